// Every reader under unchecked bytes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/hostile.h"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "calibration/prior.h"
#include "core/error.h"
#include "core/text/settings.h"
#include "dem/engine/simulation.h"
#include "dem/loading/path.h"
#include "dem/run/scenario.h"
#include "fem/run/scenario.h"
#include "files/exchange/spheres_text.h"
#include "files/exchange/table.h"
#include "files/files.h"
#include "gws/solution/geotextile.h"
#include "gws/solution/soil.h"
#include "packing/container/shapes/surface.h"
#include "packing/expand/plan.h"
#include "packing/generate/grading.h"

namespace soilweave::hostile {
namespace {

template <class F>
void expect_error_of_ours(F f) {
  try {
    f();
  } catch (const Error&) {
  }
}

// A file of this process, for readers that need a path.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes, const std::string& ending = "") {
    path_ += ending;
    const int number = mkstemps(path_.data(), static_cast<int>(ending.size()));
    if (number < 0 || ::write(number, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) std::abort();
    ::close(number);
  }
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;
  ~Bytes() { std::filesystem::remove(path_); }
  const std::string& path() const { return path_; }

 private:
  std::string path_ = (std::filesystem::temp_directory_path() / "soilweave-XXXXXX").string();
};

dem::Model sand() {
  Settings document =
      Settings::parse("[contact]\nlaw = \"linear\"\nyoung_modulus = 1e8\nstiffness_ratio = 0.3\n", "sand");
  return dem::read_model(document);
}

}  // namespace

void scenario(std::string_view bytes) {
  expect_error_of_ours([&] {
    const dem::Scenario read = dem::read_scenario(bytes, "scenario", {});
    const dem::PathState state{3, Mat3::Identity(), Vec3::Zero()};
    for (const dem::Stage& stage : read.stages) stage.path->goals(stage.path->stations() - 1, state);
  });
  expect_error_of_ours([&] { fem::read_scenario(bytes, "scenario", {}, std::nullopt); });
  expect_error_of_ours([&] { packing::read_plan(bytes, "plan", {}); });
  expect_error_of_ours([&] { gws::read_geotextile(std::string(bytes), "geotextile"); });
  for (const auto read :
       {+[](Settings& s) { (void)calibration::read_prior(s); }, +[](Settings& s) { (void)gws::read_soil(s); },
        +[](Settings& s) { (void)dem::read_model(s); }})
    expect_error_of_ours([&] {
      Settings document = Settings::parse(bytes, "document");
      read(document);
      document.finish();
    });
}

void table(std::string_view bytes) {
  expect_error_of_ours([&] { io::from_tsv(bytes, "table"); });
  expect_error_of_ours([&] { packing::Grading::from_tsv(bytes, "grading").radii(100, 3); });
}

void spheres(std::string_view bytes) {
  const Bytes text(bytes);
  for (const std::optional<io::CellRecord>& cell : {std::optional<io::CellRecord>(), std::optional(io::CellRecord())})
    expect_error_of_ours([&] {
      const io::ImportedSpheres read = io::import_spheres(text.path(), {2650, cell, {}});
      dem::Simulation simulation(read.state, sand(), {});
      for (int step = 0; step < 2; ++step) simulation.step();
    });
}

void mesh(std::string_view bytes) {
  expect_error_of_ours([&] { fem::read_gmsh(bytes, "mesh"); });
}

void surface(std::string_view bytes) {
  const Bytes file(bytes, ".stl");
  expect_error_of_ours([&] {
    const packing::Surface read(file.path());
    (void)read.depth(0.5 * (read.low() + read.high()));
  });
}

void file(std::string_view bytes) {
  const Bytes file(bytes);
  expect_error_of_ours([&] { io::read_kind(file.path()); });
  expect_error_of_ours([&] { io::read_history(file.path()); });
  expect_error_of_ours([&] { io::read_states(file.path()); });
  expect_error_of_ours([&] { io::read_run_series(file.path()); });
  expect_error_of_ours([&] { io::read_fields(file.path()); });
  expect_error_of_ours([&] { io::read_ensemble(file.path()); });
}

Reader reader(std::string_view name) {
  if (name == "scenario") return scenario;
  if (name == "table") return table;
  if (name == "spheres") return spheres;
  if (name == "mesh") return mesh;
  if (name == "surface") return surface;
  if (name == "file") return file;
  return nullptr;
}

}  // namespace soilweave::hostile
