"""Calibration: laboratory tests in natural strains at stations, predictions of a posterior, wrong options."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib
import types

import numpy
import pytest
from calibration import calibrate, plausible, predicted, prior, rate
from calibration.laboratory import Test as Triaxial
from calibration.laboratory import as_it_stands, curve, greatest, observed, pressure
from study import StudyError, Table
from study.command import Failure

HEAD = "axial_strain [%]\tvolumetric_strain [%]\tdeviatoric_stress [kPa]\tmean_stress [kPa]\n"
PRIOR = "".join(f'[[parameter]]\nname = "{name}"\n{words}\n' for name, words in (
    ("young_modulus", 'unit = "Pa"\nscale = "log"\nlow = 1e9\nhigh = 1e11'), ("poisson_ratio", "low = 0.1\nhigh = 0.3"),
    ("rolling_stiffness", "low = 0\nhigh = 0.5"), ("rolling_limit", "low = 0\nhigh = 1"), ("friction_angle", 'unit = "deg"\nlow = 20\nhigh = 40')))


def triaxial(path, rows, head=HEAD, kind="engineering", at=1e5):
    path.write_text(head + "".join("\t".join(map(str, row)) + "\n" for row in rows))
    return curve(Triaxial(path, at, kind, "packing.h5"))


ROWS = [(0, 0, 0, 100), (1, 0.1, 100, 100 + 100 / 3), (2, -0.2, 200, 100 + 200 / 3), (2, -0.2, 200, 100 + 200 / 3), (10, -1, 300, 200)]


def test_engineering_strains_become_natural_ones_and_stresses_a_ratio(tmp_path):
    columns = observed(triaxial(tmp_path / "t.tsv", ROWS), 20, 0)
    assert columns["strain_axial [%]"] == pytest.approx(-100 * numpy.log([0.99, 0.98, 0.9]))
    assert columns["strain_volumetric [%]"] == pytest.approx(-100 * numpy.log([0.999, 1.002, 1.01]))
    assert columns["stress_ratio [1]"] == pytest.approx([2, 3, 4])
    natural = observed(triaxial(tmp_path / "t.tsv", ROWS, kind="natural"), 20, 0)
    assert natural["strain_axial [%]"] == pytest.approx([1, 2, 10])
    assert len(observed(triaxial(tmp_path / "t.tsv", [(k, 0, 10 * k, 100 + 10 * k / 3) for k in range(50)]), 9, 4)["stress_ratio [1]"]) == 4


def test_a_table_that_is_no_compression_test_is_refused_by_name(tmp_path):
    for rows, head, words in (
            ([(-a, v, -q, p) for a, v, q, p in ROWS], HEAD, "change the signs"),
            (ROWS[:2], HEAD, "3 are needed"),
            (ROWS[:1], HEAD, "no row has an axial strain above 0"), ([], HEAD, "holds no rows"),
            ([*ROWS[:2], (2, -0.2, 200, 300), *ROWS[3:]], HEAD, "row 3: mean_stress - deviatoric_stress/3, the lateral stress, is 233.3 kPa"),
            ([(a, v, q, p * 3) for a, v, q, p in ROWS], HEAD, "correct the one that is wrong"),
            (ROWS, HEAD.replace("volumetric", "volumetrik"), "has no column strain_volumetric"),
            ([*ROWS, (120, -1, 300, 200)], HEAD, "reaches 120 %")):
        with pytest.raises(StudyError, match=words):
            observed(triaxial(tmp_path / "t.tsv", rows, head), 20, 0)
    assert pressure("0.1 MPa") == 1e5
    for wrong in ("100", "0 kPa", "100 mm", "1e kPa", "100 Pa", "1 GPa"):
        with pytest.raises(StudyError):
            pressure(wrong)


Q_HEAD = HEAD.replace("\tmean_stress [kPa]", "")
RATIO_HEAD = Q_HEAD.replace("deviatoric_stress [kPa]", "stress_ratio [1]")
# A dense sand: strains in %, deviatoric stress in kPa.
DENSE = [(0, 0, 2), (0.1, 0.06, 50), (0.2, 0.1, 90), (0.5, 0.12, 170), (1, 0, 240), (2, -0.6, 320), (3, -1.4, 360), (5, -3, 380), (8, -5, 340),
         (12, -6, 300), (15, -6.2, 280)]


def changed(row, *, a=None, v=None, q=None, rows=DENSE):
    """Returns the rows with other cells in one of them, which counts from 1."""
    return [(new_a, new_v, new_q) if k != row else tuple(old if new is None else new for old, new in zip((new_a, new_v, new_q), (a, v, q), strict=True))
            for k, (new_a, new_v, new_q) in enumerate(rows, start=1)]


@pytest.mark.parametrize(("rows", "head", "kind", "said"), [
    ([(a, v, q / (100 + q / 3)) for a, v, q in DENSE], RATIO_HEAD, "engineering", "row 1: axial over radial stress is 0.01"),
    ([(a, v, q / 100) for a, v, q in DENSE], RATIO_HEAD, "engineering", "which is neither q/p nor q over the radial stress"),
    ([(a, v, q + 100) for a, v, q in DENSE], Q_HEAD, "engineering", "row 1: axial over radial stress is 2.02 at an axial strain of 0 %"),
    (DENSE, Q_HEAD.replace("kPa", "MPa"), "engineering", "row 1: axial over radial stress is 21, where no soil bears more than 15"),
    (DENSE, Q_HEAD.replace("kPa", "Pa"), "engineering", "axial over radial stress never exceeds 1.004"),
    (DENSE, Q_HEAD.replace("volumetric_strain [%]", "volumetric_strain"), "engineering", "row 2: the volumetric strain is 6.188 % at an axial strain of 0.1"),
    (DENSE, Q_HEAD.replace("axial_strain [%]", "axial_strain"), "natural", "row 5: the axial strain is 100 %"),
    (changed(5, q=-999), Q_HEAD, "engineering", "row 5: axial over radial stress is -8.99"),
    (changed(5, q="inf"), Q_HEAD, "engineering", "row 5: axial over radial stress is inf"),
    (changed(5, v=-999), Q_HEAD, "engineering", "row 5: the volumetric strain is -239.7 %"),
    (changed(5, a=-999), Q_HEAD, "engineering", "row 5: the axial strain is -239.7 %"),
    (changed(8, v=0, q=0), Q_HEAD, "engineering", "row 8: deviatoric_stress falls to nothing"),
    (changed(9, q=0, rows=changed(8, q=0)), Q_HEAD, "engineering", "row 8: deviatoric_stress falls to nothing"),
    (changed(11, v=0), Q_HEAD, "engineering", "row 11: volumetric strain falls to nothing"),
    ([(*row, 50 + 3 * k) for k, row in enumerate(DENSE)], Q_HEAD[:-1] + "\tpore_pressure [kPa]\n", "engineering", "undrained test by its pore_pressure, at rising"),
    ([(a, 0, q, 50) for a, _, q in DENSE], Q_HEAD[:-1] + "\tu [kPa]\n", "engineering", "undrained test by its u, at a constant volume"),
    (changed(3, q=""), Q_HEAD, "engineering", "row 3: column deviatoric_stress: '' is no number")])
def test_rows_that_no_drained_test_gives_are_refused_by_file_and_row(tmp_path, rows, head, kind, said):
    with pytest.raises(StudyError) as error:
        triaxial(tmp_path / "t.tsv", rows, head, kind)
    assert str(error.value).startswith(str(tmp_path / "t.tsv")) and said in str(error.value) and "\n" not in str(error.value)


@pytest.mark.parametrize(("rows", "head", "said"), [
    (DENSE, Q_HEAD, ""), ([(0, 0, -5), *DENSE[1:]], Q_HEAD, ""),
    ([*DENSE[:5], (0.9, 0, 20), (0.95, 0, 150), *DENSE[5:]], Q_HEAD, "2 of 13 rows are left out"),
    ([(0, 0, 0), (2, -0.5, 320), (4, -2, 420), (6, -3.5, 330), (10, -5, 300)], Q_HEAD, ""),  # few rows around a peak
    (changed(5, q=1000), Q_HEAD, "deviatoric_stress of row 5, at an axial strain of 1.005 %, lies far"),
    (changed(6, q=1000, rows=changed(5, q=990)), Q_HEAD, "deviatoric_stress of row 5"), (changed(11, q=900), Q_HEAD, "deviatoric_stress of row 11"),
    (changed(8, v=-16, rows=changed(9, v=-3.5)), Q_HEAD, "more than a drained test has"), (changed(9, v=9), Q_HEAD, "the volumetric strain of row 9"),
    ([(a, 0, q) for a, _, q in DENSE], Q_HEAD, "the volumetric strain changes by 0 % in all"),
    ([(a, -v, q) for a, v, q in DENSE], Q_HEAD, "the volume expands first"),
    ([(a / 100, v, q) for a, v, q in DENSE], Q_HEAD.replace("axial_strain [%]", "axial_strain"), "axial_strain has no unit"),
    ([(*row, 200) for row in DENSE], Q_HEAD[:-1] + "\tpore_pressure [kPa]\n", "pore_pressure is not read, and the confining pressure has to be the effective"),
    ([(*row, 200) for row in DENSE], Q_HEAD[:-1] + "\taxial_stress [kPa]\n", "the column axial_stress is not read"),
    ([(a, v, 3 * q) for a, v, q in DENSE], Q_HEAD, "its friction angle is 58.3 deg"), ([(a, v, q / 4) for a, v, q in DENSE], Q_HEAD, "its friction angle is 18.8")])
def test_what_is_unusual_is_doubted_and_what_is_usual_is_not(tmp_path, rows, head, said):
    try:
        doubts = plausible.doubts(triaxial(tmp_path / "t.tsv", rows, head))
    except StudyError as error:
        doubts = [str(error)]
    assert bool(doubts) == bool(said) and said in "".join(doubts)


def test_tests_of_one_soil_have_like_strengths_and_other_rows(tmp_path):
    low, high = (triaxial(tmp_path / f"{at}.tsv", [(a, v, q * at / 100 * (101 - at / 100) / 100) for a, v, q in DENSE], Q_HEAD, at=at * 1e3) for at in (100, 400))
    assert plausible.compared([low, high]) == []
    plausible.distinct([low, high])
    weaker, wrong = (triaxial(tmp_path / "w.tsv", [(a, v, share * q) for a, v, q in DENSE], Q_HEAD, at=2e5) for share in (1.2, 0.5))
    assert "far apart for one soil" in plausible.compared([low, weaker])[0]
    with pytest.raises(StudyError, match="which one soil does not have"):
        plausible.compared([wrong, high])
    # A test that still rises has no strength yet.
    assert plausible.compared([low, triaxial(tmp_path / "r.tsv", [(a, v, 0.5 * q) for a, v, q in DENSE[:7]], Q_HEAD, at=2e5)]) == []
    copy = triaxial(tmp_path / "copy.tsv", [(a / 100, v / 100, q / 1e3) for a, v, q in DENSE[2:]], Q_HEAD.replace("[%]", "[-]").replace("kPa", "MPa"))
    with pytest.raises(StudyError, match=r"copy.tsv: has 9 of 9 rows of .*100.tsv: a test counts once"):
        plausible.distinct([low, high, copy])
    path = tmp_path / "peak.tsv"
    path.write_text("stress_ratio_peak [1]\n0.7\n")
    with pytest.raises(StudyError, match="row 1: stress_ratio_peak is 0.7"):
        greatest(Triaxial(path, 1e5, "greatest", ""))
    for rows in ("", "4.2\n4.1\n"):
        path.write_text("stress_ratio_peak [1]\n" + rows)
        with pytest.raises(StudyError, match=f"has {rows.count('.')} rows of stress_ratio_peak, of which a test has one"):
            greatest(Triaxial(path, 1e5, "greatest", ""))


NATURAL_HEAD = "strain_axial [%]\tstrain_volumetric [%]\tstress_ratio [1]\tstrain_radial [%]\n"
NATURAL = [(0.5, 0.1, 2, -0.2), (1, 0.2, 3, -0.4), (2, 0.1, 3.5, -0.95)]


@pytest.mark.parametrize(("head", "rows", "kind", "reads"), [
    (NATURAL_HEAD, NATURAL, "natural", True), (NATURAL_HEAD, NATURAL, "engineering", False),
    (NATURAL_HEAD.replace("%", "1"), [(a / 100, v / 100, q, r / 100) for a, v, q, r in NATURAL], "natural", False),
    (NATURAL_HEAD, [*NATURAL[:2], (0.8, 0.2, 2, -0.3), *NATURAL[2:]], "natural", False),
    (NATURAL_HEAD.replace("strain_axial", "axial_strain"), NATURAL, "natural", False)])
def test_the_filter_reads_tables_in_per_cent_alone_and_others_are_written_for_it(tmp_path, head, rows, kind, reads):
    found = triaxial(tmp_path / "t.tsv", rows, head, kind)
    assert as_it_stands(found, ["stress_ratio", "strain_radial"]) == reads
    columns = observed(found, 6, 0, ["stress_ratio", "strain_radial"])
    natural = [row[3] if kind == "natural" else -100 * numpy.log(1 - row[3] / 100) for row in NATURAL]
    assert columns["strain_radial [%]"] == pytest.approx(natural) and "strain_radial [%]" not in observed(found, 6, 0)


@pytest.mark.parametrize(("old", "new", "said"), [
    ('"friction_angle"', '"sliding_damping"', "no run depends on a parameter named 'sliding_damping'; known: young_modulus,"),
    ('"friction_angle"', '"rolling_limit"', "rolling_limit is there twice"), ("[[parameter]]\nname = \"poisson_ratio\"\nlow = 0.1\nhigh = 0.3", "",
                                                                             "poisson_ratio is missing"),
    ("low = 1e9", "low = 1e12", "young_modulus: high = 1e+11 is not above low = 1e+12: correct one of them"),
    ("low = 1e9\n", "", "young_modulus: low is missing: write a number in Pa"), ("low = 1e9", "low = 1", "low = 1: write a number from 100000 to 1e+13 in Pa"),
    ("high = 40", "high = nan", "friction_angle: high = nan: write a number from 0 to 89 in deg"),
    ("high = 40", 'high = "40 kPa"', "friction_angle: high: 'kPa' is a unit of stress"), ("low = 20", "low = [20]", "low = [20]: write a number in deg"),
    ("low = 0\nhigh = 0.5", 'scale = "log"\nlow = 0\nhigh = 0.5', "low = 0 has no place on a log scale"),
    ('"Pa"', '"GPa"', "young_modulus is in 'GPa'; give it in 'Pa'"), ("[[parameter]]", "[parameter", "prior.toml: ")])
def test_a_prior_holds_what_the_runs_take(tmp_path, old, new, said):
    path = tmp_path / "prior.toml"
    path.write_text(PRIOR)
    assert len(prior.read(path)) == 5
    path.write_text(PRIOR.replace("high = 1e11", 'high = "100 GPa"'))
    assert prior.read(path)[0]["high"] == 1e11
    assert old in PRIOR
    path.write_text(PRIOR.replace(old, new, 1))
    with pytest.raises(StudyError) as error:
        prior.read(path)
    assert said in str(error.value) and "\n" not in str(error.value)


def test_rows_of_unloading_are_left_out_and_doubted(tmp_path):
    unloaded = [*DENSE[:6], (1.9, -0.55, 150), (1.95, -0.57, 250), *DENSE[6:]]
    found = triaxial(tmp_path / "u.tsv", unloaded, Q_HEAD)
    assert observed(found, 20, 0)["stress_ratio [1]"] == pytest.approx([1 + q / 100 for _, _, q in DENSE[1:]])
    assert [line.partition(": ")[2] for line in plausible.doubts(found)] == [
        "2 of 13 rows are left out, since the axial strain does not rise there, as in unloading: check the order of the rows if the test was not unloaded"]
    assert plausible.doubts(triaxial(tmp_path / "u.tsv", [(0, 0, 0), *DENSE], Q_HEAD)) == []


OTHER = [(a, 0.9 * v, 2 * q) for a, v, q in DENSE]


@pytest.mark.parametrize(("rows", "said"), [
    (DENSE[:8] + OTHER, "row 9: the axial strain falls back from 5.129 to 0 %, as where a second test begins: give each test a table of its own, with its rows"),
    (DENSE[:10] + [(a + 1, v, q) for a, v, q in OTHER[5:]], "row 11: here the axial strain first falls back, from 12.78 to 3.046 %, and 4 of 16 rows lie below a strain before them: sort the rows"),
    (sorted(DENSE, key=lambda row: row[2]), "with its rows in the order of the test, or correct the row"),
    (sorted(DENSE, key=lambda row: -row[1]), "with its rows in the order of the test, or correct the row"),
    (DENSE[::-1], "row 1 has the greatest axial strain, 16.25 %: sort the rows in the order of the test")])
def test_two_tests_in_one_table_and_rows_out_of_order_are_refused(tmp_path, rows, said):
    with pytest.raises(StudyError) as error:
        triaxial(tmp_path / "t.tsv", rows, Q_HEAD)
    assert str(error.value).startswith(f"{tmp_path / 't.tsv'}: row ") and said in str(error.value)


def test_rows_of_two_tests_sorted_by_strain_are_doubted(tmp_path):
    said = plausible.doubts(triaxial(tmp_path / "t.tsv", sorted(DENSE + [(a + 0.01, v, q) for a, v, q in OTHER]), Q_HEAD))
    assert any("deviatoric_stress jumps up and down at 14 of 20 rows, as where rows of two tests are mixed" in line for line in said)


@pytest.mark.parametrize(("rows", "head", "said"), [
    ([(a, v / 100, q) for a, v, q in DENSE], Q_HEAD, "the volumetric strain changes by 0.063 % in all, while the axial strain reaches 16.3 %: give a drained"),
    ([(a, 0.001, q) for a, _, q in DENSE], Q_HEAD, "or head the column [1] if it is a fraction headed [%]"),
    ([(a, 0.2, q) for a, _, q in DENSE], Q_HEAD, "the volumetric strain changes by 0 % in all"),
    ([(a, 0.02, q) for a, _, q in DENSE[:5]], Q_HEAD, "the volumetric strain changes by 0 % in all, while the axial strain reaches 1.01 %"),
    ([(a / 100, v / 100, q) for a, v, q in DENSE[:1] + DENSE[4:]], Q_HEAD, "the axial strain ends at 0.15 %, where tests to failure reach some per cent"),
    ([(a / 100, v / 100, q) for a, v, q in DENSE], Q_HEAD, "and the axial strain, which ends at 0.15 %, as a fraction headed [%] does"),
    ([(a, v / 100, q, 50) for a, v, q in DENSE], Q_HEAD[:-1] + "\tu [kPa]\n", "at a constant volume: give drained ones, or correct the unit of the volumetric")])
def test_strains_a_hundred_times_too_small_are_doubted(tmp_path, rows, head, said):
    try:
        found = plausible.doubts(triaxial(tmp_path / "t.tsv", rows, head))
    except StudyError as error:
        found = [str(error)]
    assert said in found[0]


def test_a_posterior_predicts_with_its_weights(tmp_path):
    path = tmp_path / "curves.tsv"
    path.write_text("id [1]\tstep [1]\tstrain_axial [%]\tstress_ratio [1]\tstress_ratio_observed [1]\n"
                    "0\t1\t1\t2\t2.5\n0\t2\t2\t3\t3.5\n7\t1\t1\t4\t2.5\n7\t2\t2\t5\t3.5\n")
    columns = predicted.band(Table.read(path), {0: 0.75, 7: 0.25}, ["stress_ratio"])
    assert columns["stress_ratio [1]"] == [2.5, 3.5] and columns["stress_ratio_low [1]"] == [2, 3]
    assert columns["stress_ratio_high [1]"] == [4, 5] and columns["stress_ratio_observed [1]"] == [2.5, 3.5]
    assert columns["stress_ratio_deviation [1]"] == pytest.approx([0.75**0.5] * 2)
    curves, other = Table.read(path), Table.read(path).replace("stress_ratio", [2.2, 3.2, 4.2, 5.2])
    steps = Table([["0.1"]] * 4, {"stress_ratio_error": "1"}, "steps")
    assert rate.difference((curves, steps), (other, steps)) == pytest.approx(2)
    radial = [Table([[value]], {name: "%"}, "r") for name, value in (("strain_radial", "-0.4"), ("strain_radial", "-0.1"), ("strain_radial_error", "0.1"))]
    assert rate.difference((radial[0], radial[2]), (radial[1], radial[2])) == pytest.approx(3)


def test_curves_of_other_tests_leave_the_folder(tmp_path):
    for name in ("predicted_a_100kPa.tsv", "predicted.svg", "posterior.h5", "round1_sets.tsv"):
        (tmp_path / name).write_text("old")
    predicted.clear(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["round1_sets.tsv"]


def test_the_middle_of_a_prior_and_a_rate_of_a_scenario(tmp_path):
    prior, scenario = tmp_path / "prior.toml", tmp_path / "s.toml"
    prior.write_text(PRIOR)
    assert rate.middle(prior) == pytest.approx({
        "young_modulus [Pa]": 1e10, "poisson_ratio [1]": 0.2, "rolling_stiffness [1]": 0.25, "rolling_limit [1]": 0.5, "friction_angle [deg]": 30})
    scenario.write_text("[[stage]]\nmax_rate = 1\nrate = 0.1 # 1/s\n")
    case = types.SimpleNamespace(given=types.SimpleNamespace(rate="0.02", scenario=scenario), folder=tmp_path)
    assert rate.chosen(case) == "loading rate: 0.02 1/s as given"
    assert pathlib.Path(case.scenario).read_text() == "[[stage]]\nmax_rate = 1\nrate = 0.02\n"
    scenario.write_text("max_rate = 1\n")
    with pytest.raises(Failure, match='0 lines begin with "rate ="'):
        rate.chosen(case)
    scenario.write_text('[[stage]]\nrate = "10 %/s"\n')
    case.given.rate, case.tests = "try", [types.SimpleNamespace(kind="natural")]
    with pytest.raises(Failure, match="write it as a number in 1/s"):
        rate.chosen(case)


@pytest.mark.parametrize(("changes", "chosen", "said"), [
    ([0.2], 0.1, "0.1 1/s, half of it changes the curves by 0.2 of the tests' error"),
    ([0.9, 0.3], 0.05, "0.05 1/s, half of it changes the curves by 0.3 of the tests' error"),
    ([0.9, 0.5], 0.025, "at which the response may still depend on the rate: halving it from 0.05 1/s still changed the curves by 0.5 of the tests' error"),
    ([None], 0.1, "the middle of the prior cannot be run")])
def test_the_trial_takes_the_fastest_rate_whose_half_changes_little(tmp_path, monkeypatch, changes, chosen, said):
    scenario = tmp_path / "s.toml"
    scenario.write_text("[[stage]]\nrate = 0.1\n")
    case = types.SimpleNamespace(given=types.SimpleNamespace(rate="try", scenario=scenario), folder=tmp_path, tests=[types.SimpleNamespace(kind="natural")])
    monkeypatch.setattr(rate, "_curves", lambda *_: changes[0] and "curves")
    left = iter(changes)
    monkeypatch.setattr(rate, "difference", lambda *_: next(left))
    assert said in rate.chosen(case)
    assert pathlib.Path(case.scenario).read_text() == f"[[stage]]\nrate = {chosen:g}\n"


@pytest.mark.parametrize(("words", "status", "said"), [
    ("--test t.tsv", 64, "write TABLE PRESSURE KIND"), ("--test t.tsv 1kPa true", 64, "KIND one of engineering"),
    ("--test t.tsv 1kPa natural", 64, "has no packing"), ("--test t.tsv 1kPa natural gone.h5", 66, "t.tsv: is not there"),
    ("--test t.tsv 1kPa natural p --error 0", 64, "errors are numbers above 0"), ("--test t.tsv 1kPa natural p --error nan", 64, "numbers above 0"),
    ("--test t.tsv 1kPa natural p --error 5", 64, "write 5 per cent as 0.05"), ("--test t.tsv 1kPa natural p --error 500%", 64, "a share is at most 1"),
    ("--test t.tsv 1kPa natural p --variance stress_ratio=inf", 64, "numbers above 0"), ("--test t.tsv 1kPa natural p --until nan", 64, "above 0 in %"), ("--test t.tsv 1kPa natural p --rounds 0", 64, "whole number of at least 1"),
    ("--test t.tsv 1kPa natural p --variance 0.1", 64, "a share is an --error"), ("--test t.tsv 1kPa natural p --rate x", 64, "write a number in 1/s"),
    ("--test t.tsv 1kPa natural p --rate 0", 64, "write a number in 1/s above 0")])
def test_wrong_options_are_one_line(words, status, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(Failure) as failure:
        calibrate.parse(["folder", "--prior", "p.toml", *words.split()])
    assert failure.value.status == status and said in str(failure.value) and "\n" not in str(failure.value)
