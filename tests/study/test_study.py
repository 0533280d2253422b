"""The studies' package on small tables: reading, refusals, comparisons, figures and pages."""
# SPDX-License-Identifier: GPL-3.0-or-later
import json
import math
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

import pytest
from study import Drawn, Measure, NotMade, Series, Statement, Study, StudyError, Table, compare, figures, main, panel, read_statements
from study.files import put
from study.units import factor
from study.words import plain, spell

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
    # A unit of another quantity would be refused in turn.
    with pytest.raises(StudyError, match=r"'kPa/m' is not a known unit; did you mean 'kN/m'\?"):
        factor("kPa/m", "N/m")
    assert factor("N/mm", "N/m") == 1e3


def test_a_missing_value_is_never_a_number(table):
    with pytest.raises(StudyError, match="void_ratio has no value in row 2"):
        table("void_ratio", "1")
    assert math.isnan(table("void_ratio", "1", missing=True)[1])


def test_rows_that_are_not_there_are_an_error(table):
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
    with pytest.raises(StudyError, match="words.tsv: row 1: column a: .*none"):
        Table.read(tmp_path / "words.tsv")("a", "1")


@pytest.mark.parametrize(("content", "sum_of_cells"), [
    ("a [mm],b (kPa)\n1,2\n", 2000.001), ('"a [mm]";"b [kN/m²]"\r\n"1";2\r\n', 2000.001), ("\ufeffa [µm]\tb [N/mm2]\r1\t2\r", 2000000.000001),
    ("a\u00a0[m]\tb [bar]\n1\u00a0\t 2\n", 200001)])
def test_separators_units_and_line_ends_are_taken_as_they_are_written(tmp_path, content, sum_of_cells):
    (tmp_path / "a.csv").write_bytes(content.encode())
    table = Table.read(tmp_path / "a.csv")
    assert table("a", "m")[0] + table("b", "Pa")[0] == pytest.approx(sum_of_cells, rel=1e-12)
    assert Table.parse("share [-]\n0.5\n", "a table")("share", "%")[0] == 50


@pytest.mark.parametrize(("content", "message"), [
    (b"a [m]\n0,5\n", "column a: '0,5' is no number: write 0.5, with a decimal point"), (b"a [m]\n1\na [m]\n", "row 2: column a: 'a \\[m\\]' is no number"), (b"a [m]\n1_0\n", "'1_0' is no number"),
    (b"a [m]\n\xb5\n", "line 2: is not UTF-8; .*iconv -f WINDOWS-1252"), (b"\xff\xfea\0", "UTF-16 text"), (b"a [m]\n\0\n", "zero bytes"),
    (b"\x89HDF\r\n\x1a\n", "an HDF5 file where a text belongs")])
def test_texts_that_are_not_understood_are_refused_by_file(tmp_path, content, message):
    (tmp_path / "bad.tsv").write_bytes(content)
    with pytest.raises(StudyError, match=f"bad.tsv: .*{message}"):
        Table.read(tmp_path / "bad.tsv")("a", "m")


def test_files_are_replaced_whole_through_links_with_their_permissions(tmp_path):
    (tmp_path / "real").mkdir()
    (tmp_path / "link").symlink_to("real/file")
    put(tmp_path / "link", "one")  # made where a dangling link points to
    (tmp_path / "real/file").chmod(0o640)
    left = tmp_path / "real/.file.0123456789abcdef.tmp"
    left.write_text("of a killed process")
    put(tmp_path / "link", b"two")
    assert (tmp_path / "link").is_symlink() and (tmp_path / "real/file").read_text() == "two"
    assert (tmp_path / "real/file").stat().st_mode & 0o777 == 0o640 and not left.exists()
    with pytest.raises(OSError):
        put(tmp_path / "real", "no file")
    assert sorted(path.name for path in (tmp_path / "real").iterdir()) == ["file"]


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
    assert (verdict.measured, verdict.difference) == ("2.4 ± 0.12", "+0.4 (+20.0 %)")
    assert (verdict.statement.bound, verdict.statement.margin) == ("2", "± 0.5")


def test_a_rounding_error_is_no_difference():
    (verdict,) = compare([stated()], {"peak": Measure(2000 * (1 - 1e-15), "Pa")})
    assert verdict.difference == "+0 (+0.0 %)"
    (verdict,) = compare([stated()], {"peak": Measure(2000 * (1 - 1e-8), "Pa")})
    assert verdict.difference == "-2e-08 (-0.0 %)"


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
    for study in ("quickstart", "packings", "ch2", "ch3", "ch4", "ch5", "ch6"):
        tables = [ROOT / "pipelines" / study / name for name in ("expected.tsv", "statements.tsv")]
        assert all(read_statements(path) for path in tables if path.exists())


def example(folder, judged=True):
    study = Study("example", "An <example>", folder, "quick", judged)
    study.lead = "Two grains & a wall."
    # A measure, its statement and a figure of it are three lines.
    study.measure("peak", 2.1, "kPa", 0.05)
    study.state("peak", "within", 2, "kPa", "thesis", "greatest stress", tolerance=0.5)
    study.figure("stress", drawing(), "Stress rises.", "Fig. 1", "stress rises.", ["peak"])
    study.headline = f"The greatest stress is {study.say('peak')}."
    return study


def drawing(columns=1):
    figure, axes = figures.panels(columns)
    for a in axes:
        a.plot([0, 1], [0, 2])
        figures.label(a, "axial strain (%)", "stress (kPa)")
    return figure


def test_the_three_lines_of_the_readme_add_a_measure_a_statement_and_a_figure(tmp_path):
    lines, curves = re.findall(r"```python\n(.*?)```", (ROOT / "pipelines/README.md").read_text(), re.DOTALL)
    assert lines.count("\n") == 3
    (tmp_path / "run.tsv").write_text("stress_ratio [1]\n1\n4.4\n4.1\n")
    (tmp_path / "bag.tsv").write_text("strain_axial [1]\tplate_pressure [Pa]\tmean_stress [Pa]\tdeviatoric_stress [Pa]\n0\t0\t0\t0\n0.1\t9\t8\t7\n")
    study = Study("example", "Example", tmp_path, "quick")
    exec(lines, {"study": study, "table": Table.read(tmp_path / "run.tsv"), "drawing": drawing()})  # pylint: disable=exec-used
    exec(curves, {"study": study, "tables": {"PE": Table.read(tmp_path / "bag.tsv")}, "Drawn": Drawn, "Series": Series,  # pylint: disable=exec-used
                  "figures": figures, "panel": panel})
    study.lead, study.headline = "A test.", f"The peak is {study.say('peak')}."
    study.write()
    assert (tmp_path / "load.svg").read_text().count(">PE<") == 2
    assert "peak stress ratio: <b>4.4</b>; expected 4.5 ± 0.3; <span class=\"met\">" in (tmp_path / "page.html").read_text()


def test_a_study_writes_tables_figures_and_page_and_the_same_bytes_again(tmp_path, capsys):
    example(tmp_path).write()
    first = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    example(tmp_path).write()
    assert first == {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    assert sorted(first) == ["card.json", "comparison.tsv", "measured.tsv", "page.html", "stress.svg"]
    assert capsys.readouterr().out.startswith("example: 1 of 1 published values within tolerance")
    page = first["page.html"].decode()
    xml.etree.ElementTree.fromstring(page)  # every tag is closed
    assert "An &lt;example&gt;" in page and "Two grains &amp; a wall." in page and "2.1 ± 0.05" in page
    assert not re.search(r'<(\w+)[^>]* id="(?!example)', page)
    card = json.loads(first["card.json"])
    assert card["score"]["met"] == card["score"]["total"] == 1 and 'id="card_example_stress' in card["figure"]


def test_a_study_of_which_nothing_is_kept_says_what_keeps_it(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["study.py", str(tmp_path / "ch9/kept"), "--kept"])
    with pytest.raises(SystemExit, match="65"):
        main(lambda _: None)
    assert "nothing is kept of ch9 yet; make PROFILE=thesis ch9, then ch9-keep" in capsys.readouterr().err


def test_statements_have_tables_of_their_own_and_kept_runs_no_page(tmp_path):
    (tmp_path / "statements.tsv").write_text("name\trelation\tpublished\ttolerance\tunit\tsource\tdescription\n"
                                             "peak\tat least\t1\t\tkPa\tthesis\tstress rises\n")
    study = example(tmp_path)
    study.expect(tmp_path / "statements.tsv", "Statements", table="checklist")
    study.write_tables()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["checklist.tsv", "comparison.tsv", "measured.tsv", "statements.tsv", "stress.svg"]
    assert [(tmp_path / f"{name}.tsv").read_text().count("\n") for name in ("comparison", "checklist")] == [2, 2]
    assert "stress rises\tkPa\tat least 1\t\t2.1 ± 0.05\t+1.1\tmet\tthesis" in (tmp_path / "checklist.tsv").read_text()


def test_a_row_that_is_not_met_has_its_reason_beside_it(tmp_path):
    study = example(tmp_path)
    study.state("peak", "at most", 1, "kPa", "thesis", "small stress")
    study.write()
    assert "the cause is not known" in (tmp_path / "page.html").read_text()
    study.reason("peak", "the wall is rough")
    study.write()
    page = (tmp_path / "page.html").read_text()
    assert "✗ not met</span> <small>the wall is rough</small>" in page and "the cause is not known" not in page
    study.reason("peek", "misspelt")
    with pytest.raises(StudyError, match="peek: is not stated; did you mean 'peak'"):
        study.write()


def kept(folder, measured="2.3", verdict="met", tolerance="± 0.5", description="greatest stress"):
    path = folder / "kept.tsv"
    path.write_text("description\tunit\tpublished\ttolerance\tmeasured\tdifference\tverdict\tsource\n"
                    f"{description}\tkPa\t2\t{tolerance}\t{measured}\t+0.3 (+15.0 %)\t{verdict}\tthesis\n")
    return path


def test_a_quick_run_is_shown_beside_the_kept_one_and_not_judged(tmp_path, capsys):
    study = Study("example", "Example", tmp_path, "quick", judged=False)
    study.measure("peak", 9, "kPa")  # far from what is published
    study.measure("work", 1e-4, "1")
    study.state("peak", "within", 2, "kPa", "thesis", "greatest stress", tolerance=0.5)
    study.kept(kept(tmp_path))
    study.accept("work", "at most", 1e-3, "1", "work left over")
    study.lead, study.headline = "Two grains.", f"At full size {study.say('peak', kept=True)}, in this run {study.say('peak')}."
    study.figure("stress", drawing(), "Stress rises.", measures=["peak"])
    study.write()
    assert capsys.readouterr().out == ("example: 1 of 1 published values within tolerance at full size. This quick run is not judged. "
                                       f"The run passes the check of the tools. ({tmp_path}/page.html)\n")
    page = (tmp_path / "page.html").read_text()
    assert "At full size 2.3\u00a0kPa, in this run 9.00\u00a0kPa." in page
    assert "2.3 kPa</b> at full size" in page and "quick run: 9 kPa" in page and 'class="unmet"' not in page
    assert (tmp_path / "comparison.tsv").read_text().splitlines()[1].split("\t")[6] == "not judged"
    study.measures["work"] = Measure(1, "1")
    study.write()
    assert "The run fails checks of the tools: work left over." in capsys.readouterr().out


def test_statements_that_need_full_size_are_judged_by_the_kept_run_beside_those_of_any_size(tmp_path, capsys):
    text = "name\trelation\tpublished\ttolerance\tunit\tsource\tdescription\nload\twithin\t5\t1\tkPa\tthesis\tload of the bag\n"
    (tmp_path / "grains.tsv").write_text(text)
    study = example(tmp_path)
    study.expect(tmp_path / "grains.tsv", "Of grains", table="grains", judged=False)
    study.measure("load", 9, "kPa")
    study.write()
    assert "1 of 1 published values within tolerance. No full-size run is kept. One value of this quick run is not judged." in capsys.readouterr().out
    assert (tmp_path / "grains.tsv").read_text().splitlines()[1].split("\t")[6] == "not judged"
    assert (tmp_path / "comparison.tsv").read_text().splitlines()[1].split("\t")[6] == "met"
    page = (tmp_path / "page.html").read_text()
    assert "1 of 1 met<" in page and "1 value, not judged" in page


@pytest.mark.parametrize(("change", "message"), [
    ({"description": "greatest strain"}, "'greatest strain' is no statement of the study; did you mean 'greatest stress'"),
    ({"tolerance": "± 0.4"}, "tolerance is '± 0.4', in the statements '± 0.5'; compare the kept run anew"),
    ({"verdict": "not judged"}, "only runs that are judged can be kept"),
])
def test_a_kept_comparison_that_fits_no_statement_is_refused(tmp_path, change, message):
    with pytest.raises(StudyError, match=rf"kept.tsv: line 2: .*{message}"):
        example(tmp_path).kept(kept(tmp_path, **change))


def test_numbers_in_sentences_come_from_measures(tmp_path):
    study = example(tmp_path)
    study.measure("load", 1731.4, "kPa")
    study.measure("contraction", -0.01234, "1", 0.0021)
    study.unmade("strength", "kPa", "made with PROFILE=thesis")
    assert study.say("load") == "1730\u00a0kPa" and study.say("load", 4, "MPa") == "1.731\u00a0MPa"
    assert study.say("contraction", 2, "%", deviation=True) == "−1.2 ± 0.21\u00a0%"
    assert study.published("peak") == "2\u00a0kPa"
    for name, message in (("lode", "lode: is said but not measured; did you mean 'load'"), ("strength", "made with PROFILE=thesis")):
        with pytest.raises(StudyError, match=message):
            study.say(name)
    with pytest.raises(StudyError, match="peak: no kept run has it"):
        study.say("peak", kept=True)


@pytest.mark.parametrize(("value", "digits", "text"), [
    (0, 3, "0"), (4.539, 3, "4.54"), (123456, 2, "120000"), (-0.00012, 2, "−0.00012"), (2.5e-9, 2, "2.5e−9"), (3e8, 1, "3e+8"),
    (9.996, 3, "10.0"), (-0.9996, 3, "−1.00"), (99.96, 3, "100")])
def test_numbers_are_spelt_to_significant_digits(value, digits, text):
    assert spell(value, digits) == text


@pytest.mark.parametrize(("text", "page"), [
    ("6.897e+04", "68970"), ("-3.091 ± 0.31", "−3.091 ± 0.31"), ("at most 1e-3", "at most 0.001"), ("8.6e-06", "8.6e−06"), ("-0.4 (-2 %)", "−0.4 (−2 %)"),
    ("wide-width 1.5", "wide-width 1.5")])
def test_numbers_on_pages_are_plain(text, page):
    assert plain(text) == page


def test_a_first_screen_is_short_and_whole(tmp_path):
    study = example(tmp_path)
    study.lead = "word " * 95
    with pytest.raises(StudyError, match="have 101 words; 100 are what a first screen holds"):
        study.write()
    study.lead = ""
    with pytest.raises(StudyError, match="opens with a lead, a headline and a figure"):
        study.write()


def test_panels_of_a_figure_are_cut_apart_and_its_file_is_whole(tmp_path):
    study = example(tmp_path)
    study.figure("two", drawing(2), "Two panels.")
    study.write()
    assert (tmp_path / "page.html").read_text().count('class="pane"') == 3
    assert (tmp_path / "two.svg").read_text().count(">stress (kPa)<") == 2
    for pane in figures.panes(drawing(2)):
        assert pane.count(">stress (kPa)<") == 1


def test_appendices_hold_tables_reports_and_text(tmp_path):
    (tmp_path / "causes.tsv").write_text("bag\tstress [kPa]\nsoft\t1\n")
    (tmp_path / "report.txt").write_text("a < b\n")
    study = example(tmp_path)
    study.appendix("Causes", "One.\n\nTwo.", tmp_path / "causes.tsv", {"bag": ["stiff"], "stress": [2]})
    study.text("Report", tmp_path / "report.txt")
    study.write()
    page = (tmp_path / "page.html").read_text()
    for part in ("<p>Two.</p>", "<th>stress [kPa]</th>", "<td>soft</td>", "<td>stiff</td>", "<pre>a &lt; b</pre>"):
        assert part in page
    with pytest.raises(StudyError, match="none.tsv: cannot be read"):
        study.appendix("Causes", tmp_path / "none.tsv")


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


@pytest.mark.parametrize("name", ["quickstart", "packings", "ch3", "ch4", "ch5", "ch6"])
def test_a_study_without_its_tables_ends_in_one_line(tmp_path, name):
    run = subprocess.run([sys.executable, "-P", ROOT / f"pipelines/{name}/study.py", tmp_path], capture_output=True, text=True,
                         check=False, env={"PYTHONPATH": str(ROOT / "pipelines"), "PYTHONDONTWRITEBYTECODE": "1"})
    assert run.returncode == 65
    assert run.stderr.startswith("study: ") and run.stderr.count("\n") == 1 and ".tsv: cannot be read" in run.stderr


def test_a_study_may_have_arguments_of_its_own(tmp_path, monkeypatch):
    def build(arguments):
        assert arguments.cases == ["one", "two"]
        return example(arguments.out)
    monkeypatch.setattr(sys, "argv", ["study.py", str(tmp_path), "--cases", "one", "two"])
    main(build, cases={"nargs": "+"})
    assert (tmp_path / "page.html").exists()
