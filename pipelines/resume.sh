#!/bin/bash
# Makes a file with a tool that keeps checkpoints: goes on where a make that was killed left it, unless the tool has changed
# since, and waits for one that is still at it.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: resume.sh OUTPUT TOOL ARGUMENT...
set -euo pipefail
export LC_ALL=C.UTF-8
output=$1 tool=$2
shift 2
exec 9> "$output.lock"
flock 9
rm -f "$output"
[[ ! $tool -nt $output.part ]] || rm -rf "$output.part"
exec "$tool" "$@" --threads 1 --quiet --resume -o "$output"
