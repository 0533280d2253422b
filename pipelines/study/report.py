"""The report of all studies as one self-contained page: a card for each on the front, then their chapters."""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import json
import pathlib
import sys

from markupsafe import Markup

from . import pages
from .errors import StudyError
from .files import put


def chapter(folder):
    """Returns the card of a study, a dictionary, with its chapter as markup: card.json and what page.html has in <main>."""
    try:
        page = (folder / "page.html").read_text(encoding="utf-8")
        card = json.loads((folder / "card.json").read_text(encoding="utf-8"))
    except OSError as error:
        raise StudyError(f"{error.filename}: cannot be read: {error.strerror}") from error
    body = Markup(page[page.index("<main>") + len("<main>"):page.rindex("</main>")])
    return card | {"name": folder.name, "headline": Markup(card["headline"]), "figure": Markup(card["figure"]), "body": body}


def duration(path):
    """Returns what the file `took` of make reproduce says, in a sentence; nothing where there is no such file.

    Its one line holds seconds, cores, and how many studies had their pages before, with spaces between them.
    """
    if not path.exists():
        return ""
    seconds, cores, before = (int(word) for word in path.read_text(encoding="utf-8").split())
    time = f"{seconds // 60} min {seconds % 60} s"
    kept = " Pages that existed before were kept." if before else ""
    return f"The last make reproduce took {time} for the studies on {cores} cores.{kept}"


def write(out, names, picture=None):
    """Writes out/report.html of the studies named, in their order. picture: of the front page, if any."""
    out = pathlib.Path(out)
    profile = (out / "profile").read_text(encoding="utf-8").strip()
    text = pages.render("report.html", title="Soilweave: the studies", profile=profile, took=duration(out / "took"),
                        chapters=[chapter(out / name) for name in names],
                        picture=pages.picture(picture, "A bag of woven geotextile full of sand under compression") if picture else "")
    put(out / "report.html", text)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", help="folder of the results of all studies")
    parser.add_argument("names", nargs="+", help="studies, in the order of the report")
    parser.add_argument("--picture", help="of the front page")
    try:
        write(**vars(parser.parse_args()))
    except (StudyError, OSError) as error_:
        print(f"report: {error_}", file=sys.stderr)
        sys.exit(65)
