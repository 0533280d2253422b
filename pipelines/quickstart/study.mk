# Quickstart: Toyoura sand from a grading curve to drained triaxial tests at 0.2, 0.5 and 1.0 MPa (thesis Fig. 3.2).
# SPDX-License-Identifier: GPL-3.0-or-later

STUDIES += quickstart
QS := pipelines/quickstart
QSO := $(OUT)/quickstart
# Two packings of a thousand grains may differ in strength by more than the tolerances, but means of six do not.
QS_SEEDS_quick := 1 2 3 4 5 6
QS_SEEDS_thesis := 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16
QS_SEEDS := $(QS_SEEDS_$(PROFILE))
QS_PRESSURES := 0.2 0.5 1.0
QS_LAB := $(sort $(wildcard data/laboratory/toyoura_drained_triaxial_*.tsv))

.PHONY: quickstart
quickstart: $(QSO)/page.html ## Toyoura sand, grading curve to triaxial test, in a few minutes (PROFILE=quick|thesis)

# % is the seed.
QS_PACKINGS := $(QS_SEEDS:%=$(QSO)/packing_%.h5)
$(QSO)/packing_%.h5: $(BIN)/pack-generate
	@mkdir -p $(@D)
	@echo '  pack  $@'
	@pipelines/resume.sh $@ $(BIN)/pack-generate --grains 1000 --void-ratio 0.68 --pressure 1e3 --seed $*

# % is the pressure in MPa and the seed, as in 0.2_1.
QS_TESTS := $(foreach p,$(QS_PRESSURES),$(QS_SEEDS:%=$(QSO)/triaxial_$(p)_%.h5))
qs_pressure = $(word 1,$(subst _, ,$*))
$(QSO)/triaxial_%.h5: $(QS_PACKINGS) $(QS)/triaxial.toml $(BIN)/run-dem
	@echo '  run   $@'
	@pipelines/resume.sh $@ $(BIN)/run-dem $(QSO)/packing_$(word 2,$(subst _, ,$*)).h5 $(QS)/triaxial.toml \
	  --set stage.0.pressure=$(qs_pressure)e6 --set stage.1.confining_pressure=$(qs_pressure)e6

QS_TABLES := $(QS_TESTS:$(QSO)/%.h5=$(QSO)/series_%.tsv) $(QS_PACKINGS:$(QSO)/%.h5=$(QSO)/cell_%.tsv) \
  $(patsubst $(QSO)/%.h5,$(QSO)/fabric_%.tsv,$(QS_TESTS) $(QS_PACKINGS)) $(QSO)/rose_packing_1.tsv $(QSO)/histogram_packing_1.tsv
$(QSO)/series_%.tsv: $(QSO)/%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --tsv --table series $(call whole,$@)
$(QSO)/cell_%.tsv: $(QSO)/%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --tsv $(call whole,$@)
$(QSO)/fabric_%.tsv: $(QSO)/%.h5 $(BIN)/fabric
	@$(BIN)/fabric $< --tsv $(call whole,$@)
$(QSO)/rose_%.tsv: $(QSO)/%.h5 $(BIN)/fabric
	@$(BIN)/fabric $< --tsv --table rose $(call whole,$@)
$(QSO)/histogram_%.tsv: $(QSO)/%.h5 $(BIN)/fabric
	@$(BIN)/fabric $< --tsv --table histogram $(call whole,$@)
$(QSO)/provenance.txt: $(QSO)/triaxial_0.2_1.h5 $(BIN)/to-vtk
	@$(BIN)/to-vtk --history $< $(call whole,$@)

$(QSO)/page.html: $(QS)/study.py $(QS)/words.toml $(QS)/expected.tsv $(STUDY) $(QS_TABLES) $(QS_LAB) $(QSO)/provenance.txt $(OUT)/profile
	@$(STUDY_PY) $< $(QSO) --profile $(PROFILE) --seeds $(QS_SEEDS)

# Kept, since every table is made from them.
.PRECIOUS: $(QSO)/packing_%.h5 $(QSO)/triaxial_%.h5
