// The list of all contact laws by their types.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact/laws.h"
#include "lists/laws.h"

namespace soilweave::dem {

/// All laws, listed by the build from the headers in laws/ (Makefile).
using Laws = LawList<SOILWEAVE_LAWS>;

}  // namespace soilweave::dem
