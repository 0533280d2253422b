#!/usr/bin/env bats
# Keys of TOML documents as data: complete, described, the same on the pages, and a JSON Schema that files obey.
# SPDX-License-Identifier: GPL-3.0-or-later
load common

setup() {
  cd "$BATS_TEST_DIRNAME/../.." || return
}

@test "the pages say the keys that the tools say" {
  bash tests/pages.sh
}

@test "every key has a sentence" {
  for tool in run-dem filter-expand fem-dem pf-weight pack-generate; do
    exits 0 "$tool" --keys
    [[ -n $output ]] || show "$tool says no keys"
    bare=$(grep -E '(required|optional|default [^:]*): *(\(.*\))?$' <<< "$output" || true)
    [[ -z $bare ]] || show "without a sentence: $bare"
  done
}

@test "every key of the studies' files is in the schema of its tool" {
  for tool in run-dem filter-expand fem-dem pf-weight; do "$tool" --keys json > "$BATS_TEST_TMPDIR/$tool.json"; done
  "$PYTHON" - "$BATS_TEST_TMPDIR" << 'END'
import json, pathlib, sys, tomllib

schemas = {p.stem: json.loads(p.read_text()) for p in pathlib.Path(sys.argv[1]).glob("*.json")}

def strange(value, schema, path):
    """Returns what a value has that its schema does not know."""
    if isinstance(value, dict):
        known = schema.get("properties", {})
        return [s for key, inner in value.items() for s in
                (strange(inner, known[key], f"{path}.{key}") if key in known else [f"{path}.{key}"])]
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return [s for k, inner in enumerate(value) for s in strange(inner, schema.get("items", {}), f"{path}[{k}]")]
    words = schema.get("enum")
    return [f"{path} = {value}"] if words and value not in words else []

def tool_of(document):
    if "stage" in document: return "run-dem"
    if "soil" in document or "mesh" in document: return "fem-dem"
    if "parameter" in document: return "pf-weight"
    if {"container", "surround", "growth", "geotextile_mesh", "sheet"} & document.keys(): return "filter-expand"

seen, faults = {}, []
for file in sorted(pathlib.Path("pipelines").rglob("*.toml")):
    document = tomllib.loads(file.read_text())
    tool = tool_of(document)
    if not tool or "words" in file.name: continue
    seen[tool] = seen.get(tool, 0) + 1
    faults += [f"{file}: {s}" for s in strange(document, schemas[tool], tool)]
assert not faults, "\n".join(faults)
assert len(seen) >= 3, seen
END
}

@test "a form of the keys that is none is refused" {
  mkdir "$BATS_TEST_TMPDIR/here"
  cd "$BATS_TEST_TMPDIR/here"
  refuses 64 run-dem "--keys yaml: give text, json or no word" --keys yaml
  [[ $(run-dem --keys yaml 2>&1 | wc -l) == 1 ]]
}
