#!/bin/sh
# A line on how far the ensemble is, now and then: rows done and failed, time left, runs per hour.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: progress.sh FOLDER   (FOLDER/progress, as ensemble.sh leaves it: rows, rows done before, second of the beginning)
set -eu
export LC_ALL=C.UTF-8
folder=$1
[ -e "$folder/progress" ] || exit 0
now=$(date +%s)
last=$(cat "$folder/told" 2>/dev/null || echo 0)
[ $((now - ${last:-0})) -ge "${PROGRESS_INTERVAL:-15}" ] || exit 0
printf '%s\n' "$now" > "$folder/told.$$" && mv "$folder/told.$$" "$folder/told"
read -r first rows before start < "$folder/progress"
find "$folder/runs" -name series.h5 -o -name failed |
  awk -F / -v first="$first" -v rows="$rows" -v before="$before" -v spent="$((now - start))" -v name="$(basename "$folder")" '
    $(NF - 1) + 0 >= first && $(NF - 1) + 0 < first + rows { ++done; failed += $NF == "failed" }
    END {
      left = done > before ? spent * (rows - done) / (done - before) : 0
      printf "  %s: %d of %d runs, %d failed", name, done, rows, failed
      if (done > before) printf ", %s left, %.0f runs/h",
        left < 90 ? sprintf("%.0f s", left) : left < 5400 ? sprintf("%.0f min", left / 60) : sprintf("%.1f h", left / 3600),
        3600 * (done - before) / (spent > 0 ? spent : 1)
      print ""
    }' >&2
