"""The kinds of plots that the command `plot` draws: which columns of which table, in which unit, over which."""
# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses

from .quantities import Line, quantity


@dataclasses.dataclass(frozen=True)
class Panel:
    """Curves over one abscissa. each: curves; a tuple holds alternatives, of which the first that all tables have is drawn.
    label: the ordinate's, if there are several curves. log: whether the abscissa is logarithmic."""

    abscissa: Line
    each: tuple
    label: str = ""
    log: bool = False


@dataclasses.dataclass(frozen=True)
class Kind:
    """A kind of plot. words: what it shows. table: the tool, and its table that is drawn. whole: shows all stages, not the last one alone."""

    words: str
    table: tuple
    panels: tuple
    whole: bool = False


_STRAIN, _MEAN, _VOLUME = (quantity(name) for name in ("strain_axial", "mean_stress", "strain_volumetric"))
_SERIES, _LOADING = ("homogenize", "series"), ("homogenize", "loading")

KINDS = {
    "stress-strain": Kind("stress ratio and volumetric strain over axial strain", _SERIES, (
        Panel(_STRAIN, ((quantity("stress_ratio"), quantity("deviatoric_stress")),)),
        Panel(_STRAIN, (_VOLUME,)))),
    "stress-path": Kind("deviatoric over mean stress", _SERIES, (
        Panel(_MEAN, (quantity("deviatoric_stress"),)),), whole=True),
    "e-log-p": Kind("void ratio over the logarithm of mean stress", _SERIES, (
        Panel(_MEAN, (quantity("void_ratio"),), log=True),), whole=True),
    "coordination": Kind("coordination numbers over axial strain", _SERIES, (
        Panel(_STRAIN, (Line("coordination_number", "1", "all grains"), quantity("mechanical_coordination_number")), "coordination number"),)),
    "energies": Kind("energies over axial strain", _SERIES, (
        Panel(_STRAIN, tuple(map(quantity, ("boundary_work", "elastic_energy", "frictional_dissipation", "rolling_dissipation",
                                            "damping_dissipation", "energy_error"))), "energy (J)"),)),
    "fabric": Kind("anisotropies of contacts and forces over axial strain", ("fabric", "fabric"), (
        Panel(_STRAIN, tuple(map(quantity, ("a_c", "a_n", "a_t"))), "anisotropy"),)),
    "rose": Kind("density of contact normals over their direction, last state", ("fabric", "rose"), ()),
    "bag": Kind("plate pressure and volumetric strain of a bag over its settlement", _LOADING, (
        Panel(_STRAIN, (quantity("plate_pressure"),)), Panel(_STRAIN, (_VOLUME,)))),
    "yarns": Kind("tension of the yarns of a bag, and how many broke", _LOADING, (
        Panel(_STRAIN, (Line("tension_yarn_face", "N", "faces"), Line("tension_yarn_side_around", "N", "sides, around"),
                        Line("tension_yarn_side_up", "N", "sides, up")), "tension of a yarn (N)"),
        Panel(_STRAIN, (quantity("broken_yarns"),)))),
    "posterior": Kind("densities of the parameters that pf-weight identified", (), ()),
}
