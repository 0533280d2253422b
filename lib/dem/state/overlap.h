// The deepest overlap of an assembly.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "dem/state/bodies.h"

namespace soilweave::dem {

/// Contact with the largest relative overlap. All zeros without contacts.
struct DeepestContact {
  /// Bodies as in io::ContactsRecord::bodies.
  std::int32_t first = 0, second = 0;
  /// Overlap, m.
  double overlap = 0;
  /// Overlap over the smaller radius, 1.
  double relative = 0;
};
/// Finds the deepest contact of a state.
DeepestContact deepest_of(const io::ContactsRecord& contacts, const Bodies& bodies);

/// Returns the contact in words, for messages.
std::string description(const DeepestContact& contact);

}  // namespace soilweave::dem
