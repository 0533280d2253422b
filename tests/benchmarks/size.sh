#!/usr/bin/env bash
# Cost of a step per contact and memory per grain, from a thousand grains to a million, and the gain of a second core for
# small systems. Makes a table and a figure, and compares both with bars.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# make bench-size. Needs about 3 GB of memory and two cores that nobody else uses. OUT (default build/bench): folder of
# size.tsv and size.svg. Exits with 1 where a bar is missed.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
bench=${BENCH:-$here/../../build/tests/bench}
out=${OUT:-$here/../../build/bench}
mkdir -p "$out"
export LC_ALL=C.UTF-8
# Each size has a process of its own, because the memory that a smaller system returned would not count in the next one.
for grains in 1000 10000 70000 200000 1000000; do
  "$bench" --benchmark_filter="size_of_system/$grains\$" --benchmark_format=csv 2> /dev/null
done > "$out/size_of_system.csv"
# Medians over one thread and two in turn, so that other work of the machine affects both.
"$bench" --benchmark_filter=small_systems --benchmark_repetitions=15 --benchmark_enable_random_interleaving=true \
  --benchmark_format=csv 2> /dev/null > "$out/small_systems.csv"

awk -F , -v OFS='\t' '
  $1 == "name" && !n++ { for (i = 1; i <= NF; ++i) { gsub(/"/, "", $i); at[$i] = i }
    print "grains [1]", "contacts [1]", "step [ms]", "per_contact [ns]", "per_grain [B]",
      "memory_per_contact [ns]" }
  /size_of_system/ { print $at["grains"], $at["contacts"], $at["cpu_time"], 1e9 * $at["per_contact"], $at["bytes_per_grain"],
      1e9 * $at["memory_per_contact"] }
  ' "$out/size_of_system.csv" > "$out/size.tsv"
column -t -s $'\t' "$out/size.tsv"

PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$here/../../pipelines ${PYTHON:-/usr/bin/python3} -P "$here/size_figure.py" "$out/size.tsv" "$out/size.svg"

awk -F '\t' '
  function bar(words, value, met) { printf "%s: %.4g: %s\n", words, value, met ? "met" : "MISSED"; if (!met) missed = 1 }
  NR == FNR { if (FNR > 1) { cost[$1 + 0] = $4; held[$1 + 0] = $5 } next }
  { split($0, cell, ","); if (cell[1] ~ /small_systems\/1\/.*_median/) one = cell[3]; if (cell[1] ~ /small_systems\/2\/.*_median/) two = cell[3] }
  END {
    if (!cost[1000000] || !cost[70000] || !one || !two) { print "bench-size: a row is missing" > "/dev/stderr"; exit 2 }
    bar("cost per contact of a million grains over that of 70,000, at most 1.5", cost[1000000] / cost[70000],
      cost[1000000] <= 1.5 * cost[70000])
    bar("memory of a million grains, bytes a grain, at most 800", held[1000000], held[1000000] <= 800)
    bar("128 systems of 400 grains on two threads over one, at least 1.9", one / two, one >= 1.9 * two)
    exit missed
  }' "$out/size.tsv" "$out/small_systems.csv"
