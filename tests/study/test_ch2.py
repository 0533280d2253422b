"""Chapter 2: its measures on small tables by hand, the results of a single round, the rows of an ensemble."""
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import pathlib
import subprocess
import types

import h5py
import numpy
import pytest
from calibration import ensemble
from ch2 import inputs, loading, rates
from ch2 import study as chapter
from ch2.inputs import PARAMETERS
from ch2.study import Case
from matplotlib import pyplot
from renaming import demand_columns
from study import NotMade, Study, StudyError, Table, jobs

ROOT = pathlib.Path(__file__).parents[2]
STRAINS = [0.5 * k for k in range(1, 13)]
# The mean friction angle goes 1 degree a station up to 1.5 %, and 0.1 in the last 1.5 %.
FRICTION = [28, 29, 30, *[30] * 6, 30.1, 30.2, 30.3]
ANSWER = {"young_modulus": 4e9, "poisson_ratio": 0.1, "rolling_stiffness": 0.15, "rolling_limit": 0.2, "friction_angle": 30.3}


def write(path, **columns):
    """Writes columns, given as head=(unit, values). A single value fills its whole column."""
    length = max(numpy.size(values) for _, values in columns.values())
    rows = zip(*(numpy.broadcast_to(values, length) for _, values in columns.values()), strict=True)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(["\t".join(f"{head} [{unit}]" for head, (unit, _) in columns.items()),
                               *("\t".join(repr(float(x)) for x in row) for row in rows)]) + "\n")


def write_case(folder, name, rounds, scale=1.0):
    """Writes the tables of a case; `scale` multiplies the parameters that it identified."""
    curve = name.endswith("_0.2")
    station = {"strain_axial": ("%", STRAINS)} if curve else {"confining_pressure": ("kPa", [1000])}
    friction = FRICTION if curve else [30.3]
    write(folder / name / "rounds.tsv", round=("1", range(1, rounds + 1)), sets=("1", [6 + 4 * r for r in range(rounds)]), failed=("1", range(rounds)))
    for r in range(1, rounds + 1):
        values = {p: scale * (numpy.array(friction) if p == "friction_angle" else ANSWER[p]) for p in PARAMETERS}
        columns = {p: (PARAMETERS[p], v) for p, v in values.items()}
        columns |= {f"{p}_{end}": (PARAMETERS[p], factor * values[p]) for p in PARAMETERS
                    for end, factor in (("deviation", 0.05), ("low", 0.9), ("high", 1.1))}
        write(folder / name / f"round{r}_steps.tsv", **station, **columns, effective_size=("1", numpy.linspace(20, r, len(friction))))
        stations = STRAINS[-2:] if curve else [1000]
        grid = [(at, k, x) for at in stations for k in range(5) for x in (1, 2, 3)]
        at, k, x = zip(*grid, strict=True)
        head, (unit, _) = next(iter(station.items()))
        write(folder / name / f"round{r}_density.tsv", **{head: (unit, at)}, parameter=("1", k), value=("its own", x),
              density=("1 per its own", [0.1, 0.3, 0.1] * (len(grid) // 3)))
        (folder / name / f"round{r}_posterior.txt").write_text("at the end\n")
        if curve and r == 1:
            write(folder / name / "thesis_error.tsv", **station, **columns, effective_size=("1", 2))
    if curve:
        ids, misfit = [0, 1, 2, 10, 11], [0.02, 0.03, 0.04, 0.05, 0.06]
        for table, factor in (("near", 1), ("whole", 2)):
            write(folder / name / f"check_{table}.tsv", id=("1", ids), fate=("1", [0, 0, 4, 0, 0]),
                  stress_ratio_misfit_relative=("1", factor * numpy.array(misfit)),
                  strain_volumetric_misfit=("%", factor * 10 * numpy.array(misfit)))
        write(folder / name / "check_curves.tsv", id=("1", [0, 0, 10, 10]), strain_axial=("%", [1, 2, 1, 2]),
              stress_ratio=("1", [3, 4, 3, 4]), strain_volumetric=("%", [0.1, 0, 0.1, 0]))


class Undrawn(Study):
    """A study that notes the names of its figures, and draws none: most of the time would go there."""

    def figure(self, name, figure, sentence="", **_):
        self._drawings[name] = ""
        pyplot.close(figure)
        assert sentence or self._texts is None or self._texts.figure(name)["sentence"]


@pytest.fixture(name="out", autouse=True)
def small_results(tmp_path, monkeypatch):
    monkeypatch.chdir(ROOT)
    monkeypatch.setattr(chapter, "Study", Undrawn)
    for name in ("hm_1000_0.2", "cl_1000_0.2", "hm_1000_1"):
        write_case(tmp_path, name, 2)
    write_case(tmp_path, "hm_1000_8", 2, scale=1.25)
    return tmp_path


def build(out, *cases, samples=(6, 4)):
    return chapter.build(types.SimpleNamespace(out=out, profile="quick", kept=False, cases=cases, samples=list(samples), until=6.0, error="0.1,0.025,0.1"))


def test_the_mean_settles_where_it_moves_less_per_strain_at_the_end(out):
    case = Case(out, "hm_1000_0.2", 1)
    # Two degrees over the 1 % from the first station to 1.5 %; 0.3 degrees over the last 1.5 %.
    assert chapter.settling(case) == pytest.approx((0.3 / 1.5) / (2 / 1))
    case.steps[0] = case.steps[0].rows(case.steps[0]["strain_axial"] < 3)
    with pytest.raises(NotMade, match="too few stations"):
        chapter.settling(case)
    with pytest.raises(NotMade, match="no curve of the laboratory"):
        chapter.settling(Case(out, "hm_1000_1", 1))


def test_misfits_are_means_over_the_twins_that_went_through(out):
    study = build(out, "hm_1000_0.2")
    measured = {name: m for name, m in study.measures.items() if m.value is not None}
    assert measured["ratio_hm_1000_0.2"].value == 2.5 and measured["ratio_hm_1000_0.2"].deviation == pytest.approx(numpy.sqrt(0.5))
    assert measured["ratio_thesis_hm_1000_0.2"].value == 5.5 and measured["ratio_excess_hm_1000_0.2"].value == -3
    assert measured["volume_whole_hm_1000_0.2"].value == pytest.approx(0.5) and measured["volume_whole_hm_1000_0.2"].unit == "%"
    assert measured["size_first_hm_1000_0.2"].value == 1 and measured["size_last_hm_1000_0.2"].value == 2
    assert measured["log_modulus_hm_1000_0.2"].value == pytest.approx(numpy.log10(4e9), rel=1e-5)
    assert (measured["friction_angle_hm_1000_0.2"].value, measured["friction_angle_hm_1000_0.2"].unit) == (30.3, "deg")


def test_the_thesis_s_weights_count_up_to_the_laboratory_s_greatest_stress_ratio(out):
    measures = build(out, "hm_1000_0.2").measures
    # The ratio is greatest at 5.4 % of strain; the station before it is at 5 %.
    assert measures["friction_angle_at_peak_hm_1000_0.2"].value == 30.1
    assert measures["log_modulus_at_peak_hm_1000_0.2"].value == pytest.approx(numpy.log10(4e9))
    (out / "hm_1000_0.2/thesis_error.tsv").unlink()
    assert build(out, "hm_1000_0.2").measures["friction_angle_at_peak_hm_1000_0.2"].reason == "the thesis's sets are those of full-size runs"


def test_what_a_case_or_a_set_lacks_has_its_reason_and_no_number(out):
    write(out / "hm_1000_0.2/check_near.tsv", id=("1", [0, 10]), fate=("1", [0, 4]), stress_ratio_misfit_relative=("1", [0.1, numpy.nan]),
          strain_volumetric_misfit=("%", [0.1, numpy.nan]))
    study = build(out, "hm_1000_0.2")
    assert study.measures["ratio_hm_1000_0.2"].value == 10 and study.measures["ratio_hm_1000_0.2"].deviation == 0
    assert study.measures["ratio_thesis_hm_1000_0.2"].reason == "no run of the thesis set of hm_1000_0.2"
    assert study.measures["ratio_excess_hm_1000_0.2"].reason == "no run of the thesis set of hm_1000_0.2"
    assert study.measures["friction_angle_cl_2000_0.2"].reason == "case cl_2000_0.2 is not among C2_CASES"
    assert study.measures["trend_E"].reason == "case hm_1000_8 is not among C2_CASES"
    write(out / "hm_1000_0.2/check_near.tsv", id=("1", [0]), fate=("1", [0]), stress_ratio_misfit_relative=("1", [numpy.nan]),
          strain_volumetric_misfit=("%", [0.1]))
    with pytest.raises(StudyError, match="check_near.tsv: column stress_ratio_misfit_relative has no value in row 1"):
        build(out, "hm_1000_0.2")


def test_trends_are_shares_in_the_direction_of_the_thesis(out):
    study = build(out, "hm_1000_0.2", "hm_1000_1", "hm_1000_8")
    assert study.measures["trend_E"].value == pytest.approx(0.25) and study.measures["trend_mu"].value == pytest.approx(-0.25)
    assert {"pressure", "identified", "means_hm", "prediction", "density_hm_1000_8"} <= set(study._drawings)
    assert "Fig. 2.1: no case of linear contacts at 0.2 MPa" in study.remarks[-1]


def test_a_trend_within_the_spread_of_the_weights_is_not_determined(out):
    write_case(out, "hm_1000_8", 2, scale=1.2)
    study = build(out, "hm_1000_0.2", "hm_1000_8")
    for name in ("trend_E", "trend_mu", "trend_kr"):
        assert study.measures[name].value is None
        assert study.measures[name].reason == "not determined: the middle 90 % of the weights at 0.2 and 8 MPa overlap"


def test_a_single_round_has_its_figures_and_says_what_is_left_out(out, monkeypatch):
    monkeypatch.setattr(chapter, "kept_cases", lambda folder: {})
    study = build(out, "hm_1000_0.2", "cl_1000_0.2", samples=[6])
    assert list(study._drawings) == ["identified", "means_cl", "means_hm", "prediction", "density_hm_1000_0.2", "density_cl_1000_0.2"]
    assert study.remarks[-1].startswith("Not drawn: Fig. 2.3, which takes") and "since one round was made" in study.remarks[-1]
    monkeypatch.setattr(chapter, "Study", Study)
    build(out, "hm_1000_1", samples=[6]).write()
    page = (out / "page.html").read_text()
    assert (out / "density_hm_1000_1.svg").exists() and "since one round was made" in page and "6 sets are drawn from assumed ranges (the prior)." in page


def test_each_column_that_is_renamed_is_missed_by_name(out):
    cases = ("hm_1000_0.2", "hm_1000_1")
    known, observed = "data/contacts/toyoura_hm_0.2MPa.tsv", "data/laboratory/toyoura_peak_obliquity.tsv"

    def all_cases(some):
        return {name: Case(out, name, 2) for name in some}

    def drawing(draw, *some):
        return lambda: draw(Undrawn("ch2", "", out, "quick"), list(all_cases(some or cases[:1]).values()), {})
    readers = [lambda: inputs.peak(observed, 0.2), lambda: inputs.sets([known], 1),
               lambda: chapter.measure(Undrawn("ch2", "", out, "quick"), all_cases(cases)), drawing(chapter.draw_identified),
               drawing(chapter.draw_prediction), *[lambda name=name: chapter.draw_density(Undrawn("ch2", "", out, "quick"), Case(out, name, 2))
                                                   for name in cases], drawing(chapter.draw_means("hm", "Fig. 2.2")),
               drawing(chapter.draw_pressure, "hm_1000_0.2", "hm_1000_1", "hm_1000_8")]
    assert demand_columns(readers) > 50


def test_kept_cases_are_compared_and_drawn_without_a_page(out):
    study = chapter.build(types.SimpleNamespace(out=out, profile="quick", kept=True, cases=["hm_1000_0.2"], samples=[6, 4], until=6.0, error="0.1,0.025,0.1"))
    study.write_tables()
    assert "Hertz–Mindlin contacts, 0.2 MPa\t1\t9.615\t± 0.3\t9.602\t-0.0129 (-0.1 %)\tmet" in (out / "comparison.tsv").read_text()
    assert not (out / "page.html").exists()
    with pytest.raises(StudyError, match="no case is kept; make PROFILE=thesis ch2, then ch2-keep"):
        chapter.build(types.SimpleNamespace(out=out, kept=True, cases=[]))


def test_kept_cases_are_shown_beside_those_of_a_quick_run(out, monkeypatch):
    kept = chapter.kept_cases(out)
    assert list(kept) == ["cl_1000_0.2", "hm_1000_0.2", "hm_1000_1", "hm_1000_8"] and len(kept["hm_1000_1"].steps) == 2
    monkeypatch.setattr(chapter, "kept_cases", lambda folder: kept)
    shown = []
    monkeypatch.setattr(Undrawn, "curves", lambda self, name, *panels, **_: shown.extend(run.name for panel in panels for run in panel.runs))
    study = build(out, "hm_1000_0.2")
    named = {"1000 grains, full size", "thesis's error", "identified at full size", "Hertz–Mindlin"}
    assert "identified" in study._drawings and named <= set(shown)


def test_rates_of_loading_are_compared_set_by_set(out):
    fast, slow = out / "fast", out / "slow"
    for folder, more in ((fast, 0), (slow, 0.2)):
        write_case(folder, "hm_1000_0.2", 2, scale=1 + more)
        strains = numpy.repeat(rates.STRAINS, 2)
        write(folder / "hm_1000_0.2/check_curves.tsv", id=("1", [0, 1, 0, 1, 0, 1, 10]), strain_axial=("%", [*strains, rates.STRAINS[0]]),
              stress_ratio=("1", [3 + more, 3.2 + more, 4, 4, 4, 4, 9]), strain_volumetric=("%", [0.1] * 7))
    table = rates.table(fast, slow, 2, ["hm_1000_0.2"]).splitlines()
    assert table[1] == "Hertz–Mindlin\tidentified E\tGPa\t4\t0.2\t4.8\t0.24"
    assert table[6] == "Hertz–Mindlin\tstress ratio at 1.02 %, set of the study's rate\t1\t3.1\t0.14\t3.3\t0.14" and len(table) == 12
    write(fast / "hm_1000_0.2/check_curves.tsv", id=("1", [0]), strain_axial=("%", [rates.STRAINS[0]]), stress_ratio=("1", [3]),
          strain_volumetric=("%", [0.1]))
    with pytest.raises(StudyError, match=r"at 1.02 % of axial strain there are 1 runs of the identified set"):
        rates.table(fast, slow, 2, ["hm_1000_0.2"])


def test_the_table_of_cases_tells_sets_failed_runs_and_what_was_identified(out, tmp_path):
    columns = chapter.case_table([Case(out, "hm_1000_0.2", 2), Case(out, "hm_1000_8", 2)])
    assert {head: cells[0] for head, cells in columns.items()} == {
        "case": "Hertz–Mindlin, 1000 grains, 0.2 MPa", "sets, round by round": "6, 4", "failed runs": "1", "effective sets, first round": "1",
        "effective sets, all rounds": "2", "E (GPa)": "4 ± 0.2", "ν": "0.1 ± 0.005", "rolling stiffness": "0.15 ± 0.0075", "rolling limit": "0.2 ± 0.01",
        "friction angle (deg)": "30.3 ± 1.5"}
    assert columns["E (GPa)"][1] == "5 ± 0.25" and all(len(cells) == 2 for cells in columns.values())
    # One set has all the weight: what is left of the deviation is less than the mean shows.
    table = out / "hm_1000_8/round2_steps.tsv"
    table.write_text(table.read_text().replace(repr(0.05 * 1.25 * ANSWER["young_modulus"]), "3.8e-9"))
    assert chapter.case_table([Case(out, "hm_1000_8", 2)])["E (GPa)"] == ["5 ± 0"]
    for name, fates in (("one", [0, 4, 0]), ("two", [0, 4, 0, 4])):
        write(tmp_path / f"{name}.tsv", id=("1", range(len(fates))), fate=("1", fates))
    assert inputs.rounds([tmp_path / "one.tsv", tmp_path / "two.tsv"]) == "round [1]\tsets [1]\tfailed [1]\n1\t3\t1\n2\t4\t2\n"


def write_loaded(folder, sets, ratio, steps):
    """Writes the curves of the runs of so many sets, and their series, as ch2-loading leaves them; the last set ends early."""
    for name in loading.LOADINGS:
        ids = [number for number in range(sets) for strain in loading.STRAINS[:1 if number == sets - 1 else 3]]
        strains = [strain for number in range(sets) for strain in loading.STRAINS[:1 if number == sets - 1 else 3]]
        write(folder / f"{name}.tsv", id=("1", ids), strain_axial=("%", strains), stress_ratio=("1", [ratio[name] + 0.04 * number for number in ids]),
              strain_volumetric=("%", [0.1 * ratio[name]] * len(ids)))
        for number in range(sets):
            run = folder / f"{name}/runs/{number:06d}"
            run.mkdir(parents=True)
            with h5py.File(run / "series.h5", "w") as file:
                file["fields/series/step"] = [0, steps[name] + 100 * number]


def test_loadings_are_compared_over_the_sets_that_ran_under_each(tmp_path):
    ratio, steps = {"study": 4.0, "plain": 3.8, "slow": 4.0}, {"study": 1000, "plain": 2000, "slow": 5000}
    write_loaded(tmp_path / "hm_1000_0.2", 3, ratio, steps)
    head, study, plain, slow = [line.split("\t") for line in loading.table(tmp_path, ["hm_1000_0.2"]).splitlines()]
    assert len(head) == len(study) == 10 and head[4] == "stress ratio at 1.02 %, difference from slow (% of it)"
    assert study[2:5] == ["2", "1050", "+0 ± 0"] and slow[2:] == ["2", "5050", *"000000"]
    assert plain[:4] == ["Hertz–Mindlin", "10 %/s, without", "2", "2050"] and plain[4] == "-5 ± 0.02" and plain[7] == "-0.02 ± 0"
    (tmp_path / "hm_1000_0.2/slow/runs/000001/series.h5").unlink()
    with pytest.raises(StudyError, match=r"slow/runs/000001/series.h5: has no series"):
        loading.table(tmp_path, ["hm_1000_0.2"])
    write_loaded(tmp_path / "cl_1000_0.2", 2, ratio, steps)
    with pytest.raises(StudyError, match="1 sets ran under every loading; two give a standard error"):
        loading.table(tmp_path, ["cl_1000_0.2"])


def test_the_appendix_tells_how_the_kept_response_depends_on_the_rate():
    rows = [line.split("\t") for line in (chapter.HERE / "kept/rates_quick.tsv").read_text().splitlines()]
    ratios = [float(row[5]) / float(row[3]) - 1 for row in rows if row[1].startswith("stress ratio")]
    words = (chapter.HERE / "words.toml").read_text()
    assert f"{100 * min(ratios):.0f} to {100 * max(ratios):.0f} % higher" in words and len(ratios) == 6
    volumes = [abs(float(row[5]) - float(row[3])) for row in rows if row[1].startswith("volumetric strain")]
    assert f"differs by at most {max(volumes):.1f} %" in words


def test_the_appendix_tells_how_many_steps_the_kept_loading_saves_for_the_same_response():
    rows = [line.split("\t") for line in (chapter.HERE / "kept/loading_thesis.tsv").read_text().splitlines()[1:]]
    words = (chapter.HERE / "words.toml").read_text()
    for law, of in (("Hertz–Mindlin", "{} % of the steps with Hertz–Mindlin contacts"), ("linear", "{} % with linear ones")):
        study, plain, _ = (row for row in rows if row[0] == law)
        assert of.format(f"{100 * float(study[3]) / float(plain[3]):.0f}") in words
        for own, without in zip(study[4:], plain[4:], strict=True):
            (mean, error), (other, beside) = ([float(number) for number in cell.split(" ± ")] for cell in (own, without))
            assert abs(mean) <= abs(other) + max(error, beside)  # "at least as near"


def settled(strain, friction, published):
    """Returns the strain from which the friction angle stays within 0.1 degrees of the published one, to the end."""
    return strain[strain > strain[abs(friction - published) >= 0.1][-1]][0]


@pytest.mark.parametrize(("law", "words_of_law"), [("hm", "Hertz–Mindlin"), ("cl", "linear")])
def test_the_appendix_tells_where_the_thesis_s_sets_are_found(law, words_of_law):
    words = (chapter.HERE / "words.toml").read_text().replace("\\\n", "")
    case = Case(chapter.HERE / "kept", f"{law}_1000_0.2", 1)
    published = case.thesis()("friction_angle", "deg")[0]
    for steps in (case.folder("thesis_error"), case.steps[0]):  # the thesis's error, the study's error
        strain, friction = steps("strain_axial", "%"), steps("friction_angle", "deg")
        start = settled(strain, friction, published)
        assert f"from {start:.1f} % on with {words_of_law} contacts" in words
        assert f"to the end, at {strain[-1]:.1f} % of axial strain" in words
        assert steps("effective_size", "1")[strain >= start].max() < 1.1  # "one set has nearly all the weight"


def test_reasons_tell_which_sets_later_rounds_find_and_how_these_agree():
    words = (chapter.HERE / "words.toml").read_text().replace("\\\n", "")
    case = Case(chapter.HERE / "kept", "hm_1000_0.2", 4)
    friction, ratio = case.identified("friction_angle", "deg"), case.identified("poisson_ratio", "1")
    assert f"friction angle of {friction:.1f} degrees and a Poisson's ratio of {ratio:.2f}" in words
    assert chapter.excess(case, "near", "stress_ratio_misfit_relative") < 0 and chapter.excess(case, "near", "strain_volumetric_misfit") < 0
    case = Case(chapter.HERE / "kept", "cl_1000_0.2", 4)
    assert f"friction angle of {case.identified('friction_angle', 'deg'):.1f} degrees, whose RMS" in words
    strain, friction = case.steps[-1]("strain_axial", "%"), case.steps[-1]("friction_angle", "deg")
    assert "all weight is on it at 7.1 % of axial strain" in words
    assert abs(friction - case.thesis()("friction_angle", "deg")[0])[abs(strain - 7.1).argmin()] < 0.01
    near = case.folder("check_near")
    own = near("id", "1") < 10  # the twins of the identified set; those of the thesis's are numbered from 10 on
    volume, stress = near("strain_volumetric_misfit", "%"), near("stress_ratio_misfit", "1")
    assert f"volumetric strain is {volume[own].mean():.3f} % (the thesis's set: {volume[~own].mean():.3f} %)" in words
    assert f"is smaller (RMS {stress[own].mean():.3f}) than that of the thesis's set ({stress[~own].mean():.3f})" in words
    assert chapter.excess(case, "near", "stress_ratio_misfit_relative") > 0


@pytest.mark.parametrize("name", ["cl_2000_0.2", "hm_5000_0.2"])
def test_a_reason_tells_that_the_thesis_s_set_is_better_than_those_of_a_case_of_few_sets(name):
    words = (chapter.HERE / "words.toml").read_text().replace("\\\n", "")
    words = words[words.index(f'of = ["friction_angle_{name}"]'):]
    case = Case(chapter.HERE / "kept", name, 3)
    (own, thesis), (own_volume, thesis_volume) = ([chapter.misfit(case, "near", column, which=k)[0] for k in (0, 1)]
                                                  for column in ("stress_ratio_misfit_relative", "strain_volumetric_misfit"))
    told = words[:words.index("[[reason]]")]
    assert f"stress ratio {thesis:.1f} %, of the volumetric strain {thesis_volume:.2f} %) than the set" in told
    assert f"identified ({own:.1f} %, {own_volume:.2f} %)" in told


def test_inputs_are_what_runs_and_filter_read(out, tmp_path):
    failure = tmp_path / "failure.tsv"
    write(failure, confining_pressure=("kPa", [200, 1000]), obliquity_at_failure=("1", [1.5, 1.2]))
    assert inputs.peak(failure, 0.2) == "confining_pressure [kPa]\tstress_ratio_peak [1]\n200\t4\n"
    with pytest.raises(StudyError, match="none of the rows"):
        inputs.peak(failure, 0.3)
    table = inputs.sets([out / "hm_1000_0.2/round1_steps.tsv", "data/contacts/toyoura_hm_0.2MPa.tsv"], 2).splitlines()
    assert table[0] == "id [1]\tyoung_modulus [Pa]\tpoisson_ratio [1]\trolling_stiffness [1]\trolling_limit [1]\tfriction_angle [deg]\ttwin [1]"
    assert table[1] == "0\t4000000000.0\t0.1\t0.15\t0.2\t30.3\t0" and table[4] == "11\t4123000000.0\t0.0635\t0.1479\t0.202\t30.39\t1"
    (tmp_path / "sets.tsv").write_text("\n".join(table))
    assert [row[0] + row[-1] for row in ensemble.read_rows(tmp_path / "sets.tsv")] == ["00", "11", "100", "111"]


@pytest.mark.parametrize(("text", "rows"), [
    ("id\tE\tnu\tkr\teta\tmu\r\n# x\r\n\r\n007\t1\t2\t3\t4\t5\r\n000\t1\t2\t3\t4\t5", [["7", *"12345", "0"], ["0", *"12345", "0"]]),
    ("\ufeffid [1]\tE [Pa]\tnu\tkr\teta\tmu\tlog\ttwin [1]\r8\t1\t2\t3\t4\t 5\t9\t2\r", [["8", *"12345", "2"]]),
])
def test_rows_are_read_with_any_line_ends_and_padded_ids(tmp_path, text, rows):
    (tmp_path / "sets.tsv").write_bytes(text.encode())
    assert ensemble.read_rows(tmp_path / "sets.tsv") == rows


def test_an_ensemble_knows_which_rows_are_finished_and_how_long_the_others_take(tmp_path):
    rows = [[str(k), *"12345", "0"] for k in range(4)]
    some = ensemble.Ensemble("sets", tmp_path / "case", ["case", "hm", "p.h5", "s.toml", "0.2", "6"], rows)
    for k, (result, parameters) in enumerate((("series.h5", "hm 0.2 6 1 2 3 4 5 0"), ("failed", "hm 0.2 6 1 2 3 4 5 0"),
                                              ("series.h5", "hm 0.5 6 1 2 3 4 5 0"))):
        some.of_row(rows[k], "").mkdir(parents=True)
        some.of_row(rows[k], result).write_text("out of range\n")
        some.of_row(rows[k], "parameters").write_text(parameters + "\n")
    assert some.unfinished() == rows[2:] and some.failed() == [rows[1]]
    assert some.progress(1, 60) == "  case: 2 of 4 runs, 1 failed, 2 min left, 60 runs/h"
    assert some.progress(2, 60) == "  case: 2 of 4 runs, 1 failed"


def test_an_array_job_s_tasks_share_the_rows(tmp_path, monkeypatch):
    names = ["a", "b c", "d", "e"]
    (tmp_path / "jobs").write_text("".join(f"touch\t{tmp_path}/{name}\n" for name in names))
    monkeypatch.setenv("SLURM_ARRAY_TASK_ID", "1")
    assert jobs.task(tmp_path / "jobs", "2") == 0
    assert sorted(path.name for path in tmp_path.iterdir() if path.is_file() and path.name in names) == ["b c", "e"]


def test_what_an_ensemble_needs_is_named_in_one_line(tmp_path):
    run = subprocess.run([ROOT / "pipelines/calibration/ensemble.sh", "sets.tsv"], capture_output=True, text=True, check=False,
                         env={"BIN": str(tmp_path), "PATH": os.environ["PATH"]})
    assert run.returncode == 64 and run.stderr.count("\n") == 1 and "usage: BIN=build/bin ensemble.sh TABLE.tsv" in run.stderr
