#!/usr/bin/env bats
# The data that studies read are the ones described, and the report's comparison can fail.
# SPDX-License-Identifier: GPL-3.0-or-later

setup() {
  cd "$BATS_TEST_DIRNAME/../.." || return 1
  export LC_ALL=C.UTF-8
}

# refused WORDS: the comparison stopped with one line that holds the words.
refused() {
  # shellcheck disable=SC2030,SC2031,SC2154  # status and output are set by run, each test is a shell of its own
  [ "$status" -eq 1 ]
  [[ "$output" == *"compare: "*"$1"* ]]
}

@test "every file under data/ has its digest and line in SOURCES.md" {
  run sh tests/data.sh
  [ "$status" -eq 0 ]
  [ "$output" = "== data: as described" ]
}

compare() {
  printf 'name\trelation\tpublished\ttolerance\tunit\tsource\tdescription\n%s\n' "$1" > "$BATS_TEST_TMPDIR/expected.tsv"
  printf 'name\tvalue\tdeviation\n%s\n' "$2" > "$BATS_TEST_TMPDIR/measured.tsv"
  run awk -v partial="${3-}" -f pipelines/compare.awk "$BATS_TEST_TMPDIR/expected.tsv" "$BATS_TEST_TMPDIR/measured.tsv"
}

@test "a measured value is met inside the tolerance and not met outside it" {
  compare $'e\twithin\t0.68\t0.002\t1\tthesis\tvoid ratio' $'e\t0.6815\t'
  [ "$(cut -f 7 <<< "${lines[1]}")" = "met" ]
  compare $'e\twithin\t0.68\t0.002\t1\tthesis\tvoid ratio' $'e\t0.6825\t'
  [ "$(cut -f 7 <<< "${lines[1]}")" = "not met" ]
}

@test "bounds hold on their own side only" {
  compare $'x\tat most\t1e-3\t\t1\texact\terror' $'x\t2e-3\t'
  [ "$(cut -f 7 <<< "${lines[1]}")" = "not met" ]
  compare $'x\tat least\t1e-3\t\t1\texact\terror' $'x\t2e-3\t'
  [ "$(cut -f 7 <<< "${lines[1]}")" = "met" ]
}

@test "a published value that was not measured stops the study, unless a part alone is compared" {
  compare $'x\tat most\t1e-3\t\t1\texact\terror' $'y\t2e-3\t'
  [ "$status" -eq 1 ]
  [[ "$output" == *"x is not in the measured values"* ]]
  compare $'x\tat most\t1e-3\t\t1\texact\terror' $'y\t2e-3\t' 1
  [ "$status" -eq 0 ]
  [ "${#lines[@]}" -eq 1 ]
  compare $'x\tat most\t1e-3\t\t1\texact\terror' $'x\t-nan\t'
  [ "$status" -eq 1 ]
}

@test "what is no finite number, no relation or no column is never met" {
  local value
  for value in nan NaN -nan inf 1e999 0,5 "" .; do
    compare $'x\tat least\t-1\t\t1\texact\terror' $'x\t'"$value"$'\t'
    refused "x is $value, not a number"
  done
  compare $'x\twithout\t1\t1\t1\texact\terror' $'x\t1\t'
  refused 'x: relation "without"; write within, at most or at least'
  compare $'x\twithin\t1\tnan\t1\texact\terror' $'x\t1\t'
  refused 'tolerance is "nan", not a number'
  compare $'x\twithin\tnan\t1\t1\texact\terror' $'x\t1\t'
  refused 'published is "nan", not a number'
  compare $'x\twithin\t1\t1\t1\texact' $'x\t1\t'
  refused "6 columns where 7 belong"
  printf 'name\tpublished\trelation\ttolerance\tunit\tsource\tdescription\n' > "$BATS_TEST_TMPDIR/expected.tsv"
  run awk -f pipelines/compare.awk "$BATS_TEST_TMPDIR/expected.tsv" "$BATS_TEST_TMPDIR/measured.tsv"
  refused 'column 2 is "published" where relation belongs'
}

@test "tables with the line ends of Windows are compared alike" {
  compare $'e\twithin\t0.68\t0.002\t1\tthesis\tvoid ratio\r' $'e\t0.6815\t\r'
  [ "$status" -eq 0 ]
  [ "$(cut -f 7 <<< "${lines[1]}")" = "met" ]
}

# german: sets a locale whose numbers have decimal commas, or skips the test.
german() {
  localedef -i de_DE -f UTF-8 "$BATS_TEST_TMPDIR/de_DE.UTF-8" 2> /dev/null || skip "no sources of locales here"
  export LOCPATH=$BATS_TEST_TMPDIR LC_ALL=de_DE.UTF-8
  [ "$(env printf '%.1f' 1,5 2> /dev/null)" = "1,5" ] || skip "the locale does not take hold"
}

@test "where numbers have decimal commas nothing is met by being cut at the point" {
  german
  compare $'e\twithin\t0.68\t0.002\t1\tthesis\tvoid ratio' $'e\t0.2\t'
  [[ "$output" != *$'\tmet\t'* ]]
  [ "$status" -eq 0 ] || refused "run it with LC_ALL=C.UTF-8"
}

@test "make gives what it runs the locale that tables are written in" {
  german
  printf 'include %s/Makefile\nlocale-of-recipes:\n\t@awk "BEGIN { print 1 / 4, 1000 * 0.5 }"\n' "$PWD" > "$BATS_TEST_TMPDIR/locale.mk"
  run env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make --no-print-directory -f "$BATS_TEST_TMPDIR/locale.mk" locale-of-recipes
  [ "${lines[-1]}" = "0.25 500" ]
}

@test "one of a run that is not made at this size is left out" {
  compare $'x\tat most\t1e-3\t\t1\texact\terror\ny\tat most\t1\t\t1\texact\tother' $'x\tnone\ny\t1\t'
  [ "$status" -eq 0 ]
  [ "${#lines[@]}" -eq 2 ]
  [ "$(cut -f 1 <<< "${lines[1]}")" = "other" ]
}

@test "what is kept of the studies is compared as its statements and tables now are" {
  command -v gnuplot > /dev/null || skip "no gnuplot"
  cp -r pipelines/ch6/kept "$BATS_TEST_TMPDIR/6"
  env -u MAKEFLAGS -u MAKELEVEL make --no-print-directory -s OUT="$BATS_TEST_TMPDIR/out" "C6_KEPT=$BATS_TEST_TMPDIR/6" ch6-compare
  for table in pipelines/ch6/kept/c[oh]*.tsv; do cmp "$table" "$BATS_TEST_TMPDIR/6/${table##*/}"; done
}
