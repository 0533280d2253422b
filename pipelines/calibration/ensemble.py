"""Runs every row of an ensemble's table, one row one job one folder; ensemble.sh tells how it is called.

Stopped at any point, it goes on with the rows that are missing. Rows whose parameters always fail are listed and not repeated. Rows with
any other error are tried again, then reported. study/jobs.py runs the rows at once.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses
import hashlib
import os
import pathlib
import re
import shutil
import sys

from study import jobs
from study.command import Failure

HERE = pathlib.Path(__file__).parent
RUN = str(HERE / "run.sh")
# Contact parameters in the order of run.sh's arguments: name in pf-weight, name in the author's tables, unit.
PARAMETERS = (("young_modulus", "E", "Pa"), ("poisson_ratio", "nu", "1"), ("rolling_stiffness", "kr", "1"), ("rolling_limit", "eta", "1"),
              ("friction_angle", "mu", "deg"))
LAWS = {"hm": "Hertz-Mindlin", "cl": "linear"}
LISTED = 10  # the most failed rows that are printed one by one


def read_rows(path):
    """Returns the rows of a table as text: id without leading zeros, the five parameters, the number of the twin (0 by default).

    The table has a header of names, id first. Comments and empty lines are skipped. Parameters and twin are found by their
    names, and other columns are ignored. Raises Failure for a row without a whole id, a parameter that is missing or in
    another unit, and a table without rows.
    """
    try:
        text = pathlib.Path(path).read_bytes().decode("utf-8-sig", errors="surrogateescape")
    except OSError as error:
        raise Failure(66, f"rows: {path}: cannot be read: {error.strerror}") from error
    header, places, rows, number = None, [], {}, 1

    def fail(words):
        raise Failure(65, f"rows: {path}: line {number}: {words}")

    for number, line in enumerate(re.split("\r\n|\n|\r", text), start=1):
        cells = line.split("\t")
        if line.startswith("#") or not line.strip(" \t"):
            continue
        if header is None:
            header = [re.sub(r" ?\[.*", "", cell) for cell in cells]
            if cells[0] not in ("id", "id [1]"):
                fail(f'the first column is "{cells[0]}" where id belongs; columns are separated by tabs')
            for long, short, unit in PARAMETERS:
                found = [k for k, name in enumerate(header) if name in (long, short)]
                if len(found) != 1:
                    fail(f"{len(found)} columns named {short} or {long} where one belongs; columns are separated by tabs")
                given = re.search(r"\[(.*)\]", cells[found[0]])
                if given and given[1] != unit:
                    fail(f"{header[found[0]]} is in {given[1]}: give it in {unit}")
                places += found
            continue
        if len(cells) != len(header):
            fail(f"{len(cells)} values where the header names {len(header)} columns, separated by tabs")
        if not re.fullmatch("[0-9]+", cells[0]):
            fail(f'id "{cells[0]}" is no whole number')
        name = cells[0].lstrip("0") or "0"
        if name in rows:
            fail(f"id {name} is there twice")
        for k, cell in enumerate(cells[1:], start=2):
            if not cell.strip() or "," in cell:
                fail(f'"{cell}" in column {k} is no number; write it with a decimal point')
        twin = dict(zip(header, cells, strict=True)).get("twin", "0")
        rows[name] = [name, *(cells[k].strip() for k in places), twin.strip()]
    if header is None:
        fail("no header line that begins with id")
    if not rows:
        raise Failure(65, f"rows: {path}: no rows below the header")
    return list(rows.values())


@dataclasses.dataclass
class Ensemble:
    """The rows of a table and the folder of their runs. common: the arguments of run.sh before those of a row."""

    name: str
    folder: pathlib.Path
    common: list
    rows: list

    def of_row(self, row, name):
        """Returns the path of a file in the folder of a row."""
        return self.folder / "runs" / f"{int(row[0]):06d}" / name

    def unfinished(self):
        """Returns the rows that have neither result nor failure with these parameters."""
        _, law, _, _, pressure, strain = self.common

        def finished(row):
            parameters = self.of_row(row, "parameters")
            if not parameters.exists() or not (self.of_row(row, "series.h5").exists() or self.of_row(row, "failed").exists()):
                return False
            return parameters.read_text(errors="replace").rstrip("\n") == " ".join([law, pressure, strain, *row[1:]])
        return [row for row in self.rows if not finished(row)]

    def failed(self):
        """Returns the rows whose parameters always fail."""
        return [row for row in self.rows if self.of_row(row, "failed").exists()]

    def progress(self, before, seconds):
        """Returns a line of progress: rows done and failed, time left, runs per hour. before: rows done at the start."""
        done = len(self.rows) - len(self.unfinished())
        line = f"  {self.folder.name}: {done} of {len(self.rows)} runs, {len(self.failed())} failed"
        if done > before:
            left = seconds * (len(self.rows) - done) / (done - before)
            words = f"{left:.0f} s" if left < 90 else f"{left / 60:.0f} min" if left < 5400 else f"{left / 3600:.1f} h"
            line += f", {words} left, {3600 * (done - before) / max(seconds, 1):.0f} runs/h"
        return line

    def tell_failed(self):
        """Prints the rows that failed with their reasons, the first few of them."""
        failed = self.failed()
        if failed:
            print(f"  {self.folder} {self.name}: rows that failed, with the reason:")
        for row in failed[:LISTED]:
            print(f"    {row[0]}: {self.of_row(row, 'failed').read_text(errors='replace').partition(chr(10))[0]}")
        if len(failed) > LISTED:
            print(f"    and {len(failed) - LISTED} more (FOLDER/runs/*/failed)")


def keep_results_of(folder, inputs):
    """Removes the results in a folder unless they come from these inputs, programs and scenario."""
    digest = hashlib.sha256()
    for path in inputs:
        try:
            digest.update(pathlib.Path(path).read_bytes())
        except OSError as error:
            raise Failure(66, f"ensemble: {path}: cannot be read: {error.strerror}") from error
    key = folder / "key"
    if not (key.exists() and key.read_text().strip() == digest.hexdigest()):
        shutil.rmtree(folder / "runs", ignore_errors=True)
        (folder / "runs").mkdir()
        key.write_text(digest.hexdigest() + "\n")


def main(table, folder, law, packing, scenario, pressure, strain):
    """Runs the rows of the table that have no result yet; raises Failure where some did not finish."""
    if law not in LAWS:
        raise Failure(64, f'ensemble: "{law}" is no law; give ' + " or ".join(f"{key} ({words})" for key, words in LAWS.items()))
    for what, word in (("PRESSURE_MPa", pressure), ("STRAIN_%", strain)):
        if not re.fullmatch(r"\d+\.?\d*|\.\d+", word, re.ASCII):
            raise Failure(64, f'ensemble: {what}: "{word}" is no number; write it with digits and a decimal point')
    # A path that begins with a dash would be read as an option.
    folder, packing, scenario = (f"./{path}" if path.startswith("-") else path for path in (folder, packing, scenario))
    name, home, programs = pathlib.Path(table).stem, pathlib.Path(folder), pathlib.Path(os.environ["BIN"])
    (home / "runs").mkdir(parents=True, exist_ok=True)
    ensemble, speed = Ensemble(name, home, [folder, law, packing, scenario, pressure, strain], read_rows(table)), ""
    lock = jobs.one_at_a_time(home)
    try:
        keep_results_of(home, [packing, scenario, RUN, programs / "run-dem", programs / "homogenize"])
        left = ensemble.unfinished()
        if left:
            print(f"  run   {home} {name}: {len(left)} of {len(ensemble.rows)} rows", flush=True)
            speed = jobs.run(home, name, [[RUN, *ensemble.common, *row] for row in left], lock,
                             lambda seconds: ensemble.progress(len(ensemble.rows) - len(left), seconds))
    finally:
        os.close(lock)
    ensemble.tell_failed()
    print(f"  {home} {name}: {len(ensemble.rows)} runs, {len(ensemble.failed())} failed{speed}", flush=True)
    missing = len(ensemble.unfinished())
    if missing:
        raise Failure(1, f"{home}: {missing} rows did not finish (see {home / name}.joblog); make again tries them")


if __name__ == "__main__":
    try:
        if len(sys.argv) != 8 or "BIN" not in os.environ:
            raise Failure(64, "ensemble: usage: BIN=build/bin ensemble.sh TABLE.tsv FOLDER LAW PACKING SCENARIO PRESSURE_MPa STRAIN_%")
        main(*sys.argv[1:])
    except Failure as error:
        print(error, file=sys.stderr)
        sys.exit(error.status)
    except KeyboardInterrupt:
        sys.exit(130)
