// Data that come with the tools: geotextiles, soils. They lie in data/ of the source, or share/soilweave if installed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soilweave {

/// Returns the path of data/FOLDER/FILE. Searches $SOILWEAVE_DATA, or else share/soilweave and data beside and above
/// the running program. Throws MissingInput.
std::filesystem::path data_file(const std::string& folder, const std::string& file);

/// Returns the names of the files in data/FOLDER with this ending, without the ending, sorted.
std::vector<std::string> data_names(const std::string& folder, const std::string& ending);

}  // namespace soilweave
