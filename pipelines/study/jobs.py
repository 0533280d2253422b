"""Runs commands side by side: by GNU parallel on this machine or on the hosts of SSHLOGINFILE, which see the same folder, or by Slurm.

ENGINE=slurm makes an array job of at most SLURM_ARRAY_SIZE tasks. SLURM_FLAGS: further options of sbatch. JOBS: commands at once.
Nodes of a cluster run this file, too, so that it needs the standard library alone: python3 -m study.jobs FILE MOST runs one task's share.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import contextlib
import fcntl
import os
import pathlib
import shlex
import signal
import subprocess
import sys
import time

from .command import Failure


def one_at_a_time(folder):
    """Waits until nobody else works in the folder, and returns the open lock.

    Jobs inherit the lock, because jobs of a killed make may still be running, and their results count.
    """
    lock = os.open(folder / "lock", os.O_WRONLY | os.O_CREAT, 0o666)
    os.set_inheritable(lock, True)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        print(f"  {folder}: waiting for runs that are still under way", file=sys.stderr, flush=True)
        fcntl.flock(lock, fcntl.LOCK_EX)
    return lock


def _by_parallel(jobs, words, joblog, lock):
    """Starts GNU parallel on the commands of a file; returns a function that waits some seconds and returns whether it still runs.

    Names of folders and files may hold any characters, since parallel quotes the words of the file.
    """
    hosts = os.environ.get("SSHLOGINFILE")
    command = ["parallel", "--quote", "--colsep", "\t", "--trim", "n", "--jobs", os.environ.get("JOBS", "100%"), "--joblog", str(joblog),
               "--retries", "3", *(["--sshloginfile", hosts, "--workdir", os.getcwd()] if hosts else []), "--env", "BIN",
               *(f"{{{k}}}" for k in range(1, words + 1)), "::::", str(jobs)]
    try:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, pass_fds=[lock])
    except FileNotFoundError as error:
        raise Failure(66, "jobs: GNU parallel is not installed; run: apt-get install parallel") from error

    def runs(seconds):
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(seconds)
        return process.returncode is None
    return runs


def _by_slurm(folder, jobs, count):
    """Submits the commands of a file as an array job; returns a function that waits some seconds and returns whether it still runs."""
    most = int(os.environ.get("SLURM_ARRAY_SIZE", "1000"))  # tasks; Slurm's own limit is MaxArraySize, 1001 unless configured
    share = [sys.executable, "-P", "-m", "study.jobs", str(jobs), str(most)]
    command = ["sbatch", "--parsable", "--job-name", folder.name, "--array", f"0-{min(count, most) - 1}", "--cpus-per-task", "1",
               "--export", "ALL", "--chdir", os.getcwd(), "--output", f"{folder}/slurm-%a.log",
               *os.environ.get("SLURM_FLAGS", "").split(), "--wrap", shlex.join(share)]
    try:
        said = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        raise Failure(1, f"jobs: sbatch: {error}") from error
    job = said.strip().partition(";")[0]

    def interrupted(*_):
        # An interrupted make cancels its job.
        subprocess.run(["scancel", job], check=False)
        sys.exit(143)
    signal.signal(signal.SIGTERM, interrupted)
    signal.signal(signal.SIGINT, interrupted)

    def runs(seconds):
        time.sleep(min(seconds, float(os.environ.get("SLURM_POLL", "10"))))
        asked = subprocess.run(["squeue", "--noheader", "--job", job, "--format", "%i"], capture_output=True, text=True, check=False)
        # Slurm forgets a job some time after its end. Without an answer from Slurm, the job counts as running.
        return bool(asked.stdout.strip()) or (asked.returncode != 0 and "Invalid job id" not in asked.stderr)
    return runs


def task(jobs, most):
    """Runs the share of one task of an array job, every `most`-th command of the file; returns the greatest exit status."""
    lines = pathlib.Path(jobs).read_text(encoding="utf-8", errors="surrogateescape").splitlines()
    own = lines[int(os.environ["SLURM_ARRAY_TASK_ID"])::int(most)]
    return max((subprocess.run(line.split("\t"), check=False).returncode for line in own), default=0)


def _rate(joblog):
    """Returns ", N runs per hour and core" from GNU parallel's account of its jobs; nothing where there is none."""
    rows = [line.split("\t") for line in joblog.read_text(errors="replace").splitlines()[1:]] if joblog.exists() else []
    seconds = [float(row[3]) for row in rows if len(row) >= 9 and float(row[3]) > 0]
    return f", {3600 * len(seconds) / sum(seconds):.0f} runs per hour and core" if seconds else ""


def run(folder, name, commands, lock, progress):
    """Runs commands and returns a sentence on their speed. Each command is a list of words; all lists are equally long.

    The commands stand in FOLDER/NAME.unrun, and GNU parallel's log of them in FOLDER/NAME.joblog. lock: from one_at_a_time(). progress:
    takes the seconds since the start and returns a line on the progress. It is printed every PROGRESS_INTERVAL seconds (15).
    """
    jobs, joblog = (folder / f"{name}.{ending}" for ending in ("unrun", "joblog"))
    if any("\t" in word or "\n" in word for word in commands[0]):
        raise Failure(65, f"jobs: {folder}: names of folders and files may not hold tabs or line ends")
    jobs.write_text("".join("\t".join(words) + "\n" for words in commands), encoding="utf-8", errors="surrogateescape")
    slurm = os.environ.get("ENGINE", "parallel") == "slurm"
    still_runs = _by_slurm(folder, jobs, len(commands)) if slurm else _by_parallel(jobs, len(commands[0]), joblog, lock)
    interval = max(float(os.environ.get("PROGRESS_INTERVAL", "15")), 0.2)
    start = told = time.monotonic()
    while still_runs(interval):
        if time.monotonic() - told >= 0.9 * interval:
            told = time.monotonic()
            print(progress(told - start), file=sys.stderr, flush=True)
    return "" if slurm else _rate(joblog)


if __name__ == "__main__":
    sys.exit(task(*sys.argv[1:]))
