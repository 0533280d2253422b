# The bag of PE varied in one thing at a time (variants.tsv). This shows the causes of differences from the published figures, and how much
# packings differ. All bags, also the unvaried one, are compressed at 2 %/s with a given drag and the thesis's limit of the kinetic energy at
# rest. That is slow enough for inertia to have no effect, and lets a variant change the loading. Each finished variant is kept in
# pipelines/ch3/kept/variants_PROFILE.tsv, which the page shows. Full-size variants are kept with their histories, since they are
# expensive to repeat. The tables rates_*_PROFILE.tsv beside it compare fast and slow plates.
# SPDX-License-Identifier: GPL-3.0-or-later
C3_KEPT := $(C3)/kept
C3V := $(C3O)/variants
C3V_PY := $(STUDY_PY) -m ch3.variants
# Plates of a given rate, and grains of unscaled masses.
C3V_GIVEN := --set stage.1.way_unbalanced_force=0 --set stage.1.homogeneous_start=false --set stage.1.rest_drag=60 \
  --set grains.mass_scaling=none --set equilibrium.kinetic_energy=1e-5
C3V_LOADING := --set stage.1.rate=0.02 $(C3V_GIVEN)
# Strain past the greatest load; at full size, past the first yarn's break.
C3V_END_quick := 0.16
C3V_END_thesis := 0.10
C3V_STATES_quick := [0.04,0.08,0.12,0.16]
C3V_STATES_thesis := [0.04,0.08]
SETTINGS += ch3/variants
SETTINGS_ch3/variants = $(C3V_UC) $(C3V_LOADING)
C3V_UC := --set stage.1.strain=$(C3V_END_$(PROFILE)) --set record.strains=$(C3V_STATES_$(PROFILE))
C3_SEEDS := $(filter-out seed_$(C3_SEED),seed_1 seed_2 seed_3)
# All rows of variants.tsv except the seed of the study's own bag, and bags that exist at full size only.
C3_VARIANTS_quick := $(filter-out name seed_$(C3_SEED) bulging_seed_%,$(shell sed '/^#/d' $(C3)/variants.tsv | cut -f 1))
# Effect of the speed of the plates: fast ones beside slow ones. At full size this is the only variant.
C3V_RATES := paced fast held_often followed
C3V_SLOW_paced := slow_paced
C3V_SLOW_fast := slow
C3V_SLOW_held_often := slow_held_often
C3V_SLOW_followed := slowest
C3_VARIANTS_thesis := bag $(foreach r,$(C3V_RATES),$(r) $(C3V_SLOW_$(r)))
C3_VARIANTS := $(C3_VARIANTS_$(PROFILE))
C3V_ENDED := $(patsubst $(C3V)/%/uc_PE.h5,%,$(wildcard $(C3_VARIANTS:%=$(C3V)/%/uc_PE.h5)))
# $(call of_variant,NAME,PART): the settings of a variant's bag or load, as options
of_variant = $$($(C3V_PY) options $(1) $(2))

.PHONY: ch3-variants ch3-variants-keep
ch3-variants: $(C3_VARIANTS:%=$(C3V)/%/uc_PE.h5) ## vary the bag of ch3 in one thing at a time, and keep the effect of each
	@$(MAKE) --no-print-directory ch3-variants-keep && cat $(C3_KEPT)/variants_$(PROFILE).tsv
ch3-variants-keep: $(C3V)/variants.tsv $(BIN)/to-vtk ## keep the effects of the finished variants of ch3
	@kept=$(C3_KEPT)/variants_$(PROFILE).tsv; $(C3V_PY) merge $$kept < $< $(call whole,$$kept)
	@$(foreach r,$(C3V_RATES),$(if $(filter-out $(C3V_ENDED),$(r) $(C3V_SLOW_$(r))),,\
	  $(C3V_PY) rates $(C3V)/$(r) $(C3V)/$(C3V_SLOW_$(r)) $(call whole,$(C3_KEPT)/rates_$(r)_$(PROFILE).tsv) || exit;))
	@$(if $(filter thesis,$(PROFILE)),kept=$(C3_KEPT)/variants_thesis.txt; for run in $(C3V_ENDED); do echo "== $$run" && \
	  $(BIN)/to-vtk --history $(C3V)/$$run/uc_PE.h5 || exit; done | $(C3V_PY) merge $$kept $(call whole,$$kept))

.PRECIOUS: $(C3V)/%/rv.h5 $(C3V)/%/bag.h5 $(C3V)/%/uc_PE.h5
$(C3V)/%/rv.h5: $(C3)/variants.tsv $(BIN)/pack-generate $(C3O)/rv.settings
	@mkdir -p $(@D)
	@seed=$$($(C3V_PY) seed $*) && $(call pack_volume,$${seed/#-/$(C3_SEED)})
# Variants that only load differently use the bag itself.
$(C3V)/%/bag.h5: $(C3V)/%/rv.h5 $(C3O)/bag.h5 $(C3)/bag.toml $(BIN)/filter-expand $(C3O)/bag.settings
	@echo '  fill  $@'
	@seed=$$($(C3V_PY) seed $*) && options=$(call of_variant,$*,bag) && if [ "$$seed$$options" = - ]; then cp $(C3O)/bag.h5 $@; else \
	  $(call fill_bag,$$options); fi
$(C3V)/%/uc_PE.h5: $(C3V)/%/bag.h5 $(C3)/uc.toml $(BIN)/run-dem $(GEOTEXTILES) $(C3O)/load.settings $(C3O)/variants.settings
	@echo '  run   $@'
	@options=$(call of_variant,$*,load) && $(call compress,PE,$(C3V_UC) $(C3V_LOADING),$$options)

# The bag itself comes first; the others are reported as differences from it.
$(C3V)/variants.tsv: $(C3_PY) $(STUDY) $(patsubst %,$(C3V)/%/uc_PE.tsv,bag $(filter-out bag,$(C3V_ENDED)))
	@$(C3V_PY) table $(C3V) bag $(filter-out bag,$(C3V_ENDED)) $(call whole,$@)

# Causes of a misfit of the study: bags of another shape or filling, and bags of other representative volumes, which
# show how much is chance.
# The runs have the study's own rate and go past the greatest stress.
C3K := $(C3O)/causes
C3K_UC := --set stage.1.strain=0.15 --set record.strains=[0.04,0.08,0.12]
C3_CAUSES_quick := bulging_corners round_corners sharp_corners unstretched meshed_evenly round_sides flatter_sides
C3_CAUSES := $(C3_CAUSES_$(PROFILE))
# At full size, one cause for three volumes: its effect beside the chance.
C3_BULGING_thesis := bulging_seed_1 bulging_seed_2 bulging_seed_3
C3_BULGING := $(C3_BULGING_$(PROFILE))
SETTINGS += ch3/causes
SETTINGS_ch3/causes = $(C3K_UC)
C3K_YARNS_quick := PE
C3K_YARNS_thesis := PE PP
C3K_RUNS := $(foreach run,$(C3_CAUSES) $(C3_BULGING) $(C3_SEEDS),$(foreach g,$(C3K_YARNS_$(PROFILE)),$(run)/uc_$(g)))
C3K_ENDED := $(patsubst $(C3K)/%.h5,%,$(wildcard $(C3K_RUNS:%=$(C3K)/%.h5)))
C3K_TABLES_quick := causes seeds
C3K_TABLES_thesis := bulging seeds
C3K_TABLES := $(C3K_TABLES_$(PROFILE))
# Bags of which a run has ended.
ended = $(filter $(1),$(sort $(patsubst %/,%,$(dir $(C3K_ENDED)))))
causes_ended := $(call ended,$(C3_CAUSES))
bulging_ended := $(call ended,$(C3_BULGING))
seeds_ended := $(call ended,$(C3_SEEDS))
C3K_WITH_RUNS := $(foreach of,$(C3K_TABLES),$(if $($(of)_ended),$(of)))

.PHONY: ch3-causes ch3-causes-keep
ch3-causes: $(C3K_RUNS:%=$(C3K)/%.h5) ## compress bags with another shape, filling or packing as ch3 does, and keep how near each is to the record
	@$(MAKE) --no-print-directory ch3-causes-keep && cat $(C3K_TABLES:%=$(C3_KEPT)/%_$(PROFILE).tsv)
ch3-causes-keep: $(C3K_WITH_RUNS:%=$(C3K)/%.tsv) $(BIN)/to-vtk ## keep how near the finished bags of ch3-causes are to the record
	@$(foreach of,$(C3K_WITH_RUNS),cp $(C3K)/$(of).tsv $(C3_KEPT)/$(of)_$(PROFILE).tsv || exit; $(if $(filter thesis,$(PROFILE)), \
	  for run in $(filter $($(of)_ended:%=%/%),$(C3K_ENDED)); do echo "== $$run" && $(BIN)/to-vtk --history $(C3K)/$$run.h5 || exit; done \
	  $(call whole,$(C3_KEPT)/$(of)_thesis.txt) || exit;))

# % is BAG/uc_GEOTEXTILE.
.PRECIOUS: $(C3K)/%.h5
.SECONDEXPANSION:
$(C3K)/%.h5: $(C3V)/$$(*D)/bag.h5 $(C3)/uc.toml $(BIN)/run-dem $(GEOTEXTILES) $(C3O)/load.settings $(C3O)/causes.settings
	@mkdir -p $(@D)
	@echo '  run   $@'
	@$(call compress,$(patsubst uc_%,%,$(*F)),$(C3K_UC))

# % is causes, bulging or seeds. The first bag is the study's own. apart adds mean and deviation of the other bags, scatter of all bags.
C3K_BESIDE_bulging := apart
C3K_BESIDE_seeds := scatter
c3k_runs = $(C3K_YARNS_$(PROFILE):%=$(C3O)/uc_%) $(filter $(foreach run,$($(1)_ended),$(C3K)/$(run)/%),$(C3K_ENDED:%=$(C3K)/%))
$(C3K_TABLES:%=$(C3K)/%.tsv): $(C3K)/%.tsv: $(C3_PY) $(STUDY) $$(foreach run,$$(call c3k_runs,$$*),$$(run).tsv $$(run)_path.tsv)
	@mkdir -p $(@D)
	@$(C3V_PY) $(or $(C3K_BESIDE_$*),beside) bag=$(C3O) $($*_ended:%=$(C3K)/%) $(call whole,$@)
