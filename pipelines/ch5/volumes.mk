# Constants identified from seven bags of each of several representative volumes, in the quick profile. Their scatter tells how much of a
# difference from Table 5.2 may be chance: the intervals of one volume's fit do not contain it.
# SPDX-License-Identifier: GPL-3.0-or-later
C5V := $(C5O)/volumes
C5V_VOLUMES := 4 5 6 7
# Chapter 3 makes the bags, for its comparison of loadings.
C5V_RUNS := $(foreach v,$(C5V_VOLUMES),$(C5_GEOTEXTILES:%=$(C5V)/$v/uc_%))

.PHONY: ch5-volumes
ch5-volumes: $(C5V_VOLUMES:%=$(C5V)/%/own_constants.tsv) ## constants from bags of several representative volumes, and keep them
	@$(STUDY_PY) -m ch5.volumes constants $(C5)/kept $(C5V_VOLUMES:%=$(C5V)/%) $(call whole,$(C5)/kept/volumes_$(PROFILE).tsv)

.PRECIOUS: $(C5V)/%.h5
# The file's name is uc_GEOTEXTILE.
c5v_geotextile = $(patsubst uc_%,%,$(basename $(@F)))
$(C5V_RUNS:%=%.h5): $(C5V)/%.h5: $(C3L)/$$(*D)/bag.h5 $(C3)/uc.toml $(BIN)/run-dem $(GEOTEXTILES) $(C3O)/load.settings \
  $(C5O)/$$(*F).settings
	@mkdir -p $(@D)
	@echo '  run   $@'
	@$(call compress,$(c5v_geotextile),$(call c5_far,$(c5v_geotextile)) --set record.strains=$(C5_STATES))
$(C5V_RUNS:%=%.tsv): $(C5V)/%.tsv: $(C5V)/%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --table loading --tsv $(call whole,$@)
$(foreach v,$(C5V_VOLUMES),$(eval $(call c5_own,$(C5V)/$v)))
