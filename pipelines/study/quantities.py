"""Columns of the tools' tables as studies and `plot` take them: each in one unit, with its words along an axis."""
# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses

from .errors import StudyError, suggestion


@dataclasses.dataclass(frozen=True)
class Line:
    """A column: the unit that it is taken in, its words in a legend and along an axis. missing: NaN is "no value" in it."""

    column: str
    unit: str
    words: str
    missing: bool = False

    @property
    def axis(self):
        """The label of an axis that shows this column alone."""
        return self.words if self.unit == "1" else f"{self.words} ({self.unit})"


_LINES = (
    Line("step", "1", "step"),
    Line("stage", "1", "stage"),
    Line("id", "1", "number of the run"),
    Line("plane", "1", "plane"),
    Line("series", "1", "number of the series"),
    Line("time", "s", "time"),
    # Strains and displacements.
    Line("strain_axial", "%", "axial strain"),
    Line("strain_volumetric", "%", "volumetric strain, contraction positive"),
    Line("strain_deviatoric", "%", "deviatoric strain"),
    Line("strain_shear", "%", "shear strain"),
    Line("settlement", "mm", "settlement"),
    Line("shear_displacement", "mm", "shear displacement"),
    Line("reference_height", "mm", "height"),
    Line("pull_end", "cm", "pulled"),
    # Stresses and their ratios.
    Line("mean_stress", "kPa", "mean stress p"),
    Line("deviatoric_stress", "kPa", "deviatoric stress q"),
    Line("axial_stress", "kPa", "axial stress"),
    Line("lateral_stress", "kPa", "lateral stress"),
    Line("radial_stress", "kPa", "lateral stress"),
    Line("shear_stress", "kPa", "shear stress"),
    Line("stress_ratio", "1", "stress ratio σₐ/σᵣ"),
    Line("obliquity", "1", "q/p"),
    Line("plate_pressure", "kPa", "plate pressure"),
    Line("plate_shear", "kPa", "shear of the plates"),
    Line("plate_ratio", "1", "shear over normal force of the plates"),
    Line("surcharge", "kPa", "surcharge"),
    Line("traction_y_bottom", "kPa", "vertical stress at the bottom", missing=True),
    Line("interface_friction", "1", "friction ratio at the bottom", missing=True),
    Line("slope", "1", "slope of the path in p and q"),
    Line("deviation", "1", "greatest distance from it"),
    # Structure of the packing.
    Line("void_ratio", "1", "void ratio e"),
    Line("delaunay_void_ratio", "1", "void ratio"),
    Line("coordination_number", "1", "coordination number"),
    Line("mechanical_coordination_number", "1", "without rattlers"),
    Line("a_c", "1", "a_c, contact normals"),
    Line("a_n", "1", "a_n, normal forces"),
    Line("a_t", "1", "a_t, tangential forces"),
    Line("anisotropy", "1", "F_a"),
    Line("angle", "deg", "angle from the vertical"),
    Line("density", "1", "contacts over those of an isotropic packing"),
    Line("contacts", "1", "contacts of a grain"),
    Line("grains", "1", "grains"),
    Line("unbalanced_force", "1", "unbalanced force"),
    # The geotextile.
    Line("tension_yarn_face", "N", "tension of yarns on the faces"),
    Line("tension_yarn_side_around", "N", "tension of yarns around the sides"),
    Line("tension_yarn_side_up", "N", "tension of yarns up the sides"),
    Line("tension_yarn_horizontal", "N", "tension of horizontal yarns"),
    Line("strain_yarn_face", "%", "strain of yarns on the faces"),
    Line("strain_yarn_side_around", "%", "strain of yarns around the sides"),
    Line("broken_yarns", "1", "broken yarns"),
    Line("intact_springs", "1", "whole springs"),
    Line("first_break_strain", "%", "axial strain of the first break", missing=True),
    Line("seam", "1", "distance from the middle, 1 at the seam"),
    Line("face_friction_x", "deg", "friction mobilised on the sides along x"),
    Line("face_friction_y", "deg", "friction mobilised on the sides along y"),
    Line("face_friction_z", "deg", "upper and lower face"),
    Line("hoop_strain", "%", "hoop strain"),
    Line("reinforcing_efficiency", "1/m", "surcharge over stiffness"),
    # Energies.
    Line("boundary_work", "J", "work of the boundary"),
    Line("elastic_energy", "J", "elastic"),
    Line("frictional_dissipation", "J", "sliding"),
    Line("rolling_dissipation", "J", "rolling"),
    Line("damping_dissipation", "J", "damping"),
    Line("law_energy", "J", "taken by the incremental law"),
    Line("energy_error", "J", "left over"),
    # Contacts and the filter that identifies them.
    Line("young_modulus", "GPa", "E"),
    Line("poisson_ratio", "1", "ν"),
    Line("rolling_stiffness", "1", "rolling stiffness"),
    Line("rolling_limit", "1", "rolling limit"),
    Line("friction_angle", "deg", "friction angle"),
    Line("confining_pressure", "MPa", "confining pressure"),
    Line("effective_size", "1", "effective sample size"),
)
QUANTITIES = {line.column: line for line in _LINES}


def quantity(name):
    """Returns the Line of a column. Raises StudyError for an unknown column."""
    if name not in QUANTITIES:
        raise StudyError(f"'{name}' has no unit of its own; ask for it in one, or name it in study/quantities.py{suggestion(name, QUANTITIES)}")
    return QUANTITIES[name]
