#!/usr/bin/env bats
# Tests of the assertions in common.bash: missing values and non-numbers must fail.
# SPDX-License-Identifier: GPL-3.0-or-later

setup() {
  load common
  cd "$BATS_TEST_TMPDIR" || exit 1
  printf 'step [1]\tload [N]\n1\t2.5\n2\tnan\n' > series.tsv
  printf 'step [1]\n' > empty.tsv
}

# fails COMMAND...: demands that the command fails.
fails() {
  run "$@"
  [[ $status -ne 0 ]] || show "did not fail: $*"
}

@test "numbers are near only where both are numbers" {
  near 1.001 1 2e-3
  near -1e-3 -.001 0
  local other
  for other in '' nan -nan inf word '1 2' 1e; do
    fails near "$other" "$other" 1
    fails near 1 "$other" 1
    fails near "$other" 1 1e9
  done
  fails near 1 1 ''
  fails near 1.01 1 1e-3
  holds 'x < 1 && y > 1' x=0.5 y=2
  fails holds 'x < 1' x=1
  fails holds 'x < 1' x=
  fails holds 'x == x' x=nan
}

@test "what is not in a table is no value" {
  [[ $(value series.tsv load 1) == 2.5 && $(value series.tsv step last) == 2 ]]
  local wanted
  for wanted in 'series.tsv mass 1' 'series.tsv load 3' 'empty.tsv step 1' 'empty.tsv step last' 'none.tsv step 1'; do
    # shellcheck disable=SC2086  # file, column and row
    fails value $wanted
    # shellcheck disable=SC2086
    fails near "$(value $wanted 2>/dev/null)" "$(value $wanted 2>/dev/null)" 1
  done
  fails near "$(value series.tsv load last)" "$(value series.tsv load last)" 1
  [[ $(value series.tsv mass 1 2>/dev/null) != "$(value empty.tsv mass 1 2>/dev/null)" ]]
  table '{ sum += c("step") } END { exit sum != 3 }' series.tsv
  fails table '{ sum += c("load") } END { exit 0 }' series.tsv
  fails table '{ sum += c("mass") } END { exit 0 }' series.tsv
  fails table 'END { exit 0 }' empty.tsv
}

@test "nothing is neither the same as nothing nor something else" {
  same_text <(echo one) <(echo one)
  other_text <(echo one) <(echo two)
  fails same_text <(true) <(true)
  fails same_text <(echo one) <(echo two)
  fails other_text <(echo one) <(true)
  fails other_text <(echo one) <(echo one)
  same_bytes series.tsv <(cat series.tsv)
  other_bytes series.tsv empty.tsv
  : > nothing
  fails same_bytes nothing nothing
  fails same_bytes none none
  fails other_bytes series.tsv none
  fails other_bytes series.tsv series.tsv
}

@test "a refusal is tested in a folder where no other test writes" {
  mkdir here
  cd here
  refuses 64 run-dem "--keys yaml" --keys yaml
  local shared
  for shared in "$BATS_TEST_TMPDIR" "$BATS_TEST_DIRNAME"; do
    cd "$shared"
    fails refuses 64 run-dem "--keys yaml" --keys yaml
    [[ $output == *"refuses needs a folder below $BATS_TEST_TMPDIR, not $shared"* ]] || show "wanted the folder"
  done
}

@test "a test that hangs is stopped and named, what a check skips is listed" {
  {
    echo "setup() { BATS_TEST_DIRNAME=$BATS_TEST_DIRNAME; load $BATS_TEST_DIRNAME/common; }"
    echo '@test "sleeps in a grandchild" { run bash -c "sleep 100; true"; }'
    echo '@test "is left out" { skip "as an example"; }'
  } > hang.bats
  exits 1 env -i PATH=/usr/local/bin:/usr/bin:/bin BIN="$BIN" SOILWEAVE_TEST_LIMIT=1 bats --tap hang.bats
  [[ $output == *"not ok 1 sleeps in a grandchild"*"stopped, for it takes more than 1 s"*"ok 2 is left out # skip as an example"* ]] ||
    show "wanted the first stopped and the second skipped"
  printf 'unit\tA.b\tno data\ntools\tc\tno data\n' > skipped
  exits 0 awk -f "$BATS_TEST_DIRNAME/../skipped.awk" skipped
  [[ ${lines[1]} == "  no data (2): unit: A.b; tools: c" ]] || show "wanted one line for the reason"
  exits 0 awk -f "$BATS_TEST_DIRNAME/../skipped.awk" /dev/null
  [[ $output == *"everything passed, nothing was skipped" ]] || show "wanted nothing skipped"
}

@test "a test program stops and names what hangs, and notes what it skips" {
  local program=$BIN/../tests/benchmarks
  [[ -x $program ]] || skip "not built: make programs"
  exits 1 env SOILWEAVE_TRY_HANGING=1 SOILWEAVE_TEST_LIMIT=1 "$program" --gtest_filter='Harness.*'
  [[ $output == *"[  FAILED  ] Harness.HangsWhereAskedTo: stopped, for it takes more than 1 s" ]] || show "wanted the name"
  exits 0 env SOILWEAVE_TRY_SKIPPING=1 SOILWEAVE_SKIPPED=noted "$program" --gtest_filter='Harness.*'
  [[ $(< noted) == $'benchmarks\tHarness.SkipsWhereAskedTo\tasked to' ]] || show "$(< noted)"
}

@test "a comment without its subject is refused, and a licence that continues a sentence" {
  local check=$BATS_TEST_DIRNAME/../comments.py opening
  printf '// Volume of a sphere, m3. What follows\n// Of is a continuation.\nint a = 1'"'"'000;  // "Of" in quotes\nauto b = "// Of";\n' > sound.h
  printf '"""Returns it."""\nx = "# Of"  # value of x\n' > sound.py
  printf '# Sets it.\n# Of is a continuation.\nx = "y"  # m\n' > sound.toml
  exits 0 "$PYTHON" "$check" sound.h sound.py sound.toml
  local file said refused=(whole.h after.cpp whole.toml whole.py after.mk script.sh script.py sourced.bash docstring.py)
  for opening in 'Of a sphere, m3.' 'Those of a chunk.' 'That of the next one.' 'What is left.' 'The same in m.' 'Whose it is.'; do
    printf 'int a;\n\n/// %s\n' "$opening" > whole.h
    printf 'int a = 0;  // %s\n' "$opening" > after.cpp
    printf 'x = 1\n# %s\n' "$opening" | tee whole.toml > whole.py
    printf 'all: # %s\n' "$opening" > after.mk
    printf '#!/bin/bash\n# %s\n' "$opening" | tee script.sh > script.py
    printf '# shellcheck shell=bash\n# %s\n' "$opening" > sourced.bash
    printf 'def x():\n    """%s"""\n' "$opening" > docstring.py
    exits 1 "$PYTHON" "$check" sound.h "${refused[@]}"
    # shellcheck disable=SC2154  # stderr is set by call
    mapfile -t said <<< "$stderr"
    [[ ${#said[@]} -eq ${#refused[@]} ]] || show "wanted a line for each file"
    for file in "${!refused[@]}"; do
      [[ ${said[file]} == "${refused[file]}:"*" opens with "*"begin with the subject: $opening" ]] || show "wanted ${refused[file]} and the opening"
    done
  done
  printf '// Volumes of\n// grains. SPDX-License-Identifier: GPL-3.0-or-later\n' > glued.h
  exits 1 "$PYTHON" "$check" glued.h
  # shellcheck disable=SC2154  # stderr is set by exits
  [[ $stderr == "glued.h:2: the licence continues a sentence; put it on a line of its own" ]] || show "wanted the line"
}

@test "a source that compiles with the precompiled header alone is refused" {
  local check=$BATS_TEST_DIRNAME/../headers.py
  mkdir lib tests tools
  printf '#include <algorithm>\n\n#include <fmt/format.h>\n\nint a = std::max(1, 2);\nauto b = fmt::format("std::sort");\n' > lib/a.cpp
  exits 0 "$PYTHON" "$check"
  printf 'int a = std::max(1, 2);\n' > tools/b.cpp
  printf 'auto b = fmt::format("");\n' > tests/c.cpp
  printf '#include <Eigen/Core>\n\ndouble d = Eigen::Matrix3d::Identity().determinant();\n' > lib/d.cpp
  exits 1 "$PYTHON" "$check"
  [[ $stderr == *"tools/b.cpp: uses std::max and does not include <algorithm>"* ]] || show "wanted the name"
  [[ $stderr == *"tests/c.cpp: uses fmt and does not include <fmt/format.h>"* ]] || show "wanted the library"
  [[ $stderr == *"lib/d.cpp: uses .determinant() and does not include <Eigen/LU>"* ]] || show "wanted the member"
}
