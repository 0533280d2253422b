# Every chapter at the thesis's own size, from one command. It takes hours, and goes on where it was stopped. thesis-forecast says beforehand
# how long it takes, and a page beside the results shows the progress.
# SPDX-License-Identifier: GPL-3.0-or-later
THESIS := pipelines/thesis
THESIS_OUT ?= $(OUT)/thesis
# Single runs go side by side, one on each core. Then each ensemble of chapter 2 uses all cores, hosts or Slurm nodes by itself.
THESIS_MAKE = $(MAKE) --no-print-directory PROFILE=thesis OUT=$(THESIS_OUT) C3_THREADS=1
THESIS_CASES := --cases $(C2_CASES_thesis) --two-scales $(foreach e,shape pullout,$(C6_CASES_thesis:%=$(e)_%.h5)) swinging_$(C6_MAIN_thesis).h5
THESIS_STATUS = $(STUDY_PY) $(THESIS)/status.py $(THESIS_OUT) $(THESIS_CASES)

.PHONY: thesis thesis-forecast thesis-status
thesis: ## every chapter at full size, into OUT/thesis: goes on where it was stopped (first: thesis-forecast)
	@$(AGAIN) deps
	@$(AGAIN) all
	@mkdir -p $(THESIS_OUT)
	@echo 'thesis: begins' >> $(THESIS_OUT)/log; $(THESIS_STATUS) --while $$$$ & \
	  echo "thesis: $(THESIS_OUT)/status.html tells how far it is"; \
	  { $(THESIS_MAKE) -k -j$(JOBS) ch3 ch4 ch5 ch6; a=$$?; $(THESIS_MAKE) -k ch2; b=$$?; [ $$a$$b = 00 ] && $(THESIS_MAKE) report; } 2>&1 | tee -a $(THESIS_OUT)/log; \
	  status=$${PIPESTATUS[0]}; $(THESIS_STATUS); exit $$status

thesis-status: ## write OUT/thesis/status.html anew: what is done, running (time left), stopped, failed (why)
	@mkdir -p $(THESIS_OUT)
	@$(THESIS_STATUS) && echo "$(THESIS_OUT)/status.html"

# fem-dem --check forecasts each run of chapter 6 from its packing. The packings take a minute.
C6_SAID := $(foreach e,shape pullout,$(C6_CASES_thesis:%=$(THESIS_OUT)/ch6/$(e)_%.check)) $(THESIS_OUT)/ch6/swinging_$(C6_MAIN_thesis).check
thesis-forecast: ## hours, memory and disk of make thesis by chapter, from a trial of about a minute
	@$(AGAIN) all
	@$(THESIS_MAKE) -j$(JOBS) $(C6_SAID)
	@$(STUDY_PY) $(THESIS)/forecast.py $(THESIS_OUT) --tools $(BIN) --cores $(shell nproc) --prior $(C2)/prior_thesis.toml --strain $(C2_STRAIN_thesis) \
	  --sets $$(($(subst $() ,+,$(strip $(C2_SAMPLES_thesis))))) --cases $(C2_CASES_thesis) --checks $(C6_SAID)
