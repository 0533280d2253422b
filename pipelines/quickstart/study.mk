# Quickstart: Toyoura sand from a grading curve to drained triaxial tests at 0.2, 0.5 and 1.0 MPa (thesis Fig. 3.2).
# SPDX-License-Identifier: GPL-3.0-or-later

STUDIES += quickstart
QS := pipelines/quickstart
QSO := $(OUT)/quickstart
# Two packings of a thousand grains may differ in strength by more than the tolerances; means of six do not.
QS_SEEDS_quick := 1 2 3 4 5 6
QS_SEEDS_thesis := $(shell seq 1 16)
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

# One row a run: pressure and the seed of its packing.
$(QSO)/runs.tsv: $(QS)/study.mk $(OUT)/profile
	@mkdir -p $(@D)
	@{ printf 'pressure\tseed\n'; for s in $(QS_SEEDS); do \
	  for p in $(QS_PRESSURES); do printf '%s\t%s\n' $$p $$s; done; done; } $(call whole,$@)

# ensemble.sh runs under GNU parallel and goes on where it was stopped.
$(QSO)/ensemble: $(QS)/ensemble.sh $(QS)/run.sh $(QS)/shear.awk $(QS)/triaxial.toml $(QSO)/runs.tsv $(QS_PACKINGS) \
  $(BIN)/run-dem $(BIN)/homogenize $(BIN)/fabric
	@BIN=$(BIN) OUT=$(QSO) $(QS)/ensemble.sh $(QSO)/runs.tsv $(QS)/triaxial.toml $(QS_PACKINGS)
	@touch $@

# Tables of the packings before loading, and of the first one what its picture is made of.
QS_CELLS := $(QS_SEEDS:%=$(QSO)/cell_%.tsv)
QS_FABRICS := $(QS_SEEDS:%=$(QSO)/fabric_%.tsv)
QS_GRAINS := $(QS_SEEDS:%=$(QSO)/grains_%.txt)
$(QS_CELLS): $(QSO)/cell_%.tsv: $(QSO)/packing_%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --tsv $(call whole,$@)
$(QS_FABRICS): $(QSO)/fabric_%.tsv: $(QSO)/packing_%.h5 $(BIN)/fabric
	@$(BIN)/fabric $< --tsv $(call whole,$@)
$(QS_GRAINS): $(QSO)/grains_%.txt: $(QSO)/packing_%.h5 $(BIN)/to-vtk
	@$(BIN)/to-vtk --text $< --force -o $@
QS_PICTURE := $(QSO)/histogram.tsv $(QSO)/petals.tsv
$(QSO)/histogram.tsv: $(QSO)/packing_1.h5 $(BIN)/fabric
	@$(BIN)/fabric $< --tsv --table histogram $(call whole,$@)
$(QSO)/petals.tsv: $(QSO)/packing_1.h5 $(QS)/petals.awk $(BIN)/fabric
	@$(BIN)/fabric $< --tsv --table rose | awk -f $(QS)/petals.awk $(call whole,$@)

QS_ENSEMBLES := $(foreach p,$(QS_PRESSURES),$(QSO)/ensemble_$(p)MPa.tsv)
$(QS_ENSEMBLES): $(QSO)/ensemble_%MPa.tsv: $(QS)/ensemble.awk $(QSO)/ensemble
	@awk -f $< $(QSO)/runs/$*MPa_*/series.tsv $(call whole,$@)

$(QSO)/measured.tsv: $(QS)/measure.sh $(QS_ENSEMBLES) $(QS_CELLS) $(QS_FABRICS) $(QS_GRAINS) $(QS_LAB)
	@OUT=$(QSO) $(QS)/measure.sh $(QS_SEEDS) $(call whole,$@)

$(QSO)/comparison.tsv: pipelines/compare.awk $(QS)/expected.tsv $(QSO)/measured.tsv
	@awk -f $< $(QS)/expected.tsv $(QSO)/measured.tsv $(call whole,$@)

$(QSO)/figures: $(QS)/figures.gp $(QS_ENSEMBLES) $(QS_PICTURE) $(QS_LAB)
	@for format in svg png; do gnuplot -e "out='$(QSO)'; format='$$format'" $<; done
	@touch $@

$(QSO)/provenance.txt: $(QSO)/ensemble $(BIN)/to-vtk
	@$(BIN)/to-vtk --history $(QSO)/runs/0.2MPa_1/run.h5 $(call whole,$@)

$(QSO)/page.html: $(QS)/page.sh pipelines/figure.sh pipelines/table.awk $(QSO)/comparison.tsv $(QSO)/figures $(QSO)/provenance.txt
	@OUT=$(QSO) $(QS)/page.sh $(call whole,$@)
	@awk -F '\t' 'NR > 1 { n[$$7]++ } END { printf "quickstart: %d published values met, %d not met (make report)\n", \
	  n["met"], n["not met"] }' $(QSO)/comparison.tsv
