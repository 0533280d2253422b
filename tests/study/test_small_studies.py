"""quickstart, packings and chapter 5: every column that they read is missed by name, on small tables."""
# SPDX-License-Identifier: GPL-3.0-or-later
import importlib.util
import pathlib

import numpy
import pytest
from renaming import demand_columns
from study import Study

ROOT = pathlib.Path(__file__).parents[2]
STRAIN = (0, 0.006, 0.02, 0.05, 0.06, 0.07, 0.08, 0.085, 0.1)
SCALE = {"1": 1, "m": 1, "deg": 100, "Pa": 1e6, "J": 1, "N/m": 1e5, "1/m": 10}  # in SI, as tools print
GIVEN = {"stage": [1] * 9, "step": range(9), "plane": [2] * 9, "contacts": range(9), "series": [0, 1, 2] * 3}
ENERGIES = "boundary_work[J] energy_error[J] frictional_dissipation[J] damping_dissipation[J] elastic_energy[J] law_energy[J]"
SERIES = (f"stage step strain_axial stress_ratio strain_volumetric unbalanced_force void_ratio coordination_number "
          f"mechanical_coordination_number {ENERGIES}")
SOLUTION = ("surcharge[Pa] strain_axial radial_stress[Pa] axial_stress[Pa] strain_volumetric hoop_strain reinforcing_efficiency[1/m] "
            "strain_deviatoric hoop_tension[N/m]")


def study_of(name):
    """Returns the module study.py of a study."""
    spec = importlib.util.spec_from_file_location(f"study_{name}", ROOT / f"pipelines/{name}/study.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def write(path, columns, unit="1"):
    """Writes a table of nine rows: columns as "name" or "name[unit]", their numbers rising."""
    heads = [column.rstrip("]").split("[") for column in columns.split()]
    values = {h[0]: GIVEN.get(h[0], STRAIN if h[0] == "strain_axial" else numpy.linspace(0.01, 0.2, 9) * SCALE[(h + [unit])[1]]) for h in heads}
    rows = "\n".join("\t".join(repr(float(v)) for v in row) for row in zip(*values.values(), strict=True))
    path.write_text("\t".join(f"{h[0]} [{(h + [unit])[1]}]" for h in heads) + "\n" + rows + "\n")


@pytest.fixture(autouse=True)
def in_the_tree(monkeypatch):
    monkeypatch.chdir(ROOT)


def test_columns_of_the_quickstart(tmp_path):
    module = study_of("quickstart")
    write(tmp_path / "cell_packing_1.tsv", "void_ratio mean_radius[m] cell_length_x[m] cell_length_y[m] cell_length_z[m]")
    write(tmp_path / "fabric_packing_1.tsv", "coordination_number")
    write(tmp_path / "rose_packing_1.tsv", "plane angle[deg] density")
    write(tmp_path / "histogram_packing_1.tsv", "grains contacts")
    for p in module.PRESSURES:
        write(tmp_path / f"series_triaxial_{p}_1.tsv", SERIES)
        write(tmp_path / f"fabric_triaxial_{p}_1.tsv", "step strain_axial stress_obliquity_from_fabric stress_obliquity a_c a_n a_t")

    def reader(act):
        return lambda: act(Study("quickstart", "", tmp_path, "quick"), module.Runs(tmp_path, [1]))
    assert demand_columns(map(reader, (module.measure_packings, module.measure_tests, module.draw))) > 60


def test_columns_of_the_packings(tmp_path):
    module = study_of("packings")
    for p in module.PRESSURES:
        write(tmp_path / f"cell_packing_1000_{p}_1.tsv", "void_ratio")
    for twin in module.TWINS["quick"]:
        write(tmp_path / f"series_triaxial_1000_1_{twin}.tsv", SERIES)

    def drawn():
        study = Study("packings", "", tmp_path, "quick")
        study.expect(ROOT / "pipelines/packings/expected.tsv")
        module.draw(study, [1])
    assert demand_columns([lambda: module.measure(Study("packings", "", tmp_path, "quick"), [1]), drawn]) == 11


def test_columns_of_chapter_5(tmp_path):
    module = study_of("ch5")
    for name in [*(f"uniaxial_{g}" for g in module.UNIAXIAL), *(f"triaxial_{g}_{p}kPa" for g in module.SHEARED for p in module.PRESSURES)]:
        write(tmp_path / f"{name}.tsv", SOLUTION)
    stresses = {"p_0", "p_c", "alpha"}
    write(tmp_path / "constants.tsv", " ".join(f"{c}{end}[{'Pa' if c in stresses else '1'}]" for c in module.CONSTANTS
                                               for end in ("", "_low", "_high", "_given")))
    for name, columns in {"near_failure_line": "distance_to_failure residual strain_deviatoric series fitted",
                          "failure_line": "mean_stress[Pa] failure_obliquity fitted",
                          "compression_line": "mean_stress[Pa] strain_volumetric series fitted",
                          "dilatancy_line": "distance_to_failure distance_of_dilation_rate series fitted",
                          "increments": "series generalized_stress[Pa] plastic_axial",
                          "stiffness": "series young_modulus[Pa] tensile_stiffness[N/m]",
                          "chart": "stiffness[N/m] capacity[Pa] allowable_surcharge[Pa] settlement service_settlement",
                          "bands": "settlement surcharge_low[Pa] surcharge_high[Pa] surcharge[Pa] radial_stress_low[Pa] radial_stress_high[Pa] "
                                   "radial_stress[Pa] samples"}.items():
        write(tmp_path / f"{name}.tsv", columns)

    def reader(act):
        return lambda: act(Study("ch5", "", tmp_path, "quick"), module.Runs(tmp_path))
    readers = [lambda: module.measure_trends(Study("ch5", "", tmp_path, "quick"), module.Runs(tmp_path).uniaxial),
               reader(lambda study, runs: [module.measure_beside_record(study, g, runs.uniaxial[g], r) for g, r in runs.recorded.items()]),
               *map(reader, (module.measure_triaxial, module.measure_constants, module.draw_uniaxial, module.draw_tension, module.draw_lines,
                             module.draw_stiffness, module.draw_triaxial, module.draw_design))]
    assert demand_columns(readers) > 200
