#!/usr/bin/env python3
"""Chapter 2: contact parameters of Toyoura sand identified by the particle filter (thesis Figs. 2.1 to 2.4)."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib

import numpy
from study import NotMade, Study, Table, figures, main

HERE = pathlib.Path(__file__).parent
LABORATORY = "data/laboratory/toyoura_drained_triaxial_{}MPa.tsv"
LAWS = {"cl": "linear", "hm": "Hertz–Mindlin"}
PARAMETERS = {"young_modulus": "Pa", "poisson_ratio": "1", "rolling_stiffness": "1", "rolling_limit": "1", "friction_angle": "deg"}
# How figures show a parameter: label and unit.
SHOWN = {"young_modulus": ("E (GPa)", "GPa"), "poisson_ratio": ("ν", "1"), "rolling_stiffness": ("rolling stiffness", "1"),
         "rolling_limit": ("rolling limit", "1"), "friction_angle": ("friction angle (°)", "deg")}
PURE = [label for label, unit in SHOWN.values() if unit == "1"]
RADII = {1000: figures.BLUE, 2000: figures.ORANGE, 5000: figures.GREEN}  # colour of a number of grains
# The misfits of a checked run: name, table, column.
MISFITS = (("ratio", "near", "stress_ratio_misfit_relative"), ("volume", "near", "strain_volumetric_misfit"),
           ("ratio_whole", "whole", "stress_ratio_misfit_relative"), ("volume_whole", "whole", "strain_volumetric_misfit"))
# The cases of thesis Table 2.1, and every measure of a case with its unit.
THESIS = [f"{law}_{n}_0.2" for n in RADII for law in LAWS] + [f"{law}_1000_{p}" for p in ("0.5", "1", "2", "4", "8") for law in LAWS]
MEASURES = {"size_first": "1", "size_last": "1", "settling": "1", "log_modulus": "1", **PARAMETERS,
            **{f"{name}{kind}": "%" for name, _, _ in MISFITS for kind in ("", "_thesis", "_excess")}}


class Case:
    """The tables of pf-weight for one law, number of grains and confining pressure (MPa), round by round."""

    def __init__(self, out, name, rounds):
        self.name, (self.law, grains, self.pressure) = name, name.split("_")
        self.grains, self.out, self.rounds = int(grains), out / name, rounds
        self.steps = [self._read(f"round{r}_steps") for r in range(1, rounds + 1)]
        self.density = [self._read(f"round{r}_density") for r in range(1, rounds + 1)]
        # Where there is no curve of the laboratory, the greatest stress ratio alone is compared.
        self.curve = pathlib.Path(LABORATORY.format(self.pressure)).exists()
        self.checks = {name: self._read(f"check_{name}") for name in ("near", "whole", "curves")} if self.curve else {}
        self.station = ("strain_axial", "%") if self.curve else ("confining_pressure", "kPa")

    def _read(self, name):
        return Table.read(self.out / f"{name}.tsv")

    def __str__(self):
        return f"{LAWS[self.law]}, {self.grains} grains, {self.pressure} MPa"

    def identified(self, name, unit):
        """Returns the weighted mean of a parameter over the sets of all rounds, at the last station."""
        return self.steps[-1](name, unit)[-1]

    def thesis(self):
        """Returns the set that the thesis identified for this case, as a table of one row; None where it has none."""
        path = pathlib.Path(f"data/contacts/toyoura_{self.law}_{self.pressure}MPa.tsv")
        return Table.read(path) if path.exists() else None

    def misfits(self, which, table, column):
        """Returns the misfits (%) of the twins of a checked set: 0, the identified one; 1, the thesis's.

        Raises NotMade where the set was not run or none of its runs went through.
        """
        own = self.checks[table]("id", "1") // 10 == which
        own &= self.checks[table]("fate", "1") == 0
        if not own.any():
            raise NotMade(f"no run of the {'thesis' if which else 'identified'} set of {self.name}")
        return self.checks[table].rows(own)(column, "%")


def settling(table):
    """Returns the way of the mean friction angle per strain in the last 1.5 % of axial strain, over that in the first 1.5 %."""
    strain, mean = table("strain_axial", "%"), table("friction_angle", "deg")
    if len(strain) <= 10:
        raise NotMade("too few stations")
    way, span = abs(numpy.diff(mean)), numpy.diff(strain)
    early, late = strain[1:] <= 1.5, strain[1:] > strain[-1] - 1.5
    if way[early].sum() == 0:
        raise NotMade("the mean does not move at first")
    return (way[late].sum() / span[late].sum()) / (way[early].sum() / span[early].sum())


def measure_case(study, case):
    """How the means settle, effective sample sizes, identified parameters."""
    c, last = case.name, case.steps[-1]
    study.measure(f"size_first_{c}", case.steps[0]("effective_size", "1")[-1], "1")
    study.measure(f"size_last_{c}", last("effective_size", "1")[-1], "1")
    if case.curve:
        study.measure(f"settling_{c}", lambda: settling(case.steps[0]), "1")
    study.measure(f"log_modulus_{c}", numpy.log10(case.identified("young_modulus", "Pa")), "1")
    for name, unit in PARAMETERS.items():
        study.measure(f"{name}_{c}", case.identified(name, unit), unit, last(f"{name}_deviation", unit)[-1])


def measure_check(study, case):
    """How far the runs of the identified and of the thesis's set are from the laboratory; means over twins."""
    for name, table, column in MISFITS:
        means = []
        for which, kind in enumerate(("", "_thesis")):
            try:
                twins = case.misfits(which, table, column)
            except NotMade as reason:
                study.unmade(f"{name}{kind}_{case.name}", "%", str(reason))
                continue
            means.append(twins.mean())
            study.measure(f"{name}{kind}_{case.name}", means[-1], "%", twins.std(ddof=1) if len(twins) > 1 else 0)
        if len(means) == 2:
            study.measure(f"{name}_excess_{case.name}", means[0] - means[1], "%")
        else:
            study.unmade(f"{name}_excess_{case.name}", "%", "one of the two sets has no run")


def measure_trends(study, cases):
    """From 0.2 to 8 MPa: how much a parameter grows in the direction of the thesis, as a share."""
    ends = [cases.get(f"hm_1000_{p}") for p in ("0.2", "8")]

    def trend(name, sign):
        if None in ends:
            raise NotMade("made with the cases hm_1000_0.2 and hm_1000_8")
        low, high = (end.identified(name, PARAMETERS[name]) for end in ends)
        return sign * (high / low - 1)
    for short, name, sign in (("E", "young_modulus", 1), ("mu", "friction_angle", -1), ("kr", "rolling_stiffness", 1)):
        study.measure(f"trend_{short}", lambda name=name, sign=sign: trend(name, sign), "1")


def leave_out(study, cases):
    """Says of the thesis's cases that are not run, and of what the run ones lack, that they have no measures."""
    for c in THESIS:
        for name, unit in MEASURES.items():
            if f"{name}_{c}" not in study.measures:
                study.unmade(f"{name}_{c}", unit, "no curve of the laboratory" if c in cases else f"case {c} is not among C2_CASES")


def six(title=""):
    """Returns a figure, five axes for the parameters and a sixth."""
    figure, axes = figures.panels(3, rows=2, height=6)
    return figure, dict(zip(SHOWN, axes, strict=False)), axes[5]


def draw_identified(study, cases, left_out):
    """The answer: each parameter over the thesis's."""
    known = [case for case in cases if case.thesis()]
    if not known:
        left_out.append("the parameters beside the thesis's, which has none for these cases")
        return
    figure, axes = figures.panels(len(known), height=3)
    for a, case in zip(axes, known, strict=True):
        thesis, last = case.thesis(), case.steps[-1]
        for k, (name, unit) in enumerate(PARAMETERS.items()):
            given = thesis(name, unit)[0]
            a.plot([last(f"{name}{end}", unit)[-1] / given for end in ("_low", "_high")], [k, k], color=figures.BLUE, linewidth=3, alpha=0.4)
            a.plot(case.identified(name, unit) / given, k, "o", color=figures.BLUE)
        a.axvline(1, color=figures.INK, linewidth=1)
        a.set_xscale("log", base=2)
        a.xaxis.set_major_formatter("{x:g}")
        a.set_yticks(range(len(SHOWN)), [label.partition(" (")[0] for label, _ in SHOWN.values()])
        a.invert_yaxis()
        figures.label(a, "identified over the thesis's", "", ["identified over the thesis's", ""])
        a.set_title(str(case), fontsize=10)
    study.figure("identified", figure, "Identified parameters over those that the thesis identified. Bars hold the middle 90 % of the "
                 "weight.", measures=[f"{name}_{case.name}" for case in known for name in ("log_modulus", "friction_angle")
                                      if case.grains == 1000 and case.pressure == "0.2"])


def draw_means(study, cases, law, number, claim, measures, left_out):
    """Figs. 2.1 and 2.2: weighted means over axial strain at 0.2 MPa."""
    own = [case for case in cases if case.law == law and case.pressure == "0.2"]
    if not own:
        left_out.append(f"{number}: no case of {LAWS[law]} contacts at 0.2 MPa")
        return
    figure, axes, size = six()
    for case, colour in zip(own, figures.SERIES, strict=False):
        for r, table in enumerate(case.steps):
            how = {"color": RADII.get(case.grains, colour), "linestyle": "--" if r else "-", "label": None if r else f"{case.grains} grains"}
            for name, (_, unit) in SHOWN.items():
                axes[name].plot(table("strain_axial", "%"), table(name, unit), **how)
            size.plot(table("strain_axial", "%"), table("effective_size", "1"), **how)
    for name, (label, _) in SHOWN.items():
        figures.label(axes[name], "axial strain (%)", label, PURE)
    figures.label(size, "axial strain (%)", "effective sample size", ["effective sample size"])
    for a, minor in ((axes["young_modulus"], "{x:g}"), (size, "")):
        a.set_yscale("log")
        a.yaxis.set_major_formatter("{x:g}")
        a.yaxis.set_minor_formatter(minor)
    size.legend()
    later = "dashed: of all sets after each later round." if own[0].rounds > 1 else "one round was made, so that there are no later ones."
    study.figure(f"means_{law}", figure, f"Weighted means over axial strain, {LAWS[law]} contacts; solid: of the sets from the prior, {later}",
                 number, claim, measures)


def draw_pressure(study, cases, left_out):
    """Fig. 2.3: identified means over confining pressure."""
    groups = {law: sorted((case for case in cases if case.law == law and case.grains == 1000), key=lambda case: float(case.pressure))
              for law in LAWS}
    groups = {law: own for law, own in groups.items() if len(own) > 2}
    if not groups:
        left_out.append("Fig. 2.3: it takes cases of 1000 grains at three pressures or more")
        return
    figure, axes, rest = six()
    rest.remove()
    for law, colour in zip(groups, figures.SERIES, strict=False):
        for name, (label, unit) in SHOWN.items():
            axes[name].semilogx([float(case.pressure) for case in groups[law]], [case.identified(name, unit) for case in groups[law]],
                                "o-", color=colour, label=LAWS[law])
            figures.label(axes[name], "confining pressure (MPa)", label, PURE)
    axes["young_modulus"].legend()
    study.figure("pressure", figure, "Identified means over confining pressure, 1000 grains.", "Fig. 2.3",
                 "as the confining pressure increases, μ decreases, and E and the rolling stiffness increase (§2.4).",
                 ["trend_mu", "trend_E", "trend_kr"])


def draw_prediction(study, cases, left_out):
    """Fig. 2.4: the test with the identified parameters, and with the thesis's, beside the laboratory."""
    if not cases:
        left_out.append("Fig. 2.4: curves of the laboratory are public at 0.2 and 0.5 MPa only")
        return
    figure, axes = figures.panels(2, rows=len(cases), height=3.6 * len(cases))
    quantities = (("stress_ratio", "1", "stress ratio σₐ/σᵣ"), ("strain_volumetric", "%", "volumetric strain, contraction positive (%)"))
    for k, case in enumerate(cases):
        laboratory, curves = Table.read(LABORATORY.format(case.pressure)), case.checks["curves"]
        for a, (name, unit, label) in zip(axes[2 * k:], quantities, strict=False):
            figures.points(a, laboratory("strain_axial", "%")[::3], laboratory(name, unit)[::3], figures.INK, "laboratory")
            for id_ in numpy.unique(curves("id", "1")):
                run = curves.rows(curves("id", "1") == id_)
                kind = (figures.BLUE, "-", "identified") if id_ < 10 else (figures.ORANGE, "--", "the thesis's set")
                a.plot(run("strain_axial", "%"), run(name, unit), kind[1], color=kind[0], linewidth=1.2, label=None if id_ % 10 else kind[2])
            a.set_xlim(left=0)
            a.set_title(str(case), fontsize=10)
            figures.label(a, "axial strain (%)", label, [quantities[0][2]])
        axes[2 * k].legend()
    stated = [case.name for case in cases if case.grains == 1000 and case.pressure == "0.2"]
    study.figure("prediction", figure, "The test run with the identified parameters and with the sets that the thesis identified, beside the "
                 "laboratory; lines of one kind are twins, moved by a millionth of a radius.", "Fig. 2.4",
                 "predicted and measured behaviours agree very well, except at 4 MPa (§2.4).",
                 [f"{name}_{c}" for c in stated for name in ("ratio", "ratio_excess", "volume_excess")])


def draw_density(study, case):
    """Marginal posterior densities at several stations of the first round, and of all rounds at the end."""
    figure, axes, rest = six()
    stations = numpy.unique(case.density[0](*case.station))
    colours = dict(zip(stations, figures.SERIES, strict=False))
    for k, (name, (label, unit)) in enumerate(SHOWN.items()):
        for r, table in enumerate([case.density[0], *case.density[1:][-1:]]):
            for at in stations if r == 0 else stations[-1:]:
                rows = table.rows((table("parameter", "1") == k) & numpy.isclose(table(*case.station), at))
                value = rows("value", "its own") / (1e9 if unit == "GPa" else 1)
                words = "all rounds, at the end" if r else f"to {at:g} {case.station[1]}"
                axes[name].plot(value, rows("density", "1 per its own"), "--" if r else "-", color=figures.INK if r else colours[at], label=words)
        axes[name].set_ylim(bottom=0)
        figures.label(axes[name], label, "density", [*PURE, "density"])
    axes["young_modulus"].set_xscale("log")
    rest.set_axis_off()
    rest.legend(*axes["young_modulus"].get_legend_handles_labels(), loc="center")
    study.figure(f"density_{case.name}", figure, f"Marginal posterior densities: {case}. Solid: the sets of the first round; E per decade.")


def draw(study, cases):
    """All figures in the thesis's order, and a remark on those that these cases and rounds do not give."""
    left_out = []
    curves = [case for case in cases if case.curve]
    draw_identified(study, curves, left_out)
    draw_means(study, cases, "cl", "Fig. 2.1", "means fluctuate at small strain, then converge, to the same ones regardless of the number "
               "of grains (§2.4).", ["settling_cl_1000_0.2", "friction_angle_cl_2000_0.2", "friction_angle_cl_5000_0.2"], left_out)
    draw_means(study, cases, "hm", "Fig. 2.2", "means converge alike; with 5000 grains a single set has all the weight, with the same E and "
               "μ (§2.4).", ["settling_hm_1000_0.2", "size_first_hm_5000_0.2", "friction_angle_hm_5000_0.2"], left_out)
    draw_pressure(study, cases, left_out)
    draw_prediction(study, curves, left_out)
    for case in cases:
        draw_density(study, case)
    if cases[0].rounds == 1:
        left_out.append("what later rounds add to the means and densities, since one round was made")
    if left_out:
        study.remark(f"Not drawn: {'; '.join(left_out)}.")


def explain(study):
    """Says why statements are not met."""
    study.reason("trend_E", "at most pressures the greatest stress ratio alone is observed, which does not determine five parameters")
    study.reason("trend_kr", "at most pressures the greatest stress ratio alone is observed, which does not determine five parameters")
    for c in ("hm_1000_0.2", "cl_1000_0.2"):
        study.reason(f"settling_{c}", "the error is small beside the distances between sets: all weight is on one at a time, and moves to "
                     "another where their curves cross")
        for name in ("volume_excess", "volume_whole_excess"):
            study.reason(f"{name}_{c}", "here the stress ratio has a smaller error than with the thesis, whose sets the strains decide alone")
        study.reason(f"ratio_whole_excess_{c}", "beyond the strain up to which sets are compared, an identified one is extrapolated")
        study.reason(f"friction_angle_{c}", "rolling parameters and friction angle trade against one another: sets far apart fit as well")


def build(arguments):
    """Reads the tables of pf-weight in the folder OUT and writes what was identified, compared and drawn."""
    study = Study("ch2", "Contact parameters of Toyoura sand, identified with the particle filter", arguments.out, arguments.profile,
                  judged=arguments.profile == "thesis")
    cases = {name: Case(study.out, name, len(arguments.samples)) for name in arguments.cases}
    for case in cases.values():
        measure_case(study, case)
        if case.curve:
            measure_check(study, case)
    measure_trends(study, cases)
    leave_out(study, cases)
    study.expect(HERE / "expected.tsv")
    study.expect(HERE / "statements.tsv", "Statements of §2.4", table="checklist")
    explain(study)
    accept(study, cases)
    write_words(study, cases, arguments)
    draw(study, list(cases.values()))
    for case in cases.values():
        study.text(f"Posterior: {case}", case.out / f"round{case.rounds}_posterior.txt")
    return study


def accept(study, cases):
    """What a run of any size has to keep."""
    for case in cases.values():
        if case.curve:
            study.accept(f"ratio_{case.name}", "at most", 12, "%", f"RMS misfit of the stress ratio, identified set: {case}")
            study.accept(f"volume_{case.name}", "at most", 1, "%", f"RMS misfit of the volumetric strain, identified set: {case}")


def write_words(study, cases, arguments):
    """What was done and what came out, in words."""
    sets = " and ".join(str(n) for n in arguments.samples)
    later = ", each later one around the posterior of all before" if len(arguments.samples) > 1 else ""
    study.lead = (f"Sets of contact parameters are drawn from a prior{later}, in rounds of {sets}. Each is run through the drained triaxial "
                  "test, and the laboratory's results weigh it step by step (thesis Eqs. 2.3 to 2.8).")
    first = {}  # case of each law
    for c, case in cases.items():
        first.setdefault(case.law, c)
    told = [f"{study.say(f'friction_angle_{c}')} for {LAWS[law]} contacts" for law, c in first.items()]
    study.headline = f"The friction angle of grains is found to be {' and '.join(told)}"
    fits = [c for c in first.values() if cases[c].curve and study.measures[f"ratio_{c}"].value is not None]
    study.headline += (f"; with these sets the stress ratio follows the laboratory's to {' and '.join(study.say(f'ratio_{c}', 2) for c in fits)}"
                       f" (RMS, to {arguments.until:g} % strain)." if fits else ".")
    error = ", ".join(arguments.error.split(","))
    study.remark(f"The variances of the observation error are {error}, of the radial strain (%), the stress ratio and the volumetric strain (%). "
                 "With the thesis's 0.1 for all the strains decide alone, and sets are chosen that miss the stress ratio. The sets of all "
                 "rounds count as one sample, each with the importance that corrects for where it was drawn (pf-weight resample --keep); the "
                 "thesis has one round.")
    few = [c for c in cases if study.measures[f"size_last_{c}"].value < len(PARAMETERS) + 1]
    if few:
        study.remark(f"Effective sample sizes end at {', '.join(study.say(f'size_last_{c}', 2) for c in few)} ({', '.join(str(cases[c]) for c in few)}): "
                     "means are next to the values of the heaviest set, and their ± says little.")
    study.remark("Curves of the laboratory are public at 0.2 and 0.5 MPa only; at other pressures the greatest stress ratio alone is observed, "
                 "which does not determine five parameters.")


if __name__ == "__main__":
    main(build, cases={"nargs": "+", "required": True, "help": "LAW_GRAINS_PRESSURE"}, samples={"nargs": "+", "type": int, "required": True},
         until={"type": float, "required": True, "help": "strain (%%) up to which runs are compared"}, error={"required": True})
