// History of contacts that only one law keeps: in files, in records, and in their checks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "files/files.h"
#include "files/finite_part.h"
#include "support/states.h"

namespace soilweave::io {
namespace {

// Returns a state whose contacts keep a number and a vector of their law.
Snapshot with_own() {
  Snapshot state = test::example_state(5);
  ContactsRecord& c = state.contacts;
  c.own = {{"own_overlap", "m", "largest overlap so far", 1, {}}, {"own_walk", "m", "slip so far", 3, {}}};
  for (std::size_t k = 0; k < c.size(); ++k) {
    const auto x = static_cast<double>(k);
    c.own[0].values.push_back(x), c.own[1].values.insert(c.own[1].values.end(), {x, 2 * x, -x});
  }
  return state;
}

TEST(OwnHistory, ComesBackFromAFile) {
  const test::Folder folder;
  const Snapshot state = with_own();
  ASSERT_GT(state.contacts.size(), 0u);
  write_packing(folder / "file.h5", state, {});
  const std::vector<OwnHistory> own = read_state(folder / "file.h5").state.contacts.own;
  ASSERT_EQ(own.size(), 2u);
  for (std::size_t f = 0; f < 2; ++f) {
    const OwnHistory& wanted = state.contacts.own[f];
    EXPECT_EQ(own[f].name, wanted.name);
    EXPECT_EQ(own[f].unit, wanted.unit);
    EXPECT_EQ(own[f].long_name, wanted.long_name);
    EXPECT_EQ(own[f].width, wanted.width);
    EXPECT_EQ(own[f].values, wanted.values);
  }
}

TEST(OwnHistory, StaysWithItsContact) {
  const ContactsRecord from = with_own().contacts;
  ContactsRecord to;
  to.append(from, from.size() - 1);
  const auto last = static_cast<double>(from.size() - 1);
  EXPECT_EQ(to.own[0].values, std::vector<double>{last});
  EXPECT_EQ(to.own[1].values, (std::vector<double>{last, 2 * last, -last}));
  to.append_own(from, from.size() - 1, -1);
  EXPECT_EQ(to.own[0].values.back(), last) << "a number has no direction";
  EXPECT_EQ(to.own[1].values.back(), last);
}

TEST(OwnHistory, IsCheckedAsAllNumbersAre) {
  Snapshot state = with_own();
  state.contacts.own[1].values.pop_back();
  EXPECT_THROW(check(state, "state"), DataError);
  state = with_own();
  state.contacts.own[0].values[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(check(state, "state"), DataError);
  const std::size_t all = state.contacts.size();
  EXPECT_EQ(finite_part(state).contacts.size(), all - 1);
}

}  // namespace
}  // namespace soilweave::io
