# The bag of PE varied in one thing at a time (variants.tsv), to tell what a difference from the published figures comes from, and what
# one packing differs from the next by. Kept in pipelines/ch3/kept/variants_PROFILE.tsv, which the page shows.
# SPDX-License-Identifier: GPL-3.0-or-later
C3V := $(C3O)/variants
# Past the greatest load.
C3V_STRAIN_quick := 0.16
C3V_STRAIN_thesis := 0.14
C3V_UC = --set stage.1.strain=$(C3V_STRAIN_$(PROFILE))
C3_VARIANTS_quick := $(shell awk -F '\t' '!/^#/ && $$1 != "name" { print $$1 }' $(C3)/variants.tsv)
# Of full size: what grains twice as large might answer otherwise.
C3_VARIANTS_thesis := fast slow
C3_VARIANTS := $(C3_VARIANTS_$(PROFILE))
# $(call of_variant,NAME,COLUMN): its seed; its settings as options
of_variant = $(shell awk -F '\t' '$$1 == "$(1)" { n = split($$$(2), s, " "); for (i = 1; i <= n; ++i) print $(3) s[i] }' $(C3)/variants.tsv)
as_options = $(call of_variant,$(1),$(2),"--set ")

.PHONY: ch3-variants
ch3-variants: $(C3V)/variants.tsv ## vary the bag of ch3 in one thing at a time, and keep what each is worth
	@cp $< $(C3_KEPT)/variants_$(PROFILE).tsv && cat $<

.PRECIOUS: $(C3V)/%/rv.h5 $(C3V)/%/bag.h5 $(C3V)/%/uc.h5
$(C3V)/%/rv.h5: $(C3)/variants.tsv $(BIN)/pack-generate
	@mkdir -p $(@D)
	@$(BIN)/pack-generate --grains 1000 --void-ratio 0.68 --pressure 1e3 --seed $(call of_variant,$*,2) --threads 1 --quiet --force -o $@
# What is only loaded otherwise is the bag itself.
$(C3V)/%/bag.h5: $(C3V)/%/rv.h5 $(C3O)/bag.h5 $(C3)/bag.toml $(BIN)/filter-expand
	@echo '  fill  $@'
	@if [ '$(call of_variant,$*,2)$(call of_variant,$*,3)' = 1 ]; then cp $(C3O)/bag.h5 $@; else \
	  $(BIN)/filter-expand $< $(C3)/bag.toml $(C3_BAG_$(PROFILE)) $(call as_options,$*,3) --threads $(C3_FILL_THREADS) --quiet --resume --force -o $@; fi
$(C3V)/%/uc.h5: $(C3V)/%/bag.h5 $(C3)/uc.toml $(BIN)/run-dem
	@echo '  run   $@'
	@$(call compress,PE,$(C3V_UC),$(call as_options,$*,4))
$(C3V)/%/uc.tsv: $(C3V)/%/uc.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --table series --tsv $(call whole,$@)

# The bag itself comes first; the others are told as differences from it.
$(C3V)/variants.tsv: $(C3)/variants.awk $(C3)/variants.tsv $(C3O)/uc_PE.tsv $(C3_VARIANTS:%=$(C3V)/%/uc.tsv)
	@awk -v yarns=$(C3_YARNS_$(PROFILE)) -f $^ $(call whole,$@)
