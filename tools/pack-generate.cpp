// pack-generate: from a grading curve to a packing of given void ratio at given pressure.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "core/error.h"
#include "core/progress.h"
#include "core/stop_signals.h"
#include "core/tool.h"
#include "dem/scenario.h"
#include "io/files.h"
#include "io/safe_output.h"
#include "io/spheres_text.h"
#include "packing/cloud.h"
#include "packing/generate.h"
#include "packing/grading.h"
#include "packing/spatial_order.h"

namespace {

using namespace soilweave;

constexpr Parameter grains_parameter{"grains", "1", 10, 1e8, false, "number of grains", "fewer cannot carry a load"};
constexpr Parameter void_ratio_parameter{"void_ratio", "1", 0, 5, true, "void ratio to reach"};
constexpr Parameter pressure_parameter{"pressure",
                                       "Pa",
                                       0,
                                       1e12,
                                       true,
                                       "isotropic pressure it holds at",
                                       "a packing needs contacts, and contacts need a pressure"};
constexpr Parameter radius_parameter{"mean_radius", "m", 0, 1e3, true, "mean radius the grading is scaled to"};
constexpr Parameter cloud_parameter{
    "cloud_void_ratio", "1", 1, 1e3, false, "void ratio of the initial cloud", "grains placed at random jam below it"};
constexpr Parameter aspect_parameter{"aspect", "1", 0.1, 10, false, "height of the cell over its width"};
constexpr Parameter dimension_parameter{"dimension", "1", 2, 3, false, "3 for spheres, 2 for disks"};
constexpr Parameter density_parameter{"density", "kg/m3", 0, 1e12, true, "density of the grains, scaling included"};
constexpr Parameter rate_parameter{"max_rate", "1/s", 0, 1e3, true, "largest strain rate while compressing"};
constexpr Parameter tolerance_parameter{"tolerance", "1", 0, 1, true, "unbalanced force of an equilibrium"};

// Thesis Table 3.1, soil.
constexpr std::string_view default_material =
    "[contact]\nlaw = \"hertz-mindlin\"\nyoung_modulus = \"4 GPa\"\npoisson_ratio = 0.33\nfriction_angle = 29\n"
    "[contact.rolling]\nstiffness = 0.13\nlimit = \"none\"\n[contact.twisting]\nstiffness = 0.13\nlimit = \"none\"\n";

// Solid volume per grain of the thesis's representative volume of 1000 grains, 46.2202 x 46.1205 x 92.1203 mm at a void
// ratio of 0.6798, m3: the built-in curve is scaled to it. Grains are of the same size however many they are, since
// parameters that hold a length, as the absolute rolling stiffness does, belong to a size.
constexpr double thesis_solids = 1.169e-7;

struct PackGenerate {
  std::filesystem::path output, material, import;
  std::string grading = "toyoura", cell;
  std::int64_t grains = 1000, dimension = 3;
  std::optional<double> void_ratio, mean_radius;
  double pressure = 1e3, cloud_void_ratio = 2.5, aspect = 2, density = 2650e3, max_rate = 1, tolerance = 1e-3;
  double interval = 300;
  bool as_is = false;

  void options(tool::Table& table) {
    table.about(
        "pack-generate", "make a packing of grains from a grading curve, at a void ratio and a pressure",
        "A random cloud in a periodic cell is compressed isotropically to the pressure; then the inter-particle "
        "friction is lowered step by step until the void ratio is reached, and restored.");
    table.example("pack-generate --grains 300 --void-ratio 0.70 --pressure 1e5 -o packing.h5", "Toyoura grading");
    table.example("pack-generate --import spheres.txt --as-is -o imported.h5", "a packing from another code");
    table.option(grading, "grading", "NAME|FILE", "toyoura, or a table: diameter [mm], finer_by_mass [%]");
    table.option(grains, grains_parameter);
    table.option(void_ratio, void_ratio_parameter);
    table.option(pressure, pressure_parameter);
    table.option(dimension, dimension_parameter);
    table.option(mean_radius, radius_parameter);
    table.option(aspect, aspect_parameter);
    table.option(cloud_void_ratio, cloud_parameter);
    table.option(material, "material", "FILE", "TOML with [contact] and [grains]; default: thesis Table 3.1");
    table.option(density, density_parameter);
    table.option(max_rate, rate_parameter);
    table.option(tolerance, tolerance_parameter);
    table.option(import, "import", "FILE",
                 "start from a packing file, or from text: x y z r (disks x y r) or named columns");
    table.option(cell, "cell", "LX,LY,LZ", "periodic cell of a text without a ##PERIODIC:: line, m; of disks LX,LY");
    table.flag(as_is, "as-is", "write the imported packing as it is, but many loose grains in spatial order");
    table.output(output, "packing to write");
    table.resume(interval);
    table.seed();
    table.threads();
  }

  void validate() const {
    if (as_is && import.empty()) throw UsageError("--as-is needs --import FILE");
    if (!cell.empty() && import.empty()) throw UsageError("--cell needs --import FILE");
    if (!cell.empty() && is_ours()) throw UsageError("--cell: " + import.string() + " has a cell of its own");
    if (!cell.empty()) io::periodic_cell(cell, "--cell");
    const PackGenerate standard;
    const bool new_cloud = grading != standard.grading || grains != standard.grains || mean_radius ||
                           aspect != standard.aspect || cloud_void_ratio != standard.cloud_void_ratio ||
                           (is_ours() && dimension != standard.dimension);
    if (!import.empty() && new_cloud)
      throw UsageError(
          "--grading, --grains, --mean-radius, --aspect, --cloud-void-ratio and, beside a packing file, --dimension "
          "are of a new packing: leave them out with --import");
    const bool load =
        void_ratio || pressure != standard.pressure || max_rate != standard.max_rate || tolerance != standard.tolerance;
    if (as_is && load)
      throw UsageError(
          "--void-ratio, --pressure, --max-rate and --tolerance would change the packing: leave out --as-is");
  }

  void run(const tool::Invocation& invocation) const {
    std::vector<io::Source> sources;
    const io::TextFile text =
        material.empty() ? io::TextFile{std::string(default_material), {}} : io::read_text(material, "material");
    if (!material.empty()) sources.push_back(text.source);
    Settings document = Settings::parse(text.text, material.empty() ? "default material" : material.string());
    const dem::Model model = dem::read_model(document);
    const double read_density = dem::read_density(document);
    dem::Numerics numerics = dem::read_numerics(document);
    document.finish();
    numerics.threads = invocation.threads;
    const double rho = read_density > 0 ? read_density : density;
    std::vector<std::string> notes;
    const io::Snapshot state =
        import.empty() ? make_cloud(rho, invocation.seed, sources, notes) : read_import(rho, sources, notes);
    const std::string law = as_is && material.empty() ? "" : document.resolved();
    const io::History history = io::extend(sources, invocation, law);
    const StopSignals signals;
    Progress progress("pack-generate", invocation.quiet);
    for (const std::string& note : notes) progress.note("pack-generate: " + note);
    io::SafeOutput safe(output, history, invocation);
    if (safe.finished(progress)) return;
    if (as_is) {
      const dem::Simulation checked(state, model, numerics);  // refuses grains that overlap too much
      return void(safe.write([&] { io::write_packing(output, state, history); }));
    }
    const packing::Report report = [&](double f, const std::string& detail) { progress.update(f, detail); };
    packing::Result result =
        packing::compact(state, model, numerics, recipe(numerics), report, {safe.part(), interval, &signals});
    result.price.output += safe.write([&] { io::write_packing(output, result.state, history); });
    if (output != "-") progress.note("pack-generate: " + result.price.line());
  }

  packing::Recipe recipe(const dem::Numerics& numerics) const {
    return {.pressure = pressure,
            .void_ratio = void_ratio,
            .tolerances = {.unbalanced_force = tolerance},
            .max_rate = max_rate,
            .damping = numerics.damping};
  }

  io::Snapshot make_cloud(double rho, std::uint64_t seed, std::vector<io::Source>& sources,
                          std::vector<std::string>& notes) const {
    packing::Grading curve;
    if (grading == "toyoura") {
      curve = packing::Grading::toyoura();
    } else {
      const io::TextFile table = io::read_text(grading, "grading");
      sources.push_back(table.source);
      curve = packing::Grading::from_tsv(table.text, grading);
      if (const std::string lack = curve.left_out(); !lack.empty()) notes.push_back(grading + ": " + lack);
    }
    const int d = static_cast<int>(dimension);
    std::vector<double> radii = curve.radii(static_cast<std::size_t>(grains), d);
    scale(radii);
    return packing::cloud(radii, cloud_void_ratio, {1, d == 2 ? aspect : 1.0, aspect}, d, rho, seed);
  }

  void scale(std::vector<double>& radii) const {
    double sum = 0, cubes = 0;
    for (const double r : radii) sum += r, cubes += r * r * r;
    double factor = 1;
    if (mean_radius)
      factor = *mean_radius * static_cast<double>(radii.size()) / sum;
    else if (grading == "toyoura")
      factor = std::cbrt(thesis_solids * static_cast<double>(radii.size()) / (4.0 / 3.0 * std::numbers::pi * cubes));
    for (double& r : radii) r *= factor;
  }

  bool is_ours() const { return import.extension() == ".h5"; }

  io::Snapshot read_import(double rho, std::vector<io::Source>& sources, std::vector<std::string>& notes) const {
    if (is_ours()) {
      io::PackingFile file = io::read_state(import);
      sources.push_back(file.source);
      return packing::in_spatial_order(file.state);
    }
    io::SpheresOptions options{rho, {}, {}};
    if (!cell.empty()) options.cell = io::periodic_cell(cell, "--cell");
    if (dimension == 2 || (options.cell && !options.cell->periodic[2])) options.dimension = 2;
    io::ImportedSpheres read = io::import_spheres(import, options);
    sources.push_back(read.source);
    notes = read.notes;
    return packing::in_spatial_order(read.state);
  }
};

}  // namespace

int main(int argc, char** argv) { return tool::start<PackGenerate>(argc, argv); }
