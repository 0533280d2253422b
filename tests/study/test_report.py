"""The report of all studies: cards, chapters, and HTML that holds together without anything outside of it."""
# SPDX-License-Identifier: GPL-3.0-or-later
import html.parser
import subprocess
import sys

import pytest
from study import Study, StudyError, figures, report

VOID = {"meta", "img", "br", "hr", "link", "input", "col"}


class Structure(html.parser.HTMLParser):
    """Notes identifiers, references and tags that are not closed in their order."""

    def __init__(self, text):
        super().__init__()
        self.ids, self.links, self.open, self.faults = [], [], [], []
        self.feed(text)
        self.close()
        self.faults += [f"<{tag}> is never closed" for tag in self.open]

    def handle_starttag(self, tag, attrs):
        self._note(attrs)
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self._note(attrs)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append(f"</{tag}> closes nothing")

    def _note(self, attrs):
        names = [name for name, _ in attrs]
        if len(set(names)) < len(names):
            self.faults.append(f"an attribute is there twice: {names}")
        for name, value in attrs:
            if name == "id":
                self.ids.append(value)
            if name in ("href", "src", "xlink:href"):
                self.links.append(value)


def write_study(folder, name):
    folder.mkdir()
    study = Study(name, f"Study {name} & others", folder, "quick")
    study.lead, study.headline = "A test.", "One of two < three."
    study.measure("peak", 2, "kPa")
    study.state("peak", "within", 2, "kPa", "thesis", "greatest stress", tolerance=0.5)
    study.state("peak", "at most", 1, "kPa", "thesis", "small stress")
    for key in ("stress", "again"):
        figure, axes = figures.panels(2)
        for a in axes:
            a.plot([0, 1], [0, 2], label="run")
            a.legend()
            figures.label(a, "strain (%)", "stress (kPa)")
        study.figure(key, figure, "Stress “rises” & falls.", "Fig. 1", "so it is.", ["peak"])
    study.appendix("Causes", {"bag": ["soft"], "stress [kPa]": [1]})
    study.write()


@pytest.fixture(name="out", scope="module")
def results(tmp_path_factory):
    folder = tmp_path_factory.mktemp("out")
    (folder / "profile").write_text("quick\n")
    for name in ("first", "second"):
        write_study(folder / name, name)
    return folder


def fault(page):
    """Returns the faults of a page; nothing for a sound page."""
    structure = Structure(page.read_text(encoding="utf-8"))
    twice = sorted({i for i in structure.ids if structure.ids.count(i) > 1})
    outside = [link for link in structure.links if not link.startswith(("#", "data:")) and link != "../report.html"]
    broken = [link for link in structure.links if link.startswith("#") and link[1:] not in structure.ids]
    return structure.faults + twice + outside + broken


def test_report_and_chapters_are_sound_and_whole_in_themselves(out):
    report.write(out, ["second", "first"])
    for page in (out / "report.html", out / "first/page.html", out / "second/page.html"):
        assert fault(page) == []
    text = (out / "report.html").read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>") and text.index('id="second"') < text.index('id="first"')
    assert text.count('class="card"') == 2 and text.count("1 of 2 published values within tolerance") == 4
    assert "Study first &amp; others" in text and "One of two &lt; three." in text


def test_the_check_itself_finds_what_is_wrong(tmp_path):
    (tmp_path / "page.html").write_text('<p id="a"><b></p><img src="http://example.org/x.png"><a id="a" href="#none"></a>')
    assert len(fault(tmp_path / "page.html")) >= 4


def test_the_front_page_says_how_long_the_run_took(out):
    report.write(out, ["first"])
    assert "The last make reproduce" not in (out / "report.html").read_text()
    (out / "took").write_text("1012 2 0\n")
    report.write(out, ["first"])
    assert "The last make reproduce took 16 min 52 s for the studies on 2 cores. Profile" in (out / "report.html").read_text()
    (out / "took").write_text("12 2 6\n")
    report.write(out, ["first"])
    assert "took 0 min 12 s for the studies on 2 cores. Pages that existed before were kept." in (out / "report.html").read_text()


def test_a_study_without_its_page_is_named(out):
    with pytest.raises(StudyError, match=r"none/page\.html: cannot be read"):
        report.write(out, ["none"])
    run = subprocess.run([sys.executable, "-P", "-m", "study.report", out, "none"], capture_output=True, text=True, check=False)
    assert run.returncode == 65 and run.stderr.startswith("report: ") and run.stderr.count("\n") == 1
