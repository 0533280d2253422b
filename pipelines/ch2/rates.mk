# Sets identified by runs at the study's rate of loading and at a tenth of it, and the response of one set at either rate. Most steps of a
# run wait for rest, so that the slow runs take some 1.6 times as long.
# SPDX-License-Identifier: GPL-3.0-or-later
C2R := $(C2O)/slow
C2R_RATE := 0.01
C2R_CASES := hm_1000_0.2 cl_1000_0.2

C2R_TABLES := $(foreach t,$(C2_LAST)_steps check_curves,$(foreach at,$(C2O) $(C2R),$(C2R_CASES:%=$(at)/%/$t.tsv)))

.PHONY: ch2-rates
ch2-rates: $(C2R_TABLES) ## what ch2 identifies at a tenth of the rate of loading, and keep it
	@mkdir -p $(C2)/kept
	@$(STUDY_PY) -m ch2.rates $(C2O) $(C2R) $(words $(C2_SAMPLES)) $(C2R_CASES) $(call whole,$(C2)/kept/rates_$(PROFILE).tsv)

$(C2R)/settings: always
	@$(call remember,$(C2R_RATE))
$(C2R)/%/posterior.h5: $$(c2_prior) $$(c2_packing) $$(c2_scenario) $$(c2_observed) $(C2_CALIBRATION) $(C2R)/settings
	@$(call c2_calibrate,--rate $(C2R_RATE) $(C2R)/$*)
$(C2R_CASES:%=$(C2R)/%/$(C2_LAST)_steps.tsv): $$(@D)/posterior.h5 ;

# The set that the study's rate identified. The calibration leaves the scenario with the other rate in its folder.
$(C2R)/%/checked: $(C2O)/%/check.tsv $(C2R)/%/posterior.h5 $$(c2_packing)
	@BIN=$(BIN) $(CALIBRATION)/ensemble.sh $< $(@D)/check $(c2_law) $(c2_packing) $(@D)/scenario_$(C2R_RATE).toml $(c2_pressure) $(C2_STRAIN)
	@touch $@
$(C2R)/%/check_curves.tsv: $(C2R)/%/checked $(BIN)/pf-weight
	@$(call c2_check,$(C2R)/$*) curves --until $(C2_STRAIN) $(call whole,$@)
