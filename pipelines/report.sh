#!/bin/sh
# One self-contained HTML report of the studies' pages, on standard output.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: report.sh STYLE.css PAGE.html...
set -eu
export LC_ALL=C.UTF-8
style=$1
shift
cat <<'HEAD'
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Soilweave: the studies</title>
<style>
HEAD
sed '/^\/\*/d' "$style"
cat <<'HEAD'
</style>
</head>
<body>
<header>
<h1>Soilweave: the studies</h1>
<p>Multiscale mechanics of geotextile-reinforced granular soil, beside H. Cheng's dissertation (Hiroshima University, 2016) and
laboratory tests. Every number here was measured in the runs below. Compression is positive; strains are natural.</p>
<nav><ul>
HEAD
for page in "$@"; do
  name=$(basename "$(dirname "$page")")
  title=$(sed -n 's|.*<h2>\(.*\)</h2>.*|\1|p' "$page" | head -n 1)
  met=$(grep -o '<td class="met">' "$page" | wc -l)
  unmet=$(grep -o '<td class="unmet">' "$page" | wc -l)
  printf '<li><a href="#%s">%s</a>: %s of %s published values met</li>\n' "$name" "$title" "$met" "$((met + unmet))"
done
printf '</ul></nav>\n</header>\n'
cat "$@"
printf '</body>\n</html>\n'
