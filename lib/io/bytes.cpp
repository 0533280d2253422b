// Whole files through the POSIX calls that can sync and rename.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace soilweave::io {
namespace {

namespace fs = std::filesystem;

std::string reason() { return std::strerror(errno); }

/// A file descriptor that is closed at the end of its scope.
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
  struct stat status = {};
  if (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode))
    bytes.reserve(static_cast<std::size_t>(status.st_size) + 1);
  constexpr std::size_t block = std::size_t{1} << 20;
  std::size_t length = 0;
  for (;;) {
    bytes.resize(std::max(bytes.capacity(), length + block));
    const ssize_t got = ::read(descriptor, bytes.data() + length, bytes.size() - length);
    if (got < 0 && errno == EINTR) continue;
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
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) throw IoError(where + ": writing failed: " + reason() + "; make room or write elsewhere");
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

void sync_folder(const fs::path& folder) {
  const Descriptor d(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // Some file systems cannot sync a folder and say EINVAL; the file itself is safe by then.
  if (d && ::fsync(d.number()) != 0 && errno != EINVAL)
    throw IoError(folder.string() + ": syncing the folder failed: " + reason());
}

void write_in_place(const fs::path& path, std::string_view bytes) {
  Descriptor d(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!d) throw CannotCreate(path.string() + ": cannot be opened for writing: " + reason());
  write_all(d.number(), bytes, path.string());
  if (!d.close()) throw IoError(path.string() + ": writing failed: " + reason());
}

/// The temporary file, removed unless it was renamed.
class Temporary {
 public:
  explicit Temporary(const fs::path& target)
      : path_(target.parent_path() / ("." + target.filename().string() + "." + std::to_string(::getpid()) + ".tmp")) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (!renamed_) ::unlink(path_.c_str());
  }
  const fs::path& path() const { return path_; }
  void rename(const fs::path& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0)
      throw CannotCreate(target.string() + ": cannot be created: " + reason());
    renamed_ = true;
  }

 private:
  fs::path path_;
  bool renamed_ = false;
};

void replace(const fs::path& path, std::string_view bytes) {
  Temporary temporary(path);
  Descriptor d(::open(temporary.path().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!d) throw CannotCreate(path.string() + ": cannot be created: " + reason() + "; check its folder");
  write_all(d.number(), bytes, path.string());
  if (::fsync(d.number()) != 0) throw IoError(path.string() + ": syncing failed: " + reason());
  if (!d.close()) throw IoError(path.string() + ": writing failed: " + reason());
  temporary.rename(path);
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
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) throw CannotCreate(path.string() + ": a directory; name a file in it");
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_in_place(path, bytes);
  // A link keeps pointing to the file it names: that file is replaced, not the link.
  replace(fs::is_symlink(fs::symlink_status(path, ignored)) ? fs::weakly_canonical(path) : path, bytes);
}

void make_folder(const fs::path& path) {
  if (::mkdir(path.c_str(), 0777) == 0) return sync_folder(folder_of(path));
  const std::string why = reason();
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) throw CannotCreate(path.string() + ": cannot be created: " + why);
}

}  // namespace soilweave::io
