// pack-generate: from a grading curve to a packing of given void ratio at given pressure.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <string>

#include "core/cli/tool.h"
#include "core/error.h"
#include "core/progress.h"
#include "core/stop_signals.h"
#include "files/files.h"
#include "files/safe_output.h"
#include "packing/container/geotextile.h"
#include "packing/generate/doubtful.h"
#include "packing/generate/generate.h"
#include "packing/generate/grading.h"
#include "packing/generate/imported.h"
#include "packing/generate/standard.h"

namespace {

using namespace soilweave;

constexpr Parameter grains_parameter{
    "grains", "1", 10, 1e8, false, "number of grains; more for a wide grading", "fewer cannot carry a load"};
constexpr Parameter void_ratio_parameter{"void_ratio", "1", 0, 5, true, "void ratio to reach"};
constexpr Parameter pressure_parameter{
    "pressure", "Pa", 0, 1e12, true, "isotropic pressure of the finished packing", "contacts need a pressure"};
constexpr Parameter radius_parameter{"mean_radius", "m", 0, 1e3, true, "mean radius the grading is scaled to"};
constexpr Parameter cloud_parameter{
    "cloud_void_ratio", "1", 1, 1e3, false, "void ratio of the initial cloud", "grains placed at random jam below it"};
constexpr Parameter aspect_parameter{"aspect", "1", 0.1, 10, false, "height of the cell over its width"};
constexpr Parameter dimension_parameter{"dimension", "1", 2, 3, false, "2: disks, whose stress scales with E r"};
constexpr Parameter coarsest_parameter{"coarsest", "m", 0, 1e3, true, "coarser grains of the grading are left out"};
constexpr Parameter density_parameter{
    "density", "kg/m3", 0, 1e12, true, "density of the grains, scaling included [2650e3, or a packing file's own]"};
constexpr Parameter rate_parameter{
    "max_rate", "1/s", 0, 1e3, true, "largest strain rate of compression [1, or suited to the grain size]"};
constexpr Parameter tolerance_parameter{"tolerance", "1", 0, 1, true, "unbalanced force of an equilibrium"};

struct PackGenerate {
  std::filesystem::path output, material, import;
  std::string grading = "toyoura", cell;
  std::int64_t grains = 1000, dimension = 3;
  std::optional<double> void_ratio, coarsest, mean_radius, max_rate, density;
  double pressure = 1e3, cloud_void_ratio = 2.5, aspect = 2, tolerance = 1e-3, interval = 300;
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
    table.option(coarsest, coarsest_parameter);
    table.option(mean_radius, radius_parameter);
    table.option(aspect, aspect_parameter);
    table.option(cloud_void_ratio, cloud_parameter);
    table.option(material, "material", "FILE", "TOML with [contact], [grains]; default: the thesis's, scaled");
    table.option(density, density_parameter);
    table.option(max_rate, rate_parameter);
    table.option(tolerance, tolerance_parameter);
    table.option(import, "import", "FILE",
                 "start from a packing file, or from text: x y z r (disks x y r) or named columns");
    table.option(cell, "cell", "LX,LY,LZ", "periodic cell of a text without a ##PERIODIC:: line, m; of disks LX,LY");
    table.flag(as_is, "as-is", "write the imported packing as it is, but many loose grains in spatial order");
    table.output(output, "packing to write");
    table.refuse(
        {"void-ratio", "pressure", "max-rate", "tolerance", "checkpoint-every"}, [this] { return as_is; },
        "beside --as-is");
    table.refuse(
        {"dimension"}, [this] { return dimension == 3 && std::ranges::count(cell, ',') == 1; },
        "beside a --cell of disks");
    table.resume(interval);
    table.seed();
    table.keys("a material file of pack-generate", &packing::Contacts::keys);
    table.threads();
  }

  void validate() const {
    if (as_is && import.empty()) throw UsageError("--as-is needs --import FILE");
    if (!cell.empty() && import.empty()) throw UsageError("--cell needs --import FILE");
    if (!cell.empty() && is_ours()) throw UsageError("--cell: " + import.string() + " has a cell of its own");
    if (!cell.empty()) io::periodic_cell(cell, "--cell");
    const PackGenerate standard;
    const bool new_cloud = grading != standard.grading || grains != standard.grains || coarsest || mean_radius ||
                           aspect != standard.aspect || cloud_void_ratio != standard.cloud_void_ratio ||
                           (is_ours() && dimension != standard.dimension);
    if (!import.empty() && new_cloud)
      throw UsageError(
          "--grading, --grains, --coarsest, --mean-radius, --aspect, --cloud-void-ratio and, beside a packing file, "
          "--dimension are of a new packing: leave them out with --import");
  }

  void run(const tool::Invocation& invocation) const {
    if (invocation.seed != 0 && !import.empty()) throw UsageError("--seed has no effect with --import: leave it out");
    std::vector<io::Source> sources;
    std::optional<packing::Contacts> given;
    if (!material.empty()) {
      const io::TextFile text = io::read_text(material, "material");
      sources.push_back(text.source);
      given = packing::Contacts(text.text, material.string());
    }
    const bool of_material = given && given->density > 0;
    if (of_material && density && *density != given->density)
      throw UsageError("--density: " + material.string() + " has another grains.density: leave one of the two out");
    const std::optional<double> rho = of_material ? given->density : density;
    std::vector<std::string> notes;
    std::vector<Doubt> about;
    std::optional<packing::Room> room;
    if (import.empty()) room = read_room(sources, notes, about);
    const io::Snapshot state = room ? make_cloud(*room, rho.value_or(packing::default_density), invocation)
                                    : read_import(rho, sources, notes, about);
    const double radius = packing::mean_radius(state);
    packing::Contacts contacts =
        given ? *given : packing::Contacts(packing::default_material(radius), "default material");
    contacts.numerics.threads = invocation.threads;
    contacts.model.geotextiles = packing::resting_geotextiles(packing::geotextiles_of(state));
    const io::History history = io::extend(sources, invocation, as_is && !given ? "" : contacts.resolved);
    const StopSignals signals;
    Progress progress("pack-generate", invocation.quiet);
    for (const std::string& note : notes) progress.note("pack-generate: " + note);
    io::SafeOutput safe(output, history, invocation);
    if (safe.finished(progress)) return;
    if (as_is) {
      const dem::Simulation checked(state, contacts.model, contacts.numerics);  // throws for too large overlaps
      Doubts doubts("pack-generate");
      for (const std::vector<Doubt>& some : {about, packing::doubts_as_is(state, contacts)}) doubts.add_all(some);
      return void(safe.write([&] { io::write_packing(output, state, io::with_doubts(history, doubts)); }));
    }
    packing::Recipe recipe;
    recipe.pressure = pressure, recipe.void_ratio = void_ratio, recipe.tolerances.unbalanced_force = tolerance;
    recipe.max_rate = max_rate.value_or(given ? 1 : packing::default_rate(radius));
    recipe.damping = contacts.numerics.damping, recipe.room = room;
    const ProgressReport report = [&](double f, const std::string& detail) { progress.update(f, detail); };
    packing::Result result =
        packing::compact(state, contacts.model, contacts.numerics, recipe, report, {safe.part(), interval, &signals});
    for (Doubt& doubt : packing::doubts_about(result.state, contacts, room, tolerance)) about.push_back(doubt);
    Doubts("pack-generate").add_all(about);
    Doubts doubts;
    if (result.unheld) doubts.add({"void_ratio", *result.unheld});  // the error below says it
    doubts.add_all(about);
    const io::History with = io::with_doubts(history, doubts);
    result.cost.output += safe.write([&] { io::write_packing(output, result.state, with); });
    if (output != "-") progress.note("pack-generate: " + result.cost.line());
    if (result.unheld) throw TargetNotReached(*result.unheld);
  }

  // Returns the grading, and the cell that its grains will fill.
  packing::Room read_room(std::vector<io::Source>& sources, std::vector<std::string>& notes,
                          std::vector<Doubt>& about) const {
    packing::Grading curve = packing::Grading::toyoura();
    if (grading != "toyoura") {
      const io::TextFile table = io::read_text(grading, "grading");
      sources.push_back(table.source);
      curve = packing::Grading::from_tsv(table.text, grading);
      const std::optional<Doubt> finest = packing::finest_doubt(curve);
      for (const std::optional<Doubt>& doubt : {finest, packing::size_doubt(curve)})
        if (doubt) about.push_back(*doubt);
      for (const std::string& note : curve.notes(!finest)) notes.push_back(grading + ": " + note);
    }
    if (auto doubt = coarsest ? packing::coarsest_doubt(curve, *coarsest) : std::nullopt) about.push_back(*doubt);
    if (coarsest) curve = curve.up_to(*coarsest);
    return {curve, static_cast<int>(dimension), {1, dimension == 2 ? aspect : 1.0, aspect}, cloud_void_ratio};
  }

  // Keeps a given number of grains; raises the default to what a wide grading needs.
  io::Snapshot make_cloud(const packing::Room& room, double rho, const tool::Invocation& invocation) const {
    const auto names_grains = [](const std::string& word) { return word.starts_with("--grains"); };
    auto n = static_cast<std::size_t>(grains);
    if (std::none_of(invocation.arguments.begin(), invocation.arguments.end(), names_grains))
      n = packing::enough_grains(room, void_ratio, n);
    return packing::new_cloud(room, n, {grading == "toyoura", mean_radius}, void_ratio, rho, invocation.seed);
  }

  bool is_ours() const { return packing::is_packing_file(import); }

  io::Snapshot read_import(const std::optional<double>& rho, std::vector<io::Source>& sources,
                           std::vector<std::string>& notes, std::vector<Doubt>& about) const {
    io::SpheresOptions options;
    if (!cell.empty()) options.cell = io::periodic_cell(cell, "--cell");
    if (dimension == 2 || (options.cell && !options.cell->periodic[2])) options.dimension = 2;
    packing::Imported read = packing::import_packing(import, rho, options);
    if (!as_is) packing::demand_no_geotextile(read.state, import);
    if (auto doubt = packing::length_doubt(read.state)) about.push_back(*doubt);
    sources.push_back(std::move(read.source));
    notes = std::move(read.notes);
    return std::move(read.state);
  }
};

}  // namespace

int main(int argc, char** argv) { return tool::start<PackGenerate>(argc, argv); }
