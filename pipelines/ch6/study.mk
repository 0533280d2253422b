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
# $(call c6_cases,MESHES|SPEEDS,PROFILE): SQUARES_SPEED of the runs that differ in one of them alone.
c6_cases = $(if $(filter MESHES,$(1)),$(C6_MESHES_$(2):%=%_$(C6_MESH_SPEED_$(2))),$(C6_SPEEDS_$(2):%=$(C6_MESH_$(2))_%))
# Of every run.
C6_CASES := $(sort $(call c6_cases,MESHES,$(PROFILE)) $(call c6_cases,SPEEDS,$(PROFILE)) $(C6_MAIN))
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
$(C6_SERIES): $(C6O)/%.tsv: $(C6O)/%.h5 $(BIN)/fem-dem
	@$(BIN)/fem-dem --table series $< $(call whole,$@)

# Of the main runs: the history of point A or B, and the last state.
C6_MAINS := $(foreach e,shape pullout,$(e)_$(C6_MAIN))
C6_LAST_points := element x y mean_stress deviatoric_stress strain_shear strain_volumetric rotation anisotropy
C6_LAST_nodes := node x y displacement_x displacement_y
C6_LAST_bars := x_0 y_0 tension_ratio broken
C6_OF_MAINS := $(foreach run,$(C6_MAINS),$(foreach t,local last_points last_nodes last_bars fields,$(run)_$(t)))
C6_SHOWN := mean_stress deviatoric_stress strain_shear rotation anisotropy strain_volumetric
$(C6_MAINS:%=$(C6O)/%_local.tsv): $(C6O)/%_local.tsv: $(C6)/local.awk $(C6O)/%.h5 $(BIN)/fem-dem
	@$(BIN)/fem-dem --table points $(C6O)/$*.h5 | awk -v example=$(firstword $(subst _, ,$*)) -f $< $(call whole,$@)
# last_of WHAT
define last_of
$(C6_MAINS:%=$(C6O)/%_last_$(1).tsv): %_last_$(1).tsv: %.h5 pipelines/last.awk pipelines/keep.awk $(BIN)/fem-dem
	@$(BIN)/fem-dem --table $(1) $$< | awk -f pipelines/last.awk | awk -v names='$$(C6_LAST_$(1))' -f pipelines/keep.awk $$(call whole,$$@)
endef
$(foreach t,points nodes bars,$(eval $(call last_of,$(t))))
$(C6_MAINS:%=$(C6O)/%_fields.tsv): %_fields.tsv: $(C6)/triangles.awk %_last_nodes.tsv %_last_points.tsv
	@awk -v squares=$(word 1,$(subst _, ,$(C6_MAIN))) -v names='$(C6_SHOWN)' -f $^ $(call whole,$@)

# $(call measure_scales,FOLDER,MAIN,MESHES,SPEEDS)
measure_scales = awk -v folder=$(1) -v main=$(2) -v meshes='$(3)' -v speeds='$(4)'
$(C6O)/measured.tsv: $(C6)/measure.awk $(C6_SERIES) $(C6_OF_MAINS:%=$(C6O)/%.tsv) $(OUT)/profile
	@$(call measure_scales,$(C6O),$(C6_MAIN),$(call c6_cases,MESHES,$(PROFILE)),$(call c6_cases,SPEEDS,$(PROFILE))) -f $< $(call whole,$@)
$(C6O)/comparison.tsv: pipelines/compare.awk $(C6)/statements.tsv $(C6O)/measured.tsv
	@awk -f $^ $(call whole,$@)

include $(C6)/kept.mk

# $(call draw_scales,FOLDER,FORMAT,MAIN,SHAPES,PULLOUTS)
draw_scales = gnuplot -e "out='$(1)'; format='$(2)'; main='$(3)'; shapes='$(4)'; pullouts='$(5)'" $(C6)/figures.gp
$(C6O)/figures: $(C6)/figures.gp $(C6_SERIES) $(C6_OF_MAINS:%=$(C6O)/%.tsv)
	@for format in svg png; do $(call draw_scales,$(C6O),$$format,$(C6_MAIN),$(C6_CASES),$(C6_CASES)); done
	@touch $@

$(C6O)/page.html: $(C6)/page.sh pipelines/figure.sh pipelines/table.awk $(C6O)/comparison.tsv $(C6O)/figures $(wildcard $(C6_KEPT)/*)
	@OUT=$(C6O) PROFILE=$(PROFILE) GRAINS=$(C6_G) MAIN=$(C6_MAIN) $(C6)/page.sh $(call whole,$@)
	@awk -F '\t' 'NR > 1 { n[$$7]++ } END { printf "ch6: %d statements met, %d not met (make report)\n", n["met"], n["not met"] }' \
	  $(C6O)/comparison.tsv

# Kept: they are dear.
.PRECIOUS: $(C6O)/%.h5
