// Writes the states of packings and runs: an H5MD trajectory, with contacts, cell and planes beside it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "core/error.h"
#include "files/file_head.h"
#include "files/states_layout.h"

namespace soilweave::io {
namespace {

using namespace layout;
using States = std::vector<const Snapshot*>;

class StatesWriter {
 public:
  StatesWriter(Writer& file, const States& states) : file_(file), states_(states) {
    const Snapshot& first = *states.front();
    extents_ = {{'F', states.size()},
                {'N', first.grains.size()},
                {'D', static_cast<Extent>(first.grains.dimension)},
                {'P', first.planes.point.size()},
                {'Y', first.yarns.size()}};
  }

  void write(const History& history) {
    write_h5md(history);
    write_box();
    moving([&](const std::string& path, auto member) { write_frames(path, path, &Snapshot::grains, member); });
    lasting([&](const std::string& path, auto member) { write_element(path, member); });
    for (const char* name : {"/orientation", "/velocity", "/angular_velocity"}) share_clock(grains + name);
    file_.variable_text(grains + "/orientation", "order", "wxyz");
    for (const char* name : {"/velocity", "/angular_velocity"}) file_.attribute(grains + name, "time_offset", -0.5);
    write_cell();
    for (std::size_t frame = 0; frame < states_.size(); ++frame) write_contacts(frame);
    if (extents_['P'] > 0)
      of_planes([&](const std::string& path, auto member) { write_frames(path, path, &Snapshot::planes, member); });
    if (extents_['Y'] > 0)
      of_yarns([&](const std::string& path, auto member) { write_frames(path, path, &Snapshot::yarns, member); });
  }

 private:
  template <class T>
  void put(const std::string& path, const std::string& in_schema, const std::vector<T>& values, bool frames = true) {
    const Entry& e = entry(in_schema);
    file_.write<T>(path, values, resolve(e.shape, extents_, frames), {std::string(e.units), std::string(e.long_name)});
    put_unit(path, std::string(e.units));
  }

  /// Writes a unit under H5MD's name, as its module `units` demands; pure numbers get none. Positions get none either:
  /// MDAnalysis knows no unit of length above the nanometre, and refuses files with positions in m.
  void put_unit(const std::string& path, const std::string& unit) {
    if (unit == "1" || path == grains + "/position/value") return;
    if (path.starts_with("/particles"))
      file_.variable_text(path, "unit", unit);
    else
      file_.attribute(path, "unit", unit);
  }

  template <class Record, class Items>
  void write_frames(const std::string& path, const std::string& in_schema, Record Snapshot::*record,
                    Items Record::*member) {
    const Shape shape = resolve(entry(in_schema).shape, extents_);
    std::vector<typename NumberOf<Items>::type> values;
    for (const Snapshot* state : states_) append(values, state->*record.*member, shape.back());
    if (path == "/planes/partners" && values.empty()) return;
    put(path, in_schema, values);
  }

  template <class T>
  void write_element(const std::string& path, std::vector<T> GrainsRecord::*member) {
    const std::vector<T>& first = states_.front()->grains.*member;
    const bool constant = std::all_of(states_.begin(), states_.end(), [&](const Snapshot* state) {
      return std::memcmp((state->grains.*member).data(), first.data(), first.size() * sizeof(T)) == 0;
    });
    if (constant) return put(path, path, first, false);
    write_frames(path + "/value", path, &Snapshot::grains, member);
    share_clock(path);
  }

  void write_h5md(const History& history) {
    const std::string creator = history.empty() ? "soilweave" : history.back().tool;
    for (const char* path : {"/h5md/author", "/h5md/creator", "/h5md/modules/units"}) file_.group(path);
    file_.attribute("/h5md", "version", std::vector<std::int64_t>{1, 1});
    file_.variable_text("/h5md/author", "name", "not recorded");
    file_.variable_text("/h5md/creator", "name", creator);
    file_.variable_text("/h5md/creator", "version", history.empty() ? std::string("unknown") : history.back().version);
    file_.attribute("/h5md/modules/units", "version", std::vector<std::int64_t>{1, 0});
    file_.variable_text("/h5md/modules/units", "system", "SI");
    std::vector<std::int64_t> steps;
    std::vector<double> times;
    for (const Snapshot* state : states_) {
      steps.push_back(state->step);
      times.push_back(state->time);
    }
    const std::string clock = grains + "/position";
    put(clock + "/step", clock + "/step", steps);
    put(clock + "/time", clock + "/time", times);
  }

  void share_clock(const std::string& element) {
    for (const char* name : {"/step", "/time"}) file_.link(grains + "/position" + name, element + name);
  }

  void write_box() {
    const std::string box = grains + "/box";
    const int dimension = states_.front()->grains.dimension;
    std::vector<double> edges;
    for (const Snapshot* state : states_) append_rows(edges, state->cell.matrix.transpose(), dimension);
    put(box + "/edges/value", box + "/edges/value", edges);
    share_clock(box + "/edges");
    std::vector<std::string> boundary;
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
      boundary.push_back(states_.front()->cell.periodic[a] ? "periodic" : "none");
    file_.attribute(box, "dimension", std::int64_t{dimension});
    file_.variable_texts(box, "boundary", boundary);
  }

  void write_cell() {
    std::vector<double> velocity_gradients, deformation_gradients, thicknesses;
    for (const Snapshot* state : states_) {
      append_rows(velocity_gradients, state->cell.velocity_gradient, 3);
      append_rows(deformation_gradients, state->cell.deformation_gradient, 3);
      thicknesses.push_back(state->cell.matrix(2, 2));
    }
    put("/cell/velocity_gradient", "/cell/velocity_gradient", velocity_gradients);
    put("/cell/deformation_gradient", "/cell/deformation_gradient", deformation_gradients);
    if (extents_['D'] == 2) put("/cell/thickness", "/cell/thickness", thicknesses);
  }

  void write_contacts(std::size_t frame) {
    const ContactsRecord& contacts = states_[frame]->contacts;
    extents_['M'] = contacts.size();
    of_contacts([&](const std::string& name, auto member) {
      const std::string in_schema = "/contacts/<frame>/" + name;
      std::vector<typename NumberOf<std::remove_cvref_t<decltype(contacts.*member)>>::type> values;
      append(values, contacts.*member, resolve(entry(in_schema).shape, extents_).back());
      put(contacts_of(frame) + "/" + name, in_schema, values);
    });
    for (const OwnHistory& field : contacts.own) {
      const std::string path = contacts_of(frame) + "/" + field.name;
      const Shape shape = field.width == 1 ? Shape{contacts.size()} : Shape{contacts.size(), field.width};
      file_.write<double>(path, field.values, shape, {field.unit, field.long_name});
      put_unit(path, field.unit);
    }
  }

  Writer& file_;
  const States& states_;
  Extents extents_;
};

/// Checks that all frames share number and kind of grains, planes and periodic axes.
void check_alike(const States& states) {
  const Snapshot& first = *states.front();
  for (std::size_t f = 1; f < states.size(); ++f) {
    const Snapshot& state = *states[f];
    const auto differ = [&](const char* what) {
      throw DataError(
          fmt::format("state {} differs from state 0 in its {}; write them to files of their own", f, what));
    };
    if (state.grains.size() != first.grains.size()) differ("number of grains");
    if (state.grains.dimension != first.grains.dimension) differ("dimension");
    if (state.planes.point.size() != first.planes.point.size()) differ("number of planes");
    if (state.yarns.size() != first.yarns.size()) differ("number of yarns");
    if (state.cell.periodic != first.cell.periodic) differ("periodic axes");
    if (state.step < states[f - 1]->step)
      throw DataError(fmt::format("state {} is of an earlier step than {}", f, f - 1));
  }
}

}  // namespace

void write_states(Writer& file, const std::vector<const Snapshot*>& states, const History& history) {
  if (states.empty()) throw DataError("no state to write");
  check_alike(states);
  StatesWriter(file, states).write(history);
}

}  // namespace soilweave::io
