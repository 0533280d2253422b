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
  for chapter in 3 6; do
    cp -r "pipelines/ch$chapter/kept" "$BATS_TEST_TMPDIR/$chapter"
    env -u MAKEFLAGS -u MAKELEVEL make --no-print-directory -s OUT="$BATS_TEST_TMPDIR/out" "C${chapter}_KEPT=$BATS_TEST_TMPDIR/$chapter" "ch$chapter-compare"
    for table in "pipelines/ch$chapter"/kept/c[oh]*.tsv; do cmp "$table" "$BATS_TEST_TMPDIR/$chapter/${table##*/}"; done
  done
}

@test "new lines of variants replace those of their name, others stay, those of another bag are refused, unless none of them stays" {
  cd "$BATS_TEST_TMPDIR" || return
  local merge=$BATS_TEST_DIRNAME/../../pipelines/ch3/merge.awk
  printf 'variant\tload\nbag\t1\nfast\t2\n' > new.tsv
  printf 'variant\tload\nbag\t1\nfast\t9\nseed_2\t5\n' > kept.tsv
  run awk -f "$merge" new.tsv kept.tsv
  [ "$output" = $'variant\tload\nbag\t1\nfast\t2\nseed_2\t5' ]
  printf '== fast\nnew\n' > new.txt
  printf '== fast\nold\n== seed_2\nkept\n' > kept.txt
  run awk -f "$merge" new.txt kept.txt
  [ "$output" = $'== fast\nnew\n== seed_2\nkept' ]
  sed -i 's/^bag.*/bag\t3/' kept.tsv
  run awk -f "$merge" new.tsv kept.tsv
  [ "$status" -eq 1 ]
  [[ "$output" == *"kept.tsv is of another bag"* ]]
  sed -i '/^seed_2/d' kept.tsv
  run awk -f "$merge" new.tsv kept.tsv
  [ "$output" = "$(cat new.tsv)" ]
}

@test "bags beside one another: a column each, mean and deviation of those that have a value, the first of them apart" {
  cd "$BATS_TEST_TMPDIR" || return
  local beside=$BATS_TEST_DIRNAME/../../pipelines/ch3/beside.awk bag
  mkdir bag one two
  for bag in bag:9 one:1 two:4; do
    printf 'description\tunit\tpublished\ttolerance\tmeasured\nload\tkPa\t3\t1\t%s\nfailure\t%%\t3\t1\t1\n' "${bag#*:}" > "${bag%:*}/comparison.tsv"
  done
  printf 'slope\t1\t2\t1\t7\n' >> bag/comparison.tsv
  run awk -v leave=failure -v scatter=1 -v apart=1 -f "$beside" bag/comparison.tsv one/comparison.tsv two/comparison.tsv
  [ "$output" = $'description\tunit\tpublished\ttolerance\tbag\tone\ttwo\tmean\tdeviation
load\tkPa\t3\t1\t9\t1\t4\t2.5\t2.1
slope\t1\t2\t1\t7\tnone\tnone\tnone\tnone' ]
  run awk -v leave=failure -v scatter=1 -f "$beside" bag/comparison.tsv one/comparison.tsv two/comparison.tsv
  [ "${lines[1]}" = $'load\tkPa\t3\t1\t9\t1\t4\t4.667\t4' ]
  [ "${lines[2]}" = $'slope\t1\t2\t1\t7\tnone\tnone\t7\tnone' ]
}
