// A folder ParaView opens: numbered VTK files, one .pvd a group with the physical times, and a script that shows them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/vtk.h"

namespace soilweave::io {

/// Throws DataError where the times of a group's frames do not advance: ParaView could not tell them apart.
void demand_advance(const std::string& group, const std::vector<double>& times);

/// Every file is written under a temporary name and renamed, the .pvd files last: a reader meets whole files only.
class ParaviewFolder {
 public:
  /// Makes the folder. One that holds anything is refused without `force`; with it the frames, tables and .pvd files an
  /// earlier call left are removed, other files are left alone. compress: zlib. Throws CannotCreate.
  ParaviewFolder(std::filesystem::path folder, bool force, bool compress);

  /// Writes GROUP_INDEX.vtp (.vtu for a hexahedron or a mesh) and notes its time. The frames of a group come in order
  /// of time; throws DataError where time does not advance.
  void add(const std::string& group, std::size_t index, const VtkPicture& picture);
  /// Writes NAME.csv: columns without a place in space.
  void add_table(const std::string& name, const std::string& csv);
  /// Writes one .pvd a group, and show.py: `paraview --script=show.py`.
  void finish() const;

 private:
  struct Frame {
    double time;  // s
    std::string file;
  };
  std::filesystem::path folder_;
  bool compress_;
  std::map<std::string, std::vector<Frame>> groups_;
};

}  // namespace soilweave::io
