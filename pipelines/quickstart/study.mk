# Quickstart: Toyoura sand from a grading curve to drained triaxial tests at 0.2, 0.5 and 1.0 MPa (thesis Fig. 3.2).
# SPDX-License-Identifier: GPL-3.0-or-later

STUDIES += quickstart
QS := pipelines/quickstart
QSO := $(OUT)/quickstart
QS_TWINS_quick := 3
QS_TWINS_thesis := 8
QS_PRESSURES := 0.2 0.5 1.0
QS_LAB := $(sort $(wildcard data/laboratory/toyoura_drained_triaxial_*.tsv))

.PHONY: quickstart
quickstart: $(QSO)/page.html ## Toyoura sand, grading curve to triaxial test, in a few minutes (PROFILE=quick|thesis)

$(QSO)/packing.h5: $(BIN)/pack-generate
	@mkdir -p $(@D)
	@echo '  pack  $@'
	@pipelines/resume.sh $@ $(BIN)/pack-generate --grains 1000 --void-ratio 0.68 --pressure 1e3 --seed 1

# One row a run: pressure and twin; twin 0 starts from the packing itself, the others from grains moved by 1e-6 r.
$(QSO)/runs.tsv: $(QS)/study.mk $(OUT)/profile
	@mkdir -p $(@D)
	@{ printf 'pressure\ttwin\n'; for k in $$(seq 0 $$(($(QS_TWINS_$(PROFILE)) - 1))); do \
	  for p in $(QS_PRESSURES); do printf '%s\t%s\n' $$p $$k; done; done; } $(call whole,$@)

# ensemble.sh runs under GNU parallel and goes on where it was stopped.
$(QSO)/ensemble: $(QS)/ensemble.sh $(QS)/run.sh $(QS)/shear.awk $(QS)/triaxial.toml $(QSO)/runs.tsv $(QSO)/packing.h5 \
  $(BIN)/run-dem $(BIN)/homogenize $(BIN)/fabric
	@BIN=$(BIN) OUT=$(QSO) $(QS)/ensemble.sh $(QSO)/runs.tsv $(QSO)/packing.h5 $(QS)/triaxial.toml
	@touch $@

# Tables of the packing before loading.
QS_PACKING := $(addprefix $(QSO)/,packing_cell.tsv packing_fabric.tsv rose.tsv histogram.tsv petals.tsv grains.txt)
$(QS_PACKING) &: $(QSO)/packing.h5 $(QS)/petals.awk $(BIN)/homogenize $(BIN)/fabric $(BIN)/to-vtk
	@$(BIN)/homogenize $< --tsv > $(QSO)/packing_cell.tsv
	@$(BIN)/fabric $< --tsv > $(QSO)/packing_fabric.tsv
	@$(BIN)/fabric $< --tsv --table rose > $(QSO)/rose.tsv
	@$(BIN)/fabric $< --tsv --table histogram > $(QSO)/histogram.tsv
	@awk -f $(QS)/petals.awk $(QSO)/rose.tsv > $(QSO)/petals.tsv
	@$(BIN)/to-vtk --text $< --force -o $(QSO)/grains.txt

QS_ENSEMBLES := $(foreach p,$(QS_PRESSURES),$(QSO)/ensemble_$(p)MPa.tsv)
$(QS_ENSEMBLES): $(QSO)/ensemble_%MPa.tsv: $(QS)/ensemble.awk $(QSO)/ensemble
	@awk -f $< $(QSO)/runs/$*MPa_*/series.tsv $(call whole,$@)

$(QSO)/measured.tsv: $(QS)/measure.sh $(QS_ENSEMBLES) $(QS_PACKING) $(QS_LAB)
	@OUT=$(QSO) $(QS)/measure.sh $(call whole,$@)

$(QSO)/comparison.tsv: pipelines/compare.awk $(QS)/expected.tsv $(QSO)/measured.tsv
	@awk -f $< $(QS)/expected.tsv $(QSO)/measured.tsv $(call whole,$@)

$(QSO)/figures: $(QS)/figures.gp $(QS_ENSEMBLES) $(QS_PACKING) $(QS_LAB)
	@for format in svg png; do gnuplot -e "out='$(QSO)'; format='$$format'" $<; done
	@touch $@

$(QSO)/provenance.txt: $(QSO)/ensemble $(BIN)/to-vtk
	@$(BIN)/to-vtk --history $(QSO)/runs/0.2MPa_0/run.h5 $(call whole,$@)

$(QSO)/page.html: $(QS)/page.sh pipelines/figure.sh pipelines/table.awk $(QSO)/comparison.tsv $(QSO)/figures $(QSO)/provenance.txt
	@OUT=$(QSO) $(QS)/page.sh $(call whole,$@)
	@awk -F '\t' 'NR > 1 { n[$$7]++ } END { printf "quickstart: %d published values met, %d not met (make report)\n", \
	  n["met"], n["not met"] }' $(QSO)/comparison.tsv
