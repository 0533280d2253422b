// Several mistakes in one text, a line each.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/error.h"

namespace soilweave {

/// DataError with a line for each mistake. The lines of any other DataError are one: a line's end in it is a file's.
struct Mistakes : DataError {
  explicit Mistakes(const std::string& lines) : DataError(lines) {}
};

}  // namespace soilweave
