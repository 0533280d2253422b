#!/bin/bash
# Runs every row of an ensemble's table, one row one job one folder: by GNU parallel on this machine or on those of
# SSHLOGINFILE, which see the same folder, or as a Slurm array job (ENGINE=slurm). Stopped at any point, it goes on with the rows
# that are missing. Rows that will fail each time are listed and stay failed; other trouble is tried again, then told.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: BIN=build/bin ensemble.sh TABLE.tsv FOLDER LAW PACKING SCENARIO PRESSURE_MPa STRAIN_%
# TABLE: id, E, nu, kr, eta and mu, separated by tabs; ids are whole numbers, with leading zeros or without.
set -euo pipefail
export LC_ALL=C.UTF-8
name=$(basename "$1" .tsv)
table=$2/$name.rows folder=$2 law=$3 packing=$4 scenario=$5 pressure=$6 strain=$7
common=("${@:2}")
here=$(dirname "$0")
joblog=$folder/$name.joblog
log=$joblog
[[ $log == /* ]] || log=./$log  # awk takes a file a=b for an assignment, and ./a=b for a file
mkdir -p "$folder/runs"

# One at a time: jobs of a make that was killed may still be under way, and their results count.
exec 9> "$folder/lock"
flock -n 9 || { echo "  $folder: waiting for runs that are still under way" >&2; flock 9; }
file=$1 awk -v columns=6 -f "$here/../rows.awk" < "$1" > "$table"

# Results of other inputs, programs or scenarios are not resumed from.
key=$(cat "$packing" "$scenario" "$here/run.sh" "$BIN/run-dem" "$BIN/homogenize" | sha256sum)
if [[ $(cat "$folder/key" 2>/dev/null) != "$key" ]]; then
  rm -rf "$folder/runs" "$folder"/*.joblog
  mkdir -p "$folder/runs"
  printf '%s\n' "$key" > "$folder/key"
fi

# unfinished: the lines of the table, from 1, whose rows have neither result nor failure with these parameters.
unfinished() {
  local line=0 id modulus ratio rolling limit friction row
  while IFS=$'\t' read -r id modulus ratio rolling limit friction _; do
    ((line++)) || continue
    row=$folder/runs/$(printf %06d "$id")
    if [[ -e $row/series.h5 || -e $row/failed ]] &&
      [[ $(cat "$row/parameters") == "$law $pressure $strain $modulus $ratio $rolling $limit $friction 0" ]]; then
      continue
    fi
    echo $((line - 1))
  done < "$table"
}

rows=$(($(wc -l < "$table") - 1))
mapfile -t unrun < <(unfinished)
first=$(sed -n 2p "$table" | cut -f 1)
printf '%s %s %s %s\n' "$first" "$rows" $((rows - ${#unrun[@]})) "$(date +%s)" > "$folder/progress"
rm -f "$folder/told"

if ((${#unrun[@]} > 0)); then
  echo "  run   $folder $name: ${#unrun[@]} of $rows rows"
  if [[ ${ENGINE:-parallel} == slurm ]]; then
    printf '%s\n' "${unrun[@]}" > "$folder/$name.unrun"
    "$here/slurm.sh" "$table" "$folder/$name.unrun" "${common[@]}"
  else
    # The joblog keeps whole lines of rows that have their result: a killed machine may leave half a line, a user take a
    # folder away.
    if [[ -e $joblog ]]; then
      printf '%s\n' "${unrun[@]}" | awk -F '\t' 'NR == FNR { unrun[$1] = 1; next } FNR == 1 || (NF >= 9 && !($1 in unrun))' \
        - "$log" > "$joblog.part" && mv "$joblog.part" "$joblog"
    fi
    export BIN
    # --quote: names of folders and files reach run.sh as they are, whatever is in them.
    parallel --quote --header : --colsep '\t' --jobs "${JOBS:-100%}" --joblog "$joblog" --resume-failed --retries 3 \
      ${SSHLOGINFILE:+--sshloginfile "$SSHLOGINFILE" --workdir "$PWD"} --env BIN \
      "$here/run.sh" "${common[@]}" '{1}' '{2}' '{3}' '{4}' '{5}' '{6}' :::: "$table" || true
  fi
fi

mapfile -t unrun < <(unfinished)
failed=0
while IFS=$'\t' read -r id _; do
  [[ $id == id* ]] && continue
  file=$folder/runs/$(printf %06d "$id")/failed
  [[ -e $file ]] || continue
  ((failed++)) || echo "  $folder $name: rows that failed, with the reason:"
  ((failed <= 10)) && echo "    $id: $(head -n 1 "$file")"
done < "$table"
((failed <= 10)) || echo "    and $((failed - 10)) more (FOLDER/runs/*/failed)"
if [[ -s $joblog ]]; then
  awk -F '\t' -v failed="$failed" -v name="$folder $name" '
    FNR > 1 { ++rows; if ($4 > 0) { seconds += $4; ++runs } }
    END { printf "  %s: %d runs, %d failed%s\n", name, rows, failed,
      seconds ? sprintf(", %.0f runs per hour and core", 3600 * runs / seconds) : "" }' "$log"
fi
if ((${#unrun[@]} > 0)); then
  echo "$folder: ${#unrun[@]} rows did not finish (see $joblog); make again tries them" >&2
  exit 1
fi
