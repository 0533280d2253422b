// Converts contacts to and from records.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contact/contacts_record.h"

#include <algorithm>
#include <utility>

namespace soilweave::dem {
namespace {

// Returns the touching pairs of a chunk, sorted by grains.
std::vector<std::pair<Pair, PairHistory>> in_order_of_grains(const LargeVector<ContactBlock>& chunk,
                                                             const Contacts& contacts) {
  std::vector<std::pair<Pair, PairHistory>> found;
  for (const ContactBlock& block : chunk)
    for (int k = 0; k < block.count; ++k)
      if ((block.touching >> k) & 1) found.emplace_back(contacts.pair(block, k), history_of(block, k));
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return before(a.first, b.first); });
  return found;
}

// Returns a history with the shear force as a vector: disks hold a number along the contact (space.h).
PairHistory in_space(PairHistory h, const Vec3& normal) {
  const V2<double> force = joined(0.0, V2<double>{normal[0], normal[1]}, h.history.shear.z);
  h.history.shear = {force.x, force.y, 0};
  return h;
}
PairHistory in_plane(PairHistory h, const Vec3& normal) {
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

}  // namespace

io::ContactsRecord contacts_record(const Contacts& contacts, const Bodies& bodies, const Cell& cell,
                                   const Planes& planes) {
  io::ContactsRecord r;
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
  };
  const auto add_plane = [&](const PlanePair& pair) {
    const Plane& plane = planes.all[static_cast<std::size_t>(pair.plane)];
    const auto i = static_cast<std::size_t>(pair.grain);
    const double height = (vector_of(bodies.grains[i].position) - plane.point).dot(plane.normal);
    add(pair.history, pair.grain, -1 - pair.plane, Vec3i::Zero(), -plane.normal, -height * plane.normal,
        bodies.radius(i) - height);
  };
  const std::vector<PlanePair> with_planes = in_order_of_grains(contacts.planes);
  auto with_plane = with_planes.begin();
  const auto add_planes_up_to = [&](std::int32_t grain) {
    for (; with_plane != with_planes.end() && with_plane->grain <= grain; ++with_plane) add_plane(*with_plane);
  };
  for (const auto& chunk : contacts.chunks)
    for (const auto& [pair, history] : in_order_of_grains(chunk, contacts)) {
      const auto [first, second, image] = pair;
      add_planes_up_to(first);
      const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
      const Vec3 branch =
          vector_of(bodies.grains[j].position) - vector_of(bodies.grains[i].position) + shift_of(image, cell.matrix());
      const double distance = branch.norm();
      const Vec3 normal = branch / distance;
      add(bodies.dimension == 2 ? in_space(history, normal) : history, first, second, cells_of(image), normal, branch,
          bodies.radius(i) + bodies.radius(j) - distance);
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
                              r.sliding[k] != 0};
    const auto [first, second] = std::pair(r.bodies[k][0], r.bodies[k][1]);
    if (second < 0)
      with_planes.push_back({first, -1 - second, history});
    else
      known.push_back(
          {{first, second, cell_offset(r.image[k])}, bodies.dimension == 2 ? in_plane(history, r.normal[k]) : history});
  }
  std::sort(known.begin(), known.end(),
            [in_order = PairOrder(bodies)](const auto& a, const auto& b) { return in_order(a.first, b.first); });
  std::vector<Pair> pairs;
  for (const auto& [pair, history] : known) pairs.push_back(pair);
  contacts.list(pairs, std::move(with_planes), bodies);
  auto next = known.begin();
  for (auto& chunk : contacts.chunks)
    for (ContactBlock& block : chunk)
      for (int lane = 0; lane < block.count; ++lane) set_history(block, lane, next++->second);
}

}  // namespace soilweave::dem
