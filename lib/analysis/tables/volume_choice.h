// Volumes of interest that a user asks for.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/measure/volume_of_interest.h"

namespace soilweave::analysis {

/// Choice of volumes to average over.
struct VolumeChoice {
  /// Boxes as "x0,x1,y0,y1,z0,z1", in 2D "x0,x1,y0,y1", m.
  std::vector<std::string> boxes;
  bool copies = false, groups = false;

  /// Returns whether no volume is asked for.
  bool empty() const { return boxes.empty() && !copies && !groups; }
  /// Adds one line for each box that is not four or six numbers from low to high.
  void check(std::vector<std::string>& wrong) const;
  /// Returns copies, then groups, then boxes. `where` names the state's file. Throws DataError if copies or groups are
  /// requested and the state has none, for a box of another dimension, and for one with an edge of more than 100 times
  /// the extent of the state, or with edges of more than 20 times along all axes, as coordinates in millimetres give.
  std::vector<Volume> volumes(const io::Snapshot& state, const std::string& where) const;
};

}  // namespace soilweave::analysis
