// Whole files by the POSIX calls that sync and rename.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "store/bytes.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "core/output_path.h"
#include "store/temporary.h"

namespace soilweave::io {
namespace {

namespace fs = std::filesystem;

std::string reason() { return std::strerror(errno); }

/// Returns the remedy for a write that failed, from errno: room on the disk, a greater quota, a higher limit.
std::string remedy() {
  switch (errno) {
    case ENOSPC:
      return "; make room or write elsewhere";
    case EDQUOT:
      return "; your share of the disk is used up: remove files, ask for more (quota), or write elsewhere";
    case EFBIG:
      return "; files may not be larger here: raise the limit (ulimit -f) or write elsewhere";
    default:
      return "; write elsewhere";
  }
}

/// Waits until a non-blocking descriptor is ready. Returns false if the call failed for another reason.
bool waited(int descriptor, short wanted) {
  if (errno == EINTR) return true;
  if (errno != EAGAIN) return false;
  pollfd ready{descriptor, wanted, 0};
  return ::poll(&ready, 1, -1) == 1 || errno == EINTR;
}

/// A file descriptor, closed at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  explicit operator bool() const { return number_ >= 0; }
  int number() const { return number_; }
  bool close() { return number_ < 0 || ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

std::string read_all(int descriptor, const std::string& where) {
  std::string bytes;
  constexpr std::size_t block = std::size_t{1} << 20;
  std::size_t length = 0, more = block;
  struct stat status = {};
  // A file gets room for one byte more than it has, so that its end is seen without more memory.
  if (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) more = static_cast<std::size_t>(status.st_size) + 1;
  for (;;) {
    if (length == bytes.size()) {
      bytes.resize(length + more);
      more = std::max(block, bytes.size());
    }
    const ssize_t got = ::read(descriptor, bytes.data() + length, bytes.size() - length);
    if (got < 0 && waited(descriptor, POLLIN)) continue;
    if (got < 0) throw IoError(where + ": reading failed: " + reason());
    if (got == 0) break;
    length += static_cast<std::size_t>(got);
  }
  bytes.resize(length);
  return bytes;
}

void write_all(int descriptor, std::string_view bytes, const std::string& where) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(descriptor, bytes.data(), bytes.size());
    if (put < 0 && waited(descriptor, POLLOUT)) continue;
    if (put < 0) throw IoError(where + ": writing failed: " + reason() + remedy());
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

void sync_folder(const fs::path& folder) {
  const Descriptor d(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // Some file systems cannot sync a folder and return EINVAL; the file itself is safe by then.
  if (d && ::fsync(d.number()) != 0 && errno != EINVAL)
    throw IoError(folder.string() + ": syncing the folder failed: " + reason());
}

void write_in_place(const fs::path& path, std::string_view bytes) {
  Descriptor d(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!d) throw CannotCreate(path.string() + ": cannot be opened for writing: " + reason());
  write_all(d.number(), bytes, path.string());
  if (!d.close()) throw IoError(path.string() + ": writing failed: " + reason());
}

void replace(const fs::path& path, std::string_view bytes) {
  Temporary temporary(path);
  write_all(temporary.descriptor(), bytes, path.string());
  if (::fsync(temporary.descriptor()) != 0) throw IoError(path.string() + ": syncing failed: " + reason() + remedy());
  if (!temporary.close()) throw IoError(path.string() + ": writing failed: " + reason() + remedy());
  temporary.rename();
  sync_folder(folder_of(path));
}

}  // namespace

std::string input_name(const fs::path& path) { return path == "-" ? "standard input" : path.string(); }

std::string read_bytes(const fs::path& path) {
  const std::string where = input_name(path);
  if (path == "-") {
    if (::isatty(STDIN_FILENO)) throw DataError(where + ": a terminal; pipe or redirect a file into it");
    return read_all(STDIN_FILENO, where);
  }
  const Descriptor d(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!d && (errno == ENOENT || errno == ENOTDIR))
    throw MissingInput(where + ": no such file; check the path, or make the file first");
  if (!d && errno == EACCES) throw MissingInput(where + ": may not be read; check its permissions");
  if (!d) throw IoError(where + ": cannot be opened: " + reason());
  struct stat status = {};
  if (fstat(d.number(), &status) == 0 && S_ISDIR(status.st_mode))
    throw DataError(where + ": a directory; name a file in it");
  return read_all(d.number(), where);
}

void write_bytes(const fs::path& path, std::string_view bytes) {
  if (path == "-") return write_all(STDOUT_FILENO, bytes, "standard output");
  if (path.empty()) throw CannotCreate("no output file named");
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw CannotCreate(path.string() + ": a directory; name a file in it");
  if (written_in_place(path)) return write_in_place(path, bytes);
  // A link keeps pointing to its target, which is made or replaced.
  const fs::path file = followed(path);
  remove_left_temporaries(folder_of(file), file.filename().string());
  replace(file, bytes);
}

void write_own_bytes(const fs::path& path, std::string_view bytes) { replace(path, bytes); }

void make_folder(const fs::path& path) {
  if (::mkdir(path.c_str(), 0777) == 0) return sync_folder(folder_of(path));
  const std::string why = reason();
  std::error_code ignored;
  const fs::file_status there = fs::symlink_status(path, ignored);
  if (fs::is_symlink(there))
    throw CannotCreate(path.string() + ": is a link, and a folder of its own belongs there; remove the link");
  if (!fs::is_directory(there)) throw CannotCreate(path.string() + ": cannot be created: " + why);
}

}  // namespace soilweave::io
