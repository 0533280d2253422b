# Sourced by the cross-checks that run for long: ends them without GNU parallel, and sets `work` to the folder WORK, which is kept, or to
# a folder that is removed at the end.
# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
command -v parallel > /dev/null || { echo "crosscheck: no GNU parallel here; skipped"; exit 0; }
if [[ -n ${WORK:-} ]]; then
  mkdir -p "$WORK"
  work=$(cd "$WORK" && pwd)
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
