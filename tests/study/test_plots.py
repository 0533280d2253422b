"""The kinds of plots: each exists, its axes have names and units, and its curves are the numbers of the table."""
# SPDX-License-Identifier: GPL-3.0-or-later
import h5py
import numpy
import pytest
from matplotlib import pyplot
from study import StudyError, Table, kinds, plots

PURE = ("stress ratio σₐ/σᵣ", "void ratio e", "coordination number", "anisotropy", "broken yarns", "density along x", "density along y",
        "density along z")


@pytest.fixture(autouse=True)
def closed_figures():
    yield
    pyplot.close("all")


def table_for(kind, name="run.tsv", scale=1.0, rows=3):
    """A table of a kind: step, stage and every column that it draws, each with numbers of its own."""
    lines = [line for panel in kind.panels for entry in (panel.abscissa, *panel.each) for line in (entry if isinstance(entry, tuple) else (entry,))]
    columns = {line.column: line.unit for line in lines}
    units = {"%": "1", "kPa": "Pa"}  # tables are in SI
    head = "\t".join(["step [1]", "stage [1]", *(f"{c} [{units.get(u, u)}]" for c, u in columns.items())])
    text = [head] + ["\t".join([str(r), str(r // 2), *(repr(scale * (k + 1) * (r + 1) / 100) for k in range(len(columns)))]) for r in range(rows)]
    return Table.parse("\n".join(text), name)


def test_a_table_without_rows_is_refused():
    with pytest.raises(StudyError, match="run.tsv: has no rows"):
        plots.stage_of(table_for(kinds.KINDS["stress-strain"], rows=0), "", kinds.KINDS["stress-strain"])


@pytest.mark.parametrize(("rows", "why"), [("", "has no rows below its header"), ("nan\t1\n", "column strain_axial has no value; give test data")])
def test_test_data_without_numbers_are_refused_without_remedies_for_runs(rows, why):
    empty = Table.parse(f"strain_axial [%]\tstress_ratio\n{rows}", "b.tsv")
    with pytest.raises(StudyError, match=f"b.tsv: {why}"):
        plots.draw("stress-strain", [("run", table_for(kinds.KINDS["stress-strain"]))], [("b", empty)])


LINED = [name for name, kind in kinds.KINDS.items() if kind.panels]


@pytest.mark.parametrize("name", LINED)
def test_curves_are_the_numbers_of_the_table_and_axes_have_units(name):
    kind, table = kinds.KINDS[name], table_for(kinds.KINDS[name])
    figure, notes = plots.draw(name, [("run", table)])
    assert len(figure.axes) == len(kind.panels) and notes == []
    for axes, panel in zip(figure.axes, kind.panels, strict=True):
        assert axes.get_xlabel() == panel.abscissa.axis
        for label in (axes.get_xlabel(), axes.get_ylabel()):
            assert label in PURE or label.endswith(")")
        lines = [entry[0] if isinstance(entry, tuple) else entry for entry in panel.each]
        for curve, line in zip(axes.lines, lines, strict=True):
            assert list(curve.get_xdata()) == list(table(panel.abscissa.column, panel.abscissa.unit))
            assert list(curve.get_ydata()) == list(table(line.column, line.unit))


@pytest.mark.parametrize("name", LINED)
def test_a_column_that_is_renamed_is_missed_by_name(name):
    kind = kinds.KINDS[name]
    for panel in kind.panels:
        for line in (panel.abscissa, *(entry for entry in panel.each if not isinstance(entry, tuple))):
            table = table_for(kind)
            table._units = {("other" if c == line.column else c): u for c, u in table._units.items()}  # pylint: disable=protected-access
            table._place = {c: k for k, c in enumerate(table._units)}  # pylint: disable=protected-access
            with pytest.raises(StudyError, match=f"run.tsv: has no column {line.column}"):
                plots.draw(name, [("run", table)])


def test_runs_beside_each_other_have_colours_of_their_own_and_geotextiles_theirs():
    tables = [(name, table_for(kinds.KINDS["bag"], name)) for name in ("uc_PE", "uc_PP")]
    figure, _ = plots.draw("bag", tables)
    assert [line.get_color() for line in figure.axes[0].lines] == [plots.figures.GEOTEXTILE[g] for g in ("PE", "PP")]
    figure, _ = plots.draw("bag", [("uc_PE", tables[0][1]), ("uc_PE_rough", tables[1][1])])
    assert len({line.get_color() for line in figure.axes[0].lines}) == 2
    assert [text.get_text() for text in figure.axes[0].get_legend().get_texts()] == ["uc_PE", "uc_PE_rough"]


def test_test_data_are_points_and_what_they_lack_is_said():
    kind = kinds.KINDS["stress-strain"]
    test = Table.parse("strain_axial [%]\tdeviatoric_stress [kPa]\n1\t20\n2\t30\n", "test.tsv")
    figure, notes = plots.draw("stress-strain", [("run", table_for(kind))], [("test", test)])
    # The test has no stress ratio: the deviatoric stress, which both have, is drawn.
    assert figure.axes[0].get_ylabel() == "deviatoric stress q (kPa)"
    assert list(figure.axes[0].lines[1].get_ydata()) == [20, 30] and figure.axes[0].lines[1].get_linestyle() == "None"
    assert notes == ["test: has no column strain_volumetric; volumetric strain, contraction positive is without it"]
    with pytest.raises(StudyError, match="test: has none of the columns that e-log-p draws"):
        plots.draw("e-log-p", [("run", table_for(kinds.KINDS["e-log-p"]))], [("test", test)])


def test_test_data_of_other_columns_are_refused_by_the_column_that_they_have():
    run = table_for(kinds.KINDS["stress-strain"])
    stress = Table.parse("strain_axial [%]\tdeviatoric_stress [kPa]\n0\t0\n1\t100\n", "b.tsv")
    ratio = Table.parse("strain_axial [%]\tstress_ratio\n0\t1\n1\t3\n", "b2.tsv")
    with pytest.raises(StudyError, match="b: has deviatoric_stress, but stress_ratio is drawn of the other tables; draw it without them"):
        plots.draw("stress-strain", [("run", run)], [("b", stress), ("b2", ratio)])
    # A table with a column of the other panel is drawn there. This panel draws the column that most tables have.
    both = Table.parse("strain_axial [%]\tstress_ratio\tstrain_volumetric [%]\n0\t1\t0\n1\t3\t1\n", "b3.tsv")
    volume = Table.parse("strain_axial [%]\tstrain_volumetric [%]\n0\t0\n1\t1\n", "b.tsv")
    figure, notes = plots.draw("stress-strain", [("run", run)], [("b", volume), ("b3", both)])
    assert figure.axes[0].get_ylabel() == "stress ratio σₐ/σᵣ" and [len(a.lines) for a in figure.axes] == [2, 3]
    assert notes == ["b: has no column stress_ratio; stress ratio σₐ/σᵣ is without it"]


def test_points_without_a_neighbour_are_marked():
    head = "strain_axial [1]\tdeviatoric_stress [Pa]\tstrain_volumetric [1]\n"
    figure, _ = plots.draw("stress-strain", [("run", Table.parse(head + "0\t0\t0\n", "run.tsv"))])
    assert [(line.get_marker(), line.get_markevery()) for a in figure.axes for line in a.lines] == [("o", [0])] * 2
    figure, _ = plots.draw("stress-strain", [("run", Table.parse(head + "0\t0\t0\n1\tnan\t0\n2\t5\t0\n", "run.tsv"))])
    assert [(a.lines[0].get_marker(), a.lines[0].get_markevery()) for a in figure.axes] == [("o", [0, 2]), ("None", None)]
    with pytest.raises(StudyError, match="run.tsv: no row has a value of both strain_axial and deviatoric_stress"):
        plots.draw("stress-strain", [("run", Table.parse(head + "nan\t0\t0\n1\tnan\t0\n", "run.tsv"))])


def test_rows_that_a_logarithmic_axis_leaves_out_are_counted():
    head, kind = "mean_stress [Pa]\tvoid_ratio [1]\n", "e-log-p"
    figure, notes = plots.draw(kind, [("run", Table.parse(head + "0\t1\n1e3\t0.9\n-5\t0.8\n2e3\t0.7\n", "run.tsv"))])
    assert notes == ["run: 2 of 4 rows left out, since mean_stress is not above 0 there, and its axis is logarithmic"]
    assert numpy.isnan(figure.axes[0].lines[0].get_xdata()).tolist() == [True, False, True, False]
    test = Table.parse("mean_stress [kPa]\tvoid_ratio [1]\n0\t1\n1\t0.9\n", "test.tsv")
    assert plots.draw(kind, [("run", table_for(kinds.KINDS[kind]))], [("test", test)])[1] == [
        "test: 1 of 2 rows left out, since mean_stress is not above 0 there, and its axis is logarithmic"]
    with pytest.raises(StudyError, match="run.tsv: column mean_stress has no value above 0, and its axis is logarithmic"):
        plots.draw(kind, [("run", Table.parse(head + "0\t1\n-1\t0.9\n", "run.tsv"))])


def test_missing_values_leave_gaps_and_columns_of_nothing_else_are_refused():
    text = "strain_axial [1]\tstress_ratio [1]\tstrain_volumetric [1]\n0\t1\t0\n0.1\tnan\t0\n0.2\t3\t0\n"
    figure, notes = plots.draw("stress-strain", [("run", Table.parse(text, "run.tsv"))])
    assert numpy.isnan(figure.axes[0].lines[0].get_ydata()).tolist() == [False, True, False]
    assert notes == ["run: 1 of 3 rows have no stress_ratio, and the curve over strain_axial has gaps there"]
    with pytest.raises(StudyError, match="run.tsv: column stress_ratio has no value"):
        plots.draw("stress-strain", [("run", Table.parse(text.replace("\t1\t", "\tnan\t").replace("\t3\t", "\tnan\t"), "run.tsv"))])


@pytest.mark.parametrize(("kind", "remedy"), [("e-log-p", "--table volumes --box"), ("stress-strain", "--table volumes --box"),
                                              ("energies", "columns of its plates: homogenize RUN --table series")])
def test_a_cell_that_is_not_periodic_has_a_remedy(kind, remedy):
    over = kinds.KINDS[kind].panels[0].abscissa.column
    table = table_for(kinds.KINDS[kind]).replace(over, numpy.full(3, numpy.nan))
    with pytest.raises(StudyError, match=f"column {over} has no value; a cell that is not periodic has none: .*{remedy}"):
        plots.draw(kind, [("run", table)])


def test_disks_beside_spheres_are_doubted():
    head = "strain_axial [1]\tstress_ratio [1]\tstrain_volumetric [1]\tstrain_zz [1]\tstress_yy [Pa]\tstress_zz [Pa]\n"
    disks, spheres = (Table.parse(f"{head}0\t1\t0\t0\t1000\t0\n0.1\t2\t0\t{z}\t2000\t{1000 * z}\n", "run.tsv") for z in (0, 0.1))
    doubt = "doubt: flat is a run of disks, and round of spheres: their void ratios and coordination numbers do not compare, nor stresses at one stiffness"
    assert plots.draw("stress-strain", [("flat", disks), ("round", spheres)])[1] == [doubt]
    assert plots.draw("stress-strain", [("flat", disks), ("other", disks)])[1] == []
    test = Table.parse("strain_axial [%]\tstress_ratio [1]\tstrain_volumetric [%]\n0\t1\t0\n", "test.tsv")
    assert plots.draw("stress-strain", [("flat", disks), ("test", test)])[1] == []


def test_a_rose_needs_contacts():
    head = "step [1]\tplane [1]\tangle [deg]\tcontacts [1]\tdensity [1]\tnormal_force [N]\n"
    with pytest.raises(StudyError, match="bare.tsv: has no contacts in its last state, and so no rose; give a state under load"):
        plots.draw("rose", [("bare", Table.parse(f"{head}0\t1\t90\t0\tnan\tnan\n0\t1\t270\t0\tnan\tnan\n", "bare.tsv"))])


def test_a_column_without_its_unit_is_told_with_the_head_that_it_needs():
    table = Table.parse("strain_axial [%]\tdeviatoric_stress\tstrain_volumetric [%]\n0\t0\t0\n1\t100\t0\n", "q.tsv")
    with pytest.raises(StudyError, match=r"q.tsv: column deviatoric_stress: has no unit: head it as deviatoric_stress \[kPa\]"):
        plots.draw("stress-strain", [("q", table)])


def test_the_last_stage_is_drawn_over_strain_and_all_along_a_path():
    table = table_for(kinds.KINDS["stress-strain"], rows=4)
    assert len(plots.stage_of(table, "", kinds.KINDS["stress-strain"])) == 2
    assert len(plots.stage_of(table, "", kinds.KINDS["stress-path"])) == 4
    assert len(plots.stage_of(table, "0", kinds.KINDS["stress-path"])) == 2
    assert len(plots.stage_of(table, "all", kinds.KINDS["stress-strain"])) == 4
    with pytest.raises(StudyError, match="run.tsv: has no stage 5; give one that it has: 0, 1"):
        plots.stage_of(table, "5", kinds.KINDS["stress-path"])
    bare = Table.parse("strain_axial [1]\n0\n", "bare.tsv")
    assert len(plots.stage_of(bare, "", kinds.KINDS["stress-strain"])) == 1
    with pytest.raises(StudyError, match="bare.tsv: has no column stage"):
        plots.stage_of(bare, "1", kinds.KINDS["stress-strain"])


def test_a_bag_is_drawn_from_where_its_settlement_counts():
    rows = [(0, -3e-4), (0, 0), (1, 1e-3), (2, 0), (2, -1e-3)]
    table = Table.parse("stage [1]\tsettlement [m]\n" + "".join(f"{stage}\t{settled}\n" for stage, settled in rows), "loading.tsv")
    assert list(plots.stage_of(table, "", kinds.KINDS["bag"])("settlement", "mm")) == [0, 1, 0, -1]
    assert len(plots.stage_of(table, "2", kinds.KINDS["bag"])) == 2


def test_a_bag_has_the_columns_of_its_loading_or_those_of_its_series_over_the_strain_between_its_plates():
    series = Table.parse("step [1]\tstrain_axial [1]\tmean_stress [Pa]\tcoordination_number [1]\tmechanical_coordination_number [1]\n"
                         "1\t0\t1\t5\t6\n2\t0\t2\t5\t6\n", "bag.h5")
    loading = Table.parse("step [1]\tstrain_axial [1]\tmean_stress [Pa]\tdeviatoric_stress [Pa]\tcoordination_number [1]\n"
                          "1\t0\t7\t8\t4\n2\t0.1\t7\t8\t4\n", "bag.h5")
    assert list(plots.bag_series(kinds.KINDS["stress-path"], series, loading)("mean_stress", "Pa")) == [7, 7]
    whole = plots.bag_series(kinds.KINDS["coordination"], series, loading)
    assert list(whole("strain_axial", "1")) == [0, 0.1] and list(whole("coordination_number", "1")) == [5, 5]
    fabric = Table.parse("step [1]\tstrain_axial [1]\n1\t0\n2\t0\n", "bag.h5")
    assert list(plots.strained(fabric, plots.bag_series(kinds.KINDS["fabric"], series, loading))("strain_axial", "1")) == [0, 0.1]


def test_states_get_the_strain_that_the_series_has_at_their_steps():
    series = Table.parse("step [1]\tstrain_axial [1]\n10\t0\n30\t0.02\n", "run.h5")
    fabric = Table.parse("step [1]\tstrain_axial [1]\ta_c [1]\n0\t0\t0.1\n10\t0.005\t0.2\n20\t0.01\t0.3\n", "run.h5")
    strained = plots.strained(fabric, series)
    assert list(strained("strain_axial", "%")) == [0, 1] and list(strained("a_c", "1")) == [0.2, 0.3]
    # The series of a cell that is not periodic has no strain: the fabric has none either, and says where to look.
    unknown = plots.strained(fabric, series.replace("strain_axial", numpy.full(2, numpy.nan)))
    with pytest.raises(StudyError, match="a cell that is not periodic has none: see the columns of its plates"):
        plots.draw("fabric", [("run", unknown)])


def test_roses_draw_the_last_state_in_each_plane():
    rows = [(step, plane, angle, 1 + step + plane / 10) for step in (0, 1) for plane in (0, 1, 2) for angle in (45, 135, 225, 315)]
    text = "step [1]\tplane [1]\tangle [deg]\tdensity [1]\n" + "\n".join("\t".join(map(str, row)) for row in rows)
    figure, _ = plots.draw("rose", [("run", Table.parse(text, "run.tsv"))])
    assert [(a.get_xlabel(), a.get_ylabel()) for a in figure.axes] == [("density along x", "density along y"), ("density along x", "density along z")]
    for axes, density in zip(figure.axes, (2.1, 2.2), strict=True):
        x, y = axes.lines[1].get_data()
        assert numpy.allclose(numpy.hypot(x, y), density) and len(x) == 9
    # A plane is drawn of the runs that have it.
    flat = Table.parse("\n".join(line for line in text.splitlines() if line.split("\t")[1] != "2"), "flat.tsv")
    figure, notes = plots.draw("rose", [("run", Table.parse(text, "run.tsv")), ("flat", flat)])
    assert [len(a.lines) for a in figure.axes] == [3, 2]
    assert notes == ["flat: has no contacts in the plane xz; that panel is without it"]
    with pytest.raises(StudyError, match="has one direction alone in plane 1"):
        plots.draw("rose", [("run", Table.parse("\n".join(text.splitlines()[:1] + ["0\t1\t45\t1"]), "run.tsv"))])
    with pytest.raises(StudyError, match="run.tsv: has no column stage by which to choose one; leave --stage out"):
        plots.stage_of(Table.parse(text, "run.tsv"), "0", kinds.KINDS["rose"])
    with pytest.raises(StudyError, match="has none of the planes 1, 2"):
        plots.draw("rose", [("run", Table.parse("step [1]\tplane [1]\n0\t0\n", "run.tsv"))])


PRIOR = '[[parameter]]\nname = "e"\nlong_name = "Young\'s modulus"\nunit = "Pa"\nscale = "log"\n[[parameter]]\nname = "nu"\n'


def test_posteriors_draw_the_densities_of_the_last_step(tmp_path):
    with h5py.File(tmp_path / "posterior.h5", "w") as file:
        file["prior"] = PRIOR
        for name, values in {"step": [1, 1, 2, 2, 2, 2], "parameter": [0, 1, 0, 0, 1, 1], "value": [1e8, 0, 1e8, 1e9, 0, 0.5],
                             "density": [9, 9, 1, 2, 3, 4]}.items():
            file[f"fields/density/{name}"] = values
    figure, _ = plots.draw("posterior", [("case", plots.read_posterior(tmp_path / "posterior.h5"))])
    modulus, ratio = figure.axes
    assert (modulus.get_xlabel(), modulus.get_ylabel(), modulus.get_xscale()) == ("Young's modulus (Pa)", "density (1/decade)", "log")
    assert (ratio.get_xlabel(), ratio.get_ylabel(), ratio.get_xscale()) == ("nu", "density", "linear")
    assert list(modulus.lines[0].get_ydata()) == [1, 2] and list(ratio.lines[0].get_xdata()) == [0, 0.5]
