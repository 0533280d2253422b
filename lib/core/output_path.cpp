// Links, folders and rights of an output.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/output_path.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "core/error.h"

namespace soilweave {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  // the kernel's own limit

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// Returns whether the file at `path` is another user's, in a folder where only owners may rename and remove (sticky).
bool of_another_user(const fs::path& path) {
  struct stat folder = {}, file = {};
  if (::stat(folder_of(path).c_str(), &folder) != 0 || ::lstat(path.c_str(), &file) != 0) return false;
  const uid_t user = ::geteuid();
  return (folder.st_mode & S_ISVTX) != 0 && file.st_uid != user && file.st_uid != folder.st_uid;
}

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw CannotCreate(fmt::format("{}: {}", path.string(), why));
}

}  // namespace

fs::path followed(const fs::path& path) {
  fs::path at = path;
  for (int links = 0; links <= most_links; ++links) {
    std::error_code failure;
    if (!fs::is_symlink(fs::symlink_status(at, failure))) return at;
    if (of_another_user(at)) refuse(at, "is a link that another user put into a shared folder; name another file");
    const fs::path target = fs::read_symlink(at, failure);
    if (failure) refuse(at, "is a link that cannot be read: " + failure.message());
    at = target.is_absolute() ? target : at.parent_path() / target;
  }
  refuse(path, "is a link that leads back to itself; remove it, or name another file");
}

bool same_file(const fs::path& one, const fs::path& other) {
  std::error_code failure;
  if (fs::equivalent(one, other, failure)) return true;
  const auto place = [](const fs::path& path) {
    const fs::path file = followed(path);
    std::error_code missing;
    const fs::path folder = fs::canonical(folder_of(file), missing);
    return missing ? fs::absolute(file, missing).lexically_normal() : folder / file.filename();
  };
  return place(one) == place(other);
}

bool written_in_place(const fs::path& path) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void demand_place(const fs::path& path) {
  if (written_in_place(path)) {
    if (::access(path.c_str(), W_OK) != 0) refuse(path, fmt::format("cannot be written to: {}", std::strerror(errno)));
    return;
  }
  const fs::path file = followed(path), folder = folder_of(file);
  const std::string link = file == path ? "" : fmt::format("a link to {}, which ", file.string());
  struct stat status = {};
  if (::lstat(file.c_str(), &status) != 0 && errno == ENAMETOOLONG)
    refuse(path, link + "cannot be created: the name is too long; shorten it");
  const auto no_folder = [&](const std::string& why) {
    refuse(path, fmt::format("{}cannot be created: {} {}", link, folder.string(), why));
  };
  if (::stat(folder.c_str(), &status) != 0)
    no_folder(errno == ENOENT ? "is not a directory; make it first"
                              : fmt::format("cannot be reached: {}; name another folder", std::strerror(errno)));
  if (!S_ISDIR(status.st_mode)) no_folder("is a file, not a directory; name another folder");
  if (::access(folder.c_str(), W_OK) != 0)
    refuse(path, fmt::format("{}cannot be created: {}: {}; name another folder", link, folder.string(),
                             std::strerror(errno)));
  if (::geteuid() != 0 && of_another_user(file))
    refuse(path, link + "belongs to another user, whose files nobody else may replace in this folder; name another");
}

}  // namespace soilweave
