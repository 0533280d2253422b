"""A study's section of the report, from its template."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib
import re

import jinja2

_TEMPLATES = pathlib.Path(__file__).parent / "templates"


def inline(svg, prefix):
    """Returns SVG as it stands inside a page: without its prologue, and with identifiers of its own figure alone."""
    svg = svg[svg.index("<svg"):]
    svg = re.sub(r'\bid="([^"]*)"', rf'id="{prefix}_\1"', svg)
    svg = re.sub(r'href="#([^"]*)"', rf'href="#{prefix}_\1"', svg)
    return re.sub(r"url\(#([^)]*)\)", rf"url(#{prefix}_\1)", svg)


def render(template, **values):
    """Returns the page. Text is escaped; what is markup already is passed as markupsafe.Markup by the caller."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(_TEMPLATES), autoescape=True, trim_blocks=True,
                                     lstrip_blocks=True, undefined=jinja2.StrictUndefined, keep_trailing_newline=True)
    return environment.get_template(template).render(**values)
