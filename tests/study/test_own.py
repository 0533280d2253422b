"""A soil of one's own: own.toml refused by key, sets of a posterior, intervals of the answer, the forecast."""
# SPDX-License-Identifier: GPL-3.0-or-later
import math
import os
import pathlib
import re
import shutil
import subprocess
import types

import numpy
import pytest
from own import constants, forecast, inputs, sets, transfer
from own import study as page
from study import StudyError, Table

EXAMPLE = pathlib.Path(__file__).parents[2] / "data/own/example"
CATALOGUE = EXAMPLE.parents[1] / "geotextiles"


@pytest.fixture(name="soil")
def example(tmp_path):
    return pathlib.Path(shutil.copytree(EXAMPLE, tmp_path / "soil")) / "own.toml"


def test_the_example_is_read_and_written_for_make(soil, tmp_path):
    own = inputs.read(soil, CATALOGUE)
    assert len(own.tests) == 2 and len(own.predictions) == 1 and own.fabric.stiffness == 232e3
    assert own.reduction == pytest.approx(2.64)
    inputs.write(own, tmp_path / "out")
    made = (tmp_path / "out/inputs.mk").read_text()
    assert "OWN_SURCHARGE := 200000.0\n" in made and f"OWN_FAILURE := --failure {tmp_path}/out/failure.tsv\n" in made
    assert "--predict '" in made and made.count("--test '") == 2
    failure = Table.read(tmp_path / "out/failure.tsv")
    assert failure("obliquity_at_failure", "1") == pytest.approx([1.6526, 1.5953], rel=1e-4)
    assert "OWN_REDUCED := --strength-fraction 1.0 --rf-creep 2.0 --rf-installation 1.2 --rf-durability 1.1\n" in made
    assert 'strength = "31754.0 N/m"' in (tmp_path / "out/geotextile.toml").read_text()
    # The page of one geotextile: yarns 5 mm apart carry the stiffness.
    assert "yarn_tension = [145.0]" in (tmp_path / "out/geotextile_1.toml").read_text()


@pytest.mark.parametrize(("old", "new", "said"), [
    ("void_ratio = 0.756", "void_ratio = 75.6", "void_ratio = 75.6: void ratios of granular soils"),
    ("\nvoid_ratio", "\nvoidratio", "voidratio is unknown; did you mean 'void_ratio'?"),
    ('surcharge = "200 kPa"', "surcharge = 200", "surcharge = 200: write a number above 0 with its unit"),
    ('surcharge = "200 kPa"', 'surcharge = "200 mm"', "surcharge: 'mm' is a unit of length"),
    ("settlement = 0.05", "settlement = 5", "settlement = 5: write a fraction"),
    ('geotextile = "PP"', 'geotextile = "PQ"', 'geotextile = "PQ" is not in'),
    ('geotextile = "PP"', 'geotextile = {strength = "30 kN/m", failure_strain = 15}', "failure_strain = 15: write a fraction"),
    ('geotextile = "PP"', 'geotextile = {strength = "30 kN/m", failure_strain = 0.15, stiffness = "9 kN/m"}', "contradict each other"),
    ('geotextile = "PP"', 'geotextile = "3PQ"', '"3PQ" is not in'),
    ('geotextile = "PP"', 'geotextile = "PP@across"', "'across' is no direction"),
    ('geotextile = "PP"', 'geotextile = "sheets.toml:A"', "sheets.toml: cannot be read"),
    ('geotextile = "PP"', 'geotextile = {tension_at_2 = "9 kN/m", strength = "30 kN/m", failure_strain = "15 %", stiffness = "200 kN/m"}',
     "geotextile.stiffness stands beside tension_at_2"),
    ('geotextile = "PP"', 'geotextile = {tension_at_5 = "31 kN/m", strength = "30 kN/m", failure_strain = "15 %"}', "is not above tension_at_5"),
    ('geotextile = "PP"', 'geotextile = {tension_at_5 = "9 kN/m", strength = "30 kN/m", failure_strain = "4 %"}', "but tension_at_5 is given"),
    ('geotextile = "PP"', 'geotextile = {strength = "30 kN/m", machine = {strength = "30 kN/m", failure_strain = 0.1}}', "stands beside the tables"),
    ('geotextile = "PP"', 'geotextile = {machine = {strength = "30 kN/m"}, cross = {strength = "30 kN/m", failure_strain = 0.1}}',
     "geotextile.machine has no failure_strain"),
    ('geotextile = "PP"', 'geotextile = {strength = "30 kN/m"}', "geotextile.failure_strain is missing"),
    ('geotextile = "PP"', 'geotextile = {strength = "30 kN/m", failure_strain = "0.12 %"}', 'failure_strain = 0.12 %: geotextiles break above 1 %; write 12 %'),
    ('geotextile = "PP"', 'geotextile = {machine = {strength = "30 kN/m", failure_strain = 0.12}, cross = {strength = "30 kN/m", failure_strain = 0.0012}}',
     "geotextile.cross.failure_strain = 0.12 %"),
    ('geotextile = "PP"', 'geotextile = {tension_at_2 = "0.05 kN/m", strength = "30 kN/m", failure_strain = "12 %"}',
     "geotextile.tension_at_2 = 0.05 kN/m beside strength = 30 kN/m at 12 %: check both units"),
    ('width = "400 mm"', 'width = "400"', "bag.width = '400': write a number above 0 with its unit, as \"400 mm\""),
    ('width = "400 mm"', 'width = "400 kPa"', "bag.width: 'kPa' is a unit of"),
    ('width = "400 mm"', 'widht = "400 mm"', "bag.widht is unknown; did you mean 'width'?"),
    ('width = "400 mm"', 'width = "400 m"', "bag.width = 400 m: bags measure 0.01 to 100 m"),
    ('height = "80 mm"', 'height = "0.08 mm"', "bag.height = 8e-05 m: bags measure"),
    ('surcharge = "200 kPa"', 'surcharge = "200 MPa"', "surcharge = 200000 kPa: bags carry 1 to 10000 kPa"),
    ('surcharge = "200 kPa"', 'surcharge = "200 Pa"', "surcharge = 0.2 kPa: bags carry"),
    ('geotextile = "PP"', 'geotextile = {strength = "60 N/m", failure_strain = 0.1}', "geotextile.strength = 0.06 kN/m: geotextiles have 0.5 to"),
    ('geotextile = "PP"', 'geotextile = {strength = "60 MN/m", failure_strain = 0.1}', "geotextile.strength"),
    ('table = "drained_400kPa.tsv"\nconfining_pressure = "400 kPa"', 'table = "drained_100kPa.tsv"\nconfining_pressure = "100 kPa"',
     "two tests have a table of this name and 100 kPa"),
    ("creep = 2.0", "creep = inf", "factors.creep = inf: write a number above 0"),
    ('surcharge = "200 kPa"', 'surcharge = "1e400 kPa"', "write a number above 0 with its unit"),
    ("creep = 2.0", "creep = 0.5", "factors.creep = 0.5: this factor is from 1 to 10"),
    ("creep = 2.0", "creep = 200", "factors.creep = 200: this factor is from 1 to 10; write 1.35, not 135"),
    ("load = 1.0", "load = 135", "factors.load = 135: this factor is from 1 to 10"),
    ("soil = 1.0", "soil = 3", "factors.soil = 3: this factor is from 1 to 2"),
    ('geotextile = "PP"', 'geotextile = {strength = "0.6 kN/m", failure_strain = 0.9}', "strength over failure_strain is 0.6667 kN/m"),
    ("settlement = 0.05", "settlement = 0.05\nstrength_fraction = 1.5", "strength_fraction = 1.5: write a share of the strength"),
    ("settlement = 0.05", "settlement = 0.05\nstrength_fraction = 0", "strength_fraction = 0"),
    ("creep = 2.0", "crep = 2.0", "factors.crep is unknown; did you mean 'creep'?"),
    ('"engineering"', '"enginering"', "test 1: strains = \"enginering\"; did you mean 'engineering'?"),
    ('confining_pressure = "100 kPa"', 'confining_pressure = "300 kPa"', "correct the one that is wrong"),
    ('confining_pressure = "100 kPa"', "", "test 1: confining_pressure is missing"),
    ('table = "drained_100kPa.tsv"', 'table = "drained.tsv"', "drained.tsv: cannot be read"),
    ('name = "Karlsruhe fine sand"', 'name = " "', "name = ' ': write one line of text"),
    ('name = "Karlsruhe fine sand"', 'name = "sand\\nof mine"', "name = 'sand\\nof mine': write one line of text"),
    ("[[test]]", "[[test", "own.toml: ")])
def test_what_is_wrong_is_one_line_with_file_and_key(soil, old, new, said):
    text = soil.read_text()
    assert old in text
    soil.write_text(text.replace(old, new, 1))
    with pytest.raises(StudyError) as error:
        inputs.read(soil, CATALOGUE)
    assert said in str(error.value) and str(soil.parent) in str(error.value) and "\n" not in str(error.value)


@pytest.mark.parametrize(("rows", "said"), [
    ("diameter [m]\tfiner_by_mass [1]\n0.14\t0.5\n0.28\t1", "row 2: diameter is 280 mm, where granular soils have 0.002 to 200 mm"),
    ("diameter [um]\tfiner_by_mass [1]\n0.14\t0.5\n0.28\t1", "row 1: diameter is 0.00014 mm"),
    ("diameter [mm]\tfiner_by_mass [1]\n0\t0\n0.28\t1", "row 1: diameter is 0 mm"),
    ("diameter [mm]\tfiner_by_mass [1]\n0.14\t50\n0.28\t100", "row 1: finer_by_mass is 5000 %: it lies between 0 and 100 %"),
    ("diameter [mm]\tfiner_by_mass [1]\n0.14\t-0.1\n0.28\t1", "row 1: finer_by_mass is -10 %"),
    ("diameter [mm]\tfiner_by_mass [1]\n0.28\t0.5\n0.14\t1", "diameters have to rise"),
    ("diameter [mm]\tfiner_by_mass [1]\n0.14\t0.5\n0.28\t0.9", "finer_by_mass to end at 1")])
def test_a_grading_that_no_soil_has_is_refused_by_row(soil, rows, said):
    (soil.parent / "grading.tsv").write_text(rows + "\n")
    with pytest.raises(StudyError) as error:
        inputs.read(soil, CATALOGUE)
    assert said in str(error.value) and str(soil.parent / "grading.tsv") in str(error.value)


@pytest.mark.parametrize(("rows", "said"), [
    ("0.01\t0\n0.05\t0.6\n0.2\t1", ["63.5 % of the mass is finer than 0.063 mm: silt"]),
    ("2\t0\n20\t1", []), ("2\t0\n20.1\t1", ["its largest grains measure 20.1 mm in a bag of 80 mm: fewer than 4 over its height"])])
def test_silt_and_grains_too_large_for_the_bag_are_doubted(soil, rows, said):
    (soil.parent / "grading.tsv").write_text(f"diameter [mm]\tfiner_by_mass [1]\n{rows}\n")
    found = inputs.doubts(inputs.read(soil, CATALOGUE))
    assert len(found) == len(said) and all(words in line for words, line in zip(said, found, strict=True))


def test_a_copy_of_a_test_is_refused_before_anything_is_packed(soil):
    shutil.copy(soil.parent / "drained_100kPa.tsv", soil.parent / "copy.csv")
    soil.write_text(soil.read_text().replace('"drained_200kPa.tsv"\nconfining_pressure = "200 kPa"', '"copy.csv"\nconfining_pressure = "100 kPa"'))
    with pytest.raises(StudyError, match=r"copy.csv: has 85 of 85 rows of .*drained_100kPa.tsv: a test counts once, and cannot predict itself"):
        inputs.read(soil, CATALOGUE)


def test_a_prior_beside_own_toml_is_judged_and_a_test_needs_rows_up_to_the_strain_that_is_compared(soil):
    with pytest.raises(StudyError, match="drained_100kPa.tsv: 0 rows have a rising axial strain above 0 and up to 0.01 %"):
        inputs.read(soil, CATALOGUE, until=0.01)
    (soil.parent / "prior.toml").write_text('[[parameter]]\nname = "sliding_damping"\nlow = 0.1\nhigh = 0.9\n')
    with pytest.raises(StudyError, match=r"soil/prior.toml: no run depends on a parameter named 'sliding_damping'"):
        inputs.read(soil, CATALOGUE)


@pytest.mark.parametrize(("old", "new", "said"), [
    ('{width = "400 mm", height = "80 mm"}', '{width = "80 mm", height = "400 mm"}', "the bag is 80 mm wide and 400 mm high"),
    ('geotextile = "PP"', 'geotextile = {machine = {strength = "30 kN/m", failure_strain = 0.1}}', "values of its machine direction alone"),
    ('geotextile = "PP"', 'geotextile = {strength = "30 N/mm", failure_strain = "1.2 %"}', "failure_strain = 1.2 %, where polymers break at more than 2 %"),
    ('geotextile = "PP"', 'geotextile = {strength = "3 MN/m", failure_strain = "10 %"}', "the greatest stiffness of geotextile, 3e+04 kN/m, is more than 20000"),
    ('"drained_100kPa.tsv"', '"weak.tsv"', "q/p at failure, 1.5 at 100 kPa and 1.6 at 400 kPa, does not fall with the pressure")])
def test_what_is_unusual_is_doubted(soil, tmp_path, old, new, said):
    inputs.write(inputs.read(soil, CATALOGUE), tmp_path / "out")
    assert (tmp_path / "out/inputs.said").read_text() == ""
    head, *rows = [line for line in (soil.parent / "drained_100kPa.tsv").read_text().splitlines() if not line.startswith("#")]
    cells = [row.split("\t") for row in rows]
    (soil.parent / "weak.tsv").write_text("\n".join(["\t".join(head.split("\t")[:3]), *("\t".join([a, v, repr(0.8 * float(q))]) for a, v, q, _ in cells)]) + "\n")
    soil.write_text(soil.read_text().replace(old, new, 1))
    inputs.write(inputs.read(soil, CATALOGUE), tmp_path / "out")
    lines = (tmp_path / "out/inputs.said").read_text().splitlines()
    assert len(lines) == 1 and lines[0].startswith("own: doubt: ") and said in lines[0]


def test_strengths_that_do_not_fall_take_the_exponent_of_toyoura_sand():
    assert inputs.failure_options([(100, 1.65), (400, 1.6)], "failure.tsv") == "--failure failure.tsv"
    # The last two are scatter at nearly one pressure.
    for rows in ([(100, 1.6), (400, 1.6)], [(100, 1.6), (400, 1.599)], [(100, 1.7), (110, 1.66)]):
        assert inputs.failure_options(rows, "failure.tsv").startswith("--set failure_line.p_c=")
    identified = "compression_line: 12 points, R2 1\nnear_failure_line: 12 points\nstiffness: 4 points\n"
    own = types.SimpleNamespace(curves=[])
    for points, failure_line in (([(100, 1.65), (400, 1.6)], "failure line"), ([(100, 1.6)], "exponent of the failure line")):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(page, "failures", lambda _, points=points: (points, []))
            assert page.borrowed(identified, own) == [failure_line, "dilatancy line"]


def test_no_greater_factor_leaves_a_greater_share_of_the_strength(soil, tmp_path):
    text, shares = soil.read_text(), []
    for creep in (1.0, 1.0001, 1.05, 1.5, 1.9999, 2.0, 2.0001, 3.0, 10.0):
        soil.write_text(text.replace("creep = 2.0, installation = 1.2, durability = 1.1", f"creep = {creep}"))
        own = inputs.read(soil, CATALOGUE)
        shares.append(own.strength_fraction / own.reduction)
        inputs.write(own, tmp_path / "out")
        assert f"--strength-fraction {min(1.0, 0.5 * creep)!r} --rf-creep {creep!r}\n" in (tmp_path / "out/inputs.mk").read_text()
    assert shares == pytest.approx([0.5] * 6 + [1 / 2.0001, 1 / 3, 0.1]) and all(b <= a * (1 + 1e-12) for a, b in zip(shares, shares[1:], strict=False))
    soil.write_text(text.replace("settlement = 0.05", "settlement = 0.05\nstrength_fraction = 0.8"))
    assert inputs.read(soil, CATALOGUE).strength_fraction == 0.8


def make(soil, out, tools, *goals):
    """Runs make with tools that only write their output; returns what they were called with after the inputs were judged, and what make says.

    With -p among the goals, it returns the lines of make's database instead.
    """
    (tools / "log").write_text("")
    root = EXAMPLE.parents[2]
    # A make that runs the tests would hand its job server down, of which this one would warn.
    alone = {name: value for name, value in os.environ.items() if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL")}
    command = ["make", "-s", f"BIN={tools}", f"OUT={out}", f"SOIL={soil}", *goals]
    done = subprocess.run(command, cwd=root, env=alone, capture_output=True, text=True, check=False)
    if "-p" in goals:
        return done.stdout.splitlines(), done.stderr
    return [line for line in (tools / "log").read_text().splitlines() if "draw" not in line], done.stderr


@pytest.fixture(name="tools")
def writers(tmp_path):
    folder = tmp_path / "tools"
    folder.mkdir()
    for name in ("pack-generate", "pf-weight"):
        (folder / name).write_text(f'#!/bin/sh\necho {name} "$@" >> {folder}/log\nwhile [ $# -gt 1 ]; do [ "$1" = -o ] && echo > "$2"; shift; done\n')
        (folder / name).chmod(0o755)
    (folder / "gws-solve").write_text("#!/bin/sh\nexit 0\n")
    (folder / "gws-solve").chmod(0o755)
    return folder


@pytest.mark.parametrize(("tool", "ends", "said"), [
    ("gws-solve", 'gws-solve design: doubt: far off\ngws-solve design: --factor-soil: 2 lowers M; give a smaller factor\n', "own.toml: factors.soil: 2 lowers M; give a smaller factor"),
    ("gws-solve", "gws-solve respond: {out}/geotextile.toml:3: strength: is odd\n", "own.toml: geotextile: strength: is odd"),
    ("pf-weight", "pf-weight draw: {out}/prior.toml:9: parameter.0.scale: is odd\n", "prior.toml:9: parameter.0.scale: is odd")])
def test_the_tools_judge_the_inputs_before_anything_is_packed(soil, tmp_path, tools, tool, ends, said):
    out = tmp_path / "out/own/soil"
    words = (tools / tool).read_text()
    for status, packed in ((65, False), (1, True)):
        (tools / tool).write_text(f"#!/bin/sh\nprintf '%s' '{ends.format(out=out)}' >&2\nexit {status}\n")
        called, lines = make(soil.parent, tmp_path / "out", tools, out / "packing_1.h5")
        assert bool(called) == (out / "packing_1.h5").exists() == packed
        assert lines.startswith(f"own: {soil.parent}/{said}\nmake") != packed, lines
    # A packing is not made anew because the inputs are judged anew.
    (tools / tool).write_text(words)
    (out / "judged").unlink()
    assert not make(soil.parent, tmp_path / "out", tools, out / "packing_1.h5")[0] and (out / "judged").exists()


def test_the_tools_at_hand_take_the_example(soil, tmp_path):
    tools = pathlib.Path(os.environ.get("BIN", EXAMPLE.parents[2] / "build/bin")).resolve()
    if not all((tools / name).exists() for name in ("gws-solve", "pf-weight")):
        pytest.skip("gws-solve and pf-weight are not built")
    log = tmp_path / "log"
    log.mkdir()
    for name in ("gws-solve", "pf-weight"):
        (log / name).symlink_to(tools / name)
    judged = tmp_path / "out/own/soil/judged"
    assert not make(soil.parent, tmp_path / "out", log, judged)[1] and judged.exists()
    soil.write_text(soil.read_text().replace('surcharge = "200 kPa"', 'surcharge = "1 kPa"'))
    assert "own.toml: surcharge: 1000 Pa is below the initial one" in make(soil.parent, tmp_path / "out", log, judged)[1]


def test_a_design_that_an_option_of_own_toml_hinders_is_an_error(soil, tmp_path, tools):
    out = tmp_path / "out/own/soil"
    make(soil.parent, tmp_path / "out", tools, out / "judged")
    (out / "loads").write_text("1e5 2e5\n")
    for said, left in (("--factor-soil: 2 lowers M", False), ("no state under it", True)):
        (tools / "gws-solve").write_text(f"#!/bin/sh\necho 'gws-solve design: {said}' >&2\nexit 65\n")
        make(soil.parent, tmp_path / "out", tools, "-o", out / "loads", out / "design.tsv")
        assert (out / "design.tsv").exists() == left


def test_make_goes_by_the_content_of_what_own_toml_names(soil, tmp_path, tools):
    out, packing = tmp_path / "out", tmp_path / "out/own/soil/packing_1.h5"
    assert len(make(soil.parent, out, tools, packing)[0]) == 1 and not make(soil.parent, out, tools, packing)[0]
    # Another grading that is older than the packing, in another folder; and the first one touched.
    (tmp_path / "elsewhere").mkdir()
    grading = pathlib.Path(shutil.copy(soil.parent / "grading.tsv", tmp_path / "elsewhere/my grading's.csv"))
    (soil.parent / "grading.tsv").touch()
    assert not make(soil.parent, out, tools, packing)[0]
    text = grading.read_text()
    grading.write_text(text.replace("0.02\n", "0.03\n", 1))
    os.utime(grading, (1, 1))
    soil.write_text(soil.read_text().replace('"grading.tsv"', '"../elsewhere/my grading\'s.csv"'))
    assert len(make(soil.parent, out, tools, packing)[0]) == 1 and "0.03" in (out / "own/soil/grading.tsv").read_text()
    # A test that is a CSV with blanks in its name.
    (soil.parent / "drained_100kPa.tsv").rename(soil.parent / "drained 100 kPa.csv")
    soil.write_text(soil.read_text().replace("drained_100kPa.tsv", "drained 100 kPa.csv"))
    make(soil.parent, out, tools, packing)
    table = out / "own/soil/tests/100kPa/drained_100_kPa.tsv"
    assert str(table) in (out / "own/soil/inputs.mk").read_text()
    before = table.stat().st_mtime_ns
    make(soil.parent, out, tools, packing)
    assert table.stat().st_mtime_ns == before
    (soil.parent / "drained 100 kPa.csv").write_text("# corrected\n" + table.read_text())
    make(soil.parent, out, tools, packing)
    assert table.read_text().startswith("# corrected")


def test_what_the_tests_of_a_soil_are_run_with_makes_its_calibration_anew(soil, tmp_path, tools):
    out = tmp_path / "out"
    database, _ = make(soil.parent, out, tools, "-p", "-n", "-q", out / "own/soil/page.html")
    for target in ("calibration/posterior.h5", "checked_1"):
        needs = next(line for line in database if line.startswith(f"{out}/own/soil/{target}: "))
        assert "pipelines/calibration/hertz-mindlin.toml" in needs.split()


def test_make_refuses_a_second_folder_of_one_name_and_names_that_it_cannot_take(soil, tmp_path, tools):
    out, packing = tmp_path / "out", tmp_path / "out/own/soil/packing_1.h5"
    make(soil.parent, out, tools, packing)
    other = shutil.copytree(soil.parent, tmp_path / "b/soil")
    called, said = make(other, out, tools, packing)
    assert not called and f"holds the results of {soil.parent}, a folder of the same name as {other}: rename one" in said
    # A folder that was moved goes on.
    soil.parent.rename(tmp_path / "moved")
    assert not make(other, out, tools, packing)[1]
    for name in ("my soil", "my'soil", "my$$soil"):
        called, said = make(tmp_path / name, out, tools, "own")
        assert not called and "make cannot use a folder with blanks, quotes or signs" in said and said.count("\n") == 1


def test_make_refuses_a_strain_of_bags_in_per_cent(soil, tmp_path, tools):
    for strain in ("12", "12 %", "x"):
        called, said = make(soil.parent, tmp_path / "out", tools, f"OWN_STRAIN={strain}", tmp_path / "out/own/soil/packing_1.h5")
        assert not called and f"OWN_STRAIN={strain}: give a share of the height between 0.01 and 0.5, as 0.12 for 12 %" in said


def test_a_data_sheet_without_stiffness_gives_a_secant_and_one_test_a_failure_line(soil):
    soil.write_text(soil.read_text().replace('"PP"', '{strength = "30 kN/m", failure_strain = 0.15}', 1))
    assert inputs.read(soil, CATALOGUE).fabric.stiffness == pytest.approx(200e3)
    assert 'stiffness = "200000.0 N/m"' in inputs.read(soil, CATALOGUE).fabric.file()
    option = inputs.failure_options([(100, 1.6526)], "failure.tsv")
    p_c = float(option.removeprefix("--set failure_line.p_c="))
    assert inputs.M * (300e3 / (3 - 1.6526) / p_c)**-inputs.EXPONENT == pytest.approx(1.6526, rel=1e-5)


def test_a_geotextile_is_a_sheet_a_multiple_or_a_product(soil):
    text = soil.read_text()

    def read(given):
        soil.write_text(text.replace('"PP"', given, 1))
        return inputs.read(soil, CATALOGUE).fabric
    assert read('"3PP"').stiffness == 3 * 232e3 and read('"0.5PP"').points["strength"] == 0.5 * 31754
    sides = 'name = "A"\n{}machine = {{tension_at_5 = "20 kN/m", strength = "60 kN/m", failure_strain = "10 %"}}\n' \
            'cross = {{tension_at_5 = "15 kN/m", strength = "70 kN/m", failure_strain = 0.12}}\n'
    (soil.parent / "sheets.toml").write_text(f"[[product]]\n{sides.format('')}")
    (soil.parent / "A.toml").write_text(sides.format(""))
    # At the lesser strength the softer direction is stretched farther.
    lesser = {"tension_at_5": 15e3, "strength": 60e3, "failure_strain": 0.05 + 0.07 * 45 / 55}
    assert read('"sheets.toml:A"').points == read('"A.toml"').points == pytest.approx(lesser)
    machine = read('"sheets.toml:A@machine"')
    assert machine.stiffness == pytest.approx(600e3) and machine.points["tension_at_5"] == pytest.approx(20e3)
    for listed, said in (("product = 3\n", "is a table [[product]] with a name"), ("[[product]]\nstrength = 3\n", "with a name"),
                         ("[[product]]\nname = 'A'\n" * 2, "two products have one name"), ("", "has no [[product]] named 'A'")):
        (soil.parent / "other.toml").write_text(listed)
        with pytest.raises(StudyError, match=re.escape(said)):
            read('"other.toml:A"')
    # The solution refuses a stiffness beside the points of a curve.
    assert "stiffness" not in machine.file() and 'tension_at_5 = "20000.0 N/m"' in machine.file()


def test_draws_stand_for_the_weights(tmp_path):
    path = tmp_path / "sets.tsv"
    head = "id [1]\tyoung_modulus [Pa]\tpoisson_ratio [1]\trolling_stiffness [1]\trolling_limit [1]\tfriction_angle [deg]\n"
    path.write_text(head + "".join(f"{k}\t4e9\t0.2\t0.1\t{0.1 * k}\t{20 + k}\n" for k in range(4)))
    some = Table.read(path)
    weights = Table([["0", "0.25"], ["1", "0"], ["2", "0.5"], ["3", "0.25"]], {"id": "1", "weight": "1"}, "weights")
    assert sorted(sets.drawn(some, weights, 4)) == [0, 2, 2, 3]
    assert sets.table(some, [2, 3], 2).splitlines()[4].split("\t") == ["3", "4000000000.0", "0.2", "0.1", "0.30000000000000004", "23.0", "1"]
    assert "contact.rolling.stiffness=0.8 " in sets.options(some, 0, 2) and "contact.rolling.limit=none" in sets.options(some, 0, 2)


def linear(name, end, load, unit="Pa"):
    """Returns a table of a load that grows to `load` at `end`."""
    rows = [["0", "0"], [repr(end), repr(float(load))]]
    return Table(rows, {name: "1", "surcharge": unit}, "linear")


def test_the_answer_has_the_factor_of_the_bags_and_their_scatter():
    asked = Table([["0", "1", "1", "1"], ["0.1", "100", "80", "125"]],
                  {"settlement": "1", "surcharge": "kPa", "surcharge_low": "kPa", "surcharge_high": "kPa"}, "asked")
    loads = [linear("strain_axial", 0.08, 80e3 * share) for share in (1, 2, 4, 2, 1)]
    told = transfer.Transfer(asked, linear("settlement", 0.5, 250e3), loads)
    factor = 2 * numpy.exp(numpy.mean(numpy.log([1, 2, 4, 2, 1])))
    assert told.factor(0.05) == pytest.approx(factor) and told.factor(0.1) == pytest.approx(told.factor(0.08))
    median, low, high = told.at(0.1)
    # Student's deviate of 80 % for five values, and a normal one for the constants, whose 95 % are 1.25 apart either way.
    bags = 1.5332 * numpy.std(numpy.log([1, 2, 4, 2, 1]), ddof=1) * numpy.sqrt(1.2)
    spread = numpy.hypot(bags, 1.2816 * numpy.log(1.25) / 1.96)
    assert (median, low, high) == pytest.approx((100 * factor, 100 * factor * numpy.exp(-spread), 100 * factor * numpy.exp(spread)))
    assert transfer.loads_of_design(told, 200e3, 0.3) == pytest.approx((200e3 / factor, 200e3 / factor * numpy.exp(spread)))
    with pytest.raises(StudyError, match="a simulated bag carries nothing at a settlement of 0.05"):
        transfer.Transfer(asked, linear("settlement", 0.5, 250e3), [*loads, linear("strain_axial", 0.08, 0)]).factor(0.05)


def test_four_bands_in_five_hold_a_further_bag():
    draws = numpy.random.default_rng(1).normal(size=(20000, 6))
    held = [abs(row[5] - row[:5].mean()) < transfer.scatter(numpy.exp(row[:5])) for row in draws]
    assert numpy.mean(held) == pytest.approx(0.8, abs=0.01)


def test_a_forecast_reads_what_a_check_says():
    line = "about 7 min: 164087 steps (97 % of them waiting for rest) of 13797 grains with 15031 contacts in 420 s: 3.941e+02 steps/s, 169 ns"
    assert forecast.seconds_of(line) == (164087, 13797, 394.1)
    with pytest.raises(StudyError):
        forecast.seconds_of("nothing")


def columns(path, **given):
    """Writes a table of heads without their units and (unit, values)."""
    path.parent.mkdir(parents=True, exist_ok=True)
    rows = zip(*(values for _, values in given.values()), strict=True)
    path.write_text("\t".join(f"{name} [{unit}]" for name, (unit, _) in given.items()) + "\n"
                    + "".join("\t".join(map(repr, row)) + "\n" for row in rows))


@pytest.fixture(name="out")
def results(soil, tmp_path, monkeypatch):
    """Writes the results of own/study.mk on a small scale: a bag that bears 1000 kPa times its settlement over 10 %, to 4 or to 10 %."""
    monkeypatch.chdir(EXAMPLE.parents[2])
    out = tmp_path / "out"
    inputs.write(inputs.read(soil), out)

    def make(end):
        load = numpy.linspace(0, 1e7 * end, 11) + 1
        columns(out / "bands.tsv", settlement=("1", numpy.linspace(0, end, 11).tolist()),
                **{f"surcharge{e}": ("Pa", (f * load).tolist()) for e, f in (("_low", 0.9), ("", 1), ("_high", 1.1))})
        columns(out / "of_grains.tsv", settlement=("1", [0, 0.5]), surcharge=("Pa", [0, 5e6]))
        for name in ("design", "design_high"):
            columns(out / f"{name}.tsv", stiffness=("N/m", [1e5]), strength=("N/m", [5e3]), settlement=("1", [0.05]))
        for name, said in (("bands", "gws-solve respond: doubt: it is extrapolated\n"), ("design", "")):
            (out / f"{name}.said").write_text(said)
        for name, share in zip([f"uc_{k}" for k in range(1, 5)] + [f"other_{k}_3" for k in range(1, 5)], (1, 1, 1, 1, 1.2, 1 / 1.2, 1.1, 1 / 1.1), strict=True):
            columns(out / f"{name}.tsv", stage=("1", [0, 1, 1]), strain_axial=("1", [-0.1, 0, 0.1]), surcharge=("Pa", [0, 0, 1e6 * share]),
                    mean_stress=("Pa", [1, 2, 3]), deviatoric_stress=("Pa", [1, 2, 3]))
        columns(out / "draws.tsv", id=("1", [0, 1, 2, 3]), young_modulus=("Pa", [4e9] * 4), poisson_ratio=("1", [0.2] * 4),
                rolling_stiffness=("1", [0.1] * 4), rolling_limit=("1", [0.1] * 4), friction_angle=("deg", [25.0, 25.0, 25.0, 30.0]))
        for k in (1, 3, 4, 5):
            (out / f"packing_{k}.said").write_text("")
        (out / "packing_2.said").write_text("pack-generate: doubt: many rattlers\n")
        (out / "identified.said").write_text("gws-solve identify: doubt: failure_line: the scatter is unknown\n")
        columns(out / "chart.tsv", stiffness=("N/m", [1e4, 1e5]), allowable_surcharge=("Pa", [1e5, 2e5]), capacity=("Pa", [2e5, 4e5]))
        for seed in (1, 2):
            columns(out / f"check_{seed}.tsv", id=("1", [0, 0, 1, 1]), stress_ratio=("1", [2.0, 4.0, 2.0, 4.2]))
        heads = {f"{name}{end}": (unit, [1.0, 2.0, 3.0]) for name, unit in (("stress_ratio", "1"), ("strain_volumetric", "%"))
                 for end in ("", "_observed", "_low", "_high", "_deviation")}
        for test in ("drained_100kPa_100kPa", "drained_400kPa_400kPa", "drained_200kPa_200kPa"):
            columns(out / f"calibration/predicted_{test}.tsv", strain_axial=("%", [1.0, 2.0, 3.0]), **heads)
        columns(out / "calibration/misfits.tsv", stress_ratio=("1", [0.1]))
        columns(out / "constants.tsv", middle=("1", [1.0]))
        for name in ("calibration/said.txt", "calibration/posterior.txt", "identified.txt", "provenance.txt"):
            (out / name).write_text("effective sample size 20\n")
        return page.build(types.SimpleNamespace(out=out, profile="quick", soil=soil.parent, kept=False))
    return make


def test_the_page_says_what_the_bag_carries_and_where_its_geotextile_ends(out):
    study = out(0.1)
    low, high = (study.measures[f"carried_{end}"].value for end in ("low", "high"))
    assert study.measures["carried"].value == pytest.approx(500, rel=1e-4) and low < 450 < 550 < high
    assert study.measures["needed_strength_high"].value == pytest.approx(5) and study.measures["packings_apart"].value == 0
    assert study.measures["factor"].value == pytest.approx(1) and study.measures["bags_apart"].value == pytest.approx(14.5, abs=0.1)
    assert any("sets of contact parameters drawn from the posterior (2 different ones)" in text for text in study.remarks)
    # The report of the identification names no line at all.
    assert "Taken from Toyoura sand instead of this soil: " in study.headline and "stiffness." in study.headline
    assert "at 5.00 % settlement." in study.headline.replace("\xa0", " ") and all(any(doubt in text for text in study.remarks) for doubt in ("it is extrapolated", "many rattlers", "the scatter is unknown"))
    study.write()
    assert (study.out / "page.html").exists()


@pytest.mark.parametrize(("old", "new", "said"), [
    ("creep = 2.0", "creep = 2.0", "Failure is counted at 0.379 of the strength of the data sheet. That is what reduction factors of 2.64 in all leave."),
    ("creep = 2.0", "creep = 1.0", "Failure is counted at 0.5 of the strength of the data sheet. In the thesis's discrete elements"),
    ("settlement = 0.05", 'settlement = 0.05\nstrength_fraction = "66 %"', "Failure is counted at 0.25 of the strength of the data sheet. That is the strength_fraction")])
def test_the_page_says_which_share_of_the_strength_counts_and_why(out, soil, monkeypatch, old, new, said):
    monkeypatch.setattr(page, "draw", lambda *_: None)
    soil.write_text(soil.read_text().replace(old, new))
    assert any(said in text.replace("\xa0", " ") for text in out(0.1).remarks)


def test_doubts_that_differ_in_numbers_are_one_and_name_variables_of_make(tmp_path):
    for k, (wide, grains) in enumerate((("2.99", 528), ("2.98", 534), ("2.99", 528))):
        (tmp_path / f"{k}.said").write_text(f"made\npack-generate: doubt: the cell is {wide} wide: about {grains} grains (--grains)\n")
    (tmp_path / "3.said").write_text("gws-solve: doubt: p_0 is -1.8e+03\ngws-solve: doubt: p_0 is -1.8e+03\n")
    assert page.doubts(tmp_path, ["0", "1", "2", "3"]) == [
        "the cell is 2.99 wide: about 528 grains (OWN_GRAINS) (and 1 more with other numbers)", "p_0 is -1.8e+03"]
    assert page.in_make("give more --rounds or --samples") == "give more OWN_ROUNDS or OWN_SAMPLES"


def test_constants_have_the_ranges_of_one_more_packing(tmp_path):
    def soil(kappa, xi=None):
        text = f"[near_failure_line]\nkappa = {kappa}\nxi = {xi or 0}\n[stiffness]\nalpha = 1e7\n[failure_line]\nM = 1.35\nn = 0.1\n"
        text += "[scatter.near_failure_line]\nkappa = 0.1\nfreedom = 3\n" + ("xi = 0.01\ncorrelation = [1, 0, 0, 1]\n" if xi else "")
        return text + "[scatter.failure_line]\nn = 0.01\n"
    for name, text in (("soil", soil(1, 0.1)), ("soil_1", soil(4, 0.3)), ("soil_2", soil(2, 0.2)), ("soil_3", soil(2)), ("soil_4", "")):
        (tmp_path / f"{name}.toml").write_text(text)
    (tmp_path / "constants.tsv").write_text(constants.table(tmp_path))
    read = Table.read(tmp_path / "constants.tsv")
    assert read("packings", "1").tolist() == [4, 3] and len(read) == 2
    # Student's deviates of 80 %: 1.6377 for four values, 1.8856 for three.
    kappa = math.log(2) * 1.6377 * math.sqrt(2 / 3 * 5 / 4)
    for name, expected in (("packing_1", [1, 0.1]), ("middle", [2, 0.2]), ("low_80", [2 * math.exp(-kappa), 0.2 - 0.18856 * math.sqrt(4 / 3)]),
                           ("high_80", [2 * math.exp(kappa), 0.2 + 0.18856 * math.sqrt(4 / 3)]),
                           ("high_95", [2 * math.exp(kappa * 3.1824 / 1.6377), 0.2 + 0.43027 * math.sqrt(4 / 3)])):
        assert read(name, "1").tolist() == pytest.approx(expected, rel=1e-5)
    # One packing has no range.
    for k in (1, 2, 3):
        (tmp_path / f"soil_{k}.toml").write_text("")
    (tmp_path / "constants.tsv").write_text(constants.table(tmp_path))
    read = Table.read(tmp_path / "constants.tsv")
    assert read("packings", "1").tolist() == [1, 1] and numpy.isnan(read("low_95", "1", missing=True)).all()


def test_the_page_says_where_the_geotextile_ends_before_the_settlement(out, monkeypatch):
    monkeypatch.setattr(page, "draw", lambda *_: None)
    study = out(0.04)
    assert study.measures["carried"].value == pytest.approx(400, rel=1e-4) and "where its geotextile fails" in study.headline


@pytest.mark.parametrize(("empty", "said"), [(["design_high"], "at the low end of the range no geotextile is enough."),
                                             (["design", "design_high"], "For 200 kPa within 5 % no geotextile is stiff enough.")])
def test_the_page_says_where_no_geotextile_is_enough(out, monkeypatch, empty, said):
    monkeypatch.setattr(page, "draw", lambda *_: None)
    measured = page.measure

    def measure(study, *words):
        for name in empty:
            (study.out / f"{name}.tsv").write_text("")
        measured(study, *words)
    monkeypatch.setattr(page, "measure", measure)
    study = out(0.1)
    assert said in study.headline.replace("\xa0", " ") and study.measures["needed_strength_high"].reason == "no geotextile is enough"


def test_both_directions_together_are_never_stiffer_than_one(soil):
    text = soil.read_text()

    def read(word):
        soil.write_text(text.replace('"PP"', word, 1))
        return inputs.read(soil, CATALOGUE).fabric
    (soil.parent / "sides.toml").write_text('machine = {strength = "60 kN/m", failure_strain = "10 %"}\ncross = {strength = "40 kN/m", failure_strain = "20 %"}\n')
    both, machine, cross = (read(f'"sides.toml{end}"') for end in ("", "@machine", "@cross"))
    assert both.stiffness <= min(machine.stiffness, cross.stiffness) == pytest.approx(200e3)
    assert both.points["strength"] == 40e3


@pytest.mark.parametrize(("axial", "volumetric", "said"), [(2, 0, "the axial strain is 2 % in row 1"), (0, 1.5, "the volumetric strain is 1.5 % in row 1"),
                                                           (0, -1.2, "the volumetric strain is -1.2 % in row 1")])
def test_strains_that_count_from_elsewhere_are_doubted(soil, tmp_path, axial, volumetric, said):
    table = soil.parent / "drained_100kPa.tsv"
    head, *rows = [line for line in table.read_text().splitlines() if not line.startswith("#")]
    cells = [[float(c) for c in row.split("\t")] for row in rows]
    table.write_text("\n".join([head, *(f"{a + axial}\t{v + volumetric}\t{q}\t{p}" for a, v, q, p in cells)]) + "\n")
    soil.write_text(soil.read_text().replace('"engineering"', '"natural"', 1))
    inputs.write(inputs.read(soil, CATALOGUE, 8), tmp_path / "out")
    assert said in (tmp_path / "out/inputs.said").read_text()


def test_shares_of_a_prior_are_not_taken_in_percent(soil):
    text = (EXAMPLE.parents[2] / "pipelines/own/prior.toml").read_text()
    (soil.parent / "prior.toml").write_text(text.replace('name = "rolling_limit"', 'name = "rolling_limit"\nunit = "%"'))
    with pytest.raises(StudyError, match="rolling_limit is in '%'; give it in '1'"):
        inputs.read(soil, CATALOGUE)


def test_a_byte_order_mark_and_a_large_exponent_are_read_and_an_empty_grading_is_one_line(soil):
    soil.write_text("\ufeff" + soil.read_text().replace('"100 kPa"', '"1E5 Pa"'), encoding="utf-8")
    assert inputs.read(soil, CATALOGUE).tests[0].pressure == 1e5
    (soil.parent / "grading.tsv").write_text("diameter [mm]\tfiner_by_mass [%]\n")
    with pytest.raises(StudyError, match="grading.tsv: holds no rows below its header"):
        inputs.read(soil, CATALOGUE)


def test_bags_on_more_cores_than_bags_take_the_time_of_one():
    assert [forecast.seconds_at_once(10, 4, cores) for cores in (1, 2, 4, 64)] == [40, 20, 10, 10]


def test_make_says_which_folders_of_results_it_cannot_use(soil, tmp_path, tools):
    assert "make cannot use a folder with blanks" in make(soil.parent, tmp_path / "my out", tools, "own")[1]
    assert "the results take the name of the folder" in make(f"{soil.parent}//", tmp_path / "out", tools, "own")[1]


def test_the_page_of_a_long_name_a_stiff_geotextile_and_one_test(out, soil, monkeypatch):
    monkeypatch.setattr(page, "draw", lambda study, *_: study.figure("answer", page.figures.panels(1)[0]))
    text = soil.read_text().replace("Karlsruhe fine sand", "sand " * 40).replace('"PP"', '{strength = "200 kN/m", failure_strain = "10 %"}')
    soil.write_text(text.replace('"400 kPa"\nstrains = "engineering"', '"400 kPa"\nstrains = "engineering"\npredict = true'))
    study = out(0.1)
    study.write()
    assert "geotextile of 2000 kN/m" in study.headline.replace("\xa0", " ") and "to a drained triaxial test at 100 kPa" in study.lead
    assert any(f"make own SOIL={soil.parent} PROFILE=thesis" in text for text in study.remarks)


def test_neither_a_forecast_nor_a_quick_run_takes_the_place_of_full_size_results(soil, tmp_path, tools):
    out = tmp_path / "out"

    def files():
        return {path: path.stat().st_mtime_ns for path in out.rglob("*.h5")}
    (tools / "run-dem").write_text("#!/bin/sh\necho '10 steps of 10 grains: 1e3 steps/s'\n")
    (tools / "run-dem").chmod(0o755)
    make(soil.parent, out, tools, "PROFILE=thesis", "own-check")
    before = files()
    assert len(before) == 1
    make(soil.parent, out, tools, "own-check")
    assert before.items() <= files().items()


def test_make_keeps_what_the_identification_doubts_for_the_page(soil, tmp_path, tools):
    out = tmp_path / "out/own/soil"
    (tools / "gws-solve").write_text("#!/bin/sh\necho 'gws-solve identify: doubt: the scatter is unknown' >&2\necho 'name = \"x\"'\n")
    for name in ("gws-solve", "run-dem", "filter-expand"):
        (tools / name).touch()
        (tools / name).chmod(0o755)
    make(soil.parent, tmp_path / "out", tools, out / "inputs.mk")
    bags = [out / f"uc_{k}.h5" for k in range(1, 5)]
    for bag in bags:
        bag.touch()
    said = make(soil.parent, tmp_path / "out", tools, *(word for bag in bags for word in ("-o", bag)), out / "soil.toml")[1]
    assert (out / "soil.toml").exists() and "the scatter is unknown" in (out / "identified.said").read_text() and "the scatter is unknown" in said


@pytest.mark.parametrize(("status", "left"), [(0, 'name = "own"\n'), (1, ""), (65, ""), (74, None)])
def test_a_packing_without_a_solution_has_no_constants_and_an_error_none_at_all(soil, tmp_path, tools, status, left):
    out = tmp_path / "out/own/soil"
    for name in ("gws-solve", "run-dem", "filter-expand"):
        (tools / name).write_text(f"#!/bin/sh\necho \"$*\" >> {tools}/called\necho 'name = \"x\"'\necho 'gws-solve: that is why' >&2\nexit {status}\n")
        (tools / name).chmod(0o755)
    make(soil.parent, tmp_path / "out", tools, out / "inputs.mk")
    made = [out / "soil.toml", *(out / f"other_2_{k}.h5" for k in (2, 3))]
    for path in made:
        path.touch()
    said = make(soil.parent, tmp_path / "out", tools, *(word for path in made for word in ("-o", path)), "OWN_VARIED=2 3", out / "soil_2.toml")[1]
    assert (out / "soil_2.toml").read_text() == left if left is not None else not (out / "soil_2.toml").exists()
    assert ("packing 3 gives no constants: that is why" in said) == (left == "") and ("that is why" in said) == (status != 0) and (out / "varied").read_text() == "2 3\n"
    called = (tools / "called").read_text()
    assert f"identify {out}/other_2_2.h5 {out}/other_2_3.h5 --geotextile {out}/geotextile_2.toml --geotextile {out}/geotextile_3.toml" in called
    # The soil's file does not say that all constants were fitted together.
    assert "--fit thesis" in called
