// Written files: links, permissions, leftovers of earlier attempts, limits.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "store/bytes.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

#include "core/error.h"
#include "core/output_path.h"
#include "store/temporary.h"
#include "support/same_state.h"
#include "support/states.h"

namespace soilweave::io {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using test::expect_error;

mode_t mode_of(const fs::path& path) {
  struct stat status = {};
  return stat(path.c_str(), &status) == 0 ? status.st_mode & 07777 : 0;
}

class Bytes : public testing::Test {
 protected:
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder.path())) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }
  test::Folder folder;
};

TEST_F(Bytes, ALinkKeepsPointingToTheFileThatIsMadeOrReplaced) {
  fs::create_directory(folder / "far");
  fs::create_symlink("far/file", folder / "link");
  fs::create_symlink(folder / "link", folder / "link_to_link");
  write_bytes(folder / "link", "one");
  EXPECT_EQ(bytes_of(folder / "far/file"), "one");
  write_bytes(folder / "link_to_link", "two");
  EXPECT_EQ(bytes_of(folder / "far/file"), "two");
  EXPECT_TRUE(fs::is_symlink(folder / "link") && fs::is_symlink(folder / "link_to_link"));
  EXPECT_TRUE(same_file(folder / "link", folder / "far/file"));
  EXPECT_FALSE(same_file(folder / "link", folder / "other"));
  fs::create_symlink("round", folder / "round");
  expect_error<CannotCreate>([&] { write_bytes(folder / "round", "x"); }, "leads back to itself");
  fs::create_symlink("none/file", folder / "nowhere");
  expect_error<CannotCreate>([&] { demand_place(folder / "nowhere"); }, "a link to");
  // In a folder of the program's own a link is replaced, and its target stays.
  write_own_bytes(folder / "link", "own");
  EXPECT_EQ(bytes_of(folder / "far/file"), "two");
  EXPECT_FALSE(fs::is_symlink(folder / "link"));
}

TEST_F(Bytes, WhatIsReplacedKeepsItsPermissions) {
  test::put_bytes(folder / "file", "old");
  for (const mode_t mode : {0600U, 0640U, 0444U, 0755U}) {
    chmod((folder / "file").c_str(), mode);
    write_bytes(folder / "file", "new");
    EXPECT_EQ(mode_of(folder / "file"), mode);
  }
  const mode_t mask = umask(027);
  write_bytes(folder / "fresh", "new");
  umask(mask);
  EXPECT_EQ(mode_of(folder / "fresh"), 0640U);
}

TEST_F(Bytes, TemporaryFilesOfDeadProcessesGoAndOthersStay) {
  const std::string dead = ".out.h5.0123456789abcdef.tmp", alive = ".out.h5.fedcba9876543210.tmp";
  const std::vector<std::string> kept = {alive, ".out.h5.mine.tmp", ".x.h5.0123456789abcdef.tmp"};
  for (const std::string& name : kept) test::put_bytes(folder / name, "x");
  test::put_bytes(folder / dead, "x");
  fs::create_symlink("elsewhere", folder / ".out.h5.1111111111111111.tmp");
  const int lock = open((folder / alive).c_str(), O_RDONLY);
  ASSERT_EQ(flock(lock, LOCK_EX), 0);
  write_bytes(folder / "out.h5", "new");
  close(lock);
  EXPECT_FALSE(fs::exists(folder / dead));
  for (const std::string& name : kept) EXPECT_TRUE(fs::exists(folder / name)) << name;
}

TEST_F(Bytes, TemporaryNamesAreNewEachTimeAndFitBesideTheLongestName) {
  const auto names = [&](const std::string& target) {
    const Temporary one(folder / target), other(folder / target);
    return files();
  };
  EXPECT_EQ(names("a").size(), 2U);
  EXPECT_NE(names("a"), names("a"));
  EXPECT_TRUE(files().empty());
  write_bytes(folder / std::string(255, 'n'), "x");
  EXPECT_EQ(files(), std::vector<std::string>{std::string(255, 'n')});
  expect_error<CannotCreate>([&] { demand_place(folder / std::string(256, 'n')); }, "the name is too long");
}

TEST_F(Bytes, ALimitOnTheSizeOfFilesIsAFullDisk) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit = {1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    int status = 0;
    try {
      write_bytes(folder / "file", std::string(5000, 'x'));
    } catch (const IoError& error) {
      status = std::string(error.what()).find("ulimit -f") != std::string::npos ? 74 : 1;
    }
    _exit(status);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 74);
  EXPECT_TRUE(files().empty());
}

TEST_F(Bytes, AFolderOfTheProgramsOwnIsNoLink) {
  fs::create_directory(folder / "real");
  fs::create_directory_symlink("real", folder / "run.part");
  expect_error<CannotCreate>([&] { make_folder(folder / "run.part"); }, "is a link");
  EXPECT_NO_THROW(make_folder(folder / "real"));
}

}  // namespace
}  // namespace soilweave::io
