// The list of all contact laws by their types. The build makes it from the headers in laws/ (Makefile).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact/laws.h"
#include "lists/laws.h"

namespace soilweave::dem {

using Laws = LawList<SOILWEAVE_LAWS>;

}  // namespace soilweave::dem
