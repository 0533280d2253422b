"""The studies' package: what it reads, refuses, compares, draws and writes, on small tables."""
# SPDX-License-Identifier: GPL-3.0-or-later
import math
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

import pytest
from study import Measure, NotMade, Statement, Study, StudyError, Table, compare, figures, read_statements

ROOT = pathlib.Path(__file__).parents[2]


@pytest.fixture(name="table")
def small_table(tmp_path):
    (tmp_path / "run.tsv").write_text("strain [1]\tstress [Pa]\tvoid_ratio [1]\n0\t1000\t0.7\n0.01\t3000\tnan\n")
    return Table.read(tmp_path / "run.tsv")


def test_columns_come_by_name_in_the_unit_asked_for(table):
    assert list(table("strain", "%")) == [0, 1]
    assert list(table("stress", "kPa")) == [1, 3]
    assert len(table) == 2


def test_a_column_that_is_missing_or_of_another_kind_names_file_and_nearest(table):
    with pytest.raises(StudyError, match=r"run\.tsv: has no column stres; did you mean 'stress'\?"):
        table("stres", "Pa")
    with pytest.raises(StudyError, match=r"run\.tsv: column stress: 'Pa' is a unit of stress, 'm' of length"):
        table("stress", "m")
    with pytest.raises(StudyError, match=r"'kpa' is not a known unit; did you mean 'kPa'\?"):
        table("stress", "kpa")


def test_a_missing_value_is_never_a_number(table):
    with pytest.raises(StudyError, match="void_ratio has no value in row 2"):
        table("void_ratio", "1")
    assert math.isnan(table("void_ratio", "1", missing=True)[1])


def test_rows_and_values_between_them_are_not_extrapolated(table):
    assert table.at("stress", "Pa", "strain", 0.5, "%") == 2000
    with pytest.raises(StudyError, match="lies outside 0 to 1"):
        table.at("stress", "Pa", "strain", 1.5, "%")
    with pytest.raises(StudyError, match="none of the rows"):
        table.rows(table("strain", "1") > 1)


@pytest.mark.parametrize(("text", "message"), [
    ("", "holds no table"),
    ("a [1]\ta [Pa]\n1\t2\n", "two columns are named a"),
    ("a [1]\tb [1]\n1\n", "row 1 has 1 values, the header 2 columns"),
    ("a [1\n1\n", "is no head of a column"),
])
def test_tables_that_are_none_are_refused(tmp_path, text, message):
    (tmp_path / "bad.tsv").write_text(text)
    with pytest.raises(StudyError, match=message):
        Table.read(tmp_path / "bad.tsv")


def test_a_word_where_a_number_belongs_names_its_column(tmp_path):
    (tmp_path / "words.tsv").write_text("a [1]\nnone\n")
    with pytest.raises(StudyError, match="words.tsv: column a: .*none"):
        Table.read(tmp_path / "words.tsv")("a", "1")


def stated(relation="within", published="2", tolerance="0.5", unit="kPa", name="peak"):
    return Statement(name, relation, published, tolerance, unit, "thesis", "greatest stress")


@pytest.mark.parametrize(("statement", "value", "met"), [
    (stated(), 2400, True), (stated(), 2600, False), (stated(), 1400, False),
    (stated("at most", tolerance=""), 2000, True), (stated("at most", tolerance=""), 2001, False),
    (stated("at least", tolerance=""), 2000, True), (stated("at least", tolerance=""), 1999, False),
])
def test_relations_are_judged_in_the_unit_of_the_statement(statement, value, met):
    (verdict,) = compare([statement], {"peak": Measure(value, "Pa")})
    assert verdict.met == met


def test_a_verdict_shows_value_scatter_and_difference():
    (verdict,) = compare([stated()], {"peak": Measure(2400, "Pa", 120)})
    assert (verdict.measured, verdict.difference, verdict.published, verdict.tolerance) == ("2.4 ± 0.12", "+0.4 (+20.0 %)", "2", "± 0.5")


@pytest.mark.parametrize("value", [math.nan, math.inf])
def test_nan_is_never_met(value):
    with pytest.raises(StudyError, match="not a number"):
        compare([stated("at least", tolerance="")], {"peak": Measure(value, "Pa")})


def test_a_statement_needs_its_measure_and_a_unit_that_fits():
    with pytest.raises(StudyError, match="peak: is stated but not measured; did you mean 'peaks'?"):
        compare([stated()], {"peaks": Measure(1, "Pa")})
    with pytest.raises(StudyError, match="peak: 'm' is a unit of length"):
        compare([stated()], {"peak": Measure(1, "m")})
    assert compare([stated()], {"peak": Measure(None, "Pa", reason="runs of full size only")}) == []


@pytest.mark.parametrize(("change", "message"), [
    ({"relation": "atleast"}, "'atleast' is not a known relation; did you mean 'at least'"),
    ({"published": "nan"}, "the published value 'nan' is no number"),
    ({"tolerance": ""}, "a tolerance belongs to the relation within"),
    ({"tolerance": "0"}, "must be above 0"),
    ({"relation": "at most"}, "a tolerance belongs to the relation within"),
])
def test_statements_that_cannot_be_judged_are_refused(change, message):
    with pytest.raises(StudyError, match=message):
        stated(**change)


def test_tables_of_statements_name_line_and_column(tmp_path):
    head = "name\trelation\tpublished\ttolerance\tunit\tsource\tdescription\n"
    path = tmp_path / "expected.tsv"
    path.write_text(head + "# a comment\npeak\twithin\t2\t0.5\tkPa\tthesis\tgreatest stress\n")
    assert read_statements(path) == [stated()]
    path.write_text(head + "peak\tbelow\t2\t\tkPa\tthesis\tgreatest stress\n")
    with pytest.raises(StudyError, match="line 2: peak: 'below' is not a known relation"):
        read_statements(path)
    path.write_text(head.replace("tolerance", "tolerence"))
    with pytest.raises(StudyError, match="has no column tolerance; did you mean 'tolerence'"):
        read_statements(path)


def test_every_table_of_statements_in_the_tree_is_read():
    for study in ("quickstart", "packings", "ch5"):
        for path in (ROOT / "pipelines" / study).glob("*.tsv"):
            assert read_statements(path)


def example(folder):
    study = Study("example", "An <example>", folder, "quick")
    study.lead = "Two grains & a wall."
    # A measure, its statement and a figure of it are three lines.
    study.measure("peak", 2.1, "kPa", 0.05)
    study.state("peak", "within", 2, "kPa", "thesis", "greatest stress", tolerance=0.5)
    figure, (axes,) = figures.panels(1)
    axes.plot([0, 1], [0, 2])
    figures.label(axes, "axial strain (%)", "stress (kPa)")
    study.figure("stress", figure, "Stress rises.")
    return study


def test_a_study_writes_tables_figures_and_page_and_the_same_bytes_again(tmp_path, capsys):
    example(tmp_path).write()
    first = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    example(tmp_path).write()
    assert first == {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    assert sorted(first) == ["comparison.tsv", "measured.tsv", "page.html", "stress.svg"]
    assert capsys.readouterr().out.startswith("example: 1 published values met, 0 not met")
    page = first["page.html"].decode()
    xml.etree.ElementTree.fromstring(page)  # every tag is closed
    assert "An &lt;example&gt;" in page and "Two grains &amp; a wall." in page and "2.1 ± 0.05" in page
    assert not re.search(r'<(\w+)[^>]* id="(?!example)', page)


def test_an_axis_without_a_unit_is_refused():
    figure, (axes,) = figures.panels(1)
    with pytest.raises(StudyError, match="axis 'stress': has no unit"):
        figures.label(axes, "axial strain (%)", "stress")
    figures.label(axes, "axial strain (%)", "q/p", pure=["q/p"])
    figures.svg(figure)


def test_a_measure_is_made_once(tmp_path):
    study = example(tmp_path)
    with pytest.raises(StudyError, match="peak: is measured twice"):
        study.measure("peak", 1, "kPa")


def test_a_measure_without_its_run_is_not_made_and_says_why(tmp_path):
    def of_full_size():
        raise NotMade("made with PROFILE=thesis")
    study = example(tmp_path)
    study.measure("strength", of_full_size, "kPa")
    study.measure("strain", lambda: 0.02 + 1e-9, "1")
    assert study.measures["strength"] == Measure(None, "kPa", reason="made with PROFILE=thesis")
    assert study.measures["strain"] == Measure(0.02, "1")


@pytest.mark.parametrize("name", ["quickstart", "packings", "ch5"])
def test_a_study_without_its_tables_ends_in_one_line(tmp_path, name):
    run = subprocess.run([sys.executable, "-P", ROOT / f"pipelines/{name}/study.py", tmp_path], capture_output=True, text=True,
                         check=False, env={"PYTHONPATH": str(ROOT / "pipelines"), "PYTHONDONTWRITEBYTECODE": "1"})
    assert run.returncode == 65
    assert run.stderr.startswith("study: ") and run.stderr.count("\n") == 1 and ".tsv: cannot be read" in run.stderr
