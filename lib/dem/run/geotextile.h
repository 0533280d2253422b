// Geotextiles of a scenario: the tension-strain curve of their yarns, by name, from a file, or by numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/text/named_file.h"
#include "core/text/settings.h"
#include "dem/contact/wire.h"
#include "files/provenance.h"

namespace soilweave::dem {

/// Reads a [[geotextile]] table. `curve` is a name of data/geotextiles, a multiple such as 3PP, or a TOML file.
/// The lists `yarn_strain` and `yarn_tension` may replace `curve`. `key`: name of this table, such as "geotextile.0".
/// Mistakes are reported to the table. Files that were read are added to `sources`.
WireCurve read_geotextile(Settings& table, const std::string& key, const NamedFiles& files,
                          std::vector<io::Source>& sources);

}  // namespace soilweave::dem
