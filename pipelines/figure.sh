# What pages of the report are made of; sourced by each study's page.sh, with OUT the folder of its results.
# shellcheck shell=sh
# SPDX-License-Identifier: GPL-3.0-or-later

# Inline SVG: identifiers get the figure's path before them, since gnuplot gives every figure the same ones.
figure() { # NAME CAPTION
  own=$(printf %s "$OUT/$1" | tr -c '[:alnum:]' _)
  printf '<figure>\n'
  sed -e '/^<?xml/d' -e '/^<!DOCTYPE/,/>/d' -e "s/id='\([^']*\)'/id='${own}_\1'/g" -e "s/id=\"\([^\"]*\)\"/id=\"${own}_\1\"/g" \
    -e "s/href='#\([^']*\)'/href='#${own}_\1'/g" -e "s/url(#\([^)]*\))/url(#${own}_\1)/g" "$OUT/$1.svg"
  printf '<figcaption>%s</figcaption>\n</figure>\n' "$2"
}

# What has too many marks for SVG.
picture() { # NAME CAPTION
  printf '<figure>\n<img alt="%s" src="data:image/png;base64,' "$2"
  base64 -w 0 "$OUT/$1.png"
  printf '">\n<figcaption>%s</figcaption>\n</figure>\n' "$2"
}

escaped() { # FILE
  sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g' -e 's/>/\&gt;/g' "$1"
}
