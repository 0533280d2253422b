// The file that an output is written to before it takes its name.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace soilweave::io {

/// A new file beside `target`, under a name nobody can foretell (".NAME.0123456789abcdef.tmp"), opened exclusively, so
/// that no link or file of another is ever followed or taken; locked while it lives, which tells it from one that a
/// process left when it was killed. Where `target` is there, the new file gets its permissions (and its owner, if the
/// user may give files away) before a byte is in it. Removed unless it was renamed. Throws CannotCreate.
class Temporary {
 public:
  explicit Temporary(const std::filesystem::path& target);
  ~Temporary();
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  int descriptor() const { return descriptor_; }
  /// Closes the file; false where the system could not write all of it.
  bool close();
  /// Gives the file its target's name. Throws CannotCreate.
  void rename();

 private:
  std::filesystem::path target_, path_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

/// Removes the temporary files in a folder that processes which are gone left of the file `name`; empty: of any file.
/// Where the file system knows no locks none is taken for left.
void remove_left_temporaries(const std::filesystem::path& folder, std::string_view name);

}  // namespace soilweave::io
