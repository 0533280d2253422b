#!/usr/bin/env bats
# gws-solve: the output of its verbs, loops that close, refusals, and the help of each verb.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup() {
  cd "$BATS_TEST_TMPDIR" || return
}

DEM=$BATS_TEST_DIRNAME/../../data/discrete_element
LAB=$BATS_TEST_DIRNAME/../../data/laboratory

# refuses STATUS VERB MESSAGE ARGUMENTS...: demands exactly one line, "gws-solve VERB: MESSAGE", and an empty standard
# output.
refuses() {
  local wanted=$1 verb=$2 message=$3
  shift 3
  exits "$wanted" gws-solve "$verb" "$@"
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $stderr == "gws-solve $verb: $message" ]] || show "wanted: gws-solve $verb: $message"
  [[ -z $output ]] || show "wanted nothing on standard output"
}

@test "respond prints a table a person can read, and what the bag bears" {
  exits 0 gws-solve respond --geotextile PP --surcharge 1000e3
  [[ ${lines[0]} == "Soil toyoura-gws, since no --soil is given" ]] || show
  [[ ${lines[1]} == "Geotextile PP: stiffness 232 kN/m, strength 31.75 kN/m, strain at failure 14.25 %" ]] || show
  [[ ${lines[3]} == *surcharge*settlement*sigma_a*sigma_r*hoop* ]] || show
  [[ ${lines[25]} =~ ^\ *1000\.0\ +8\.241 ]] || show "the last row is not 1000 kPa"
  [[ $output == *"Ends at 1000.0 kPa at a settlement of 8.24 % (6.6 mm)"* ]] || show
  [[ $(wc -L <<<"$output") -le 140 ]] || show "lines of $(wc -L <<<"$output") columns"
  exits 0 gws-solve respond --geotextile PP
  [[ $output == *"Ultimate bearing capacity 1730.6 kPa at a settlement of 12.50 % (10.0 mm): the hoop strain"* ]] || show
}

@test "--help tells the model's assumptions, limits and source in a paragraph" {
  exits 0 gws-solve --help
  local paragraph
  paragraph=$(tr '\n' ' ' <<<"$output")
  for words in "H. Cheng's dissertation (Hiroshima University, 2016, section 5.3)" "It assumes" "It knows no unloading" \
    "20-25 % above"; do
    [[ $paragraph == *"$words"* ]] || show "not in the help: $words"
  done
}

@test "text, file and pipe say the same" {
  gws-solve respond --geotextile PE --tsv > response.tsv
  gws-solve respond --geotextile PE -o response.h5 > /dev/null
  gws-solve respond --geotextile PE -o - > piped.h5
  same_bytes response.h5 piped.h5
  exits 0 "$PYTHON" - <<'PY'
import h5py
rows = [line.split("\t") for line in open("response.tsv")]
with h5py.File("response.h5") as file:
    table = file["fields/response"]
    for i, head in enumerate(rows[0]):
        name, unit = head.strip().split(" [")
        assert table[name].attrs["units"] in (unit.rstrip("]"), unit.rstrip("]").encode()), name
        assert table[name][()].tolist() == [float(row[i]) for row in rows[1:]], name
PY
}

@test "design, then respond: the loop closes to 0.1 %" {
  gws-solve design --surcharge "300 kPa" --settlement 0.05 --safety 1.5 --tsv > design.tsv
  local stiffness strength
  stiffness=$(value design.tsv stiffness 1) strength=$(value design.tsv strength 1)
  gws-solve respond --stiffness "$stiffness" --strength "$strength" --surcharge "300 kPa" --tsv > service.tsv
  near "$(value service.tsv settlement last)" 0.05 1e-3
  gws-solve respond --stiffness "$stiffness" --strength "$strength" --tsv > ultimate.tsv
  near "$(value ultimate.tsv surcharge last)" 450e3 1e-3
}

@test "design with reduction factors, then respond with the printed product and the same factors: it bears the surcharge" {
  local factors=(--rf-creep 3 --rf-installation 1.2) demand=(--surcharge "300 kPa" --settlement 0.05 --safety 1.5)
  gws-solve design "${demand[@]}" "${factors[@]}" --tsv > design.tsv
  near "$(value design.tsv strength 1)" "$("$PYTHON" -c "print(3.6 * $(value design.tsv long_term_strength 1))")" 1e-9
  exits 0 gws-solve design "${demand[@]}" "${factors[@]}"
  # 3.6 times the 7.8887 kN/m without factors.
  [[ $output == *"with a strength of 28.399 kN/m"*", 0.5 of the long-term strength"*"Long-term strength: 28.4 kN/m over"*"leaves 7.889 kN/m"* ]] || show
  gws-solve respond --stiffness "$(value design.tsv stiffness 1)" --strength "$(value design.tsv strength 1)" "${factors[@]}" --tsv > ultimate.tsv
  near "$(value ultimate.tsv surcharge last)" 450e3 1e-3
  # A data sheet, all tensions of which are scaled by the factor that the answer names.
  sheet() {
    printf 'name = "sheet"\ntension_at_2 = %s\ntension_at_5 = %s\nstrength = %s\nfailure_strain = 0.2\n' \
      "$("$PYTHON" -c "print(4e3 * $1)")" "$("$PYTHON" -c "print(9e3 * $1)")" "$("$PYTHON" -c "print(30e3 * $1)")"
  }
  sheet 1 > sheet.toml
  gws-solve design --geotextile sheet.toml --strength-fraction 1 --rf-creep 2 --surcharge 300e3 --tsv > design.tsv
  sheet "$(value design.tsv strength 1) / 30e3" > scaled.toml
  gws-solve respond --geotextile scaled.toml --strength-fraction 1 --rf-creep 2 --tsv > ultimate.tsv
  near "$(value ultimate.tsv surcharge last)" 300e3 1e-3
  # A row of a chart is a product too.
  gws-solve design --geotextile PP --surcharge 3e5 --chart "${factors[@]}" --from 232e3 --to 1160e3 --points 5 --tsv > chart.tsv
  near "$(value chart.tsv strength last)" 158770 1e-9
  gws-solve respond --geotextile 5PP "${factors[@]}" --tsv > 5PP.tsv
  near "$(value chart.tsv capacity last)" "$(value 5PP.tsv surcharge last)" 1e-9
}

@test "the surcharge a bag is said to carry is the one it settles so much under" {
  gws-solve design --geotextile PP --settlement 0.05 --safety 1.5 --tsv > allowance.tsv
  gws-solve respond --geotextile PP --surcharge "$(value allowance.tsv surcharge 1)" --tsv > service.tsv
  near "$(value service.tsv settlement last)" 0.05 1e-6
}

@test "a chart has a row for each stiffness, and the capacity of a known one" {
  gws-solve design --geotextile PP --surcharge 3e5 --chart --from 232e3 --to 1160e3 --points 5 --tsv > chart.tsv
  [[ $(wc -l < chart.tsv) -eq 6 ]] || show "$(cat chart.tsv)"
  gws-solve respond --geotextile 5PP --tsv > 5PP.tsv
  near "$(value chart.tsv capacity last)" "$(value 5PP.tsv surcharge last)" 1e-9
}

@test "identify reads what respond wrote, as text and as a file" {
  local geotextile
  for geotextile in PE PP 3PP; do gws-solve respond --geotextile "$geotextile" --points 100 --tsv > "$geotextile.tsv"; done
  exits 0 gws-solve identify PE.tsv PP.tsv 3PP.tsv --tsv
  printf '%s\n' "$output" > constants.tsv
  near "$(value constants.tsv kappa 1)" 1.386 1e-6
  near "$(value constants.tsv p_1 1)" 1.68 0.01
  near "$(value constants.tsv alpha 1)" 26.1e6 0.01
  gws-solve respond --geotextile PP --points 100 -o PP.h5 > /dev/null
  gws-solve identify PP.h5 --tsv --table near_failure_line > file.tsv
  gws-solve identify PP.tsv --tsv --table near_failure_line > text.tsv
  same_bytes file.tsv text.tsv
}

@test "identify reads what homogenize wrote: natural strains of the cell, up to the greatest axial stress" {
  cat > cell.py <<'PY'
import h5py, math, sys
rows = [line.rstrip("\n").split("\t") for line in open("PP.tsv")]
names = [name.split(" [")[0] for name in rows[0]]
column = {name: [float(row[i]) for row in rows[1:]] for i, name in enumerate(names)}
natural = lambda values: [-math.log1p(-value) for value in values]
with h5py.File("cell.h5", "r+") as file:
    cell = file["fields/cell"]
    for name in cell:
        attributes = dict(cell[name].attrs)
        old = cell[name][()]
        values = {"strain_zz": natural(column["strain_axial"]), "strain_volumetric": natural(column["strain_volumetric"]),
                  "mean_stress": column["mean_stress"], "deviatoric_stress": column["deviatoric_stress"]}.get(name)
        del cell[name]
        data = values if values else [old[0]] * len(column["mean_stress"])
        cell.create_dataset(name, data=data, dtype=old.dtype)
        for key, value in attributes.items():
            cell[name].attrs[key] = value
PY
  gws-solve respond --geotextile PP --points 100 --tsv > PP.tsv
  "$PYTHON" "$BATS_TEST_DIRNAME/vtk_states.py" sheared states.h5
  homogenize --quiet states.h5 -o cell.h5
  "$PYTHON" cell.py
  exits 0 gws-solve identify cell.h5 --geotextile PP --strains natural --tsv
  printf '%s\n' "$output" > constants.tsv
  near "$(value constants.tsv kappa 1)" 1.386 1e-6
  exits 65 gws-solve identify cell.h5
  [[ $stderr == *"cell.h5: no stiffness of the geotextile: give --geotextile for it"* ]] || show
}

@test "the discrete-element points give Table 5.2 where they can, and say by how much where not" {
  exits 0 gws-solve identify "$DEM"/soilbag_uniaxial_{PE,PP,3PP}.tsv --failure "$LAB/toyoura_peak_obliquity.tsv" --fit thesis
  [[ ${lines[0]} == "Line by line, as the thesis; "* ]] || show "the way is not said"
  local constant
  for constant in kappa lambda xi C_t n p_c; do
    grep -qE "^  $constant .*: inside" <<<"$output" || show "$constant is outside its interval"
  done
  grep -qE "^  p_1 .*given 1.68: outside \(-23.1 %\)" <<<"$output" || show "p_1"
  grep -qE "^  alpha .*given 2.61e\+07: inside \(-2.4 %\)" <<<"$output" || show "alpha"
  grep -q "outlier, kept: row 1 of .*soilbag_uniaxial_PE.tsv" <<<"$output" || show "no outlier"
}

@test "tests at failure count at their mean stress, or as the thesis counts them" {
  # M (p/p_c)^-n with M = 1.35, n = 0.1 and p_c = 3 MPa, at p = 3 sigma_r / (3 - q/p) for confining pressures of 100 to 400 kPa.
  exits 0 "$PYTHON" - <<'PY'
with open("peaks.tsv", "w") as file:
    file.write("confining_pressure [kPa]\tobliquity_at_failure [1]\n")
    for p in (100, 200, 400, 700):
        eta = 1.35 * (p / 3000) ** -0.1
        file.write(f"{p * (3 - eta) / 3!r}\t{eta!r}\n")
PY
  exits 0 gws-solve identify "$DEM"/soilbag_uniaxial_{PE,PP}.tsv --failure peaks.tsv --tsv
  near "$(value <(printf '%s\n' "$output") n 1)" 0.1 1e-6
  near "$(value <(printf '%s\n' "$output") p_c 1)" 3e6 1e-6
  exits 0 gws-solve identify "$DEM"/soilbag_uniaxial_{PE,PP}.tsv --failure peaks.tsv --fit thesis
  [[ $output == *"tests at failure count at their confining pressure."* ]] || show
  exits 0 gws-solve identify "$DEM"/soilbag_uniaxial_{PE,PP}.tsv --failure peaks.tsv --fit thesis --tsv
  # There p_c is a pressure between the confining ones, about sigma_r = p (3 - q/p)/3 of 3 MPa.
  holds 'p_c > 1e6 && p_c < 2e6' p_c="$(value <(printf '%s\n' "$output") p_c 1)"
  printf 'confining_pressure [kPa]\tobliquity_at_failure [1]\n100\t1.4\n200\t4.2\n' > beyond.tsv
  exits 65 gws-solve identify "$DEM"/soilbag_uniaxial_{PE,PP}.tsv --failure beyond.tsv
  [[ $stderr == *"beyond.tsv: row 2: q/p = 4.2 under 200 kPa; in compression q/p lies between 0 and 2.47: check that obliquity_at_failure is q/p, "* ]] || show
}

@test "points of compression in another unit are refused or a doubt" {
  local head factor status words
  gws-solve respond --geotextile PP --tsv > PP.tsv
  while IFS=';' read -r head factor status words; do
    { printf 'mean_stress [%s]\tstrain_volumetric%s\n' "${head%,*}" "${head#*,}"
      printf '25 .446\n50 .655\n90 .87\n' | awk -v f="$factor" -v OFS='\t' '{ print $1, f * $2 }'; } > c.tsv
    exits "$status" gws-solve identify PP.tsv --set failure_line.n=0.0723 --compression c.tsv
    [[ -n $words || $stderr != *c.tsv* && $stderr != *C_t* && $stderr != *--compression* ]] || show "$head"
    [[ $stderr == *"$words"* ]] || show "$head"
  done <<'CASES'
kPa, [%];1;0;
kPa, [1];0.01;0;
kPa,;1;65;c.tsv: row 1: strain_volumetric = 0.446; must be between -0.3 and 0.3: per cent are written strain_volumetric [%] in the header
kPa,;0.01;0;doubt: c.tsv: strain_volumetric has no unit and is taken for a fraction; write [%] or [1] in the header
kPa, [%];0.01;0;doubt: C_t = 0.01372 is 0.01 times that of soil toyoura-gws (changed): check the units of strain_volumetric and mean_stress in the heads
Pa, [%];1;65;c.tsv: row 1: mean_stress = 0.025 kPa; must be from 500 Pa to 100 MPa: check the unit in the header
MPa, [%];1;0;doubt: 3 of 3 points of --compression, from 2.5e+04 to 9e+04 kPa, lie beyond the mean stress of the series
CASES
}

@test "strengths under impossible pressures, or that are not q/p, are refused or a doubt" {
  local unit first second status words
  gws-solve respond --geotextile PP --tsv > PP.tsv
  while IFS=';' read -r unit first second status words; do
    printf 'confining_pressure [%s]\tobliquity_at_failure [1]\n%s\n%s\n' "$unit" "${first/ /$'\t'}" "${second/ /$'\t'}" > f.tsv
    exits "$status" gws-solve identify PP.tsv --failure f.tsv
    [[ -n $words || $stderr != *f.tsv* && $stderr != *p_c* ]] || show "$first"
    [[ $stderr == *"$words"* ]] || show "$first"
  done <<'CASES'
kPa;50 1.68;400 1.46;0;
MPa;50 1.68;400 1.46;65;f.tsv: row 2: confining_pressure = 4e+05 kPa; must be from 500 Pa to 100 MPa: check the unit in the header
MPa;20 1.68;90 1.46;0;doubt: f.tsv: all confining pressures lie beyond 10 kPa to 10 MPa, the first is 2e+04 kPa: check the unit
Pa;50 1.68;400 1.46;65;f.tsv: row 1: confining_pressure = 0.05 kPa; must be from 500 Pa to 100 MPa
kPa;50 4.1;400 3.6;65;f.tsv: row 1: q/p = 4.1 under 50 kPa; in compression q/p lies between 0 and 2.47
kPa;50 2.5;400 2.4;65;f.tsv: row 1: q/p = 2.5 under 50 kPa; in compression q/p lies between 0 and 2.47
kPa;50 .63;400 .60;0;doubt: f.tsv: row 1: q/p = 0.63 is a friction angle of 16.6 deg, where granular soils have 22 to 55
kPa;50 .63;400 .60;0;kPa is far beyond the tests, 63.29 to 500 kPa: check obliquity_at_failure
CASES
}

@test "what is identified the next command takes, and what is not is a doubt" {
  local strengths
  gws-solve respond --geotextile PP --points 40 --tsv > PP.tsv
  for strengths in "1.40 1.35 1.30" "1.65 1.645 1.64" "1.20 1.22 1.25"; do
    # shellcheck disable=SC2086  # three words
    set -- $strengths
    printf 'confining_pressure [kPa]\tobliquity_at_failure [1]\n100\t%s\n200\t%s\n400\t%s\n' "$@" > peaks.tsv
    exits 0 gws-solve identify PP.tsv --failure peaks.tsv --toml
    [[ $output == *'name = "identified (other constants: toyoura-gws)"'* ]] || show
    printf '%s\n' "$output" > soil.toml
    if [[ $1 == 1.40 ]]; then
      [[ $stderr == *": doubt: stiffness: not identified, so the answer keeps the constants of soil toyoura-gws: "* ]] || show
      near "$(awk '/^n =/ { print $3; exit }' soil.toml)" 0.0559 0.01
    else
      [[ $stderr == *": doubt: failure_line, stiffness: not identified, so the answer keeps "*"--set failure_line.n=0"* ]] || show
    fi
    exits 0 gws-solve respond --geotextile PP --soil soil.toml
  done
  exits 0 gws-solve identify PP.tsv --set failure_line.n=0 --set failure_line.M=1.645 --soil soil.toml
  [[ $stderr == *": doubt: stiffness: "* && $stderr != *": doubt: failure_line"* ]] || show
}

@test "a soil has all its constants, and says where its data end" {
  sed '/^xi/d; /^p_1/d' "$LAB/../soils/toyoura-gws.toml" > partial.toml
  exits 65 gws-solve respond --soil partial.toml --geotextile PP
  [[ $stderr == *"near_failure_line.xi: is missing; give "*"dilatancy_line.p_1: is missing; give "* ]] || show
  printf 'name = "mine"\n' > mine.toml
  exits 65 gws-solve respond --soil mine.toml --geotextile PP
  sed '/^\[identified/,/^$/d' "$LAB/../soils/toyoura-gws.toml" > ranges.toml
  exits 0 gws-solve respond --soil ranges.toml --geotextile PP
  [[ $stderr == *"doubt: soil toyoura-gws lacks [identified] with stiffness, mean_stress and axial_strain, the ranges of its data: extrapolation cannot be noticed" ]] || show
}

@test "identify takes each bag once, and of its rows those of loading" {
  exits 65 gws-solve identify "$DEM"/soilbag_uniaxial_PE.tsv "$DEM"/soilbag_uniaxial_PE.tsv
  [[ $stderr == *"PE.tsv and "*"PE.tsv hold equal rows: one bag counted twice would narrow the intervals; give it once" ]] || show
  # The third row again, after an unloading.
  awk 'BEGIN { FS = OFS = "\t" } { print } /^1\.65/ { again = $0; $1 -= 0.5; $6 /= 3; $8 /= 3; $9 /= 3; print; print again }' \
    "$DEM"/soilbag_uniaxial_PE.tsv > unloaded.tsv
  exits 0 gws-solve identify unloaded.tsv "$DEM"/soilbag_uniaxial_PP.tsv
  [[ $output == *"unloaded.tsv: 14 of 23 rows, up to the greatest axial stress, less 1 of unloading and reloading"* ]] || show
  exits 65 gws-solve identify "$DEM"/soilbag_uniaxial_PE.tsv --geotextile PP
  [[ $stderr == *"its column tensile_stiffness tells 53 kN/m, --geotextile 232 kN/m: leave one of them out" ]] || show
  sed '12s/\t53$/\t54/' "$DEM"/soilbag_uniaxial_PE.tsv > changes.tsv
  exits 65 gws-solve identify changes.tsv
  [[ $stderr == *": tensile_stiffness is 54000 N/m after 53000 N/m; a bag has one geotextile: give each its own table" ]] || show
  awk 'BEGIN { FS = OFS = "\t" } /^[0-9]/ { $1 = -$1 } { print }' "$DEM"/soilbag_uniaxial_PE.tsv > signs.tsv
  exits 65 gws-solve identify signs.tsv
  [[ $stderr == *"signs.tsv: rows up to the greatest axial stress whose axial strain does not fall: 1; at least 3 are needed: sort the rows by time, "* ]] || show
}

@test "a response identified again has its constants inside their intervals, whatever its rows" {
  local rows
  for rows in 12 20 2000; do
    gws-solve respond --geotextile PP --points "$rows" -o - > response.h5
    exits 0 gws-solve identify response.h5
    [[ ${lines[0]} == *"the plastic strain is subtracted from the compression line."* ]] || show "the way is not said"
    [[ $(grep -c ": inside" <<<"$output") -eq 7 && $output != *outside* && $output != *outlier* ]] || show "$rows rows"
  done
}

@test "an identified soil can be used, with bands; the same seed gives the same bytes" {
  gws-solve identify "$DEM"/soilbag_uniaxial_{PE,PP,3PP}.tsv --toml > soil.toml
  gws-solve respond --geotextile PP --soil soil.toml --samples 200 --seed 3 -o one.h5 > text
  gws-solve respond --geotextile PP --soil soil.toml --samples 200 --seed 3 -o other.h5 > /dev/null
  same_bytes one.h5 other.h5
  local words='([0-9]+) draws \(([0-9]+) of 200 left out\): ultimate bearing capacity [0-9.]+ kPa \(95 %: [0-9.]+ to [0-9.]+\)'
  [[ $(cat text) =~ $words ]] || show "$(cat text)"
  ((BASH_REMATCH[1] + BASH_REMATCH[2] == 200 && BASH_REMATCH[2] < 20)) || show "$(cat text)"
}

@test "bands say which constants were varied, and a line through as many points as constants is a doubt" {
  local geotextile held='; held, having none: '
  for geotextile in PE PP 3PP; do gws-solve respond --geotextile "$geotextile" --tsv > "$geotextile.tsv"; done
  printf 'confining_pressure [kPa]\tobliquity_at_failure [1]\n100\t1.70\n400\t1.55\n' > peaks.tsv
  exits 0 gws-solve identify PE.tsv PP.tsv 3PP.tsv --failure peaks.tsv --toml
  [[ $stderr == "gws-solve identify: doubt: failure_line: fitted to as many points as constants, so the scatter "* ]] || show
  printf '%s\n' "$output" > soil.toml
  exits 0 gws-solve respond --geotextile PP --soil soil.toml --samples 50 -o bands.h5
  [[ $stderr == *"doubt: failure_line: fitted to as many points as constants"* ]] || show
  [[ $output == *"Constants varied by their scatter: C_t, p_0, kappa, "*"$held"*"M, n, p_c, "* ]] || show
  printf '200\t1.61\n' >> peaks.tsv
  exits 0 gws-solve identify PE.tsv PP.tsv 3PP.tsv --failure peaks.tsv --toml
  [[ $stderr != *"as many points"* ]] || show
  printf '%s\n' "$output" > soil.toml
  exits 0 gws-solve respond --geotextile PP --soil soil.toml --samples 200
  [[ $output == *"Constants varied by their scatter: C_t, p_0, n, p_c, "*"$held"* ]] || show
  local used left
  read -r used left < <(sed -nE 's/^([0-9]+) draws \(([0-9]+) of 200 left out\): .*/\1 \2/p' <<< "$output")
  [[ $((used + left)) -eq 200 && $left -gt 0 ]] || show "draws that were left out count"
}

@test "geotextiles in another order than their series are a doubt" {
  local geotextile
  for geotextile in PE PP 3PP; do gws-solve respond --geotextile "$geotextile" --tsv | cut -f 4,6,10,11 > "$geotextile.tsv"; done
  exits 0 gws-solve identify PE.tsv PP.tsv 3PP.tsv --geotextile PP --geotextile PE --geotextile 3PP --set failure_line.n=0.0723
  [[ $stderr == *": doubt: the points hardly determine these constants: stiffness: "*"beta "*"; must be from 0 to 2"*"R2 "*"; check that the geotextiles are in the order of the series, "* ]] || show
  exits 0 gws-solve identify PE.tsv PP.tsv 3PP.tsv --geotextile PE --geotextile PP --geotextile 3PP --set failure_line.n=0.0723
  [[ -z $stderr ]] || show "nothing is doubtful"
}

@test "options on which nothing depends are refused" {
  refuses 64 respond "--seed has no effect without --samples: leave it out" --geotextile PP --seed 3
  refuses 64 respond "--range has no effect without --sensitivity: leave it out" --geotextile PP --samples 9 --range 0.3
  refuses 64 respond "--points has no effect beside --sensitivity without -o: leave it out" --geotextile PP --sensitivity --points 7
  refuses 64 design "--points has no effect without --chart: leave it out" --surcharge 3e5 --points 7
  refuses 64 design "--from has no effect without --surcharge or --chart: leave it out" --geotextile PP --settlement 0.05 --from 5e3
  refuses 64 identify "--table increments: chooses the table that --tsv prints: give --tsv too, or leave it out" PP.tsv --table increments
  refuses 64 identify "--group loading has no effect: no series is a fields file: leave it out" "$DEM/soilbag_uniaxial_PP.tsv" --group loading
  refuses 64 identify "--strains natural has no effect: runs and their tables loading and reinforced tell their strains: leave it out" \
    "$DEM/../../pipelines/ch5/kept/uc_PP.tsv" --geotextile PP --strains natural
}

@test "the sensitivity names every constant" {
  exits 0 gws-solve respond --geotextile PP --sensitivity
  local constant
  for constant in C_t kappa p_1 alpha poisson_ratio geotextile.strength height; do
    [[ $output == *"$constant "* ]] || show "no $constant"
  done
  exits 0 gws-solve respond --geotextile PP --sensitivity --tsv
  [[ ${#lines[@]} -eq 21 ]] || show "${#lines[@]} lines"
}

@test "a lateral history and a compaction are followed" {
  printf 'surcharge [kPa]\tlateral_stress [kPa]\n20\t0\n500\t100\n' > history.tsv
  gws-solve respond --geotextile PP --lateral-history history.tsv --surcharge 500e3 --tsv > response.tsv
  near "$(value response.tsv lateral_stress last)" 100e3 1e-9
  exits 0 gws-solve respond --geotextile PP --initial-settlement 0.02
  [[ $output == *"Compacted to 134.9 kPa, which it took 2.00 % of its height to reach"* ]] || show
}

@test "a lateral history is doubted where an answer leaves it on either side, and its refusals name the file" {
  local verb
  printf 'surcharge [kPa]\tlateral_stress [kPa]\n100\t10\n150\t12\n' > history.tsv
  for verb in "respond --surcharge 300e3" "design --surcharge 300e3 --chart --points 2 --from 200e3 --to 400e3"; do
    # shellcheck disable=SC2086  # several words
    exits 0 gws-solve $verb --soil toyoura-gws --geotextile PP --lateral-history history.tsv
    [[ $stderr == *"the history of the lateral stress begins at a surcharge of 100 kPa, and its first value, 10 kPa, is taken \
from 7.50"*" kPa on; give rows from 0 kPa on"* ]] || show
    [[ $stderr == *"ends at a surcharge of 150 kPa, and its last value, 12 kPa, is kept up to "* ]] || show
  done
  exits 0 gws-solve design --settlement 0.1 --safety 4 --soil toyoura-gws --geotextile PP --lateral-history history.tsv
  [[ $stderr == *"its last value, 12 kPa, is kept up to 1776 kPa"* ]] || show "the safety counts against a load beyond the history"
  printf 'surcharge [kPa]\tlateral_stress [kPa]\n0\t10\n300\t12\n' > history.tsv
  exits 0 gws-solve respond --soil toyoura-gws --geotextile PP --surcharge 300e3 --lateral-history history.tsv
  [[ $stderr != *"history"* ]] || show
  printf 'surcharge [kPa]\tlateral_stress [kPa]\n400\t80\n200\t80\n' > history.tsv
  refuses 65 respond "history.tsv: lateral stress: row 2: the surcharge 200000 Pa is not above the one before; the model \
cannot unload: give rows that rise" --geotextile PP --lateral-history history.tsv
}

@test "a column that could be meant for a needed one is refused by name" {
  printf 'surcharge [kPa]\tlateral_stress [kPa]\tlateral_stress_upper [kPa]\n0\t10\t20\n' > history.tsv
  refuses 65 respond "history.tsv: its columns lateral_stress and lateral_stress_upper could both be meant: leave one of them out, \
and head the other lateral_stress" --geotextile PP --lateral-history history.tsv
  printf 'confining_pressure [kPa]\tobliquity_at_failure [1]\tObliquity_at_failure [1]\n100\t1.4\t1.5\n200\t1.3\t1.4\n' > points.tsv
  refuses 65 identify "points.tsv: its columns obliquity_at_failure and Obliquity_at_failure could both be meant: leave one of them out, \
and head the other obliquity_at_failure" "$DEM/soilbag_uniaxial_PE.tsv" --failure points.tsv
}

@test "what is inadmissible is refused with range and reason" {
  refuses 64 respond "--stiffness: -5 is out of range: must be between 0 and 1e10 N/m (without stiffness the \
geotextile holds nothing)" --geotextile PP --stiffness -5
  refuses 64 respond "--height: 0 is out of range: must be between 0 and 100 m (a bag has an extent; millimetres are written \"400 mm\")" \
    --geotextile PP --height 0
  refuses 65 respond "surcharge: 1000 Pa is below the initial one, 4169.3 Pa (mean stress 2600 Pa); the model \
has no state there" --geotextile PP --surcharge 1000
  refuses 65 respond "geotextile PO: unknown; multiples such as 3PP and paths of TOML files are taken too; did \
you mean 'PE'?" --geotextile PO
  exits 65 gws-solve respond --geotextile PP --set stiffness.poisson_ratio=0.5
  [[ $stderr == *"stiffness.poisson_ratio: 0.5 is out of range: must be between -1 and 0.5 (at 0.5 the soil"* ]] || show
  exits 65 gws-solve respond --geotextile PP --initial-surcharge 1000
  [[ $stderr == *"initial surcharge: 1000 Pa is not from 4169.3 Pa"* ]] || show
  refuses 64 respond "no geotextile: give --geotextile NAME, or --stiffness and one of --strength, \
--failure-strain"
  refuses 64 identify "--table: 'kappa' is not one of constants, compression_line, failure_line, near_failure_line, \
dilatancy_line, stiffness, increments" "$DEM/soilbag_uniaxial_PE.tsv" --table kappa
  refuses 64 design "nothing to design for: give --surcharge or --settlement" --geotextile PP
}

@test "a surcharge that is not reached has status 1, its table is printed all the same" {
  exits 1 gws-solve respond --geotextile PE --surcharge 1e6
  [[ $output == *"Ultimate bearing capacity 584.6 kPa"* ]] || show
  [[ $stderr == *$'\n'"gws-solve respond: 1000 kPa are not reached: the bag bears 584.592 kPa: the hoop strain reaches the stated \
fraction of the geotextile's strength" ]] || show
  exits 1 gws-solve design --surcharge 300e3 --settlement 0.001
}

@test "each verb has help that fits a screen, a page, and examples that run" {
  local verb command
  for geotextile in PE PP 3PP; do gws-solve respond --geotextile "$geotextile" --tsv > "$geotextile.tsv"; done
  for verb in respond identify design; do
    exits 0 gws-solve "$verb" --help
    [[ $(wc -l <<<"$output") -le 45 && $(wc -L <<<"$output") -le 100 ]] || show "$verb --help is too large"
    local examples=0
    while IFS= read -r command; do
      exits 0 bash -c "set -o pipefail; $command" || show "example of $verb: $command"
      examples=$((examples + 1))
    done < <(awk '/^[A-Z]/ { on = /^Example/ } on && /^  [^ ]/ { sub(/^  /, ""); print }' <<<"$output")
    ((examples > 0)) || show "$verb --help has no example"
    exits 0 gws-solve "$verb" --man
    [[ ${lines[0]} == ".TH gws\\-solve\\-$verb 1 "* ]] || show "$verb --man"
    exits 0 bash -c "source <(gws-solve --completion); COMP_WORDS=(gws-solve $verb --geo); COMP_CWORD=2; _gws_solve; \
      echo \${COMPREPLY[@]}"
    [[ $output == --geotextile ]] || show "completes --geo to this after $verb"
  done
  # shellcheck disable=SC2016  # expanded by the inner shell
  exits 0 bash -c 'source <(gws-solve --completion); COMP_WORDS=(gws-solve re); COMP_CWORD=1; _gws_solve; echo ${COMPREPLY[@]}'
  [[ $output == respond ]] || show "completes re to this"
}

@test "a verb is needed, comes first, and is told by its nearest" {
  complains 64 gws-solve "a verb is missing; give one of respond, identify, design, or see 'gws-solve --help'"
  complains 64 gws-solve "'respnd' is no verb; did you mean 'respond'?" respnd
  complains 64 gws-solve "respond: the verb comes first: 'gws-solve respond ...'" --quiet respond
}

@test "a response doubts the settlements of a weakened soil, a design has the soil's own" {
  local verb=(respond --surcharge '300 kPa')
  exits 0 gws-solve "${verb[@]}" --soil toyoura-gws --geotextile PP
  [[ $stderr != *factor-soil* ]] || show
  exits 0 gws-solve "${verb[@]}" --soil toyoura-gws --geotextile PP --factor-soil 1.25
  [[ $stderr == "gws-solve respond: doubt: --factor-soil counts against failure alone, "*"leave it out for settlements, or use design" ]] || show
  exits 0 gws-solve design --surcharge '300 kPa' --soil toyoura-gws --geotextile PP --factor-soil 1.25
  [[ $stderr != *factor-soil* ]] || show
}

@test "a soil that nobody chose and constants beyond their data are said, in the file too" {
  exits 0 gws-solve respond --geotextile PP -o out.h5
  [[ $stderr == "gws-solve respond: doubt: the soil is toyoura-gws, since none was chosen: give --soil"* ]] || show
  [[ $output == "Soil toyoura-gws, since no --soil is given"* ]] || show
  exits 0 gws-solve respond --geotextile PP --soil toyoura-gws
  [[ -z $stderr && $output == "Geotextile PP"* ]] || show "nothing is doubtful"
  exits 0 gws-solve respond --geotextile 6PP --soil toyoura-gws -o far.h5
  [[ $stderr == *"doubt: the constants of toyoura-gws are extrapolated: stiffness of the geotextile 1392 kN/m (identified on 53 to 696 kN/m)"* ]] ||
    show
  exits 0 to-vtk --history far.h5
  [[ $output == *"  doubt: extrapolation: the constants of toyoura-gws"* ]] || show
  exits 0 gws-solve respond --geotextile PP --soil toyoura-gws --width "80 mm" --height "0.4 m" --lateral-stress "150 kPa"
  [[ $stderr == *"doubt: the solution is untested here: height over width 5 (simulated bags had 0.2), lateral stress 150 kPa (simulated under 0 to 100 kPa)"* ]] || show
  # Below about 30 kPa of surcharge no geotextile is stretched in a cell under 10 kPa; under 20 MPa none ever is.
  exits 0 gws-solve respond --geotextile PP --soil toyoura-gws --lateral-stress "10 kPa" --surcharge "20 kPa"
  [[ $stderr == *"doubt: at 20 kPa the lateral stress outside, 10 kPa, exceeds the soil's"* ]] || show
  exits 65 gws-solve respond --geotextile PP --lateral-stress "20 MPa"
  [[ $stderr == "gws-solve respond: lateral stress: 20000 kPa outside the bag exceed the soil's own, 1.556 kPa, "*"take a smaller lateral stress" ]] || show
  exits 65 gws-solve design --geotextile PP --chart --lateral-stress "20 MPa"
  [[ $stderr == *"design: lateral stress: 20000 kPa outside the bag exceed the soil's own"* && -z $output ]] || show "a chart without a value"
  # The series that identification read give the range of its constants.
  exits 0 gws-solve identify "$DEM"/soilbag_uniaxial_{PE,PP}.tsv --toml
  [[ $output == *$'[identified]\nstiffness = [53000, 232000]\n'* ]] || show
}
