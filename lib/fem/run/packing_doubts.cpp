// Doubts about the packings of a two-scale run before its first step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/run/packing_doubts.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "analysis/doubts/loading_doubts.h"
#include "analysis/doubts/material_doubts.h"
#include "analysis/tables/doubts.h"

namespace soilweave::fem {
namespace {

std::optional<Doubt> jump(const io::Snapshot& packing, const io::Snapshot& begun) {
  const std::optional<analysis::StressChange> change = analysis::stress_change(packing, begun);
  if (!change) return std::nullopt;
  const std::string cause =
      change->moved ? "the grains do not lie where the contacts of the file were"
                    : "the scenario has another law, stiffness or friction than the packing was made with: give that "
                      "one";
  return Doubt{"jump",
               fmt::format("the points begin at a mean stress of {:.4g} kPa, and the packing's file has {:.4g}: "
                           "{}, or bring the packing to its stress with this [contact] first, by run-dem",
                           change->after / 1e3, change->before / 1e3, cause)};
}

}  // namespace

std::vector<Doubt> packing_doubts(const std::vector<io::Snapshot>& packings, const ModelSetup& setup,
                                  const Model& model) {
  std::vector<Doubt> doubts;
  for (Index k = 0; k < packings.size(); ++k) {
    std::vector<Doubt> found = analysis::cell_doubts(packings[k]);
    for (Doubt& doubt : analysis::material_doubts(packings[k], setup.grains.model, Vec3::Zero()))
      found.push_back(std::move(doubt));
    // A packing for all points is that of point 0, too.
    if (std::optional<Doubt> doubt = jump(packings[k], *model.points()[k]->packing())) found.push_back(*doubt);
    for (Doubt& doubt : found) {
      if (packings.size() > 1)
        doubt.sentence = fmt::format("packing {} of {}: {}", k + 1, packings.size(), doubt.sentence);
      doubts.push_back(std::move(doubt));
    }
  }
  return doubts;
}

}  // namespace soilweave::fem
