# The loading of the study beside slow plates and fast ones, on bags of several representative volumes: only a mean over volumes tells its
# effect from chance. Fast plates move at 10 %/s and slow ones at 0.5 %/s without a limit of the unbalanced force, wait under a drag of
# 60 1/s until the kinetic energy is 1e-5 J, and move unscaled masses.
# SPDX-License-Identifier: GPL-3.0-or-later
C3L := $(C3O)/loadings
C3L_VOLUMES := 4 5 6 7 8 9
C3L_OF := slow fast study
C3L_slow := $(C3V_GIVEN) --set stage.1.rate=0.005
C3L_fast := $(C3V_GIVEN) --set stage.1.rate=0.1
# Strains past the greatest load of most volumes. Volume 5 in PE, torn, bears more and more up to 18 % at least.
C3L_END_PE_slow := 0.16
C3L_END_PE_fast := 0.16
C3L_END_PE_study := 0.16
C3L_END_PP_slow := 0.16
C3L_END_PP_fast := 0.19
C3L_END_PP_study := 0.17
SETTINGS += ch3/loadings
SETTINGS_ch3/loadings = $(foreach of,$(C3L_OF),$(C3L_$(of)) $(C3L_END_PE_$(of)) $(C3L_END_PP_$(of)))
C3L_RUNS := $(foreach v,$(C3L_VOLUMES),$(foreach g,PE PP,$(C3L_OF:%=$(C3L)/$v/$g_%)))

.PHONY: ch3-loadings
ch3-loadings: $(C3L_RUNS:%=%.tsv) ## compare the loading of ch3 with slow and fast plates, on bags of six volumes, and keep the comparison
	@$(foreach of,stresses steps,$(STUDY_PY) -m ch3.loadings $(of) $(C3L) $(C3L_VOLUMES) $(call whole,$(C3)/kept/loadings_$(of)_$(PROFILE).tsv) &&) :

.PRECIOUS: $(C3L)/%/rv.h5 $(C3L)/%/bag.h5 $(C3L)/%.h5
$(C3L)/%/rv.h5: $(BIN)/pack-generate
	@mkdir -p $(@D)
	@$(call pack_volume,$*)
$(C3L)/%/bag.h5: $(C3L)/%/rv.h5 $(C3)/bag.toml $(BIN)/filter-expand $(C3O)/bag.settings
	@echo '  fill  $@'
	@$(call fill_bag)
# The file's name is GEOTEXTILE_LOADING.
c3l = $(word $(1),$(subst _, ,$(basename $(@F))))
$(C3L_RUNS:%=%.h5): $(C3L)/%.h5: $(C3L)/$$(*D)/bag.h5 $(C3)/uc.toml $(BIN)/run-dem $(GEOTEXTILES) $(C3O)/load.settings \
  $(C3O)/loadings.settings
	@echo '  run   $@'
	@$(call compress,$(call c3l,1),--set stage.1.strain=$(C3L_END_$(call c3l,1)_$(call c3l,2)),$(C3L_$(call c3l,2)))
