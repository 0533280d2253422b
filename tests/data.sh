#!/bin/sh
# Every file under data/ but the pages is the one that data/SOURCES.md names, by its SHA-256 digest, and none is missing there.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
export LC_ALL=C.UTF-8
cd "$(dirname "$0")/../data"
listed=$(sed -n 's/^    \([0-9a-f]\{64\}  .*\)$/\1/p' SOURCES.md)
printf '%s\n' "$listed" | sha256sum --quiet --strict --check - || {
  echo "data/SOURCES.md: a file is not the one listed: restore it, or describe the new one" >&2
  exit 1
}
find . -type f ! -name SOURCES.md ! -path ./README.md | sed 's|^\./||' | while read -r file; do
  printf '%s\n' "$listed" | grep -qF "  $file" || { echo "data/$file: is not in data/SOURCES.md" >&2; exit 1; }
  grep -qF "\`$file\`" SOURCES.md || { echo "data/$file: has no line in the table of data/SOURCES.md" >&2; exit 1; }
done
echo "== data: as described"
