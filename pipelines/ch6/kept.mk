# What the thesis-size runs of chapter 6 leave, kept in the repository for readers who have not the hours. Kept run by run, as they end;
# compared and drawn anew whenever that changes, without the runs.
# SPDX-License-Identifier: GPL-3.0-or-later
C6_KEPT := $(C6)/kept
C6_KEEP := time pull_end force_y_bottom length_bottom interface_shear interface_normal external_work energy_error
C6_ENDED := $(patsubst $(C6O)/%.h5,%,$(wildcard $(C6_RUNS:%=$(C6O)/%.h5) $(C6O)/$(C6_SWINGING).h5))
C6_OF_ENDED := $(filter $(foreach run,$(C6_ENDED),$(run)_%),$(C6_OF_MAINS))
.PHONY: ch6-keep
ch6-keep: $(BIN)/fem-dem $(BIN)/to-vtk $(C6_OF_ENDED:%=$(C6O)/%.tsv) ## keep what the thesis-size runs of ch6 that have ended leave (PROFILE=thesis)
	@$(call keep_series,$(C6_KEPT),$(C6_ENDED:%=$(C6O)/%.h5),$(BIN)/fem-dem --table series,$(C6_KEEP))
	@$(if $(C6_OF_ENDED),cp $(filter %.tsv,$^) $(C6_KEPT))
	@$(MAKE) --no-print-directory ch6-compare

C6_KEPT_MAIN := $(C6_MESH_thesis)_$(C6_SPEED_thesis)
kept_cases = $(patsubst $(C6_KEPT)/$(1)_%.txt,%,$(wildcard $(C6_KEPT)/$(1)_*.txt))
.PHONY: ch6-compare
ch6-compare: $(C6)/measure.awk $(C6)/statements.tsv $(C6)/figures.gp ## compare and draw anew what is kept of ch6
	@mkdir -p $(C6O)
	@$(call measure_scales,$(C6_KEPT),$(C6_KEPT_MAIN),$(call c6_cases,MESHES,thesis),$(call c6_cases,SPEEDS,thesis)) -v partial=1 \
	  -f $(C6)/measure.awk $(call whole,$(C6O)/kept_measured.tsv)
	@awk -v partial=1 -f pipelines/compare.awk $(C6)/statements.tsv $(C6O)/kept_measured.tsv $(call whole,$(C6_KEPT)/comparison.tsv)
	@$(call draw_scales,$(C6_KEPT),svg,$(C6_KEPT_MAIN),$(call kept_cases,shape),$(call kept_cases,pullout))
