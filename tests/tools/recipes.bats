#!/usr/bin/env bats
# The recipes of pipelines/recipes/README.md run unchanged, and their results are sound.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

ROOT=$BATS_TEST_DIRNAME/../..

@test "each recipe of the page of recipes runs as it stands" {
  cd "$BATS_TEST_TMPDIR" || return
  command -v parallel >/dev/null || skip "GNU parallel is not installed"
  local folder command count=0
  for folder in data pipelines tests; do ln -s "$ROOT/$folder" "$folder"; done
  while IFS= read -r command; do
    # The examples of run-dem press this bag already (help.bats).
    [[ $command != *press.toml* ]] || command="${command% -o *} --check"
    bash -o pipefail -c "$command" 2> said || show "$command" "$(cat said)"
    count=$((count + 1))
  done < <(awk '/^    [^# ]/ { sub(/^ +/, ""); print }' "$ROOT/pipelines/recipes/README.md")
  [[ $count -eq 15 ]] || show "$count recipes"
  # Undrained, the volume stays; in the box, the lid sinks under each load.
  table '{ v = c("strain_volumetric"); if (v * v > 1e-8 && c("stage") == 1) bad = 1 } END { exit bad }' undrained.tsv || show "$(cat undrained.tsv)"
  homogenize oedometer.h5 --table series --tsv --quiet > oedometer.tsv
  holds 'low < first && high > 340 && high < 380' "low=$(value oedometer.tsv displacement_top_z last)" "first=$(value oedometer.tsv displacement_top_z 3)" \
    "high=$(value oedometer.tsv force_top_z last)"
  # The box is not periodic: its series has no stress, and a volume among its grains is drawn instead.
  mentions 65 plot "homogenize RUN --table volumes --box" e-log-p oedometer.h5 -o e.svg
  homogenize oedometer.h5 --table volumes --box=-0.02,0.02,-0.02,0.02,-0.015,0.005 --tsv > volume.tsv
  exits 0 plot e-log-p volume.tsv -o e.svg
  exits 0 plot stress-strain volume.tsv -o s.svg
  exits 0 homogenize oedometer.h5 --table series --tsv --columns force_top_z
  [[ -z $stderr ]] || show "a doubt about columns that are not printed"
  exits 0 homogenize oedometer.h5 --table series --tsv --columns stage,stress_zz
  [[ $stderr == "homogenize: doubt: the cell is not periodic along all axes"*"--table volumes with a --box"* ]] || show
  # A lid that begins where the first run began, and not where it ended, leaves the grains below it.
  exits 0 run-dem oedometer.h5 pipelines/recipes/oedometer.toml --check
  [[ $stderr == *'doubt: plane "top" starts 0.00'*'m behind its place at the end of the input'* ]] || show
}
