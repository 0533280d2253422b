# Chapter 5: soil wrapped in a geotextile, by grains and by the analytical solution (thesis Figs. 5.2 to 5.20). The bags are chapter 3's
# packing under seven geotextiles. The cells are chapter 4's wrapped packing, of which those at 10 kPa are chapter 4's own runs.
# SPDX-License-Identifier: GPL-3.0-or-later

STUDIES += ch5
C5 := pipelines/ch5
C5O := $(OUT)/ch5
C5_DEM := $(foreach g,PE PP 3PP,data/discrete_element/soilbag_uniaxial_$(g).tsv)
C5_FAILURE := data/laboratory/toyoura_peak_obliquity.tsv
C5_UNIAXIAL := $(foreach g,PE 0.5PP PP 2PP 3PP 4PP 5PP,$(C5O)/uniaxial_$(g).tsv)
C5_TRIAXIAL := $(foreach g,PE PP 5PP,$(foreach s,10 50 100,$(C5O)/triaxial_$(g)_$(s)kPa.tsv))
C5_LINES := $(foreach t,constants compression_line failure_line near_failure_line dilatancy_line stiffness increments,$(C5O)/$(t).tsv)
C5_DESIGN := $(addprefix $(C5O)/,chart.tsv sensitivity.txt bands.tsv bands.txt identified.txt)

.PHONY: ch5 ch5-solution
ch5: $(C5O)/page.html ## geotextile-wrapped soil: seven DEM bags, and the analytical solution
ch5-solution: $(C5_UNIAXIAL) $(C5_TRIAXIAL) $(C5_LINES) $(C5_DESIGN) ## the tables of the analytical solution alone

# The curves and constants that gws-solve knows by name.
C5_CATALOGUE := $(GEOTEXTILES) $(wildcard data/soils/*.toml)
$(C5_UNIAXIAL): $(C5O)/uniaxial_%.tsv: $(BIN)/gws-solve $(C5_CATALOGUE)
	@mkdir -p $(@D)
	@$(BIN)/gws-solve respond --soil toyoura-gws --geotextile $* --points 100 --tsv $(call whole,$@)

# % is GEOTEXTILE_PRESSUREkPa.
$(C5_TRIAXIAL): $(C5O)/triaxial_%.tsv: $(BIN)/gws-solve $(C5_CATALOGUE)
	@mkdir -p $(@D)
	@$(BIN)/gws-solve respond --soil toyoura-gws --geotextile $(word 1,$(subst _, ,$*)) --lateral-stress "$(patsubst %kPa,%,$(word 2,$(subst _, ,$*))) kPa" \
	  --points 100 --tsv $(call whole,$@)

# One identification prints its tables, its text and its soil, each by a call of its own. The call of the soil says the doubts, and the series that
# they are about. The other calls leave them out.
c5_doubting = { { $(1) 2>&1 >&3 3>&- | sed 's|: doubt: |: doubt: of $(2): |' >&2; } 3>&1; }
c5_undoubting = { { $(1) 2>&1 >&3 3>&- | sed '/: doubt: /d' >&2; } 3>&1; }
C5_IDENTIFY = $(BIN)/gws-solve identify $(C5_DEM) --failure $(C5_FAILURE) --fit thesis --difference backward
$(C5_LINES): $(C5O)/%.tsv: $(BIN)/gws-solve $(C5_DEM) $(C5_FAILURE)
	@mkdir -p $(@D)
	@$(call c5_undoubting,$(C5_IDENTIFY) --tsv --table $*) $(call whole,$@)

$(C5O)/identified.txt: $(BIN)/gws-solve $(C5_DEM) $(C5_FAILURE)
	@mkdir -p $(@D)
	@$(call c5_undoubting,$(C5_IDENTIFY)) | sed 's|data/discrete_element/soilbag_uniaxial_||g; s|\.tsv||g' $(call whole,$@)

$(C5O)/soil.toml: $(BIN)/gws-solve $(C5_DEM) $(C5_FAILURE)
	@mkdir -p $(@D)
	@$(call c5_doubting,$(C5_IDENTIFY) --toml,$(notdir $(C5_DEM))) $(call whole,$@)

# Bands: the identified constants and their scatter; the chart: geotextiles like PP, a service surcharge of 300 kPa.
C5_BANDS = $(BIN)/gws-solve respond --geotextile PP --soil $(C5O)/soil.toml --samples 1000 --points 50
$(C5O)/bands.tsv: $(BIN)/gws-solve $(C5O)/soil.toml $(C5_CATALOGUE)
	@$(C5_BANDS) --tsv $(call whole,$@)
$(C5O)/bands.txt: $(BIN)/gws-solve $(C5O)/soil.toml $(C5_CATALOGUE)
	@$(C5_BANDS) | sed -n '/draws/p' | tail -n +2 $(call whole,$@)
$(C5O)/chart.tsv: $(BIN)/gws-solve $(C5_CATALOGUE)
	@mkdir -p $(@D)
	@$(BIN)/gws-solve design --geotextile PP --soil toyoura-gws --surcharge 300e3 --settlement 0.06 --safety 1.5 --chart --from 30e3 --to 1160e3 \
	  --points 60 --tsv $(call whole,$@)
$(C5O)/sensitivity.txt: $(BIN)/gws-solve $(C5_CATALOGUE)
	@mkdir -p $(@D)
	@$(BIN)/gws-solve respond --geotextile PP --soil toyoura-gws --sensitivity $(call whole,$@)

# The bags, to the greatest load and beyond. % is the geotextile. States of PP are kept for the principal stresses of its copies.
C5_GEOTEXTILES := PE 0.5PP PP 2PP 3PP 4PP 5PP
C5_UC := $(C5_GEOTEXTILES:%=$(C5O)/uc_%.h5)
# Final strains, 2 % or more past the greatest load. Stiffer geotextiles reach it later. A torn bag takes most of the steps.
C5_FAR_quick := PE=0.15 0.5PP=0.15 PP=0.14 2PP=0.16 3PP=0.17 4PP=0.18 5PP=0.19
C5_FAR_thesis := $(C5_GEOTEXTILES:%=%=0.20)
# $(call c5_far,GEOTEXTILE)
c5_far = --set stage.1.strain=$(patsubst $(1)=%,%,$(filter $(1)=%,$(C5_FAR_$(PROFILE))))
# At full size chapter 3 has compressed two of them as far, and recorded their states.
C5_OF_C3_thesis := PE PP
C5_OF_C3 := $(C5_OF_C3_$(PROFILE):%=$(C5O)/uc_%.h5)
C5_STATES := [0.04,0.08,0.12]
C5_STATES_PP := [0.01,0.02,0.03,0.04,0.05,0.06,0.07,0.08,0.09,0.10,0.11,0.12,0.13,0.14]
SETTINGS += $(C5_GEOTEXTILES:%=ch5/uc_%)
$(foreach g,$(C5_GEOTEXTILES),$(eval SETTINGS_ch5/uc_$g = $(filter $g=%,$(C5_FAR_$(PROFILE))) $(or $(C5_STATES_$g),$(C5_STATES))))
.PRECIOUS: $(C5O)/%.h5
$(C5_OF_C3): $(C5O)/uc_%.h5: $(C3O)/uc_%.h5
	@mkdir -p $(@D)
	@cat $< $(call whole,$@)
$(filter-out $(C5_OF_C3),$(C5_UC)): $(C5O)/uc_%.h5: $(C3O)/bag.h5 $(C3)/uc.toml $(BIN)/run-dem $(GEOTEXTILES) \
  $(C3O)/load.settings $(C5O)/uc_%.settings
	@mkdir -p $(@D)
	@echo '  run   $@'
	@$(call compress,$*,$(call c5_far,$*) --set record.strains=$(or $(C5_STATES_$*),$(C5_STATES)))
$(C5_UC:%.h5=%.tsv): $(C5O)/%.tsv: $(C5O)/%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --table loading --tsv $(call whole,$@)
C5_VOLUMES := step,volume_of_interest,centre_x,centre_y,principal_1,principal_2,principal_3,$\
  direction_1x,direction_1y,direction_1z,direction_2x,direction_2y,direction_2z,direction_3x,direction_3y,direction_3z
$(C5O)/volumes_PP.tsv: $(C5O)/uc_PP.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --copies --table volumes --columns $(C5_VOLUMES) --tsv $(call whole,$@)

# The cells. % is GEOTEXTILE_PRESSUREkPa.
C5_CELLS := $(foreach g,PE PP 5PP,$(foreach s,10 50 100,cell_$(g)_$(s)kPa))
C5_PRESSED := $(filter-out %_10kPa,$(C5_CELLS))
c5_geotextile = $(word 1,$(subst _, ,$*))
c5_pressure = "$(patsubst %kPa,%,$(word 2,$(subst _, ,$*))) kPa"
# Axial strains in % past the greatest stress of the cells, which comes at 10 to 16 %. Beyond, torn cells hardly come to rest: 5PP at 100 kPa
# waited for 52,000 steps at 18 % in vain, and takes 70,000 to 17 %.
C5_CELL_FAR_thesis := PE=17 PP=16 5PP=17
c5_cell_far = $(patsubst $(c5_geotextile)=%,%,$(filter $(c5_geotextile)=%,$(C5_CELL_FAR_$(PROFILE))))
SETTINGS += $(C5_PRESSED:%=ch5/%)
$(foreach c,$(C5_PRESSED),$(eval SETTINGS_ch5/$c = $(filter $(word 2,$(subst _, ,$c))=%,$(C5_CELL_FAR_$(PROFILE)))))
# The stations of the scenario, one for each 1 % of strain.
c5_stations = $(shell tr -d '\n' < $(C4)/triaxial.toml | sed 's/.*stations = \[\([^]]*\)\].*/\1/; s/ //g' | cut -d , -f 1-$(c5_cell_far))
$(C5_PRESSED:%=$(C5O)/%.h5): $(C5O)/cell_%.h5: $(C4O)/wrapped.h5 $(C4)/triaxial.toml $(BIN)/run-dem $(GEOTEXTILES) \
  $(C4O)/load.settings $(C5O)/cell_%.settings
	@mkdir -p $(@D)
	@echo '  run   $@'
	@$(BIN)/run-dem $< $(C4)/triaxial.toml $(C4_LOAD_$(PROFILE)) --set geotextile.0.curve=$(c5_geotextile) \
	  $(if $(c5_cell_far),--set stage.1.stations=[$(c5_stations)]) \
	  --set stage.0.pressure=$(c5_pressure) --set stage.1.confining_pressure=$(c5_pressure) --threads $(C4_THREADS) --quiet --resume --force -o $@
$(C5_PRESSED:%=$(C5O)/%.tsv): $(C5O)/%.tsv: $(C5O)/%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --table reinforced --tsv $(call whole,$@)
$(patsubst %,$(C5O)/%.tsv,$(filter %_10kPa,$(C5_CELLS))): $(C5O)/cell_%_10kPa.tsv: $(C4O)/wrapped_%.tsv
	@mkdir -p $(@D)
	@cp $< $@

# Constants and lines identified from these bags, and the solution with these constants. They are made both from the runs and from the kept
# tables, since seven full-size bags are seldom compressed in one sitting. The argument is the folder of the bags' tables.
C5_OWN_NAMES := own_constants own_compression_line own_near_failure_line own_dilatancy_line own_stiffness
C5_SOLVED := $(patsubst $(C5O)/%.tsv,own_%,$(C5_UNIAXIAL) $(C5_TRIAXIAL))
define c5_own
C5_BAGS_$(1) := $(C5_GEOTEXTILES:%=$(1)/uc_%.tsv)
C5_OWN_$(1) = $$(BIN)/gws-solve identify $$(C5_BAGS_$(1)) $(C5_GEOTEXTILES:%=--geotextile %) --failure $$(C5_FAILURE) --fit thesis --difference backward --quiet
$(C5_OWN_NAMES:%=$(1)/%.tsv): $(1)/own_%.tsv: $$(BIN)/gws-solve $$(C5_BAGS_$(1)) $$(C5_FAILURE) $$(C5_CATALOGUE)
	@$$(call c5_undoubting,$$(C5_OWN_$(1)) --tsv --table $$*) $$(call whole,$$@)
$(1)/own_identified.txt: $$(BIN)/gws-solve $$(C5_BAGS_$(1)) $$(C5_FAILURE) $$(C5_CATALOGUE)
	@$$(call c5_undoubting,$$(C5_OWN_$(1))) | sed 's|$(1)/uc_||g; s|\.tsv||g' $$(call whole,$$@)
$(1)/own_soil.toml: $$(BIN)/gws-solve $$(C5_BAGS_$(1)) $$(C5_FAILURE) $$(C5_CATALOGUE)
	@$$(call c5_doubting,$$(C5_OWN_$(1)) --toml,$(C5_GEOTEXTILES:%=$(1)/uc_%)) $$(call whole,$$@)
$(C5_UNIAXIAL:$(C5O)/%=$(1)/own_%): $(1)/own_uniaxial_%.tsv: $$(BIN)/gws-solve $(1)/own_soil.toml $$(C5_CATALOGUE)
	@$$(BIN)/gws-solve respond --soil $(1)/own_soil.toml --geotextile $$* --points 40 --tsv --quiet $$(call whole,$$@)
$(C5_TRIAXIAL:$(C5O)/%=$(1)/own_%): $(1)/own_triaxial_%.tsv: $$(BIN)/gws-solve $(1)/own_soil.toml $$(C5_CATALOGUE)
	@$$(BIN)/gws-solve respond --soil $(1)/own_soil.toml --geotextile $$(c5_geotextile) --lateral-stress $$(c5_pressure) --points 40 --tsv --quiet \
	  $$(call whole,$$@)
endef
$(foreach f,$(C5O) $(C5)/kept,$(eval $(call c5_own,$(f))))
# Bags and cells that chapters 3 and 4 keep are copied from there.
C5_KEPT_BAGS := $(foreach g,$(C5_OF_C3_thesis),$(C5)/kept/uc_$g.tsv $(C5)/kept/uc_$g.txt)
C5_KEPT_CELLS := $(foreach g,PE PP 5PP,$(C5)/kept/cell_$g_10kPa.tsv $(C5)/kept/cell_$g_10kPa.txt)
$(C5_KEPT_BAGS): $(C5)/kept/%: $(C3)/kept/%
	@mkdir -p $(@D) && cp $< $@
.SECONDEXPANSION:
$(C5_KEPT_CELLS): $(C5)/kept/cell_%: $(C4)/kept/wrapped_$$(subst _10kPa,,$$*)
	@mkdir -p $(@D) && cp $< $@
# The lines of the runs, and of the kept tables once there are all seven bags.
C5_OWN_TABLES := $(C5_OWN_NAMES:%=$(C5O)/%.tsv) $(C5_SOLVED:%=$(C5O)/%.tsv)
C5_KEPT_OWN := $(if $(filter-out $(C5_KEPT_BAGS) $(wildcard $(C5)/kept/uc_*.tsv),$(C5_BAGS_$(C5)/kept)),,$(patsubst %,$(C5)/kept/%.tsv,$(C5_OWN_NAMES) $(C5_SOLVED)))

$(C5O)/provenance.txt: $(C5O)/uc_PP.h5 $(BIN)/to-vtk
	@$(BIN)/to-vtk --history $< $(call whole,$@)

C5_OF_RUNS := $(C5_UC:%.h5=%.tsv) $(C5O)/volumes_PP.tsv $(C5_CELLS:%=$(C5O)/%.tsv) $(C5_OWN_TABLES)
C5_PY := $(wildcard $(C5)/*.py $(C5)/*.tsv) $(C5)/words.toml $(C3)/bag.py $(C3)/compression.py $(C4)/cells.py \
  $(wildcard data/geotextiles/P?.toml) $(C5_DEM)
$(C5O)/page.html: $(C5)/study.py $(C5_PY) $(STUDY) $(C5_UNIAXIAL) $(C5_TRIAXIAL) $(C5_LINES) $(C5_DESIGN) $(C5_OF_RUNS) $(C5O)/own_identified.txt \
  $(C5O)/provenance.txt $(wildcard $(C5)/kept/*.tsv) $(OUT)/profile
	@$(STUDY_PY) $< $(C5O) --profile $(PROFILE)

KEEPING += ch5
BESIDE_ch5 := --solutions $(C5O)
ENDED_ch5 := $(patsubst $(C5O)/%.h5,%,$(wildcard $(C5_UC) $(C5_PRESSED:%=$(C5O)/%.h5)))
C5_OF_ENDED := $(filter $(ENDED_ch5:%=$(C5O)/%.tsv),$(C5_OF_RUNS)) $(if $(filter uc_PP,$(ENDED_ch5)),$(C5O)/volumes_PP.tsv)
ch5-keep: $(C5_OF_ENDED) ## keep the tables of finished thesis-size runs of ch5 (PROFILE=thesis)
ch5-compare: $(C5_PY) $(C5_UNIAXIAL) $(C5_TRIAXIAL) $(C5_LINES) $(C5_KEPT_BAGS) $(C5_KEPT_CELLS) $(C5_KEPT_OWN) ## compare and draw the kept runs of ch5 anew
include $(C5)/volumes.mk
