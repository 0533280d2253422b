# What the thesis-size runs of chapter 3 leave, kept in the repository for readers who have not the hours: tables, each run's history, and
# what is compared and drawn of them. Kept run by run, as they end; compared and drawn anew whenever that changes, without the runs.
# SPDX-License-Identifier: GPL-3.0-or-later
C3_KEPT := $(C3)/kept
C3_ENDED := $(patsubst $(C3O)/%.h5,%,$(wildcard $(C3O)/uc_*.h5 $(C3O)/ss_*.h5))
C3_OF_ENDED := $(filter $(foreach table,fabric groups path breaks,$(C3_ENDED:%=%_$(table))) $(C3_ENDED),$(C3_OF_RUNS))
.PHONY: ch3-keep
ch3-keep: $(BIN)/to-vtk $(C3_OF_ENDED:%=$(C3O)/%.tsv) $(C3_OF_BAG) ## keep what the thesis-size runs of ch3 that have ended leave (PROFILE=thesis)
	@$(if $(filter thesis,$(PROFILE)),,$(error $@: of PROFILE=thesis only))mkdir -p $(C3_KEPT)
	@cp $(filter %.tsv,$^) $(C3_KEPT)
	@for run in $(C3_ENDED); do $(BIN)/to-vtk --history $(C3O)/$$run.h5 $(call whole,$(C3_KEPT)/$$run.txt) && echo "  keep  $$run" || exit; done
	@$(BIN)/to-vtk --history $(C3O)/bag.h5 $(call whole,$(C3_KEPT)/generation.txt)
	@$(MAKE) --no-print-directory ch3-compare

.PHONY: ch3-compare
ch3-compare: $(C3_PY) ## compare and draw anew what is kept of ch3
	@$(STUDY_PY) $(C3)/study.py $(C3_KEPT) --kept
