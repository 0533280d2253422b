// Temporary files.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "store/temporary.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace soilweave::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view temporary_ending = ".tmp";
constexpr std::size_t digits = 16;

/// Returns ".NAME." of a target, with a long name cut so that the whole fits the 255 bytes of a file name.
std::string prefix_of(std::string_view name) {
  constexpr std::size_t longest = 255 - 2 - digits - temporary_ending.size();
  return fmt::format(".{}.", name.substr(0, longest));
}

/// Returns whether `file` names a temporary file of `name` (empty: of any file).
bool is_temporary(std::string_view file, std::string_view name) {
  if (!file.starts_with(name.empty() ? "." : prefix_of(name)) || !file.ends_with(temporary_ending)) return false;
  file.remove_suffix(temporary_ending.size());
  if (file.size() < digits + 2 || file[file.size() - digits - 1] != '.') return false;
  if (!name.empty() && file.size() != prefix_of(name).size() + digits) return false;
  const std::string_view number = file.substr(file.size() - digits);
  return number.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string random_number() {
  std::uint64_t number = 0;
  if (::getrandom(&number, sizeof number, 0) != static_cast<ssize_t>(sizeof number))
    throw CannotCreate(fmt::format("the system gives no random number: {}", std::strerror(errno)));
  return fmt::format("{:016x}", number);
}

/// Locks a file of this process. Returns false if another process, cleaning up, locked or removed it first.
bool lock(int descriptor) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
  struct stat status = {};
  return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

/// Gives the file the permissions of the file that it will replace, and its owner and group as far as the user may.
void resemble(int descriptor, const struct stat& model) {
  constexpr mode_t special = S_ISUID | S_ISGID;
  const bool given = ::fchown(descriptor, model.st_uid, model.st_gid) == 0 ||
                     (::fchown(descriptor, static_cast<uid_t>(-1), model.st_gid) == 0 && model.st_uid == ::geteuid());
  // A failure is harmless: it means that the file system has no permissions.
  if (::fchmod(descriptor, model.st_mode & 07777 & ~(given ? 0 : special)) != 0) return;
}

}  // namespace

Temporary::Temporary(const fs::path& target) : target_(target) {
  struct stat model = {};
  const bool replaces = ::stat(target.c_str(), &model) == 0 && S_ISREG(model.st_mode);
  const std::string prefix = prefix_of(target.filename().string());
  constexpr int attempts = 100;
  for (int k = 0; k < attempts && descriptor_ < 0; ++k) {
    path_ = target.parent_path() / (prefix + random_number() + std::string(temporary_ending));
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, replaces ? 0600 : 0666);
    if (descriptor_ < 0 && errno == EEXIST) continue;
    if (descriptor_ < 0) break;
    if (!lock(descriptor_)) ::close(std::exchange(descriptor_, -1)), ::unlink(path_.c_str()), errno = EAGAIN;
  }
  if (descriptor_ < 0)
    throw CannotCreate(
        fmt::format("{}: cannot be created: {}; check its folder", target.string(), std::strerror(errno)));
  if (replaces) resemble(descriptor_, model);
}

Temporary::~Temporary() {
  if (!renamed_) ::unlink(path_.c_str());
  close();
}

bool Temporary::close() { return descriptor_ < 0 || ::close(std::exchange(descriptor_, -1)) == 0; }

void Temporary::rename() {
  if (::rename(path_.c_str(), target_.c_str()) != 0)
    throw CannotCreate(fmt::format("{}: cannot be created: {}", target_.string(), std::strerror(errno)));
  renamed_ = true;
}

void remove_left_temporaries(const fs::path& folder, std::string_view name) {
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
    const fs::path& path = entry->path();
    if (!is_temporary(path.filename().string(), name)) continue;
    const int file = ::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    struct stat status = {};
    if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && ::flock(file, LOCK_EX | LOCK_NB) == 0)
      ::unlink(path.c_str());
    ::close(file);
  }
}

}  // namespace soilweave::io
