# The bag of PE varied in one thing at a time (variants.tsv), to tell what a difference from the published figures comes from, and what
# one packing differs from the next by. All are compressed at 2 %/s, the bag itself too: slowly enough for inertia to be no part of
# it. Kept in pipelines/ch3/kept/variants_PROFILE.tsv, which the page shows, variant by variant, as they end; of full size, which is not
# soon repeated, with how each came to be. Beside it, in rates_*_PROFILE.tsv, how fast and slow plates compare.
# SPDX-License-Identifier: GPL-3.0-or-later
C3V := $(C3O)/variants
C3V_RATE := 0.02
# Past the greatest load; of full size, past the first yarn's break.
C3V_END_quick := 0.16
C3V_END_thesis := 0.10
C3V_STATES_quick := [0.04,0.08,0.12,0.16]
C3V_STATES_thesis := [0.04,0.08]
C3V_UC := --set stage.1.strain=$(C3V_END_$(PROFILE)) --set record.strains=$(C3V_STATES_$(PROFILE))
C3_SEEDS := $(filter-out seed_$(C3_SEED),seed_1 seed_2 seed_3)
# All but the study's own volume, which the bag itself is made of, and bags that are of full size alone.
C3_VARIANTS_quick := $(filter-out seed_$(C3_SEED) bulging_seed_%,$(shell awk -F '\t' '!/^#/ && $$1 != "name" { print $$1 }' $(C3)/variants.tsv))
# What the speed of the plates is worth, fast ones beside slow ones; of full size, nothing else.
C3V_RATES := paced fast held_often
C3V_SLOW_paced := slow_paced
C3V_SLOW_fast := slow
C3V_SLOW_held_often := slow_held_often
C3_VARIANTS_thesis := bag $(foreach r,$(C3V_RATES),$(r) $(C3V_SLOW_$(r)))
C3_VARIANTS := $(C3_VARIANTS_$(PROFILE))
C3V_ENDED := $(patsubst $(C3V)/%/uc_PE.h5,%,$(wildcard $(C3_VARIANTS:%=$(C3V)/%/uc_PE.h5)))
# $(call of_variant,NAME,COLUMN): its seed, - for the study's; its settings as options
of_variant = $(shell awk -F '\t' '$$1 == "$(1)" { n = split($$$(2), s, " "); for (i = 1; i <= n; ++i) print $(3) s[i] }' $(C3)/variants.tsv)
as_options = $(call of_variant,$(1),$(2),"--set ")

.PHONY: ch3-variants ch3-variants-keep
ch3-variants: $(C3_VARIANTS:%=$(C3V)/%/uc_PE.h5) ## vary the bag of ch3 in one thing at a time, and keep what each is worth
	@$(MAKE) --no-print-directory ch3-variants-keep && cat $(C3_KEPT)/variants_$(PROFILE).tsv
ch3-variants-keep: $(C3V)/variants.tsv $(BIN)/to-vtk ## keep what the variants of ch3 that have ended are worth
	@kept=$(C3_KEPT)/variants_$(PROFILE).tsv; awk -f $(C3)/merge.awk $< $$(ls $$kept 2> /dev/null) $(call whole,$$kept)
	@$(foreach r,$(C3V_RATES),$(if $(filter-out $(C3V_ENDED),$(r) $(C3V_SLOW_$(r))),,awk -f $(C3)/rates.awk \
	  $(C3V)/$(r)/uc_PE.tsv $(C3V)/$(C3V_SLOW_$(r))/uc_PE.tsv $(call whole,$(C3_KEPT)/rates_$(r)_$(PROFILE).tsv) || exit;))
	@$(if $(filter thesis,$(PROFILE)),kept=$(C3_KEPT)/variants_thesis.txt; for run in $(C3V_ENDED); do echo "== $$run" && \
	  $(BIN)/to-vtk --history $(C3V)/$$run/uc_PE.h5 || exit; done | awk -f $(C3)/merge.awk - $$(ls $$kept 2> /dev/null) $(call whole,$$kept))

.PRECIOUS: $(C3V)/%/rv.h5 $(C3V)/%/bag.h5 $(C3V)/%/uc_PE.h5
$(C3V)/%/rv.h5: $(C3)/variants.tsv $(BIN)/pack-generate
	@$(if $(call of_variant,$*,2),mkdir -p $(@D),$(error $(C3)/variants.tsv has no variant '$*'))
	@$(BIN)/pack-generate --grains 1000 --void-ratio 0.68 --pressure 1e3 --seed $(subst -,$(C3_SEED),$(call of_variant,$*,2)) --threads 1 --quiet --force -o $@
# What is only loaded otherwise is the bag itself.
$(C3V)/%/bag.h5: $(C3V)/%/rv.h5 $(C3O)/bag.h5 $(C3)/bag.toml $(BIN)/filter-expand
	@echo '  fill  $@'
	@if [ '$(call of_variant,$*,2)$(call of_variant,$*,3)' = - ]; then cp $(C3O)/bag.h5 $@; else \
	  $(BIN)/filter-expand $< $(C3)/bag.toml $(C3_BAG_$(PROFILE)) $(call as_options,$*,3) --threads $(C3_FILL_THREADS) --quiet --resume --force -o $@; fi
$(C3V)/%/uc_PE.h5: $(C3V)/%/bag.h5 $(C3)/uc.toml $(BIN)/run-dem
	@echo '  run   $@'
	@$(call compress,PE,$(C3V_UC) --set stage.1.rate=$(C3V_RATE),$(call as_options,$*,4))

# The bag itself comes first; the others are told as differences from it.
$(C3V)/variants.tsv: $(C3)/variants.awk $(C3)/variants.tsv $(patsubst %,$(C3V)/%/uc_PE.tsv,bag $(filter-out bag,$(C3V_ENDED)))
	@awk -v yarns=$(C3_YARNS_$(PROFILE)) -f $^ $(call whole,$@)

# What a misfit of the study comes from: bags otherwise shaped or filled, and how much of it is chance: bags of other representative
# volumes. At the study's own rate, past the greatest stress.
C3K := $(C3O)/causes
C3K_END := 0.15
C3K_UC := --set stage.1.strain=$(C3K_END) --set record.strains=[0.04,0.08,0.12]
C3_CAUSES_quick := bulging_corners round_corners sharp_corners unstretched meshed_evenly round_sides flatter_sides
C3_CAUSES := $(C3_CAUSES_$(PROFILE))
# Of full size one cause, for three volumes: what it is worth beside what chance is.
C3_BULGING_thesis := bulging_seed_1 bulging_seed_2 bulging_seed_3
C3_BULGING := $(C3_BULGING_$(PROFILE))
C3K_YARNS_quick := PE
C3K_YARNS_thesis := PE PP
C3K_BAGS := $(C3_CAUSES) $(C3_BULGING) $(C3_SEEDS)
C3K_RUNS := $(foreach run,$(C3K_BAGS),$(foreach g,$(C3K_YARNS_$(PROFILE)),$(run)/uc_$(g)))
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
ch3-causes: $(C3K_RUNS:%=$(C3K)/%.h5) ## compress bags otherwise shaped, filled or packed as the study does, and keep how near each is to the record
	@$(MAKE) --no-print-directory ch3-causes-keep && cat $(C3K_TABLES:%=$(C3_KEPT)/%_$(PROFILE).tsv)
ch3-causes-keep: $(C3K_WITH_RUNS:%=$(C3K)/%.tsv) $(BIN)/to-vtk ## keep how near such bags that have ended are to the record
	@$(foreach of,$(C3K_WITH_RUNS),cp $(C3K)/$(of).tsv $(C3_KEPT)/$(of)_$(PROFILE).tsv || exit; $(if $(filter thesis,$(PROFILE)), \
	  for run in $(filter $($(of)_ended:%=%/%),$(C3K_ENDED)); do echo "== $$run" && $(BIN)/to-vtk --history $(C3K)/$$run.h5 || exit; done \
	  $(call whole,$(C3_KEPT)/$(of)_thesis.txt) || exit;))

# of_cause GEOTEXTILE
define of_cause
.PRECIOUS: $(C3K)/%/uc_$(1).h5
$(C3K)/%/uc_$(1).h5: $(C3V)/%/bag.h5 $(C3)/uc.toml $(BIN)/run-dem
	@mkdir -p $$(@D)
	@echo '  run   $$@'
	@$$(call compress,$(1),$$(C3K_UC))
endef
$(foreach g,$(C3K_YARNS_$(PROFILE)),$(eval $(call of_cause,$(g))))

# What of the published values the runs whose tables are among the prerequisites have.
bag_compared = $(call measure,,$(C3_YARNS_$(PROFILE)),$(filter $(C3O)/%,$^)) | awk -v partial=1 -f pipelines/compare.awk $(C3)/expected.tsv - $(call whole,$@)
# cause_compared RUN FOLDER GEOTEXTILES: the bag itself is the study's
define cause_compared
$(C3K)/$(1)/comparison.tsv: $(foreach g,$(3),$(2)/uc_$(g).tsv $(2)/uc_$(g)_first_break.tsv) $(C3_MEASURE) $(C3_SET) pipelines/compare.awk $(C3)/expected.tsv
	@mkdir -p $$(@D)
	@$$(call bag_compared)
endef
$(eval $(call cause_compared,bag,$(C3O),$(C3K_YARNS_$(PROFILE))))
$(foreach r,$(sort $(C3K_BAGS)),$(eval $(call cause_compared,$(r),$(C3K)/$(r),$(patsubst $(r)/uc_%,%,$(filter $(r)/%,$(C3K_ENDED))))))
# $(call beside,OPTIONS): the bags whose comparisons are prerequisites
beside = awk -v leave=failure $(1) -f $^ $(call whole,$@)
beside_bag = $(C3)/beside.awk $(patsubst %,$(C3K)/%/comparison.tsv,bag $(1))
$(C3K)/causes.tsv: $(call beside_bag,$(causes_ended))
	@$(call beside)
$(C3K)/bulging.tsv: $(call beside_bag,$(bulging_ended))
	@$(call beside,-v scatter=1 -v apart=1)
$(C3K)/seeds.tsv: $(call beside_bag,$(seeds_ended))
	@$(call beside,-v scatter=1)
