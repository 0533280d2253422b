# The response of the same sets under the study's loading, under the study's rate without its masses and its drag, and under slow loading.
# SPDX-License-Identifier: GPL-3.0-or-later
C2L := $(C2O)/loading
C2L_CASES := hm_1000_0.2 cl_1000_0.2
C2L_SETS ?= 40
C2L_STRAIN := 4
# The loadings, as scripts for sed that change the study's scenario.
C2L_OF := study plain slow
C2L_study :=
C2L_plain := /^mass_scaling = /d;/^rest_drag = /d
C2L_slow := $(C2L_plain);s/^rate = .*/rate = 0.01/

SETTINGS += ch2/loading
SETTINGS_ch2/loading = $(PROFILE) $(C2L_SETS) $(C2L_STRAIN) $(C2_BASES) $(foreach of,$(C2L_OF),$(C2L_$(of)))

.PHONY: ch2-loading
ch2-loading: $(foreach c,$(C2L_CASES),$(C2L_OF:%=$(C2L)/$c/%.tsv)) ## compare the loading of ch2 with slow loading, and keep it
	@mkdir -p $(C2)/kept
	@$(STUDY_PY) -m ch2.loading $(C2L) $(C2L_CASES) $(call whole,$(C2)/kept/loading_$(PROFILE).tsv)

$(C2L)/%/sets.tsv: $$(c2_prior) $(BIN)/pf-weight $(C2O)/loading.settings
	@mkdir -p $(@D)
	@$(BIN)/pf-weight draw $< --samples $(C2L_SETS) --bases $(C2_BASES) --quiet --tsv $(call whole,$@)
define c2_loaded
$(C2L)/%/$(1)/done: $(C2L)/%/sets.tsv $$$$(c2_packing) $$$$(c2_scenario) $$(C2_RUN)
	@mkdir -p $$(@D)
	@sed '$$(C2L_$(1))' $$(c2_scenario) $$(call whole,$$(@D)/scenario.toml)
	@BIN=$$(BIN) $$(CALIBRATION)/ensemble.sh $$< $$(@D) $$(c2_law) $$(c2_packing) $$(@D)/scenario.toml $$(c2_pressure) $$(C2L_STRAIN)
	@touch $$@
$(C2L)/%/$(1).tsv: $(C2L)/%/$(1)/done $$(BIN)/pf-weight
	@$$(call c2_compare,$$(@D)/sets.tsv,$$(@D)/$(1)) curves --until $$(C2L_STRAIN) $$(call whole,$$@)
endef
$(foreach of,$(C2L_OF),$(eval $(call c2_loaded,$(of))))
