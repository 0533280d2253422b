# Results of the thesis-size runs of chapter 6, kept in the repository for readers who have not the hours: tables, each run's history, and
# what is compared of them. Kept run by run, as they end; compared anew whenever that changes, without the runs.
# SPDX-License-Identifier: GPL-3.0-or-later
C6_KEPT := $(C6)/kept
C6_ENDED := $(patsubst $(C6O)/%.h5,%,$(wildcard $(C6_RUNS:%=$(C6O)/%.h5)))
C6_OF_ENDED := $(foreach run,$(C6_ENDED),$(filter %_$(run).tsv,$(C6_TABLES)))
.PHONY: ch6-keep
ch6-keep: $(BIN)/to-vtk $(C6_OF_ENDED) ## keep what the thesis-size runs of ch6 that have ended leave (PROFILE=thesis)
	@$(if $(filter thesis,$(PROFILE)),,$(error $@: of PROFILE=thesis only))mkdir -p $(C6_KEPT)
	@$(if $(C6_OF_ENDED),cp $(C6_OF_ENDED) $(C6_KEPT))
	@for run in $(C6_ENDED); do $(BIN)/to-vtk --history $(C6O)/$$run.h5 $(call whole,$(C6_KEPT)/$$run.txt) && echo "  keep  $$run" || exit; done
	@$(MAKE) --no-print-directory ch6-compare

.PHONY: ch6-compare
ch6-compare: $(C6_PY) ## compare anew what is kept of ch6
	@$(STUDY_PY) $(C6)/study.py $(C6_KEPT) --kept
