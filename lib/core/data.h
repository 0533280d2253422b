// Data that come with the tools: geotextiles, soils.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soilweave {

/// Returns the path of data/FOLDER/FILE. Throws MissingInput.
/// Searches $SOILWEAVE_DATA, or else share/soilweave and data beside and above the program.
std::filesystem::path data_file(const std::string& folder, const std::string& file);

/// Returns the sorted names, without `ending`, of the files in data/FOLDER that have it.
std::vector<std::string> data_names(const std::string& folder, const std::string& ending);

}  // namespace soilweave
