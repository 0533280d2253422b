# What all studies share: where results go, the profile, the report. A study is a folder with a study.mk that adds its
# name to STUDIES, gives a target of that name, and makes out/NAME/page.html, its section of the report.
# SPDX-License-Identifier: GPL-3.0-or-later

PROFILE ?= quick
ifeq ($(filter $(PROFILE),quick thesis),)
$(error PROFILE=$(PROFILE): choose quick or thesis)
endif
OUT := out
BIN := $(B)/bin

# Changes only when the profile does; whatever the profile decides depends on it.
$(OUT)/profile: always
	@mkdir -p $(@D)
	@printf '%s\n' '$(PROFILE)' | cmp -s - $@ || printf '%s\n' '$(PROFILE)' > $@

# Puts what a recipe prints into a file that appears whole. The name beside it is the writing shell's own, since a make that
# was killed may leave writers behind while the next one is at work.
whole = > $(1).$$$$ && mv $(1).$$$$ $(1) || { rm -f $(1).$$$$; false; }

include $(sort $(wildcard pipelines/*/study.mk))

.PHONY: report
report: $(OUT)/report.html ## collect the pages of all studies in out/report.html

PAGES := $(foreach study,$(STUDIES),$(OUT)/$(study)/page.html)
$(OUT)/report.html: pipelines/report.sh pipelines/report.css $(PAGES)
	@pipelines/report.sh pipelines/report.css $(PAGES) $(call whole,$@)
	@echo "report: $@"
