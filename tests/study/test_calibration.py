"""Calibration: tests of the laboratory brought to natural strains and stations, what a posterior predicts, options that are wrong."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib
import types

import numpy
import pytest
from calibration import calibrate, predicted, rate
from calibration.laboratory import Test as Triaxial
from calibration.laboratory import left_out, observed, pressure
from study import StudyError, Table
from study.command import Failure

HEAD = "axial_strain [%]\tvolumetric_strain [%]\tdeviatoric_stress [kPa]\tmean_stress [kPa]\n"
PRIOR = '[[parameter]]\nname = "young_modulus"\nunit = "Pa"\nscale = "log"\nlow = 1e9\nhigh = 1e11\n[[parameter]]\nname = "poisson_ratio"\nlow = 0.1\nhigh = 0.3\n'


def triaxial(path, rows, head=HEAD, kind="engineering"):
    path.write_text(head + "".join("\t".join(map(str, row)) + "\n" for row in rows))
    return Triaxial(path, 1e5, kind, "packing.h5")


ROWS = [(0, 0, 0, 100), (1, 0.1, 100, 100 + 100 / 3), (2, -0.2, 200, 100 + 200 / 3), (2, -0.2, 200, 100 + 200 / 3), (10, -1, 300, 200)]


def test_engineering_strains_become_natural_ones_and_stresses_a_ratio(tmp_path):
    columns = observed(triaxial(tmp_path / "t.tsv", ROWS), 20, 0)
    assert columns["strain_axial [%]"] == pytest.approx(-100 * numpy.log([0.99, 0.98, 0.9]))
    assert columns["strain_volumetric [%]"] == pytest.approx(-100 * numpy.log([0.999, 1.002, 1.01]))
    assert columns["stress_ratio [1]"] == pytest.approx([2, 3, 4])
    natural = observed(triaxial(tmp_path / "t.tsv", ROWS, kind="natural"), 20, 0)
    assert natural["strain_axial [%]"] == pytest.approx([1, 2, 10])
    assert len(observed(triaxial(tmp_path / "t.tsv", [(k, 0, 10 * k, 100 + 10 * k / 3) for k in range(100)]), 9, 4)["stress_ratio [1]"]) == 4


def test_a_table_that_is_no_compression_test_is_refused_by_name(tmp_path):
    for rows, head, words in (
            ([(-a, v, -q, p) for a, v, q, p in ROWS], HEAD, "change the signs"),
            (ROWS[:2], HEAD, "3 are needed"),
            ([(a, v, q, p * 3) for a, v, q, p in ROWS], HEAD, "correct the one that is wrong"),
            (ROWS, HEAD.replace("volumetric", "volumetrik"), "has no column strain_volumetric"),
            ([*ROWS, (120, -1, 300, 200)], HEAD, "reaches 120 %")):
        with pytest.raises(StudyError, match=words):
            observed(triaxial(tmp_path / "t.tsv", rows, head), 20, 0)
    assert pressure("0.1 MPa") == 1e5
    for wrong in ("100", "0 kPa", "100 mm", "1e kPa"):
        with pytest.raises(StudyError):
            pressure(wrong)


def test_rows_of_unloading_are_left_out_and_said(tmp_path):
    unloaded = [*ROWS[:3], (1.5, -0.1, 50, 100 + 50 / 3), (1.8, -0.1, 150, 150), *ROWS[4:]]
    assert observed(triaxial(tmp_path / "u.tsv", unloaded), 20, 0)["stress_ratio [1]"] == pytest.approx([2, 3, 4])
    assert left_out(triaxial(tmp_path / "u.tsv", unloaded)).startswith("u_100kPa: 2 of 6 rows are left out")
    assert not left_out(triaxial(tmp_path / "u.tsv", [(0, 0, 0, 100), (0, 0, 1, 100 + 1 / 3), *ROWS[1:3], ROWS[4]]))


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


def test_the_middle_of_a_prior_and_a_rate_of_a_scenario(tmp_path):
    prior, scenario = tmp_path / "prior.toml", tmp_path / "s.toml"
    prior.write_text(PRIOR)
    assert rate.middle(prior) == pytest.approx({"young_modulus [Pa]": 1e10, "poisson_ratio [1]": 0.2})
    scenario.write_text("[[stage]]\nmax_rate = 1\nrate = 0.1 # 1/s\n")
    case = types.SimpleNamespace(given=types.SimpleNamespace(rate="0.02", scenario=scenario), folder=tmp_path)
    assert rate.chosen(case) == "loading rate: 0.02 1/s as given"
    assert pathlib.Path(case.scenario).read_text() == "[[stage]]\nmax_rate = 1\nrate = 0.02\n"
    scenario.write_text("max_rate = 1\n")
    with pytest.raises(Failure, match='0 lines begin with "rate ="'):
        rate.chosen(case)


@pytest.mark.parametrize(("words", "status", "said"), [
    ("--test t.tsv", 64, "write TABLE PRESSURE KIND"), ("--test t.tsv 1kPa true", 64, "KIND one of engineering"),
    ("--test t.tsv 1kPa natural", 64, "has no packing"), ("--test t.tsv 1kPa natural gone.h5", 66, "t.tsv: is not there"),
    ("--test t.tsv 1kPa natural p --error 0", 64, "errors are above 0"), ("--test t.tsv 1kPa natural p --rounds 0", 64, "whole number of at least 1"),
    ("--test t.tsv 1kPa natural p --variance 0.1", 64, "a share is an --error"), ("--test t.tsv 1kPa natural p --rate x", 64, "write a number in 1/s")])
def test_wrong_options_are_one_line(words, status, said, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(Failure) as failure:
        calibrate.parse(["folder", "--prior", "p.toml", *words.split()])
    assert failure.value.status == status and said in str(failure.value) and "\n" not in str(failure.value)
