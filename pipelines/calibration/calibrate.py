"""Calibrates contact parameters to one or several drained triaxial tests together: draws, runs, assimilates and resamples.

Rounds end when the effective sample size is reached or the rounds are spent. FOLDER then holds posterior.h5, posterior.txt,
parameters.tsv, predicted_TEST.tsv (curves of the posterior beside each test), predicted.svg and posterior.svg. A calibration that was
stopped goes on when it is called again: finished runs are kept.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys

from study import StudyError, Table
from study.command import Failure
from study.errors import suggestion
from study.files import put

from . import ensemble, plausible, predicted, prior, rate
from .laboratory import KINDS, OF_A_RUN, PEAK, Test, as_it_stands, curve, distinct_names, greatest, observed, pressure

HERE = pathlib.Path(__file__).parent
SCENARIOS = {"hm": HERE / "hertz-mindlin.toml", "cl": HERE / "linear.toml"}


class Parser(argparse.ArgumentParser):
    """A parser whose errors are one line with status 64."""

    def error(self, message):
        raise Failure(64, f"calibrate: {message}; --help tells the options")


def _share(text):
    """Returns as a fraction a share that is written as a number or in per cent."""
    return float(text.strip().removesuffix("%")) / (100 if text.strip().endswith("%") else 1)


def _errors(text):
    """Returns a relative error, or errors by observable, of "0.05", "5 %" or "stress_ratio=0.15,strain_volumetric=0.3"."""
    try:
        pairs = [part.split("=") for part in text.split(",")]
        sizes = _share(text) if "=" not in text else {name: float(value) for name, value in pairs}
        if "=" in text and len(sizes) < len(pairs):
            raise argparse.ArgumentTypeError(f'"{text}": a name is there twice; leave one of them out')
    except ValueError as error:
        raise argparse.ArgumentTypeError(f'"{text}": write a share, as 0.05 or 5 %, or NAME=NUMBER,NAME=NUMBER') from error
    if not all(0 < size < math.inf for size in (sizes.values() if isinstance(sizes, dict) else [sizes])):
        raise argparse.ArgumentTypeError(f'"{text}": errors are numbers above 0')
    if isinstance(sizes, float) and sizes > 1:
        raise argparse.ArgumentTypeError(f'"{text}": a share is at most 1; write 5 per cent as 0.05 or 5 %')
    return sizes


def _number(least, unit="", above=False):
    """Returns a function that reads a number of at least `least`, or above it. The unit may be written behind the number."""
    def read(text):
        try:
            value = float(text.removesuffix(unit))
        except ValueError:
            value = math.nan
        if not least <= value < math.inf or (above and value == least):
            raise argparse.ArgumentTypeError(f'"{text}": give a number {"above" if above else "of at least"} {least}{f" in {unit}" if unit else ""}')
        return value
    return read


def _whole(least):
    """Returns a function that reads a whole number of at least `least`."""
    def read(text):
        if not re.fullmatch("[0-9]+", text) or int(text) < least:
            raise argparse.ArgumentTypeError(f'"{text}": give a whole number of at least {least}')
        return int(text)
    return read


def _strains(text):
    """Returns the strains (%) of a list such as "0.2,1" as they are written."""
    found = text.split(",")
    for one in found:
        _number(0)(one)
    return found


def parse(words):
    """Returns the options of a command line. Raises Failure for wrong ones."""
    p = Parser(prog="calibrate.sh", description=__doc__.replace("\n\n", " "), allow_abbrev=False)
    p.add_argument("folder", type=pathlib.Path, metavar="FOLDER")
    p.add_argument("--prior", required=True, help="ranges of the parameters, a TOML as pf-weight draw takes it")
    p.add_argument("--test", required=True, nargs="+", action="append", metavar="TABLE PRESSURE KIND [PACKING]",
                   help=f"a test, again for each: table, confining pressure (\"100 kPa\"), strains ({', '.join(KINDS)}: one row with "
                   f"{PEAK} instead of a curve), packing if it has its own")
    p.add_argument("--predict", nargs="+", action="append", default=[], metavar="TABLE PRESSURE KIND [PACKING]",
                   help="a test that is predicted and not weighed, again for each")
    p.add_argument("--packing", default="", help="packing of tests that name none")
    p.add_argument("--law", choices=tuple(SCENARIOS), default="hm", help="Hertz-Mindlin or linear contacts")
    p.add_argument("--scenario", type=pathlib.Path, help="isotropic and triaxial stage; else that of the law beside this file")
    p.add_argument("--until", type=_number(0, "%", above=True), default=6, metavar="%", help="axial strain up to which runs go and are compared [6]")
    p.add_argument("--stations", type=_whole(0), default=12, metavar="N", help="compared rows of each test; 0: all, as they are [12]")
    p.add_argument("--error", type=_errors, help="standard deviations of the tests, NAME=S,..., or a share of the greatest value [0.05]")
    p.add_argument("--variance", type=_errors, help="variances instead, NAME=V,...")
    p.add_argument("--samples", type=lambda text: [_whole(1)(n) for n in text.split(",")], default=[40], metavar="N[,N...]",
                   help="sets of each round, the last number for all later ones [40]")
    p.add_argument("--rounds", type=_whole(1), default=5, metavar="N", help="most rounds [5]")
    p.add_argument("--effective-size", type=_number(0), default=12, metavar="X", help="sample size that ends the rounds; 0: all are made [12]")
    p.add_argument("--rate", default="scenario", help="1/s of the loading; try: the fastest that the response no longer depends on")
    p.add_argument("--bases", default="", help="of the first round's Halton sequence")
    p.add_argument("--at", type=_strains, default=[], metavar="%,%...", help="strains at which densities are also given")
    given = p.parse_args(words)
    if given.error is not None and given.variance is not None:
        p.error("--error and --variance both say how exact the tests are: give one of them")
    if isinstance(given.variance, float):
        p.error("--variance: write NAME=NUMBER,NAME=NUMBER; a share is an --error")
    if given.rate not in ("scenario", "try") and not (re.fullmatch(r"\d+\.?\d*(e-?\d+)?|\.\d+", given.rate) and float(given.rate) > 0):
        p.error(f'--rate "{given.rate}": write a number in 1/s above 0, or try')
    given.error = given.error if given.error is not None or given.variance else 0.05
    given.tests = [_test(p, one, given.packing) for one in given.test]
    given.predictions = [_test(p, one, given.packing) for one in given.predict]
    given.scenario = given.scenario or SCENARIOS[given.law]
    return given


def _test(parser, words, packing):
    if len(words) not in (3, 4) or words[2] not in KINDS:
        parser.error(f'--test {" ".join(words)}: write TABLE PRESSURE KIND [PACKING], KIND one of {", ".join(KINDS)}')
    if len(words) == 3 and not packing:
        parser.error(f"--test {words[0]}: has no packing; name one at its end, or give --packing")
    test = Test(pathlib.Path(words[0]), pressure(words[1]), words[2], words[3] if len(words) == 4 else packing)
    for path in (test.table, test.packing):
        if not pathlib.Path(path).exists():
            raise Failure(66, f"calibrate: {path}: is not there")
    return test


class Calibration:
    """A calibration and its files: the compared values of each test, the runs of each round, and their weights."""

    def __init__(self, given):
        self.given, self.folder, self.tests = given, given.folder, given.tests
        distinct_names(self.tests + given.predictions)
        prior.read(given.prior)
        self.observed, self.until, self.said = {}, {}, []
        curves = {test.name: curve(test) for test in self.tests + given.predictions if test.kind != "greatest"}
        plausible.distinct(list(curves.values()))
        self.said += [f"doubt: {line}" for one in curves.values() for line in plausible.doubts(one)]
        self.said += [f"doubt: {line}" for line in plausible.compared(list(curves.values()))]
        self.folder.mkdir(parents=True, exist_ok=True)
        for test in self.tests + given.predictions:
            self._prepare(test, curves.get(test.name))
        self._check_errors()
        # Removes an earlier posterior. Status 1 may be an error, and callers then look whether a posterior was written.
        predicted.clear(self.folder)
        for line in self.said:
            print(f"calibrate: {line}", file=sys.stderr, flush=True)
        self.scenario = given.scenario
        self.rate_words = rate.chosen(self)

    def _prepare(self, test, found):
        """Writes the compared values of a test into TEST.tsv. With --stations 0 a table that the filter can read is used as it is."""
        self.observed[test.name], self.until[test.name] = test.table, f"{self.given.until:g}"
        if test.kind == "greatest":
            # The filter takes the first column for the station. The pressure goes there, whatever column the table begins with.
            self._write(test, {"confining_pressure [kPa]": [test.pressure / 1e3], f"{PEAK} [1]": [greatest(test)]})
            return
        if self.given.stations == 0 and as_it_stands(found, self.observables(test)):
            return
        columns = observed(found, self.given.until, self.given.stations, self.observables(test))
        self._write(test, columns)
        # The run goes on to the next 0.1 % of strain beyond the last compared row, so that nothing is extrapolated.
        self.until[test.name] = f"{(int(10 * columns['strain_axial [%]'][-1]) + 1) / 10:g}"

    def _write(self, test, columns):
        """Writes columns of compared values into TEST.tsv."""
        self.observed[test.name] = self.folder / f"{test.name}.tsv"
        rows = zip(*columns.values(), strict=True)
        put(self.observed[test.name], "\n".join(["\t".join(columns), *("\t".join(f"{x:.9g}" for x in row) for row in rows)]) + "\n")

    def observables(self, test):
        """Returns the names of the quantities that a test is compared by: those given an error by name, or else the default ones."""
        sizes, single = self.given.variance or self.given.error, test.kind == "greatest"
        if isinstance(sizes, dict):
            return [name for name in sizes if (name == PEAK) == single]
        return [PEAK] if single else ["stress_ratio", "strain_volumetric"]

    def _check_errors(self):
        """Raises Failure for an error of a quantity that a test does not have, and for a test without any error."""
        sizes, tests = self.given.variance or self.given.error, self.tests + self.given.predictions
        for test in tests:
            names = self.observables(test)
            if not names:
                wanted = PEAK if test.kind == "greatest" else "stress_ratio"
                raise Failure(64, f"calibrate: {test.table}: no error is given for what it observes; name {wanted}")
            table = Table.read(self.observed[test.name])
            for name in names:
                if not table.has(name):
                    raise Failure(64, f"calibrate: an error is given for {name}, which {test.table} does not tell{suggestion(name, table.names)}")
        for name in sizes if isinstance(sizes, dict) else []:
            if not any(name in self.observables(test) for test in tests):
                raise Failure(64, f"calibrate: an error is given for {name}, which no test tells; leave it out")

    def filter(self, *words, output=None, fails=()):
        """Runs pf-weight; what it prints goes to the file `output`. Raises Failure unless its status is 0 or one of `fails`."""
        command = [f"{os.environ['BIN']}/pf-weight", *map(str, words)]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        if done.returncode not in (0, *fails):
            raise Failure(done.returncode, done.stderr.strip())
        if output:
            put(output, done.stdout)
        return done

    def run(self, sets, test, folder=None):
        """Runs the rows of a table of sets through a test, in FOLDER/TEST or the folder given."""
        ensemble.main(str(sets), str(folder or self.folder / test.name), self.given.law, str(test.packing), str(self.scenario),
                      test.megapascals, self.until[test.name])

    def comparison(self, test, folder=None):
        """Returns the options of pf-weight that compare runs with a test."""
        sizes, names = self.given.variance or self.given.error, self.observables(test)
        words = [self.observed[test.name], "--runs", f"{folder or self.folder / test.name}/runs/{{id:06}}/series.h5", "--where", "stage=1"]
        words += ["--greatest"] if test.kind == "greatest" else ["--station", "strain_axial", "--until", f"{self.given.until:g}"]
        words += [word for name in names for word in ("--observe", f"{name}={OF_A_RUN[name]}" if name in OF_A_RUN else name)]
        if isinstance(sizes, dict):
            words += ["--covariance", "component", "--variance" if self.given.variance else "--error", ",".join(f"{sizes[n]!r}" for n in names)]
        else:
            words += ["--covariance", "largest", "--error", repr(sizes)]
        return words + [word for at in self.given.at if test.kind != "greatest" for word in ("--at", at)]

    def assimilate(self, name):
        """Weighs the sets of a round by all tests, one after the other, into NAME_posterior.h5; returns the effective sample size.

        Also writes the tables after the last test, NAME_steps.tsv, NAME_density.tsv and NAME_runs.tsv, and TEST_curves.tsv of each test.
        """
        of = self.folder / name
        before = f"{of}_sets.h5"
        for k, test in enumerate(self.tests):
            last = k == len(self.tests) - 1
            after = f"{of}_posterior.h5" if last else f"{of}_{test.name}.h5"
            words = ["assimilate", before, *self.comparison(test), *(["--continue"] if k else []), "--quiet"]
            self.filter(*words, "--force", "-o", after, output=f"{of}_posterior.txt", fails=(1,))
            self.filter(*words, "--tsv", "--table", "curves", output=self.folder / f"{test.name}_curves.tsv", fails=(1,))
            before = after
        for table in ("steps", "density", "runs"):
            self.filter(*words, "--tsv", "--table", table, output=f"{of}_{table}.tsv", fails=(1,))
        return float(Table.read(f"{of}_steps.tsv")("effective_size", "1")[-1])

    def predict(self, test, sets):
        """Runs a table of sets through a test that was not weighed, and writes their curves into TEST_curves.tsv."""
        self.run(sets, test)
        words = ["assimilate", sets, "--prior", self.given.prior, *self.comparison(test), "--quiet", "--tsv", "--table", "curves"]
        self.filter(*words, output=self.folder / f"{test.name}_curves.tsv", fails=(1,))

    def rounds(self):
        """Makes the rounds; returns the name of the last one and its effective sample size."""
        given = self.given
        for r in range(1, given.rounds + 1):
            name, sets = f"round{r}", given.samples[min(r, len(given.samples)) - 1]
            drawn = ["draw", given.prior, *(["--bases", given.bases] if given.bases else [])] if r == 1 else [
                "resample", self.folder / f"round{r - 1}_posterior.h5", "--keep", "--seed", r]
            self.filter(*drawn, "--samples", sets, "--tsv", "--force", "--quiet", "-o", self.folder / f"{name}_sets.h5",
                        output=self.folder / f"{name}_sets.tsv")
            for test in self.tests:
                self.run(self.folder / f"{name}_sets.tsv", test)
            size = self.assimilate(name)
            print(f"  {self.folder}: round {r}: effective sample size {size:.3g}", flush=True)
            if given.effective_size and size >= given.effective_size:
                break
        return name, size


def refuse_missing_tools(folder):
    """Raises Failure, 69, where a tool that a calibration calls is not in the folder: the last one is called after hours."""
    missing = [name for name in ("run-dem", "homogenize", "pf-weight", "plot") if not os.access(folder / name, os.X_OK)]
    if missing:
        raise Failure(69, f"calibrate: {folder} lacks {', '.join(missing)}: make all builds them, and BIN=FOLDER names another folder")


def main(words):
    """Calibrates as a command line says; returns 1 where the effective sample size that was asked for is not reached."""
    given = parse(words)
    refuse_missing_tools(pathlib.Path(os.environ["BIN"]))
    case = Calibration(given)
    name, size = case.rounds()
    shutil.copyfile(case.folder / f"{name}_posterior.txt", case.folder / "posterior.txt")
    predicted.write(case, name)
    met = size >= given.effective_size
    said = f"effective sample size {size:.3g} after {name.removeprefix('round')} of {given.rounds} rounds"
    said += "" if met else f", below the {given.effective_size:g} asked for: means and intervals are coarse; give more --rounds or --samples"
    words = [said, case.rate_words]
    put(case.folder / "said.txt", "".join(f"{line}\n" for line in [*words, *case.said]))
    put(case.folder / "posterior.h5", (case.folder / f"{name}_posterior.h5").read_bytes())
    print(f"calibrate: {case.folder}: {'; '.join(words)}", file=sys.stdout if met else sys.stderr)
    return 0 if met else 1


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except StudyError as wrong:
        print(f"calibrate: {wrong}", file=sys.stderr)
        sys.exit(65)
    except Failure as wrong:
        print(wrong, file=sys.stderr)
        sys.exit(wrong.status)
    except KeyboardInterrupt:
        sys.exit(130)
