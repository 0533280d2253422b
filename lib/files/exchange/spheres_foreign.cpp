// Packings of other programs, and how to convert them to plain columns.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/exchange/spheres_foreign.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "core/text/number_word.h"
#include "files/exchange/table.h"

namespace soilweave::io {
namespace {

/// Returns the first lines of the text.
std::vector<std::string_view> head(std::string_view text, std::size_t most) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < most) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

bool numbers(const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(), [](const std::string& w) { return number_of(w).has_value(); });
}

/// Returns how to give the box of a dump: its lengths, or why it cannot be given.
std::string box_of_dump(std::string_view text) {
  constexpr std::string_view mark = "ITEM: BOX BOUNDS";
  const std::size_t at = text.find(mark);
  if (at == text.npos) return "it has no box";
  const std::vector<std::string_view> lines = head(text.substr(at + mark.size()), 4);
  const std::vector<std::string> kinds = cells(lines[0], ' ');
  if (kinds.size() > 3) return "its box is tilted, which no text of spheres can say: dump it from an upright box";
  std::vector<std::string> lengths;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const std::vector<std::string> ends = cells(lines[k], ' ');
    const auto low = ends.empty() ? std::nullopt : number_of(ends[0]);
    const auto high = ends.size() < 2 ? std::nullopt : number_of(ends[1]);
    if (low && high) lengths.push_back(fmt::format("{}", *high - *low));
  }
  const auto periodic = std::count(kinds.begin(), kinds.end(), "pp");
  const std::string cell = fmt::format("--cell {}", fmt::join(lengths, ","));
  if (lengths.size() != 3) return "its box is not understood";
  if (kinds.empty()) return "if its box is periodic, give it by " + cell;
  if (kinds.size() == 3 && periodic == 0) return "its box is not periodic, so give no --cell";
  if (periodic != 3) return "its box is not periodic along all axes, so a --cell would add boundaries that it has not";
  return "give its box by " + cell;
}

std::string dump(std::string_view text) {
  const std::string_view what = "a dump of LAMMPS or LIGGGHTS";
  constexpr std::string_view mark = "ITEM: ATOMS ";
  const std::size_t at = text.find(mark);
  const std::string_view columns =
      at == text.npos ? "" : text.substr(at + mark.size(), text.find('\n', at) - at - mark.size());
  const std::vector<std::string> names = cells(columns, ' ');
  const auto has = [&](const char* name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  if (!has("x") || !has("y") || !has("z") || !(has("radius") || has("diameter")))
    return fmt::format("{} without columns x y z radius; dump these: dump custom ... id x y z radius", what);
  return fmt::format(
      "{}; take its first step by: awk '/^ITEM:/ {{ on = 0 }} on; /^ITEM: ATOMS/ {{ if (n++) exit; on = 1; print "
      "substr($0, {}) "
      "}}' FILE > NEW; {}",
      what, mark.size() + 1, box_of_dump(text));
}

/// Returns the column names of an extended XYZ file, from Properties=species:S:1:pos:R:3:radius:R:1.
std::string properties(std::string_view comment) {
  constexpr std::string_view mark = "Properties=";
  const std::size_t at = comment.find(mark);
  if (at == comment.npos) return "";
  std::string_view rest = comment.substr(at + mark.size());
  rest = rest.substr(0, rest.find(' '));
  std::vector<std::string> parts, names;
  for (std::size_t from = 0; from <= rest.size();) {
    const std::size_t end = std::min(rest.find(':', from), rest.size());
    parts.emplace_back(rest.substr(from, end - from));
    from = end + 1;
  }
  for (std::size_t k = 0; k + 2 < parts.size(); k += 3) {
    const int n = static_cast<int>(number_of(parts[k + 2]).value_or(0));
    for (int c = 0; c < std::min(n, 9); ++c)
      names.push_back(parts[k] == "pos" && c < 3 ? std::string(1, "xyz"[c])
                      : n == 1                   ? parts[k]
                                                 : fmt::format("{}{}", parts[k], c));
  }
  return fmt::format("{}", fmt::join(names, " "));
}

std::string xyz(const std::vector<std::string_view>& lines, double grains) {
  const std::string names = properties(lines[1]);
  const std::size_t width = cells(lines[2], ' ').size();
  if (names.empty() && width < 5) return "an XYZ file without radii; write x y z r a line";
  return fmt::format("an XYZ file; name the columns of its first step by: (echo '{}'; sed -n '3,{}p' FILE) > NEW{}",
                     names.empty() ? "element x y z r" : names, static_cast<std::int64_t>(grains) + 2,
                     lines[1].find("Lattice=") == lines[1].npos
                         ? ""
                         : "; if its Lattice is upright and periodic, give the three lengths by --cell");
}

std::string mercury(double grains, std::size_t width) {
  const std::string_view names = width == 14 ? "x y z vx vy vz r qx qy qz wx wy wz species" : "x y vx vy r q w species";
  return fmt::format(
      "a .data file of MercuryDPM; name the columns of its first step by: (echo '{}'; sed -n '2,{}p' FILE) > NEW",
      names, static_cast<std::int64_t>(grains) + 1);
}

constexpr std::string_view lammps_data =
    "a data file of LAMMPS; write a dump of it: write_dump all custom FILE id x y z radius";

/// Returns whether one of the first lines counts atoms, as in LAMMPS data files below a first line of any words.
bool counts_atoms(const std::vector<std::string_view>& lines) {
  return std::any_of(lines.begin(), lines.end(), [](std::string_view line) {
    const std::vector<std::string> words = cells(line, ' ');
    return words.size() == 2 && words[1] == "atoms" && numbers({words[0]});
  });
}

struct Mark {
  std::string_view begins, what;
};

constexpr std::array marks{
    Mark{"# vtk DataFile",
         "a VTK file; write it from ParaView as CSV (File > Save Data), with the columns Points and radius"},
    Mark{"<VTKFile",
         "a VTK file; write it from ParaView as CSV (File > Save Data), with the columns Points and radius"},
    Mark{"<?xml",
         "an XML file; of VTK write it from ParaView as CSV (File > Save Data), with the columns Points and radius"},
    Mark{"$MeshFormat", "a Gmsh mesh; write x y z r a line"},
    Mark{"solid ", "an STL surface; write x y z r a line"},
    Mark{"ply\n", "a PLY file; write x y z r a line"},
    Mark{"OFF\n", "an OFF surface; write x y z r a line"},
    Mark{"LSMGeometry",
         "a geometry of ESyS-Particle; take its grains by: (echo 'x y z r id tag'; awk '/^EndParticles/ { exit } on && "
         "NF "
         "== 6; /^BeginParticles/ { on = 1 }' FILE) > NEW"},
    Mark{"MercuryDPM", "a restart file of MercuryDPM; give its .data file"},
    Mark{"restart_version", "a restart file of MercuryDPM; give its .data file"},
    Mark{"Begin ", "a model of Kratos (.mdpa); write x y z r a line"},
    Mark{"LAMMPS", lammps_data},
    Mark{"{", "a JSON or similar file; write x y z r a line"},
    Mark{"[", "a TOML, JSON or similar file; write x y z r a line"}};

}  // namespace

std::string foreign_spheres(std::string_view text) {
  for (const Mark& mark : marks)
    if (text.starts_with(mark.begins)) return std::string(mark.what);
  if (text.starts_with("ITEM: ")) return dump(text);
  if (counts_atoms(head(text, 5))) return std::string(lammps_data);
  const std::vector<std::string_view> lines = head(text, 3);
  if (lines.size() < 2) return "";
  const std::vector<std::string> first = cells(lines[0], ' '), second = cells(lines[1], ' ');
  const double count = first.empty() ? 0 : number_of(first[0]).value_or(0);
  if (!(count >= 1 && count == std::floor(count) && count < 1e15)) return "";
  if (first.size() == 1 && lines.size() > 2 && !(second.size() >= 3 && numbers(second))) return xyz(lines, count);
  if (first.size() == 1 && second.size() >= 3)
    return "a list below the number of its grains; leave the first line out: tail -n +2 FILE > NEW";
  const bool three = first.size() == 8 && second.size() == 14, two = first.size() == 6 && second.size() == 8;
  if ((three || two) && numbers(first) && numbers(second)) return mercury(count, second.size());
  return "";
}

}  // namespace soilweave::io
