"""Chapter 3: its measures on small tables by hand, and on its kept full-size runs."""
# SPDX-License-Identifier: GPL-3.0-or-later
import io
import math
import re
import sys
import tomllib
import types

import numpy
import pytest
from ch3 import breaks, compression, drawing, loadings, making, pictures, shear, variants
from ch3 import study as chapter
from ch3.bag import HERE, Bag, Record, Runs
from matplotlib import pyplot
from renaming import demand_columns
from study import NotMade, Series, Study, StudyError, Table, figures, read_statements
from study.quantities import QUANTITIES
from study.tables import read_words

SI = {"mm": "m", "cm": "m", "kPa": "Pa", "%": "1"}


def write(path, units, **columns):
    """Writes a table of columns of equal length. A single number fills its whole column."""
    length = max(numpy.size(values) for values in columns.values())
    rows = zip(*(numpy.broadcast_to(values, length) for values in columns.values()), strict=True)
    head = "\t".join(f"{name} [{units[name]}]" for name in columns)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join([head, *("\t".join(repr(float(x)) for x in row) for row in rows)]) + "\n")
    return Table.read(path)


def bag(path, **columns):
    """Writes the loading of a bag, in SI units; columns that are not given are 1."""
    units = {name: SI.get(line.unit, line.unit) for name, line in QUANTITIES.items()}
    given = {"step": numpy.arange(numpy.size(columns["strain_axial"])), "broken_yarns": 0} | columns
    return write(path, units, **{name: 1 for name in units} | given)


def loaded(path, **columns):
    """Returns a bag without groups and fabric."""
    def absent(_):
        raise NotMade("not recorded")
    return Bag(bag(path, **columns), absent)


@pytest.fixture(name="compressed")
def compressed_bag(tmp_path):
    return loaded(tmp_path / "uc_PE.tsv", stage=[0, 0, 1, 1, 1, 1], strain_axial=[-0.01, 0, 0.01, 0.02, 0.03, 0.04],
                  plate_pressure=[0, 1e3, 5e3, 10e3, 9.9e3, 4e3], broken_yarns=[0, 0, 0, 1, 2, 9],
                  mean_stress=[0, 1e3, 2e3, 4e3, 4e3, 1e3])


def test_a_bag_counts_from_the_end_of_the_preload(compressed):
    assert list(compressed["strain_axial"]) == [0, 1, 2, 3, 4]
    assert (compressed.broken, compressed.failed) == (2, 3)
    assert compressed.before_end(3, "failure") == 3
    with pytest.raises(NotMade, match="failure does not come before 4 %"):
        compressed.before_end(4, "failure")
    with pytest.raises(NotMade, match="no station at 5 %"):
        compressed.step_at(5)


def test_a_value_is_where_another_one_first_comes_to_it_and_nowhere_else(compressed):
    assert compressed.where("plate_pressure", 5, "strain_axial") == 1
    assert compressed.where("plate_pressure", 7.5, "strain_axial") == pytest.approx(1.5)
    assert compressed.where("strain_axial", 0, "plate_pressure") == 1
    for at in (10.1, 0.5):
        with pytest.raises(StudyError, match=f"uc_PE.tsv: plate_pressure does not come to {at} from below"):
            compressed.where("plate_pressure", at, "strain_axial")


def test_the_first_break_is_told_only_where_there_was_one(tmp_path, compressed):
    assert compression.first_break(compressed, None) == 100
    whole = loaded(tmp_path / "whole.tsv", stage=[0, 1], strain_axial=[0, 0.1], first_break_strain=math.nan)
    with pytest.raises(NotMade, match="no yarn breaks before 10 %"):
        compression.first_break(whole, None)


def test_what_is_left_after_failure_is_compared_where_the_shorter_series_ends(tmp_path, compressed):
    record = Record(write(tmp_path / "record.tsv", {"strain_axial": "%", "plate_pressure": "kPa"}, strain_axial=[0, 2, 3.5],
                          plate_pressure=[1, 20, 10]))
    assert compression.left_over(compressed, record, "plate_pressure") == pytest.approx((9.9 - 5.9 / 2) / 10 / (10 / 20))


def test_groups_are_those_in_the_middle_and_the_two_at_the_edges(tmp_path):
    groups = write(tmp_path / "groups.tsv", {"step": "1", "mean_stress": "Pa"}, step=[0] * 4 + [1] * 4,
                   mean_stress=[1, 2, 4, 3, 1, 2, 2, 1])
    one = Bag(bag(tmp_path / "uc.tsv", stage=[0, 1], strain_axial=[0, 0.01]), lambda _: groups)
    assert one.middle_over_edge("mean_stress", 0) == 3 / 2 and one.middle_over_edge("mean_stress", 1) == 2


def test_contacts_are_spread_alike_if_cumulative_shares_differ_by_less_than_chance():
    one, other = numpy.array([5, 3, 2]), numpy.array([10, 10])
    assert making.distance(one, other) == pytest.approx(0.2)
    assert making.chance(one, other) == pytest.approx(1.358 * math.sqrt(1 / 10 + 1 / 20))


SERIES = {"force_right_y": "N", "yarn_tension_face": "N", "displacement_right_y": "m", "stage": "1", "force_left_x": "N",
          "force_right_x": "N", "force_lid_z": "N", "displacement_left_x": "m"}


def strip(path):
    return write(path, SERIES, force_right_y=[0, -21, -100], yarn_tension_face=[0, 4.2, 20], displacement_right_y=[0, 0.001, 0.005])


def box(path, held=1.0):
    return write(path, SERIES, stage=[0, 1, 1, 1], force_left_x=[0, -100, -500 * held, -500 * held], force_right_x=0,
                 force_lid_z=[-500, -500, -500, -500], displacement_left_x=[0, 0.001, 0.002, 0.003])


def test_strips_and_boxes_are_measured(tmp_path):
    assert making.Strip(strip(tmp_path / "strip.tsv")).stiffness("PE") == pytest.approx(1)
    assert making.Strip(strip(tmp_path / "strip.tsv")).strength() == 20
    assert making.Box(box(tmp_path / "box.tsv")).friction() == pytest.approx(45)


YARNS = {"step": "1", "family": "1", "position_x": "m", "position_y": "m", "position_z": "m", "direction_x": "1", "direction_y": "1",
         "length": "m", "tension": "N", "broken": "1"}


def yarns(path, step=0):
    return write(path, YARNS, step=step, family=[0, 0, 1, 2], position_x=[0.2, -0.05, 0.2, 0.2], position_y=[0, 0.1, 0, 0],
                 position_z=[0.04, 0.04, 0.02, -0.04], direction_x=1, direction_y=0, length=0.005, tension=3, broken=[0, 1, 1, 0])


def test_breaks_are_as_near_the_seam_as_the_outermost_yarn_lets_them(tmp_path):
    table = breaks.breaks(yarns(tmp_path / "yarns.tsv"))
    assert list(table["x [mm]"]) == [-50, 200] and list(table["seam [1]"]) == [0.5, 0.5]


def test_shear_is_measured_by_hand(tmp_path):
    s = shear.Shear(loaded(tmp_path / "ss.tsv", stage=[0, 1, 1, 2, 2], strain_axial=0, settlement=[0, 2e-3, 1e-3, 0, -1e-3],
                           plate_shear=[0, -2e3, -4e3, -3e3, -4e3], plate_ratio=[0, 0.2, 0.4, 0.3, 0.4], shear_stress=[0, -1e3, -3e3, -2e3, -2e3],
                           axial_stress=1e4, lateral_stress=[1e3, 1e3, 2e3, 2e3, 3e3], step=[0, 1, 2, 3, 4]))
    assert (s.peak, s.thinnest, s.state()) == (2, 1, 2)
    assert s.lag(-1) == pytest.approx(0.2) and s.over_before("lateral_stress") == 2 and s.dilated() == pytest.approx(3)
    assert s.unsteadiness() == pytest.approx(math.sqrt((1.5**2 + 1) / 2) / 3.5)


def test_measures_of_loads_that_are_not_there_are_not_made(tmp_path):
    study = Study("ch3", "", tmp_path, "quick")
    shear.measure(study, Runs(tmp_path, False, absent="not run"))
    assert {m.value for m in study.measures.values()} == {None}
    assert study.measures["shear_lag"].reason == "no bag is sheared"


def test_a_table_that_is_missing_is_an_error_unless_runs_may_be(tmp_path):
    with pytest.raises(StudyError, match="uc_PE.tsv: cannot be read"):
        Runs(tmp_path, False).bag("uc_PE")
    with pytest.raises(NotMade, match="uc_PE: not run"):
        Runs(tmp_path, False, absent="not run").bag("uc_PE")


def arguments(out, kept):
    return types.SimpleNamespace(out=out, profile="quick", kept=kept, loads=[])


def test_what_is_kept_of_full_size_gives_the_comparison_that_is_kept(tmp_path, monkeypatch):
    monkeypatch.setattr(chapter, "OF_ALL", ())
    for path in (HERE / "kept").glob("*.tsv"):
        (tmp_path / path.name).write_text(path.read_text())
    chapter.build(arguments(tmp_path, kept=True)).write_tables()
    for name in ("comparison", "checklist", "measured"):
        assert (tmp_path / f"{name}.tsv").read_text() == (HERE / "kept" / f"{name}.tsv").read_text()


def test_statements_say_something_of_their_own():
    descriptions = [s.description for path in ("expected.tsv", "statements.tsv") for s in read_statements(HERE / path)]
    assert len(set(descriptions)) == len(descriptions)
    bare = [s.name for s in read_statements(HERE / "statements.tsv") if s.relation != "within" and float(s.published) == 0]
    assert bare == []  # a change without a margin


def small_runs(folder):
    """Writes strips, boxes and pictures into a folder, beside the bag that is kept."""
    for g in ("PE", "PP"):
        strip(folder / f"strip_{g}.tsv")
    for angle in (21, 25):
        box(folder / f"box_{angle}.tsv", angle / 25)
    step = int(Runs.kept().bag("uc_PE").step_at(12))
    for k in pictures.STATES:
        yarns(folder / f"uc_PE_yarns_{k}.tsv", step)
        grains = {"position_x": "m", "position_y": "m", "position_z": "m", "radius": "m", "copy": "1", "strain_deviatoric": "1"}
        write(folder / f"uc_PE_grains_{k}.tsv", grains, position_x=[0, 0.1], position_y=0, position_z=0, radius=0.002, copy=[-1, 0],
              strain_deviatoric=[math.nan, 0.1])
    for name in ("uc_PE", "uc_PE_breaks"):
        (folder / f"{name}.tsv").write_text((HERE / "kept" / f"{name}.tsv").read_text())
    (folder / "uc_PE_rough_breaks.tsv").write_text((HERE / "kept/uc_PE_breaks.tsv").read_text())


class Undrawn(Study):
    """A study whose figures are made and not rendered, which takes most of the time. It notes which the page has words for."""

    def figure(self, name, *_, **__):
        pyplot.close("all")
        if self._texts:
            self._texts.figure(name)

    def picture(self, *_, **__):
        pyplot.close("all")


def test_each_column_that_the_chapter_reads_is_missed_by_name(tmp_path, monkeypatch):
    def drawn(draw, runs):
        return lambda: draw(Undrawn("ch3", "", tmp_path, "quick"), runs(), None)
    monkeypatch.setattr(figures, "png", lambda *_: None)
    small_runs(tmp_path)

    def small():
        return Runs(tmp_path, False, absent="not run")
    def measured(measure):
        return lambda: measure(Study("ch3", "", tmp_path, "thesis"), Runs.kept())
    readers = [*map(measured, (making.measure, shear.measure, compression.measure_breaks, compression.measure)),
               lambda: making.Strip(small().table("strip_PE")).stiffness("PE"),
               lambda: [making.Box(small().table(f"box_{angle}")).friction() for angle in making.FRICTION],
               lambda: [making.Strip(small().table(f"strip_{g}")).strength() for g in ("PE", "PP")],
               lambda: breaks.breaks(small().table("uc_PE_yarns_1"))]
    _, (axes,) = figures.panels(1)
    for k in pictures.STATES:
        readers += [lambda k=k: pictures.section(axes, small().table(f"uc_PE_grains_{k}")),
                    lambda k=k: pictures.face(axes, small().table(f"uc_PE_yarns_{k}"))]
    readers += [drawn(draw, Runs.kept) for draw in chapter.OF_ALL]
    readers += [drawn(draw, small) for draw in chapter.OF_RUNS]
    assert demand_columns(readers) > 150


def test_the_page_has_words_for_all_and_numbers_in_them(tmp_path, monkeypatch):
    class Kept:
        """The kept runs, whichever folder is asked for."""
        kept = Runs.kept

        def __new__(cls, *_):
            return Runs.kept()
    monkeypatch.setattr(chapter, "Study", Undrawn)
    monkeypatch.setattr(chapter, "Runs", Kept)
    monkeypatch.setattr(chapter, "OF_RUNS", ())
    (tmp_path / "provenance.txt").write_text("made\n")
    study = chapter.build(arguments(tmp_path, kept=False))
    said = f"{study.lead}{study.headline}{study.remarks}{study._reasons}{study.appendices}"
    assert "{" not in said.replace("{'", "") and "}" not in said.replace("'}", "") and "(6" in study.lead
    assert len(study.appendices) == 5 and re.search(r"axial stress in PE differs from the recorded one by \d+ to \d+ %", said)


def stations(folder, stress, **columns):
    bag(folder / "uc_PE.tsv", stage=[0] + [1] * 8, strain_axial=numpy.arange(9) / 100, axial_stress=[100] + [1000 * stress * k for k in range(1, 9)],
        plate_pressure=[100] + [1000 * stress * k for k in range(1, 9)], **columns)


def test_fast_plates_are_beside_slow_ones_up_to_the_first_break(tmp_path):
    stations(tmp_path / "fast", 1, broken_yarns=[0, 0, 0, 1, 1, 1, 1, 1, 1])
    stations(tmp_path / "slow", 2)
    assert variants.rates(tmp_path / "fast", tmp_path / "slow") == (
        "axial strain [%]\tfast [kPa]\tslow [kPa]\tdifference [%]\n1\t1.00\t2.00\t-50.00\n2\t2.00\t4.00\t-50.00\n3\t3.00\t6.00\t-50.00\n")


def test_variants_are_told_as_differences_from_the_bag(tmp_path):
    stations(tmp_path / "bag", 2, broken_yarns=[0] * 8 + [1])
    stations(tmp_path / "loose", 1, void_ratio=0.7)
    header, first, second = variants.table(tmp_path, ["bag", "loose"]).splitlines()
    assert header.split("\t")[:4] == ["variant", "what is varied", "void ratio under the preload", "load at 1 % [kPa]"]
    assert first.split("\t")[3:5] == ["2.0", "+0.0"] and first.split("\t")[-4:] == ["8", "none", "none", "none"]
    assert second.split("\t")[2:5] == ["0.7000", "1.0", "-50.0"] and second.split("\t")[-4] == "none"
    with pytest.raises(StudyError, match=r"has no variant lose; did you mean 'loose'"):
        variants.cell("lose", "seed")
    assert variants.options("round_sides", "bag") == "--set container.width=0.374336 --set container.side_radius=0.04"


def test_new_variants_replace_those_of_their_name_and_others_stay():
    kept = "variant\tload\nbag\t1\nfast\t9\nseed_2\t5\n"
    assert variants.merge("variant\tload\nbag\t1\nfast\t2\n", kept, "kept") == "variant\tload\nbag\t1\nfast\t2\nseed_2\t5\n"
    assert variants.merge("== fast\nnew\n", "== fast\nold\n== seed_2\nkept\n", "kept") == "== fast\nnew\n== seed_2\nkept\n"
    other = kept.replace("bag\t1", "bag\t3")
    with pytest.raises(StudyError, match="kept: is of another bag"):
        variants.merge("variant\tload\nbag\t1\nfast\t2\n", other, "kept")
    assert variants.merge("variant\tload\nbag\t1\nfast\t2\n", other.replace("seed_2\t5\n", ""), "kept") == "variant\tload\nbag\t1\nfast\t2\n"


def test_bags_are_beside_one_another_with_mean_and_deviation(tmp_path, monkeypatch):
    class Told:
        def __init__(self, measured):
            self.measured = measured
            self.statement = read_statements(HERE / "expected.tsv")[0]
    told = {"bag": {"load": Told("9"), "failure": Told("1"), "slope": Told("7")}, "one": {"load": Told("1")}, "two": {"load": Told("4")}}
    monkeypatch.setattr(variants, "verdicts", lambda folder: told[folder])
    assert variants.beside(["bag", "one", "two"], scatter=True, apart=True).splitlines() == [
        "description\tunit\tpublished\ttolerance\tbag\tone\ttwo\tmean\tdeviation", "load\t1\t0.675\t± 0.005\t9\t1\t4\t2.5\t2.1"]
    assert variants.beside(["own=bag", "one"], scatter=True).splitlines()[1].endswith("\t9\t1\t5\t5.7")


def test_the_variants_of_a_run_are_judged_as_the_study_is():
    of = variants.verdicts(HERE / "kept")
    kept = dict(line.split("\t")[:5:4] for line in (HERE / "kept/comparison.tsv").read_text().splitlines())
    assert of["axial strain of the first broken yarn, PE"].measured == kept["axial strain of the first broken yarn, PE"]


def test_the_commands_of_study_mk_end_in_one_line_where_they_cannot(capsys, monkeypatch):
    monkeypatch.setattr(sys, "argv", ["variants", "options", "nothing", "bag"])
    with pytest.raises(SystemExit) as end:
        variants.main()
    assert end.value.code == 65 and capsys.readouterr().err.count("\n") == 1
    monkeypatch.setattr(sys, "argv", ["variants", "merge", "/nonexistent/kept.tsv"])
    monkeypatch.setattr(sys, "stdin", io.StringIO("variant\tload\n"))
    variants.main()
    assert capsys.readouterr().out == "variant\tload\n"


def loads(folder, geotextile, loading, by, steps):
    """Writes a bag whose load rises by `by` kPa at each per cent up to 14 %, in steps of `steps`, and then falls."""
    pressure = [1000 * by * k for k in range(15)] + [0]
    bag(folder / f"{geotextile}_{loading}.tsv", stage=[0] + [1] * 15, strain_axial=numpy.arange(16) / 100, plate_pressure=pressure,
        step=100 + steps * numpy.arange(16))


def test_loadings_are_compared_by_the_mean_over_volumes(tmp_path):
    for volume, fast in (("4", 9), ("5", 7)):
        for geotextile in ("PE", "PP"):
            for loading, by, steps in (("slow", 10, 30), ("fast", fast, 20), ("study", 10, 5)):
                loads(tmp_path / volume, geotextile, loading, by, steps)
    told = loadings.stresses(tmp_path, ["4", "5"]).splitlines()
    assert told[1] == "PE\t1\t2\t10.0\t-20.00\t10.00\t+0.00\t0.00" and told[-1] == "PP\tgreatest\t2\t140.0\t-20.00\t10.00\t+0.00\t0.00"
    assert loadings.stresses(tmp_path, ["4"]).splitlines()[1] == "PE\t1\t1\t10.0\t-10.00\tnone\t+0.00\tnone"
    assert [line.split("\t")[:2] for line in loadings.COMMANDS["start"](tmp_path, "4", "5").splitlines()[1:]] == [["PP", "1"], ["PP", "2"]]
    assert loadings.steps(tmp_path, ["4", "5"]).splitlines()[1:4] == ["PE\tslow\t360\t1.500", "PE\tfast\t240\t1.000", "PE\tstudy\t60\t0.250"]


def test_a_volume_without_a_greatest_load_is_left_out_and_named(tmp_path, capsys, monkeypatch):
    for geotextile in ("PE", "PP"):
        for loading in ("slow", "fast", "study"):
            loads(tmp_path / "4", geotextile, loading, 10, 5)
            loads(tmp_path / "5", geotextile, loading, 20, 5)
    bag(tmp_path / "5" / "PE_fast.tsv", stage=[0] + [1] * 6, strain_axial=numpy.arange(7) / 100, plate_pressure=numpy.arange(7))
    told = loadings.stresses(tmp_path, ["4", "5"]).splitlines()
    assert told[6].startswith("PE\tgreatest\t1\t140.0") and told[12].startswith("PP\tgreatest\t2\t210.0") and told[1].startswith("PE\t1\t2\t")
    assert capsys.readouterr().err == "study: volume 5 is left out of the greatest loads: the greatest plate pressure does not come before 6 %\n"
    monkeypatch.setattr(sys, "argv", ["loadings", "stresses", str(tmp_path), "5"])
    with pytest.raises(SystemExit) as end:
        variants.main(loadings.COMMANDS)
    assert end.value.code == 65 and "C3L_END in loadings.mk" in capsys.readouterr().err


def test_a_series_of_another_unit_is_refused(tmp_path):
    series = Series(write(tmp_path / "run.tsv", {"axial_stress": "N"}, axial_stress=[1]))
    with pytest.raises(StudyError, match="run.tsv: column axial_stress: 'N' is a unit of force, 'kPa' of stress"):
        series["axial_stress"]  # pylint: disable=pointless-statement


def test_a_span_of_equal_values_is_one_value():
    row = "slope of the path in p and q up to the first break, PE"
    assert " to " not in chapter.span(row, bags=["bag"]) and " to " in chapter.span(row, digits=4)


def test_the_page_says_that_bags_of_other_volumes_were_loaded_otherwise():
    kept, words = HERE / "kept", (HERE / "words.toml").read_text()
    judged = {row["description"]: row["measured"] for _, row in read_words(kept / "comparison.tsv")[1]}
    for name in ("bulging_thesis", "seeds_thesis"):
        rows = [row for _, row in read_words(kept / f"{name}.tsv")[1]]
        if any(row["bag"] != judged[row["description"]] for row in rows):
            assert '"bag" differs from the run that is judged above' in words
            assert "way_unbalanced_force" in (kept / "uc_PE.txt").read_text() and "way_unbalanced_force" not in (kept / f"{name}.txt").read_text()


def words():
    """Returns the text of words.toml on one line."""
    return " ".join((HERE / "words.toml").read_text().replace("\\\n", "").split())


def obliquity(least, medium, most):
    """Returns q/p of principal stresses."""
    return math.sqrt(((most - medium)**2 + (medium - least)**2 + (most - least)**2) / 2) / ((most + medium + least) / 3)


def mobilised(bag, step):
    """Returns the mean stress of the groups at a step: friction angle (deg), (σ2 - σ3)/(σ1 - σ3), q/p."""
    groups = bag._parts("groups")
    rows = groups.rows(groups["step"] == step)
    share = rows("volume", "m3") / rows("volume", "m3").sum()
    mean = {pair: (share * rows(f"stress_{pair}", "kPa")).sum() for pair in ("xx", "xy", "xz", "yy", "yz", "zz")}
    least, medium, most = numpy.linalg.eigvalsh([[mean["".join(sorted(i + j))] for j in "xyz"] for i in "xyz"])
    return math.degrees(math.asin((most - least) / (most + least))), (medium - least) / (most - least), obliquity(least, medium, most)


def test_reasons_tell_the_numbers_of_the_kept_sheared_bags():
    bags, told = {load: shear.Shear(bag) for load, bag in Runs.kept().sheared().items()}, words()
    small, large = bags[2410], bags[24100]
    before, greatest = (small.bag["lateral_stress"][row] / small.bag["axial_stress"][row] for row in (0, small.peak))
    of = {s: [mobilised(s.bag, step) for step in (s.bag["step"][0], s.state(), s.bag.last("step"))] for s in (small, large)}

    def unmoved(s):  # q/p at the friction angle at 5 %, with the intermediate stress before the shear
        ratio = (1 + math.sin(math.radians(of[s][1][0]))) / (1 - math.sin(math.radians(of[s][1][0])))
        return obliquity(1, 1 + of[s][0][1] * (ratio - 1), ratio)
    at_5 = {s: int(numpy.flatnonzero(s.bag["step"] == s.state())[0]) for s in bags.values()}
    growth = {s: s.bag.last("lateral_stress") / s.bag["lateral_stress"][at_5[s]] - 1 for s in (small, large)}
    drawn, heaviest = bags[12050], bags[36150]
    strains = [tuple(series[-1] - series[0] for series in (s.bag.table("strain_yarn_side_up", "%"), s.bag["strain_yarn_side_around"])) for s in (drawn, heaviest)]
    tensions = [(s.bag["tension_yarn_side_around"][at_5[s]], s.bag.table("tension_yarn_side_up", "N")[at_5[s]]) for s in (large, heaviest)]
    ends = {name: [s.bag.fabric(name, s.bag.last("step")) for s in bags.values()] for name in ("a_c", "a_n")}
    assert sorted(ends["a_c"]) == ends["a_c"]
    falls = [s.bag.fabric("a_c", s.state()) - end for s, end in zip(bags.values(), ends["a_c"], strict=True)]
    assert max(falls[3:]) < min(falls[:3])
    void_ratios = [s.bag.last("delaunay_void_ratio") for s in bags.values()]

    def listed(values):
        return ", ".join(f"{v:.2f}" for v in values[:-1]) + f" and {values[-1]:.2f}"
    lags = [(s.lag((len(s.bag) - 1) // 2), s.lag(-1)) for s in (bags[1330], drawn, large, heaviest)]
    said = [
        f"the lateral stress is {before:.2f} times the axial stress, as q/p = {small.bag['obliquity'][0]:.2f} in compression",
        f"at least {1 / before:.1f} times; if it only doubled, it would stay below {2 * before:.2f} times",
        f"it reaches {greatest:.2f} times the axial stress",
        "grows from {:.1f}° to {:.1f}° under 2.41 kN and from {:.1f}° to {:.1f}° under 24.1 kN".format(*(of[s][k][0] for s in of for k in (0, 1))),
        "q/p falls from {:.2f} to {:.2f} and from {:.2f} to {:.2f}".format(*(of[s][k][2] for s in of for k in (0, 1))),
        f"would mean q/p = {unmoved(small):.2f} and {unmoved(large):.2f}",
        "falls from {:.1f}° to {:.1f}° under 2.41 kN and from {:.1f}° to {:.1f}° under 24.1 kN".format(*(of[s][k][0] for s in of for k in (1, 2))),
        f"rises by {100 * growth[large]:.0f} %", f"rises by only {100 * growth[small]:.0f} %",
        f"{abs(large.bag.last('shear_stress')) / abs(large.bag['shear_stress']).max():.3f} of its greatest value",
        "halfway ({:.3f}) as at the end ({:.3f})".format(*lags[0]),
        "by {:.3f} halfway and {:.3f} at the end under 12.05 kN, by {:.3f} and {:.3f} under 24.1 kN, and by {:.3f} and {:.3f} under 36.15 kN".format(
            *(v for lag in lags[1:] for v in lag)),
        "their mean strain grows by {:.2f} % up to the end, and that of the yarns around the sides by {:.2f} %".format(*strains[0]),
        "under 36.15 kN by {:.2f} % and {:.2f} %".format(*strains[1]),
        "({:.2f} against {:.2f} N, {:.2f} against {:.2f} N)".format(*tensions[0], *tensions[1]),
        f"At the end it is {listed(ends['a_c'])} under", f"({min(void_ratios):.3f} to {max(void_ratios):.3f})", f"a_n ends at {listed(ends['a_n'])}"]
    assert list(bags) == [1330, 1870, 2410, 12050, 24100, 36150] and [part for part in said if part not in told] == []
    # The statement on yarns around the sides holds up to 5 % of shear and no longer.
    around_less_up = large.bag["tension_yarn_side_around"] - large.bag.table("tension_yarn_side_up", "N")
    assert (around_less_up[:at_5[large] + 1] > 0).all() and (around_less_up[at_5[large] + 1:] < 0).all()


def test_a_reason_tells_the_friction_on_the_faces_of_the_kept_bag():
    bag, told = Runs.kept().bag("uc_PE"), words()
    sides, faces = bag["friction_sides"][1:], bag["face_friction_z"][1:]
    assert f"with {sides.min():.1f}° to {sides.max():.1f}° from 1 % of strain on" in told and f"it is at most {faces.max():.2f}° there" in told


def test_each_variant_has_a_name_in_words_and_its_description_in_the_kept_tables():
    known = {row["name"]: row["description"] for _, row in read_words(HERE / "variants.tsv")[1]}
    names = tomllib.loads((HERE / "words.toml").read_text())["names"]
    assert sorted(names) == sorted(set(known) - {"bag"}) and len(set(names.values())) == len(names)
    for size in ("quick", "thesis"):
        for _, row in read_words(HERE / f"kept/variants_{size}.tsv")[1]:
            assert row["what is varied"] == known[row["variant"]]
