# Chapter 2: contact parameters of Toyoura sand identified by the particle filter (thesis Figs. 2.1 to 2.4).
# SPDX-License-Identifier: GPL-3.0-or-later
# A case is LAW_GRAINS_PRESSURE: hm (Hertz-Mindlin) or cl (linear), number of grains, MPa. The sets of the first round are drawn from
# the prior, those of the next around the posterior of all sets so far. Slurm: ENGINE=slurm; other hosts: SSHLOGINFILE=FILE.

STUDIES += ch2
C2 := pipelines/ch2
C2O := $(OUT)/ch2
C2_CASES_quick := hm_1000_0.2 cl_1000_0.2
C2_CASES_thesis := $(foreach n,1000 2000 5000,hm_$(n)_0.2 cl_$(n)_0.2) $(foreach p,0.5 1 2 4 8,hm_1000_$(p) cl_1000_$(p))
C2_CASES ?= $(C2_CASES_$(PROFILE))
# Sets of each round, and the axial strain (%) up to which runs go and are compared.
C2_SAMPLES_quick := 32 24
# The thesis's 2000, and rounds after them: each narrows the posterior further than more sets of the first would.
C2_SAMPLES_thesis := 2000 200 100 100
C2_SAMPLES ?= $(C2_SAMPLES_$(PROFILE))
C2_STRAIN_quick := 6
C2_STRAIN_thesis := 8.5
C2_STRAIN ?= $(C2_STRAIN_$(PROFILE))
C2_PRIOR_quick = $(C2)/prior_quick_$(1).toml
C2_PRIOR_thesis = $(C2)/prior_thesis.toml
C2_ROUNDS := $(shell seq $(words $(C2_SAMPLES)))
C2_LAST := $(lastword $(C2_ROUNDS))
C2_SCENARIO_hm := $(C2)/hertz-mindlin.toml
C2_SCENARIO_cl := $(C2)/linear.toml
# Variances of the observation error: of the radial strain (%), the stress ratio and the volumetric strain (%). The thesis
# has 0.1 for all; 0.3 of a stress ratio is 8 % of it, so that the strains then decide alone. 0.025 is 4 % of it.
C2_ERROR ?= 0.1,0.025,0.1
# Of the greatest stress ratio, where there is no curve: the thesis's.
C2_ERROR_peak := 0.1
c2_error = $(if $(call has_curve,$(1)),--covariance component --error $(C2_ERROR),--error $(C2_ERROR_peak))
# Strains (%) at which densities are drawn, as far as the runs go.
C2_STATIONS := 0.5 1 3 6 8.5

law = $(word 1,$(subst _, ,$(1)))
grains = $(word 2,$(subst _, ,$(1)))
pressure = $(word 3,$(subst _, ,$(1)))
# Where there is a curve of the laboratory, three observables at each of its stations; else the greatest stress ratio alone.
C2_CURVES := 0.2 0.5
has_curve = $(filter $(call pressure,$(1)),$(C2_CURVES))
observed = $(if $(call has_curve,$(1)),data/laboratory/toyoura_drained_triaxial_$(call pressure,$(1))MPa.tsv,$(C2O)/peak_$(call pressure,$(1))MPa.tsv)
compared = $(if $(call has_curve,$(1)),--runs '$(C2O)/$(1)/runs/{id:06}/series.h5' --where stage=1 --station strain_axial --until $(C2_STRAIN) \
  --observe strain_radial=strain_xx$(comma)strain_yy --observe stress_ratio --observe strain_volumetric \
  $(foreach s,$(C2_STATIONS),--at $(s)),--runs '$(C2O)/$(1)/runs/{id:06}/peak.tsv')
comma := ,

.PHONY: ch2
ch2: $(C2O)/page.html ## contact parameters identified with the particle filter (thesis: 2000 runs a case; C2_CASES=...)

# Remembers what the variables above decide; ensembles depend on it.
$(C2O)/settings: always
	@mkdir -p $(@D)
	@printf '%s\n' '$(PROFILE) $(C2_SAMPLES) $(C2_STRAIN) $(C2_ERROR)' | cmp -s - $@ || printf '%s\n' '$(PROFILE) $(C2_SAMPLES) $(C2_STRAIN) $(C2_ERROR)' > $@

C2_SIZES := $(sort $(foreach c,$(C2_CASES),$(call grains,$(c))))
$(C2_SIZES:%=$(C2O)/packing_%.h5): $(C2O)/packing_%.h5: $(BIN)/pack-generate
	@mkdir -p $(@D)
	@echo '  pack  $@'
	@pipelines/resume.sh $@ $(BIN)/pack-generate --grains $* --void-ratio 0.68 --pressure 1e3 --seed 1

# q/p at failure as stress ratio, (3 + 2 q/p)/(3 - q/p).
$(C2O)/peak_%MPa.tsv: data/laboratory/toyoura_peak_obliquity.tsv
	@mkdir -p $(@D)
	@awk -F '\t' -v p=$* 'BEGIN { printf "point [1]\tstress_ratio_peak [1]\n" } $$1 == 1000 * p { printf "1\t%.6g\n", (3 + 2 * $$2) / (3 - $$2) }' \
	  $< $(call whole,$@)

# One round of one case. $(1): case, $(2): number of the round, $(3): sets, $(4): the round before.
c2_made = $(if $(4),resample $(C2O)/$(1)/posterior$(4).h5 --keep --seed $(2),draw $(call C2_PRIOR_$(PROFILE),$(call law,$(1))) --bases 2$(comma)5$(comma)7$(comma)9$(comma)11)
define c2_round
$(C2O)/$(1)/round$(2).h5 $(C2O)/$(1)/round$(2).tsv &: $(if $(4),$(C2O)/$(1)/posterior$(4).h5,$(call C2_PRIOR_$(PROFILE),$(call law,$(1)))) \
  $(C2O)/settings $(BIN)/pf-weight
	@mkdir -p $$(@D)
	@$(BIN)/pf-weight $(c2_made) --samples $(3) --tsv --force -o $(C2O)/$(1)/round$(2).h5 \
	  $$(call whole,$(C2O)/$(1)/round$(2).tsv)
$(C2O)/$(1)/ran$(2): $(C2)/ensemble.sh $(C2)/run.sh $(C2O)/$(1)/round$(2).tsv $(C2O)/packing_$(call grains,$(1)).h5 $(C2_SCENARIO_$(call law,$(1))) \
  $(BIN)/run-dem $(BIN)/homogenize
	@BIN=$(BIN) $(C2)/ensemble.sh $(C2O)/$(1)/round$(2).tsv $(C2O)/$(1) $(call law,$(1)) $(C2O)/packing_$(call grains,$(1)).h5 \
	  $(C2_SCENARIO_$(call law,$(1))) $(call pressure,$(1)) $(if $(call has_curve,$(1)),$(C2_STRAIN),10)
	@touch $$@
$(C2O)/$(1)/posterior$(2).h5: $(C2O)/$(1)/ran$(2) $(call observed,$(1)) $(BIN)/pf-weight
	@$(BIN)/pf-weight assimilate $(C2O)/$(1)/round$(2).h5 $(call observed,$(1)) $(call compared,$(1)) $(call c2_error,$(1)) --force -o $$@ \
	  > $(C2O)/$(1)/posterior$(2).txt
$(foreach t,steps density,$(C2O)/$(1)/$(t)$(2).tsv): $(C2O)/$(1)/%$(2).tsv: $(C2O)/$(1)/posterior$(2).h5
	@$(BIN)/pf-weight assimilate $(C2O)/$(1)/round$(2).h5 $(call observed,$(1)) $(call compared,$(1)) $(call c2_error,$(1)) --quiet \
	  --tsv --table $$* $$(call whole,$$@)
endef
$(foreach c,$(C2_CASES),$(foreach r,$(C2_ROUNDS),$(eval $(call c2_round,$(c),$(r),$(word $(r),$(C2_SAMPLES)),$(filter-out 0,$(shell expr $(r) - 1))))))
# One ensemble after the other, since each has all cores: a case waits for the last round of the case before.
define c2_after
$(C2O)/$(2)/ran1: | $(C2O)/$(1)/ran$(C2_LAST)
endef
c2_pairs = $(join $(addsuffix :,$(filter-out $(lastword $(C2_CASES)),$(C2_CASES))),$(wordlist 2,$(words $(C2_CASES)),$(C2_CASES)))
$(foreach p,$(c2_pairs),$(eval $(call c2_after,$(word 1,$(subst :, ,$(p))),$(word 2,$(subst :, ,$(p))))))

# The identified means, and the thesis's where it has them, run through the same test as the curves of the laboratory go.
C2_CHECKED := $(foreach c,$(C2_CASES),$(if $(call has_curve,$(c)),$(c)))
define c2_check
$(C2O)/$(1)/check.tsv: $(C2)/check.sh $(C2)/run.sh $(C2O)/$(1)/steps$(C2_LAST).tsv $(wildcard data/contacts/toyoura_$(call law,$(1))_$(call pressure,$(1))MPa.tsv)
	@BIN=$(BIN) $(C2)/check.sh $(C2O)/$(1) $(call law,$(1)) $(C2O)/packing_$(call grains,$(1)).h5 $(C2_SCENARIO_$(call law,$(1))) \
	  $(call pressure,$(1)) $(C2O)/$(1)/steps$(C2_LAST).tsv $(call observed,$(1)) $(C2_STRAIN) data/contacts/toyoura_$(call law,$(1))_$(call pressure,$(1))MPa.tsv \
	  $$(call whole,$$@)
endef
$(foreach c,$(C2_CHECKED),$(eval $(call c2_check,$(c))))

C2_TABLES := $(foreach c,$(C2_CASES),$(foreach r,$(C2_ROUNDS),$(foreach t,steps density,$(C2O)/$(c)/$(t)$(r).tsv)))
C2_CHECKS := $(C2_CHECKED:%=$(C2O)/%/check.tsv)

$(C2O)/measured.tsv: $(C2)/measure.awk $(C2_TABLES) $(C2_CHECKS)
	@awk -v cases='$(C2_CASES)' -v checked='$(C2_CHECKED)' -v round=$(C2_LAST) -v folder=$(C2O) -f $< $(call whole,$@)
# Only what this profile measures is compared.
$(C2O)/expected.tsv $(C2O)/statements.tsv: $(C2O)/%.tsv: $(C2)/%.tsv $(C2O)/measured.tsv
	@awk -F '\t' 'FNR == NR { known[$$1] = 1; next } /^#/ || $$1 == "name" || ($$1 in known)' $(C2O)/measured.tsv $< $(call whole,$@)
$(C2O)/comparison.tsv: pipelines/compare.awk $(C2O)/expected.tsv $(C2O)/measured.tsv
	@awk -f $^ $(call whole,$@)
$(C2O)/checklist.tsv: pipelines/compare.awk $(C2O)/statements.tsv $(C2O)/measured.tsv
	@awk -f $^ $(call whole,$@)

$(C2O)/figures: $(C2)/figures.gp $(C2_TABLES) $(C2_CHECKS)
	@for format in svg png; do gnuplot -e "out='$(C2O)'; format='$$format'; cases='$(C2_CASES)'; checked='$(C2_CHECKED)'; \
	  last='$(C2_LAST)'; rounds='$(C2_ROUNDS)'; until=$(C2_STRAIN)" $<; done
	@touch $@

$(C2O)/page.html: $(C2)/page.sh pipelines/table.awk $(C2O)/comparison.tsv $(C2O)/checklist.tsv $(C2O)/figures
	@OUT=$(C2O) CASES='$(C2_CASES)' SAMPLES='$(C2_SAMPLES)' LAST=$(C2_LAST) ERROR='$(C2_ERROR)' PROFILE=$(PROFILE) $(C2)/page.sh $(call whole,$@)
	@awk -F '\t' '$$7 == "met" { ++met } $$7 == "not met" { ++not } END { printf "ch2: %d published values and statements met, %d not met (make report)\n", \
	  met, not }' $(C2O)/comparison.tsv $(C2O)/checklist.tsv
