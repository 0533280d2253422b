#!/usr/bin/env bats
# gws-solve: thirty data sheets and questions as a design office types them. Each is answered, or refused in one line that tells what
# to change.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup() {
  cd "$BATS_TEST_TMPDIR" || return
  # The sheets: a woven one with both directions, one that is stiff at first, and some that cannot be.
  cat > woven.toml <<'TOML'
name = "woven"
[machine]
tension_at_2 = "14 kN/m"
tension_at_5 = "35 kN/m"
strength = "80 kN/m"
failure_strain = "12 %"
[cross]
tension_at_2 = "12 kN/m"
tension_at_5 = "30 kN/m"
strength = "70 kN/m"
failure_strain = "11 %"
TOML
  printf 'name = "PET"\ntension_at_2 = "35.7 kN/m"\ntension_at_5 = "73.9 kN/m"\nstrength = "160 kN/m"\nfailure_strain = "12 %%"\n' > pet.toml
  printf 'name = "fraction"\nfailure_strain = "0.12 %%"\nstiffness = "232 kN/m"\nstrength = "30 kN/m"\n' > fraction.toml
  printf 'name = "stiff"\nfailure_strain = 0.12\nstiffness = "232 MN/m"\nstrength = "30 kN/m"\n' > stiff.toml
  printf 'name = "falls"\ntension_at_2 = "30 kN/m"\ntension_at_5 = "25 kN/m"\nstrength = "80 kN/m"\nfailure_strain = "12 %%"\n' > falls.toml
  printf 'name = "early"\ntension_at_5 = "35 kN/m"\nstrength = "80 kN/m"\nfailure_strain = "4 %%"\n' > early.toml
  printf 'name = "bare"\ntension_at_5 = "35 kN/m"\nstrength = "80 kN/m"\n' > bare.toml
  printf 'name = "blunt"\ntension_at_5 = "35 kN/m"\nfailure_strain = "10 %%"\n' > blunt.toml
  printf 'name = "both"\nstiffness = "400 kN/m"\ntension_at_5 = "35 kN/m"\nstrength = "80 kN/m"\nfailure_strain = "12 %%"\n' > both.toml
  printf 'name = "plain"\nstrength = "60 kN/m"\nfailure_strain = 0.12\nstiffness = 600\n' > plain.toml
  printf 'name = "mixed"\nstrength = "60 kN/m"\nfailure_strain = 0.12\ntension_at_5 = 30\n' > mixed.toml
  sed 's/"\([0-9.]*\) kN\/m"/\1/' pet.toml > unitless.toml
  sed '/tension_at_2 = "12/d' woven.toml > half.toml
  { sed 's/^name.*/[[product]]\nname = "W70"/; s/^\[machine\]/[product.machine]/; s/^\[cross\]/[product.cross]/' woven.toml
    sed 's/^name.*/\n[[product]]\nname = "P160"/' pet.toml; } > catalogue.toml
  { cat catalogue.toml; sed 's/^name.*/\n[[product]]\nname = "P160"/' pet.toml; } > two.toml
  sed 's/product.cross/product.cros/; /^$/,$d' catalogue.toml > typing.toml
  { cat catalogue.toml; echo 'rf_creep = 2.5'; } > creep.toml
  echo 'product = [{name = "I", stiffness = "400 kN/m", strength = "60 kN/m", failure_strain = "10 %"}, {name = "J", stiffness = "400 kN/m", strength = "60 kN/m", failure_strain = "10 %", strngth = 1}]' > inline.toml
  sed 's/^\(\[*\)product/\1products/' catalogue.toml > plural.toml
  sed 's/^name = "W70"/&\nstrength = "75 kN\/m"/' catalogue.toml > beside.toml
  sed '/^\[cross/,$d' woven.toml > oneway.toml
  sed 's/^\[machine/[MD/; s/^\[cross/[CD/' woven.toml > letters.toml
  printf 'name = "site sand"\n[estimate]\nfriction_angle = 38\ndilation_angle = 8\nE50 = "40 MPa"\nvoid_ratio = 0.6\n' > site.toml
  printf 'name = "tested"\n[estimate]\ntriaxial = "%s/../../data/laboratory/toyoura_drained_triaxial_0.2MPa.tsv"\nvoid_ratio = 0.68\n' \
    "$BATS_TEST_DIRNAME" > curves.toml
  mkdir lab
  sed 's/^triaxial.*/triaxial = "test.tsv"\npressure = "200 kPa"/' curves.toml > lab/soil.toml
  grep -v '^#' "$BATS_TEST_DIRNAME/../../data/laboratory/toyoura_drained_triaxial_0.2MPa.tsv" > lab/test.tsv
  sed "s|^triaxial.*|triaxial = \"$BATS_TEST_DIRNAME/../../data/own/example/drained_100kPa.tsv\"\npressure = \"200 kPa\"|" curves.toml > lab/other.toml
  for case in reversed percent ratio; do sed "s/test.tsv/$case.tsv/" lab/soil.toml > "lab/$case.toml"; done
  { head -1 lab/test.tsv; tail -n +2 lab/test.tsv | tac; } > lab/reversed.tsv
  awk -F'\t' -v OFS='\t' 'NR > 1 { $1 *= 100 } { print }' lab/test.tsv | sed '1s/ \[[^]]*\]//' > lab/percent.tsv
  awk -F'\t' -v OFS='\t' 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i ~ /stress_ratio/) k = i } NR > 1 { $k = 3 * ($k - 1) / ($k + 2) } { print }' \
    lab/test.tsv > lab/ratio.tsv
  echo $'surcharge [kPa]\tlateral_stress [kPa]' > empty.tsv
  sed 's/^friction_angle.*/friction_angle = 5/' site.toml > weak.toml
  sed 's/^dilation_angle.*/dilation_angle = 29/; s/^friction_angle.*/friction_angle = 28/' site.toml > wild.toml
}

# STATUS ; words of the first line that answers (on standard output) or refuses (on standard error) ; arguments of gws-solve
questions() {
  cat <<'TABLE'
0;Ends at 200.0 kPa at a settlement of;respond --soil toyoura-gws --geotextile woven.toml --surcharge "200 kPa"
0;strength 70 kN/m, strain at failure 11 %;respond --soil toyoura-gws --geotextile woven.toml
0;strength 80 kN/m, strain at failure 12 %;respond --soil toyoura-gws --geotextile woven.toml@machine
0;strength 140 kN/m;respond --soil toyoura-gws --stiffness "1200 kN/m" --strength "140 kN/m"
0;secant at the;respond --soil toyoura-gws --geotextile pet.toml --surcharge "500 kPa"
0;at the same tension of 80 kN/m;respond --soil toyoura-gws --geotextile pet.toml --surcharge "500 kPa"
0;at the same tension of 1.14 kN/m;respond --soil toyoura-gws --geotextile PP --stiffness "8 kN/m"
0;Geotextile W70: ;respond --soil toyoura-gws --geotextile catalogue.toml:W70@cross
0;Smallest stiffness;design --soil toyoura-gws --surcharge "300 kPa" --settlement "5 %" --safety 1.5
64;--geotextile is given twice: PP and PE; give one;design --soil toyoura-gws --geotextile PP --settlement 0.05 --geotextile PE
64;--rf-creep is given twice: 2 and 3; give one;respond --soil toyoura-gws --geotextile PP --rf-creep 2 --rf-creep=3
0;soil softer, Young;respond --soil toyoura-gws --geotextile PP --geotextile PP --set near_failure_line.kappa=1.5 --set near_failure_line.kappa=1.6 --set name=softer
0;Carries;design --soil toyoura-gws --geotextile catalogue.toml:P160 --settlement "5 %"
0;Long-term strength: 90.61 kN/m over creep 2, installation 1, durability 1 leaves 45.3 kN/m;design --soil toyoura-gws --geotextile PP --surcharge "1500 kPa" --safety 1.5 --rf-creep 2
0;leaves 14.43 kN/m;respond --soil toyoura-gws --geotextile PP --rf-creep 2 --rf-installation 1.1
0;multiplied by 1.35, and tan phi divided by 1.25;design --soil toyoura-gws --geotextile PP --settlement "5 %" --factor-load 1.35 --factor-soil 1.25
0;Failure is counted at 1 of the strength.;respond --soil toyoura-gws --geotextile PP --strength-fraction 1
0;Failure is counted at 0.5 of the strength, the default: in the thesis's;respond --soil toyoura-gws --geotextile PP
0;apparent cohesion 347.5 kPa;respond --soil toyoura-gws --geotextile PP
0;At the surcharge asked for:;respond --soil toyoura-gws --geotextile PP --surcharge "300 kPa" --sensitivity
0;Soil site sand: estimated from phi 38 deg, psi 8 deg, E50 40 MPa under 100 kPa, e 0.6: no bags of it were computed;respond --soil site.toml --geotextile PP
0;Soil toyoura-gws, since no --soil is given;design --surcharge "300 kPa"
64;--stiffness: 400 N/m is less than any geotextile has (2000 N/m); did you mean "400 kN/m"?;respond --stiffness 400 --strength "40 kN/m"
64;--strength: 40 N/m is less than any geotextile has (500 N/m); did you mean "40 kN/m"?;respond --stiffness "400 kN/m" --strength 40
64;--surcharge: 300 Pa is less than a person standing on the bag; did you mean "300 kPa"?;respond --geotextile PP --surcharge 300
64;--strength: tells no kind of geotextile: give --stiffness and one of;design --surcharge "300 kPa" --strength 10e3
64;--strength: tells no kind of geotextile: give --stiffness and one of;design --surcharge "300 kPa" --strength 10e3 --failure-strain 0.1
64;--stiffness: tells no kind of geotextile: give --stiffness and one of;design --surcharge "300 kPa" --stiffness 200e3
0;Smallest stiffness;design --soil toyoura-gws --surcharge "300 kPa" --settlement 0.05 --safety 1.5 --failure-strain 0.02
0;Smallest stiffness;design --soil toyoura-gws --surcharge "300 kPa" --stiffness 200e3 --strength 10e3
64;millimetres are written "400 mm";respond --geotextile PP --width 400
64;per cent are written "12 %";respond --geotextile PP --failure-strain 12
64;per cent are written "12 %";respond --geotextile PP --failure-strain "0.12 %"
65;stiff.toml: stiffness is 2.32e+05 kN/m, strength over failure_strain 250 kN/m: they contradict each other;respond --geotextile stiff.toml
65;fraction.toml:2: failure_strain: '0.12 %' is out of range: must be between 0.01 and 2 (a strain of 1;respond --geotextile fraction.toml
64;contradict each other: 400 kN/m at 5 % are 20 kN/m;respond --stiffness "400 kN/m" --strength "80 kN/m" --failure-strain "5 %"
64;must be from 1 to 100 (a factor below 1 would take away safety);respond --geotextile PP --rf-creep 0.5
65;falls.toml: 25 kN/m at a strain of 5 % is not above 30 kN/m at 2 %;respond --geotextile falls.toml
65;early.toml: it fails at a strain of 4 %, but a tension is given at 5 %;respond --geotextile early.toml
65;bare.toml: no strain at failure: give it, as failure_strain = "10 %";respond --geotextile bare.toml
65;blunt.toml: no strength: give the tension at failure;respond --geotextile blunt.toml
65;both.toml: stiffness and tensions at strains both tell a stiffness: leave one of them out;respond --geotextile both.toml
65;half.toml: [cross] has no tension_at_2, which [machine] has: give it, or choose a direction (NAME@machine);respond --geotextile half.toml
65;catalogue.toml: is a catalogue: name one of its products, as catalogue.toml:W70 (W70, P160);respond --geotextile catalogue.toml
65;plain.toml:4: stiffness: 600 N/m is less than any geotextile has (2000 N/m); did you mean "600 kN/m"?;respond --geotextile plain.toml
65;unitless.toml:4: strength: 160 N/m is less than any geotextile has (500 N/m); did you mean "160 kN/m"?;respond --geotextile unitless.toml
65;mixed.toml: 0.03 kN/m at a strain of 5 % beside 60 kN/m at 12 %: check both units;respond --geotextile mixed.toml
65;two.toml: 2 of its [[product]] are named P160: give each a name of its own;respond --geotextile two.toml:P160
65;typing.toml:8: unknown key 'product.0.cros';respond --geotextile typing.toml:W70@machine
65;creep.toml:20: unknown key 'product.1.rf_creep'; known: cross, failure_strain, machine, name,;respond --geotextile creep.toml:P160
0;Geotextile W70;respond --soil toyoura-gws --geotextile creep.toml:W70
0;Geotextile I;respond --soil toyoura-gws --geotextile inline.toml:I
65;inline.toml:1: unknown key 'product.1.strngth'; did you mean 'strength'?;respond --geotextile inline.toml:J
65;plural.toml:1: unknown key 'products'; did you mean 'product'?;respond --geotextile plural.toml:W70
65;beside.toml: W70: strength stands beside the tables of its directions: move it into [machine] and [cross];respond --geotextile beside.toml:W70
65;oneway.toml: has [machine] alone, and a bag is stretched both ways: give [cross] too, or take that one for both (NAME@machine);respond --geotextile oneway.toml
0;strength 80 kN/m;respond --soil toyoura-gws --geotextile oneway.toml@machine
65;oneway.toml: has no [cross]: write it, or leave out @cross;respond --geotextile oneway.toml@cross
65;letters.toml: [MD] is no table of a sheet: the directions are written [machine] and [cross];respond --geotextile letters.toml
65;catalogue.toml: has no [[product]] named W71; did you mean 'W70'?;respond --geotextile catalogue.toml:W71
65;'along' is no direction: give @machine or @cross;respond --geotextile woven.toml@along
65;greater --strength-fraction;respond --geotextile PP --strength-fraction 0
65;estimate.pressure: is missing;respond --soil curves.toml --geotextile PP
65;row 1: its lateral stress is 99.63 kPa, and pressure says 200 kPa: check both;respond --soil lab/other.toml --geotextile PP
0;under 200 kPa, e 0.68: no bags of it were computed;respond --soil lab/soil.toml --geotextile PP
65;lab/reversed.tsv: row 2: the axial strain falls: leave out unloading, and give rows in the order of the test;respond --soil lab/reversed.toml --geotextile PP
65;which must be below 1: per cent are written [%] in the header;respond --soil lab/percent.toml --geotextile PP
65;it is 1 at rest and no soil bears more than 15: check stress_ratio or deviatoric_stress;respond --soil lab/ratio.toml --geotextile PP
64;--lateral-stress: 50 Pa is less than a person standing on the bag; did you mean "50 kPa"?;respond --geotextile PP --lateral-stress 50
64;--factor-load multiplies the surcharge: give one too;respond --geotextile PP --factor-load 1.5
65;empty.tsv: has no rows: give one at least, or leave out --lateral-history;respond --soil toyoura-gws --geotextile PP --lateral-history empty.tsv
0;no capacity for a bag so slender;respond --soil toyoura-gws --geotextile PP --width "80 mm" --height "400 mm"
65;friction_angle: 5 is out of range: must be from 15 to 60 deg;respond --soil weak.toml --geotextile PP
65;dilation_angle: is not below the friction angle: check both, 0 is on the safe side;respond --soil wild.toml --geotextile PP
0;Ultimate bearing capacity;respond --soil toyoura-gws --geotextile PP --factor-soil 1.5
0;Smallest stiffness;design --soil toyoura-gws --surcharge "300 kPa" --factor-soil 1.5
0;Neither settlement nor strength governs,;design --soil toyoura-gws --surcharge "300 kPa"
0;The settlement governs.;design --soil toyoura-gws --surcharge "300 kPa" --settlement "5 %"
0;The strength governs.;design --soil toyoura-gws --geotextile oneway.toml@machine --surcharge "300 kPa"
0;Carries;design --soil site.toml --geotextile PP --settlement "5 %" --factor-soil 1.5
65;--factor-soil: 5 lowers M from 1.35 to;design --soil toyoura-gws --geotextile PP --surcharge "300 kPa" --chart --factor-soil 5
65;a dilation angle of 30 deg is too near to the friction angle of 38 deg: q/p at failure would be M at no pressure of a test; take at most;respond --soil site.toml --geotextile PP --set estimate.dilation_angle=30
0;Ultimate bearing capacity;respond --soil site.toml --geotextile PP --set estimate.dilation_angle=26.3
0;soil toyoura-gws (changed), Young;respond --soil toyoura-gws --geotextile PP --set near_failure_line.kappa=1.2
0;soil softer, Young;respond --soil toyoura-gws --geotextile PP --set near_failure_line.kappa=1.6 --set name=softer
1;300 kPa are not reached: the bag bears;respond --soil toyoura-gws --geotextile PE --rf-creep 3 --rf-durability 1.5 --surcharge "300 kPa"
1;no stiffness up to 1e+05 kN/m carries 300 kPa within a settlement of 0.1 %; allow more;design --soil toyoura-gws --surcharge "300 kPa" --settlement "0.1 %"
TABLE
}

@test "what design answers for a data sheet, respond settles as asked" {
  local scale
  printf 'name = "slack"\ntension_at_2 = "2 kN/m"\ntension_at_5 = "8 kN/m"\nstrength = "60 kN/m"\nfailure_strain = "10 %%"\n' > slack.toml
  gws-solve design --soil toyoura-gws --geotextile slack.toml --settlement "5 %" --tsv > allowance.tsv
  gws-solve respond --soil toyoura-gws --geotextile slack.toml --surcharge "$(value allowance.tsv surcharge 1)" --tsv > service.tsv
  near "$(value service.tsv settlement last)" 0.05 1e-6
  exits 0 gws-solve design --soil toyoura-gws --geotextile slack.toml --surcharge "300 kPa" --settlement "5 %"
  [[ $output == "Smallest stiffness 98.622 kN/m (secant at the 2.719 % it reaches) with a strength of 46.796 kN/m, 0.7799 times the tensions of slack"* ]] || show
  scale=0.7799
  awk -v scale=$scale '/kN/ { match($0, /[0-9.]+ kN/); n = substr($0, RSTART) * scale; sub(/"[0-9.]+/, "\"" n) } { print }' slack.toml > scaled.toml
  gws-solve respond --soil toyoura-gws --geotextile scaled.toml --surcharge "300 kPa" --tsv > service.tsv
  near "$(value service.tsv settlement last)" 0.05 1e-3
}

@test "thirty questions are answered, or refused in one line that tells what to change" {
  local wanted words arguments count=0
  while IFS=';' read -r wanted words arguments; do
    # "; did you mean" and "; allow more" belong to the words: the arguments begin with a verb.
    while [[ $arguments != respond\ * && $arguments != design\ * ]]; do
      words+=";${arguments%%;*}" arguments=${arguments#*;}
    done
    eval "exits $wanted gws-solve $arguments"
    if [[ $wanted == 0 ]]; then
      [[ $output == *"$words"* ]] || show "wanted in the answer of gws-solve $arguments: $words"
      [[ $output != *nan* || $arguments == *--strength-fraction\ 1* ]] || show "no number in gws-solve $arguments"
    else
      # shellcheck disable=SC2154  # stderr is set by call
      [[ $(grep -vc ': doubt: ' <<<"$stderr") -eq 1 && $stderr == *"$words"* ]] || show "wanted in one line of gws-solve $arguments: $words"
    fi
    count=$((count + 1))
  done < <(questions)
  [[ $count -ge 30 ]] || show "$count questions"
}

# STATUS ; words on standard error, none for a table that is right ; awk program that changes columns 1 to 3 (strains in %, q in kPa) or the head
tables_of_tests() {
  cat <<'TABLE'
0;;
65;t.tsv: is an undrained test by its pore_pressure, at rising or falling pore pressure: give a drained one;n == 1 { $4 = "pore_pressure [kPa]" } n > 1 { $4 = -0.3 * $3 }
65;t.tsv: the volumetric strain is 0 in all rows, as in an undrained test: give a drained one;n > 1 { $2 = 0 }
65;t.tsv: row 30: volumetric strain falls to nothing at an axial strain of 6.18 %, where rows beside it do not: leave out rows without a value;n == 31 { $2 = 0 }
65;t.tsv: row 30: deviatoric_stress falls to nothing at an axial strain of 6.18 %;n == 31 { $3 = 0 }
65;t.tsv: row 30: the volumetric strain is -9.162 % at an axial strain of 6.18 %, more than a drained test has;n == 31 { $2 = -9.162 }
65;t.tsv: axial over radial stress never exceeds 1.004: check the unit of deviatoric_stress and pressure;n > 1 { $3 /= 1000 }
0;doubt: t.tsv: the volume expands first and contracts then;n > 1 { $2 = -$2 }
0;doubt: t.tsv: deviatoric_stress of row 30, at an axial strain of 6.18 %, lies far from the rows beside it;n == 31 { $3 *= 1.5 }
0;doubt: t.tsv: the volumetric strain of row 30, at an axial strain of 6.18 %, lies far from the rows beside it;n == 31 { $2 += 2.2 }
0;doubt: t.tsv: the volumetric strain stays below 0.1 % up to an axial strain of 23.8 %, as in an undrained test, or with fractions;n > 1 { $2 /= 100 }
0;doubt: t.tsv: the axial strain is 1 % in row 1, where axial over radial stress is still 1.02: strains count from;n > 1 { $1 += 1 }
0;doubt: t.tsv: the axial strain is 5.12 % in row 1, and rises by 0.145 % at most from row to row after it: strains count from the end;n > 1 && $1 == 0 { next } n > 1 { $1 += 5 }
0;doubt: t.tsv: the volumetric strain is 1.08 % in row 1, more than the axial strain: strains count from the end;n > 1 && $1 == 0 { next } n > 1 { $2 += 1 }
0;;n > 1 && $1 < 3 { next } n > 1 && n % 10 { next }
0;doubt: t.tsv: axial_strain has no unit and is taken for a fraction;n == 1 { $1 = "axial_strain" } n > 1 { $1 /= 100 }
0;doubt: t.tsv: the column axial_stress is not read;n == 1 { $4 = "axial_stress [kPa]" } n > 1 { $4 = $3 + 100 }
0;doubt: t.tsv: the column deviatoric_stress_corrected is not read, but deviatoric_stress: if it is meant, leave deviatoric_stress out and give;n == 1 { $4 = "deviatoric_stress_corrected [kPa]" } n > 1 { $4 = $3 + 5 }
0;doubt: t.tsv: the column axial_strain is not read;n == 1 { $4 = "strain_axial [%]" } n > 1 { $4 = $1 + 5 }
0;doubt: t.tsv: its friction angle is 57.1 deg, where granular soils have 22 to 55;n > 1 { $3 *= 2.82 }
0;doubt: E50 is 3.14 MPa under 100 kPa, where Toyoura sand has 36.1 MPa: check its unit;n > 1 { $1 *= 3; $3 /= 3 }
TABLE
}

@test "a triaxial table that no drained test gives is refused by its row, and an unusual one is a doubt" {
  local wanted words change
  printf 'name = "x"\n[estimate]\ntriaxial = "t.tsv"\npressure = "100 kPa"\nvoid_ratio = 0.758\n' > x.toml
  while IFS=';' read -r wanted words change; do
    grep -v '^#' "$BATS_TEST_DIRNAME/../../data/own/example/drained_100kPa.tsv" | cut -f 1-3 |
      awk -F '\t' -v OFS='\t' "{ n = NR } $change { print }" > t.tsv
    exits "$wanted" gws-solve respond --soil x.toml --geotextile PP
    [[ $stderr == *"$words"* ]] || show "wanted: $words"
    [[ -n $words || $stderr != *t.tsv* && $stderr != *E50\ is* ]] || show "the table is right"
  done < <(tables_of_tests)
}
