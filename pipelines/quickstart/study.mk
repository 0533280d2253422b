# Quickstart: 1000 grains of Toyoura sand from a grading curve to triaxial tests, beside the laboratory's.
# SPDX-License-Identifier: GPL-3.0-or-later

STUDIES += quickstart
Q := $(OUT)/quickstart
PAGES += $(Q)/page.html
QS := pipelines/quickstart

# Confining pressures (MPa) and twins (initial positions moved by 1e-6 of the radius) per pressure.
Q_PRESSURES := 0.2 0.5 1.0
Q_TWINS := $(if $(filter thesis,$(PROFILE)),1 2 3 4 5 6 7 8,1 2 3 4)

.PHONY: quickstart
quickstart: report ## the first study: Toyoura sand, from a grading curve to a triaxial test

$(Q)/packing.h5: $(B)/bin/pack-generate
	@mkdir -p $(Q)
	pack-generate --grains 1000 --void-ratio 0.68 --pressure 1e3 --seed 1 --force -o $@

# One row, one job. The job log lets parallel go on where an interrupted run stopped, and repeat what failed; a run that
# is complete keeps its file, whose provenance names packing and scenario.
$(Q)/runs.done: $(QS)/triaxial.toml $(QS)/run-one.sh $(Q)/packing.h5 $(B)/bin/run-dem $(B)/bin/homogenize
	@[ ! -f $@ ] || rm -f $(Q)/jobs.log
	parallel --jobs $(JOBS) --joblog $(Q)/jobs.log --resume-failed --halt soon,fail=20% \
	  bash $(QS)/run-one.sh $(QS)/triaxial.toml $(Q)/packing.h5 $(Q) {1} {2} ::: $(Q_PRESSURES) ::: $(Q_TWINS)
	@touch $@

$(Q)/metrics.tsv: $(QS)/measure.sh $(Q)/runs.done $(B)/bin/fabric $(B)/bin/homogenize
	bash $(QS)/measure.sh $(Q) "$(Q_PRESSURES)" "$(Q_TWINS)"

$(Q)/figures.done: $(QS)/figures.gp $(Q)/metrics.tsv
	gnuplot -e "dir='$(Q)'" $(QS)/figures.gp
	@touch $@

$(Q)/page.html: $(QS)/page.sh $(QS)/expected.tsv $(Q)/figures.done $(Q)/metrics.tsv $(B)/bin/to-vtk
	bash $(QS)/page.sh $(Q) $(QS)/expected.tsv > $@.tmp && mv $@.tmp $@
