// to-vtk: files of the other tools for ParaView; also a file's history, and packings as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/measure/parts.h"
#include "analysis/measure/stress.h"
#include "core/cli/tool.h"
#include "core/error.h"
#include "core/progress.h"
#include "display/display.h"
#include "display/display_multiscale.h"
#include "display/display_table.h"
#include "display/paraview.h"
#include "files/exchange/spheres_text.h"
#include "files/exchange/state_choice.h"
#include "files/exchange/table_output.h"
#include "files/files.h"
#include "files/provenance.h"
#include "store/bytes.h"

namespace soilweave {
namespace {

constexpr Parameter force_scale_parameter = {
    .name = "force_scale",
    .unit = "m/N",
    .low = 0,
    .sentence = "tube radius of a contact per newton of normal force; by default the greatest is half a grain"};

struct Frame {
  std::string group;
  std::size_t index;
  io::VtkPicture picture;
};

struct ToVtk {
  std::filesystem::path input, output = "-", fields;
  std::string state = "all";
  std::optional<double> force_scale;
  bool unwrapped = false, compress = false, history = false, text = false;

  void options(tool::Table& table) {
    table.about(
        "to-vtk", "write packings, runs and fields as VTK files for ParaView",
        "For each state of a packing or run the grains, contacts, yarns and where they broke, the cell and the rigid "
        "planes as VTK XML files, a .pvd a group with the physical times, and show.py, which shows them in ParaView: "
        "grains, force chains, yarns by tension and, with --fields, the strain of grains on a cut. Contacts through a "
        "periodic face are drawn at both sides. Of a run of fem-dem mesh and geosynthetic. Rows of fields that have a "
        "place become points, yarns lines, volumes also principal axes; others .csv.");
    table.example("to-vtk packing.h5 -o packing-vtk", "then: paraview --script=packing-vtk/show.py");
    table.example("to-vtk run.h5 --fields fields.h5 -o run-vtk",
                  "strains too, after: homogenize run.h5 --grains -o fields.h5");
    table.example("to-vtk --history packing.h5", "the runs and inputs that led to this file");
    table.example("to-vtk --text packing.h5", "x y z r, a grain a line");
    table.input(input, "INPUT", "packing, run, fields or multiscale file");
    table.output_folder(output, "folder for the VTK files; with --history and --text a file");
    table.option(state, "state", "WHICH", "states to write: all, first, last or a number from 0");
    table.option(fields, "fields", "FILE", "fields whose group \"grains\" is joined to the grains by body_id");
    table.option(force_scale, force_scale_parameter);
    table.flag(unwrapped, "unwrapped", "show grains where they have travelled to, not inside the periodic cell");
    table.flag(compress, "compress", "compress the arrays with zlib");
    table.flag(history, "history", "print how the file came to be, and stop");
    table.flag(text, "text", "print a state, the last by default, as text: x y z r, a grain a line, and stop");
    const auto prints = [this] { return text || history; };
    table.refuse({"fields", "force-scale", "unwrapped", "compress"}, prints, "beside --text and --history");
    table.refuse(
        {"state", "text"}, [this] { return history; }, "beside --history");
    table.refuse(
        {"state"}, [this] { return text && state == "all"; }, "as all beside --text, which prints one state");
  }

  void validate() const {
    std::vector<std::string> wrong;
    if (!history && !text && output == "-") wrong.emplace_back("name a folder for the VTK files with -o");
    io::check_states(state, wrong);
    io::demand_none(wrong);
  }

  void run(const tool::Invocation& invocation) const {
    if (history) return io::write_bytes(output, io::describe(io::read_history(input)));
    if (text) return write_text(invocation);
    const std::string kind = input != "-" ? io::read_kind(input) : "";
    if (kind != "fields" && kind != "multiscale") return show_states(invocation);
    if (!fields.empty() || force_scale || unwrapped)
      throw UsageError("--fields, --force-scale and --unwrapped are for packings and runs, not for " + input.string());
    kind == "fields" ? show_fields(invocation) : show_multiscale(invocation);
  }

 private:
  /// Returns the indices of the requested states.
  std::vector<std::size_t> chosen(std::size_t count) const {
    if (count == 0) throw DataError(input.string() + " holds no state to show");
    return io::chosen_states(state, count, input.string());
  }

  /// Writes the spheres of the chosen state, or of the last, as text. Reports the content that the text leaves out.
  void write_text(const tool::Invocation& invocation) const {
    const io::ExportedSpheres spheres = io::export_spheres(last_or_chosen(), input.string());
    Progress progress("to-vtk", invocation.quiet);
    if (!spheres.left_out.empty()) progress.note("to-vtk: the text leaves out " + spheres.left_out);
    io::write_bytes(output, spheres.text);
  }

  io::Snapshot last_or_chosen() const {
    if (state == "all" || state == "last") return io::read_state(input).state;
    io::RunFile file = io::read_states(input);
    return std::move(file.snapshots[chosen(file.snapshots.size()).front()]);
  }

  void show_states(const tool::Invocation& invocation) const {
    const io::RunFile file = io::read_states(input);
    const auto indices = chosen(file.snapshots.size());
    const std::optional<io::Series> table =
        fields.empty() ? std::nullopt : std::optional(io::read_grain_fields(fields));
    std::vector<const io::Snapshot*> shown;
    std::size_t contacts = 0;
    for (const std::size_t index : indices) {
      shown.push_back(&file.snapshots[index]);
      contacts += shown.back()->contacts.size();
    }
    const double scale = force_scale.value_or(io::fitting_force_scale(shown));
    const auto grains_of = [&](const io::Snapshot& snapshot) {
      const auto dyads = contacts > 0 ? analysis::grain_dyads(snapshot) : std::vector<Mat3>();
      io::VtkPicture grains = io::show_grains(snapshot, dyads, unwrapped);
      analysis::mark_parts(snapshot, grains);
      if (table) io::join_grains(grains, snapshot, *table);
      io::add_principal(grains, snapshot.grains.dimension);
      return grains;
    };
    std::vector<double> times;
    for (const io::Snapshot* snapshot : shown) {
      times.push_back(snapshot->time);
      if (table) grains_of(*snapshot);  // a mismatch with the table is told before anything is written
    }
    io::demand_advance("grains", times);
    io::ParaviewFolder folder(output, invocation.force, compress);
    Progress progress("to-vtk", invocation.quiet);
    if (contacts == 0) progress.note(input.string() + " holds no contacts: only grains and cell are written");
    for (std::size_t s = 0; s < shown.size(); ++s) {
      folder.add("grains", indices[s], grains_of(*shown[s]));
      if (contacts > 0) folder.add("contacts", indices[s], io::show_contacts(*shown[s], unwrapped, scale));
      folder.add("cell", indices[s], io::show_cell(*shown[s]));
      if (!shown[s]->planes.point.empty()) folder.add("planes", indices[s], io::show_planes(*shown[s]));
      if (shown[s]->yarns.size() > 0) {
        folder.add("yarns", indices[s], io::show_yarns(*shown[s]));
        folder.add("broken", indices[s], io::show_broken(*shown[s]));
      }
      progress.update(static_cast<double>(s + 1) / static_cast<double>(shown.size()));
    }
    folder.finish();
  }

  void show_multiscale(const tool::Invocation& invocation) const {
    const io::MultiscaleFile file = io::read_multiscale(input);
    const std::vector<io::VtkPicture> mesh = io::show_mesh(file), bars = io::show_bars(file);
    io::ParaviewFolder folder(output, invocation.force, compress);
    for (const std::size_t index : chosen(mesh.size())) {
      folder.add("soil", index, mesh[index]);
      if (index < bars.size()) folder.add("geosynthetic", index, bars[index]);
    }
    folder.add_table("series", io::to_csv(file.series));
    folder.finish();
  }

  void show_fields(const tool::Invocation& invocation) const {
    const io::FieldsFile file = io::read_fields(input);
    std::vector<Frame> frames;
    for (const auto& group : file.groups) {
      if (!io::has_positions(group.table)) continue;
      const auto states = io::states_of(group.table);
      std::vector<double> times;
      for (const std::size_t index : chosen(states.size())) {
        frames.push_back({group.name, index, io::show_rows(group.table, states[index])});
        times.push_back(frames.back().picture.time);
        if (auto axes = io::show_axes(group.table, states[index]))
          frames.push_back({group.name + "_axes", index, std::move(*axes)});
      }
      io::demand_advance(group.name, times);
    }
    if (frames.empty() && state != "all") throw UsageError("--state has no effect without places: leave it out");
    io::ParaviewFolder folder(output, invocation.force, compress);
    for (const Frame& frame : frames) folder.add(frame.group, frame.index, frame.picture);
    for (const auto& group : file.groups)
      if (!io::has_positions(group.table)) folder.add_table(group.name, io::to_csv(group.table));
    folder.finish();
  }
};

}  // namespace
}  // namespace soilweave

int main(int argc, char** argv) { return soilweave::tool::start<soilweave::ToVtk>(argc, argv); }
