#!/usr/bin/env bats
# The quick bag of pipelines/ch3, as its study makes and loads it.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

ROOT=$BATS_TEST_DIRNAME/../..

# study VARIABLE=VALUE... TARGET...: files of the study under $BATS_FILE_TMPDIR, by these tools.
study() {
  env -u MAKEFLAGS -u MAKELEVEL make --no-print-directory -s -C "$ROOT" BIN="$BIN" OUT="$BATS_FILE_TMPDIR" PROFILE=quick "$@" >&2
}

# A bag must widen as it is compressed, against the inertia of its scaled density. It lags behind plates of 10 %/s, by 6 % at 1 %. Plates
# slow down where the unbalanced force would be too large, so that the result does not depend on the given rate. The remaining difference
# is chance: three pairs of twins of such a bag, whose grains start a millionth of their radius apart, differ by at most 1.2 % in the mean
# of a station, and by 2.3 % in two of 24 stations.
@test "compressed ten times slower, a bag carries the same" {
  local of=$BATS_FILE_TMPDIR/ch3/variants
  study C3V_UC='--set stage.1.strain=0.03 --set record.strains=[0.03]' "$of/paced/uc_PE.tsv" "$of/slow_paced/uc_PE.tsv"
  PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$ROOT/pipelines "${PYTHON:-/usr/bin/python3}" -P -m ch3.variants rates "$of/paced" "$of/slow_paced" > "$of/rates.tsv"
  cat "$of/rates.tsv" >&2
  awk -F '\t' 'NR > 1 { ++stations; all += $4; d = $4 < 0 ? -$4 : $4; if (d > most) most = d }
      END { exit !(stations == 3 && all / stations < 1 && all / stations > -1 && most < 2) }' "$of/rates.tsv" || show "stresses differ"
}
