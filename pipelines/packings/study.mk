# Packings: the same sand made from nothing with few and with many grains, at two pressures, and what it then carries.
# SPDX-License-Identifier: GPL-3.0-or-later

STUDIES += packings
PK := pipelines/packings
PKO := $(OUT)/packings
PK_SCENARIO := pipelines/quickstart/triaxial.toml
PK_GRAINS_quick := 1000
PK_GRAINS_thesis := 1000 5000 10000
PK_GRAINS := $(PK_GRAINS_$(PROFILE))
PK_SEEDS := 1 2 3
PK_TWINS_quick := 0 1
PK_TWINS_thesis := 0 1 2 3
# GRAINS_PRESSURE_SEED and GRAINS_SEED_TWIN.
PK_PACKINGS := $(foreach n,$(PK_GRAINS),$(foreach p,1e3 1e5,$(foreach s,$(PK_SEEDS),$(n)_$(p)_$(s))))
PK_TESTS := $(foreach n,$(PK_GRAINS),$(foreach s,$(PK_SEEDS),$(foreach t,$(PK_TWINS_$(PROFILE)),$(n)_$(s)_$(t))))

.PHONY: packings
packings: $(PKO)/page.html ## packings of 1000 (thesis: to 10,000) grains from three seeds, and their triaxial strength

PK_CELLS := $(PK_PACKINGS:%=$(PKO)/packing_%.tsv)
$(PKO)/packing_%.h5: $(BIN)/pack-generate
	@mkdir -p $(@D)
	@echo '  pack  $@'
	@pipelines/resume.sh $@ $(BIN)/pack-generate --grains $(word 1,$(subst _, ,$*)) --pressure $(word 2,$(subst _, ,$*)) \
	  --seed $(word 3,$(subst _, ,$*)) --void-ratio 0.68
$(PK_CELLS): $(PKO)/packing_%.tsv: $(PKO)/packing_%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --tsv $(call whole,$@)

# Loaded at 0.2 MPa from the loose end, 1 kPa, as fast as the packing that they are compared with; twin 0 is the packing itself, the
# others are moved by 1e-6 r.
PK_CURVES := $(PK_TESTS:%=$(PKO)/triaxial_%.tsv)
define packing_test
$(PKO)/triaxial_$(1).tsv: $(PKO)/packing_$(word 1,$(subst _, ,$(1)))_1e3_$(word 2,$(subst _, ,$(1))).h5 $(PK_SCENARIO) \
  $(BIN)/run-dem $(BIN)/homogenize
	@echo '  run   $$@'
	@pipelines/resume.sh $(PKO)/triaxial_$(1).h5 $(BIN)/run-dem $$< $(PK_SCENARIO) --set stage.1.axial_strain=0.08 --set stage.1.rate=0.1 \
	  --perturb $(if $(filter %_0,$(1)),0,1e-6) --seed $(word 3,$(subst _, ,$(1)))
	@$(BIN)/homogenize $(PKO)/triaxial_$(1).h5 --tsv --table series $$(call whole,$$@)
endef
$(foreach t,$(PK_TESTS),$(eval $(call packing_test,$(t))))

$(PKO)/measured.tsv: $(PK)/measure.awk $(PK_CELLS) $(PK_CURVES) $(OUT)/profile
	@awk -v folder=$(PKO) -v sizes='$(PK_GRAINS)' -v seeds='$(PK_SEEDS)' -v twins='$(PK_TWINS_$(PROFILE))' -f $< $(call whole,$@)
# Only what this profile measures is compared.
$(PKO)/comparison.tsv: pipelines/compare.awk $(PK)/expected.tsv $(PKO)/measured.tsv
	@awk -F '\t' 'FNR == NR { known[$$1] = 1; next } /^#/ || $$1 == "name" || ($$1 in known)' $(PKO)/measured.tsv $(PK)/expected.tsv \
	  > $(PKO)/expected.tsv
	@awk -f $< $(PKO)/expected.tsv $(PKO)/measured.tsv $(call whole,$@)
$(PKO)/page.html: $(PK)/page.sh pipelines/table.awk $(PKO)/comparison.tsv
	@OUT=$(PKO) $(PK)/page.sh $(call whole,$@)
	@awk -F '\t' 'NR > 1 { n[$$7]++ } END { printf "packings: %d values met, %d not met (make report)\n", n["met"], n["not met"] }' \
	  $(PKO)/comparison.tsv

# Kept, since every test of a packing starts from it.
.PRECIOUS: $(PKO)/packing_%.h5
