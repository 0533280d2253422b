#!/bin/bash
# The habits of the house that a script can see: include direction, who includes what, sizes, first lines, loose ends.
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
export LC_ALL=C.UTF-8
cd "$(dirname "$0")/.." || exit 1

faults=0
fault() {
  echo "$1" >&2
  faults=$((faults + 1))
}

# Folders from the lowest up. Each may include itself and those before it.
layers=(core io dem analysis packing calibration gws fem)
allowed=""
for layer in "${layers[@]}"; do
  allowed+="${allowed:+|}$layer"
  [[ -d lib/$layer ]] || continue
  while IFS= read -r line; do
    fault "$line: lib/$layer may include only $allowed"
  done < <(grep -rnE '^#include "' "lib/$layer" | grep -vE "#include \"($allowed)/")
done
for folder in lib/*/; do
  [[ " ${layers[*]} " == *" $(basename "$folder") "* ]] || fault "$folder: not a layer; add it to tests/layers.sh"
done

# only PATTERN FOLDERS FILES: demands that only these files in the folders include the pattern.
only() {
  local pattern=$1 files=$3 folders
  read -ra folders <<<"$2"
  while IFS= read -r line; do
    [[ " $files " == *" ${line%%:*} "* ]] || fault "$line: only ${files:-the library} may include this"
  done < <(grep -rnE "^ *#include [<\"]$pattern" "${folders[@]}" --include='*.cpp' --include='*.h' 2>/dev/null)
}
only '(hdf5|H5[A-Z]*public)' 'lib tools' 'lib/io/hdf5_id.h'
only 'io/hdf5_' 'lib tools' \
  'lib/io/hdf5_memory.h lib/io/hdf5_memory.cpp lib/io/hdf5_guard.h lib/io/hdf5_guard.cpp lib/io/store_read.cpp lib/io/store_write.cpp'
only 'CGAL/' 'lib tools' 'lib/analysis/tessellation.cpp lib/packing/surface.cpp'
only 'vtk' 'lib tools' 'lib/io/vtk.cpp lib/io/vtk_read.cpp'
only 'mpi' 'lib tools' 'lib/fem/ranks_mpi.cpp'
only 'CLI/' 'lib tools' 'lib/core/tool_parse.cpp'
only 'toml' 'lib tools' 'lib/core/settings.cpp'
only '(Eigen/|unsupported/)' 'tools' ''

# limit LINES FILE...: demands that no file is longer.
limit() {
  local most=$1 file
  shift
  for file in "$@"; do
    [[ -f $file ]] || continue
    local lines
    lines=$(wc -l <"$file")
    ((lines <= most)) || fault "$file: $lines lines; at most $most"
  done
}
mapfile -t headers < <(find lib -name '*.h' | sort)
mapfile -t sources < <(find lib -name '*.cpp' | sort)
mapfile -t tools < <(find tools -name '*.cpp' 2>/dev/null | sort)
mapfile -t tests < <(find tests -name '*.cpp' -o -name '*.h' | sort)
limit 150 "${headers[@]}"
limit 400 "${sources[@]}"
limit 200 "${tools[@]}"

# A function body as clang-format lays it out: from a line that opens a brace to the closing brace in the same column.
# Namespaces, types and tables of data are no functions.
# shellcheck disable=SC2016  # awk's dollars, not the shell's
awk_functions='
  FNR == 1 { depth = 0 }
  /^( *)[^ ].*\) (const |noexcept |override )*\{$/ && !/^ *(if|for|while|switch|else|do|\}|namespace|struct|class|enum)/ \
    && !depth && !/= *\[/ { match($0, /^ */); indent = RLENGTH - ($0 ~ /^ *:/ ? 4 : 0); start = FNR; depth = 1; name = $0; next }
  depth && match($0, /^ *\}/) && RLENGTH == indent + 1 {
    if (FNR - start - 1 > most) { sub(/^ +/, "", name); printf "%s:%d: %d lines in one function; at most %d: %s\n", FILENAME, start, FNR - start - 1, most, name }
    depth = 0
  }'
while IFS= read -r line; do fault "$line"; done \
  < <(awk -v most=60 "$awk_functions" "${headers[@]}" "${sources[@]}" "${tools[@]}")

# Every file has the licence in its first lines, below a sentence that may take several.
mapfile -t scripts < <(find tests pipelines .ci -name '*.sh' -o -name '*.bash' -o -name '*.bats' -o -path .ci/run | sort)
for file in "${headers[@]}" "${sources[@]}" "${tools[@]}" "${tests[@]}" "${scripts[@]}" Makefile; do
  head -8 "$file" | grep -q 'SPDX-License-Identifier: GPL-3.0-or-later' || fault "$file: no SPDX line at the top"
done
for file in "${headers[@]}" "${sources[@]}" "${tools[@]}" "${tests[@]}"; do
  head -1 "$file" | grep -qE '^// [^ ]' || fault "$file: the first line does not say what the file is"
  head -1 "$file" | grep -q 'SPDX' && fault "$file: the first line does not say what the file is"
done

# Unfinished work is finished or filed, not marked. The brackets keep this line from finding itself.
while IFS= read -r line; do
  fault "$line: unfinished"
done < <(grep -rnwE 'T[O]DO|F[I]XME|X[X]X|H[A]CK|N[O]LINT' lib tools tests pipelines Makefile .ci 2>/dev/null \
  | grep -v '^Binary')

# The library neither ends the process nor writes to standard error; core/tool and core/terminal do.
while IFS= read -r line; do
  fault "$line: throw an error of core/error.h instead"
done < <(grep -rnE 'std::cerr|std::exit|[^_a-z.]exit\(|std::abort|stderr' lib --include='*.cpp' --include='*.h' \
  | grep -vE '^lib/core/tool\.cpp:')

if ((faults > 0)); then
  echo "tests/layers.sh: $faults faults" >&2
  exit 1
fi
