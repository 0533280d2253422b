// How deep grains lie in one another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "dem/bodies.h"

namespace soilweave::dem {

/// The contact of the largest overlap over the smaller radius. Zero without contacts.
struct DeepestContact {
  std::int32_t first = 0, second = 0;  // of io::ContactsRecord::bodies
  double overlap = 0;                  // m
  double relative = 0;                 // over the smaller radius
};
DeepestContact deepest_of(const io::ContactsRecord& contacts, const Bodies& bodies);

/// In words, for messages.
std::string description(const DeepestContact& contact);

}  // namespace soilweave::dem
