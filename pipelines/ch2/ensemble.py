"""Runs every row of an ensemble's table, one row one job one folder; ensemble.sh tells how it is called.

GNU parallel runs the rows on this machine or on the hosts of SSHLOGINFILE, which see the same folder; with ENGINE=slurm they are
a Slurm array job. Stopped at any point, it goes on with the rows that are missing. Rows that will fail each time are listed and
stay failed; other trouble is tried again, then told. The standard library is enough, since nodes of a cluster run this file, too.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import contextlib
import dataclasses
import fcntl
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).parent
RUN = str(HERE / "run.sh")
# The contact parameters of a row in the order of run.sh: as pf-weight names them, as the author's tables do, in which unit.
PARAMETERS = (("young_modulus", "E", "Pa"), ("poisson_ratio", "nu", "1"), ("rolling_stiffness", "kr", "1"), ("rolling_limit", "eta", "1"),
              ("friction_angle", "mu", "deg"))
LAWS = {"hm": "Hertz-Mindlin", "cl": "linear"}
LISTED = 10  # failed rows that are told one by one


class EnsembleError(Exception):
    """One line for the reader, and the exit status that goes with it."""

    def __init__(self, text, status=65):
        super().__init__(text)
        self.status = status


def read_rows(path):
    """Returns the rows of a table: id without leading zeros, the five parameters, the number of the twin (0), all as text.

    Below a header of names, the id first, with any line ends; comments and empty lines are left out. Parameters and twin are
    found by their names, other columns are ignored. Raises EnsembleError for a row without a whole id, a parameter that is
    missing or in another unit, and a table without rows.
    """
    try:
        text = pathlib.Path(path).read_bytes().decode("utf-8-sig", errors="surrogateescape")
    except OSError as error:
        raise EnsembleError(f"rows: {path}: cannot be read: {error.strerror}", 66) from error
    header, places, rows, number = None, [], {}, 1

    def fail(words):
        raise EnsembleError(f"rows: {path}: line {number}: {words}")

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
                if given and unit != "1" and given[1] != unit:
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
        raise EnsembleError(f"rows: {path}: no rows below the header")
    return list(rows.values())


@dataclasses.dataclass
class Ensemble:
    """The rows of a table and the folder of their runs. common: what run.sh is told before a row's own numbers, FOLDER first."""

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
        """Returns the rows that will fail each time."""
        return [row for row in self.rows if self.of_row(row, "failed").exists()]

    def progress(self, before, seconds):
        """Returns a line on how far it is: rows done and failed, time left, runs per hour; `before` rows were done at first."""
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
    """Clears a folder whose results come from other inputs, programs or scenarios: those are not resumed from."""
    digest = hashlib.sha256()
    for path in inputs:
        try:
            digest.update(pathlib.Path(path).read_bytes())
        except OSError as error:
            raise EnsembleError(f"ensemble: {path}: cannot be read: {error.strerror}", 66) from error
    key = folder / "key"
    if not (key.exists() and key.read_text().strip() == digest.hexdigest()):
        shutil.rmtree(folder / "runs", ignore_errors=True)
        (folder / "runs").mkdir()
        key.write_text(digest.hexdigest() + "\n")


def one_at_a_time(folder):
    """Waits until no other ensemble runs in the folder, and returns the open lock.

    Jobs inherit it: those of a make that was killed may still be under way, and their results count.
    """
    lock = os.open(folder / "lock", os.O_WRONLY | os.O_CREAT, 0o666)
    os.set_inheritable(lock, True)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        print(f"  {folder}: waiting for runs that are still under way", file=sys.stderr, flush=True)
        fcntl.flock(lock, fcntl.LOCK_EX)
    return lock


def by_parallel(jobs, joblog, lock):
    """Starts GNU parallel on the commands of a file; returns what says after a wait of some seconds whether it still runs.

    Names of folders and files reach run.sh as they are, whatever is in them: parallel quotes what it takes from a file.
    """
    hosts = os.environ.get("SSHLOGINFILE")
    words = len(jobs.read_text(encoding="utf-8", errors="surrogateescape").partition("\n")[0].split("\t"))
    command = ["parallel", "--quote", "--colsep", "\t", "--trim", "n", "--jobs", os.environ.get("JOBS", "100%"), "--joblog", str(joblog),
               "--retries", "3", *(["--sshloginfile", hosts, "--workdir", os.getcwd()] if hosts else []), "--env", "BIN",
               *(f"{{{k}}}" for k in range(1, words + 1)), "::::", str(jobs)]
    try:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, pass_fds=[lock])
    except FileNotFoundError as error:
        raise EnsembleError("ensemble: GNU parallel is not installed; run: apt-get install parallel", 66) from error

    def runs(seconds):
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(seconds)
        return process.returncode is None
    return runs


def by_slurm(ensemble, jobs, count):
    """Submits the commands of a file as an array job; returns what says after a wait of some seconds whether it still runs."""
    most = int(os.environ.get("SLURM_ARRAY_SIZE", "1000"))  # tasks; Slurm's own limit is MaxArraySize, 1001 unless configured
    task = [sys.executable, "-P", __file__, "--task", str(jobs), str(most)]
    command = ["sbatch", "--parsable", "--job-name", ensemble.folder.name, "--array", f"0-{min(count, most) - 1}", "--cpus-per-task", "1",
               "--export", "ALL", "--chdir", os.getcwd(), "--output", f"{ensemble.folder}/slurm-%a.log",
               *os.environ.get("SLURM_FLAGS", "").split(), "--wrap", shlex.join(task)]
    try:
        said = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        raise EnsembleError(f"ensemble: sbatch: {error}", 1) from error
    job = said.strip().partition(";")[0]

    def interrupted(*_):
        # An interrupted make takes its job along.
        subprocess.run(["scancel", job], check=False)
        sys.exit(143)
    signal.signal(signal.SIGTERM, interrupted)
    signal.signal(signal.SIGINT, interrupted)

    def runs(seconds):
        time.sleep(min(seconds, float(os.environ.get("SLURM_POLL", "10"))))
        queue = ["squeue", "--noheader", "--job", job, "--format", "%i"]
        return bool(subprocess.run(queue, capture_output=True, check=False).stdout.strip())
    return runs


def task(jobs, most):
    """Runs the commands that fall to one task of an array job, every `most`-th of the file; returns the exit status."""
    lines = pathlib.Path(jobs).read_text(encoding="utf-8", errors="surrogateescape").splitlines()
    own = lines[int(os.environ["SLURM_ARRAY_TASK_ID"])::int(most)]
    return max((subprocess.run(line.split("\t"), check=False).returncode for line in own), default=0)


def rate(joblog):
    """Returns ", N runs per hour and core" from GNU parallel's account of its jobs; nothing where there is none."""
    rows = [line.split("\t") for line in joblog.read_text(errors="replace").splitlines()[1:]] if joblog.exists() else []
    seconds = [float(row[3]) for row in rows if len(row) >= 9 and float(row[3]) > 0]
    return f", {3600 * len(seconds) / sum(seconds):.0f} runs per hour and core" if seconds else ""


def run_rows(ensemble, left, lock):
    """Runs these rows, tells every PROGRESS_INTERVAL seconds (15) how far it is, and returns how fast rows were."""
    jobs, joblog = (ensemble.folder / f"{ensemble.name}.{ending}" for ending in ("unrun", "joblog"))
    commands = [[RUN, *ensemble.common, *row] for row in left]
    if any("\t" in word or "\n" in word for word in commands[0]):
        raise EnsembleError(f"ensemble: {ensemble.folder}: names of folders and files may not hold tabs or line ends")
    jobs.write_text("".join("\t".join(words) + "\n" for words in commands), encoding="utf-8", errors="surrogateescape")
    slurm = os.environ.get("ENGINE", "parallel") == "slurm"
    still_runs = by_slurm(ensemble, jobs, len(left)) if slurm else by_parallel(jobs, joblog, lock)
    interval = max(float(os.environ.get("PROGRESS_INTERVAL", "15")), 0.2)
    before = len(ensemble.rows) - len(left)
    start = told = time.monotonic()
    while still_runs(interval):
        if time.monotonic() - told >= 0.9 * interval:
            told = time.monotonic()
            print(ensemble.progress(before, told - start), file=sys.stderr, flush=True)
    return "" if slurm else rate(joblog)


def main(table, folder, law, packing, scenario, pressure, strain):
    """Runs the rows of the table that have no result yet; raises EnsembleError where some did not finish."""
    if law not in LAWS:
        raise EnsembleError(f'ensemble: "{law}" is no law; give ' + " or ".join(f"{key} ({words})" for key, words in LAWS.items()), 64)
    for what, word in (("PRESSURE_MPa", pressure), ("STRAIN_%", strain)):
        if not re.fullmatch(r"\d+\.?\d*|\.\d+", word, re.ASCII):
            raise EnsembleError(f'ensemble: {what}: "{word}" is no number; write it with digits and a decimal point', 64)
    # No program that is handed these takes them for options.
    folder, packing, scenario = (f"./{path}" if path.startswith("-") else path for path in (folder, packing, scenario))
    name, programs = pathlib.Path(table).stem, pathlib.Path(os.environ["BIN"])
    home = pathlib.Path(folder)
    (home / "runs").mkdir(parents=True, exist_ok=True)
    lock = one_at_a_time(home)
    ensemble = Ensemble(name, home, [folder, law, packing, scenario, pressure, strain], read_rows(table))
    keep_results_of(home, [packing, scenario, RUN, programs / "run-dem", programs / "homogenize"])
    left, speed = ensemble.unfinished(), ""
    if left:
        print(f"  run   {home} {name}: {len(left)} of {len(ensemble.rows)} rows", flush=True)
        speed = run_rows(ensemble, left, lock)
    ensemble.tell_failed()
    print(f"  {home} {name}: {len(ensemble.rows)} runs, {len(ensemble.failed())} failed{speed}", flush=True)
    missing = len(ensemble.unfinished())
    if missing:
        raise EnsembleError(f"{home}: {missing} rows did not finish (see {home / name}.joblog); make again tries them", 1)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--task"]:
        sys.exit(task(*sys.argv[2:]))
    try:
        if len(sys.argv) != 8 or "BIN" not in os.environ:
            raise EnsembleError("ensemble: usage: BIN=build/bin ensemble.sh TABLE.tsv FOLDER LAW PACKING SCENARIO PRESSURE_MPa STRAIN_%", 64)
        main(*sys.argv[1:])
    except EnsembleError as error:
        print(error, file=sys.stderr)
        sys.exit(error.status)
    except KeyboardInterrupt:
        sys.exit(130)
