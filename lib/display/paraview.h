// A folder for ParaView: VTK files, one .pvd per group, and a script.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "display/vtk.h"

namespace soilweave::io {

/// Throws DataError unless times increase, because ParaView cannot tell equal ones apart.
void demand_advance(const std::string& group, const std::vector<double>& times);

/// Writer of the folder. Whole files are renamed into place, .pvd files last.
class ParaviewFolder {
 public:
  /// Makes the folder. `force` removes earlier frames, tables and .pvd files; `compress` means zlib. Throws
  /// CannotCreate, also for a folder not empty without `force`.
  ParaviewFolder(std::filesystem::path folder, bool force, bool compress);

  /// Writes GROUP_INDEX.vtp (.vtu for hexahedra and meshes). Throws DataError if time does not increase.
  void add(const std::string& group, std::size_t index, const VtkPicture& picture);
  /// Writes NAME.csv, for tables without positions.
  void add_table(const std::string& name, const std::string& csv);
  /// Writes the .pvd files, and show.py for `paraview --script=show.py`.
  void finish() const;

 private:
  /// One written file.
  struct Frame {
    /// Time, s.
    double time;
    /// Name within the folder.
    std::string file;
  };
  std::filesystem::path folder_;
  bool compress_;
  /// Frames by group.
  std::map<std::string, std::vector<Frame>> groups_;
};

}  // namespace soilweave::io
