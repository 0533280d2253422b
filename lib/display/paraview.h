// A folder for ParaView: numbered VTK files, one .pvd per group with the physical times, and a script that shows them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "display/vtk.h"

namespace soilweave::io {

/// Throws DataError if the times of a group's frames do not increase, because ParaView could not tell them apart.
void demand_advance(const std::string& group, const std::vector<double>& times);

/// Writer of the folder. Files are renamed when whole, the .pvd files last.
class ParaviewFolder {
 public:
  /// Makes the folder. `force` removes the frames, tables and .pvd files of an earlier call; other files stay.
  /// compress: zlib. Throws CannotCreate, also for a folder that is not empty without `force`.
  ParaviewFolder(std::filesystem::path folder, bool force, bool compress);

  /// Writes GROUP_INDEX.vtp (.vtu for a hexahedron or a mesh). Throws DataError if the group's time does not increase.
  void add(const std::string& group, std::size_t index, const VtkPicture& picture);
  /// Writes NAME.csv, for columns without a position.
  void add_table(const std::string& name, const std::string& csv);
  /// Writes one .pvd per group, and show.py for `paraview --script=show.py`.
  void finish() const;

 private:
  /// One written file, with its time.
  struct Frame {
    double time;  // s
    std::string file;
  };
  std::filesystem::path folder_;
  bool compress_;
  std::map<std::string, std::vector<Frame>> groups_;
};

}  // namespace soilweave::io
