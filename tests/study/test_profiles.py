"""Rules of the studies: what a change of the profile or of the catalogue makes anew."""
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).parents[2]


def make(out, tools, *words):
    """Runs make with tools that only write their output; returns what they were called with."""
    (tools / "log").write_text("")
    alone = {name: value for name, value in os.environ.items() if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL")}
    subprocess.run(["make", "-s", f"BIN={tools}", f"OUT={out}", *map(str, words)], cwd=ROOT, env=alone, check=True, capture_output=True)
    return (tools / "log").read_text().splitlines()


def writers(folder, *names):
    """Makes tools in a folder that note how they are called and write what -o names."""
    folder.mkdir()
    for name in names:
        (folder / name).write_text(f'#!/bin/sh\necho {name} "$@" >> {folder}/log\nwhile [ $# -gt 1 ]; do [ "$1" = -o ] && echo > "$2"; shift; done\n')
        (folder / name).chmod(0o755)
    return folder


def test_the_volume_of_a_bag_is_that_of_the_profile(tmp_path):
    out, tools = tmp_path / "out", writers(tmp_path / "tools", "pack-generate")
    for volume in (out / "ch3/rv.h5", out / "ch3/variants/bag/rv.h5"):
        for profile, seed in (("quick", 1), ("thesis", 3), ("quick", 1)):
            called = make(out, tools, f"PROFILE={profile}", volume)
            assert len(called) == 1 and f"--seed {seed} " in called[0], called
        assert not make(out, tools, "PROFILE=quick", volume)


def test_tables_of_the_solution_hang_on_the_catalogue(tmp_path):
    out, tools = tmp_path / "out", writers(tmp_path / "tools", "gws-solve")
    tables = [out / f"ch5/{name}" for name in ("chart.tsv", "sensitivity.txt", "uniaxial_PE.tsv")]
    assert len(make(out, tools, *tables)) == 3 and not make(out, tools, *tables)
    assert len(make(out, tools, *tables, "-W", "data/geotextiles/PP.toml")) == 3
