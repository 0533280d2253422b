// Supports and tractions of a two-scale scenario, and doubts about what they load.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "core/text/settings.h"
#include "fem/model/model.h"

namespace soilweave::fem {

/// Reads [[support]] and [[traction]]. The soil must have its mesh. Tables with a mistake are left out.
void read_boundary_conditions(Settings& document, SoilSetup& soil);

/// Returns whether a support moves the soil, or an end of the chain is pulled.
bool is_driven(const ModelSetup& setup);

/// Returns doubts about tractions that supports carry whole, tractions that pull a soil without tension, pieces of soil
/// that no support holds against their tractions, and a soil that nothing loads.
std::vector<Doubt> loading_doubts(const ModelSetup& setup);

/// Returns "load_unbalanced" if the initial stress of the points misses a traction or the seat pressure by more than a
/// tenth where the soil is free. Empty for soil without initial stress. Shear stress is judged under shear tractions.
/// model: before its first step.
std::vector<Doubt> balance_doubts(const ModelSetup& setup, const Model& model);

/// Returns "uncarried" if a seat pressure acts on bars below which no guide lies.
std::vector<Doubt> guide_doubts(const Model& model);

}  // namespace soilweave::fem
