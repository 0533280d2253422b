"""Files of chapters 3 to 5 at the thesis's own size: their steps, and how far each is in a folder of results."""
# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses
import pathlib
import re

from study import StudyError, Table
from study.tables import read_words

HERE = pathlib.Path(__file__).parent
COLUMNS = ("chapter", "product", "bodies", "links", "steps", "megabytes", "basis")


@dataclasses.dataclass(frozen=True)
class Product:
    """A file CHAPTER/NAME.h5. bodies, links: numbers of them in each step. steps: of the whole run. basis: source of the steps."""

    chapter: str
    name: str
    bodies: int
    links: int
    steps: int
    megabytes: int
    basis: str

    def file(self, out):
        """Returns the path of its file in a folder of results."""
        return pathlib.Path(out) / self.chapter / f"{self.name}.h5"

    def states(self, out):
        """Returns (step, time of writing in s) of each state that a run under way has recorded, in order."""
        part = self.file(out).with_name(f"{self.name}.h5.part")
        found = [(int(match[1]), path.stat().st_mtime) for path in part.glob("state-*.h5") if (match := re.search(r"state-(\d+)\.h5$", path.name))]
        return sorted(found)

    def left(self, out):
        """Returns the steps that are left: none of a file that exists, all of one that has not begun."""
        if self.file(out).exists():
            return 0
        states = self.states(out)
        return max(0, self.steps - states[-1][0]) if states else self.steps


def _kept_steps(chapter, name, pipelines):
    """Returns the last step of a kept table, or None where there is none with steps."""
    path = pipelines / chapter / "kept" / f"{name}.tsv"
    if not path.exists():
        return None
    table = Table.read(path)
    return int(table("step", "1")[-1]) if table.has("step") and len(table) else None


def read(path=HERE / "products.tsv", pipelines=HERE.parent):
    """Returns the Products of a table, with the steps of kept runs. Raises StudyError for a row without whole numbers above 0."""
    products = []
    for line, row in read_words(path, COLUMNS)[1]:
        try:
            numbers = [int(row[name]) for name in COLUMNS[2:6]]
        except ValueError as error:
            raise StudyError(f"{path}: line {line}: {error}; write whole numbers") from error
        if min(numbers) <= 0:
            raise StudyError(f"{path}: line {line}: a number is not above 0")
        kept = _kept_steps(row["chapter"], row["product"], pipelines)
        products.append(Product(row["chapter"], row["product"], numbers[0], numbers[1], kept or numbers[2], numbers[3],
                                "measured" if kept else row["basis"]))
    return products
