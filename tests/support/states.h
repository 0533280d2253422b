// States, runs and folders for the tests of files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>

#include "files/files.h"

namespace soilweave::io::test {

/// A folder of this process, removed at the end.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "soilweave-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void put_bytes(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// Numbers that use every bit of the fraction, equal in each call.
class Numbers {
 public:
  double operator()() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) * 0x1p-53 - 0.5;
  }
  Vec3 vector() { return {(*this)(), (*this)(), (*this)()}; }

 private:
  std::uint64_t state_ = 42;
};

/// Lets branch vectors and normals of contacts join the grains' centres, and point at planes.
inline void join_centres(Snapshot& state) {
  const std::vector<Vec3>& x = state.grains.position;
  ContactsRecord& c = state.contacts;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const auto [first, second] = c.bodies[k];
    const Vec3& from = x[static_cast<std::size_t>(first)];
    c.branch_vector[k] =
        second < 0 ? Vec3(-0.05 * state.planes.normal[static_cast<std::size_t>(-second - 1)])
                   : Vec3(x[static_cast<std::size_t>(second)] + state.cell.matrix * c.image[k].cast<double>() - from);
    c.normal[k] = c.branch_vector[k].normalized();
  }
}

/// Returns a chain of touching grains in a sheared cell, with contacts and their history, one of them through a
/// periodic face, and optional planes. Some numbers are denormal, negative zero or extreme.
inline Snapshot example_state(std::size_t grains = 12, int dimension = 3, bool planes = false) {
  Numbers any;
  Snapshot state;
  state.step = 1234567890123;
  state.time = 0.1 + 0.2;
  state.cell.matrix << 1, 0.25, 0, 0, 1.1, 0, 0, 0, dimension == 3 ? 0.9 : 0.7;
  state.cell.periodic = {true, !planes, dimension == 3};
  state.cell.velocity_gradient(0, 1) = -1.0 / 3;
  state.cell.deformation_gradient(1, 1) = 1.1;
  GrainsRecord& g = state.grains;
  g.dimension = dimension;
  for (std::size_t i = 0; i < grains; ++i) {
    g.body_id.push_back(static_cast<std::int64_t>(1000 - i));
    g.position.push_back(5 * any.vector());
    g.velocity.push_back(any.vector());
    if (dimension == 2) g.position.back().z() = g.velocity.back().z() = 0;
    g.orientation.push_back(Vec4(any(), any(), any(), any()).normalized());
    g.angular_velocity.push_back(any.vector());
    g.radius.push_back(0.05 + 0.01 * any());
    g.mass.push_back(1 + any());
    g.material_id.push_back(static_cast<std::int32_t>(i % 2));
    g.copy_id.push_back(static_cast<std::int32_t>(i % 3));
  }
  g.velocity[0] = {std::numeric_limits<double>::denorm_min(), -0.0, 0};
  g.velocity[1] = {std::numeric_limits<double>::max(), -std::numeric_limits<double>::min(), 0};
  if (planes) {
    state.planes.point = {Vec3(0, 0.1, 0), Vec3(0, 1, 0)};
    state.planes.normal = {Vec3(0, 1, 0), Vec3(0, -1, 0)};
    state.planes.velocity = {Vec3(0, 0, 0), Vec3(0, -0.01, 0)};
    state.planes.material_id = {0, 1};
  }
  ContactsRecord& c = state.contacts;
  for (std::int32_t i = 0; i + 1 < static_cast<std::int32_t>(grains); ++i) {
    c.bodies.push_back({i, planes && i == 3 ? -2 : i + 1});
    c.image.emplace_back(i == 0 ? -1 : 0, 0, 0);
    c.normal.emplace_back(Vec3::Zero());
    c.branch_vector.emplace_back(Vec3::Zero());
    c.overlap.push_back(1e-5 * any());
    c.normal_force.push_back(any());
    c.shear_force.push_back(any.vector());
    c.rolling_moment.push_back(any.vector());
    c.twisting_moment.push_back(any());
    c.sliding.push_back(static_cast<std::uint8_t>(i % 2));
  }
  join_centres(state);
  return state;
}

inline History example_history() {
  History history(3);
  history[0] = {"pack-generate", "1.2.3", "pack-generate --void-ratio 0.68", "", 18446744073709551615ULL, {}};
  history[0].inputs.push_back({"grading", std::string(64, 'a'), -1});
  history[1] = {"run-dem", "1.2.3", "run-dem", "[law]\nname = \"linear\"\n", 0, {}};
  history[1].inputs.push_back({"packing", std::string(64, 'b'), 0});
  history[2] = {"run-dem", "1.2.4", "run-dem --set a=1", std::string(70000, '#'), 7, {}};
  history[2].inputs = {{"packing", std::string(64, 'c'), 1}, {"scenario", std::string(64, 'd'), -1}};
  return history;
}

/// Returns three states of the same grains in which radii change and contacts come and go.
inline RunFile example_run(std::size_t grains = 12, bool planes = false) {
  RunFile run;
  for (int f = 0; f < 3; ++f) {
    Snapshot state = example_state(grains, 3, planes);
    state.step = 100 * f;
    state.time = 0.1 * f;
    for (double& radius : state.grains.radius) radius *= 1 + 0.001 * f;
    state.cell.matrix *= 1 + 1e-3 * f;
    if (f == 1) state.contacts = {};
    join_centres(state);
    run.snapshots.push_back(std::move(state));
  }
  run.series.columns = {{"step", "1", "number of time steps taken", {0, 100, 200, 250}},
                        {"time", "s", "time", {0, 0.1, 0.2, 0.25}},
                        {"p", "Pa", "mean stress", {1e5, 1.0 / 3, std::nan(""), -0.0}},
                        {"a", "1", "comes last, though first by name", {1, 2, 3, 4}}};
  run.work = {250, 12345};
  run.scenario = "[stage]\nname = \"isotropic\"  # µ = 0.5\n";
  return run;
}

}  // namespace soilweave::io::test
