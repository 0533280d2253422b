#!/usr/bin/env python3
"""Chapter 2: contact parameters of Toyoura sand identified by the particle filter (thesis Figs. 2.1 to 2.4)."""
# SPDX-License-Identifier: GPL-3.0-or-later
import functools
import pathlib

import numpy
from ch2.inputs import LAWS, PARAMETERS
from study import Drawn, Folder, NotMade, Series, Study, StudyError, Table, figures, main, panel
from study.quantities import quantity

HERE = pathlib.Path(__file__).parent
LABORATORY = "data/laboratory/toyoura_drained_triaxial_{}MPa.tsv"
RADII = {1000: figures.BLUE, 2000: figures.ORANGE, 5000: figures.GREEN}  # colour of a number of grains
# The misfits of a checked run: name, table, column.
MISFITS = (("ratio", "near", "stress_ratio_misfit_relative"), ("volume", "near", "strain_volumetric_misfit"),
           ("ratio_whole", "whole", "stress_ratio_misfit_relative"), ("volume_whole", "whole", "strain_volumetric_misfit"))
# The cases of thesis Table 2.1.
THESIS = [f"{law}_{n}_0.2" for n in RADII for law in LAWS] + [f"{law}_1000_{p}" for p in ("0.5", "1", "2", "4", "8") for law in LAWS]


class Case:
    """The tables of pf-weight for one law, number of grains and confining pressure (MPa), round by round."""

    def __init__(self, out, name, rounds):
        self.name, (self.law, grains, self.pressure) = name, name.split("_")
        self.grains, self.folder, self.law_words = int(grains), Folder(out / name), LAWS[self.law]
        self.steps = [self.folder(f"round{r}_steps") for r in range(1, rounds + 1)]
        self.density = [self.folder(f"round{r}_density") for r in sorted({1, rounds})]
        # Where there is no curve of the laboratory, the greatest stress ratio alone is compared.
        self.curve = pathlib.Path(LABORATORY.format(self.pressure)).exists()
        self.station = ("strain_axial", "%") if self.curve else ("confining_pressure", "kPa")

    def __str__(self):
        return f"{self.law_words}, {self.grains} grains, {self.pressure} MPa"

    def identified(self, name, unit):
        """Returns the weighted mean of a parameter over the sets of all rounds, at the last station."""
        return self.steps[-1](name, unit)[-1]

    def has_thesis_error(self):
        """Returns whether the first round was weighed with the thesis's observation error."""
        return (self.folder.path / "thesis_error.tsv").exists()

    def at_peak(self, name, unit):
        """Returns the weighted mean of a parameter over the first round with the thesis's observation error, up to the laboratory's greatest
        stress ratio. Raises NotMade where these weights were not computed: only full-size runs have the thesis's sets.
        """
        self.demand_curve()
        if not self.has_thesis_error():
            raise NotMade("the thesis's sets are those of full-size runs")
        laboratory, means = Table.read(LABORATORY.format(self.pressure)), self.folder("thesis_error")
        peak = laboratory("strain_axial", "%")[laboratory("stress_ratio", "1").argmax()]
        return means(name, unit)[means("strain_axial", "%") <= peak * (1 + 1e-9)][-1]

    def thesis(self):
        """Returns the set that the thesis identified for this case, as a table of one row; None where it has none."""
        path = pathlib.Path(f"data/contacts/toyoura_{self.law}_{self.pressure}MPa.tsv")
        return Table.read(path) if path.exists() else None

    def demand_curve(self):
        """Raises NotMade where there is no curve of the laboratory."""
        if not self.curve:
            raise NotMade("no curve of the laboratory")


def case_table(cases):
    """Returns the columns of a table of cases: their sets and failed runs, effective sets after the first and the last round, and what they identified."""
    columns = {}
    for case in cases:
        rounds = case.folder("rounds")
        sets = numpy.diff(rounds("sets", "1"), prepend=0)
        row = {"case": str(case), "sets, round by round": ", ".join(f"{n:.0f}" for n in sets), "failed runs": f"{rounds('failed', '1')[-1]:.0f}",
               "effective sets, first round": f"{case.steps[0]('effective_size', '1')[-1]:.3g}",
               "effective sets, all rounds": f"{case.steps[-1]('effective_size', '1')[-1]:.3g}"}
        for name in PARAMETERS:
            unit = quantity(name).unit
            mean, deviation = case.identified(name, unit), case.identified(f"{name}_deviation", unit)
            # A deviation below the digits that are shown is one of rounding, or of a weight that counts for nothing.
            shown = f"{deviation:.2g}" if deviation > 5e-4 * abs(mean) else "0"
            row[f"{quantity(name).words} ({unit})" if unit != "1" else quantity(name).words] = f"{mean:.3g} ± {shown}"
        for head, cell in row.items():
            columns.setdefault(head, []).append(cell)
    return columns


def settling(case):
    """Returns how fast the mean friction angle moves over strain in the last 1.5 % of axial strain, over its speed in the first 1.5 %."""
    case.demand_curve()
    strain, mean = case.steps[0]["strain_axial"], case.steps[0]["friction_angle"]
    if len(strain) <= 10:
        raise NotMade("too few stations")
    way, span = abs(numpy.diff(mean)), numpy.diff(strain)
    early, late = strain[1:] <= 1.5, strain[1:] > strain[-1] - 1.5
    if way[early].sum() == 0:
        raise NotMade("the mean does not move at first")
    return (way[late].sum() / span[late].sum()) / (way[early].sum() / span[early].sum())


def misfit(case, table, column, which=0):
    """Returns the misfit (%) of a checked set, 0 the identified one, 1 the thesis's: mean and deviation over twins.

    Raises NotMade if the set was not run or all of its runs failed.
    """
    case.demand_curve()
    check = case.folder(f"check_{table}")
    own = (check["id"] // 10 == which) & (check("fate", "1") == 0)
    if not own.any():
        raise NotMade(f"no run of the {'thesis' if which else 'identified'} set of {case.name}")
    twins = check.rows(own)(column, "%")
    return twins.mean(), twins.std(ddof=1) if len(twins) > 1 else 0


def excess(case, *of):
    """Returns the misfit of the identified set less the misfit of the thesis's set."""
    return misfit(case, *of)[0] - misfit(case, *of, which=1)[0]


# Measures of a case (c): name, unit, value.
OF_A_CASE = [
    ("size_first", "1", lambda c: c.steps[0]["effective_size"][-1]),
    ("size_last", "1", lambda c: c.steps[-1]["effective_size"][-1]),
    ("settling", "1", settling),
    ("log_modulus_at_peak", "1", lambda c: numpy.log10(c.at_peak("young_modulus", "Pa"))),
    ("friction_angle_at_peak", "deg", lambda c: c.at_peak("friction_angle", "deg")),
    ("log_modulus", "1", lambda c: numpy.log10(c.identified("young_modulus", "Pa"))),
    *((name, unit, lambda c, name=name, unit=unit: (c.identified(name, unit), c.identified(f"{name}_deviation", unit)))
      for name, unit in PARAMETERS.items()),
    *((f"{name}{ending}", "%", lambda c, how=how, of=of: how(c, *of)) for name, *of in MISFITS
      for ending, how in (("", misfit), ("_thesis", functools.partial(misfit, which=1)), ("_excess", excess)))]


def change(first, last, name):
    """Returns the relative change of an identified parameter from one case to another.

    Raises NotMade if the middle 90 % of their weights overlap: the change is then not determined.
    """
    def of_both(ending):
        return [case.identified(f"{name}{ending}", PARAMETERS[name]) for case in (first, last)]
    if max(of_both("_low")) <= min(of_both("_high")):
        raise NotMade(f"not determined: the middle 90 % of the weights at {first.pressure} and {last.pressure} MPa overlap")
    before, after = of_both("")
    return after / before - 1


def measure(study, cases):
    """Measures each case, and the relative change of parameters from 0.2 to 8 MPa. It is positive in the direction of the thesis."""
    def case(name):
        if name not in cases:
            raise NotMade(f"case {name} is not among C2_CASES")
        return cases[name]
    for name in dict.fromkeys([*cases, *THESIS]):
        study.measure_each(OF_A_CASE, lambda name=name: [case(name)], f"_{name}")
    for short, name, sign in (("E", "young_modulus", 1), ("mu", "friction_angle", -1), ("kr", "rolling_stiffness", 1)):
        study.measure(f"trend_{short}", lambda name=name, sign=sign: sign * change(case("hm_1000_0.2"), case("hm_1000_8"), name), "1")


def kept_cases(folder):
    """Returns the cases of full-size runs whose tables are kept in a folder, by name: the thesis's in the order of Table 2.1, then others."""
    there = [path.parent.name for path in sorted(folder.glob("*/round1_steps.tsv"))]
    return {name: Case(folder, name, len(list((folder / name).glob("round*_steps.tsv")))) for name in dict.fromkeys([*THESIS, *there]) if name in there}


def draw_identified(study, cases, kept):
    """Draws the answer: each identified parameter over the thesis's value."""
    known = [case for case in cases if case.curve and case.thesis()]
    if not known:
        return "the parameters beside the thesis's, which has none for these cases"
    rows = -(-len(known) // 2)
    figure, axes = figures.panels(min(len(known), 2), rows, height=3 * rows)
    for a in axes[len(known):]:
        a.remove()
    for a, case in zip(axes, known, strict=False):
        thesis = case.thesis()
        of_both = [(case, figures.BLUE, "this run", 0)]
        if case.name in kept:
            of_both.append((kept[case.name], figures.GREEN, "full size", 0.25))
        for k, (name, unit) in enumerate(PARAMETERS.items()):
            given = thesis(name, unit)[0]
            for of, colour, words, lower in of_both:
                ends = [of.steps[-1](f"{name}{end}", unit)[-1] / given for end in ("_low", "_high")]
                a.plot(ends, [k + lower] * 2, color=colour, linewidth=3, alpha=0.4)
                a.plot(of.identified(name, unit) / given, k + lower, "o", color=colour, label="" if k else words)
        a.axvline(1, color=figures.INK, linewidth=1)
        a.set_xscale("log", base=2)
        a.xaxis.set_major_formatter("{x:g}")
        a.set_yticks(range(len(PARAMETERS)), [quantity(name).words for name in PARAMETERS])
        a.invert_yaxis()
        figures.label(a, "identified over the thesis's", "", ["identified over the thesis's", ""])
        a.set_title(str(case))
        if len(of_both) > 1:
            a.legend()
    study.figure("identified", figure)
    return None


def draw_means(law, number):
    """Returns the function that draws Fig. 2.1 or 2.2: weighted means over axial strain at 0.2 MPa."""
    def draw(study, cases, kept):
        own = [case for case in cases if case.law == law and case.pressure == "0.2"]
        if not own:
            return f"{number}: no case of {LAWS[law]} contacts at 0.2 MPa"
        means = [Drawn("" if r else f"{case.grains} grains", Series(table), RADII.get(case.grains, colour), "--" if r else "-")
                 for case, colour in zip(own, figures.SERIES, strict=False) for r, table in enumerate(case.steps)]
        means += [Drawn(f"{case.grains} grains, full size", Series(kept[case.name].steps[-1]), figures.INK, ":")
                  for case in own if case.name in kept]
        weighed = [case for case in (kept.get(case.name, case) for case in own) if case.has_thesis_error()]
        means += [Drawn(f"thesis's error, {case.grains} grains" if len(weighed) > 1 else "thesis's error", Series(case.folder("thesis_error")),
                        figures.PURPLE, "-.") for case in weighed]
        known, strains = own[0].thesis(), [0, max(table("strain_axial", "%")[-1] for table in own[0].steps)]
        published = [Drawn("", Series({"strain_axial": strains} | {name: [known(name, quantity(name).unit)[0]] * 2 for name in PARAMETERS}),
                           figures.GREY, ":")] if known else []
        study.curves(f"means_{law}", *(panel("strain_axial", name, means + (published if name in PARAMETERS else []), legend=name == "effective_size",
                                             yscale="log" if name in ("young_modulus", "effective_size") else "linear")
                                       for name in (*PARAMETERS, "effective_size")), columns=3, height=6)
        return None
    return draw


def draw_pressure(study, cases, kept):
    """Draws Fig. 2.3: identified parameters over confining pressure, of kept runs where they have enough pressures."""
    means = []
    for law, colour, aside in zip(LAWS, figures.SERIES, (0.97, 1.03), strict=False):
        own = max((sorted((case for case in of if case.law == law and case.grains == 1000), key=lambda case: float(case.pressure))
                   for of in (kept.values(), cases)), key=len)
        # The laws stand side by side, so that their bars do not cover each other.
        pressure = {"confining_pressure": [aside * float(case.pressure) for case in own]}
        low, mean, high = (Series({name: [case.identified(f"{name}{ending}", quantity(name).unit) for case in own] for name in PARAMETERS} | pressure)
                           for ending in ("_low", "", "_high"))
        if len(own) > 2:
            means.append(Drawn(LAWS[law], mean, colour, "o-", ends=(low, high)))
    if not means:
        return "Fig. 2.3, which takes cases of 1000 grains at three pressures or more"
    study.curves("pressure", *(panel("confining_pressure", name, means, legend=False, xscale="log",
                                     yscale="log" if name == "young_modulus" else "linear") for name in PARAMETERS), columns=3, height=6)
    return None


def draw_prediction(study, cases, kept):
    """Draws Fig. 2.4: the test with the identified parameters, and with the thesis's, beside the laboratory. Numbers of grains share a panel."""
    panels = []
    for law, pressure in dict.fromkeys((case.law, case.pressure) for case in cases if case.curve):
        own = [case for case in cases if (case.law, case.pressure) == (law, pressure)]
        laboratory = Table.read(LABORATORY.format(pressure))
        drawn = [Drawn("laboratory", Series(laboratory.rows(numpy.arange(len(laboratory)) % 3 == 0)), figures.INK, "o")]
        for case in own:
            drawn += _checked(case, own)
            if case.name in kept:
                curves = kept[case.name].folder("check_curves")
                drawn.append(Drawn("identified at full size", Series(curves.rows(curves["id"] == 0)), figures.GREEN, "-."))
        title = str(own[0]) if len(own) == 1 else f"{own[0].law_words}, {pressure} MPa"
        panels += [panel("strain_axial", name, drawn, legend=name == "stress_ratio", xlim=(0, None), title=title)
                   for name in ("stress_ratio", "strain_volumetric")]
    if not panels:
        return "Fig. 2.4: curves of the laboratory are public at 0.2 and 0.5 MPa only"
    study.curves("prediction", *panels, columns=2)
    return None


def _checked(case, beside):
    """Returns the runs of a case's identified set, and of the thesis's for the first of the cases beside which they are drawn, as Drawn."""
    curves, drawn = case.folder("check_curves"), []
    own = "identified" if len(beside) == 1 else f"identified, {case.grains} grains"
    for id_ in numpy.unique(curves["id"]):
        colour, line, words = (RADII.get(case.grains, figures.SKY), "-", own) if id_ < 10 else (figures.PURPLE, "--", "the thesis's set")
        if id_ < 10 or case is beside[0]:
            drawn.append(Drawn("" if id_ % 10 else words, Series(curves.rows(curves["id"] == id_)), colour, line))
    return drawn


def draw_density(study, case):
    """Draws marginal posterior densities: of the first round at several stations, and of all rounds at the end."""
    def density(table, at, k, name):
        rows = table.rows((table("parameter", "1") == k) & numpy.isclose(table(*case.station), at))
        return Series({name: rows("value", "its own") / (1e9 if quantity(name).unit == "GPa" else 1), "density": rows("density", "1 per its own")})
    stations = numpy.unique(case.density[0](*case.station))
    shown = [(case.density[0], at, colour, "-", f"to {at:g} {case.station[1]}") for at, colour in zip(stations, figures.SERIES, strict=False)]
    shown += [(table, stations[-1], figures.INK, "--", "all rounds, at the end") for table in case.density[1:]]
    study.curves(f"density_{case.name}", *(
        panel(name, "density", [Drawn(words, density(table, at, k, name), colour, line) for table, at, colour, line, words in shown], "density",
              legend=False, xscale="linear" if k else "log", ylim=(0, None)) for k, name in enumerate(PARAMETERS)), columns=3, height=6,
                 sentence=f"Marginal posterior densities of the parameters: {case}. Solid: sets of the first round, up to several "
                          f"strains{'; dashed: sets of all rounds at the end' if case.density[1:] else ''}. The density of E is per decade.")


def draw(study, cases, kept):
    """Draws all figures, with kept cases beside those of this run, and adds a remark on figures that these cases and rounds do not give."""
    drawers = (draw_identified, draw_means("cl", "Fig. 2.1"), draw_means("hm", "Fig. 2.2"), draw_pressure, draw_prediction)
    left_out = [reason for drawer in drawers if (reason := drawer(study, cases, kept))]
    for case in cases:
        draw_density(study, case)
    if len(cases[0].steps) == 1:
        left_out.append("means and densities of later rounds, since one round was made")
    if left_out:
        study.remark(f"Not drawn: {'; '.join(left_out)}.")


def tell(study, cases, kept, arguments):
    """Gives the texts of the page what they name. kept: the cases of full-size runs, which the table of cases shows instead, if there are any."""
    first = [next(case for case in cases.values() if case.law == law) for law in dict.fromkeys(case.law for case in cases.values())]
    study.tell(cases=case_table((kept or cases).values()), cases_of="the full-size runs" if kept or study.judged else "this run",
               samples=arguments.samples, until=f"{arguments.until:g}",
               error=", ".join(arguments.error.split(",")), first=first,
               fits=[case for case in first if case.curve and study.measures[f"ratio_{case.name}"].value is not None],
               few=[case for case in cases.values() if study.measures[f"size_last_{case.name}"].value < len(PARAMETERS) + 1])


def build(arguments):
    """Reads the tables of pf-weight in the folder OUT and writes what was identified, compared and drawn."""
    if not arguments.cases:
        raise StudyError(f"{arguments.out}: no case is kept; make PROFILE=thesis ch2, then ch2-keep" if arguments.kept else "C2_CASES: name a case")
    study = Study.of(HERE, arguments, judged=arguments.profile == "thesis")
    cases = kept_cases(study.out) if arguments.kept else {name: Case(study.out, name, len(arguments.samples)) for name in arguments.cases}
    measure(study, cases)
    for case in cases.values():
        if case.curve:
            study.accept(f"ratio_{case.name}", "at most", 12, "%", f"stress ratio: RMS difference of the identified set from the laboratory, {case}")
            study.accept(f"volume_{case.name}", "at most", 1, "%", f"volumetric strain: RMS difference of the identified set from the laboratory, {case}")
    kept = {} if study.judged else kept_cases(HERE / "kept")
    if not arguments.kept:
        tell(study, cases, kept, arguments)
    draw(study, list(cases.values()), kept)
    for case in {} if arguments.kept else cases.values():
        study.text(f"Posterior as pf-weight reports it: {case}", case.folder.path / f"round{len(case.steps)}_posterior.txt")
    return study


if __name__ == "__main__":
    main(build, cases={"nargs": "*", "required": True, "help": "LAW_GRAINS_PRESSURE"}, samples={"nargs": "+", "type": int, "required": True},
         until={"type": float, "required": True, "help": "strain (%%) up to which runs are compared"}, error={"required": True})
