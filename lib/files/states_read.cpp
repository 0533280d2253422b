// Reads the states of packings and runs, and checks them as every reader promises.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <type_traits>

#include "files/file_head.h"
#include "files/states_layout.h"

namespace soilweave::io {
namespace {

using namespace layout;

class StatesReader {
 public:
  explicit StatesReader(const Reader& file) : file_(file) {
    const std::string box = grains + "/box", clock = grains + "/position";
    dimension_ = static_cast<int>(file.integer<std::int64_t>(box, "dimension"));
    if (dimension_ != 2 && dimension_ != 3)
      file.fail(box, fmt::format("says the dimension is {}; 2 and 3 are known", dimension_));
    const Shape positions = file.shape(clock + "/value");
    if (positions.size() != 3) file.fail(clock + "/value", "has the shape " + print(positions) + ", not F x N x D");
    extents_ = {{'F', positions[0]}, {'N', positions[1]}, {'D', static_cast<Extent>(dimension_)}};
    const Shape planes = file.has("/planes/point") ? file.shape("/planes/point") : Shape{0, 0, 0};
    if (planes.size() != 3) file.fail("/planes/point", "has the shape " + print(planes) + ", not F x P x 3");
    extents_['P'] = planes[1];
    const Shape yarns = file.has("/yarns/nodes") ? file.shape("/yarns/nodes") : Shape{0, 0, 2};
    if (yarns.size() != 3) file.fail("/yarns/nodes", "has the shape " + print(yarns) + ", not F x Y x 2");
    extents_['Y'] = yarns[1];
  }

  std::vector<Snapshot> read() {
    if (extents_['F'] == 0) file_.fail(grains, "holds no state; make the file again");
    if (extents_['N'] == 0) file_.fail(grains, "holds no grains; make the file again");
    file_.claim(grains, count({extents_['F'], sizeof(Snapshot)}));
    read_clock();
    read_cell();
    moving([&](const std::string& path, auto member) { read_frames(path, path, &Snapshot::grains, member); });
    lasting([&](const std::string& path, auto member) { read_element(path, member); });
    for (std::size_t frame = 0; frame < states_.size(); ++frame) read_contacts(frame);
    if (extents_['P'] > 0)
      of_planes([&](const std::string& path, auto member) { read_frames(path, path, &Snapshot::planes, member); });
    if (extents_['Y'] > 0)
      of_yarns([&](const std::string& path, auto member) { read_frames(path, path, &Snapshot::yarns, member); });
    return std::move(states_);
  }

 private:
  template <class T>
  std::vector<T> get(const std::string& path, const std::string& in_schema, bool frames = true) const {
    std::vector<T> values = file_.read<T>(path, resolve(entry(in_schema).shape, extents_, frames));
    demand_unit(path, entry(in_schema).units);
    if constexpr (std::is_same_v<T, double>)
      for (std::size_t k = 0; k < values.size(); ++k)
        if (!std::isfinite(values[k]))
          file_.fail(path, fmt::format("holds {} as value {} of {}; the run that made it went wrong", values[k], k,
                                       values.size()));
    return values;
  }

  /// Throws DataError if another program has written another unit than expected. H5MD calls it unit, Soilweave units.
  void demand_unit(const std::string& path, std::string_view wanted) const {
    for (const char* name : {"unit", "units"}) {
      if (!file_.has_attribute(path, name)) continue;
      if (const std::string unit = file_.text_attribute(path, name); unit != wanted)
        file_.fail(path, fmt::format("is in the unit \"{}\"; {} is read here", unit, wanted));
    }
  }

  template <class Record, class Items>
  void read_frames(const std::string& path, const std::string& in_schema, Record Snapshot::*record,
                   Items Record::*member) {
    using T = typename NumberOf<Items>::type;
    if (path == "/planes/partners" && !file_.has(path)) return;
    const std::vector<T> values = get<T>(path, in_schema);
    const Shape shape = resolve(entry(in_schema).shape, extents_);
    const Extent width = shape.size() > 2 ? shape[2] : 1;
    for (std::size_t f = 0; f < states_.size(); ++f)
      assign(states_[f].*record.*member, values.data() + f * shape[1] * width, shape[1], width);
  }

  template <class T>
  void read_element(const std::string& path, std::vector<T> GrainsRecord::*member) {
    if (file_.is_group(path)) return read_frames(path + "/value", path, &Snapshot::grains, member);
    const std::vector<T> values = get<T>(path, path, false);
    file_.claim(path, count({extents_['F'], extents_['N'], sizeof(T)}));
    for (Snapshot& state : states_) state.grains.*member = values;
  }

  void read_clock() {
    const std::string clock = grains + "/position";
    const auto steps = get<std::int64_t>(clock + "/step", clock + "/step");
    const auto times = get<double>(clock + "/time", clock + "/time");
    states_.resize(steps.size());
    for (std::size_t f = 0; f < steps.size(); ++f) {
      states_[f].step = steps[f];
      states_[f].time = times[f];
      states_[f].grains.dimension = dimension_;
    }
  }

  void read_cell() {
    const std::string box = grains + "/box";
    const auto edges = get<double>(box + "/edges/value", box + "/edges/value");
    const auto velocity = get<double>("/cell/velocity_gradient", "/cell/velocity_gradient");
    const auto deformation = get<double>("/cell/deformation_gradient", "/cell/deformation_gradient");
    std::vector<double> thickness;
    if (dimension_ == 2) thickness = get<double>("/cell/thickness", "/cell/thickness");
    const std::vector<std::string> boundary = file_.text_attributes(box, "boundary");
    const auto axes = static_cast<std::size_t>(dimension_);
    if (boundary.size() != axes) file_.fail(box, "has an attribute boundary of another length than its dimension");
    for (const std::string& word : boundary)
      if (word != "periodic" && word != "none")
        file_.fail(box, "has an attribute boundary of \"" + word + "\"; \"periodic\" and \"none\" are known");
    for (std::size_t f = 0; f < states_.size(); ++f) {
      CellRecord& cell = states_[f].cell;
      cell.matrix = matrix_of_rows(edges.data() + f * axes * axes, dimension_).transpose();
      if (dimension_ == 2) cell.matrix(2, 2) = thickness[f];
      cell.velocity_gradient = matrix_of_rows(velocity.data() + f * 9, 3);
      cell.deformation_gradient = matrix_of_rows(deformation.data() + f * 9, 3);
      cell.periodic = {false, false, false};
      for (std::size_t a = 0; a < axes; ++a) cell.periodic[a] = boundary[a] == "periodic";
    }
  }

  void read_contacts(std::size_t frame) {
    const std::string path = contacts_of(frame);
    const Shape bodies = file_.shape(path + "/bodies");
    if (bodies.size() != 2) file_.fail(path + "/bodies", "has the shape " + print(bodies) + ", not M x 2");
    extents_['M'] = bodies[0];
    ContactsRecord& contacts = states_[frame].contacts;
    of_contacts([&](const std::string& name, auto member) {
      using T = typename NumberOf<std::remove_cvref_t<decltype(contacts.*member)>>::type;
      const std::string in_schema = "/contacts/<frame>/" + name;
      const Shape shape = resolve(entry(in_schema).shape, extents_);
      const std::vector<T> values = get<T>(path + "/" + name, in_schema);
      assign(contacts.*member, values.data(), shape[0], shape.size() > 1 ? shape[1] : 1);
    });
    read_own(path, contacts);
  }

  // Reads the fields of the law that made the contacts: all datasets that not every law has.
  void read_own(const std::string& path, ContactsRecord& contacts) {
    for (const std::string& name : file_.children(path)) {
      bool of_every_law = false;
      of_contacts([&](const std::string& known, auto) { of_every_law = of_every_law || known == name; });
      if (of_every_law) continue;
      const std::string place = path + "/" + name;
      const Shape shape = file_.shape(place);
      if (shape.size() > 2 || (shape.size() == 2 && shape[1] != 3))
        file_.fail(place, "has the shape " + print(shape) + "; a field of a contact law is M or M x 3");
      OwnHistory field{name,
                       file_.text_attribute(place, "units"),
                       file_.text_attribute(place, "long_name"),
                       shape.size() == 2 ? std::size_t{3} : std::size_t{1},
                       {}};
      field.values = file_.read<double>(place, field.width == 3 ? Shape{extents_['M'], 3} : Shape{extents_['M']});
      contacts.own.push_back(std::move(field));
    }
  }

  const Reader& file_;
  int dimension_ = 3;
  Extents extents_;
  std::vector<Snapshot> states_;
};

}  // namespace

std::vector<Snapshot> read_frames(const Reader& file) { return StatesReader(file).read(); }

}  // namespace soilweave::io
