# Chapter 3: the soilbag, generated and loaded (thesis Figs. 3.2 to 3.18). PROFILE=quick: grains and yarns twice as large, rolling
# stiffness eight times, yarns twice as strong, so that stresses are the same.
# SPDX-License-Identifier: GPL-3.0-or-later

STUDIES += ch3
C3 := pipelines/ch3
C3O := $(OUT)/ch3
# Seed of the representative volume. The full-size bag of seed 3 is the nearest of three to their mean, in axial stress and load at equal
# tension (kept/bulging_thesis.tsv). The void ratio below was chosen for seed 1 in the quick profile.
C3_SEED_quick := 1
C3_SEED_thesis := 3
C3_SEED := $(C3_SEED_$(PROFILE))
# Dead loads in N.
C3_LOADS_quick := 2410 24100
C3_LOADS_thesis := 1330 1870 2410 12050 24100 36150
C3_LOADS := $(C3_LOADS_$(PROFILE))
# Strains just past the greatest load and the greatest shear.
C3_UC_quick := --set stage.1.strain=0.16
C3_SS_quick := --set stage.2.parts=10 --set stage.2.move.0.distance=0.008
# Larger nodes stand out of the bag by as much more, so that its soil keeps the same room.
C3_GRAINS_quick := --set grains.scale=1.94 --set container.copies=[5,5,1] --set geotextile_mesh.cells=[45,45,10] \
  --set geotextile_mesh.node_radius=0.005 --set geotextile_mesh.offset=0.0025
C3_MOMENTS_quick := --set contact.rolling.stiffness=1.04 --set contact.twisting.stiffness=1.04 \
  $(foreach m,0 1,--set material.$(m).rolling.stiffness=1.04 --set material.$(m).twisting.stiffness=1.04)
# Delaunay tetrahedra of coarser grains leave out twice as much along the walls. With a void ratio of 0.6 the load from 2 % on is nearer to
# the recorded load than with 0.615, for this representative volume. Contacts of coarser grains also press harder in a full bag.
C3_BAG_quick := $(C3_GRAINS_quick) --set growth.delaunay_void_ratio=0.6 --set growth.measure_every=6 --set growth.overlap=2e-4 \
  --set contact.rolling.stiffness=1.04 --set contact.twisting.stiffness=1.04 --set material.0.rolling.stiffness=1.04 \
  --set material.0.twisting.stiffness=1.04
# One yarn represents two of the thesis's yarns.
C3_LOAD_quick := $(C3_MOMENTS_quick) --set geotextile.0.multiple=2 --set plane.0.point=[0,0,0.0475] --set plane.1.point=[0,0,-0.0475]
SETTINGS += ch3/rv ch3/bag ch3/load ch3/uc ch3/ss
SETTINGS_ch3/rv = $(C3_SEED)
SETTINGS_ch3/bag = $(C3_BAG_$(PROFILE))
SETTINGS_ch3/load = $(C3_LOAD_$(PROFILE))
SETTINGS_ch3/uc = $(C3_UC_$(PROFILE)) $(foreach g,PE PP,$(C3_RECORD_$(PROFILE)_$g))
SETTINGS_ch3/ss = $(C3_SS_$(PROFILE))
# Runs side by side use the cores better than threads within one run. Full-size runs are made one at a time.
C3_THREADS_quick := 1
C3_THREADS_thesis := 2
C3_THREADS ?= $(C3_THREADS_$(PROFILE))
C3_FILL_THREADS ?= $(C3_THREADS)

.PHONY: ch3
ch3: $(C3O)/page.html ## the soilbag: generated, compressed, sheared (PROFILE=thesis: 69,000 grains)

# $(call pack_volume,SEED) and $(call fill_bag,OPTIONS) make a representative volume and a bag of the first prerequisite, a volume.
pack_volume = $(BIN)/pack-generate --grains 1000 --void-ratio 0.68 --pressure 1e3 --seed $(1) --threads 1 --quiet --force -o $@
fill_bag = $(BIN)/filter-expand $< $(C3)/bag.toml $(C3_BAG_$(PROFILE)) $(1) --threads $(C3_FILL_THREADS) --quiet --resume --force -o $@
.PRECIOUS: $(C3O)/%.h5
$(C3O)/rv.h5: $(BIN)/pack-generate $(C3O)/rv.settings
	@mkdir -p $(@D)
	@echo '  pack  $@'
	@$(call pack_volume,$(C3_SEED))

$(C3O)/bag.h5 $(C3O)/generation.tsv &: $(C3O)/rv.h5 $(C3)/bag.toml $(BIN)/filter-expand $(C3O)/bag.settings
	@echo '  fill  $(C3O)/bag.h5'
	@$(BIN)/filter-expand $(C3O)/rv.h5 $(C3)/bag.toml $(C3_BAG_$(PROFILE)) --threads $(C3_FILL_THREADS) --quiet --resume --force \
	  --history $(C3O)/generation.tsv -o $(C3O)/bag.h5

# $(call compress,GEOTEXTILE,HOW FAR,OPTIONS) compresses the first prerequisite, a bag, between plates.
compress = $(BIN)/run-dem $< $(C3)/uc.toml $(C3_LOAD_$(PROFILE)) $(2) --set geotextile.0.curve=$(1) $(3) \
  --threads $(C3_THREADS) --quiet --resume --force -o $@
# Chapter 5 uses the full-size bags of PE and PP, too, and draws more states of the bag of PP.
C3_RECORD_thesis_PP := --set record.strains=[0.01,0.02,0.03,0.04,0.05,0.06,0.07,0.08,0.09,0.10,0.11,0.12,0.13,0.14,0.16]
# % is the geotextile.
$(C3O)/uc_%.h5: $(C3O)/bag.h5 $(C3)/uc.toml $(BIN)/run-dem $(GEOTEXTILES) $(C3O)/load.settings $(C3O)/uc.settings
	@echo '  run   $@'
	@$(call compress,$*,$(C3_UC_$(PROFILE)) $(C3_RECORD_$(PROFILE)_$*))
# Rough plates instead of smooth ones.
$(C3O)/uc_%_rough.h5: $(C3O)/bag.h5 $(C3)/uc.toml $(BIN)/run-dem $(GEOTEXTILES) $(C3O)/load.settings $(C3O)/uc.settings
	@echo '  run   $@'
	@$(call compress,$*,$(C3_UC_$(PROFILE)),--set stage.1.plate_friction_angle=89.9)
# % is the dead load in N.
$(C3O)/ss_%.h5: $(C3O)/bag.h5 $(C3)/ss.toml $(BIN)/run-dem $(GEOTEXTILES) $(C3O)/load.settings $(C3O)/ss.settings
	@echo '  run   $@'
	@$(BIN)/run-dem $< $(C3)/ss.toml $(C3_LOAD_$(PROFILE)) $(C3_SS_$(PROFILE)) --set stage.0.load.0.force=$* --set stage.1.load.0.force=$* \
	  --threads $(C3_THREADS) --quiet --resume --force -o $@

$(C3O)/strip.h5: $(C3O)/rv.h5 $(C3)/strip_plan.toml $(BIN)/filter-expand
	@$(BIN)/filter-expand $< $(C3)/strip_plan.toml --quiet --force -o $@
$(C3O)/strip_%.h5: $(C3O)/strip.h5 $(C3)/strip.toml $(BIN)/run-dem $(GEOTEXTILES)
	@$(BIN)/run-dem $< $(C3)/strip.toml --set geotextile.0.curve=$* --threads 1 --quiet --force -o $@

# % is the friction angle of nodes and soil.
$(C3O)/sheet.h5: $(C3O)/rv.h5 $(C3)/sheet.toml $(BIN)/filter-expand
	@$(BIN)/filter-expand $< $(C3)/sheet.toml --quiet --force -o $@
$(C3O)/box_%.h5: $(C3O)/sheet.h5 $(C3)/box.toml $(BIN)/run-dem $(GEOTEXTILES)
	@$(BIN)/run-dem $< $(C3)/box.toml --set material.0.friction_angle=$* --threads 1 --quiet --resume --force -o $@

# Tables of the runs: "loading" for bags, what clamps and walls bear for strips and boxes, whose cells have no stress.
C3_STRIPS := $(foreach run,strip_PE strip_PP,$(C3O)/$(run).tsv)
C3_BOXES := $(foreach run,box_21 box_25,$(C3O)/$(run).tsv)
$(C3_STRIPS): private COLUMNS := stage,displacement_right_y,force_right_y,yarn_tension_face
$(C3_BOXES): private COLUMNS := stage,displacement_left_x,force_left_x,force_right_x,force_lid_z
$(C3O)/%.tsv: $(C3O)/%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --table loading --tsv $(call whole,$@)
$(C3_STRIPS) $(C3_BOXES): %.tsv: %.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --table series --columns $(COLUMNS) --tsv $(call whole,$@)
$(C3O)/%_fabric.tsv: $(C3O)/%.h5 $(BIN)/fabric
	@$(BIN)/fabric $< --tsv $(call whole,$@)
$(C3O)/%_groups.tsv: $(C3O)/%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --groups --table volumes --tsv $(call whole,$@)
$(C3O)/%_path.tsv: $(C3O)/%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --table path --tsv $(call whole,$@)
C3_YARNS := step,family,position_x,position_y,position_z,direction_x,direction_y,length,tension,broken
$(C3O)/%_breaks.tsv: $(C3O)/%.h5 $(C3)/breaks.py $(BIN)/homogenize
	@$(BIN)/homogenize $< --state last --table yarns --columns $(C3_YARNS) --tsv | $(STUDY_PY) -m ch3.breaks $(call whole,$@)

# Contacts of the bag, of its soil alone, and of its representative volume, which is unloaded until it has as few contacts.
C3_ROSES := $(foreach of,rv bag bag_soil,$(C3O)/$(of)_histogram.tsv $(C3O)/$(of)_rose.tsv)
$(C3O)/rv_unloaded.h5: $(C3O)/rv.h5 $(C3)/rv.toml $(BIN)/run-dem
	@$(BIN)/run-dem $< $(C3)/rv.toml --threads 1 --quiet --force -o $@
$(C3O)/rv_%.tsv: $(C3O)/rv_unloaded.h5 $(BIN)/fabric
	@$(BIN)/fabric $< --state last --table $* --tsv $(call whole,$@)
$(C3O)/bag_%.tsv: $(C3O)/bag.h5 $(BIN)/fabric
	@$(BIN)/fabric $< --table $* --tsv $(call whole,$@)
$(C3O)/bag_soil_%.tsv: $(C3O)/bag.h5 $(BIN)/fabric
	@$(BIN)/fabric $< --soil --table $* --tsv $(call whole,$@)

# Three states of the bag of PE for a picture: after the preload, at 12 %, the last. % is the number of the picture.
C3_STATES := 1 4 last
C3_PICTURES := $(foreach k,1 2 3,$(C3O)/uc_PE_grains_$(k).tsv $(C3O)/uc_PE_yarns_$(k).tsv)
$(C3O)/uc_PE_grains_%.tsv: $(C3O)/uc_PE.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --state $(word $*,$(C3_STATES)) --grains --table grains --tsv \
	  --columns position_x,position_y,position_z,radius,copy,strain_deviatoric $(call whole,$@)
$(C3O)/uc_PE_yarns_%.tsv: $(C3O)/uc_PE.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --state $(word $*,$(C3_STATES)) --table yarns --columns $(C3_YARNS) --tsv $(call whole,$@)

$(C3O)/provenance.txt: $(C3O)/uc_PE.h5 $(BIN)/to-vtk
	@$(BIN)/to-vtk --history $< $(call whole,$@)

# Tables of each run. They are so small that tables of full-size runs are kept, and compared without the runs.
C3_UC := uc_PE uc_PP
C3_SS := $(C3_LOADS:%=ss_%)
C3_OF_RUNS := $(foreach run,$(C3_UC) $(C3_SS),$(run) $(run)_fabric $(run)_groups) \
  $(C3_UC:%=%_path) uc_PE_breaks uc_PE_rough_breaks
C3_OF_BAG := $(C3O)/generation.tsv $(C3_ROSES)
C3_PY := $(wildcard $(C3)/*.py $(C3)/*.tsv) $(C3)/words.toml $(C3)/bag.toml $(C3)/strip_plan.toml \
  $(wildcard data/geotextiles/P?.toml data/discrete_element/soilbag_uniaxial_P?.tsv)
$(C3O)/page.html: $(C3)/study.py $(C3_PY) $(STUDY) $(C3_OF_RUNS:%=$(C3O)/%.tsv) $(C3_OF_BAG) $(C3_STRIPS) $(C3_BOXES) $(C3_PICTURES) \
  $(C3O)/provenance.txt $(wildcard $(C3)/kept/*.tsv) $(OUT)/profile
	@$(STUDY_PY) $< $(C3O) --profile $(PROFILE) --loads $(C3_LOADS)

KEEPING += ch3
C3_ENDED := $(patsubst $(C3O)/%.h5,%,$(wildcard $(C3O)/uc_*.h5 $(C3O)/ss_*.h5))
ENDED_ch3 := $(C3_ENDED) bag
C3_OF_ENDED := $(filter $(foreach table,fabric groups path breaks,$(C3_ENDED:%=%_$(table))) $(C3_ENDED),$(C3_OF_RUNS))
ch3-keep: $(C3_OF_ENDED:%=$(C3O)/%.tsv) $(C3_OF_BAG) ## keep the tables of finished thesis-size runs of ch3 (PROFILE=thesis)
ch3-compare: $(C3_PY) ## compare and draw the kept runs of ch3 anew

include $(C3)/variants.mk $(C3)/loadings.mk
