// Several mistakes in one text, a line each.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/error.h"

namespace soilweave {

/// A DataError with one mistake a line. Line feeds in any other DataError belong to a file's name.
struct Mistakes : DataError {
  /// Takes the mistakes, separated by line feeds.
  explicit Mistakes(const std::string& lines) : DataError(lines) {}
};

}  // namespace soilweave
