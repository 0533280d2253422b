// Temporary file that an output is written to before it is renamed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace soilweave::io {

/// A new file beside `target` with an unpredictable name (".NAME.0123456789abcdef.tmp"). It is opened exclusively, so
/// that no link or file of another user is taken. Its lock distinguishes it from the leftover of a killed process. It
/// has the permissions of an existing `target` before a byte is written, and its owner if the user may. It is removed
/// unless renamed. Throws CannotCreate.
class Temporary {
 public:
  /// Creates the file.
  explicit Temporary(const std::filesystem::path& target);
  ~Temporary();
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  /// Returns the open descriptor.
  int descriptor() const { return descriptor_; }
  /// Closes the file. Returns false if the system could not write all of it.
  bool close();
  /// Renames the file to its target. Throws CannotCreate.
  void rename();

 private:
  std::filesystem::path target_, path_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

/// Removes temporary files of `name` (empty: of any file) that ended processes left. Removes none without file locks.
void remove_left_temporaries(const std::filesystem::path& folder, std::string_view name);

}  // namespace soilweave::io
