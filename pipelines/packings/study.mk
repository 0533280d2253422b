# Packings of one sand, with few and with many grains, at two pressures, and their strength in triaxial compression.
# SPDX-License-Identifier: GPL-3.0-or-later

STUDIES += packings
PK := pipelines/packings
PKO := $(OUT)/packings
PK_SCENARIO := pipelines/quickstart/triaxial.toml
# study.py has the same numbers of grains and twins.
PK_GRAINS_quick := 1000
PK_GRAINS_thesis := 1000 5000 10000
PK_GRAINS := $(PK_GRAINS_$(PROFILE))
PK_SEEDS := 1 2 3
PK_TWINS_quick := 0 1
PK_TWINS_thesis := 0 1 2 3
# Packings are named GRAINS_PRESSURE_SEED, tests GRAINS_SEED_TWIN.
PK_PACKINGS := $(foreach n,$(PK_GRAINS),$(foreach p,1e3 1e5,$(foreach s,$(PK_SEEDS),$(n)_$(p)_$(s))))
PK_TESTS := $(foreach n,$(PK_GRAINS),$(foreach s,$(PK_SEEDS),$(foreach t,$(PK_TWINS_$(PROFILE)),$(n)_$(s)_$(t))))
pk_word = $(word $(1),$(subst _, ,$*))

.PHONY: packings
packings: $(PKO)/page.html ## packings of 1000 (thesis: to 10,000) grains from three seeds, and their triaxial strength

$(PKO)/packing_%.h5: $(BIN)/pack-generate
	@mkdir -p $(@D)
	@echo '  pack  $@'
	@pipelines/resume.sh $@ $(BIN)/pack-generate --grains $(call pk_word,1) --pressure $(call pk_word,2) --seed $(call pk_word,3) \
	  --void-ratio 0.68

# Packings made at 1 kPa are loaded at 0.2 MPa, as fast as the packing that they are compared with. Twin 0 is the packing itself. The
# grains of other twins are moved by 1e-6 r.
$(PKO)/triaxial_%.h5: $(PK_PACKINGS:%=$(PKO)/packing_%.h5) $(PK_SCENARIO) $(BIN)/run-dem
	@echo '  run   $@'
	@pipelines/resume.sh $@ $(BIN)/run-dem $(PKO)/packing_$(call pk_word,1)_1e3_$(call pk_word,2).h5 $(PK_SCENARIO) \
	  --set stage.1.axial_strain=0.08 --set record.strains=[0.05,0.08] --set stage.1.rate=0.1 $(if $(filter-out 0,$(call pk_word,3)),--perturb 1e-6 --seed $(call pk_word,2))

$(PKO)/cell_%.tsv: $(PKO)/%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --tsv $(call whole,$@)
$(PKO)/series_%.tsv: $(PKO)/%.h5 $(BIN)/homogenize
	@$(BIN)/homogenize $< --tsv --table series $(call whole,$@)

PK_TABLES := $(PK_PACKINGS:%=$(PKO)/cell_packing_%.tsv) $(PK_TESTS:%=$(PKO)/series_triaxial_%.tsv)
$(PKO)/page.html: $(PK)/study.py $(PK)/words.toml $(PK)/expected.tsv $(STUDY) $(PK_TABLES) $(OUT)/profile
	@$(STUDY_PY) $< $(PKO) --profile $(PROFILE) --seeds $(PK_SEEDS)

# Kept, since every test of a packing starts from it.
.PRECIOUS: $(PKO)/packing_%.h5 $(PKO)/triaxial_%.h5
