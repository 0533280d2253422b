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
    """Makes tools in a folder that note how they are called and write what -o and --history name."""
    folder.mkdir()
    for name in names:
        (folder / name).write_text(f'#!/bin/sh\necho {name} "$@" >> {folder}/log\nwhile [ $# -gt 1 ]; do case $1 in -o | --history) echo > "$2" ;; esac; shift; done\n')
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


def test_runs_hang_on_the_catalogue_of_geotextiles_and_those_of_soil_alone_do_not(tmp_path):
    out, tools = tmp_path / "out", writers(tmp_path / "tools", "pack-generate", "filter-expand", "run-dem")
    runs = [out / f"{name}.h5" for name in (
        "ch3/uc_PE", "ch3/uc_PE_rough", "ch3/ss_2410", "ch3/strip_PP", "ch3/box_25", "ch3/variants/bag/uc_PE", "ch4/wrapped", "ch4/layered_PP", "ch5/uc_4PP",
        "ch5/cell_PP_50kPa")]
    alone = [out / f"{name}.h5" for name in ("ch3/rv_unloaded", "ch4/soil")]
    make(out, tools, *runs, *alone)
    assert not make(out, tools, *runs, *alone)
    again = make(out, tools, *runs, *alone, "-W", "data/geotextiles/PP.toml")
    assert {str(run) for run in runs} <= {line.split(" -o ")[1] for line in again}
    assert not any(str(run) in line for run in alone for line in again)


def test_another_number_of_twins_or_another_case_makes_what_hangs_on_it_anew(tmp_path):
    out, tools = tmp_path / "out", writers(tmp_path / "tools")
    case = out / "ch2/hm_1000_0.2"
    case.mkdir(parents=True)
    for name in ("posterior.h5", *(f"round{k}_steps.tsv" for k in (1, 2, 3, 4))):
        (case / name).touch()
    check, posterior = case / "check.tsv", case / "posterior.h5"
    for twins in (3, 4):
        make(out, tools, "-o", posterior, "STUDY_PY=echo", f"C2_TWINS={twins}", check)
        assert check.read_text().endswith(f" --twins {twins}\n") and "/twins " not in check.read_text()
    made = check.stat().st_mtime_ns
    make(out, tools, "-o", posterior, "STUDY_PY=echo", "C2_TWINS=4", check)
    assert check.stat().st_mtime_ns == made
    remembered = [out / "ch2/settings", out / "ch2/cases"]
    for words, changed in (("", [True, True]), ("C2_STRAIN_peak=12", [True, False]), ("C2_CASES=hm_1000_0.2", [True, True])):
        before = [file.read_text() if file.exists() else "" for file in remembered]
        make(out, tools, *remembered, *words.split())
        assert [file.read_text() != text for file, text in zip(remembered, before, strict=True)] == changed, words
