"""Chapter 4: its measures on cells by hand, and the tables that sections are drawn of."""
# SPDX-License-Identifier: GPL-3.0-or-later
import types

import numpy
import pytest
from ch4 import drawing, sections
from ch4 import study as chapter
from ch4.cells import FORMS, GEOTEXTILES, HERE, Cell, Runs, both_whole, over
from matplotlib import pyplot
from renaming import demand_columns
from study import NotMade, Study, StudyError, Table, read_statements

UNITS = {"axial_stress": "Pa", "lateral_stress": "Pa", "stress_zz": "Pa", "mean_stress": "Pa", "deviatoric_stress": "Pa",
         "fill_axial_stress": "Pa", "fill_lateral_stress": "Pa", "soil_axial_stress": "Pa", "soil_lateral_stress": "Pa",
         "soil_mean_stress": "Pa", "soil_deviatoric_stress": "Pa",
         **{f"group_{k}_{name}_stress": "Pa" for k in "123" for name in ("mean", "deviatoric")},
         **dict.fromkeys(("boundary_work", "energy_error"), "J"),
         **dict.fromkeys(("position_x", "position_y", "position_z", "x", "z", "radius", "height"), "m")}
STRAIN = numpy.array([0, 0.01, 0.02, 0.03, 0.04])


def write(path, **columns):
    """Writes a table of columns of equal length. A single number fills its whole column."""
    length = max(numpy.size(values) for values in columns.values())
    rows = zip(*(numpy.broadcast_to(values, length) for values in columns.values()), strict=True)
    head = "\t".join(f"{name} [{UNITS.get(name, '1')}]" for name in columns)
    path.write_text("\n".join([head, *("\t".join(repr(float(x)) for x in row) for row in rows)]) + "\n")
    return Table.read(path)


def cell(path, **columns):
    """Writes a cell of five stations after one of rest; its soil has 1.5 times the stress of the cell, and q/p of 1.5."""
    axial = numpy.array(columns.pop("axial", [1, 3, 5, 6, 5])) * 1e4
    given = {"step": 10 * numpy.arange(5), "stage": 1, "strain_axial_engineering": STRAIN, "axial_stress": axial, "lateral_stress": 1e4,
             "strain_volumetric": [0, 0.002, 0.001, -0.01, -0.02], "void_ratio": [0.68, 0.67, 0.66, 0.68, 0.7],
             "soil_axial_stress": 1.5 * axial, "soil_lateral_stress": 2e4, "soil_delaunay_void_ratio": [0.675, 0.67, 0.66, 0.7, 0.8],
             "soil_strain_deviatoric": STRAIN, "strain_x": -STRAIN / 3, "strain_y": -STRAIN / 2,
             "fill_axial_stress": 1e4, "fill_lateral_stress": 7e3, "broken_yarns": [0, 0, 0, 2, 9],
             "boundary_work": STRAIN, "energy_error": 0,
             **{f"{of}_mean_stress": axial for of in ("soil", "group_1", "group_2", "group_3")},
             **{f"{of}_deviatoric_stress": 1.5 * axial for of in ("soil", "group_1", "group_2", "group_3")}} | columns
    return Cell(write(path, **{name: numpy.concatenate([[0 if name == "stage" else 77], numpy.broadcast_to(values, 5)])
                               for name, values in given.items()}))


@pytest.fixture(name="folder")
def all_tables(tmp_path):
    """A folder with all that a page is made of: the wrapped form bears twice the layered one's, and more the stiffer."""
    for form, times in zip(FORMS, (2, 1), strict=True):
        for k, g in enumerate(GEOTEXTILES):
            cell(tmp_path / f"{form}_{g}.tsv", axial=times * (1 + k) * numpy.array([1, 3, 5, 6, 5]))
        write(tmp_path / f"{form}_shape.tsv", height=[0.08, 0.0792], yarn_length=[1, 0.99], soil_void_ratio=[0.7, 0.6])
        write(tmp_path / f"{form}_rose.tsv", density=[1, 1 + 0.05 * times])
        place = [0, 0.1, 0.2]
        write(tmp_path / f"grains_{form}.tsv", position_x=place, position_y=place, position_z=place, radius=0.01, part=[0, 1, 2])
        for which in ("least", "greatest"):
            write(tmp_path / f"bands_{form}_PP_{which}.tsv", distance=[0.25, 0.5, 0.75, 1], grains=[1, 3, 5, 7], sheared=[1, 1, 1, 5])
            write(tmp_path / f"section_{form}_PP_{which}.tsv", x=place, z=place, radius=0.01, part=[0, 1, 2], strain_deviatoric=0.1)
    write(tmp_path / "soil.tsv", stage=[0, 1, 1, 1], strain_axial=[0, 0, 0.01, 0.02], strain_volumetric=0, stress_zz=[1e4, 1e4, 4e4, 5e4],
          mean_stress=[1, 1, 2, 2e4], deviatoric_stress=[0, 0, 3, 3.4e4], void_ratio=0.7)
    return tmp_path


@pytest.fixture(name="study")
def measured(folder):
    study = Study("ch4", "", folder, "quick", judged=False)
    for measure in chapter.MEASURES:
        measure(study, Runs(folder))
    return study


def test_a_cell_counts_from_the_start_of_shear(tmp_path):
    one = cell(tmp_path / "wrapped_PE.tsv")
    assert list(one["strain"]) == [0, 1, 2, 3, 4]
    assert (one.peak, one.whole) == (3, slice(3))
    assert list(one["ratio"]) == [1, 3, 5, 6, 5]


def test_a_path_is_fitted_through_the_origin_up_to_the_peak(tmp_path):
    one = cell(tmp_path / "wrapped_PE.tsv", soil_mean_stress=[0, 1e4, 2e4, 3e4, 9e4], soil_deviatoric_stress=[0, 1e4, 2e4, 3.3e4, 0])
    slope, bend = one.path()
    assert slope == pytest.approx((1 + 4 + 9.9) / (1 + 4 + 9))
    assert bend == pytest.approx(100 * (2 * slope - 2) / 3.3)


def test_forms_are_compared_from_two_per_cent_to_the_first_break_of_either(tmp_path):
    pair = cell(tmp_path / "a.tsv", broken_yarns=[0, 0, 0, 0, 1]), cell(tmp_path / "b.tsv")
    assert both_whole(pair) == slice(2, 3)
    with pytest.raises(NotMade, match="yarns break before 2 % of axial strain"):
        both_whole((pair[0], cell(tmp_path / "c.tsv", broken_yarns=[0, 0, 1, 1, 1])))


def test_forms_of_other_stations_are_refused(tmp_path):
    pair = cell(tmp_path / "a.tsv"), cell(tmp_path / "b.tsv", stage=[0, 1, 1, 1, 1])
    with pytest.raises(StudyError, match="b.tsv: has another number of stations than .*a.tsv"):
        over(pair, "ratio")


def test_measures_of_cells_by_hand(study):
    value = {name: m.value for name, m in study.measures.items()}
    assert value["peak_wrapped_PP"] == 24 and value["peak_layered_PP"] == 12
    assert value["above_5PP"] == 2
    assert value["gap_grows"] == 6  # from 6 over 12 to 18
    assert value["dilation_5PP"] == 1
    assert value["inside_above"] == 1  # ratio of the lateral stresses, which are equal
    assert (value["inside_gap_axial"], value["inside_gap_lateral"]) == (1, 0.5)
    assert value["axial_below_lateral"] == 13.5
    assert (value["slopes_differ"], value["paths_bend"], value["slope_soil"]) == (0, 0, 1.7)
    assert (value["edge_wrapped"], value["edge_stiff"]) == (1, 0)
    assert value["inside_keeps"] == pytest.approx(0.015)
    assert value["e_end_layered"] == pytest.approx(0.8 / 0.7, rel=1e-5)
    assert value["bands_wrapped"] == pytest.approx((6 / 8) / (12 / 16))
    assert value["bands_layered"] == pytest.approx((2 / 8) / (4 / 16))
    assert value["orientation"] == pytest.approx(0.05)
    assert value["unreinforced"] == pytest.approx(5 / 12, rel=1e-5)
    assert (value["widening_y"], value["fill_wrapped"]) == (2, 80)
    assert (value["height_layered"], value["yarns_wrapped"]) == (pytest.approx(-1), pytest.approx(-1))
    assert value["slow"] is None


def test_a_slow_twin_is_compared_station_by_station(folder):
    cell(folder / "wrapped_PE_slow.tsv", axial=2 * numpy.array([1, 3, 5, 5.4, 5]))
    assert chapter.slowed(Runs(folder)) == pytest.approx(10)
    cell(folder / "wrapped_PE_slow.tsv", stage=[0, 1, 1, 1, 1])
    with pytest.raises(NotMade, match="has not come to the end"):
        chapter.slowed(Runs(folder))


def test_half_of_no_dilation_is_not_met(folder):
    for form, volume in zip(FORMS, (-0.01, 0.001), strict=True):
        cell(folder / f"{form}_5PP.tsv", strain_volumetric=volume)
    study = Study("ch4", "", folder, "quick")
    chapter.measure_cells(study, Runs(folder))
    assert study.measures["dilation_5PP"].value == 100


def test_what_is_stated_is_measured(study):
    for name in ("statements.tsv", "checks.tsv"):
        assert all(s.name in study.measures for s in read_statements(HERE / name))


def test_the_page_says_all_that_it_shows(folder):
    (folder / "provenance.txt").write_text("none")
    study = chapter.build(types.SimpleNamespace(out=folder, kept=False, profile="quick"))
    study.write()
    assert (folder / "page.html").exists()
    assert study.headline.startswith("In the quick run with PP, the wrapped cell carries 24.0 times the lateral stress, the layered cell 12.0 times.")
    pyplot.close("all")


def test_every_column_is_missed_by_name(folder):
    def run(function):
        def reader():
            study = Study("ch4", "", folder, "quick", judged=False)
            study.pageless = True
            function(study, Runs(folder))
        return reader
    assert demand_columns([run(f) for f in (*chapter.MEASURES, *drawing.OF_ALL, *drawing.OF_RUNS)]) > 60


def grains(path):
    """Eight grains of soil along x, the outermost of which shears, a fill grain and a node."""
    return write(path, position_x=[*numpy.arange(8) / 10, 5, 6], position_y=[0, 0.02, *[0] * 6, 0, 0], position_z=0, radius=0.015,
                 part=[*[0] * 8, 1, 2], strain_deviatoric=[*[0.1] * 7, 1, 9, float("nan")])


def test_a_section_has_the_circles_of_grains_that_the_plane_cuts(tmp_path):
    cut = sections.cut(grains(tmp_path / "g.tsv"))
    assert len(cut["x [mm]"]) == 10  # the plane lies 10 mm off most grains
    assert cut["radius [mm]"] == pytest.approx(numpy.full(10, (15**2 - 10**2)**0.5))
    assert cut["x [mm]"][0] == pytest.approx(-350)


def test_bands_count_soil_alone_by_its_distance(tmp_path):
    bands = sections.bands(grains(tmp_path / "g.tsv"))
    assert bands["grains [1]"].sum() == 8
    assert list(bands["sheared [1]"]) == [0] * 9 + [1]


def test_the_state_is_that_of_the_extreme_void_ratio(tmp_path):
    loading = cell(tmp_path / "wrapped_PP.tsv").table
    steps = numpy.array([77, 0, 10, 20, 30, 40])
    assert (sections.state(steps, loading, "least"), sections.state(steps, loading, "greatest")) == (3, 5)
    with pytest.raises(StudyError, match='step 40 was not recorded; record "stations"'):
        sections.state(steps[:-1], loading, "greatest")


def test_of_kept_runs_those_that_there_are_are_measured(folder):
    for path in (*folder.glob("layered*.tsv"), *folder.glob("*_5PP.tsv")):
        path.unlink(missing_ok=True)
    measures = chapter.build(types.SimpleNamespace(out=folder, kept=True, profile="thesis")).measures
    pyplot.close("all")
    assert measures["peak_wrapped_PP"].value == pytest.approx(24) and measures["lateral_held"].value is not None
    assert "not among the kept runs" in measures["peak_layered_PP"].reason and "not among the kept runs" in measures["gap_grows"].reason


def test_bands_are_looked_for_where_their_sentences_say():
    said = {s.name: s.description for s in read_statements(HERE / "statements.tsv")}
    assert "outer two fifths" in said["bands_wrapped"] and "inner half" in said["bands_layered"]
    for name, form, classes in (("bands_wrapped", "wrapped", slice(6, 10)), ("bands_layered", "layered", slice(0, 5))):
        bands = Table.read(HERE / "kept" / f"bands_{form}_PP_greatest.tsv")
        grains, sheared = bands("grains", "1"), bands("sheared", "1")
        share = (sheared[classes].sum() / sheared.sum()) / (grains[classes].sum() / grains.sum())
        measured = next(line.split("\t")[4] for line in (HERE / "kept/comparison.tsv").read_text().splitlines() if line.startswith(said[name]))
        assert float(measured) == pytest.approx(share, rel=1e-3)
