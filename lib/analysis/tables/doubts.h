// Doubts about packings, bags and runs: numbers with thresholds and remedies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "analysis/measure/volume_of_interest.h"
#include "core/doubts.h"
#include "dem/run/scenario.h"
#include "files/files.h"

namespace soilweave::analysis {

/// Returns "cell-over-grain" if the cell is narrower than 4 largest grains along a periodic axis.
std::vector<Doubt> cell_doubts(const io::Snapshot& state);

/// Returns "rattlers" (share of grains outside the backbone), "coordination" (2 Nc/N) and "isotropy" (q/p) of an
/// isotropic packing. Empty for grains without contacts.
std::vector<Doubt> compaction_doubts(const io::Snapshot& state);

/// Returns "outside" if a minority of the grains has left the bag. Returns "preload" if the soil in the bag has 2 Nc/N
/// below 2. Empty without yarns or soil.
std::vector<Doubt> bag_doubts(const io::Snapshot& state);
/// Returns "mesh" if grains are narrower than the mean opening between nodes of the geotextile around them. Empty
/// without yarns.
std::vector<Doubt> mesh_doubts(const io::Snapshot& state);

/// Returns "open-cell" unless the cell is periodic along every axis (tessellation.h). The remedy depends on the table
/// that lacks values, "cell" or "series".
std::vector<Doubt> open_cell_doubts(const io::Snapshot& state, std::string_view table);

/// Returns "few-grains" if a volume of interest holds fewer than 64 grains, four along each side (2D: 16).
std::vector<Doubt> volume_doubts(const io::Snapshot& state, const std::vector<Volume>& volumes);

/// Returns rate * d * sqrt(rho / p) (da Cruz et al. 2005): rate 1/s, mean diameter d in m, scaled density rho in kg/m3,
/// mean stress p in Pa.
double inertial_number(double rate, double diameter, double density, double pressure);

/// Returns doubts about a run's input for --check: cell, bag, materials (material_doubts.h), scenario
/// (loading_doubts.h), and "inertia", the largest inertial number of stages with a prescribed axial rate. begun: the
/// state before the first step, with forces by the scenario's law.
std::vector<Doubt> doubts_before(const io::Snapshot& start, const dem::Scenario& scenario, const io::Snapshot& begun);

/// Returns doubts about an ended run: final cell, bag and overlaps, end of the last isotropic stage, materials,
/// scenario, "inertia". The first state in `run` must be the one before the first step.
std::vector<Doubt> doubts_after(const io::Snapshot& start, const dem::Scenario& scenario, const io::RunFile& run);

}  // namespace soilweave::analysis
