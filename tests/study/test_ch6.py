"""Chapter 6: its measures on small tables by hand, and on its kept full-size runs."""
# SPDX-License-Identifier: GPL-3.0-or-later
import math
import types

import numpy
import pytest
from ch6 import study as chapter
from ch6.runs import SIZES, Curve, Field, History, Runs, label, spread
from matplotlib import pyplot
from renaming import demand_columns
from study import NotMade, Study, StudyError, Table, read_statements

UNITS = {"time": "s", "pull_end": "m", "traction_y_bottom": "Pa", "interface_friction": "1", "external_work": "J m-1", "energy_error": "J m-1",
         "strain_shear": "1", "strain_volumetric": "1", "mean_stress": "Pa", "deviatoric_stress": "Pa", "anisotropy": "1", "rotation": "rad",
         "element": "1", "node": "1", "node_0": "1", "node_1": "1", "node_2": "1", "x": "m", "y": "m", "displacement_x": "m",
         "displacement_y": "m", "x_0": "m", "y_0": "m", "tension_ratio": "1"}


def write(path, **columns):
    """Writes a table of columns of equal length. A single number fills its whole column."""
    length = max(numpy.size(values) for values in columns.values())
    rows = zip(*(numpy.broadcast_to(values, length) for values in columns.values()), strict=True)
    head = "\t".join(f"{name} [{UNITS[name]}]" for name in columns)
    path.write_text("\n".join([head, *("\t".join(repr(float(x)) for x in row) for row in rows)]) + "\n")
    return Table.read(path)


def curve(path, pull, friction, end=25.0):
    return Curve(write(path, time=numpy.array(pull) * end / 25, pull_end=numpy.array(pull) / 100, interface_friction=friction),
                 "interface_friction")


def test_a_curve_is_straight_between_its_rows_and_ends_where_they_end(tmp_path):
    line = curve(tmp_path / "loading.tsv", [0, 1, 5, 10], [math.nan, 0.1, 0.5, 0])
    assert line.at(3) == pytest.approx(0.3)  # the first row, without contact, is no zero
    assert line.mean(1, 5) == pytest.approx(0.3)
    assert line.end == 10
    with pytest.raises(StudyError, match="loading.tsv: the pull ends at 10 cm, before 12 cm"):
        line.mean(8, 12)
    with pytest.raises(StudyError, match="column interface_friction has no value in any row"):
        curve(tmp_path / "apart.tsv", [0, 25], math.nan)


def test_hardening_begins_where_a_tenth_of_the_last_stress_is_passed(tmp_path):
    # Nothing up to 10 cm, then 1 per cm: the last 3 cm have the mean 13.5, the mean over 1 cm passes 1.35 from 11 cm on.
    assert curve(tmp_path / "a.tsv", [0, 10, 25], [0, 0, 15]).onset() == pytest.approx(11.5)
    with pytest.raises(NotMade, match="nowhere passes a tenth"):
        curve(tmp_path / "b.tsv", [0, 25], [0, 0]).onset()


def test_the_rate_is_over_the_first_two_millimetres_and_by_the_time(tmp_path):
    slow = curve(tmp_path / "slow.tsv", [0, 0.1, 0.2, 25], [0, 0.02, 0.04, 0.3], end=50)
    fast = curve(tmp_path / "fast.tsv", [0, 0.1, 0.2, 25], [0, 0.02, 0.04, 0.3], end=25)
    assert slow.rate() == pytest.approx(0.04 / 0.4)
    assert fast.rate() / slow.rate() == pytest.approx(2)


def test_curves_differ_by_means_over_stretches_and_none_beyond_the_end(tmp_path):
    one = curve(tmp_path / "one.tsv", [0, 25], [0, 2.5])
    steep = curve(tmp_path / "steep.tsv", [0, 25], [0, 5])
    # Both are straight, so they differ most over the last centimetre, from 24 to 25: 2.45 of 4.9.
    assert spread([one, steep], 6) == pytest.approx(0.5)
    assert spread([one, one], 6) == 0
    bump = curve(tmp_path / "bump.tsv", [0, 6, 7.5, 9, 25], [0, 0.6, 3.75, 0.9, 2.5])
    assert spread([one, bump], 6) == pytest.approx(0.75 * 2 / 2.45, rel=0.05)


@pytest.fixture(name="history")
def small_history(tmp_path):
    p, q = [10, 0, 2000, 4000, 4000, 1000], [5, 0, 1000, 1000, 1000, 500]
    return History(write(tmp_path / "local.tsv", time=[0, 1, 2, 3, 4, 5], strain_shear=[0, 0.1, 0.2, 0.3, 0.4, 0.5],
                         strain_volumetric=[0, -0.01, -0.03, -0.02, 0, 0.01], mean_stress=p, deviatoric_stress=q,
                         anisotropy=[0.1, -1, 0.2, 0.2, 0.1, 0.1]))


def test_parts_of_a_history_are_rows_from_one_on(history):
    assert history.part(1 / 3, 2 / 3) == slice(1, 4)
    assert history.part(2 / 3, 1) == slice(3, 6)
    assert history.part(0, 1) == slice(0, 6)
    assert history.until(12.5) == slice(1, 3) and history.until(0) == slice(1, 3)


def test_the_point_is_loosest_in_one_output_and_its_obliquity_is_of_means(history):
    assert (history.loosest, history["pull"][history.loosest]) == (2, 10)
    assert history.obliquity(history.dilating) == 0.5
    assert history.obliquity(slice(2, 6)) == pytest.approx(3500 / 11000)
    with pytest.raises(NotMade, match="carries no mean stress"):
        history.obliquity(slice(1, 2))


def square(folder, rise=(-0.001, 0, 0.002), **points):
    """A square of 1.2 m of two by two squares, eight triangles. rise: of each column of nodes, m."""
    at = numpy.array([[i, j] for j in range(3) for i in range(3)]) * 0.6
    up = numpy.tile(rise, 3)
    corners = []
    for j in range(2):
        for i in range(2):
            a = 3 * j + i
            corners += [(a, a + 1, a + 3), (a + 1, a + 4, a + 3)]
    corners = numpy.array(corners)
    given = {"element": numpy.arange(8), "mean_stress": 1e3, "deviatoric_stress": 1e3, "strain_shear": 0, "strain_volumetric": 0, "rotation": 0, "anisotropy": 0.1}
    return Field(
        write(folder / "elements.tsv", element=numpy.arange(8), node_0=corners[:, 0], node_1=corners[:, 1], node_2=corners[:, 2]),
        write(folder / "points.tsv", x=at[corners, 0].mean(axis=1), **(given | points)),
        write(folder / "nodes.tsv", node=numpy.arange(9), x=at[:, 0], y=at[:, 1] + up, displacement_x=0, displacement_y=up),
        write(folder / "bars.tsv", x_0=[0, 0.6, 1.2], y_0=-0.01, tension_ratio=[0, 0.1, 0.2]))


def test_elements_are_told_by_their_corners_before_the_pull(tmp_path):
    field = square(tmp_path)
    assert field.side == pytest.approx(1.2)
    assert list(field.corners_at(0)) == [2, 1, 2, 1, 0, 0, 0, 0]
    assert list(field.corners_at(field.side) > 0) == [False] * 4 + [True] * 4
    # The two along the bottom with a side on it have means of x of 0.2 and 0.8 m; half of the length is from 0.3 to 0.9 m.
    assert list(numpy.flatnonzero(field.along(2))) == [2] and list(numpy.flatnonzero(field.along(1))) == [1]


def test_the_soil_heaves_from_the_first_column_that_rises(tmp_path):
    field = square(tmp_path)
    assert field.heaves_from() == pytest.approx(1.2)
    assert field.rise(field.start[:, 0] < 0.1) == pytest.approx(-1)
    with pytest.raises(NotMade, match="no column"):
        square(tmp_path, rise=(-1e-3, -1e-3, 0)).heaves_from()


def test_asymmetry_is_the_difference_of_the_halves_over_their_sum(tmp_path):
    left = square(tmp_path).points("x", "m") < 0.6
    assert square(tmp_path, mean_stress=numpy.where(left, 1e3, 3e3)).asymmetry() == pytest.approx(50)
    assert square(tmp_path).asymmetry() == 0


def test_tables_of_another_state_or_mesh_are_refused(tmp_path):
    with pytest.raises(StudyError, match="points.tsv: column element does not number 8 elements from 0 on"):
        square(tmp_path, element=numpy.arange(1, 9))


def test_profiles_name_their_runs():
    assert SIZES["thesis"].cases == ["6_1", "8_0.25", "8_0.5", "8_1", "10_1"]
    assert label("8_0.5") == "128 elements, 0.5 cm/s"
    for name, size in SIZES.items():
        text = (chapter.HERE / "study.mk").read_text()
        assert f"C6_CASES_{name} := {' '.join(size.cases)}\n" in text
        assert f"C6_MAIN_{name} := {size.main}\n" in text and f"C6_GRAINS_{name} := {size.grains}\n" in text


def kept_runs():
    return Runs(chapter.KEPT, SIZES["thesis"])


def test_what_is_kept_of_full_size_gives_the_comparison_that_is_kept(tmp_path):
    for path in chapter.KEPT.glob("*.tsv"):
        (tmp_path / path.name).write_text(path.read_text())
    study = chapter.build(types.SimpleNamespace(out=tmp_path, profile="quick", kept=True))
    study.write_tables()
    for name in ("comparison", "measured"):
        assert (tmp_path / f"{name}.tsv").read_text() == (chapter.KEPT / f"{name}.tsv").read_text()
    assert study.measures["swinging_mobilised"].reason == "its run is not kept"


def test_no_statement_is_of_a_change_without_a_margin():
    assert [s.name for s in read_statements(chapter.HERE / "statements.tsv") if s.relation != "within" and float(s.published) == 0] == []


class Undrawn(Study):
    """A study whose figures are made and not rendered, which takes most of the time."""

    def figure(self, *_, **__):
        pass


def test_a_quick_page_tells_what_is_kept_at_full_size(tmp_path, monkeypatch):
    monkeypatch.setattr(chapter, "Study", Undrawn)
    monkeypatch.setitem(chapter.SIZES, "quick", SIZES["thesis"])
    for path in chapter.KEPT.glob("*.tsv"):
        (tmp_path / path.name).write_text(path.read_text())
    study = chapter.build(types.SimpleNamespace(out=tmp_path, profile="quick", kept=False))
    assert "packing of 400 disks" in study.lead and study.remarks[0].startswith("In pull-out the damping of the soil is 20 1/s.")
    assert list(study._texts.figures) == ["curves", "shape_fields", "shape_fields_here", "pullout_fields", "pullout_fields_here", "A", "B"]
    pyplot.close("all")


def test_each_column_that_the_chapter_reads_is_missed_by_name(tmp_path):
    def measured(measure):
        return lambda: measure(Study("ch6", "", tmp_path, "thesis"), kept_runs())
    readers = [measured(chapter.measure_shape), measured(chapter.measure_pullout)]
    readers += [lambda: chapter.draw(Undrawn("ch6", "", tmp_path, "thesis"), kept_runs(), None)]
    columns = sum(len(table.read_text().splitlines()[0].split("\t")) for table in chapter.KEPT.glob("*_*_*.tsv"))
    assert demand_columns(readers) == columns - 3  # nothing asks for the time of two of the pull-outs, nor of point B
    pyplot.close("all")


def zero_crossing(places, values):
    """Returns where values, linear between places, first change their sign."""
    k = int(numpy.flatnonzero(values[:-1] * values[1:] < 0)[0])
    return places[k] + (places[k + 1] - places[k]) * values[k] / (values[k] - values[k + 1])


def test_reasons_tell_the_numbers_of_the_kept_runs():
    runs, told = kept_runs(), " ".join((chapter.HERE / "words.toml").read_text().replace("\\\n", "").split())
    curves = {case: runs.curve("shape", case) for case in runs.size.cases}
    main, onsets = curves[runs.size.main], [one.onset() for one in curves.values()]
    last = main.mean(main.end - 3, main.end)
    first, second, third = (next(start + 0.5 for start in numpy.arange(0, 24, 0.25) if main.mean(start, start + 1) > share * last)
                            for share in (0.01, 0.05, 0.1))
    a, field = runs.history("shape"), runs.field("shape")
    middle, p = field.start[field.corners].mean(axis=1) / field.side * 8, field.points("mean_stress", "kPa")
    column, row = numpy.floor(middle).astype(int).T
    diagonal = column + row == 7  # from the upper left to the lower right corner

    def excess(k, mask):  # mean stress of the left half of a row over that of the right half: difference over sum, %
        left, right = (p[mask & (row == k) & (half == (column < 4))].mean() for half in (True, False))
        return 100 * (left - right) / (left + right)
    lower, upper = ([excess(k, True) for k in rows] for rows in (range(4), range(4, 8)))
    assert max(excess(k, ~diagonal) for k in range(8)) < 0
    # The side that two triangles of a square share falls along this diagonal.
    shared = [field.start[sorted(set(one) & set(other))] for one, other in zip(field.corners[::2], field.corners[1::2], strict=True)]
    assert all(numpy.prod(ends[1] - ends[0]) < 0 for ends in shared)
    pulled = runs.field("pullout")
    x, y, moved = *numpy.round(pulled.start, 4).T, 1000 * numpy.linalg.norm(pulled.displacement, axis=1)
    places = numpy.unique(x)

    def mean(axis, along, mask=True):
        return numpy.array([pulled.displacement[(along == place) & mask, axis].mean() for place in places])
    heaves = [zero_crossing(places, mean(1, x, y == height)) for height in places]
    assert tuple(pulled.start[moved.argmax()]) == (0, 0)
    for words in (f"at {first:g} cm, 5 % at {second:g} cm and 10 %, which counts here, at {third:g} cm",
                  f"begin to harden between {min(onsets):g} and {max(onsets):g} cm", f"begins to contract at {a['pull'][a.loosest]:g} cm here",
                  f"carries {-max(lower):.1f} % to {-min(lower):.1f} % more", f"the left half carries {min(upper):.1f} % to {max(upper):.1f} % more",
                  f"they carry {p[diagonal].mean() / p[~diagonal].mean():.2f} times",
                  f"vanishes {zero_crossing(places, mean(1, x)):.2f} m from the left end and {zero_crossing(places, mean(0, y)):.2f} m above",
                  f"heave {min(heaves[1:]):.2f} to {max(heaves[1:]):.2f} m from the left end. On the sheet itself it does so at {heaves[0]:.2f} m",
                  "sinks by {1:.1f} mm, all other nodes move by at most {0:.1f} mm".format(*numpy.sort(moved)[-2:])):
        assert words in told, words
