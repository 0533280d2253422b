# What the thesis-size runs of chapter 3 leave, kept in the repository for readers who have not the hours: tables, each run's history, and
# what is compared and drawn of them. Kept run by run, as they end; compared and drawn anew whenever that changes, without the runs.
# SPDX-License-Identifier: GPL-3.0-or-later
C3_KEPT := $(C3)/kept
C3_KEEP := step stage time displacement_top_x displacement_top_z displacement_bottom_z force_top_x force_top_z force_bottom_z soil_volume \
  soil_void_ratio soil_delaunay_void_ratio soil_stress_xx soil_stress_yy soil_stress_zz soil_stress_xz soil_mean_stress soil_deviatoric_stress soil_obliquity \
  soil_coordination_number face_friction_x face_friction_y face_friction_z yarn_tension_face yarn_strain_face \
  yarn_tension_side_horizontal yarn_strain_side_horizontal yarn_tension_side_vertical yarn_strain_side_vertical broken_yarns \
  kinetic_energy unbalanced_force boundary_work energy_error
C3_ENDED := $(patsubst $(C3O)/%.h5,%,$(wildcard $(C3O)/uc_*.h5 $(C3O)/ss_*.h5))
C3_OF_ENDED := $(filter $(foreach table,first_break fabric groups breaks,$(C3_ENDED:%=%_$(table))),$(C3_OF_RUNS))
.PHONY: ch3-keep
ch3-keep: $(BIN)/homogenize $(BIN)/to-vtk $(C3_OF_ENDED:%=$(C3O)/%.tsv) $(C3_OF_BAG) $(C3_ROSES) ## keep what the thesis-size runs of ch3 that have ended leave (PROFILE=thesis)
	@$(call keep_series,$(C3_KEPT),$(C3_ENDED:%=$(C3O)/%.h5),$(BIN)/homogenize --table series --tsv,$(C3_KEEP))
	@cp $(filter %.tsv,$^) $(C3_KEPT)
	@$(BIN)/to-vtk --history $(C3O)/bag.h5 $(call whole,$(C3_KEPT)/generation.txt)
	@$(MAKE) --no-print-directory ch3-compare

C3_KEPT_LOADS = $(shell ls $(C3_KEPT) | sed -n 's/^ss_\([0-9]*\)\.tsv$$/\1/p' | sort -n)
C3_KEPT_TABLES = $(wildcard $(C3_KEPT)/uc_*.tsv $(C3_KEPT)/ss_*.tsv $(C3_KEPT)/generation.tsv $(C3_KEPT)/shape.tsv)
# What of the published values these runs do not have is left out.
compare_kept = awk -v partial=1 -f pipelines/compare.awk $(C3)/$(1).tsv $(C3O)/kept_measured.tsv $(call whole,$(C3_KEPT)/$(2).tsv)
.PHONY: ch3-compare
ch3-compare: $(C3_MEASURE) $(C3_SET) ## compare and draw anew what is kept of ch3
	@mkdir -p $(C3O)
	@$(call measure,$(C3_KEPT_LOADS),1,$(C3_KEPT_TABLES)) $(call whole,$(C3O)/kept_measured.tsv)
	@$(call compare_kept,expected,comparison) && $(call compare_kept,statements,checklist)
	@$(call draw,$(C3_KEPT),svg,$(C3_KEPT_LOADS),1,$(C3)/figures.gp)
