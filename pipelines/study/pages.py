"""Pages of the report, from their templates: markup of figures, pictures and tables."""
# SPDX-License-Identifier: GPL-3.0-or-later
import base64
import html
import pathlib
import re

import jinja2
from markupsafe import Markup

from .errors import StudyError
from .tables import read_words
from .words import plain

_ENVIRONMENT = jinja2.Environment(loader=jinja2.FileSystemLoader(pathlib.Path(__file__).parent / "templates"), autoescape=True,
                                  trim_blocks=True, lstrip_blocks=True, undefined=jinja2.StrictUndefined, keep_trailing_newline=True)
_ENVIRONMENT.filters["plain"] = plain
_COORDINATES = re.compile(r' (?:d|x|y|transform|viewBox)="[^"]*"')


def inline(svg, prefix, words=""):
    """Returns an SVG for use inside a page: without prologue, size and style sheet, and with unique identifiers.

    prefix: comes before each identifier. words: alternative text for readers who cannot see the figure.
    """
    svg = svg[svg.index("<svg"):]
    svg = re.sub(r"<metadata>.*?</metadata>|<style[^>]*>.*?</style>", "", svg, flags=re.DOTALL)
    # Drops identifiers that nothing refers to, which are most of them. Fonts are the page's own.
    used = set(re.findall(r"#([^\"')]+)", svg))
    svg = re.sub(r' id="([^"]*)"', lambda match: f' id="{prefix}_{match[1]}"' if match[1] in used else "", svg)
    svg = re.sub(r"'DejaVu Sans'[^;\"]*", "sans-serif", svg)
    svg = re.sub(r'href="#([^"]*)"', rf'href="#{prefix}_\1"', svg)
    svg = re.sub(r"url\(#([^)]*)\)", rf"url(#{prefix}_\1)", svg)
    svg = re.sub(r' transform="rotate\(-0 [^"]*"|(?<=\n) +', "", svg)
    # A hundredth of a point is finer than any screen.
    svg = _COORDINATES.sub(lambda match: re.sub(r"(\.\d\d)\d+", r"\1", match[0]), svg)
    head, rest = svg.split(">", 1)
    head = re.sub(r' (?:width|height|version|xmlns(?::\w+)?)="[^"]*"', "", head)
    name = f' role="img" aria-label="{html.escape(words)}"' if words else ' aria-hidden="true"'
    return Markup(head + ' xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"' + name + ">" + rest)


def pane(svg, prefix, words):
    """Returns an SVG in a box with its natural width, so that panels stand side by side as in the figure."""
    width = float(re.search(r'viewBox="0 0 ([\d.]+)', svg)[1])
    return Markup(f'<div class="pane" style="--w:{width:.0f}">{inline(svg, prefix, words)}</div>')


def picture(path, words):
    """Returns a PNG or JPEG file as an image embedded in the page."""
    path = pathlib.Path(path)
    kind = {".png": "png", ".jpg": "jpeg", ".jpeg": "jpeg"}.get(path.suffix)
    if kind is None:
        raise StudyError(f"{path}: is neither .png nor .jpg")
    try:
        data = base64.b64encode(path.read_bytes()).decode()
    except OSError as error:
        raise StudyError(f"{path}: cannot be read: {error.strerror}") from error
    return Markup(f'<img alt="{html.escape(words)}" src="data:image/{kind};base64,{data}" />')


def table(path, names=None):
    """Returns a table (.tsv) as markup.

    names: words that readers see for names in the table, by name. They replace names in heads, and cells that are a name.
    """
    header, rows = read_words(path)
    names = names or {}
    if names:
        known = re.compile(r"\b(" + "|".join(map(re.escape, sorted(names, key=len, reverse=True))) + r")\b")
        header = [known.sub(lambda match: names[match[0]], head) for head in header]
    return render("table.html", header=header, rows=[[names.get(cell, cell) for cell in row.values()] for _, row in rows])


def content(item):
    """Returns what a page shows of an item: paragraphs of text, markup as it is, a table (.tsv) or a report (other files)."""
    if isinstance(item, Markup):
        return item
    if isinstance(item, pathlib.PurePath) and item.suffix == ".tsv":
        return table(item)
    if isinstance(item, pathlib.PurePath):
        try:
            return Markup("<pre>{}</pre>").format(item.read_text(encoding="utf-8").rstrip())
        except OSError as error:
            raise StudyError(f"{item}: cannot be read: {error.strerror}") from error
    if isinstance(item, dict):
        return render("table.html", header=list(item), rows=[list(row) for row in zip(*item.values(), strict=True)])
    return Markup("\n").join(Markup("<p>{}</p>").format(part) for part in str(item).split("\n\n"))


def render(template, **values):
    """Returns the page. Text is escaped; what is markup already is passed as markupsafe.Markup by the caller."""
    return Markup(_ENVIRONMENT.get_template(template).render(**values))
