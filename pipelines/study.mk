# What every study shares: where results go, how big they are, how the report is collected.
# SPDX-License-Identifier: GPL-3.0-or-later

OUT := out
PROFILE ?= quick
TOOL_BIN := $(CURDIR)/$(B)/bin
export PATH := $(TOOL_BIN):$(PATH)

# A study adds its name to STUDIES and its page to PAGES.
PAGES :=
include $(sort $(wildcard pipelines/*/study.mk))

.PHONY: report
report: $(OUT)/report.html ## collect every study's page in out/report.html

$(OUT)/report.html: pipelines/report.sh $(PAGES)
	@bash pipelines/report.sh $(PAGES) > $@.tmp && mv $@.tmp $@
	@echo "report: $@"
