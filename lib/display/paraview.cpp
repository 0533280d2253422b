// A folder for ParaView.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "display/paraview.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "display/show_script.h"
#include "files/exchange/table.h"
#include "store/bytes.h"
#include "store/temporary.h"

namespace soilweave::io {
namespace {

namespace fs = std::filesystem;

bool all_of(std::string_view text, bool (*is)(unsigned char)) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is);
}
bool in_word(unsigned char c) { return std::isalnum(c) != 0 || c == '_'; }
bool is_digit(unsigned char c) { return std::isdigit(c) != 0; }

/// Returns whether an earlier call wrote this file: GROUP_NUMBER.vtp or .vtu with six digits, NAME.pvd, NAME.csv or
/// show.py. All others are the user's.
bool ours(const fs::path& file) {
  constexpr std::size_t digits = 6;
  const std::string name = file.filename().string(), stem = file.stem().string(), kind = file.extension().string();
  if (name == "show.py") return true;
  if (kind == ".pvd" || kind == ".csv") return all_of(stem, in_word);
  if (kind != ".vtp" && kind != ".vtu") return false;
  if (stem.size() < digits + 2 || !all_of(stem, in_word)) return false;
  const std::string_view number = std::string_view(stem).substr(stem.size() - digits);
  return all_of(number, is_digit) && stem[stem.size() - digits - 1] == '_';
}

void remove_former(const fs::path& folder) {
  std::vector<fs::path> former;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && ours(entry.path())) former.push_back(entry.path());
  for (const fs::path& file : former) fs::remove(file);
}

std::string pvd_line(double time, const std::string& file) {
  return "    <DataSet timestep=\"" + exact(time) + "\" group=\"\" part=\"0\" file=\"" + file + "\"/>\n";
}

}  // namespace

void demand_advance(const std::string& group, const std::vector<double>& times) {
  for (std::size_t k = 1; k < times.size(); ++k)
    if (!(times[k] > times[k - 1]))
      throw DataError("the states of " + group + " do not advance in time: " + exact(times[k]) + " s after " +
                      exact(times[k - 1]) + " s; choose one with --state");
}

ParaviewFolder::ParaviewFolder(fs::path folder, bool force, bool compress)
    : folder_(std::move(folder)), compress_(compress) {
  try {
    if (fs::exists(folder_) && !fs::is_directory(folder_))
      throw CannotCreate(folder_.string() + " is a file: name a folder for the VTK files");
    fs::create_directories(folder_);
    if (!fs::is_empty(folder_) && !force)
      throw CannotCreate(folder_.string() + " holds files already: name another folder, or replace them with --force");
    remove_former(folder_);
    remove_left_temporaries(folder_, "");
  } catch (const fs::filesystem_error& error) {
    throw CannotCreate("cannot use the folder " + folder_.string() + ": " + error.code().message());
  }
}

void ParaviewFolder::add(const std::string& group, std::size_t index, const VtkPicture& picture) {
  auto& frames = groups_[group];
  if (!frames.empty()) demand_advance(group, {frames.back().time, picture.time});
  const bool grid = picture.grid || picture.shape == VtkShape::hexahedron;
  std::string number = std::to_string(index);
  if (number.size() < 6) number.insert(0, 6 - number.size(), '0');
  const std::string file = group + "_" + number + (grid ? ".vtu" : ".vtp");
  write_own_bytes(folder_ / file, grid ? to_vtu(picture, compress_) : to_vtp(picture, compress_));
  frames.push_back({picture.time, file});
}

void ParaviewFolder::add_table(const std::string& name, const std::string& csv) {
  write_own_bytes(folder_ / (name + ".csv"), csv);
}

void ParaviewFolder::finish() const {
  for (const auto& [group, frames] : groups_) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n  <Collection>\n";
    for (const auto& [time, file] : frames) text += pvd_line(time, file);
    write_own_bytes(folder_ / (group + ".pvd"), text + "  </Collection>\n</VTKFile>\n");
  }
  write_own_bytes(folder_ / "show.py", show_script());
}

}  // namespace soilweave::io
