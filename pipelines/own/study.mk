# A soil and a bag of one's own, from a grading curve, triaxial tests and a data sheet to a design: make own SOIL=FOLDER (own.toml in
# it, README.md here). It is not among STUDIES, since it needs a soil and takes half an hour. The bag is the one of ch3, with the same plates and rates.
# SPDX-License-Identifier: GPL-3.0-or-later
OWN := pipelines/own
SOIL ?= data/own/example
# The folder's name is part of the names of targets and of the words of recipes.
own_plain = $(if $(filter-out data/own/example,$(SOIL)),$(shell printf %s '$(subst ','\'',$(SOIL))' | LC_ALL=C tr -d 'A-Za-z0-9_./+,@\200-\377-'))
ifneq ($(words $(SOIL)) $(own_plain),1 )
$(error SOIL=$(SOIL): make cannot use a folder with blanks, quotes or signs such as $$ in its path: write it relative, or rename the folder to letters, digits, _ and -)
endif
OWN_NAME := $(notdir $(patsubst %/,%,$(SOIL)))
ifeq ($(filter-out . ..,$(OWN_NAME)),)
$(error SOIL=$(SOIL): the results take the name of the folder; write its name, without . or .. or // at the end)
endif
# Full-size results have a folder of their own, so that no quick run, nor an own-check, takes their place.
OWNO := $(OUT)/own/$(OWN_NAME)$(if $(filter thesis,$(PROFILE)),/thesis)
# Grains of the representative volume, its mean radius (the thesis's sand's, m), and sets, rounds and effective size of the calibration.
OWN_GRAINS_quick := 500
OWN_GRAINS_thesis := 1000
OWN_RADIUS := 2.954e-3
OWN_SAMPLES_quick := 40
OWN_SAMPLES_thesis := 200
OWN_SAMPLES := $(OWN_SAMPLES_$(PROFILE))
OWN_GRAINS := $(OWN_GRAINS_$(PROFILE))
OWN_ROUNDS := 5
OWN_SIZE := 12
# Axial strain (%) up to which tests are compared, standard deviations of their error, and the rate (1/s).
OWN_UNTIL := 8
# Compared rows of a test. They are few, because the errors of a model are alike all along a curve: more rows are not independent.
OWN_STATIONS := 5
OWN_ERROR := stress_ratio=0.2,strain_volumetric=0.3
OWN_RATE := try
OWN_PRIOR := $(OWNO)/prior.toml
# Options of the bag and its load, the size of its grains over those of the calibration, and how far it is compressed.
# The number of copies of the representative volume that cover a bag depends on the soil. 14 x 14 x 2 are more than enough; copies outside are
# cut away. OWN_DENSER: Delaunay tetrahedra leave out a part along the walls, which lowers the void ratio of ch3's bags by this much.
OWN_DENSER_quick := 0.08
OWN_DENSER_thesis := 0.005
OWN_BAG ?= $(C3_BAG_$(PROFILE)) --set container.copies=[14,14,2] \
  --set growth.delaunay_void_ratio=$$(awk 'BEGIN { print $(OWN_VOID_RATIO) - $(OWN_DENSER_$(PROFILE)) }')
OWN_LOAD ?= $(C3_LOAD_$(PROFILE))
OWN_SCALE_quick := 2
OWN_SCALE_thesis := 1
OWN_SCALE := $(OWN_SCALE_$(PROFILE))
OWN_STRAIN := 0.12
OWN_TWINS := 2
# Geotextiles of the bags of each further packing. Alpha and beta of one packing need three at least.
OWN_VARIED := 1 2 3 4
OWN_DRAWS := 500
OWN_PY := $(STUDY_PY) $(OWN)
OWN_CAL := $(OWNO)/calibration

.PHONY: own own-check
own: ## your soil, your bag: make own SOIL=FOLDER with own.toml (example: data/own/example)
	+@$(AGAIN) $(OWNO)/page.html
own-check: $(OWNO)/inputs.mk $(OWNO)/packing_1.h5 $(BIN)/run-dem ## how long make own SOIL=FOLDER will take
	@BIN=$(BIN) $(OWN_PY)/forecast.py $(SOIL) $(OWNO) --samples $(OWN_SAMPLES) --rounds $(OWN_ROUNDS) --until $(OWN_UNTIL) \
	  --profile $(PROFILE) --varied $(words $(OWN_VARIED)) --cores $(shell nproc)

# For these targets alone, own.toml is read before anything is made. An error in it ends make with a message.
ifneq ($(filter own-check $(OWNO)/%,$(MAKECMDGOALS)),)
OWN_WRONG := $(shell $(OWN_PY)/inputs.py $(SOIL) $(OWNO) --until $(OWN_UNTIL) 2>&1)
$(if $(OWN_WRONG),$(error $(OWN_WRONG)))
$(shell cat $(OWNO)/inputs.said >&2)
include $(OWNO)/inputs.mk
ifneq ($(filter-out $(OWN_BAGS),$(OWN_VARIED) $(if $(strip $(OWN_VARIED)),,none)),)
$(error OWN_VARIED=$(OWN_VARIED): give one or more of the numbers $(OWN_BAGS), as OWN_VARIED="1 3")
endif
ifneq ($(shell awk 'BEGIN { print ("$(OWN_STRAIN)" + 0 > 0.01 && "$(OWN_STRAIN)" + 0 < 0.5) }'),1)
$(error OWN_STRAIN=$(OWN_STRAIN): give a share of the height between 0.01 and 0.5, as 0.12 for 12 %)
endif
endif

# Settings on which packings, calibration and bags depend; (0) comes before. The surcharge is not among them, so a change of it repeats none of them.
$(OWNO)/settings: always $(OWNO)/judged
	@$(call remember,$(PROFILE) $(OWN_VOID_RATIO) $(OWN_GRAINS) $(OWN_RADIUS))
$(OWN_CAL)/settings: always $(OWNO)/inputs.mk
	@$(call remember,$(subst ',,$(OWN_TESTS)) $(OWN_UNTIL) $(OWN_STATIONS) $(OWN_ERROR) $(OWN_SAMPLES) $(OWN_ROUNDS) $(OWN_SIZE) $(OWN_RATE))
$(OWNO)/loading: always $(OWNO)/inputs.mk
	@$(call remember,$(subst $$,,$(subst ',,$(OWN_BAG) $(OWN_LOAD))) $(OWN_SCALE) $(OWN_STRAIN))

# (0) The tools judge what (a) and (e) give them, before anything is made: the prior, and on Toyoura sand the geotextile, the bag and the factors.
# Status 1 is an answer, that no geotextile is enough, as it may be for the reader's own soil too.
own_judge = > /dev/null 2> $@.said || { status=$$?; [ $$status = 1 ] || \
  { sed -E '/: doubt: /d; s|^gws-solve [a-z]+: |own: $(SOIL)/own.toml: |; s|^pf-weight draw: |own: |; s/--(factor|rf)-/factors./g; \
    s|$(OWN_PRIOR)|$(SOIL)/prior.toml|; s|$(OWNO)/geotextile.toml(:[0-9]+)?|geotextile|' $@.said >&2; exit $$status; }; }
own_toyoura = $(own_design) --soil toyoura-gws --surcharge $(OWN_SURCHARGE)
$(OWNO)/judged: $(OWNO)/inputs.mk $(OWNO)/geotextile.toml $(OWN_PRIOR) $(BIN)/gws-solve $(BIN)/pf-weight
	@trap 'rm -f $@.said' EXIT; $(BIN)/pf-weight draw $(OWN_PRIOR) --samples 1 --tsv --quiet $(own_judge); \
	  $(own_respond) --soil toyoura-gws $(own_judge); $(own_toyoura) $(own_judge); $(own_toyoura) $(own_chart) $(own_judge)
	@touch $@

# (b) % is the seed of a representative volume; each bag of (c) is cut from one of them.
$(OWNO)/packing_%.h5: $(OWNO)/settings $(OWNO)/grading.tsv $(BIN)/pack-generate
	@echo '  pack  $@'
	@$(BIN)/pack-generate --grading $(OWNO)/grading.tsv --grains $(OWN_GRAINS) --void-ratio $(OWN_VOID_RATIO) --pressure 1e3 --seed $* \
	  --mean-radius $(OWN_RADIUS) --threads 1 --quiet --force -o $@ 2> $(@:.h5=.said); status=$$?; cat $(@:.h5=.said) >&2; exit $$status

# (a) A status of 1 means that the effective size is not reached; the page says so.
$(OWN_CAL)/posterior.h5: $(OWNO)/packing_1.h5 $(OWN_PRIOR) $(OWN_CAL)/settings $(OWN_TABLES) pipelines/calibrate.sh $(C2_SCENARIO_hm) $(C2_RUN) \
  $(BIN)/pf-weight $(BIN)/plot
	@BIN=$(BIN) pipelines/calibrate.sh --prior $(OWN_PRIOR) --packing $< $(OWN_TESTS) --until $(OWN_UNTIL) --stations $(OWN_STATIONS) --error $(OWN_ERROR) \
	  --samples $(OWN_SAMPLES) --rounds $(OWN_ROUNDS) --effective-size $(OWN_SIZE) --rate $(OWN_RATE) $(OWN_CAL) || [ $$? = 1 -a -e $@ ]
$(OWNO)/draws.tsv: $(OWN_CAL)/posterior.h5 $(OWN)/sets.py
	@$(OWN_PY)/sets.py draw $(OWN_CAL) $(words $(OWN_OTHERS)) $(call whole,$@)
$(OWNO)/heaviest.tsv: $(OWN_CAL)/posterior.h5 $(OWN)/sets.py
	@$(OWN_PY)/sets.py heaviest $(OWN_CAL) $(OWN_TWINS) $(call whole,$@)
# Twins of two volumes with the heaviest set, in the first test, show the scatter by chance. % is the seed.
$(OWNO)/checked_%: $(OWNO)/heaviest.tsv $(OWNO)/packing_%.h5 $(C2_SCENARIO_hm)
	@BIN=$(BIN) pipelines/calibration/ensemble.sh $< $(OWNO)/check_$* hm $(OWNO)/packing_$*.h5 $(C2_SCENARIO_hm) $(OWN_PRESSURE) $(OWN_UNTIL)
	@touch $@
$(OWNO)/check_%.tsv: $(OWNO)/checked_% $(BIN)/pf-weight
	@$(BIN)/pf-weight assimilate $(OWNO)/heaviest.tsv $(OWN_CAL)/$(OWN_FIRST).tsv --prior $(OWN_PRIOR) --runs '$(OWNO)/check_$*/runs/{id:06}/series.h5' \
	  --where stage=1 --station strain_axial --observe stress_ratio --error 1 --quiet --tsv --table curves $(call whole,$@)

# (c) Bag 1, cut from packing 1, has the heaviest set. It is compressed with four geotextiles (uc_1 to uc_4), and shows their effect.
# Each further bag has a packing and a set of the posterior of its own. other_1_3 is bag 2 with geotextile 3. These bags show the scatter by soil
# and packing: with the asked stiffness, that of loads; with some of the other geotextiles, that of the constants.
# $(call own_set,BAG): table and row of the set of a bag.
own_set = $(if $(filter 1,$(1)),$(OWNO)/heaviest.tsv 0,$(OWNO)/draws.tsv $$(($(1) - 2)))
own_contact = contact=$$($(OWN_PY)/sets.py options $(call own_set,$(1)) $(OWN_SCALE))
$(OWNO)/bag_%.h5: $(OWNO)/packing_%.h5 $(OWNO)/heaviest.tsv $(OWNO)/draws.tsv $(OWNO)/loading $(C3)/bag.toml $(BIN)/filter-expand
	@echo '  fill  $@'
	@$(call own_contact,$*) && $(BIN)/filter-expand $< $(C3)/bag.toml $(OWN_BAG) $$contact --threads 1 --quiet --resume \
	  --force --history $(@:.h5=.tsv) -o $@
# $(call own_compress,BAG,GEOTEXTILE) compresses the first prerequisite, a bag.
own_compress = $(call own_contact,$(1)) && $(BIN)/run-dem $< $(C3)/uc.toml $(OWN_LOAD) $$contact \
  --set stage.1.strain=$(OWN_STRAIN) --set record.strains=[$(OWN_STRAIN)] --set stage.1.plate_friction_angle=0 \
  --set geotextile.0.curve=$(OWNO)/geotextile_$(2).toml --threads 1 --quiet --resume --force -o $@
$(OWNO)/uc_%.h5: $(OWNO)/bag_1.h5 $(OWNO)/geotextile_%.toml $(C3)/uc.toml $(BIN)/run-dem
	@echo '  run   $@'
	@$(call own_compress,1,$*)
own_names = $(subst _, ,$*)
own_bag = $(words 1 $(wordlist 1,$(firstword $(own_names)),$(OWN_OTHERS)))
.SECONDEXPANSION:
$(OWNO)/other_%.h5: $(OWNO)/bag_$$(own_bag).h5 $(OWNO)/geotextile_$$(lastword $$(own_names)).toml $(C3)/uc.toml $(BIN)/run-dem
	@echo '  run   $@'
	@$(call own_compress,$(own_bag),$(lastword $(own_names)))
own_loading = $(BIN)/homogenize $< --table loading --tsv $(call whole,$@)
$(OWNO)/uc_%.tsv: $(OWNO)/uc_%.h5 $(BIN)/homogenize
	@$(own_loading)
$(OWNO)/other_%.tsv: $(OWNO)/other_%.h5 $(BIN)/homogenize
	@$(own_loading)

$(OWNO)/varied: always $(OWNO)/inputs.mk
	@$(call remember,$(OWN_VARIED))

# (d) From the bags of one soil. $(call own_identify,RUN_%,GEOTEXTILES): RUN_% is the name of the runs.
OWN_RUNS = $(OWN_BAGS:%=$(OWNO)/uc_%.h5)
own_identify = $(BIN)/gws-solve identify $(2:%=$(OWNO)/$(1).h5) $(2:%=--geotextile $(OWNO)/geotextile_%.toml) $(OWN_FAILURE) --difference backward
OWN_NAMED := sed 's/^name = .*/name = "own"/'
# Fits all constants at once (path). If the paths do not determine all of them, fits line by line (thesis). If that has no solution either, keeps
# the first fit, with Toyoura sand's values for the other constants. Fits without a solution have status 1 or 65. Any other status is an error,
# such as a killed tool or a full disk. Only the doubts of the chosen fit are printed.
own_first = $(call own_identify,uc_%,$(OWN_BAGS))
own_try = $(own_first) --fit $(1) --toml --quiet > $@.$(1) 2> $@.said; $(1)=$$?; case $$$(1) in 0 | 1 | 65) ;; *) cat $@.said >&2; exit $$$(1) ;; esac
own_fit = $(call own_try,path); fit=path; \
  if [ $$path != 0 ] || grep -Eq '^\# Not identified.*given: (all constants|near_failure_line|compression_line|dilatancy_line)' $@.path; then \
    $(call own_try,thesis); [ $$thesis != 0 -a $$path = 0 ] || fit=thesis; fi
$(OWNO)/soil.toml: $$(OWN_RUNS) $(OWNO)/inputs.mk $(OWNO)/failure.tsv $(BIN)/gws-solve
	@trap 'rm -f $@.path $@.thesis $@.said' EXIT; $(own_fit); \
	  $(own_first) --fit $$fit > $(OWNO)/identified.txt 2> $(OWNO)/identified.said; status=$$?; cat $(OWNO)/identified.said >&2; \
	  [ $$status = 0 ] || exit $$status; $(OWN_NAMED) $@.$$fit $(call whole,$@)
# The other packings, by the same fit. Where it has no solution, the file is empty, and constants.tsv has fewer packings.
$(OWNO)/soil_%.toml: $$(foreach k,$$(OWN_VARIED),$(OWNO)/other_$$*_$$(k).h5) $(OWNO)/varied $(OWNO)/soil.toml $(BIN)/gws-solve
	@trap 'rm -f $@.given $@.said' EXIT; grep -q '^# All constants together' $(OWNO)/soil.toml && fit=path || fit=thesis; \
	  $(call own_identify,other_$*_%,$(OWN_VARIED)) --fit $$fit --toml --quiet > $@.given 2> $@.said; status=$$?; \
	  case $$status in 0) $(OWN_NAMED) $@.given $(call whole,$@) ;; \
	  1 | 65) sed 's/^[a-z-]*/own: packing $(own_bag) gives no constants/' $@.said >&2; : > $@ ;; *) cat $@.said >&2; exit $$status ;; esac
$(OWNO)/constants.tsv: $(OWNO)/soil.toml $$(foreach k,$$(OWN_OTHERS),$(OWNO)/soil_$$(k).toml) $(OWN)/constants.py $(OWN)/transfer.py
	@$(OWN_PY)/constants.py $(OWNO) $(call whole,$@)

# (e) The model's response for the bag of own.toml, with the share of strength from inputs.py, and for a bag like the simulated ones. The
# simulated over the modelled load of such a bag is a factor on the model's answers (transfer.py).
own_case = --geotextile $(OWNO)/geotextile.toml $(OWN_SHAPE) $(OWN_REDUCED)
own_respond = $(BIN)/gws-solve respond $(own_case) --tsv --points 40
own_said = 2> $(@:.tsv=.said) $(call whole,$@) || { status=$$?; cat $(@:.tsv=.said) >&2; exit $$status; }
$(OWNO)/bands.tsv: $(OWNO)/soil.toml $(OWNO)/geotextile.toml $(BIN)/gws-solve
	@$(own_respond) --soil $< --samples $(OWN_DRAWS) $(own_said)
$(OWNO)/of_grains.tsv: $(OWNO)/soil.toml $(BIN)/gws-solve
	@$(BIN)/gws-solve respond --soil $< --geotextile $(OWNO)/geotextile_$(OWN_SAME).toml --points 400 --tsv $(own_said)
OWN_ASKED = $(OWN_RUNS:.h5=.tsv) $(OWN_OTHERS:%=$(OWNO)/other_%_$(OWN_SAME).tsv)
# The surcharges of the design: in the middle, and at the low end of the band.
$(OWNO)/loads: $$(OWN_ASKED) $(OWNO)/bands.tsv $(OWNO)/of_grains.tsv $(OWN)/transfer.py
	@$(OWN_PY)/transfer.py $(OWNO) $(OWN_SURCHARGE) $(OWN_SETTLEMENT) $(call whole,$@)
own_design = $(BIN)/gws-solve design $(own_case) $(OWN_PARTIAL) --settlement $(OWN_SETTLEMENT) --tsv
own_chart = --chart --from $$(awk 'BEGIN { print $(OWN_STIFFNESS) / 5 }') --to $$(awk 'BEGIN { print 5 * $(OWN_STIFFNESS) }')
own_designs = read -r middle high < $< && $(own_design) --soil $(OWNO)/soil.toml --surcharge
# Where no geotextile is enough, the file is empty, and the page says so. The status is then 1, or 65 for a soil that has no states under a stiff
# geotextile. A message that names an option of own.toml is an error in it.
own_designed = 2> $(@:.tsv=.said) $(call whole,$@) || \
  { status=$$?; cat $(@:.tsv=.said) >&2; ! grep -Eq -e ' --(factor|rf)-' $(@:.tsv=.said) && [ $$status = 65 -o $$status = 1 ] && : > $@ || exit $$status; }
$(OWNO)/design.tsv: $(OWNO)/loads $(BIN)/gws-solve
	@$(own_designs) $$middle $(own_designed)
$(OWNO)/design_high.tsv: $(OWNO)/loads $(BIN)/gws-solve
	@$(own_designs) $$high $(own_designed)
$(OWNO)/chart.tsv: $(OWNO)/loads $(BIN)/gws-solve
	@$(own_designs) $$middle $(own_chart) $(call whole,$@)

# (f)
OWN_LEFT = $(OWN_ASKED) $(OWNO)/constants.tsv $(OWNO)/design.tsv $(OWNO)/design_high.tsv $(OWNO)/chart.tsv $(OWNO)/check_1.tsv $(OWNO)/check_2.tsv
$(OWNO)/provenance.txt: $(OWNO)/uc_1.h5 $(BIN)/to-vtk
	@$(BIN)/to-vtk --history $< $(call whole,$@)
$(OWNO)/page.html: $$(OWN_LEFT) $(OWNO)/provenance.txt $(OWNO)/own.toml $(OWNO)/inputs.mk $(OWN)/study.py $(OWN)/transfer.py $(OWN)/words.toml $(STUDY)
	@$(STUDY_PY) $(OWN)/study.py $(OWNO) --profile $(PROFILE) --soil $(SOIL)
