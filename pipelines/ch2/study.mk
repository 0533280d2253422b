# Chapter 2: contact parameters of Toyoura sand identified by the particle filter (thesis Figs. 2.1 to 2.4).
# SPDX-License-Identifier: GPL-3.0-or-later
# A case is LAW_GRAINS_PRESSURE: hm (Hertz-Mindlin) or cl (linear), number of grains, MPa. The sets of the first round are drawn from
# the prior, the sets of later rounds around the posterior of all sets so far. Slurm: ENGINE=slurm; other hosts: SSHLOGINFILE=FILE.

STUDIES += ch2
C2 := pipelines/ch2
C2O := $(OUT)/ch2
C2_CASES_quick := hm_1000_0.2 cl_1000_0.2
C2_CASES_thesis := $(foreach n,1000 2000 5000,hm_$(n)_0.2 cl_$(n)_0.2) $(foreach p,0.5 1 2 4 8,hm_1000_$(p) cl_1000_$(p))
C2_CASES ?= $(C2_CASES_$(PROFILE))
is_case = $(and $(filter 3,$(words $(subst _, ,$(1)))),$(filter hm cl,$(word 1,$(subst _, ,$(1)))))
$(foreach c,$(C2_CASES) $(C2_CASES_thesis),$(if $(call is_case,$c),,$(error C2_CASES: $c is no case; write LAW_GRAINS_PRESSURE, as hm_1000_0.2 or cl_5000_0.2)))
# Sets of each round, and the axial strain (%) up to which runs go and are compared.
C2_SAMPLES_quick := 32 24
# The thesis's 2000 sets, then further rounds. Each round narrows the posterior more than additional sets in the first round.
C2_SAMPLES_thesis := 2000 200 100 100
C2_SAMPLES ?= $(C2_SAMPLES_$(PROFILE))
C2_STRAIN_quick := 6
C2_STRAIN_thesis := 8.5
C2_STRAIN ?= $(C2_STRAIN_$(PROFILE))
# Runs that are compared only by their greatest stress ratio go farther.
C2_STRAIN_peak := 10
# Variances of the observation error of the radial strain (%), the stress ratio and the volumetric strain (%). The thesis
# has 0.1 for all. An error of 0.3 is 8 % of the stress ratio, so that the strains decide alone. A variance of 0.025 is an error of 4 %.
C2_ERROR ?= 0.1,0.025,0.1
C2_ERROR_thesis := 0.1
# Variance of the greatest stress ratio, if there is no curve.
C2_ERROR_peak := $(C2_ERROR_thesis)
# Strains (%) at which densities are drawn, as far as the runs go.
C2_STATIONS := 0.5 1 3 6 8.5
# Runs of the identified set, and of the thesis's where it has one, that differ by 1e-6 of a radius at the start.
C2_TWINS ?= 3
C2_ROUNDS := $(shell seq $(words $(C2_SAMPLES)))
C2_LAST := round$(lastword $(C2_ROUNDS))

# In the rules below % is the case.
c2_law = $(word 1,$(subst _, ,$*))
c2_pressure = $(word 3,$(subst _, ,$*))
c2_packing = $(C2O)/packing_$(word 2,$(subst _, ,$*)).h5
CALIBRATION := pipelines/calibration
C2_SCENARIO_hm := $(CALIBRATION)/hertz-mindlin.toml
C2_SCENARIO_cl := $(CALIBRATION)/linear.toml
c2_scenario = $(C2_SCENARIO_$(c2_law))
c2_prior = $(C2)/prior_$(PROFILE)$(if $(filter quick,$(PROFILE)),_$(c2_law)).toml
# A laboratory curve with three observables at each station, if there is one, or else the greatest stress ratio alone.
c2_curve = $(wildcard data/laboratory/toyoura_drained_triaxial_$(c2_pressure)MPa.tsv)
c2_observed = $(or $(c2_curve),$(C2O)/peak_$(c2_pressure)MPa.tsv)
# Options of a test: all rows of a curve as they are, or the greatest stress ratio.
C2_VARIANCE := $(join strain_radial= stress_ratio= strain_volumetric=,$(subst $(comma), ,$(C2_ERROR)))
C2_ALONG := natural --until $(C2_STRAIN) --variance $(subst $() ,$(comma),$(strip $(C2_VARIANCE))) --at $(subst $() ,$(comma),$(strip $(C2_STATIONS)))
C2_PEAK := greatest --until $(C2_STRAIN_peak) --variance stress_ratio_peak=$(C2_ERROR_peak)
c2_thesis = $(wildcard data/contacts/toyoura_$(c2_law)_$(c2_pressure)MPa.tsv)
C2_BASES := 2,5,7,9,11
# Ensembles run one after the other, since each uses all cores: a case waits for the last round of the case before.
C2_PAIRS := $(join $(C2_CASES:%=%:),$(wordlist 2,$(words $(C2_CASES)),$(C2_CASES)))
c2_after = $(patsubst %:$*,$(C2O)/%/posterior.h5,$(filter %:$*,$(C2_PAIRS)))

.PHONY: ch2
ch2: $(C2O)/page.html ## contact parameters identified with the particle filter (thesis: 2000 runs a case; C2_CASES=...)

# Files that hold the variables above. Ensembles, the runs of the identified set, and the page depend on them.
$(C2O)/settings: always
	@$(call remember,$(PROFILE) $(C2_SAMPLES) $(C2_STRAIN) $(C2_ERROR) $(C2_STRAIN_peak) $(C2_ERROR_peak) $(C2_STATIONS) $(C2_BASES))
$(C2O)/twins: always
	@$(call remember,$(C2_TWINS))
$(C2O)/cases: always
	@$(call remember,$(C2_CASES))

$(C2O)/packing_%.h5: $(BIN)/pack-generate
	@mkdir -p $(@D)
	@echo '  pack  $@'
	@pipelines/resume.sh $@ $(BIN)/pack-generate --grains $* --void-ratio 0.68 --pressure 1e3 --seed 1

$(C2O)/peak_%MPa.tsv: $(C2)/inputs.py data/laboratory/toyoura_peak_obliquity.tsv
	@mkdir -p $(@D)
	@$(STUDY_PY) $^ --peak $* $(call whole,$@)

.SECONDEXPANSION:
C2_RUN := $(filter-out %.toml,$(wildcard $(CALIBRATION)/*)) pipelines/study/jobs.py $(BIN)/run-dem $(BIN)/homogenize
C2_CALIBRATION := $(C2O)/settings pipelines/calibrate.sh $(C2_RUN) $(BIN)/pf-weight $(BIN)/plot
# Options and the folder are the argument.
c2_calibrate = BIN=$(BIN) pipelines/calibrate.sh --prior $(c2_prior) --packing $(c2_packing) --law $(c2_law) --scenario $(c2_scenario) \
  --test $(c2_observed) "$(c2_pressure) MPa" $(if $(c2_curve),$(C2_ALONG),$(C2_PEAK)) --stations 0 --bases $(C2_BASES) \
  --samples $(subst $() ,$(comma),$(strip $(C2_SAMPLES))) --rounds $(words $(C2_SAMPLES)) --effective-size 0 $(1)
$(C2O)/%/posterior.h5: $$(c2_prior) $$(c2_packing) $$(c2_scenario) $$(c2_observed) $(C2_CALIBRATION) | $$(c2_after)
	@$(call c2_calibrate,$(C2O)/$*)
# Tables of the rounds of a case. They are made together with the posterior.
C2_RUNS := $(C2_ROUNDS:%=round%_runs.tsv)
C2_OF_ROUNDS := $(C2_ROUNDS:%=round%_steps.tsv) $(sort round1_density.tsv $(C2_LAST)_density.tsv)
$(foreach t,$(C2_OF_ROUNDS) $(C2_RUNS),$(C2_CASES:%=$(C2O)/%/$(t))): $$(@D)/posterior.h5 ;
$(C2O)/%/rounds.tsv: $(C2)/inputs.py $$(foreach t,$(C2_RUNS),$(C2O)/$$*/$$t)
	@$(STUDY_PY) $^ --rounds $(call whole,$@)

# Runs with the identified means, and with the thesis's set if there is one, as far as the curve of the laboratory goes. Weights are not
# used here, so that any error will do.
$(C2O)/%/check.tsv: $(C2)/inputs.py $(C2O)/%/$(C2_LAST)_steps.tsv $$(c2_thesis) $(C2O)/twins
	@$(STUDY_PY) $(filter-out %/twins,$^) --twins $(C2_TWINS) $(call whole,$@)
$(C2O)/%/checked: $(C2O)/%/check.tsv $$(c2_packing) $$(c2_scenario) $(C2_RUN)
	@BIN=$(BIN) $(CALIBRATION)/ensemble.sh $< $(C2O)/$*/check $(c2_law) $(c2_packing) $(c2_scenario) $(c2_pressure) $$(tail -n 1 $(c2_curve) | cut -f 1)
	@touch $@
# Compares runs with the laboratory's curve, without their radial strain. The arguments are the sets and the folder of their runs.
c2_compare = $(BIN)/pf-weight assimilate $(1) $(c2_curve) --prior $(c2_prior) --runs '$(2)/runs/{id:06}/series.h5' --where stage=1 \
  --station strain_axial --observe stress_ratio --observe strain_volumetric --error 1 --quiet --tsv --table
# The argument is the folder of the case.
c2_check = $(call c2_compare,$(C2O)/$*/check.tsv,$(1)/check)
# Misfits of these runs up to the strain at which sets are compared (near), and over the whole laboratory curve (whole); and their curves.
$(C2O)/%/check_near.tsv $(C2O)/%/check_whole.tsv $(C2O)/%/check_curves.tsv: $(C2O)/%/checked $(BIN)/pf-weight
	@$(call c2_check,$(@D)) runs --until $(C2_STRAIN) $(call whole,$(@D)/check_near.tsv)
	@$(foreach of,whole:runs curves:curves,$(call c2_check,$(@D)) $(lastword $(subst :, ,$(of))) \
	  $(call whole,$(@D)/check_$(firstword $(subst :, ,$(of))).tsv) || exit;)

# Means of the thesis's sets under the thesis's observation error, by the runs of the first round. Fewer samples, or another prior, would not
# be the thesis's sets, so that only full-size runs with as many samples make this table.
$(C2O)/%/thesis_error.tsv: $(C2O)/%/posterior.h5 $(BIN)/pf-weight
	@$(BIN)/pf-weight assimilate $(@D)/round1_sets.h5 $(c2_curve) --prior $(c2_prior) --runs "$$(echo $(@D)/*kPa)/runs/{id:06}/series.h5" \
	  --where stage=1 --station strain_axial --observe strain_radial=strain_xx,strain_yy --observe stress_ratio --observe strain_volumetric \
	  --until $(C2_STRAIN) --variance $(C2_ERROR_thesis) --quiet --tsv --table steps $(call whole,$@)

C2_CHECKED := $(foreach c,$(C2_CASES),$(if $(wildcard data/laboratory/toyoura_drained_triaxial_$(word 3,$(subst _, ,$(c)))MPa.tsv),$(c)))
C2_TABLES := $(foreach t,$(C2_OF_ROUNDS) rounds.tsv,$(C2_CASES:%=$(C2O)/%/$t)) \
  $(foreach t,near whole curves,$(C2_CHECKED:%=$(C2O)/%/check_$(t).tsv)) \
  $(if $(filter thesis-$(firstword $(C2_SAMPLES_thesis)),$(PROFILE)-$(firstword $(C2_SAMPLES))),$(C2_CHECKED:%=$(C2O)/%/thesis_error.tsv))
C2_PY := $(wildcard $(C2)/*.py $(C2)/*.tsv $(C2)/words.toml)
$(C2O)/page.html: $(C2)/study.py $(C2_PY) $(STUDY) $(C2_TABLES) $(C2O)/cases $(wildcard $(C2)/kept/*.tsv $(C2)/kept/*/*.tsv)
	@$(STUDY_PY) $< $(C2O) --profile $(PROFILE) --cases $(C2_CASES) --samples $(C2_SAMPLES) --until $(C2_STRAIN) --error $(C2_ERROR)

# Kept are cases that are finished; each has a folder.
KEEPING += ch2
C2_ENDED := $(filter $(C2_CASES),$(patsubst $(C2O)/%/posterior.h5,%,$(wildcard $(C2_CASES:%=$(C2O)/%/posterior.h5))))
ENDED_ch2 := $(C2_ENDED:%=%/posterior)
BESIDE_ch2 = --cases $(notdir $(patsubst %/posterior.txt,%,$(wildcard $(C2)/kept/*/posterior.txt))) --samples $(C2_SAMPLES_thesis) \
  --until $(C2_STRAIN_thesis) --error $(C2_ERROR)
ch2-keep: $(foreach c,$(C2_ENDED),$(filter $(C2O)/$(c)/%,$(C2_TABLES))) ## keep the tables of finished thesis-size cases of ch2 (PROFILE=thesis)
ch2-compare: $(C2_PY) ## compare and draw the kept cases of ch2 anew

include $(C2)/rates.mk
include $(C2)/loading.mk
