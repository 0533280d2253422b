# Soilweave: build, tests, studies. `make help` lists every verb.
# SPDX-License-Identifier: GPL-3.0-or-later

SHELL := /bin/bash
.SHELLFLAGS := -o pipefail -c
.DELETE_ON_ERROR:
.SUFFIXES:
# awk, sort and printf read and write numbers by the locale, so one locale is set here.
export LC_ALL := C.UTF-8
MAKEFLAGS += --no-builtin-rules
.DEFAULT_GOAL := all

# ---- Where things go ------------------------------------------------------------------------------------------------
# Variants live in trees of their own, so that one never reuses the objects of another:
#   make                build/            release
#   make SANITIZE=1     build/sanitize/   address and undefined-behaviour sanitizers
#   make COVERAGE=1     build/coverage/   gcov counters
#   make FUZZ=1         build/fuzz/       clang's libFuzzer and sanitizers
#   make PORTABLE=1     build/portable/   loops in place of x86-64's vector instructions, as on other processors
#   make NO_PCH=1       build/plain/      without the precompiled header, so that each source includes what it uses
# A compiler for another processor builds in build/PROCESSOR.
PREFIX ?= /usr/local
DESTDIR ?=
JOBS ?= $(shell nproc)
# Clang compiles the sanitizers' tree if it is installed. It takes three fifths of GCC's time for it, and a check sees two compilers.
CHOSEN := $(filter-out default,$(origin CXX))$(SANITIZE)$(FUZZ)
CXX := $(if $(FUZZ),clang++,$(if $(filter default,$(origin CXX)),$(if $(SANITIZE),$(if $(shell command -v clang++),clang++,g++),g++),$(CXX)))
# A compiler that was chosen is asked for its name and processor. Debian's own has that of make, and no call of make waits for it.
HERE := $(firstword $(subst -, ,$(MAKE_HOST)))
COMPILER := $(if $(CHOSEN),$(shell $(CXX) --version 2>/dev/null; echo target=$$($(CXX) -dumpmachine 2>/dev/null)),target=$(HERE)) here=$(HERE)
CLANG := $(findstring clang,$(COMPILER))
VARIANT := $(if $(SANITIZE),sanitize,$(if $(COVERAGE),coverage,$(if $(FUZZ),fuzz,$(if $(PORTABLE),portable,$(if $(NO_PCH),plain)))))
MACHINE := $(firstword $(subst -, ,$(patsubst target=%,%,$(filter target=%,$(COMPILER)))))
X86 := $(filter x86_64,$(MACHINE))
B := $(subst $() ,/,$(strip build $(filter-out $(patsubst here=%,%,$(filter here=%,$(COMPILER))),$(MACHINE)) $(VARIANT)))

# ---- Flags ----------------------------------------------------------------------------------------------------------
# -ffp-contract=off: a fused multiply-add in one place and not in another would give other bits (core/simd/lanes.h).
OPTIMISE_ := -O3 -DNDEBUG
OPTIMISE_portable := $(OPTIMISE_) -DSOILWEAVE_PORTABLE
OPTIMISE_plain := $(OPTIMISE_)
# Null pointers, overruns and wrong types show as address errors; a second check would double the compile time. Reports name
# functions; SANITIZE_DEBUG=-g1 adds lines, which take a tenth of the compile time.
SANITIZE_DEBUG ?= -g0
OPTIMISE_sanitize := -O1 $(SANITIZE_DEBUG) -fno-omit-frame-pointer -fsanitize=address,undefined \
  -fno-sanitize=null,object-size,vptr,alignment,pointer-overflow -fno-sanitize-recover=all
# The fuzzer runs on one thread and does not need clang's OpenMP.
OPTIMISE_fuzz := -O1 -g1 -fno-omit-frame-pointer -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-openmp
OPTIMISE_coverage := -Og -g --coverage -fprofile-update=atomic -DNDEBUG
# -Wno-restrict, -Wno-stringop-overflow: GCC 12 sees an overlap in "text" + std::string where there is none (its bug 105651).
# -Wno-array-bounds, -Wno-maybe-uninitialized: it misjudges vector loads from Eigen's small matrices; the sanitizers and
# clang-tidy watch instead. No warning stops a build, with whichever compiler. Only lint treats warnings as errors.
WARNINGS := -Wall -Wextra -Wpedantic -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds -Wno-maybe-uninitialized $(if $(X86),,-Wno-psabi) \
  $(if $(CLANG),-Wno-unknown-warning-option)$(if $(FUZZ), -Wno-unknown-pragmas)
PACKAGES := hdf5-serial fmt libcrypto tomlplusplus gsl
# The standard library of GCC 14 has limits of __float128, and Boost defines them once more for clang.
CLANG_ONLY := -DBOOST_MATH_DISABLE_FLOAT128
system = $(patsubst -I%,-isystem %,$(1))

# The first use of a flag of the packages asks pkg-config and keeps the answer: each object and each program has these flags.
PACKAGE_CPPFLAGS = $(eval PACKAGE_CPPFLAGS := $$(call system,$$(shell pkg-config --cflags $$(PACKAGES) 2>/dev/null)))$(PACKAGE_CPPFLAGS)
# HDF5's shared library brings some thirty others, most of them curl's, whose loading takes half of the time in which a tool starts. Where its
# archive links without them, the tools hold what they use of it. The sanitizers' lists of known leaks name the shared library.
HDF5_ARCHIVE := -Wl,-Bstatic -lhdf5 -Wl,-Bdynamic -lsz -lz -ldl
hdf5_links = $(shell echo 'extern "C" int H5open(); int main() { return H5open(); }' | $(CXX) -x c++ - -x none \
  $(patsubst -lhdf5,$(HDF5_ARCHIVE),$(1)) -o /dev/null 2>/dev/null && echo yes)
packaged = $(if $(SANITIZE)$(FUZZ),$(1),$(if $(call hdf5_links,$(1)),$(patsubst -lhdf5,$(HDF5_ARCHIVE),$(1)),$(1)))
PACKAGE_LIBS = $(eval PACKAGE_LIBS := $$(call packaged,$$(shell pkg-config --libs $$(PACKAGES) 2>/dev/null)))$(PACKAGE_LIBS)
CPPFLAGS += -Ilib -isystem /usr/include/eigen3 $(PACKAGE_CPPFLAGS)
ARCHITECTURE := $(if $(X86),-march=x86-64-v3)
CXXFLAGS += -std=c++20 $(ARCHITECTURE) -ffp-contract=off -fopenmp $(OPTIMISE_$(VARIANT)) $(WARNINGS)
CPPFLAGS += $(if $(CLANG),$(CLANG_ONLY))
LDLIBS += $(PACKAGE_LIBS) -lmpfr -lgmp -pthread

# VTK has no pkg-config file. Its newest version in VTK_PREFIX is used; VTK=9.3 chooses another.
VTK_PREFIX ?= /usr
VTK_FOUND := $(patsubst $(VTK_PREFIX)/include/vtk-%,%,$(wildcard $(VTK_PREFIX)/include/vtk-[0-9]*))
VTK := $(or $(VTK),$(if $(word 2,$(VTK_FOUND)),$(shell printf '%s\n' $(VTK_FOUND) | sort -V | tail -n 1),$(VTK_FOUND)))
VTK_CPPFLAGS := -isystem $(VTK_PREFIX)/include/vtk-$(VTK)
VTK_LIBS := $(patsubst %,-lvtk%-$(VTK),IOXML IOXMLParser IOCore CommonExecutionModel CommonDataModel CommonTransforms \
  CommonMisc CommonMath CommonCore sys)
ifneq ($(VTK_PREFIX),/usr)
VTK_LIBS += -L$(VTK_PREFIX)/lib -Wl,-rpath,$(VTK_PREFIX)/lib
endif

# Headers and programs that the compiler needs are checked before it starts; each has its remedy.
missing = $(strip $(if $(shell command -v $(CXX)),,$(CXX)) $(foreach p,$(PACKAGES),$(shell pkg-config --exists $(p) || echo $(p))) \
  $(if $(NO_VTK)$(wildcard $(VTK_PREFIX)/include/vtk-$(VTK)/vtkVersion.h),,VTK) $(if $(and $(CLANG),$(if $(FUZZ),,other)),$(shell $(CXX) -fopenmp -include omp.h -x c++ -fsyntax-only \
  /dev/null 2> /dev/null || echo OpenMP)))
remedy_VTK := run: make deps, or build without it: make NO_VTK=1
remedy_OpenMP := run: apt-get install libomp-dev ($(CXX) takes it from there)
remedy_$(CXX) := install it, or take another compiler: make CXX=g++
remedy_g++ := run: make deps
remedy_clang++ := run: apt-get install clang libomp-dev

# ---- Sources --------------------------------------------------------------------------------------------------------
FOUND := $(sort $(shell find lib tests -name '*.cpp' -o -name '*.h'))
LIB_ALL := $(filter lib/%.cpp,$(FOUND))
VTK_ONLY := lib/display/vtk.cpp lib/files/exchange/triangles_vtk.cpp
MPI_ONLY := lib/fem/model/ranks_mpi.cpp
LIB := $(filter-out $(VTK_ONLY) $(MPI_ONLY),$(LIB_ALL))
TOOL := $(sort $(wildcard tools/*.cpp))
TOOL := $(if $(NO_VTK),$(filter-out tools/to-vtk.cpp,$(TOOL)),$(TOOL))
TESTED := unit property benchmarks soak
tests_of = $(sort $(wildcard tests/$(1)/*_test.cpp))
BENCH := $(sort $(wildcard tests/benchmarks/bench_*.cpp))
SUPPORT := $(sort $(wildcard tests/support/*.cpp))
TEST_MAIN := tests/main.cpp
SOURCES := $(LIB_ALL) $(TOOL) $(foreach t,$(TESTED),$(call tests_of,$(t))) $(BENCH) $(SUPPORT) $(TEST_MAIN)
HEADERS := $(filter %.h,$(FOUND))
SCRIPTS := $(sort $(wildcard .ci/run tests/*.sh tests/crosscheck/*.sh tests/benchmarks/*.sh tests/soak/*.sh tests/fuzz/*.sh pipelines/*.sh pipelines/*/*.sh \
  tests/tools/*.bash tests/tools/*.bats tests/extension/*.bats))

# A contact law, a loading path, an energy term, a container or a table of homogenize is one header in its folder that states
# its name, and its class has the file's name: round_box.h holds RoundBox. $(B)/lists/NAME.h includes these headers and names the
# classes, so that a new one needs no other change. LISTING reads the lists.
LISTED_laws := lib/dem/contact/laws
LISTED_paths := lib/dem/loading/paths
LISTED_energies := lib/dem/engine/energies
LISTED_containers := lib/packing/container/shapes
LISTED_tables := lib/packing/expand/tables
LISTS := laws paths energies containers tables
LISTING := tests/property/laws_test.cpp lib/dem/contact/law_list.cpp lib/dem/sweep/contact_sweep.cpp lib/dem/loading/path_list.cpp lib/dem/engine/energies/energy_list.cpp \
  lib/packing/container/container_list.cpp lib/packing/expand/run_tables.cpp
X := $(B)/extended$(if $(NARROW),/narrow)
headers_of = $(sort $(shell grep -ls 'static constexpr .* name = "' $(LISTED_$(1))/*.h))

object = $(patsubst %.cpp,$(B)/obj/%.o,$(1))
# Sources of a folder of lib/ are compiled as one (UNITS), because nearly half of the time of a single source goes into the precompiled
# header and into templates that its neighbours need too. Several folders share a unit where an edit still compiles in half a minute, because
# the optimisation is low (COLD). The sanitizers' tree, which checks build, has the largest units. Sources of a unit must have unlike names, which
# clang-tidy needs as well (TIDY_GROUPS). The two sources that need CGAL and a flag for it are joined to each other (ROUNDED). SINGLE sources
# have flags of their own, objects that extensions or MPI replace, or need of VTK; build/plain and the counters of coverage take each source
# by itself. Benchmark tests, and unit tests in the sanitizers' tree, are joined by tens (TENS).
ROUNDED := lib/analysis/measure/tessellation.cpp lib/packing/container/shapes/surface.cpp
SWEPT := lib/dem/sweep/contact_sweep.cpp lib/dem/sweep/grain_motion.cpp lib/dem/engine/motion.cpp lib/dem/contact/contacts.cpp
SINGLE := $(ROUNDED) $(SWEPT) $(LISTING) lib/core/linear_algebra.cpp lib/core/processor.cpp lib/dem/sweep/vector_width.cpp lib/fem/model/ranks.cpp \
  lib/display/paraview.cpp
JOINED := $(if $(NO_PCH)$(COVERAGE),,$(filter-out $(SINGLE),$(LIB)))
# Sources that extensions compile again are one unit too, without the sweep.
LISTED := $(if $(JOINED),$(filter-out $(SWEPT),$(filter lib/%,$(LISTING))) lib/dem/sweep/vector_width.cpp)
# A folder is written with a point for a slash here.
COLD_UNITS := store+files+files.exchange+display core.cli+core.text gws.design+gws.laboratory+gws.output$(if $(SANITIZE),+gws.identification) \
  dem.run+analysis.doubts+analysis.tables fem.mesh+fem.run+calibration.output $(if $(SANITIZE),,calibration)
WARM_UNITS := $(if $(SANITIZE),dem.contact+dem.engine+dem.loading+dem.state+dem.sweep packing.container+packing.container.shapes+packing.expand+packing.generate \
  analysis.measure fem.material+fem.model)
folder_of = $(subst /,.,$(patsubst lib/%/,%,$(dir $(1))))
folders_of = $(subst +, ,$(1))
UNITS := $(if $(JOINED),rounded listed $(COLD_UNITS) $(WARM_UNITS) $(filter-out $(call folders_of,$(COLD_UNITS) $(WARM_UNITS)),$(sort $(call folder_of,$(JOINED)))))
sources_of = $(if $(filter rounded,$(1)),$(ROUNDED),$(if $(filter listed,$(1)),$(LISTED),$(foreach f,$(JOINED),$(if $(filter $(call folder_of,$f),$(call folders_of,$(1))),$f))))
unit_of = $(foreach u,$(UNITS),$(if $(filter $(call folder_of,$(1)),$(call folders_of,$u)),$u))
UNIT_OBJECTS := $(UNITS:%=$(B)/obj/units/%.o)
# Places of every tenth test. Each call of make reads this, and a shell would take longer.
DIGITS := 0 1 2 3 4 5 6 7 8 9
TENTHS := $(foreach hundreds,$(DIGITS),$(DIGITS:%=$(hundreds)%1))
tens_of = $(foreach n,$(TENTHS),$(if $(word $n,$(call tests_of,$(1))),$(B)/obj/tests/$(1)/tests_$n.o))
JOINED_TESTS := $(if $(NO_PCH)$(COVERAGE),,benchmarks $(if $(SANITIZE),unit))
TENS := $(foreach t,$(JOINED_TESTS),$(call tens_of,$(t)))
# The unit that needs CGAL takes longest and begins first, so that no core waits for it.
LIB_OBJECTS := $(UNIT_OBJECTS) $(call object,$(filter-out $(JOINED) $(LISTED) $(if $(JOINED),$(ROUNDED)),$(LIB)))
# The objects that hold these sources, joined or not.
objects_of = $(sort $(foreach s,$(1),$(if $(filter $s,$(LISTED)),$(B)/obj/units/listed.o,$(if $(filter $s,$(JOINED)),$(B)/obj/units/$(call unit_of,$s).o,\
  $(call object,$s)))))
# plot is a Python program that imports the package of the studies. It is a link, through which it finds the package.
TOOLS := $(patsubst tools/%.cpp,$(B)/bin/%,$(TOOL)) $(B)/bin/plot
# Test programs of every check; soak takes minutes.
TEST_PROGRAMS := $(foreach t,$(filter-out soak,$(TESTED)),$(if $(call tests_of,$(t)),$(B)/tests/$(t)))

# The folder tools/ would make "make tools" up to date otherwise.
.PHONY: all tools
all: $(TOOLS) ## build the tools into build/bin (NO_VTK=1: without to-vtk; SANITIZE=1: build/sanitize)
tools: all

# ---- Rules ----------------------------------------------------------------------------------------------------------
# Compiles, and keeps the compiler's warnings beside the object for lint. The argument is the rest of the command.
compile = $(CXX) $(1) 2> $@.warnings; status=$$?; cat $@.warnings >&2; exit $$status

# Replaces a file by its new version, FILE.new, if the two differ.
keep_new = cmp -s $@.new $@ || mv $@.new $@; rm -f $@.new

# $(B)/flags changes only when the compiler's command line does; every object depends on it.
FLAGS = $(strip $(CXX) $(CPPFLAGS) $(CXXFLAGS))
$(B)/flags: always
	@$(foreach m,$(strip $(missing)),echo 'make: $m is not installed; $(or $(remedy_$m),run: make deps)' >&2; exit 1;)
	@mkdir -p $(@D)
	@printf '%s\n' '$(FLAGS)' | cmp -s - $@ || printf '%s\n' '$(FLAGS)' > $@
.PHONY: always
always:

# Headers are parsed once per tree and level of optimisation, which halves the time to compile sources.
$(B)/precompiled/%.h.gch: lib/core/precompiled.h $(B)/flags
	@mkdir -p $(@D)
	@echo '  c++   $(@:.gch=)'
	@printf '#include "core/precompiled.h"\n$(PRECOMPILE_ALSO)\n' > $(@:.gch=)
	@$(call compile,$(CPPFLAGS) $(CXXFLAGS) -x c++-header $(@:.gch=) -o $@)
PRECOMPILED := $(B)/precompiled/soilweave.h
PRECOMPILED_TESTS := $(B)/precompiled/tests.h
$(PRECOMPILED_TESTS).gch: PRECOMPILE_ALSO := \#include <gtest/gtest.h>

# $(call print_list,NAME,HEADERS) prints a list. A header outside lib/ is included by its whole path.
print_list = printf '%s\n' $(foreach h,$(2),$(or $(patsubst lib/%,%,$(filter lib/%,$h)),$(abspath $h))) | \
  awk -v list='$(1)' 'BEGIN { print "// The list of $(1), made by the build from the files in their folder." } \
  { print "\#include \"" $$0 "\""; n = split($$0, at, "/"); sub(/\.h$$/, "", at[n]); m = split(at[n], word, "_"); \
    all = all (NR > 1 ? ", " : ""); for (k = 1; k <= m; ++k) all = all toupper(substr(word[k], 1, 1)) substr(word[k], 2) } \
  END { print "\#define SOILWEAVE_" toupper(list) " " all }'
$(LISTS:%=$(B)/lists/%.h): $(B)/lists/%.h: always
	@mkdir -p $(@D)
	@$(call print_list,$*,$(call headers_of,$*)) > $@.new; $(keep_new)

$(B)/obj/%.o: %.cpp $(B)/flags $(if $(NO_PCH),,$(PRECOMPILED).gch)
	@mkdir -p $(@D)
	@echo '  c++   $<'
	@$(call compile,$(CPPFLAGS) $(if $(NO_PCH),,-include $(PRECOMPILED)) $(CXXFLAGS) -MMD -MP -c $< -o $@)

# Helpers of different unit tests may have equal names, so each joined test gets a namespace within its unnamed one.
$(UNIT_OBJECTS:.o=.cpp): $(B)/obj/units/%.cpp: always
	@mkdir -p $(@D)
	@printf '#include "%s"\n' $(call sources_of,$*) > $@.new; $(keep_new)
define join_tests
$(patsubst %.o,%.cpp,$(call tens_of,$(1))): $(B)/obj/tests/$(1)/tests_%.cpp: always
	@mkdir -p $$(@D)
	@for test in $$$$(printf '%s\n' $(call tests_of,$(1)) | tail -n +$$* | head -n 10); do \
	  name=$$$$(basename $$$$test .cpp); echo "#line 1 \"$$$$test\""; \
	  sed "s/^namespace {\$$$$/namespace { namespace $$$$name {/; s,^}  // namespace\$$$$,} }," $$$$test; done > $$@.new; $$(keep_new)
endef
$(foreach t,$(JOINED_TESTS),$(eval $(call join_tests,$(t))))
$(UNIT_OBJECTS) $(TENS): %.o: %.cpp $(B)/flags $(if $(NO_PCH),,$(PRECOMPILED).gch)
	@echo '  c++   $(<:$(B)/obj/%=%)'
	@$(call compile,-iquote . $(CPPFLAGS) $(if $(NO_PCH),,-include $(PRECOMPILED)) $(CXXFLAGS) -MMD -MP -c $< -o $@)

# CGAL's interval arithmetic needs the rounding mode respected; its undefined-behaviour build takes longest of all files.
$(call object,$(ROUNDED)) $(B)/obj/units/rounded.o: private CXXFLAGS += -frounding-math $(if $(SANITIZE),-fno-sanitize=undefined)
# Sources without long loops compile faster at a lower level of optimisation: in two thirds of the time with -O1 instead of -O3, and under the
# sanitizers, CGAL included, in half to two thirds with -O0. A precompiled header holds for one level of optimisation.
COLD_LEVEL := $(if $(SANITIZE),-O0,$(if $(filter-out portable,$(VARIANT)),,-O1))
COLD := $(if $(COLD_LEVEL),$(patsubst %,$(B)/obj/units/%.o,$(COLD_UNITS) $(if $(SANITIZE),rounded)) \
  $(call object,$(if $(SANITIZE),lib/core/linear_algebra.cpp,$(TOOL))))
$(COLD): $(B)/precompiled/cold.h.gch
$(COLD): private PRECOMPILED := $(B)/precompiled/cold.h
$(COLD) $(B)/precompiled/cold.h.gch: private CXXFLAGS += $(COLD_LEVEL)
$(call object,$(VTK_ONLY)): private CPPFLAGS += $(VTK_CPPFLAGS)
# Where GCC 12 packs single numbers into vector registers, it fuses products with sums (vfmaddsub) in spite of -ffp-contract=off. GCC 14
# does not, so that eigenvalues would differ in their last digits. `make fused` finds such sources.
# A precompiled header would bring its own optimisation back. The sanitizers' tree does not pack numbers.
UNPACKED := $(if $(SANITIZE),,$(call object,lib/core/linear_algebra.cpp))
$(UNPACKED): private CXXFLAGS += -fno-tree-slp-vectorize $(COLD_LEVEL)
$(UNPACKED): private PRECOMPILED := lib/core/linear_algebra.h
# Hot loops. GCC would copy a register of four numbers in halves, and a read of the whole register then waits for both. It would
# also pack single integers into vector registers, which takes more time than it saves. Clang has no such switches.
HOT := $(X)/obj/lib/dem/sweep/contact_sweep.o $(call object,$(SWEPT))
# The loops over contacts and grains are compiled again with eight lanes, for processors with AVX-512; vector_width.cpp chooses.
# Inline functions of these objects must stay local, or the linker may use them for all objects.
WIDE := lib/dem/sweep/contact_sweep lib/dem/sweep/grain_motion
# NO_AVX512=1 builds without them.
EIGHT := $(if $(filter-out plain,$(VARIANT))$(NO_AVX512)$(if $(X86),,other),,$(WIDE:%=$(B)/obj/%.avx512.o))
EIGHT_EXTENDED := $(if $(NARROW),,$(patsubst $(B)/%,$(X)/%,$(filter %/contact_sweep.avx512.o,$(EIGHT))))
$(HOT) $(EIGHT) $(EIGHT_EXTENDED): private CXXFLAGS += $(if $(CLANG)$(if $(X86),,other),,-mmove-max=256 -mstore-max=256) -fno-tree-slp-vectorize
# GCC's headers leave a register unset on purpose in square roots of AVX-512 (bug 105593). -fno-gnu-unique: a law's list of history
# would otherwise be a symbol that no tool can make local.
$(EIGHT) $(EIGHT_EXTENDED): private CXXFLAGS += -Wno-uninitialized $(if $(CLANG),,-fno-gnu-unique)
AVX512 := -mavx512f -mavx512dq -mavx512vl -mavx512bw -mprefer-vector-width=512
CHOOSING := $(call objects_of,lib/dem/sweep/vector_width.cpp)
$(if $(EIGHT),$(CHOOSING): private CPPFLAGS += -DSOILWEAVE_AVX512)
define eight_lanes
	@mkdir -p $(@D)
	@echo '  c++   $< (AVX-512$(1))'
	@$(call compile,$(CPPFLAGS) $(CXXFLAGS) $(AVX512) -DSOILWEAVE_EIGHT_LANES -MMD -MP -MT $@ -MF $(@:.o=.d) -c $< -o $@.all)
	@ld -r --force-group-allocation $@.all -o $@.one
	@objcopy --wildcard --keep-global-symbol='*$(*F)_of_eight*' $@.one $@ && rm $@.all $@.one
endef
$(EIGHT): $(B)/obj/%.avx512.o: %.cpp $(B)/flags
	$(call eight_lanes)
# Objects of eight lanes lowered to the baseline, so that tests can compare bits on any processor.
LOWERED := $(WIDE:%=$(B)/obj/%.eight.o)
$(LOWERED): $(B)/obj/%.eight.o: %.cpp $(B)/flags
	@mkdir -p $(@D)
	@echo '  c++   $< (eight lanes)'
	@$(call compile,$(CPPFLAGS) $(CXXFLAGS) -O1 -Wno-psabi -DSOILWEAVE_EIGHT_LANES -MMD -MP -MT $@ -MF $(@:.o=.d) -c $< -o $@)
# Files that are embedded in objects (core/embedded.h).
$(call objects_of,lib/display/show_script.cpp): lib/display/show.py
$(call objects_of,lib/packing/generate/grading.cpp): data/gradings/toyoura.tsv
READING_LISTS := $(call objects_of,$(LISTING)) $(EIGHT) $(LOWERED)
$(READING_LISTS): private CPPFLAGS += -I$(B)
$(READING_LISTS): | $(LISTS:%=$(B)/lists/%.h)
# The check of the processor must run on any x86-64.
$(B)/obj/lib/core/processor.o: lib/core/processor.cpp lib/core/processor.h $(B)/flags
	@mkdir -p $(@D)
	@echo '  c++   $< (any processor)'
	@$(call compile,$(CPPFLAGS) $(subst $(ARCHITECTURE),$(if $(X86),-march=x86-64),$(CXXFLAGS)) -c $< -o $@)
# Tests need not be fast, but must compile fast; bench times the library.
objects_of_tests = $(if $(filter $(1),$(JOINED_TESTS)),$(call tens_of,$(1)),$(call object,$(call tests_of,$(1))))
TEST_OBJECTS := $(foreach t,$(TESTED),$(call objects_of_tests,$(t))) $(call object,$(SUPPORT) $(TEST_MAIN))
$(B)/obj/tests/%.o: private CPPFLAGS += -Itests
$(TEST_OBJECTS): $(if $(NO_PCH),,$(PRECOMPILED_TESTS).gch)
$(TEST_OBJECTS): private PRECOMPILED := $(PRECOMPILED_TESTS)
$(TEST_OBJECTS) $(PRECOMPILED_TESTS).gch: private CXXFLAGS += $(if $(SANITIZE),-O0,-O1)

# $(B)/sources lists the files of the archive, so that a deleted source leaves it too.
$(B)/sources: always
	@mkdir -p $(@D)
	@printf '%s\n' $(LIB) | cmp -s - $@ || printf '%s\n' $(LIB) > $@

$(B)/libsoilweave.a: $(LIB_OBJECTS) $(EIGHT) $(B)/sources
	@echo '  ar    $@'
	@rm -f $@ && ar rcsD $@ $(filter %.o,$^)

$(B)/bin/%: $(B)/obj/tools/%.o $(B)/libsoilweave.a
	@mkdir -p $(@D)
	@echo '  link  $@'
	@$(CXX) $(CXXFLAGS) $(LDFLAGS) $(filter %.o %.a,$^) $(LDLIBS) -o $@

$(B)/bin/plot: tools/plot
	@mkdir -p $(@D) && ln -sf $(CURDIR)/$< $@

# A weak symbol does not make the linker take a member of the archive.
VTK_TOOLS := $(if $(NO_VTK),,to-vtk filter-expand)
$(B)/bin/to-vtk: $(call object,lib/display/vtk.cpp)
$(if $(NO_VTK),,$(B)/bin/filter-expand: $(call object,lib/files/exchange/triangles_vtk.cpp))
$(VTK_TOOLS:%=$(B)/bin/%): LDLIBS += -Wl,--as-needed $(VTK_LIBS)

# Linked before the archive, so that its ranks replace those of the single process.
$(call object,$(MPI_ONLY)): private CPPFLAGS += $(call system,$(shell pkg-config --cflags ompi-cxx 2>/dev/null))
.PHONY: mpi
mpi: $(B)/mpi/fem-dem ## fem-dem over several machines: mpirun -n 4 build/mpi/fem-dem (needs libopenmpi-dev)
$(B)/mpi/fem-dem: $(call object,tools/fem-dem.cpp $(MPI_ONLY)) $(B)/libsoilweave.a
	@mkdir -p $(@D)
	@echo '  link  $@'
	@$(CXX) $(CXXFLAGS) $(LDFLAGS) $(filter %.o %.a,$^) $(LDLIBS) $(shell pkg-config --libs ompi-cxx) -o $@

# ---- Extensions -----------------------------------------------------------------------------------------------------
# Tools with additional headers from a folder outside lib/: FOLDER/laws, FOLDER/paths, FOLDER/energies, FOLDER/containers,
# FOLDER/tables.
# Only the sources that read the lists are compiled again. They are linked before the archive, which gives all other objects.
# With NARROW=1 their sweep takes four contacts at a time on every processor, which saves the compilation for AVX-512, and optimisation is
# low. Checks use it, since the bits are equal.
EXTENSIONS ?= tests/extension
EXTENDED := $(patsubst $(B)/%,$(X)/%,$(call objects_of,$(filter lib/%,$(LISTING)) lib/dem/sweep/vector_width.cpp)) $(EIGHT_EXTENDED)
$(if $(EIGHT_EXTENDED),$(CHOOSING:$(B)/%=$(X)/%): private CPPFLAGS += -DSOILWEAVE_AVX512)
OUTSIDE = $(wildcard $(LISTS:%=$(EXTENSIONS)/%/*.h))
MISPLACED = $(filter-out $(OUTSIDE),$(wildcard $(EXTENSIONS)/*.h $(EXTENSIONS)/*/*.h))
$(LISTS:%=$(X)/lists/%.h): $(X)/lists/%.h: always
	$(if $(OUTSIDE),,$(error EXTENSIONS=$(EXTENSIONS): has no header in $(LISTS:%=%/); put one there, or name another folder))
	$(if $(MISPLACED),$(error $(MISPLACED): is in none of $(LISTS:%=%/) of EXTENSIONS; move it into the one that it belongs to))
	@mkdir -p $(@D)
	@$(call print_list,$*,$(call headers_of,$*) $(sort $(wildcard $(EXTENSIONS)/$*/*.h))) > $@.new; \
	  $(keep_new)
COLD_EXTENDED := $(if $(NARROW),$(if $(COLD_LEVEL),$(EXTENDED)))
$(COLD_EXTENDED): $(B)/precompiled/cold.h.gch
$(COLD_EXTENDED): private PRECOMPILED := $(B)/precompiled/cold.h
$(COLD_EXTENDED): private CXXFLAGS += $(COLD_LEVEL)
define compile_extended
	@mkdir -p $(@D)
	@echo '  c++   $(<:$(B)/obj/%=%) (extended)'
	@$(call compile,-iquote . -I$(X) $(CPPFLAGS) $(if $(NO_PCH),,-include $(PRECOMPILED)) $(CXXFLAGS) -MMD -MP -c $< -o $@)
endef
$(X)/obj/units/%.o: $(B)/obj/units/%.cpp $(B)/flags $(if $(NO_PCH),,$(PRECOMPILED).gch) | $(LISTS:%=$(X)/lists/%.h)
	$(compile_extended)
$(X)/obj/%.o: %.cpp $(B)/flags $(if $(NO_PCH),,$(PRECOMPILED).gch) | $(LISTS:%=$(X)/lists/%.h)
	$(compile_extended)
$(EIGHT_EXTENDED): private CPPFLAGS += -I$(X)
$(EIGHT_EXTENDED): $(X)/obj/%.avx512.o: %.cpp $(B)/flags | $(LISTS:%=$(X)/lists/%.h)
	$(call eight_lanes,$(comma) extended)
-include $(EXTENDED:.o=.d)
$(X)/bin/%: $(B)/obj/tools/%.o $(EXTENDED) $(B)/libsoilweave.a
	@mkdir -p $(@D)
	@echo '  link  $@'
	@$(CXX) $(CXXFLAGS) $(LDFLAGS) $(filter %.o %.a,$^) $(LDLIBS) -o $@

.PHONY: extended
extended: $(addprefix $(X)/bin/,pack-generate run-dem filter-expand homogenize fem-dem) ## tools that know your own laws, paths, energies, shapes and tables too: EXTENSIONS=FOLDER

.PHONY: test-extensions
test-extensions: extended ## a law, a path, energy terms, a container and a table from outside lib/, one file each
	@BIN=$(CURDIR)/$(X)/bin OMP_NUM_THREADS=1 bats tests/extension/extension.bats

define test_program
$(B)/tests/$(1): $(call objects_of_tests,$(1)) $(if $(filter unit,$(1)),$(LOWERED)) $(call object,$(SUPPORT) $(TEST_MAIN)) $(B)/libsoilweave.a
	@mkdir -p $$(@D)
	@echo '  link  $$@'
	@$$(CXX) $$(CXXFLAGS) $$(LDFLAGS) $$(filter %.o %.a,$$^) $$(LDLIBS) -lgtest -o $$@
endef
$(foreach t,$(TESTED),$(eval $(call test_program,$(t))))

$(B)/tests/bench: $(call object,$(BENCH) $(SUPPORT)) $(B)/libsoilweave.a
	@mkdir -p $(@D)
	@echo '  link  $@'
	@$(CXX) $(CXXFLAGS) $(LDFLAGS) $(filter %.o %.a,$^) $(LDLIBS) -lbenchmark -lbenchmark_main -o $@

FUZZED := $(addprefix $(B)/tests/fuzz/,scenario table spheres mesh surface file)
$(B)/tests/fuzz/%: tests/fuzz/target.cpp $(call object,$(SUPPORT)) $(B)/libsoilweave.a
	@mkdir -p $(@D)
	@echo '  link  $@'
	@$(CXX) $(CPPFLAGS) -Itests -DREADER=$* $(CXXFLAGS) -fsanitize=fuzzer $(LDFLAGS) $^ $(LDLIBS) -o $@

-include $(patsubst %.o,%.d,$(call object,$(SOURCES)) $(UNIT_OBJECTS) $(TENS) $(EIGHT) $(LOWERED))

.PHONY: programs
programs: $(TOOLS) $(TEST_PROGRAMS)

# Objects are kept; make would otherwise delete those of the tools as intermediates and build them again.
.SECONDARY:

# ---- Dependencies ---------------------------------------------------------------------------------------------------
# The first list compiles the library, so that a check compiles it while the packages of the second are unpacked.
DEBIAN_COMPILE := g++ make pkg-config libeigen3-dev libcgal-dev libhdf5-dev libcli11-dev libtomlplusplus-dev libfmt-dev libboost-math-dev \
  libgsl-dev libssl-dev
DEBIAN := $(DEBIAN_COMPILE) clang libomp-dev libgtest-dev libbenchmark-dev libvtk9-dev python3-vtk9 python3-h5py \
  python3-numpy python3-matplotlib python3-jinja2 python3-pytest python3-yaml hdf5-tools bats parallel clang-format clang-tidy shellcheck gcovr man-db groff-base locales

# $(call lacking,PACKAGES) prints those that are not installed, and $(call install,PACKAGES) installs them.
lacking = for p in $(1); do dpkg-query -W -f '$${db:Status-Status}' $$p 2>/dev/null | grep -qx installed || echo $$p; done | xargs
install = lacking=$$($(call lacking,$(1))); \
  [ -z "$$lacking" ] && exit 0; \
  line="apt-get install -y --no-install-recommends"; \
  if [ "$$(id -u)" = 0 ]; then sudo=; \
  elif command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then sudo=sudo; \
  else echo "make deps: packages are missing and you are not root; run: sudo $$line $$($(call lacking,$(DEBIAN)))" >&2; exit 1; fi; \
  echo "make deps: $$line $$lacking"; \
  $$sudo apt-get update -qq && DEBIAN_FRONTEND=noninteractive $$sudo $$line $$lacking
.PHONY: deps deps-compile
deps: ## install the Debian packages that are missing (as root or through sudo; else print the line to run)
	@$(call install,$(DEBIAN))
deps-compile:
	@$(call install,$(DEBIAN_COMPILE))

# ---- Checks ---------------------------------------------------------------------------------------------------------
# A sub-make takes part in the job server of 'make -jN' and starts one of its own otherwise.
AGAIN = $(MAKE) --no-print-directory $(if $(findstring --jobserver,$(MAKEFLAGS)),,-j$(JOBS))

# A single test may take SOILWEAVE_TEST_LIMIT seconds (600). Then it is stopped and named.
.PHONY: check
check: ## format, lint, unit, property and benchmark tests, sanitizers, tool tests; installs what is missing first
	@$(AGAIN) deps-compile
	@$(AGAIN) NO_VTK=1 deps $(B)/libsoilweave.a
	@mkdir -p $(dir $(SKIPPED)) && : > $(SKIPPED)
	@$(AGAIN) test-bag lint all $(filter-out %/unit,$(TEST_PROGRAMS)) build/sanitize/tests/unit fused format-check test-man
	@$(AGAIN) warnings
	@$(AGAIN) test-release test-install
	@$(AGAIN) NARROW=1 BAG_TESTED=1 test-tools test-sanitized test-extensions test-study
	@LC_ALL=C sort -u $(SKIPPED) | awk -f tests/skipped.awk

# The sanitizers' tree is built beside the release's, so that no core waits for the last source of either.
ifndef VARIANT
.PHONY: build/sanitize/tests/unit
build/sanitize/tests/unit:
	+@$(AGAIN) SANITIZE=1 $@
endif

# Skipped tests are noted here: program, test and reason, separated by tabs.
SKIPPED := $(CURDIR)/build/skipped
check: export SOILWEAVE_SKIPPED := $(SKIPPED)
skip = { echo "== $(1): skipped: $(3)"; printf '%s\t%s\t%s\n' '$(1)' '$(2)' '$(3)' >> "$${SOILWEAVE_SKIPPED:-/dev/null}"; }

# One process per core takes small shares of the tests, so that all cores end together. Threads of a test that wait sleep, because
# they outnumber the cores.
SHARES = $(shell echo $$((8 * $(JOBS))))
run_tests = set -e; for t in $(1); do echo "== $$t"; seq 0 $$(($(SHARES) - 1)) | \
  OMP_WAIT_POLICY=passive GTEST_TOTAL_SHARDS=$(SHARES) parallel --will-cite --jobs $(JOBS) GTEST_SHARD_INDEX={} $(EMULATOR) "$$t" --gtest_brief=1; done

# A check runs the unit tests once, under the sanitizers, and the property tests once, without, because compiling them twice would
# take as long as all the tools. Unit tests call every contact law, so that the sanitizers see those.

# Machines must give equal bytes, so no compiler may fuse products with sums by itself.
.PHONY: fused
fused: $(B)/libsoilweave.a
	@found=$$(objdump -d --no-show-raw-insn $< | awk '/file format/ { file = $$1 } /vfmaddsub|vfmsubadd/ { print file }' | sort -u); \
	[ -z "$$found" ] || { echo "fused products and sums, add the sources to UNPACKED in the Makefile: $$found" >&2; exit 1; }

# A check has built the program before, so that this does not read the sanitizers' tree again.
.PHONY: test-sanitized
test-sanitized:
	@$(call run_tests,build/sanitize/tests/unit)

.PHONY: test-release
test-release: $(filter-out %/unit,$(TEST_PROGRAMS))
	@$(call run_tests,$^)

.PHONY: test
test: $(TEST_PROGRAMS) ## unit, property and benchmark tests of the library
	@$(call run_tests,$(TEST_PROGRAMS))

.PHONY: test-unit
test-unit: $(filter %/unit %/property,$(TEST_PROGRAMS)) ## unit and property tests (SANITIZE=1: under the sanitizers)
	@$(call run_tests,$^)

# $(call run_bats,FOLDER,TESTS): FOLDER below B/tests takes the report. Tests of tools wait for signals and disks, so that one test more than there
# are cores keeps all cores busy. The longest files come first, so that none of them is left alone at the end. Within a file, tests run one after
# the other: side by side, each would cost bats half a second of processor time more.
LONGEST := $(patsubst %,tests/tools/%.bats,filter-expand ensembles plot checkpoints pack-generate run-dem calibrate help files pf-weight gws-solve \
  fem-dem surround recipes doubts to-vtk)
run_bats = mkdir -p $(B)/tests/$(1) && BIN=$(CURDIR)/$(B)/bin OMP_NUM_THREADS=1 bats --jobs $$(($(JOBS) + 1)) --no-parallelize-within-files \
  --report-formatter tap --output $(B)/tests/$(1) $(2) && \
  sed -n 's/^ok [0-9]* \(.*\) \# skip *\(.*\)$$/tools\t\1\t\2/p' $(B)/tests/$(1)/report.tap >> "$${SOILWEAVE_SKIPPED:-/dev/null}"
# The bag's test takes some minutes on one core. Begun last, it would leave the other cores idle, so a check runs it while it compiles.
BAG_TEST := tests/tools/soilbag.bats
.PHONY: test-bag
test-bag: $(TOOLS)
	@echo "== $(BAG_TEST)"
	@$(call run_bats,bag,$(BAG_TEST))
.PHONY: test-tools
test-tools: $(TOOLS) ## the tools as a user meets them, with bats
	@echo "== tests/tools"
	@$(call run_bats,tools,$(if $(BAG_TESTED),,$(BAG_TEST)) $(LONGEST) \
	  $(filter-out $(BAG_TEST) $(LONGEST),$(sort $(wildcard tests/tools/*.bats))))

# Tests that read, compare and write run again in a locale with a decimal comma, if there is one.
PYTEST = $(STUDY_PY) -m pytest -q -p no:cacheprovider
.PHONY: test-study
test-study: ## the studies' Python package, on small tables
	@echo "== tests/study"
	@{ for test in tests/study/test_*.py; do echo "$(PYTEST) $$test"; done; echo "LC_ALL=de_DE.UTF-8 $(PYTEST) tests/study/test_study.py"; } | \
	  parallel --will-cite --jobs $(JOBS) --halt soon,fail=1

# ParaView's pvpython cannot be installed beside libvtk9-dev, which needs python3-vtk9. Unpacked beside it, it needs no
# root.
.PHONY: paraview
paraview: build/paraview/pvpython ## ParaView, unpacked into build/paraview: its test is then no longer skipped
build/paraview/pvpython:
	@mkdir -p $(@D)/packages && cd $(@D)/packages && apt-get download paraview python3-paraview && \
	  for p in *.deb; do dpkg-deb --extract $$p .. || exit; done
	@printf '#!/bin/sh\nusr=$$(dirname "$$(readlink -f "$$0")")/usr\n%s exec "$$usr/bin/pvpython" "$$@"\n' \
	  'LD_LIBRARY_PATH="$$usr/lib/$(shell dpkg-architecture -qDEB_HOST_MULTIARCH)"' > $@ && chmod +x $@

.PHONY: other-release
other-release: ## build and check on the other of Debian 12 and 13, and compare bytes (as root; WHOLE=1: every study)
	@tests/releases.sh

.PHONY: other-processor
other-processor: ## unit tests on aarch64, emulated, with the same bits (needs g++-aarch64-linux-gnu and qemu-user-static)
	@tests/processors.sh

.PHONY: soak
soak: $(TOOLS) $(B)/tests/soak ## runs killed at hundreds of moments and on failing disks, and a million steps at rest (minutes)
	@BIN=$(CURDIR)/$(B)/bin bash tests/soak/faults.sh
	@SOILWEAVE_TEST_LIMIT=7200 $(B)/tests/soak --gtest_brief=1

.PHONY: hostile
hostile: $(TOOLS) ## 5000 hostile inputs to every reader and option; failing ones are kept in build/hostile (minutes)
	@$(or $(PYTHON),/usr/bin/python3) tests/fuzz/hostile.py --bin $(CURDIR)/$(B)/bin --jobs $(JOBS)

.PHONY: soils
soils: $(TOOLS) ## ten soils at four void ratios, each packed at the first command (minutes)
	@BIN=$(CURDIR)/$(B)/bin OUT=$(CURDIR)/$(B)/soils JOBS=$(JOBS) bash tests/soils.sh

.PHONY: fuzz fuzz-targets
fuzz-targets: $(FUZZED)
fuzz: $(TOOLS) hostile ## every reader under libFuzzer, FUZZ_TIME=600 s each (needs clang)
	@command -v clang++ > /dev/null || { echo "make fuzz: clang++ is missing; run: apt-get install clang" >&2; exit 1; }
	@$(AGAIN) FUZZ=1 fuzz-targets
	@BIN=$(CURDIR)/$(BIN) tests/fuzz/run.sh $(FUZZED:$(B)/%=$(CURDIR)/build/fuzz/%)

.PHONY: golden
golden: $(B)/tests/unit ## print the tables of lib/files/FORMAT.md anew from schema and series; review them with git diff
	@SOILWEAVE_GOLDEN=write $< --gtest_brief=1 --gtest_filter='*WhatThePageSays'

.PHONY: pages
pages: $(TOOLS) ## print the keys of the tools into the pages of lib/ anew; review them with git diff
	@BIN=$(B)/bin bash tests/pages.sh write

.PHONY: bench
bench: $(B)/tests/bench ## time the hot loops with Google Benchmark
	@$(B)/tests/bench $(BENCH_FLAGS)

.PHONY: bench-size
bench-size: $(B)/tests/bench ## cost of a step from a thousand grains to a million, memory, small systems on two threads
	@BENCH=$(CURDIR)/$(B)/tests/bench OUT=$(CURDIR)/$(B)/bench bash tests/benchmarks/size.sh

.PHONY: bench-studies
bench-studies: $(TOOLS) ## time and memory of the largest studies at the thesis's size (an hour; PARTS="bag shape pullout")
	@BIN=$(CURDIR)/$(B)/bin OUT=$(CURDIR)/$(B)/bench/studies bash tests/benchmarks/studies.sh

.PHONY: bench-peers
bench-peers: $(TOOLS) ## steps per second beside YADE, LAMMPS and LIGGGHTS, where they are, on the same packings
	@BIN=$(CURDIR)/$(B)/bin bash tests/crosscheck/speed.sh

.PHONY: crosscheck
crosscheck: $(TOOLS) ## the same contact paths and packings with a peer code, live and recorded, where there is one
	@BIN=$(CURDIR)/$(B)/bin bash tests/crosscheck/run.sh
	@BIN=$(CURDIR)/$(B)/bin JOBS=$(JOBS) bash tests/crosscheck/recorded.sh
	@BIN=$(CURDIR)/$(B)/bin JOBS=$(JOBS) bash tests/crosscheck/packings.sh
	@BIN=$(CURDIR)/$(B)/bin bash tests/crosscheck/truth.sh

.PHONY: crosscheck-band
crosscheck-band: $(TOOLS) ## ten hidden soils through make own: how often its range holds what their bags carry (hours)
	@BIN=$(CURDIR)/$(B)/bin bash tests/crosscheck/band.sh

.PHONY: crosscheck-toyoura
crosscheck-toyoura: $(TOOLS) ## Toyoura sand through make own, beside the thesis's constants and chart (half an hour)
	@BIN=$(CURDIR)/$(B)/bin PROFILE=$(PROFILE) bash tests/crosscheck/toyoura.sh

# ---- Habits ---------------------------------------------------------------------------------------------------------
# Versions of clang-format differ in details of the layout; one decides.
LAYOUT := 14
CLANG_FORMAT = $(firstword $(foreach f,clang-format-$(LAYOUT) clang-format,$(if $(findstring version $(LAYOUT).,$(shell $f --version 2>/dev/null)),$f)))

.PHONY: format
format: ## lay out every source with clang-format (version 14, of Debian 12)
	@$(if $(CLANG_FORMAT),$(CLANG_FORMAT) -i $(SOURCES) $(HEADERS),echo "make format: clang-format $(LAYOUT) lays out the sources; it is not installed" >&2; exit 1)

.PHONY: format-check
format-check:
	@$(if $(CLANG_FORMAT),$(CLANG_FORMAT) --dry-run --Werror $(SOURCES) $(HEADERS) && echo "== format: clean",\
	  $(call skip,format,layout of the sources,clang-format $(LAYOUT) decides it$(comma) and is not installed))

# clang-tidy reads the sources of several folders as one, because most of its time goes into headers of libraries, and leaves a
# stamp per group. Folders of a group have namespaces of their own, or unlike names. The larger group takes 3 GB of memory.
TIDY_GROUPS := core+store+files+display+tools dem+analysis+packing+calibration+gws+fem
# It runs without OpenMP, because neither clang-tidy nor all versions of the compiler have an omp.h that it reads.
TIDY_FLAGS = -std=c++20 $(ARCHITECTURE) -Wall -Wextra -Wpedantic -Wno-unknown-pragmas -Wno-unknown-warning-option $(CLANG_ONLY)
TIDY_SOURCES := $(if $(NO_VTK),$(LIB),$(filter-out $(MPI_ONLY),$(LIB_ALL))) $(TOOL)
group_of = $(or $(strip $(foreach g,$(TIDY_GROUPS),$(if $(filter $(1),$(subst +, ,$g)),$g))),$(1))
tidied_with = build/lint/$(call group_of,$(if $(filter lib/%,$(1)),$(word 2,$(subst /, ,$(1))),tools)).tidy
TIDY := $(sort $(foreach f,$(TIDY_SOURCES),$(call tidied_with,$(f))))
build/lint/%.tidy: .clang-tidy | $(LISTS:%=$(B)/lists/%.h)
	@mkdir -p $(@D)
	@echo '  tidy  $*'
	@for f in $(filter $(TIDY_SOURCES),$^); do n=$$(basename $$f .cpp); \
	  printf '#define main %s_main\n#include "%s"\n#undef main\n' "$${n//-/_}" "$$f"; done > build/lint/$*.cpp
	@clang-tidy --quiet build/lint/$*.cpp -- -I. -I$(B) $(CPPFLAGS) $(VTK_CPPFLAGS) $(TIDY_FLAGS) 2>$@.log || { cat $@.log >&2; exit 1; }
	@$(CXX) -std=c++20 $(ARCHITECTURE) -fopenmp -I. -I$(B) $(CPPFLAGS) $(VTK_CPPFLAGS) -MM -MP -MT $@ -MF $@.d build/lint/$*.cpp && touch $@
$(foreach f,$(TIDY_SOURCES),$(eval $(call tidied_with,$(f)): $(f)))
-include $(addsuffix .d,$(TIDY))

# columns8.h, lanes8.h, lanes_x86.h and lanes_portable.h are parts of the headers that include them.
WHOLE := $(filter-out lib/core/simd/columns8.h lib/core/simd/lanes8.h lib/core/simd/lanes_%.h,$(HEADERS))

.PHONY: lint
lint: $(TIDY) build/lint/shellcheck build/lint/workflows warnings ## clang-tidy, shellcheck, warnings of the compiler, include direction, headers, file sizes, comments
	@bash tests/layers.sh && $(PYTHON) tests/headers.py && $(PYTHON) tests/comments.py && echo "== lint: clean"

# Compiles each header alone. This takes minutes on two cores, so that checks run tests/headers.py instead.
ALONE := $(patsubst %,$(B)/headers/%.alone,$(WHOLE))
.PHONY: headers
headers: $(ALONE) ## compile each header of the library and the tests alone (minutes)
	@echo "== headers: clean"
$(B)/headers/%.alone: % $(B)/flags | $(LISTS:%=$(B)/lists/%.h)
	@mkdir -p $(@D)
	@echo '  c++   $< (alone)'
	@$(CXX) $(CPPFLAGS) -Itests $(CXXFLAGS) -Werror -I$(B) -include $< -fsyntax-only -MMD -MP -MT $@ -MF $@.d -x c++ /dev/null && touch $@
-include $(addsuffix .d,$(ALONE))

# Prints the compiler's warnings about the present sources, where it has compiled them.
.PHONY: warnings
warnings:
	@found=0; for tree in build build/sanitize; do for source in $(SOURCES); do \
	  for log in $$tree/obj/$${source%.cpp}{,.avx512,.eight}.o.warnings; do \
	    if [ -s $$log ] && [ $$log -nt $$source ]; then cat $$log >&2; found=1; fi; done; done; done; \
	for log in $$(find build/obj build/sanitize/obj -name '*.o.warnings' -size +0 2> /dev/null | grep -E '/(units/[^/]+|tests_[0-9]+)\.o\.'); do \
	  sources=$$(sed -nE 's/^#(include|line 1) "(.*\.cpp)"$$/\2/p' $${log%.o.warnings}.cpp); \
	  [ -n "$$(find $$sources -newer $$log)" ] || { cat $$log >&2; found=1; }; done; exit $$found

# Workflows of hosted machines have to be YAML whose jobs each have steps.
build/lint/workflows: $(wildcard .github/workflows/*.yml)
	@mkdir -p $(@D)
	@$(PYTHON) -c 'import sys, yaml; [job["steps"] for f in sys.argv[1:] for job in yaml.safe_load(open(f))["jobs"].values()]' $^ && touch $@

build/lint/shellcheck: $(SCRIPTS)
	@mkdir -p $(@D)
	@$(if $(SCRIPTS),shellcheck -x $(SCRIPTS)) && touch $@

.PHONY: coverage
coverage: ## lines of lib/ that the tests run (report in build/coverage/report); fails under 90 %
	@$(AGAIN) COVERAGE=1 programs
	@find build/coverage -name '*.gcda' -delete
	@$(AGAIN) COVERAGE=1 test
	@$(AGAIN) COVERAGE=1 test-tools
	@mkdir -p build/coverage/report
	@gcovr --root . --filter lib/ --object-directory build/coverage/obj -j $(JOBS) --exclude-unreachable-branches \
	  --print-summary --html-details build/coverage/report/index.html --txt build/coverage/report/lines.txt \
	  --fail-under-line 90 build/coverage/obj; status=$$?; tail -3 build/coverage/report/lines.txt; exit $$status

compile_commands.json: Makefile $(B)/sources $(LISTS:%=$(B)/lists/%.h) ## for editors and clang tools
	@{ echo '['; first=1; for f in $(SOURCES); do [ $$first ] || echo ','; first=; \
	  printf '{"directory": "%s", "file": "%s", "command": "%s -c %s"}' '$(CURDIR)' "$$f" \
	  '$(CXX) $(CPPFLAGS) $(VTK_CPPFLAGS) -Itests -I$(B) $(CXXFLAGS)' "$$f"; done; echo; echo ']'; } > $@

# ---- Manual pages and installation ----------------------------------------------------------------------------------
MAN := $(TOOLS:$(B)/bin/%=build/man/%.1)
COMPLETION := $(TOOLS:$(B)/bin/%=build/completion/%)
build/man/plot.1 build/completion/plot: pipelines/study/command.py pipelines/study/kinds.py

.PHONY: man
man: $(MAN) ## manual pages, from the option tables, into build/man
build/man/%.1: $(B)/bin/%
	@mkdir -p $(@D) && $< --man > $@
build/completion/%: $(B)/bin/%
	@mkdir -p $(@D) && $< --completion > $@

.PHONY: test-man
test-man: $(MAN)
	@command -v man >/dev/null && command -v groff >/dev/null || { $(call skip,man,manual pages,no man or groff is installed); exit 0; }; \
	for page in $(MAN); do \
	  said=$$(LC_ALL=C.UTF-8 MANROFFSEQ= MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z $$page 2>&1 >/dev/null); \
	  [ -z "$$said" ] || { echo "$$page: $$said" >&2; exit 1; }; done && echo "== man pages: clean"

.PHONY: install
install: all $(MAN) $(COMPLETION) ## tools, manual pages and completion into DESTDIR/PREFIX (/usr/local)
	install -d '$(DESTDIR)$(PREFIX)/bin' '$(DESTDIR)$(PREFIX)/share/man/man1' \
	  '$(DESTDIR)$(PREFIX)/share/bash-completion/completions'
	install -m 755 $(TOOLS) '$(DESTDIR)$(PREFIX)/bin'
	install -m 644 $(MAN) '$(DESTDIR)$(PREFIX)/share/man/man1'
	install -d '$(DESTDIR)$(PREFIX)/share/soilweave/geotextiles' '$(DESTDIR)$(PREFIX)/share/soilweave/soils'
	install -m 644 data/geotextiles/*.toml '$(DESTDIR)$(PREFIX)/share/soilweave/geotextiles'
	install -m 644 data/soils/*.toml '$(DESTDIR)$(PREFIX)/share/soilweave/soils'
	install -m 644 $(COMPLETION) '$(DESTDIR)$(PREFIX)/share/bash-completion/completions'
	install -d '$(DESTDIR)$(PREFIX)/share/soilweave/python/study'
	install -m 644 pipelines/study/*.py '$(DESTDIR)$(PREFIX)/share/soilweave/python/study'

.PHONY: uninstall
uninstall: ## remove from DESTDIR/PREFIX the files that install puts there
	rm -f $(foreach t,$(TOOLS:$(B)/bin/%=%),$(foreach f,bin/$t share/man/man1/$t.1 share/bash-completion/completions/$t,'$(DESTDIR)$(PREFIX)/$f'))
	rm -f $(foreach f,$(patsubst data/%,%,$(wildcard data/geotextiles/*.toml data/soils/*.toml)) $(patsubst pipelines/%,python/%,$(wildcard pipelines/study/*.py)),\
	  '$(DESTDIR)$(PREFIX)/share/soilweave/$f')
	@for d in soilweave/python/study soilweave/python soilweave/geotextiles soilweave/soils soilweave; do \
	  [ ! -d '$(DESTDIR)$(PREFIX)/share/'$$d ] || rmdir --ignore-fail-on-non-empty '$(DESTDIR)$(PREFIX)/share/'$$d || exit; done

# Installed tools find their data and the package of plot. uninstall removes nothing else. The path has a blank, as paths may have.
INSTALLED := build/a root
.PHONY: test-install
test-install: all $(MAN) $(COMPLETION)
	@rm -rf '$(INSTALLED)' && $(AGAIN) -s install 'DESTDIR=$(CURDIR)/$(INSTALLED)' PREFIX=/usr && cd '$(INSTALLED)/usr' && \
	  touch bin/other share/soilweave/soils/mine.toml && \
	  for tool in bin/*; do [ $$tool = bin/other ] || env -u SOILWEAVE_DATA PATH=/usr/bin:/bin ./$$tool --version > /dev/null || exit; done && \
	  env -u SOILWEAVE_DATA ./bin/gws-solve respond --soil toyoura-gws --geotextile PE --surcharge 1e5 --quiet > /dev/null && \
	  $(MAKE) -s --no-print-directory -C '$(CURDIR)' uninstall 'DESTDIR=$(CURDIR)/$(INSTALLED)' PREFIX=/usr && \
	  [ "$$(find . -type f | LC_ALL=C sort | xargs)" = "./bin/other ./share/soilweave/soils/mine.toml" ] && [ ! -e share/soilweave/python ] || \
	  { echo "make test-install: files are left, or a tool does not work" >&2; exit 1; }
	@echo "== install and uninstall: clean"

# ---- Studies --------------------------------------------------------------------------------------------------------
# pipelines/study.mk adds each study to STUDIES and gives it a target of its name; report collects them.
STUDIES :=
-include pipelines/study.mk

.PHONY: reproduce
reproduce: ## install what is missing, build, run every study (PROFILE=quick) and write the report
	@$(AGAIN) deps
	@$(AGAIN) all
	@before=$$(ls $(OUT)/*/page.html 2> /dev/null | wc -l); began=$$SECONDS; \
	  $(AGAIN) $(STUDIES) && echo "$$((SECONDS - began)) $$(nproc) $$before" > $(OUT)/took
	@$(AGAIN) report

# ---- The rest -------------------------------------------------------------------------------------------------------
.PHONY: clean
clean: ## remove build/ and what was generated beside it
	rm -rf build compile_commands.json

.PHONY: help
help: ## this list
	@grep -hE '^[a-z0-9_.-]+:.*## ' $(MAKEFILE_LIST) | grep -v '\.d:' | sort -u | \
	  awk -F ':.*## ' '{ printf "  %-22s %s\n", $$1, $$2 }'
