#!/bin/bash
# Checks rules of the code that a script can see: include direction, allowed includes, sizes, first lines, loose ends.
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
export LC_ALL=C.UTF-8
cd "$(dirname "$0")/.." || exit 1

faults=0
fault() {
  echo "$1" >&2
  faults=$((faults + 1))
}

# Rooms (layers) from the lowest up. Each may include itself, its folders that are no rooms themselves (dem/contact/laws),
# and the rooms before it.
rooms=(
  core core/simd core/text core/cli
  store files files/exchange display
  dem/state dem/contact dem/sweep dem/engine dem/engine/energies dem/loading dem/run
  analysis/measure analysis/doubts analysis/tables
  packing/generate packing/container packing/expand
  calibration calibration/output
  gws/laboratory gws/solution gws/identification gws/design gws/output
  fem/mesh fem/material fem/model fem/run
)
largest=2500 # lines of sources and headers in one room
room_of='
  # Returns the room of a path within lib: the longest one that it begins with; 0 if none.
  function room_of(path) { while (sub(/\/[^\/]*$/, "", path)) if (path in rank) return path; return 0 }
  BEGIN { count = split(rooms, room, " "); for (r = 1; r <= count; ++r) rank[room[r]] = r }'
while IFS= read -r line; do fault "$line"; done < <(
  grep -rnE '^#include "' lib --include='*.cpp' --include='*.h' | sed 's,^lib/,,' | awk -F '[:"]' -v rooms="${rooms[*]}" "$room_of"'
    { from = room_of($1); to = room_of($4) }
    $4 ~ /^lists\// { next }  # made by the build from the files of a room (Makefile)
    from && to == 0 { printf "lib/%s:%s: includes \"%s\", which lies in no room\n", $1, $2, $4 }
    from && to && rank[to] > rank[from] {
      printf "lib/%s:%s: includes \"%s\", but %s stands above %s: move the declaration down, or this file up\n", $1, $2, $4, to, from
    }')
while IFS= read -r line; do fault "$line"; done < <(
  find lib \( -name '*.cpp' -o -name '*.h' \) -exec grep -c '' {} + | sed 's,^lib/,,' |
    awk -F : -v rooms="${rooms[*]}" -v largest="$largest" "$room_of"'
    !room_of($1) { printf "lib/%s: lies in no room; list its folder in tests/layers.sh\n", $1 }
    { lines[room_of($1)] += $2 }
    END { for (r = 1; r <= count; ++r) {
      if (!lines[room[r]]) printf "lib/%s: a room without sources; tests/layers.sh lists it\n", room[r]
      if (lines[room[r]] > largest) printf "lib/%s: %d lines in one room; at most %d\n", room[r], lines[room[r]], largest } }')

# only PATTERN FOLDERS FILES: demands that only these files in the folders include the pattern.
only() {
  local pattern=$1 files=$3 folders
  read -ra folders <<<"$2"
  while IFS= read -r line; do
    [[ " $files " == *" ${line%%:*} "* ]] || fault "$line: only ${files:-the library} may include this"
  done < <(grep -rnE "^ *#include [<\"]$pattern" "${folders[@]}" --include='*.cpp' --include='*.h' 2>/dev/null)
}
only '(hdf5|H5[A-Z]*public)' 'lib tools' 'lib/store/hdf5_id.h'
only 'store/hdf5_' 'lib tools' \
  'lib/store/hdf5_memory.h lib/store/hdf5_memory.cpp lib/store/hdf5_guard.h lib/store/hdf5_guard.cpp lib/store/store_read.cpp lib/store/store_write.cpp'
only 'Eigen/(Cholesky|Dense|Eigenvalues)' 'lib tools' 'lib/core/linear_algebra.cpp lib/core/precompiled.h'
only 'CGAL/' 'lib tools' 'lib/analysis/measure/tessellation.cpp lib/packing/container/shapes/surface.cpp'
only 'vtk' 'lib tools' 'lib/display/vtk.cpp lib/files/exchange/triangles_vtk.cpp'
only 'mpi' 'lib tools' 'lib/fem/model/ranks_mpi.cpp'
only 'CLI/' 'lib tools' 'lib/core/cli/tool_parse.cpp'
only 'toml' 'lib tools' 'lib/core/text/settings_document.h'
only '(Eigen/|unsupported/)' 'tools' ''

# limit LINES FILE...: demands that no file is longer.
limit() {
  local most=$1
  shift
  while IFS= read -r line; do fault "$line"; done < <(
    wc -l "$@" | awk -v most="$most" '$2 != "total" && $1 > most { printf "%s: %d lines; at most %d\n", $2, $1, most }')
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
while IFS= read -r line; do fault "$line"; done < <(
  awk '
    FNR == 1 && FILENAME ~ /\.(cpp|h)$/ && (!/^\/\/ [^ ]/ || /SPDX/) { print FILENAME ": the first line does not say what the file is" }
    /SPDX-License-Identifier: GPL-3.0-or-later/ { licensed[FILENAME] }
    FNR == 8 { nextfile }
    END { for (k = 1; k < ARGC; ++k) if (!(ARGV[k] in licensed)) print ARGV[k] ": no SPDX line at the top" }' \
    "${headers[@]}" "${sources[@]}" "${tools[@]}" "${tests[@]}" "${scripts[@]}" Makefile)

# A test is named by a sentence in one word, as WidthsAreTheDistancesOfItsFaces.
while IFS= read -r line; do
  fault "$line: name it by a sentence of capitalised words without _"
done < <(grep -rnE '^(TYPED_)?TEST(_F|_P)?\(\w+, *([a-z]\w*|\w*_\w*)\)' tests --include='*.cpp')

# Unfinished work is finished or filed, not marked. The brackets keep this line from finding itself.
while IFS= read -r line; do
  fault "$line: unfinished"
done < <(grep -rnwE 'T[O]DO|F[I]XME|X[X]X|H[A]CK|N[O]LINT' lib tools tests pipelines Makefile .ci 2>/dev/null \
  | grep -v '^Binary')

# The library neither ends the process nor writes to standard error; core/cli/tool and core/terminal do.
while IFS= read -r line; do
  fault "$line: throw an error of core/error.h instead"
done < <(grep -rnE 'std::cerr|std::exit|[^_a-z.]exit\(|std::abort|stderr' lib --include='*.cpp' --include='*.h' \
  | grep -vE '^lib/core/cli/tool\.cpp:')

# Files that programs make are not kept beside those that people write. An unpacked source tree has no git to ask.
while IFS= read -r line; do
  fault "$line: stands in the repository and is ignored by .gitignore: git rm --cached $line"
done < <(git ls-files --cached --ignored --exclude-standard 2>/dev/null)

if ((faults > 0)); then
  echo "tests/layers.sh: $faults faults" >&2
  exit 1
fi
