# Rules that all studies share: places of results, the profile, the report. A study is a folder with a study.mk that adds its
# name to STUDIES, gives a target of that name, and makes out/NAME/page.html, its section of the report.
# SPDX-License-Identifier: GPL-3.0-or-later

PROFILE ?= quick
ifeq ($(filter $(PROFILE),quick thesis),)
$(error PROFILE=$(PROFILE): choose quick or thesis)
endif
OUT := out
BIN := $(B)/bin
ifneq ($(words $(OUT)) $(words $(BIN)),1 1)
$(error OUT=$(OUT) BIN=$(BIN): make cannot use a folder with blanks in its path)
endif
# Debian's own interpreter has the packages that the studies use. The studies share the package `study`.
PYTHON ?= /usr/bin/python3
# -P: the folder of study.py does not hide the package of that name.
STUDY_PY := PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=pipelines $(PYTHON) -P
STUDY := $(wildcard pipelines/study/*.py pipelines/study/templates/*)

# Geotextiles that scenarios and gws-solve know by name.
GEOTEXTILES := $(wildcard data/geotextiles/*.toml)

# A comma, which functions of make take for the end of an argument.
comma := ,

# $(call remember,WORDS): a file with these words, which changes only when they do.
remember = mkdir -p $(@D) && { printf '%s\n' '$(1)' | cmp -s - $@ || printf '%s\n' '$(1)' > $@; }
# Whatever the profile decides depends on it.
$(OUT)/profile: always
	@$(call remember,$(PROFILE))

# Writes the output of a recipe to a temporary file and renames it, so that the file appears whole. The temporary name holds the shell's
# process number, because a killed make may leave writers behind while the next make works.
whole = > $(1).$$$$ && mv $(1).$$$$ $(1) || { status=$$?; rm -f $(1).$$$$; (exit $$status); }

include $(sort $(wildcard pipelines/*/study.mk))

# Options of a study that its rules keep in variables. Each of SETTINGS is STUDY/WHAT: the file OUT/STUDY/WHAT.settings holds the value of
# SETTINGS_STUDY/WHAT and changes only when the value does. A run depends on the options that it has, so that an edited option makes it anew.
$(SETTINGS:%=$(OUT)/%.settings): $(OUT)/%.settings: always
	@$(call remember,$(strip $(SETTINGS_$*)))

# Studies in KEEPING keep results of thesis-size runs, for readers who cannot spend the hours: tables, histories, comparisons and figures.
# NAME-keep keeps the tables of finished runs (ENDED_NAME), which are its prerequisites. NAME-compare makes comparisons and figures from
# the kept tables, without the runs; its prerequisites are the programs for this. BESIDE_NAME are further options of study.py.
.PHONY: $(KEEPING:%=%-keep) $(KEEPING:%=%-compare)
$(KEEPING:%=%-keep): %-keep: $(BIN)/to-vtk
	@$(if $(filter thesis,$(PROFILE)),,$(error $@: of PROFILE=thesis only))mkdir -p pipelines/$*/kept
	@$(if $(filter %.tsv,$^),cd $(OUT)/$* && cp --parents $(patsubst $(OUT)/$*/%,%,$(filter %.tsv,$^)) $(CURDIR)/pipelines/$*/kept)
	@for run in $(ENDED_$*); do $(BIN)/to-vtk --history $(OUT)/$*/$$run.h5 $(call whole,pipelines/$*/kept/$$run.txt) && echo "  keep  $$run" || exit; done
	@$(MAKE) --no-print-directory $*-compare
$(KEEPING:%=%-compare): %-compare: $(STUDY)
	@$(STUDY_PY) pipelines/$*/study.py pipelines/$*/kept --kept $(BESIDE_$*)

.PHONY: report
report: $(OUT)/report.html ## collect the pages of all studies in out/report.html

# A reader begins with the quickstart, and ends with the chapters.
READING := $(filter quickstart,$(STUDIES)) $(filter-out quickstart ch%,$(STUDIES)) $(filter ch%,$(STUDIES))
BAG := $(wildcard pipelines/ch3/bag3d.jpg)
$(OUT)/report.html: $(STUDY) $(READING:%=$(OUT)/%/page.html) $(OUT)/profile $(BAG) $(wildcard $(OUT)/took)
	@$(STUDY_PY) -m study.report $(OUT) $(READING) $(BAG:%=--picture %)
	@echo "report: $@"
