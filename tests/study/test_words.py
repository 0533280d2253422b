"""The studies' package: pages from words.toml, figures from short descriptions, shared ways to read tables."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib
import types

import pytest
from matplotlib import pyplot
from study import Cells, Drawn, Folder, Mean, NotMade, Series, Study, StudyError, Table, curves, panel, read_statements
from study.kept import COLUMNS, read_kept
from study.quantities import quantity
from study.tables import read_words
from study.texts import Texts

HEAD = "name\trelation\tpublished\ttolerance\tunit\tsource\tdescription\n"
WORDS = """
title = "Example"
lead = "A {{ of }} bag."
headline = "It bears {{ say('peak', kept=kept) }}."
remarks = ["Always.", "{% if judged %}Never, as this run is not judged.{% endif %}"]
[statements]
heading = "Statements"
table = "checklist"
[[reason]]
of = ["peak"]
why = "{{ say('peak') }} is what it is"
[figure.second]
sentence = "Drawn last, shown last."
[figure.first]
number = "Fig. 1"
sentence = "Load of a {{ of }} bag."
claim = "loads rise."
measures = ["peak"]
[[appendix]]
heading = "Causes"
text = "One."
tables = ["told", "causes"]
"""


class Compressed(Series):
    """A bag with a derived column, half of the load."""
    derived = {"half": ("kPa", "half of the load", lambda s: s["plate_pressure"] / 2)}


@pytest.fixture(name="folder")
def study_folder(tmp_path):
    folder = tmp_path / "example"
    (folder / "kept").mkdir(parents=True)
    (folder / "words.toml").write_text(WORDS)
    (folder / "expected.tsv").write_text(HEAD + "peak\twithin\t2\t0.5\tkPa\tthesis\tgreatest load\n")
    (folder / "statements.tsv").write_text(HEAD + "peak\tat least\t1\t\tkPa\tthesis\tit bears something\n")
    (folder / "checks.tsv").write_text(HEAD + "peak\tat most\t9\t\tkPa\tthis study\tit bears no more\n")
    (folder / "kept/comparison.tsv").write_text("description\tunit\tpublished\ttolerance\tmeasured\tdifference\tverdict\tsource\n"
                                                "greatest load\tkPa\t2\t± 0.5\t2.25\t+0.25 (+12.5 %)\tmet\tthesis\n")
    (folder / "kept/causes_thesis.tsv").write_text("bag\tload [kPa]\nsoft\t1\n")
    (tmp_path / "run.tsv").write_text("strain_axial [1]\tplate_pressure [Pa]\taxial_stress [Pa]\n0\t0\t0\n0.01\t2000\t1000\n0.02\t3000\t2000\n")
    return folder


def begun(folder, kept=False, judged=False):
    return Study.of(folder, types.SimpleNamespace(out=folder.parent, profile="quick", kept=kept), judged)


def built(folder, **how):
    study = begun(folder, **how)
    bag = Compressed(Table.read(folder.parent / "run.tsv"))
    study.measure_each([("peak", "kPa", lambda b: b["plate_pressure"].max())], lambda: [bag])
    if not study.pageless:
        study.tell(of="soft", told={"bag": ["stiff"]})
    runs = [Drawn("PE", bag, "red", note="full size"), Drawn("PE", bag, "red", "o", "record")]
    study.curves("second", panel("strain_axial", ("plate_pressure", "axial_stress"), runs[:1], "stress (kPa)"))
    study.curves("first", panel("strain_axial", "plate_pressure", runs), panel("plate_pressure", "half", runs, ylim=(0, None)))
    return study


def test_a_folder_says_all_that_a_page_has(folder, capsys):
    built(folder).write()
    page = (folder.parent / "page.html").read_text()
    for part in ("A soft bag.", "It bears 2.25\u00a0kPa.", "<p>Always.</p>", "Load of a soft bag.", "The thesis says: loads rise.", "it bears something",
                 "<td>stiff</td>", "Causes, full size:", "<td>soft</td>"):
        assert part in page
    assert "Never" not in page and page.index("Load of a soft bag.") > page.index("Drawn last")  # the order of words.toml
    assert sorted(path.name for path in folder.parent.glob("*.tsv")) == ["checklist.tsv", "comparison.tsv", "measured.tsv", "run.tsv"]
    assert "1 of 1 published values within tolerance at full size" in capsys.readouterr().out


def test_a_kept_run_has_tables_and_figures_and_no_page(folder):
    built(folder, kept=True).write_tables()
    assert (folder.parent / "first.svg").exists() and not (folder.parent / "page.html").exists()
    assert "\tnot judged\t" not in (folder.parent / "comparison.tsv").read_text()


def test_a_judged_run_has_its_reasons_and_remarks(folder):
    study = built(folder, judged=True)
    assert study.headline == "It bears 3.00\u00a0kPa." and len(study.remarks) == 2
    study.write()
    assert "3.00\u00a0kPa is what it is" in (folder.parent / "page.html").read_text()


@pytest.mark.parametrize(("was", "now", "message"), [
    ("lead =", "leed =", "words.toml: 'leed' is nothing that a page says; did you mean 'lead'"),
    ("claim =", "clame =", "words.toml: first: 'clame' is nothing that a page says; did you mean 'claim'"),
    ("why =", "wy =", "words.toml: reason: 'wy' is nothing"),
    ("why = \"{{ say('peak') }} is what it is\"", "", "words.toml: reason: has no why"),
    ("of = [\"peak\"]", "of = \"peak\"", "words.toml: reason: of is 'peak' where a list of texts belongs"),
    ("lead = \"A {{ of }} bag.\"", "lead = 1", "words.toml: lead is 1 where a text belongs"),
    ("sentence = \"Drawn last, shown last.\"", "", "words.toml: second: has no sentence"),
    ("[statements]", "expected = 1\n[statements]", "words.toml: expected: is 1 where a table belongs"),
    ("title = \"", "title = ", "words.toml: "),
    ("A {{ of }}", "A {{ off }}", r"words.toml: 'off' is undefined, in \"A {{ off }} bag.\""),
    ("A {{ of }}", "A {{ of ", "words.toml: .*in \"A {{ of"),
    ("say('peak')", "say('peek')", "peek: is said but not measured; did you mean 'peak'"),
    ("[figure.first]", "[figure.furst]", "words.toml: has no figure.first; did you mean 'furst'"),
    ("\"causes\"]", "\"cause\"]", "words.toml: there is no kept table cause"),
])
def test_words_that_no_page_has_are_refused(folder, was, now, message):
    (folder / "words.toml").write_text(WORDS.replace(was, now))
    with pytest.raises(StudyError, match=message):
        built(folder)
    pyplot.close("all")


def test_a_figure_without_a_sentence_waits_for_the_page_to_be_told(folder):
    study, run = begun(folder), Drawn("PE", Series(Table.read(folder.parent / "run.tsv")), "red")
    with pytest.raises(StudyError, match="first: is drawn before the page was told its numbers"):
        study.curves("first", panel("strain_axial", "plate_pressure", [run]))
    pyplot.close("all")


def test_three_lines_in_one_file_add_a_measure_a_statement_and_a_figure_to_a_chapter(folder):
    study, run = built(folder, judged=True), Drawn("PE", Series(Table.read(folder.parent / "run.tsv")), "red")
    study.measure("stress", 2, "kPa")
    study.state("stress", "within", 2.1, "kPa", "thesis", "stress in the soil", tolerance=0.2)
    study.figure("soil", curves.figure([panel("strain_axial", "axial_stress", [run])]), "Stress in the soil.", measures=["stress"])
    study.write()
    page = (folder.parent / "page.html").read_text()
    assert "stress in the soil: <b>2 kPa</b>; expected 2.1 ± 0.2 kPa" in page and page.index("Stress in the soil.") > page.index("Load of a soft")


def test_a_missing_words_file_is_named(folder):
    (folder / "words.toml").unlink()
    with pytest.raises(StudyError, match="words.toml: cannot be read"):
        begun(folder)


def test_a_measure_whose_run_is_not_made_says_why(folder):
    def absent():
        raise NotMade("not run")
    study = begun(folder)
    study.measure_each([("load", "kPa", lambda b: 1)], absent, "_PE")
    assert study.measures["load_PE"].value is None and study.measures["load_PE"].reason == "not run"


def test_panels_name_axes_and_curves_by_their_columns(folder):
    bag = Compressed(Table.read(folder.parent / "run.tsv"))
    runs = [Drawn("PE", bag, "red", "--", "full size"), Drawn("PE", bag, "blue", "o", "record")]
    drawn = curves.figure([panel("strain_axial", "half", runs), panel("strain_axial", ("plate_pressure", "half"), runs[:1], "load (kPa)", ylim=(0, 4)),
                           panel("half", "half", runs, legend=False)], columns=2)
    one, several, last = drawn.axes  # the fourth place is empty
    assert (one.get_xlabel(), one.get_ylabel()) == ("axial strain (%)", "half of the load (kPa)")
    assert [text.get_text() for text in one.get_legend().get_texts()] == ["PE, full size", "PE, record"]
    assert list(one.lines[0].get_xdata()) == [0, 1, 2] and list(one.lines[0].get_ydata()) == [0, 1, 1.5]
    assert one.lines[1].get_linestyle() == "None" and one.lines[0].get_color() == "red"
    assert several.get_ylabel() == "load (kPa)" and several.get_ylim() == (0, 4)
    assert [text.get_text() for text in several.get_legend().get_texts()] == ["plate pressure, full size", "half of the load, full size"]
    assert last.get_legend() is None
    drawn = curves.figure([panel("strain_axial", "plate_pressure", runs, legend=False, ylim=(1, 3), yscale="log")] * 2, columns=3)
    assert [text.get_text() for text in drawn.axes[2].get_legend().get_texts()] == ["PE, full size", "PE, record"]
    drawn.draw_without_rendering()
    assert {"1", "2", "3"} <= {text.get_text() for text in drawn.axes[0].get_yticklabels(which="both")}  # not 10⁰
    pyplot.close("all")


def test_columns_have_one_unit_and_an_unknown_one_is_asked_for_in_its_own(folder):
    series = Compressed(Table.read(folder.parent / "run.tsv"))
    assert list(series["strain_axial"]) == [0, 1, 2] and series.last("half") == 1.5 and len(series) == 3
    assert series.most("plate_pressure") == 2 and series.where("strain_axial", 0.5, "plate_pressure") == 1
    with pytest.raises(StudyError, match="run.tsv: strain_axial does not come to 3 from below"):
        series.where("strain_axial", 3, "plate_pressure")
    with pytest.raises(StudyError, match="run.tsv: has no column void_ratio"):
        series["void_ratio"]  # pylint: disable=pointless-statement
    with pytest.raises(StudyError, match="'strain_axal' has no unit of its own; .*did you mean 'strain_axial'"):
        quantity("strain_axal")


def test_means_over_packings_are_row_by_row_with_their_scatter(folder):
    (folder.parent / "other.tsv").write_text("strain_axial [1]\tplate_pressure [Pa]\n0\t0\n0.01\t4000\n0.02\t3000\n")
    mean = Mean([Table.read(folder.parent / f"{name}.tsv") for name in ("run", "other")])
    assert list(mean["plate_pressure"]) == [0, 3, 3] and mean.greatest("plate_pressure") == (3, pytest.approx(2**0.5))
    assert mean.at("strain_axial", 2, "plate_pressure") == (3, 0) and Mean.of([1, 3]) == (2, pytest.approx(2**0.5)) and Mean.of([1]) == (1, 0)
    with pytest.raises(StudyError, match="run.tsv: has no row where strain_axial is 1.5"):
        mean.at("strain_axial", 1.5, "plate_pressure")
    drawn = curves.figure([panel("strain_axial", "plate_pressure", [Drawn("", mean, "red", spread=mean.spread)])])
    low, high = drawn.axes[0].collections[0].get_paths()[0].get_extents().intervaly
    assert (low, high) == (0, pytest.approx(3 + 2**0.5))
    pyplot.close("all")
    (folder.parent / "short.tsv").write_text("strain_axial [1]\n0\n")
    with pytest.raises(StudyError, match="run.tsv: has another number of rows"):
        Mean([Table.read(folder.parent / f"{name}.tsv") for name in ("run", "short")])


def test_tables_of_a_folder_may_be_absent_for_a_reason(folder):
    assert len(Folder(folder.parent)("run")) == 3
    with pytest.raises(StudyError, match="none.tsv: cannot be read"):
        Folder(folder.parent)("none")
    with pytest.raises(NotMade, match="none: not kept"):
        Folder(folder.parent, "not kept")("none")


def test_cells_are_found_by_row_and_column(folder):
    cells = Cells(folder / "kept/causes_thesis.tsv", "bag")
    assert cells("soft", "load [kPa]") == 1
    for row, column, message in (("sofd", "bag", "has no 'sofd'; did you mean 'soft'"), ("soft", "lode", "has no 'lode'"),
                                 ("soft", "bag", "could not convert string to float")):
        with pytest.raises(StudyError, match=f"causes_thesis.tsv: .*{message}"):
            cells(row, column)


def comparisons():
    """Returns the paths of the kept comparisons of all chapters."""
    tables = pathlib.Path("pipelines").glob("ch*/kept/*.tsv")
    return sorted(path for path in tables if path.read_text(encoding="utf-8").startswith("\t".join(COLUMNS)))


def test_a_statement_that_a_kept_run_does_not_meet_has_a_reason():
    bare = []
    for table in comparisons():
        folder = table.parent.parent
        tables = [folder / f"{name}.tsv" for name in ("expected", "statements", "grains")]
        stated = [s for path in tables if path.exists() for s in read_statements(path)]
        given = {name for entry in Texts(folder / "words.toml").reasons for name in entry["of"]}
        bare += [f"{folder.name}: {s.name}" for s, verdict in read_kept(table, stated) if not verdict.met and s.name not in given]
    assert len(comparisons()) >= 5 and bare == []


def test_two_columns_of_one_name_are_refused(tmp_path):
    (tmp_path / "twice.tsv").write_text("bag\tload\t±\tstrain\t±\nsoft\t1\t2\t3\t4\n")
    with pytest.raises(StudyError, match="twice.tsv: line 1: two columns are named ±"):
        read_words(tmp_path / "twice.tsv")
    for path in pathlib.Path("pipelines").glob("*/kept/*.tsv"):
        assert read_words(path)[0]


def test_names_in_kept_tables_have_words_on_the_page(folder):
    (folder / "kept/causes_thesis.tsv").write_text("bag\tload of soft [kPa]\tsoft_wet [kPa]\nsoft\t1\tsofter\n")
    (folder / "words.toml").write_text(WORDS + '[names]\nsoft = "loose sand"\nsofter = "slack"\n'
                                       '[table.causes]\ncaption = "Why it differs"\nnames = { soft_wet = "wet sand" }\n')
    built(folder).write()
    page = (folder.parent / "page.html").read_text()
    for part in ("<p>Why it differs, full size:</p>", "<th>load of loose sand [kPa]</th><th>wet sand [kPa]</th>",
                 "<td>loose sand</td><td>1</td><td>slack</td>"):
        assert part in page
    (folder / "words.toml").write_text(WORDS + "[names]\nsoft = 1\n")
    with pytest.raises(StudyError, match="words.toml: names is {'soft': 1} where a table of texts belongs"):
        built(folder)
    (folder / "words.toml").write_text(WORDS + 'table = "causes"\n')
    with pytest.raises(StudyError, match="words.toml: appendix: 'table' is nothing that a page says"):
        built(folder)
    pyplot.close("all")
