# Chapter 5, the analytical part: soil wrapped in a geotextile, beside discrete-element series (thesis Figs. 5.2, 5.10 to 5.20).
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

.PHONY: ch5
ch5: $(C5O)/page.html ## the analytical solution for geotextile-wrapped soil, its identification, a design chart

$(C5_UNIAXIAL): $(C5O)/uniaxial_%.tsv: $(BIN)/gws-solve $(wildcard data/geotextiles/*.toml data/soils/*.toml)
	@mkdir -p $(@D)
	@$(BIN)/gws-solve respond --soil toyoura-gws --geotextile $* --points 100 --tsv $(call whole,$@)

# % is GEOTEXTILE_PRESSUREkPa.
$(C5_TRIAXIAL): $(C5O)/triaxial_%.tsv: $(BIN)/gws-solve $(wildcard data/geotextiles/*.toml data/soils/*.toml)
	@mkdir -p $(@D)
	@$(BIN)/gws-solve respond --soil toyoura-gws --geotextile $(word 1,$(subst _, ,$*)) --lateral-stress "$(patsubst %kPa,%,$(word 2,$(subst _, ,$*))) kPa" \
	  --points 100 --tsv $(call whole,$@)

C5_IDENTIFY = $(BIN)/gws-solve identify $(C5_DEM) --failure $(C5_FAILURE) --difference backward
$(C5_LINES): $(C5O)/%.tsv: $(BIN)/gws-solve $(C5_DEM) $(C5_FAILURE)
	@mkdir -p $(@D)
	@$(C5_IDENTIFY) --tsv --table $* $(call whole,$@)

$(C5O)/identified.txt: $(BIN)/gws-solve $(C5_DEM) $(C5_FAILURE)
	@mkdir -p $(@D)
	@$(C5_IDENTIFY) | sed 's|data/discrete_element/soilbag_uniaxial_||g; s|\.tsv||g' $(call whole,$@)

$(C5O)/soil.toml: $(BIN)/gws-solve $(C5_DEM) $(C5_FAILURE)
	@mkdir -p $(@D)
	@$(C5_IDENTIFY) --toml $(call whole,$@)

# Bands: the identified constants and their scatter; the chart: geotextiles like PP, a service surcharge of 300 kPa.
C5_BANDS = $(BIN)/gws-solve respond --geotextile PP --soil $(C5O)/soil.toml --samples 1000 --points 50
$(C5O)/bands.tsv: $(BIN)/gws-solve $(C5O)/soil.toml
	@$(C5_BANDS) --tsv $(call whole,$@)
$(C5O)/bands.txt: $(BIN)/gws-solve $(C5O)/soil.toml
	@$(C5_BANDS) | sed -n '/draws/p' | tail -n +2 $(call whole,$@)
$(C5O)/chart.tsv: $(BIN)/gws-solve
	@mkdir -p $(@D)
	@$(BIN)/gws-solve design --geotextile PP --soil toyoura-gws --surcharge 300e3 --settlement 0.06 --safety 1.5 --chart --from 30e3 --to 1160e3 \
	  --points 60 --tsv $(call whole,$@)
$(C5O)/sensitivity.txt: $(BIN)/gws-solve
	@mkdir -p $(@D)
	@$(BIN)/gws-solve respond --geotextile PP --soil toyoura-gws --sensitivity $(call whole,$@)

$(C5O)/page.html: $(C5)/study.py $(C5)/words.toml $(C5)/expected.tsv $(C5)/statements.tsv $(STUDY) $(C5_UNIAXIAL) $(C5_TRIAXIAL) $(C5_LINES) $(C5_DESIGN) $(C5_DEM)
	@$(STUDY_PY) $< $(C5O) --profile $(PROFILE)
