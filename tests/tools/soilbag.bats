#!/usr/bin/env bats
# The quick bag of pipelines/ch3, as its study makes and loads it.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

ROOT=$BATS_TEST_DIRNAME/../..

# study VARIABLE=VALUE... TARGET...: files of the study under $BATS_FILE_TMPDIR, by these tools.
study() {
  env -u MAKEFLAGS -u MAKELEVEL make --no-print-directory -s -C "$ROOT" BIN="$BIN" OUT="$BATS_FILE_TMPDIR" PROFILE=quick "$@" >&2
}

# A bag must widen as it is compressed, against the inertia of its scaled density. What counts is speed times the root of density, so
# that 2 %/s at a thousandfold density, at which variants are compressed, are the thesis's 10 %/s at fortyfold, and the slower is its
# 1 %/s. Grains meet otherwise each time: single stations differ by 2 to 3 %.
@test "loaded ten times slower, a bag carries the same" {
  local of=$BATS_FILE_TMPDIR/ch3/variants
  study C3V_UC='--set stage.1.strain=0.06' "$of/bag/uc_PE.tsv" "$of/slower/uc_PE.tsv"
  awk -F '\t' 'FNR == 1 { for (i = 1; i <= NF; ++i) { sub(/ \[.*/, "", $i); at[$i] = i } station = 0; next }
      $at["stage"] == 0 { next }
      NR == FNR { stress[++stations] = $at["soil_stress_zz"]; next }
      { d = stress[++station] / $at["soil_stress_zz"] - 1; print d; all += d / stations; if (d < 0) d = -d; if (d > most) most = d }
      END { print all, most; exit !(stations == 6 && station == 6 && all < 0.02 && all > -0.02 && most < 0.05) }' \
    "$of/bag/uc_PE.tsv" "$of/slower/uc_PE.tsv" || show "loads differ"
}
