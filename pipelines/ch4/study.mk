# Chapter 4: soil wrapped in geotextile beside soil between two sheets, in a periodic cell of soil, sheared at 10 kPa (thesis Figs. 4.3 to
# 4.6). PROFILE=thesis: the bag of chapter 3. PROFILE=quick: grains and yarns twice as large, rolling stiffness eight times, yarns twice
# as strong, and a representative volume half as high, so that the cell has its height.
# SPDX-License-Identifier: GPL-3.0-or-later

STUDIES += ch4
C4 := pipelines/ch4
C4O := $(OUT)/ch4
C4_FORMS := wrapped layered
C4_GEOTEXTILES := PE PP 5PP
C4_CELLS := $(foreach form,$(C4_FORMS),$(C4_GEOTEXTILES:%=$(form)_%))
# A twin sheared at a tenth of the rate, with the geotextile that takes the fewest steps.
C4_SLOW_thesis := wrapped_PE_slow
C4_RV_quick := $(C4O)/rv.h5
C4_RV_thesis := $(C3O)/rv.h5
C4_RV := $(C4_RV_$(PROFILE))
C4_BAG_quick := $(C4O)/bag.h5
C4_BAG_thesis := $(C3O)/bag.h5
C4_BAG := $(C4_BAG_$(PROFILE))
C4_GRAINS_quick := 500 --aspect 1
C4_GRAINS_thesis := 1000
c4_moments = $(foreach t,contact $(1),--set $(t).rolling.stiffness=1.04 --set $(t).twisting.stiffness=1.04)
# In the cell, a small bag with hardly loaded grains would yield more than a large one. So it is filled until it bears some of the pressure.
C4_FILL_quick := --set grains.scale=1.94 --set container.copies=[5,5,1] --set geotextile_mesh.cells=[45,45,10] \
  --set geotextile_mesh.node_radius=0.005 --set geotextile_mesh.offset=0.0025 --set growth.measure_every=6 $(call c4_moments,material.0) \
  --set growth.delaunay_void_ratio=0.57 --set growth.overlap=2e-4 --set growth.coordination_number=3.5 \
  --set growth.largest_coordination_number=4
C4_COARSE := $(call c4_moments,material.0 material.1) --set geotextile.0.multiple=2
C4_PUT_quick := --set surround.copies=[5,5,1] --set surround.scale=1.94 $(C4_COARSE)
# A coarser criterion of rest: half of the steps to 20 % wait for rest.
C4_LOAD_quick := $(C4_COARSE) --set equilibrium.unbalanced_force=2e-3
# The ring of five by five copies is half a copy wide.
C4_FORM_layered_quick := --set surround.rings=0.5
SETTINGS += ch4/rv ch4/alone ch4/bag ch4/load $(C4_FORMS:%=ch4/%)
SETTINGS_ch4/rv = $(C4_GRAINS_quick)
SETTINGS_ch4/alone = $(C4_GRAINS_$(PROFILE))
SETTINGS_ch4/bag = $(C4_FILL_quick)
SETTINGS_ch4/wrapped = $(C4_PUT_$(PROFILE)) $(C4_FORM_wrapped_$(PROFILE))
SETTINGS_ch4/layered = $(C4_PUT_$(PROFILE)) $(C4_FORM_layered_$(PROFILE))
SETTINGS_ch4/load = $(C4_LOAD_$(PROFILE))
# Runs side by side use the cores better than threads within one.
C4_THREADS ?= 1

.PHONY: ch4
ch4: $(C4O)/page.html ## soil wrapped in a geotextile beside soil between two sheets (PROFILE=thesis: 100,000 grains)

.PRECIOUS: $(C4O)/%.h5
$(C4O)/rv.h5: $(BIN)/pack-generate $(C4O)/rv.settings
	@mkdir -p $(@D)
	@echo '  pack  $@'
	@$(BIN)/pack-generate --grains $(C4_GRAINS_quick) --void-ratio 0.68 --pressure 1e3 --seed 1 --threads 1 --quiet --force -o $@
$(C4O)/bag.h5: $(C4O)/rv.h5 $(C3)/bag.toml $(BIN)/filter-expand $(C4O)/bag.settings
	@echo '  fill  $@'
	@$(BIN)/filter-expand $< $(C3)/bag.toml $(C4_FILL_quick) --threads $(C4_THREADS) --quiet --resume --force -o $@
# % is the form.
C4_PACKINGS := $(C4_FORMS:%=$(C4O)/%.h5)
$(C4_PACKINGS): $(C4O)/%.h5: $(C4_BAG) $(C4_RV) $(C4)/%.toml $(BIN)/filter-expand $(GEOTEXTILES) $(C4O)/%.settings
	@mkdir -p $(@D)
	@echo '  fill  $@'
	@$(BIN)/filter-expand $< $(C4)/$*.toml --set surround.representative_volume=$(C4_RV) $(C4_PUT_$(PROFILE)) $(C4_FORM_$*_$(PROFILE)) \
	  --history $(C4O)/$*_shape.tsv --threads $(C4_THREADS) --quiet --resume --force -o $@
$(C4_FORMS:%=$(C4O)/%_shape.tsv): $(C4O)/%_shape.tsv: $(C4O)/%.h5 ;
# Soil alone, at its true size in either profile.
$(C4O)/alone.h5: $(BIN)/pack-generate $(C4O)/alone.settings
	@mkdir -p $(@D)
	@$(BIN)/pack-generate --grains $(C4_GRAINS_$(PROFILE)) --void-ratio 0.68 --pressure 1e4 --seed 1 --threads 1 --quiet --force -o $@
# The soil alone has no nodes, fill or yarns, so that its scenario has no tables of theirs.
$(C4O)/soil.toml: $(C4)/triaxial.toml
	@mkdir -p $(@D)
	@awk '/^\[\[?(material|geotextile)/ { out = 1 } /^\[\[?(grains|equilibrium|stage)/ { out = 0 } !out' $< $(call whole,$@)
$(C4O)/soil.h5: $(C4O)/alone.h5 $(C4O)/soil.toml $(BIN)/run-dem
	@echo '  run   $@'
	@$(BIN)/run-dem $< $(C4O)/soil.toml --threads 1 --quiet --resume --force -o $@

# % is the form and the geotextile, as in wrapped_PE; states are kept where a section is drawn.
c4_form = $(word 1,$(subst _, ,$*))
c4_states = $(if $(filter %_PP,$*),--set record.snapshots=stations)
c4_shear = $(BIN)/run-dem $< $(C4)/triaxial.toml $(C4_LOAD_$(PROFILE)) \
  --set geotextile.0.curve=$(word 2,$(subst _, ,$*)) $(c4_states) $(1) --threads $(C4_THREADS) --quiet --resume --force -o $@
C4_ALL := $(C4_CELLS) $(C4_SLOW_thesis)
$(foreach form,$(C4_FORMS),$(eval $(patsubst %,$(C4O)/%.h5,$(filter $(form)_%,$(C4_ALL))): $(C4O)/$(form).h5))
$(C4_ALL:%=$(C4O)/%.h5): $(C4)/triaxial.toml $(BIN)/run-dem $(GEOTEXTILES) $(C4O)/load.settings
$(C4_CELLS:%=$(C4O)/%.h5): $(C4O)/%.h5:
	@echo '  run   $@'
	@$(call c4_shear)
$(C4_SLOW_thesis:%=$(C4O)/%.h5): $(C4O)/%.h5:
	@echo '  run   $@'
	@$(call c4_shear,--set stage.1.rate=0.01)

# The layered cell with PP under other loadings. They show how near the study's loading is to slow loading.
C4_LOADINGS := told slow limit_0.06
C4_LOADING_told := --set grains.mass_scaling=none --set stage.0.rest_drag=0 --set stage.1.rest_drag=0 --set stage.1.way_unbalanced_force=0
C4_LOADING_slow := --set stage.1.way_unbalanced_force=0 --set stage.1.rate=0.01
C4_LOADING_limit_0.06 := --set stage.1.way_unbalanced_force=0.06
SETTINGS += ch4/loadings
SETTINGS_ch4/loadings = $(foreach loading,$(C4_LOADINGS),$(C4_LOADING_$(loading)))
$(C4_LOADINGS:%=$(C4O)/loading/%.h5): $(C4O)/loading/%.h5: $(C4O)/layered.h5 $(C4)/triaxial.toml $(BIN)/run-dem $(GEOTEXTILES) \
  $(C4O)/load.settings $(C4O)/loadings.settings
	@mkdir -p $(@D)
	@echo '  run   $@'
	@$(BIN)/run-dem $< $(C4)/triaxial.toml $(C4_LOAD_$(PROFILE)) --set geotextile.0.curve=PP $(C4_LOADING_$*) --threads $(C4_THREADS) \
	  --quiet --resume --force -o $@
$(C4O)/loading/study.h5: $(C4O)/layered_PP.h5
	@mkdir -p $(@D) && ln -sf ../layered_PP.h5 $@
$(C4O)/loading/%.tsv: $(C4O)/loading/%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --table series --tsv $(call whole,$@)
c4_loaded = $(foreach run,$(C4_LOADINGS) study,$(run)=$(C4O)/loading/$(run).tsv)
.PHONY: ch4-loading
ch4-loading: $(C4)/loading.py $(foreach run,$(C4_LOADINGS) study,$(C4O)/loading/$(run).tsv) ## compare loadings of a cell of ch4, and keep the comparison
	@$(STUDY_PY) -m ch4.loading stresses $(c4_loaded) $(call whole,$(C4)/kept/loading_$(PROFILE).tsv)
	@$(STUDY_PY) -m ch4.loading steps $(c4_loaded) $(call whole,$(C4)/kept/loading_steps_$(PROFILE).tsv)

C4_RUNS := $(C4_CELLS) $(C4_SLOW_$(PROFILE))
$(C4_RUNS:%=$(C4O)/%.tsv): $(C4O)/%.tsv: $(C4O)/%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --table reinforced --tsv $(call whole,$@)
$(C4O)/soil.tsv: $(C4O)/soil.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --table series --tsv $(call whole,$@)
# Contacts of the reinforced soil at the start of shear.
$(C4_FORMS:%=$(C4O)/%_rose.tsv): $(C4O)/%_rose.tsv: $(C4O)/%.h5 $(BIN)/fabric
	@$(BIN)/fabric $< --soil --table rose --tsv $(call whole,$@)
$(C4_FORMS:%=$(C4O)/grains_%.tsv): $(C4O)/grains_%.tsv: $(C4O)/%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --table grains --columns position_x,position_y,position_z,radius,part --tsv $(call whole,$@)

# The states in which the reinforced soil with PP is densest and loosest. % is the form, the geotextile and which of both.
C4_STATES := $(foreach form,$(C4_FORMS),$(form)_PP_least $(form)_PP_greatest)
c4_run = $(C4O)/$(c4_form)_PP
C4_SECTIONS := $(STUDY_PY) -m ch4.sections
$(foreach form,$(C4_FORMS),$(eval $(patsubst %,$(C4O)/state_%.tsv,$(filter $(form)_%,$(C4_STATES))): $(C4O)/$(form)_PP.tsv))
$(C4_STATES:%=$(C4O)/state_%.tsv): $(C4O)/state_%.tsv: $(C4)/sections.py $(BIN)/homogenize
	@state=$$($(BIN)/homogenize $(c4_run).h5 --table cell --columns step --tsv | $(C4_SECTIONS) $(lastword $(subst _, ,$*)) $(c4_run).tsv) && \
	$(BIN)/homogenize $(c4_run).h5 --state $$state --table grains --tsv \
	  --columns position_x,position_y,position_z,radius,part,strain_deviatoric $(call whole,$@)
$(C4O)/section_%.tsv: $(C4O)/state_%.tsv $(C4)/sections.py
	@$(C4_SECTIONS) cut < $< $(call whole,$@)
$(C4O)/bands_%.tsv: $(C4O)/state_%.tsv $(C4)/sections.py
	@$(C4_SECTIONS) bands < $< $(call whole,$@)

$(C4O)/provenance.txt: $(C4O)/wrapped_PP.h5 $(BIN)/to-vtk
	@$(BIN)/to-vtk --history $< $(call whole,$@)

C4_TABLES := $(C4_RUNS:%=$(C4O)/%.tsv) $(C4O)/soil.tsv $(C4_FORMS:%=$(C4O)/%_rose.tsv) $(C4_FORMS:%=$(C4O)/%_shape.tsv) \
  $(C4_STATES:%=$(C4O)/bands_%.tsv)
C4_PICTURES := $(C4_FORMS:%=$(C4O)/grains_%.tsv) $(C4_STATES:%=$(C4O)/section_%.tsv)
C4_PY := $(wildcard $(C4)/*.py $(C4)/*.tsv $(C4)/*.toml)
$(C4O)/page.html: $(C4)/study.py $(C4_PY) $(STUDY) $(C4_TABLES) $(C4_PICTURES) $(C4O)/provenance.txt $(wildcard $(C4)/kept/*.tsv) \
  $(OUT)/profile
	@$(STUDY_PY) $< $(C4O) --profile $(PROFILE)

KEEPING += ch4
ENDED_ch4 := $(patsubst $(C4O)/%.h5,%,$(wildcard $(C4_RUNS:%=$(C4O)/%.h5) $(C4_PACKINGS) $(C4O)/soil.h5))
# Sections are those of a run, FORM_GEOTEXTILE; a packing, FORM, has none.
c4_of = $(C4O)/$(1).tsv $(C4O)/$(1)_shape.tsv $(C4O)/$(1)_rose.tsv $(if $(findstring _,$(1)),$(C4O)/bands_$(1)_%.tsv)
C4_OF_ENDED := $(foreach run,$(ENDED_ch4),$(filter $(call c4_of,$(run)),$(C4_TABLES)))
ch4-keep: $(C4_OF_ENDED) ## keep the tables of finished thesis-size runs of ch4 (PROFILE=thesis)
ch4-compare: $(C4_PY) ## compare and draw the kept runs of ch4 anew
