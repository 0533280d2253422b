# Soilweave: build, tests, studies. `make help` lists every verb.
# SPDX-License-Identifier: GPL-3.0-or-later

SHELL := /bin/bash
.SHELLFLAGS := -o pipefail -c
.DELETE_ON_ERROR:
.SUFFIXES:
MAKEFLAGS += --no-builtin-rules
.DEFAULT_GOAL := all

# ---- Where things go ------------------------------------------------------------------------------------------------
# Variants live in trees of their own, so that one never reuses the objects of another:
#   make                build/            release
#   make SANITIZE=1     build/sanitize/   address and undefined-behaviour sanitizers
#   make COVERAGE=1     build/coverage/   gcov counters
PREFIX ?= /usr/local
DESTDIR ?=
JOBS ?= $(shell nproc)
CXX := $(if $(filter default,$(origin CXX)),g++,$(CXX))
VARIANT := $(if $(SANITIZE),sanitize,$(if $(COVERAGE),coverage))
B := build$(addprefix /,$(VARIANT))

# ---- Flags ----------------------------------------------------------------------------------------------------------
# -ffp-contract=off: a fused multiply-add in one place and not in another would give other bits (core/lanes.h).
OPTIMISE_ := -O3 -DNDEBUG
OPTIMISE_sanitize := -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all \
  -Wno-maybe-uninitialized
OPTIMISE_coverage := -O0 -g --coverage -fprofile-update=atomic -DNDEBUG
WARNINGS := -Wall -Wextra -Wpedantic -Werror
PACKAGES := hdf5-serial fmt libcrypto tomlplusplus gsl
system = $(patsubst -I%,-isystem %,$(1))

CPPFLAGS += -Ilib -isystem /usr/include/eigen3 $(call system,$(shell pkg-config --cflags $(PACKAGES) 2>/dev/null))
CXXFLAGS += -std=c++20 -march=x86-64-v3 -ffp-contract=off -fopenmp $(OPTIMISE_$(VARIANT)) $(WARNINGS)
LDLIBS += $(shell pkg-config --libs $(PACKAGES) 2>/dev/null) -lmpfr -lgmp -pthread

VTK := 9.1
VTK_CPPFLAGS := -isystem /usr/include/vtk-$(VTK)
VTK_LIBS := $(patsubst %,-lvtk%-$(VTK),IOXML IOXMLParser IOCore CommonExecutionModel CommonDataModel CommonTransforms \
  CommonMisc CommonMath CommonCore sys)

# ---- Sources --------------------------------------------------------------------------------------------------------
LIB_ALL := $(sort $(shell find lib -name '*.cpp'))
VTK_ONLY := lib/io/vtk.cpp
LIB := $(filter-out $(VTK_ONLY),$(LIB_ALL))
TOOL := $(sort $(wildcard tools/*.cpp))
TOOL := $(if $(NO_VTK),$(filter-out tools/to-vtk.cpp,$(TOOL)),$(TOOL))
TESTED := unit property benchmarks
tests_of = $(sort $(wildcard tests/$(1)/*_test.cpp))
BENCH := $(sort $(wildcard tests/benchmarks/bench_*.cpp))
SUPPORT := $(sort $(wildcard tests/support/*.cpp))
SOURCES := $(LIB_ALL) $(TOOL) $(foreach t,$(TESTED),$(call tests_of,$(t))) $(BENCH) $(SUPPORT)
HEADERS := $(sort $(shell find lib tests -name '*.h'))
SCRIPTS := $(sort $(wildcard .ci/run tests/*.sh tests/crosscheck/*.sh pipelines/*.sh pipelines/*/*.sh \
  tests/tools/*.bash tests/tools/*.bats))

object = $(patsubst %.cpp,$(B)/obj/%.o,$(1))
TOOLS := $(patsubst tools/%.cpp,$(B)/bin/%,$(TOOL))
TEST_PROGRAMS := $(foreach t,$(TESTED),$(if $(call tests_of,$(t)),$(B)/tests/$(t)))

.PHONY: all
all: $(TOOLS) ## build the tools into build/bin (NO_VTK=1: without to-vtk; SANITIZE=1: build/sanitize)

# ---- Rules ----------------------------------------------------------------------------------------------------------
# $(B)/flags changes only when the command line of the compiler does; every object depends on it.
FLAGS := $(CXX) $(CPPFLAGS) $(CXXFLAGS)
$(B)/flags: always
	@mkdir -p $(@D)
	@printf '%s\n' '$(FLAGS)' | cmp -s - $@ || printf '%s\n' '$(FLAGS)' > $@
.PHONY: always
always:

$(B)/obj/%.o: %.cpp $(B)/flags
	@mkdir -p $(@D)
	@echo '  c++   $<'
	@$(CXX) $(CPPFLAGS) $(CXXFLAGS) -MMD -MP -c $< -o $@

# CGAL's interval arithmetic needs the rounding mode respected.
$(B)/obj/lib/analysis/tessellation.o: CXXFLAGS += -frounding-math
$(call object,$(VTK_ONLY)): CPPFLAGS += $(VTK_CPPFLAGS)
$(B)/obj/tests/%.o: CPPFLAGS += -Itests

# $(B)/sources remembers which files the archive is made of: a source taken away must leave it too.
$(B)/sources: always
	@mkdir -p $(@D)
	@printf '%s\n' $(LIB) | cmp -s - $@ || printf '%s\n' $(LIB) > $@

$(B)/libsoilweave.a: $(call object,$(LIB)) $(B)/sources
	@echo '  ar    $@'
	@rm -f $@ && ar rcsD $@ $(filter %.o,$^)

$(B)/bin/%: $(B)/obj/tools/%.o $(B)/libsoilweave.a
	@mkdir -p $(@D)
	@echo '  link  $@'
	@$(CXX) $(CXXFLAGS) $(LDFLAGS) $(filter %.o %.a,$^) $(LDLIBS) -o $@

$(B)/bin/to-vtk: $(call object,$(VTK_ONLY))
$(B)/bin/to-vtk: LDLIBS += -Wl,--as-needed $(VTK_LIBS)

define test_program
$(B)/tests/$(1): $(call object,$(call tests_of,$(1)) $(SUPPORT)) $(B)/libsoilweave.a
	@mkdir -p $$(@D)
	@echo '  link  $$@'
	@$$(CXX) $$(CXXFLAGS) $$(LDFLAGS) $$(filter %.o %.a,$$^) $$(LDLIBS) -lgtest -lgtest_main -o $$@
endef
$(foreach t,$(TESTED),$(eval $(call test_program,$(t))))

$(B)/tests/bench: $(call object,$(BENCH) $(SUPPORT)) $(B)/libsoilweave.a
	@mkdir -p $(@D)
	@echo '  link  $@'
	@$(CXX) $(CXXFLAGS) $(LDFLAGS) $(filter %.o %.a,$^) $(LDLIBS) -lbenchmark -lbenchmark_main -o $@

-include $(patsubst %.o,%.d,$(call object,$(SOURCES)))

.PHONY: programs
programs: $(TOOLS) $(TEST_PROGRAMS)

# Kept objects: make would otherwise delete the tools' as intermediates and build them again next time.
.SECONDARY:
