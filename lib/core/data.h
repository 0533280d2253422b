// The data that come with the tools (data/ in the source, share/soilweave where installed): geotextiles, soils.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soilweave {

/// The path of data/FOLDER/FILE. Looks in $SOILWEAVE_DATA, else beside and above the program that runs, for
/// share/soilweave and data. Throws MissingInput.
std::filesystem::path data_file(const std::string& folder, const std::string& file);

/// The names of the files of data/FOLDER with this ending, without it, sorted.
std::vector<std::string> data_names(const std::string& folder, const std::string& ending);

}  // namespace soilweave
