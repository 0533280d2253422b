# Chapter 6: shape-forming and pull-out of a geosynthetic with finite elements of packings (thesis Figs. 6.2 to 6.6).
# SPDX-License-Identifier: GPL-3.0-or-later

STUDIES += ch6
C6 := pipelines/ch6
C6O := $(OUT)/ch6
# Runs are EXAMPLE_SQUARES_SPEED: squares along a side (two elements each), speed in cm/s. Each profile has a main run and a
# list of all runs, as in runs.py. quick: fewer elements and grains, and a faster pull.
C6_GRAINS_quick := 100
C6_GRAINS_thesis := 400
C6_MAIN_quick := 4_3
C6_MAIN_thesis := 8_0.5
C6_CASES_quick := 2_3 4_3 4_6
C6_CASES_thesis := 6_1 8_0.25 8_0.5 8_1 10_1
C6_MAIN := $(C6_MAIN_$(PROFILE))
C6_CASES := $(C6_CASES_$(PROFILE))
C6_RUNS := $(C6_CASES:%=shape_%) $(C6_CASES:%=pullout_%) swinging_$(C6_MAIN)
C6_MAINS := shape_$(C6_MAIN) pullout_$(C6_MAIN)
# Runs side by side use the cores better than threads within one.
C6_THREADS ?= 1

.PHONY: ch6
ch6: $(C6O)/page.html ## two scales: a geosynthetic that forms a soil, and one pulled out of it

C6_RODS := $(C6O)/rods_$(C6_GRAINS_$(PROFILE))
$(C6_RODS).h5: $(BIN)/pack-generate data/gradings/aluminium-rods.tsv $(C6)/rods.toml
	@mkdir -p $(@D)
	@echo '  pack  $@'
	@$(BIN)/pack-generate --grading data/gradings/aluminium-rods.tsv --dimension 2 --grains $(C6_GRAINS_$(PROFILE)) --aspect 1 --cloud-void-ratio 1.5 \
	  --material $(C6)/rods.toml --density 2700 --pressure 1e4 --max-rate 0.5 --seed 0 --threads 1 --quiet --force -o $@
$(C6_RODS)_loose.h5: $(C6_RODS).h5 $(C6)/prepare.toml $(BIN)/run-dem
	@$(BIN)/run-dem $< $(C6)/prepare.toml --threads 1 --quiet --force -o $@
$(C6_RODS)_k0.h5: $(C6_RODS)_loose.h5 $(C6)/k0.toml $(BIN)/run-dem
	@$(BIN)/run-dem $< $(C6)/k0.toml --threads 1 --quiet --force -o $@

# A quarter of a metre of pull; 100 outputs of shape-forming, 167 of pull-out, as in the thesis's runs. % is SQUARES_SPEED.
c6_number = $(shell awk 'BEGIN { print $(1) }')
c6_squares = $(word 1,$(subst _, ,$*))
c6_speed = $(word 2,$(subst _, ,$*))
c6_velocity = $(call c6_number,$(c6_speed) / 100)
c6_mesh = --set mesh.columns=$(c6_squares) --set mesh.rows=$(c6_squares) --set record.points=[$$(($(c6_squares) - 2 + $(c6_squares) % 2))]
c6_time = --set time.duration=$(call c6_number,25 / $(c6_speed)) --set time.output_interval=$(call c6_number,25 / $(c6_speed) / $(1))
c6_pull = $(BIN)/fem-dem $(C6)/pullout.toml $< $(c6_mesh) --set geosynthetic.end.x=$(c6_velocity) $(1) $(call c6_time,167)
C6_WAYS := --resume --force --threads $(C6_THREADS) --quiet
c6_shape = $(BIN)/fem-dem $(C6)/shape.toml $< $(c6_mesh) --set geosynthetic.start.y=-$(c6_velocity) --set geosynthetic.end.y=-$(c6_velocity) \
  $(call c6_time,100)
$(C6O)/shape_%.h5: $(C6_RODS)_loose.h5 $(C6)/shape.toml $(BIN)/fem-dem
	@echo '  run   $@'
	@$(c6_shape) $(C6_WAYS) -o $@
$(C6O)/pullout_%.h5: $(C6_RODS)_k0.h5 $(C6)/pullout.toml $(BIN)/fem-dem
	@echo '  run   $@'
	@$(call c6_pull) $(C6_WAYS) -o $@
# Pull-out once more with the soil damping of the thesis.
$(C6O)/swinging_%.h5: $(C6_RODS)_k0.h5 $(C6)/pullout.toml $(BIN)/fem-dem
	@echo '  run   $@'
	@$(call c6_pull,--set soil.damping=0.2) $(C6_WAYS) -o $@

# Forecasts of each run, as fem-dem --check prints them. Make would take a pattern rule with two targets to have made both.
$(C6O)/shape_%.check: $(C6_RODS)_loose.h5 $(C6)/shape.toml $(BIN)/fem-dem
	@$(c6_shape) --check --threads 1 2>&1 $(call whole,$@)
$(C6O)/pullout_%.check: $(C6_RODS)_k0.h5 $(C6)/pullout.toml $(BIN)/fem-dem
	@$(call c6_pull) --check --threads 1 2>&1 $(call whole,$@)
$(C6O)/swinging_%.check: $(C6_RODS)_k0.h5 $(C6)/pullout.toml $(BIN)/fem-dem
	@$(call c6_pull,--set soil.damping=0.2) --check --threads 1 2>&1 $(call whole,$@)

# Tables: the loading of each run; for main runs also the history of point A or B, and the last state.
C6_KINDS := local elements points nodes bars
C6_TABLES := $(C6_RUNS:%=$(C6O)/loading_%.tsv) $(foreach kind,$(C6_KINDS),$(C6_MAINS:%=$(C6O)/$(kind)_%.tsv))
C6_LOCAL := time,strain_shear,strain_volumetric,mean_stress,deviatoric_stress,anisotropy
C6_POINTS := element,x,mean_stress,deviatoric_stress,strain_shear,strain_volumetric,rotation,anisotropy
$(C6O)/loading_%.tsv: $(C6O)/%.h5
	@$(BIN)/fem-dem --table loading --columns time,pull_end,traction_y_bottom,interface_friction,external_work,energy_error $< $(call whole,$@)
$(C6O)/local_shape_%.tsv: $(C6O)/shape_%.h5
	@$(BIN)/fem-dem --table points --near 0.6,1.2 --columns $(C6_LOCAL) $< $(call whole,$@)
$(C6O)/local_pullout_%.tsv: $(C6O)/pullout_%.h5
	@$(BIN)/fem-dem --table points --near 0.6,0 --columns $(C6_LOCAL) $< $(call whole,$@)
$(C6O)/elements_%.tsv: $(C6O)/%.h5
	@$(BIN)/fem-dem --table elements $< $(call whole,$@)
$(C6O)/points_%.tsv: $(C6O)/%.h5
	@$(BIN)/fem-dem --table points --state last --columns $(C6_POINTS) $< $(call whole,$@)
$(C6O)/nodes_%.tsv: $(C6O)/%.h5
	@$(BIN)/fem-dem --table nodes --state last --columns node,x,y,displacement_x,displacement_y $< $(call whole,$@)
$(C6O)/bars_%.tsv: $(C6O)/%.h5
	@$(BIN)/fem-dem --table bars --state last --columns x_0,y_0,tension_ratio $< $(call whole,$@)
$(C6_TABLES): $(BIN)/fem-dem

C6_PY := $(wildcard $(C6)/*.py $(C6)/*.tsv $(C6)/*.toml)
$(C6O)/page.html: $(C6)/study.py $(C6_PY) $(STUDY) $(C6_TABLES) $(wildcard $(C6)/kept/*.tsv) $(OUT)/profile
	@$(STUDY_PY) $< $(C6O) --profile $(PROFILE)

KEEPING += ch6
ENDED_ch6 := $(patsubst $(C6O)/%.h5,%,$(wildcard $(C6_RUNS:%=$(C6O)/%.h5)))
ch6-keep: $(foreach run,$(ENDED_ch6),$(filter %_$(run).tsv,$(C6_TABLES))) ## keep the tables of finished thesis-size runs of ch6 (PROFILE=thesis)
ch6-compare: $(C6_PY) ## compare the kept runs of ch6 anew

# Kept, since every table is made from them.
.PRECIOUS: $(C6O)/%.h5
