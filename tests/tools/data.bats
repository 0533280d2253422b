#!/usr/bin/env bats
# The data that studies read are the described ones, and kept results are compared anew.
# SPDX-License-Identifier: GPL-3.0-or-later

setup() {
  cd "$BATS_TEST_DIRNAME/../.." || return 1
  export LC_ALL=C.UTF-8
}

@test "every file under data/ has its digest and line in SOURCES.md" {
  run sh tests/data.sh
  [ "$status" -eq 0 ]
  [ "$output" = "== data: as described" ]
}

# german: sets a locale whose numbers have decimal commas, or skips the test.
german() {
  localedef -i de_DE -f UTF-8 "$BATS_TEST_TMPDIR/de_DE.UTF-8" 2> /dev/null || skip "no sources of locales here"
  export LOCPATH=$BATS_TEST_TMPDIR LC_ALL=de_DE.UTF-8
  [ "$(env printf '%.1f' 1,5 2> /dev/null)" = "1,5" ] || skip "the locale does not take hold"
}

@test "make gives what it runs the locale that tables are written in" {
  german
  printf 'include %s/Makefile\nlocale-of-recipes:\n\t@awk "BEGIN { print 1 / 4, 1000 * 0.5 }"\n' "$PWD" > "$BATS_TEST_TMPDIR/locale.mk"
  run env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make --no-print-directory -f "$BATS_TEST_TMPDIR/locale.mk" locale-of-recipes
  [ "${lines[-1]}" = "0.25 500" ]
}

@test "what is kept of the studies is compared as its statements and tables now are" {
  cp -r pipelines/ch6/kept "$BATS_TEST_TMPDIR/6"
  env -u MAKEFLAGS -u MAKELEVEL make --no-print-directory -s OUT="$BATS_TEST_TMPDIR/out" "C6_KEPT=$BATS_TEST_TMPDIR/6" ch6-compare
  for table in pipelines/ch6/kept/c[oh]*.tsv; do cmp "$table" "$BATS_TEST_TMPDIR/6/${table##*/}"; done
}
