"""Every chapter at full size: the parts of a forecast, and the state of each file on the status page."""
# SPDX-License-Identifier: GPL-3.0-or-later
import os

import pytest
from study import StudyError
from thesis import forecast, products, status

HEAD = "chapter\tproduct\tbodies\tlinks\tsteps\tmegabytes\tbasis\n"
CHECK = ("about 7 min: 164087 steps (97 % of them waiting for rest) of 1000 grains with 2000 contacts in 420 s: 5.0e+03 steps/s, 169 ns per contact; "
         "contacts 80 %, integration 17 %, neighbours 3 %, output 0 %")


def table(path, rows):
    path.write_text(HEAD + rows)
    return path


def test_steps_of_kept_runs_count_before_the_table(tmp_path):
    path = table(tmp_path / "products.tsv", "ch3\tuc_PE\t10\t20\t500\t3\tuc_PP\nch3\tuc_PP\t10\t20\t400\t3\tuc_PE\n")
    (tmp_path / "ch3/kept").mkdir(parents=True)
    (tmp_path / "ch3/kept/uc_PE.tsv").write_text("step [1]\ttime [s]\n0\t0\n640\t2\n")
    first, second = products.read(path, tmp_path)
    assert (first.steps, first.basis) == (640, "measured") and (second.steps, second.basis) == (400, "uc_PE")


@pytest.mark.parametrize(("row", "said"), [("ch3\tbag\tmany\t2\t3\t4\tmeasured\n", "line 2: "), ("ch3\tbag\t0\t2\t3\t4\tmeasured\n", "line 2: a number is not above 0")])
def test_a_row_that_cannot_be_is_named(tmp_path, row, said):
    with pytest.raises(StudyError) as error:
        products.read(table(tmp_path / "products.tsv", row), tmp_path)
    assert said in str(error.value)


def test_all_files_of_the_repository_are_known():
    names = {(p.chapter, p.name) for p in products.read()}
    assert {("ch3", "uc_PE"), ("ch4", "wrapped"), ("ch5", "uc_5PP"), ("ch5", "cell_5PP_100kPa")} <= names


def test_notes_of_a_tool_are_no_part_of_what_it_prints(tmp_path):
    for words, status_ in (("echo table; echo 'tool: the text leaves out 3 contacts' >&2", 0), ("echo 'tool: no room' >&2; exit 74", 74)):
        (tmp_path / "tool").write_text(f"#!/bin/sh\n{words}\n")
        (tmp_path / "tool").chmod(0o755)
        machine = forecast.Machine(tmp_path, tmp_path / "trials", 1)
        if status_ == 0:
            assert machine.run("tool") == "table\n"
        else:
            with pytest.raises(StudyError, match="tool: no room"):
                machine.run("tool")


def test_a_rate_gives_back_the_steps_that_it_was_made_of():
    rate = forecast.rate_of(CHECK)
    assert rate.step(1000, 2000) == pytest.approx(1 / 5000) and rate.link * 2000 == pytest.approx(0.8 / 5000)
    with pytest.raises(StudyError):
        forecast.rate_of("nothing")
    large = forecast.Rate(100_000, 2 * rate.link, 3 * rate.body)
    middle = forecast.between([rate, large], 10_000)
    assert middle.link == pytest.approx(1.5 * rate.link) and middle.body == pytest.approx(2 * rate.body)
    assert forecast.between([rate, large], 10**6).link == large.link and forecast.between([rate, large], 10).link == rate.link


def test_two_scales_tell_their_time_in_any_unit():
    assert forecast.two_scale_seconds("file about 17 MB\nabout 1.1e+02 min on 1 thread; contacts grow") == pytest.approx(6600)
    assert forecast.two_scale_seconds("about 40 s on 1 thread") == 40
    with pytest.raises(StudyError):
        forecast.two_scale_seconds("file about 17 MB")


def test_a_test_takes_the_mean_of_the_trial():
    assert forecast.mean_runtime("Seq\tHost\tStarttime\tJobRuntime\n1\t:\t0\t     2.5\n2\t:\t0\t     3.5\n") == 3
    with pytest.raises(StudyError):
        forecast.mean_runtime("Seq\tHost\tStarttime\tJobRuntime\n")


def test_copies_of_a_packing_lie_side_by_side():
    text = forecast.tiled("##PERIODIC:: 1 2 3\n0.5 0.5 0.5 0.1\n", (2, 1))
    assert text == "##PERIODIC:: 2.0 2.0 3.0\n0.5 0.5 0.5 0.1\n1.5 0.5 0.5 0.1\n"
    with pytest.raises(StudyError):
        forecast.tiled("0.5 0.5 0.5 0.1\n")


def test_a_forecast_leaves_out_what_is_done_and_counts_what_is_left(tmp_path):
    done, half, new = (products.Product("ch3", name, 1000, 2000, 100, 5, "measured" if name == "done" else "done") for name in ("done", "half", "new"))
    rates = [forecast.Rate(1000, 1e-4, 0), forecast.Rate(10_000, 1e-4, 0)]
    done.file(tmp_path).parent.mkdir(parents=True)
    done.file(tmp_path).touch()
    part = half.file(tmp_path).with_name("half.h5.part")
    part.mkdir()
    for step in (0, 60):
        (part / f"state-{step:012}.h5").touch()
    chapter = forecast.of_products([done, half, new], rates, tmp_path)
    assert chapter.seconds == pytest.approx((40 + 100) * 0.2) and chapter.disk == 10 and chapter.alike == 2
    calibration = forecast.of_calibration(["hm_1000_0.2", "cl_2000_0.2"], 10, {"hm": 1, "cl": 2}, rates, tmp_path)
    assert calibration.seconds == pytest.approx(10 * (1 + 2 * 2))
    lines = forecast.report([chapter, calibration], 2)
    assert lines[1].endswith("steps of 2 runs estimated from like ones") and len(lines) == 4


def test_the_page_tells_done_running_stopped_failed_and_waiting(tmp_path):
    made = {name: products.Product("ch3", name, 1000, 2000, 100, 5, "measured") for name in ("done", "running", "stopped", "failed", "waiting")}
    (tmp_path / "ch3").mkdir()
    made["done"].file(tmp_path).touch()
    now = 10_000.0
    for name, last in (("running", now - 100), ("stopped", now - 2000)):
        part = made[name].file(tmp_path).with_name(f"{name}.h5.part")
        part.mkdir()
        for step, written in ((0, last - 400), (50, last)):
            state = part / f"state-{step:012}.h5"
            state.touch()
            os.utime(state, (written, written))
    log = (f"  run   {tmp_path}/ch3/failed.h5\nrun-dem: doubt: it is fast\nrun-dem: a grain is lost\n"
           f"make[1]: *** [pipelines/ch3/study.mk:65: {tmp_path}/ch3/failed.h5] Error 70\n")
    rows = [status.row_of(p, tmp_path, status.failures(log), [], now) for p in made.values()]
    assert [row.state for row in rows] == list(made)
    assert rows[1].words == "about 7 min left" and rows[2].words == "make thesis goes on from here"
    assert rows[3].words == "run-dem: a grain is lost (exit status 70)"
    # A file that was made again has not failed.
    assert status.failures(log + f"  run   {tmp_path}/ch3/failed.h5\n") == {}
    # make thesis tries every file again.
    assert status.failures(f"{log}{status.BEGUN}\n") == {}
    assert list(status.failures(f"{status.BEGUN}\n{log}")) == [f"{tmp_path}/ch3/failed.h5"]
