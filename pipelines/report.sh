#!/bin/bash
# Collects the studies' pages in one self-contained HTML file on standard output. Usage: report.sh PAGE...
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail

cat <<'HEAD'
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Soilweave: the studies</title>
<style>
  body { font: 16px/1.55 Georgia, serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; color: #222; background: #fff; }
  h1, h2, h3, th, figcaption, nav { font-family: "Helvetica Neue", Arial, sans-serif; }
  h1 { font-size: 1.7rem; } h2 { margin-top: 3rem; border-bottom: 1px solid #ccc; } h3 { margin-top: 2rem; }
  table { border-collapse: collapse; margin: 1rem 0; font-size: .93rem; }
  th, td { padding: .3rem .8rem; border-bottom: 1px solid #ddd; text-align: left; vertical-align: top; }
  td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
  td.met { color: #1b7837; } td.missed { color: #b2182b; font-weight: bold; }
  figure { margin: 1.5rem 0; } figure svg { width: 100%; height: auto; } figcaption { font-size: .9rem; color: #444; }
  pre { font-size: .8rem; background: #f6f6f6; padding: .8rem; overflow-x: auto; }
</style>
</head>
<body>
<h1>Soilweave: the studies</h1>
<p>Every number and figure on this page was made by the run it describes. Compression is positive; strains are natural.</p>
HEAD
echo '<nav><ul>'
for page in "$@"; do
  sed -n 's|.*<h2 id="\([^"]*\)">\([^<]*\)</h2>.*|<li><a href="#\1">\2</a></li>|p' "$page"
done
echo '</ul></nav>'
cat "$@"
echo '</body></html>'
