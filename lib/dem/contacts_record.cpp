// Contacts as files hold them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contacts_record.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace soilweave::dem {

io::ContactsRecord contacts_record(const Contacts& contacts, const Bodies& bodies, const Cell& cell,
                                   const Planes& planes) {
  io::ContactsRecord r;
  const auto add = [&r](const History& h, std::int32_t first, std::int32_t second, const Vec3i& image,
                        const Vec3& normal, const Vec3& branch, double overlap) {
    r.bodies.push_back({first, second});
    r.image.push_back(image);
    r.normal.push_back(normal);
    r.branch_vector.push_back(branch);
    r.overlap.push_back(overlap);
    r.normal_force.push_back(h.normal_force);
    r.shear_force.push_back(to_eigen(h.memory.shear));
    r.rolling_moment.push_back(to_eigen(h.memory.rolling));
    r.twisting_moment.push_back(h.memory.twisting);
    r.sliding.push_back(h.sliding);
  };
  const auto add_plane = [&](const PlanePair& pair) {
    if (!pair.history.touching) return;
    const Plane& plane = planes.all[static_cast<std::size_t>(pair.plane)];
    const auto i = static_cast<std::size_t>(pair.grain);
    const double height = (vector_of(bodies.grains[i].position) - plane.point).dot(plane.normal);
    add(pair.history, pair.grain, -1 - pair.plane, Vec3i::Zero(), to_eigen(pair.normal), -height * plane.normal,
        bodies.radius(i) - height);
  };
  auto with_plane = contacts.planes.begin();
  // Of one grain the planes come last to first: in files, plane p is body -1 - p.
  const auto add_planes_up_to = [&](std::int32_t grain) {
    while (with_plane != contacts.planes.end() && with_plane->grain <= grain) {
      const auto first = with_plane;
      while (with_plane != contacts.planes.end() && with_plane->grain == first->grain) ++with_plane;
      std::for_each(std::make_reverse_iterator(with_plane), std::make_reverse_iterator(first), add_plane);
    }
  };
  for (const auto& chunk : contacts.chunks)
    for (const ContactBlock& block : chunk)
      for (int k = 0; k < block.count; ++k) {
        if (!((block.touching >> k) & 1)) continue;
        const auto [first, second, image] = contacts.pair(block, k);
        add_planes_up_to(first);
        const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
        const Vec3 branch = vector_of(bodies.grains[j].position) - vector_of(bodies.grains[i].position) +
                            shift_of(image, cell.matrix());
        const double distance = branch.norm();
        add(Contacts::history(block, k), first, second, cells_of(image), branch / distance, branch,
            bodies.radius(i) + bodies.radius(j) - distance);
      }
  add_planes_up_to(static_cast<std::int32_t>(bodies.size()));
  return r;
}

void list_recorded(const io::ContactsRecord& r, Bodies& bodies, Contacts& contacts) {
  std::vector<std::size_t> order(r.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto pair = [&r](std::size_t k) { return Pair{r.bodies[k][0], r.bodies[k][1], cell_offset(r.image[k])}; };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return before(pair(a), pair(b)); });
  std::vector<Pair> pairs;
  std::vector<PlanePair> with_planes;
  std::vector<History> histories;
  for (const std::size_t k : order) {
    const History history{{from_eigen(r.shear_force[k]), from_eigen(r.rolling_moment[k]), r.twisting_moment[k]},
                          r.normal_force[k],
                          true,
                          r.sliding[k] != 0};
    const Pair p = pair(k);
    if (p.second < 0) {
      with_planes.push_back({p.first, -1 - p.second, 0, from_eigen(r.normal[k]), history});
    } else {
      pairs.push_back(p);
      histories.push_back(history);
    }
  }
  std::sort(with_planes.begin(), with_planes.end(), [](const PlanePair& a, const PlanePair& b) {
    return std::pair(a.grain, a.plane) < std::pair(b.grain, b.plane);
  });
  contacts.list(pairs, std::move(with_planes), bodies);
  std::size_t k = 0;
  for (auto& chunk : contacts.chunks)
    for (ContactBlock& block : chunk)
      for (int lane = 0; lane < block.count; ++lane) Contacts::set_history(block, lane, histories[k++]);
}

}  // namespace soilweave::dem
