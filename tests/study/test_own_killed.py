"""Steps of make own that fail: nothing that they leave counts as an answer."""
# SPDX-License-Identifier: GPL-3.0-or-later
from test_own import make, writers, example  # noqa: F401


def tool(folder, name, words):
    (folder / name).write_text(f"#!/bin/sh\necho {name} \"$@\" >> {folder}/log\n{words}\n")
    (folder / name).chmod(0o755)


def test_a_calibration_that_ends_in_an_error_leaves_no_posterior_of_other_tests(soil, tmp_path, tools):
    out = tmp_path / "out"
    cal, draws = out / "own/soil/calibration", out / "own/soil/draws.tsv"
    make(soil.parent, out, tools, out / "own/soil/packing_1.h5")
    # An earlier calibration, with other tests, left a posterior.
    cal.mkdir()
    for name in ("sets", "weights"):
        (cal / f"{name}.tsv").write_text("id [1]\tweight [1]\tyoung_modulus [Pa]\tpoisson_ratio [1]\trolling_stiffness [1]\trolling_limit [1]\tfriction_angle [deg]\n"
                                         "0\t1\t4e9\t0.2\t0.1\t0.1\t20\n")
    (cal / "posterior.h5").write_text("old")
    for name in ("run-dem", "homogenize", "plot"):
        tool(tools, name, "echo 'cannot write: No space left on device' >&2; exit 74")
    called, said = make(soil.parent, out, tools, draws)
    assert "rows did not finish" in said and not draws.exists(), said
    assert not (cal / "posterior.h5").exists()


def test_a_tool_that_is_killed_is_no_design_that_no_geotextile_meets(soil, tmp_path, tools):
    out = tmp_path / "out"
    make(soil.parent, out, tools, out / "own/soil/packing_1.h5")
    own = out / "own/soil"
    (own / "loads").write_text("1e5 2e5\n")
    high = own / "design_high.tsv"
    for end, left in (("kill -9 $$", False), ("exit 74", False), ("exit 1", True)):
        tool(tools, "gws-solve", end)
        make(soil.parent, out, tools, "-o", own / "loads", high)
        assert high.exists() == left, end


def test_a_calibration_waits_for_the_tools_that_it_calls(soil, tmp_path, tools):
    out = tmp_path / "out"
    for name in ("run-dem", "homogenize"):
        tool(tools, name, "exit 0")
    said = make(soil.parent, out, tools, out / "own/soil/calibration/posterior.h5")[1]
    assert f"No rule to make target '{tools}/plot'" in said and not (out / "own/soil/calibration/sets.tsv").exists(), said
