// Temporary files that are renamed to outputs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace soilweave::io {

/// A new, locked file beside `target` with an unpredictable name (".NAME.0123456789abcdef.tmp"). It is opened
/// exclusively, so that no link or other file is taken. The lock tells it from leftovers of killed processes. It has
/// the permissions of `target`, and its owner if possible. It is removed unless renamed.
class Temporary {
 public:
  /// Creates the file. Throws CannotCreate.
  explicit Temporary(const std::filesystem::path& target);
  ~Temporary();
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  /// Returns the open descriptor.
  int descriptor() const { return descriptor_; }
  /// Closes the file. Returns false if not all could be written.
  bool close();
  /// Renames the file to its target. Throws CannotCreate.
  void rename();

 private:
  std::filesystem::path target_, path_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

/// Removes temporary files of `name` (empty: any) that ended processes left. Removes none without file locks.
void remove_left_temporaries(const std::filesystem::path& folder, std::string_view name);

}  // namespace soilweave::io
