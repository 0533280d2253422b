# Chapter 6: shape-forming and pull-out of a geosynthetic with finite elements of packings (thesis Figs. 6.2 to 6.6).
# SPDX-License-Identifier: GPL-3.0-or-later

STUDIES += ch6
C6 := pipelines/ch6
C6O := $(OUT)/ch6
# Squares along a side (two elements each), speeds in cm/s. quick: fewer elements and grains, and pulled faster.
C6_GRAINS_quick := 100
C6_GRAINS_thesis := 400
C6_MESH_quick := 4
C6_MESH_thesis := 8
C6_SPEED_quick := 3
C6_SPEED_thesis := 0.5
C6_MESHES_quick := 2 4
C6_MESHES_thesis := 6 8 10
C6_MESH_SPEED_quick := 3
C6_MESH_SPEED_thesis := 1
C6_SPEEDS_quick := 3 6
C6_SPEEDS_thesis := 0.25 0.5 1
C6_G := $(C6_GRAINS_$(PROFILE))
C6_MAIN := $(C6_MESH_$(PROFILE))_$(C6_SPEED_$(PROFILE))
# SQUARES_SPEED of every run.
C6_CASES := $(sort $(foreach m,$(C6_MESHES_$(PROFILE)),$(m)_$(C6_MESH_SPEED_$(PROFILE))) \
  $(foreach v,$(C6_SPEEDS_$(PROFILE)),$(C6_MESH_$(PROFILE))_$(v)) $(C6_MAIN))
C6_RUNS := $(foreach e,shape pullout,$(foreach c,$(C6_CASES),$(e)_$(c)))
# Runs side by side use the cores better than threads within one.
C6_THREADS ?= 1

.PHONY: ch6
ch6: $(C6O)/page.html ## two scales: a geosynthetic that forms a soil, and one pulled out of it

C6_ROUND = $(C6O)/rods_$(C6_G)
$(C6_ROUND).h5: $(BIN)/pack-generate data/gradings/aluminium-rods.tsv $(C6)/rods.toml
	@mkdir -p $(@D)
	@echo '  pack  $@'
	@$(BIN)/pack-generate --grading data/gradings/aluminium-rods.tsv --dimension 2 --grains $(C6_G) --aspect 1 --cloud-void-ratio 1.5 \
	  --material $(C6)/rods.toml --density 2700 --pressure 1e4 --max-rate 0.5 --seed 0 --threads 1 --quiet --force -o $@
$(C6_ROUND)_loose.h5: $(C6_ROUND).h5 $(C6)/prepare.toml $(BIN)/run-dem
	@$(BIN)/run-dem $< $(C6)/prepare.toml --threads 1 --quiet --force -o $@
$(C6_ROUND)_k0.h5: $(C6_ROUND)_loose.h5 $(C6)/k0.toml $(BIN)/run-dem
	@$(BIN)/run-dem $< $(C6)/k0.toml --threads 1 --quiet --force -o $@

# A quarter of a metre of pull; 100 outputs of shape-forming, 167 of pull-out, as in the thesis's runs.
C6_SCENARIO_shape := $(C6)/shape.toml
C6_SCENARIO_pullout := $(C6)/pullout.toml
C6_START_shape := $(C6_ROUND)_loose.h5
C6_START_pullout := $(C6_ROUND)_k0.h5
C6_OUTPUTS_shape := 100
C6_OUTPUTS_pullout := 167
C6_SET_shape := geosynthetic.start.y=-V geosynthetic.end.y=-V
C6_SET_pullout := geosynthetic.end.x=V
# run EXAMPLE SQUARES SPEED
define c6_run
$(C6O)/$(1)_$(2)_$(3).h5: $$(C6_START_$(1)) $$(C6_SCENARIO_$(1)) $(BIN)/fem-dem
	@echo '  run   $$@'
	@$(BIN)/fem-dem $$(C6_SCENARIO_$(1)) $$< --set mesh.columns=$(2) --set mesh.rows=$(2) --set record.points=[$$$$(($(2) - 2 + $(2) % 2))] \
	  $$(foreach e,$$(C6_SET_$(1)),--set '$$(subst V,$$(shell echo $(3) | awk '{print $$$$1 / 100}'),$$(e))') \
	  --set time.duration=$$$$(echo $(3) | awk '{ print 25 / $$$$1 }') \
	  --set time.output_interval=$$$$(echo $(3) | awk '{ print 25 / $$$$1 / $$(C6_OUTPUTS_$(1)) }') \
	  --resume --force --threads $(C6_THREADS) --quiet -o $$@
endef
$(foreach e,shape pullout,$(foreach c,$(C6_CASES),$(eval $(call c6_run,$(e),$(word 1,$(subst _, ,$(c))),$(word 2,$(subst _, ,$(c)))))))
# The main pull-out once more with the soil damping of the thesis.
C6_SCENARIO_swinging := $(C6_SCENARIO_pullout)
C6_START_swinging := $(C6_START_pullout)
C6_OUTPUTS_swinging := $(C6_OUTPUTS_pullout)
C6_SET_swinging := $(C6_SET_pullout) soil.damping=0.2
C6_SWINGING := swinging_$(C6_MAIN)
$(eval $(call c6_run,swinging,$(word 1,$(subst _, ,$(C6_MAIN))),$(word 2,$(subst _, ,$(C6_MAIN)))))

C6_SERIES := $(C6_RUNS:%=$(C6O)/%.tsv) $(C6O)/$(C6_SWINGING).tsv
C6_TABLES := $(foreach e,shape pullout,$(foreach t,points nodes bars,$(C6O)/$(e)_$(C6_MAIN)_$(t).tsv))
$(C6_SERIES): $(C6O)/%.tsv: $(C6O)/%.h5
	@$(BIN)/fem-dem --table series $< $(call whole,$@)
C6_MAIN_RUNS := $(foreach e,shape pullout,$(C6O)/$(e)_$(C6_MAIN))
$(C6_MAIN_RUNS:%=%_points.tsv): %_points.tsv: %.h5
	@$(BIN)/fem-dem --table points $< $(call whole,$@)
$(C6_MAIN_RUNS:%=%_nodes.tsv): %_nodes.tsv: %.h5
	@$(BIN)/fem-dem --table nodes $< $(call whole,$@)
$(C6_MAIN_RUNS:%=%_bars.tsv): %_bars.tsv: %.h5
	@$(BIN)/fem-dem --table bars $< $(call whole,$@)

$(C6O)/measured.tsv: $(C6)/measure.awk $(C6_SERIES) $(C6_TABLES) $(OUT)/profile
	@awk -v folder=$(C6O) -v main=$(C6_MAIN) -v meshes='$(foreach m,$(C6_MESHES_$(PROFILE)),$(m)_$(C6_MESH_SPEED_$(PROFILE)))' \
	  -v speeds='$(foreach v,$(C6_SPEEDS_$(PROFILE)),$(C6_MESH_$(PROFILE))_$(v))' -f $< $(call whole,$@)
$(C6O)/comparison.tsv: pipelines/compare.awk $(C6)/statements.tsv $(C6O)/measured.tsv
	@awk -f $^ $(call whole,$@)

C6_KEPT := $(C6)/kept
C6_KEEP := time pull_end force_y_bottom length_bottom interface_shear interface_normal
.PHONY: ch6-keep
ch6-keep: $(BIN)/fem-dem $(BIN)/to-vtk ## put the series of finished thesis-size runs of ch6 among the kept ones (PROFILE=thesis)
	@$(call keep_series,$(C6_KEPT),$(wildcard $(C6_RUNS:%=$(C6O)/%.h5)),$(BIN)/fem-dem --table series,$(C6_KEEP))
kept_cases = $(patsubst $(C6_KEPT)/$(1)_%.tsv,%,$(wildcard $(C6_KEPT)/$(1)_*.tsv))

# The last state of the main runs and the local responses, for the figures.
C6_POINTS := $(foreach e,shape pullout,$(C6O)/$(e)_local.tsv)
$(C6_POINTS): $(C6O)/%_local.tsv: $(C6)/local.awk $(C6O)/%_$(C6_MAIN)_points.tsv
	@awk -v example=$* -f $^ $(call whole,$@)
C6_SHOWN := mean_stress deviatoric_stress strain_shear rotation anisotropy strain_volumetric
C6_FIELDS := $(foreach e,shape pullout,$(C6O)/$(e)_fields.tsv)
$(C6_FIELDS): $(C6O)/%_fields.tsv: $(C6)/triangles.awk $(C6O)/%_$(C6_MAIN)_nodes.tsv $(C6O)/%_$(C6_MAIN)_points.tsv
	@awk -v squares=$(word 1,$(subst _, ,$(C6_MAIN))) -v names='$(C6_SHOWN)' -f $^ $(call whole,$@)
$(C6O)/figures: $(C6)/figures.gp $(C6_SERIES) $(C6_TABLES) $(C6_POINTS) $(C6_FIELDS) $(wildcard $(C6_KEPT)/*.tsv)
	@for format in svg png; do gnuplot -e "out='$(C6O)'; format='$$format'; main='$(C6_MAIN)'; cases='$(C6_CASES)'; \
	  kept='$(C6_KEPT)'; kept_shape='$(call kept_cases,shape)'; kept_pullout='$(call kept_cases,pullout)'" $<; done
	@touch $@

$(C6O)/page.html: $(C6)/page.sh pipelines/figure.sh pipelines/table.awk $(C6O)/comparison.tsv $(C6O)/figures
	@OUT=$(C6O) GRAINS=$(C6_G) MAIN=$(C6_MAIN) $(C6)/page.sh $(call whole,$@)
	@awk -F '\t' 'NR > 1 { n[$$7]++ } END { printf "ch6: %d statements met, %d not met (make report)\n", n["met"], n["not met"] }' \
	  $(C6O)/comparison.tsv

# Kept: they are dear.
.PRECIOUS: $(C6O)/%.h5
