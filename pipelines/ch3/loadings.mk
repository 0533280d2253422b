# Compares the loading of the study with slow and fast plates, on bags of several representative volumes: only a mean over volumes shows its
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
# With PP, loads at 1 % scatter most. More volumes are compared there, and compressed no farther than this strain.
C3L_MORE := 10 11 12 13 14 15 16 17
C3L_END_MORE := 0.02
SETTINGS += ch3/loadings
SETTINGS_ch3/loadings = $(C3L_END_MORE) $(foreach of,$(C3L_OF),$(C3L_$(of)) $(C3L_END_PE_$(of)) $(C3L_END_PP_$(of)))
C3L_RUNS := $(foreach v,$(C3L_VOLUMES),$(foreach g,PE PP,$(C3L_OF:%=$(C3L)/$v/$g_%)))
C3L_STARTS := $(foreach v,$(C3L_MORE),$(C3L_OF:%=$(C3L)/$v/PP_%))

.PHONY: ch3-loadings
ch3-loadings: $(C3L_RUNS:%=%.tsv) $(C3L_STARTS:%=%.tsv) ## compare the loading of ch3 with slow and fast plates, and keep it
	@$(foreach of,stresses steps,$(STUDY_PY) -m ch3.loadings $(of) $(C3L) $(C3L_VOLUMES) $(call whole,$(C3)/kept/loadings_$(of)_$(PROFILE).tsv) &&) :
	@$(STUDY_PY) -m ch3.loadings start $(C3L) $(C3L_MORE) $(call whole,$(C3)/kept/loadings_start_$(PROFILE).tsv)

.PRECIOUS: $(C3L)/%/rv.h5 $(C3L)/%/bag.h5 $(C3L)/%.h5
$(C3L)/%/rv.h5: $(BIN)/pack-generate
	@mkdir -p $(@D)
	@$(call pack_volume,$*)
$(C3L)/%/bag.h5: $(C3L)/%/rv.h5 $(C3)/bag.toml $(BIN)/filter-expand $(C3O)/bag.settings
	@echo '  fill  $@'
	@$(call fill_bag)
# The file's name is GEOTEXTILE_LOADING.
c3l = $(word $(1),$(subst _, ,$(basename $(@F))))
# $(call c3l_end,VOLUME) are options of how far its bags are compressed. States are recorded at strains that the run reaches.
c3l_end = $(if $(filter $(1),$(C3L_MORE)),--set stage.1.strain=$(C3L_END_MORE) --set record.strains=[$(C3L_END_MORE)],\
  --set stage.1.strain=$(C3L_END_$(call c3l,1)_$(call c3l,2)))
$(C3L_RUNS:%=%.h5) $(C3L_STARTS:%=%.h5): $(C3L)/%.h5: $(C3L)/$$(*D)/bag.h5 $(C3)/uc.toml $(BIN)/run-dem $(GEOTEXTILES) $(C3O)/load.settings \
  $(C3O)/loadings.settings
	@echo '  run   $@'
	@$(call compress,$(call c3l,1),$(call c3l_end,$(*D)),$(C3L_$(call c3l,2)))
