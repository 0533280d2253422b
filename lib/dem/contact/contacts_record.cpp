// Converts contacts to and from records.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contact/contacts_record.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace soilweave::dem {
namespace {

// Returns the touching pairs of a chunk, sorted by grains.
std::vector<std::pair<Pair, PairHistory>> in_order_of_grains(std::size_t chunk, const Contacts& contacts) {
  std::vector<std::pair<Pair, PairHistory>> found;
  for (std::size_t b = 0; b < contacts.chunks[chunk].size(); ++b) {
    const ContactBlock& block = contacts.chunks[chunk][b];
    for (int k = 0; k < block.count; ++k)
      if ((block.touching >> k) & 1)
        found.emplace_back(contacts.pair(block, k),
                           history_of(block, k, contacts.own_of(chunk, b), contacts.own_numbers()));
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return before(a.first, b.first); });
  return found;
}

// Calls use(number) for the place of each vector among the law's own numbers.
template <class Use>
void own_vectors(std::span<const HistoryField> fields, const Use& use) {
  std::size_t at = 0;
  for (const HistoryField& field : fields) {
    if (field.kind == HistoryField::Kind::along) use(at);
    at += field.numbers();
  }
}

// Returns the history of disks with full vectors, of which a contact keeps one number each (space.h).
PairHistory in_space(PairHistory h, const Vec3& normal, std::span<const HistoryField> fields) {
  own_vectors(fields, [&](std::size_t at) {
    const V2<double> v = joined(0.0, V2<double>{normal[0], normal[1]}, h.own[at + 2]);
    h.own[at] = v.x, h.own[at + 1] = v.y, h.own[at + 2] = 0;
  });
  const V2<double> force = joined(0.0, V2<double>{normal[0], normal[1]}, h.history.shear.z);
  h.history.shear = {force.x, force.y, 0};
  return h;
}
PairHistory in_plane(PairHistory h, const Vec3& normal, std::span<const HistoryField> fields) {
  own_vectors(fields, [&](std::size_t at) {
    h.own[at + 2] = along(V2<double>{normal[0], normal[1]}, V2<double>{h.own[at], h.own[at + 1]});
    h.own[at] = h.own[at + 1] = 0;
  });
  const V3<double>& force = h.history.shear;
  h.history.shear = {0, 0, along(V2<double>{normal[0], normal[1]}, V2<double>{force.x, force.y})};
  return h;
}

// Sorts by grain, then from the last plane to the first, because in files plane p is body -1 - p.
std::vector<PlanePair> in_order_of_grains(const PlaneContacts& planes) {
  std::vector<PlanePair> found = planes.pairs();
  std::erase_if(found, [](const PlanePair& p) { return !p.history.touching; });
  std::sort(found.begin(), found.end(), [](const PlanePair& a, const PlanePair& b) {
    return std::pair(a.grain, -a.plane) < std::pair(b.grain, -b.plane);
  });
  return found;
}

// Returns the law's own numbers of contact c, zeros for a field that the record lacks.
std::vector<double> own_numbers(const io::ContactsRecord& r, std::size_t c, std::span<const HistoryField> fields) {
  std::vector<double> numbers;
  for (const HistoryField& field : fields) {
    const auto same = [&](const io::OwnHistory& f) { return f.name == field.name && f.width == field.numbers(); };
    const auto found = std::find_if(r.own.begin(), r.own.end(), same);
    for (std::size_t k = 0; k < field.numbers(); ++k)
      numbers.push_back(found == r.own.end() ? 0 : found->values[field.numbers() * c + k]);
  }
  return numbers;
}

std::size_t touching_pairs(const Contacts& contacts) {
  std::size_t count = 0;
  for (const std::vector<ContactBlock>& chunk : contacts.chunks)
    for (const ContactBlock& block : chunk) count += static_cast<std::size_t>(std::popcount(block.touching));
  return count;
}

// Makes room for contacts, so that large columns are not copied while they grow.
void reserve(std::size_t contacts, io::ContactsRecord& r) {
  const auto room = [contacts](auto&... columns) { (columns.reserve(contacts), ...); };
  room(r.bodies, r.image, r.normal, r.branch_vector, r.overlap, r.normal_force, r.shear_force, r.rolling_moment,
       r.twisting_moment, r.sliding);
  for (io::OwnHistory& field : r.own) field.values.reserve(contacts * field.width);
}

// Appends the law's own numbers of a contact to the fields of a record.
void put_own(const std::vector<double>& numbers, io::ContactsRecord& r) {
  auto next = numbers.begin();
  for (io::OwnHistory& field : r.own)
    for (std::size_t k = 0; k < field.width; ++k) field.values.push_back(*next++);
}

}  // namespace

io::ContactsRecord contacts_record(const Contacts& contacts, const Bodies& bodies, const Cell& cell,
                                   const Planes& planes) {
  io::ContactsRecord r;
  for (const HistoryField& f : contacts.own_fields)
    r.own.push_back({std::string(f.name), std::string(f.unit), std::string(f.sentence), f.numbers(), {}});
  const auto add = [&r](const PairHistory& h, std::int32_t first, std::int32_t second, const Vec3i& image,
                        const Vec3& normal, const Vec3& branch, double overlap) {
    r.bodies.push_back({first, second});
    r.image.push_back(image);
    r.normal.push_back(normal);
    r.branch_vector.push_back(branch);
    r.overlap.push_back(overlap);
    r.normal_force.push_back(h.normal_force);
    r.shear_force.push_back(to_eigen(h.history.shear));
    r.rolling_moment.push_back(to_eigen(h.history.rolling));
    r.twisting_moment.push_back(h.history.twisting);
    r.sliding.push_back(h.sliding);
    put_own(h.own, r);
  };
  const auto add_plane = [&](const PlanePair& pair) {
    const Plane& plane = planes.all[static_cast<std::size_t>(pair.plane)];
    const auto i = static_cast<std::size_t>(pair.grain);
    const double height = (vector_of(bodies.grains[i].position) - plane.point).dot(plane.normal);
    add(pair.history, pair.grain, -1 - pair.plane, Vec3i::Zero(), -plane.normal, -height * plane.normal,
        bodies.radius(i) - height);
  };
  const std::vector<PlanePair> with_planes = in_order_of_grains(contacts.planes);
  reserve(touching_pairs(contacts) + with_planes.size(), r);
  auto with_plane = with_planes.begin();
  const auto add_planes_up_to = [&](std::int32_t grain) {
    for (; with_plane != with_planes.end() && with_plane->grain <= grain; ++with_plane) add_plane(*with_plane);
  };
  for (std::size_t chunk = 0; chunk < contacts.chunks.size(); ++chunk)
    for (const auto& [pair, history] : in_order_of_grains(chunk, contacts)) {
      const auto [first, second, image] = pair;
      add_planes_up_to(first);
      const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
      const Vec3 branch =
          vector_of(bodies.grains[j].position) - vector_of(bodies.grains[i].position) + shift_of(image, cell.matrix());
      const double distance = branch.norm();
      const Vec3 normal = branch / distance;
      add(bodies.dimension == 2 ? in_space(history, normal, contacts.own_fields) : history, first, second,
          cells_of(image), normal, branch, bodies.radius(i) + bodies.radius(j) - distance);
    }
  add_planes_up_to(static_cast<std::int32_t>(bodies.size()));
  return r;
}

void list_recorded(const io::ContactsRecord& r, Bodies& bodies, Contacts& contacts) {
  std::vector<std::pair<Pair, PairHistory>> known;
  std::vector<PlanePair> with_planes;
  for (std::size_t k = 0; k < r.size(); ++k) {
    const PairHistory history{{from_eigen(r.shear_force[k]), from_eigen(r.rolling_moment[k]), r.twisting_moment[k]},
                              r.normal_force[k],
                              true,
                              r.sliding[k] != 0,
                              own_numbers(r, k, contacts.own_fields)};
    const auto [first, second] = std::pair(r.bodies[k][0], r.bodies[k][1]);
    if (second < 0)
      with_planes.push_back({first, -1 - second, history});
    else
      known.push_back({{first, second, cell_offset(r.image[k])},
                       bodies.dimension == 2 ? in_plane(history, r.normal[k], contacts.own_fields) : history});
  }
  std::sort(known.begin(), known.end(),
            [in_order = PairOrder(bodies)](const auto& a, const auto& b) { return in_order(a.first, b.first); });
  std::vector<Pair> pairs;
  for (const auto& [pair, history] : known) pairs.push_back(pair);
  contacts.list(pairs, std::move(with_planes), bodies);
  auto next = known.begin();
  for (std::size_t chunk = 0; chunk < contacts.chunks.size(); ++chunk)
    for (std::size_t b = 0; b < contacts.chunks[chunk].size(); ++b)
      for (int lane = 0; lane < contacts.chunks[chunk][b].count; ++lane)
        set_history(contacts.chunks[chunk][b], lane, next++->second, contacts.own_of(chunk, b));
}

}  // namespace soilweave::dem
