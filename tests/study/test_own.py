"""A soil of one's own: own.toml refused by key, sets of a posterior, intervals of the answer, the forecast."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib
import shutil

import numpy
import pytest
from own import forecast, inputs, sets
from own import study as page
from study import NotMade, StudyError, Table

EXAMPLE = pathlib.Path(__file__).parents[2] / "data/own/example"
CATALOGUE = EXAMPLE.parents[1] / "geotextiles"


@pytest.fixture(name="soil")
def example(tmp_path):
    return pathlib.Path(shutil.copytree(EXAMPLE, tmp_path / "soil")) / "own.toml"


def test_the_example_is_read_and_written_for_make(soil, tmp_path):
    own = inputs.read(soil, CATALOGUE)
    assert len(own.tests) == 2 and len(own.predictions) == 1 and own.stiffness == 232e3
    assert own.reduction == pytest.approx(2.64)
    inputs.write(own, tmp_path / "out")
    made = (tmp_path / "out/inputs.mk").read_text()
    assert "OWN_SURCHARGE := 200000.0\n" in made and f"OWN_FAILURE := --failure {tmp_path}/out/failure.tsv\n" in made
    assert "--predict '" in made and made.count("--test '") == 2
    failure = Table.read(tmp_path / "out/failure.tsv")
    assert failure("obliquity_at_failure", "1") == pytest.approx([1.6526, 1.5953], rel=1e-4)
    assert 'strength = "12028.03' in (tmp_path / "out/long_term.toml").read_text()
    # The page of one geotextile: yarns 5 mm apart carry the stiffness.
    assert "yarn_tension = [145.0]" in (tmp_path / "out/geotextile_1.toml").read_text()


@pytest.mark.parametrize(("old", "new", "said"), [
    ("void_ratio = 0.756", "void_ratio = 75.6", "void_ratio = 75.6: void ratios of granular soils"),
    ("void_ratio", "voidratio", "voidratio is unknown; did you mean 'void_ratio'?"),
    ('surcharge = "200 kPa"', "surcharge = 200", "surcharge = 200: write a number above 0 with its unit"),
    ('surcharge = "200 kPa"', 'surcharge = "200 mm"', "surcharge: 'mm' is a unit of length"),
    ("settlement = 0.05", "settlement = 5", "settlement = 5: write a fraction"),
    ('geotextile = "PP"', 'geotextile = "PQ"', 'geotextile = "PQ" is not in'),
    ('geotextile = "PP"', 'geotextile = {strength = "30 kN/m", failure_strain = 15}', "failure_strain = 15: write a fraction"),
    ('geotextile = "PP"', 'geotextile = {strength = "30 kN/m", failure_strain = 0.15, stiffness = "9 kN/m"}', "contradict each other"),
    ("creep = 2.0", "creep = 0.5", "factors.creep = 0.5: a factor is 1 or more"),
    ("creep = 2.0", "crep = 2.0", "factors.crep is unknown; did you mean 'creep'?"),
    ('"engineering"', '"enginering"', "test 1: strains = \"enginering\"; did you mean 'engineering'?"),
    ('confining_pressure = "100 kPa"', 'confining_pressure = "300 kPa"', "correct the one that is wrong"),
    ('confining_pressure = "100 kPa"', "", "test 1: confining_pressure is missing"),
    ('table = "drained_100kPa.tsv"', 'table = "drained.tsv"', "drained.tsv: cannot be read"),
    ("[[test]]", "[[test", "own.toml: ")])
def test_what_is_wrong_is_one_line_with_file_and_key(soil, old, new, said):
    text = soil.read_text()
    assert old in text
    soil.write_text(text.replace(old, new, 1))
    with pytest.raises(StudyError) as error:
        inputs.read(soil, CATALOGUE)
    assert said in str(error.value) and str(soil.parent) in str(error.value) and "\n" not in str(error.value)


def test_a_data_sheet_without_stiffness_gives_a_secant_and_one_test_a_failure_line(soil):
    soil.write_text(soil.read_text().replace('"PP"', '{strength = "30 kN/m", failure_strain = 0.15}', 1))
    assert inputs.read(soil, CATALOGUE).stiffness == pytest.approx(200e3)
    option = inputs.failure_options([(100, 1.6526)], "failure.tsv")
    p_c = float(option.removeprefix("--set failure_line.p_c="))
    assert inputs.M * (300e3 / (3 - 1.6526) / p_c)**-inputs.EXPONENT == pytest.approx(1.6526, rel=1e-5)


def test_draws_stand_for_the_weights(tmp_path):
    path = tmp_path / "sets.tsv"
    head = "id [1]\tyoung_modulus [Pa]\tpoisson_ratio [1]\trolling_stiffness [1]\trolling_limit [1]\tfriction_angle [deg]\n"
    path.write_text(head + "".join(f"{k}\t4e9\t0.2\t0.1\t{0.1 * k}\t{20 + k}\n" for k in range(4)))
    some = Table.read(path)
    weights = Table([["0", "0.25"], ["1", "0"], ["2", "0.5"], ["3", "0.25"]], {"id": "1", "weight": "1"}, "weights")
    assert sorted(sets.drawn(some, weights, 4)) == [0, 2, 2, 3]
    assert sets.table(some, [2, 3], 2).splitlines()[4].split("\t") == ["3", "4000000000.0", "0.2", "0.1", "0.30000000000000004", "23.0", "1"]
    assert "contact.rolling.stiffness=0.8 " in sets.options(some, 0, 2) and "contact.rolling.limit=none" in sets.options(some, 0, 2)


def test_intervals_hold_the_scatter_of_constants_and_of_bags():
    low, high = page.combined(100, 100 / numpy.exp(0.196), 100 * numpy.exp(0.196), [100] * 4)
    assert (low, high) == pytest.approx((100 / numpy.exp(0.12816), 100 * numpy.exp(0.12816)))
    # The mean of n values without one each scatters by the deviation over the root of n.
    values = numpy.array([3.0, 5.0, 8.0, 4.0])
    assert page.jackknife([(values.sum() - v) / 3 for v in values]) == pytest.approx(values.std(ddof=1) / 2)
    assert page.combined(100, 90, 110, [80, 100, 120])[1] > page.combined(100, 90, 110, [100, 100, 100])[1]
    with pytest.raises(NotMade):
        page.combined(100, 0, 110, [100, 100])


def test_a_forecast_reads_what_a_check_says():
    line = "about 7 min: 164087 steps (97 % of them waiting for rest) of 13797 grains with 15031 contacts in 420 s: 3.941e+02 steps/s, 169 ns"
    assert forecast.seconds_of(line) == (164087, 13797, 394.1)
    with pytest.raises(StudyError):
        forecast.seconds_of("nothing")
