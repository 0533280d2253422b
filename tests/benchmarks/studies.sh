#!/usr/bin/env bash
# Time and memory of the largest studies at the thesis's own size, and the gain of a second thread, compared with bars.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# make bench-studies. PARTS (default: bag shape pullout) names the parts. bag: the soilbag of 69,000 grains, made and compressed to
# 20 %, half an hour. shape and pullout: the first STRETCH (default 0.1) seconds of the two-scale examples on 128 elements, medians of
# ROUNDS (default 3) times on one thread and on two in turn. The figures hold only on two cores that nobody else uses. OUT (default
# build/bench/studies): folder of the runs and of studies.tsv. Exits with 1 where a bar is missed.
set -euo pipefail

top=$(cd "$(dirname "$0")/../.." && pwd)
parts=${PARTS:-bag shape pullout} stretch=${STRETCH:-0.1} rounds=${ROUNDS:-3}
BIN=$(cd "${BIN:-$top/build/bin}" && pwd)
out=${OUT:-$top/build/bench/studies}
mkdir -p "$out" && out=$(cd "$out" && pwd)
export LC_ALL=C.UTF-8
cd "$top"
rm -f "$out/studies.tsv"

# Wall time in s and the most memory of one process in GiB.
timed() {
  python3 -c 'import resource, subprocess, sys, time
start = time.monotonic()
status = subprocess.run(sys.argv[1:], stdout=sys.stderr).returncode
print(time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 2**20)
sys.exit(status)' "$@"
}
study=(env -u MAKEFLAGS make --no-print-directory PROFILE=thesis OUT="$out" BIN="$BIN" C3_THREADS=2)
# note WHAT VALUE UNIT RELATION BAR
note() { printf '%s\t' "$1" "$2" "$3" "${4-}" && printf '%s\n' "${5-}"; } >> "$out/studies.tsv"
median() { sort -g | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2 }'; }

bag() {
  local made loaded
  "${study[@]}" "$out/ch3/rv.h5" >&2
  rm -rf "$out"/ch3/bag.h5* "$out"/ch3/generation.tsv "$out"/ch3/uc_PE.h5*
  made=$(timed "${study[@]}" "$out/ch3/bag.h5")
  loaded=$(timed "${study[@]}" "$out/ch3/uc_PE.h5")
  note 'soilbag: generation' "$(awk '{ printf "%.1f", $1 / 60 }' <<< "$made")" min
  note 'soilbag: compression to 20 %' "$(awk '{ printf "%.1f", $1 / 60 }' <<< "$loaded")" min
  note 'soilbag: steps of the compression' \
    "$("$BIN/homogenize" "$out/ch3/uc_PE.h5" --table series --tsv | awk 'END { print $1 }')" 1
  note 'soilbag: both' "$(awk '{ t += $1 } END { printf "%.1f", t / 60 }' <<< "$made"$'\n'"$loaded")" min 'at most' 40
  note 'soilbag: memory' "$(awk '$2 > m { m = $2 } END { printf "%.2f", m }' <<< "$made"$'\n'"$loaded")" GiB 'at most' 1
}

scales() { # EXAMPLE PACKING
  local threads one two
  "${study[@]}" "$out/ch6/$2.h5" >&2
  rm -f "$out/$1"_*.rates
  for _ in $(seq "$rounds"); do
    for threads in 1 2; do
      # fem-dem reports the speed of its packings itself, without the reading and writing of files.
      "$BIN/fem-dem" "pipelines/ch6/$1.toml" "$out/ch6/$2.h5" --set time.duration="$stretch" \
        --set time.output_interval="$stretch" --threads "$threads" --force -o "$out/$1_$threads.h5" 2>&1 | tee /dev/stderr |
        sed -n 's/.*: \([0-9.e+]*\) packing steps.*/\1/p' >> "$out/$1_$threads.rates"
    done
  done
  cmp "$out/$1_1.h5" "$out/$1_2.h5"
  one=$(median < "$out/$1_1.rates") two=$(median < "$out/$1_2.rates")
  note "$1: steps of a packing of 400 grains on one thread" "$one" 1/s
  note "$1: on two" "$two" 1/s
  note "$1: two threads over one" "$(awk -v a="$one" -v b="$two" 'BEGIN { printf "%.2f", b / a }')" 1 'at least' 1.85
}

for part in $parts; do
  case $part in
    bag) bag ;;
    shape) scales shape rods_400_loose ;;
    pullout) scales pullout rods_400_k0 ;;
    *) echo "bench-studies: no part \"$part\": bag, shape or pullout" >&2; exit 64 ;;
  esac
done
awk -F '\t' -v OFS='\t' '
  { verdict = "" }
  $4 == "at most" { verdict = $2 + 0 <= $5 ? "met" : "missed" }
  $4 == "at least" { verdict = $2 + 0 >= $5 ? "met" : "missed" }
  { print $0, verdict; missed += verdict == "missed" }
  END { exit missed > 0 }' "$out/studies.tsv" | column -t -s $'\t'
