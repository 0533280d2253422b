// The table of every file kind.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "store/schema.h"

#include <cctype>
#include <limits>
#include <stdexcept>

namespace soilweave::io {
namespace {

using enum Type;

Section every_file() {
  return {"Every file",
          "packing run fields checkpoint ensemble multiscale",
          {{"/provenance/<n>/scenario", text, "", "1", "scenario as it was resolved, TOML", true}},
          {{"/", "format", "\"soilweave\"", "name of the programs that read the file"},
           {"/", "kind", "\"packing\", \"run\", \"fields\", \"checkpoint\", \"ensemble\" or \"multiscale\"",
            "kind of the file, one of those below"},
           {"/", "format_version", "int64[2]", "major, minor; readers refuse a greater major"},
           {"/", "creator", "text", "tool that wrote the file"},
           {"/", "creator_version", "text", "version of that tool"},
           {"/provenance/<n>", "tool", "text", "tool that ran"},
           {"/provenance/<n>", "version", "text", "version of that tool"},
           {"/provenance/<n>", "command", "text", "options of that tool that can change the result"},
           {"/provenance/<n>", "seed", "uint64", "random seed of that tool"},
           {"/provenance/<n>/inputs/<k>", "role", "text", "role of the input for the tool"},
           {"/provenance/<n>/inputs/<k>", "sha256", "text", "digest of the bytes read"},
           {"/provenance/<n>/inputs/<k>", "origin", "int64", "n of the record that made it; -1: from outside"},
           {"/provenance/<n>/doubts/<k>", "key", "text", "one word that names the doubtful result"},
           {"/provenance/<n>/doubts/<k>", "sentence", "text", "the doubt, its size, and its remedy"}}};
}

Section trajectory() {
  return {"Grains: an H5MD 1.1 trajectory",
          "packing run checkpoint multiscale",
          {{"/particles/grains/position/step", int64, "F", "1", "number of time steps taken"},
           {"/particles/grains/position/time", float64, "F", "s", "time"},
           {"/particles/grains/position/value", float64, "F N D", "m", "centre, not wrapped into the cell"},
           {"/particles/grains/box/edges/value", float64, "F D D", "m", "cell vectors, one a row"},
           {"/particles/grains/orientation/value", float64, "F N 4", "1", "unit quaternion w x y z"},
           {"/particles/grains/velocity/value", float64, "F N D", "m s-1",
            "fluctuation velocity about the affine motion of the cell, half a step behind"},
           {"/particles/grains/angular_velocity/value", float64, "F N 3", "rad s-1",
            "angular velocity, half a step behind"},
           {"/particles/grains/radius", float64, "(F) N", "m", "radius"},
           {"/particles/grains/mass", float64, "(F) N", "kg", "mass in the equations of motion (2D: per metre)"},
           {"/particles/grains/species", int32, "(F) N", "1", "material_id: number of the material in the scenario"},
           {"/particles/grains/id", int64, "(F) N", "1", "body_id: number that stays with the grain"},
           {"/particles/grains/copy_id", int32, "(F) N", "1", "number of the copy of a tiled representative volume"}},
          {{"/h5md", "version", "int64[2]", "1, 1"},
           {"/h5md/author", "name", "text", "\"not recorded\": equal runs by two people give equal files"},
           {"/h5md/creator", "name", "text", "tool that wrote the file"},
           {"/h5md/creator", "version", "text", "version of that tool"},
           {"/h5md/modules/units", "version", "int64[2]", "1, 0"},
           {"/h5md/modules/units", "system", "\"SI\"", "units of the attributes `unit`"},
           {"/particles/grains/box", "dimension", "int64", "D: 3 for spheres, 2 for disks"},
           {"/particles/grains/box", "boundary", "text[D]", "\"periodic\" or \"none\" along each axis"},
           {"/particles/grains/orientation", "order", "\"wxyz\"", "order of the quaternion's components"},
           {"/particles/grains/velocity", "time_offset", "float64", "-0.5: in time steps, relative to time"},
           {"/particles/grains/angular_velocity", "time_offset", "float64", "-0.5: likewise"}}};
}

Section cell() {
  return {
      "The cell, beyond its edges",
      "packing run checkpoint multiscale",
      {{"/cell/velocity_gradient", float64, "F 3 3", "s-1", "velocity gradient, extension positive"},
       {"/cell/deformation_gradient", float64, "F 3 3", "1", "deformation gradient since the reference of the strains"},
       {"/cell/thickness", float64, "F", "m", "length of the third cell vector, 2D only", true}},
      {}};
}

Section contacts() {
  return {"Contacts: one group a frame, numbered from 000000, sorted by bodies",
          "packing run checkpoint multiscale",
          {{"/contacts/<frame>/bodies", int32, "M 2", "1",
            "rows of the first and second grain in /particles/grains; -1 - k in second: plane k"},
           {"/contacts/<frame>/image", int32, "M 3", "1", "cell vectors to add to the second grain's position"},
           {"/contacts/<frame>/normal", float64, "M 3", "1", "unit contact normal, from first to second"},
           {"/contacts/<frame>/branch_vector", float64, "M 3", "m",
            "vector from centre to centre; to the contact point for a plane"},
           {"/contacts/<frame>/overlap", float64, "M", "m", "overlap"},
           {"/contacts/<frame>/normal_force", float64, "M", "N", "normal force, compression positive"},
           {"/contacts/<frame>/shear_force", float64, "M 3", "N", "shear force on the second body"},
           {"/contacts/<frame>/rolling_moment", float64, "M 3", "N m", "rolling moment on the second body"},
           {"/contacts/<frame>/twisting_moment", float64, "M", "N m",
            "twisting moment about the normal on the second body"},
           {"/contacts/<frame>/sliding", uint8, "M", "1", "1 where the Coulomb limit holds the shear force"},
           {"/contacts/<frame>/<field>", float64, "M", "its own", "its own: a field of the contact law (M 3: a vector)",
            true}},
          {}};
}

Section planes() {
  return {
      "Rigid planes (absent without)",
      "packing run checkpoint multiscale",
      {{"/planes/point", float64, "F P 3", "m", "a point of the plane", true},
       {"/planes/normal", float64, "F P 3", "1", "unit normal into the side of the grains", true},
       {"/planes/velocity", float64, "F P 3", "m s-1", "velocity", true},
       {"/planes/material_id", int32, "F P", "1", "number of the material in the scenario", true},
       {"/planes/partners", int32, "F P", "1", "grains that touch it; 0: all, 1: soil, 2: nodes of geotextiles", true}},
      {}};
}

Section yarns() {
  return {
      "Yarns of geotextiles (absent without)",
      "packing run checkpoint",
      {{"/yarns/nodes", int32, "F Y 2", "1", "rows of both nodes in /particles/grains", true},
       {"/yarns/fabric", int32, "F Y", "1", "number of the fabric; nodes of one fabric do not touch each other", true},
       {"/yarns/geotextile_id", int32, "F Y", "1", "number of the geotextile in the scenario", true},
       {"/yarns/family", int32, "F Y", "1", "0: faces, 1: sides, in plane, 2: sides, from face to face", true},
       {"/yarns/rest_length", float64, "F Y", "m", "length without tension", true},
       {"/yarns/largest_strain", float64, "F Y", "1", "largest strain so far", true},
       {"/yarns/tension", float64, "F Y", "N", "tension", true},
       {"/yarns/broken", uint8, "F Y", "1", "1 where broken", true},
       {"/yarns/break_time", float64, "F Y", "s", "time at which it broke; 0 where whole", true},
       {"/yarns/break_position", float64, "F Y 3", "m", "position at which it broke; 0 where whole", true}},
      {}};
}

Section series() {
  return {"The series: one value a recorded moment",
          "run checkpoint multiscale",
          {{"/series/step", int64, "R", "1", "number of time steps taken", true},
           {"/series/<column>", float64, "R", "its own", "its own", true}},
          {{"/series/<column>", "column", "int64", "place among the columns, from 0"}}};
}

Section run() {
  return {"A run besides",
          "run multiscale",
          {{"/scenario", text, "", "1", "scenario as it was resolved, TOML"},
           {"/price/steps", int64, "", "1", "time steps taken", true},
           {"/price/contact_steps", int64, "", "1", "contacts, summed over the steps", true}},
          {}};
}

Section checkpoint() {
  return {"A checkpoint besides: the state that only the running program knows; with the series so far",
          "checkpoint",
          {{"/checkpoint/<name>", float64, "K", "its own", "values that the program needs to go on"}},
          {}};
}

Section fields() {
  return {"Fields: the tables of an analysis",
          "fields ensemble checkpoint multiscale",
          {{"/fields/<group>/step", int64, "R", "its own", "its own", true},
           {"/fields/<group>/<column>", float64, "R", "its own", "its own", true}},
          {{"/fields/<group>", "long_name", "text", "contents of the table"},
           {"/fields/<group>", "order", "int64", "place among the groups, from 0"},
           {"/fields/<group>/<column>", "column", "int64", "place among the columns, from 0"}}};
}

Section ensemble() {
  return {"An ensemble besides: one value a parameter set",
          "ensemble",
          {{"/prior", text, "", "1", "ranges and scales of the parameters, TOML"},
           {"/members/id", int64, "R", "1", "number that stays with the parameter set and names its run"},
           {"/members/<column>", float64, "R", "its own", "its own", true}},
          {{"/members/<column>", "column", "int64", "place among the columns, from 0"}}};
}

}  // namespace

const std::vector<Section>& schema() {
  static const std::vector<Section> sections = {every_file(), trajectory(), cell(),    contacts(),
                                                planes(),     yarns(),      series(),  run(),
                                                checkpoint(), fields(),     ensemble()};
  return sections;
}

const Entry& entry(std::string_view path) {
  for (const Section& section : schema())
    for (const Entry& e : section.entries)
      if (e.path == path) return e;
  throw std::out_of_range("no such path in the schema: " + std::string(path));
}

Shape resolve(std::string_view shape, const Extents& extents, bool with_frames) {
  if (shape.starts_with("(F)") && !with_frames) shape.remove_prefix(3);
  Shape numbers;
  for (const char c : shape) {
    if (std::isdigit(static_cast<unsigned char>(c)))
      numbers.push_back(static_cast<Extent>(c - '0'));
    else if (std::isalpha(static_cast<unsigned char>(c)))
      numbers.push_back(extents.at(c));
  }
  return numbers;
}

Extent count(const Shape& shape) {
  Extent n = 1;
  for (const Extent extent : shape)
    if (__builtin_mul_overflow(n, extent, &n)) return std::numeric_limits<Extent>::max();
  return n;
}

std::string print(const Shape& shape) {
  std::string text;
  for (const Extent extent : shape) text += (text.empty() ? "" : " x ") + std::to_string(extent);
  return text.empty() ? "a single value" : text;
}

std::string_view name(Type type) {
  switch (type) {
    case float64:
      return "float64";
    case int64:
      return "int64";
    case int32:
      return "int32";
    case uint8:
      return "uint8";
    case text:
      return "text";
  }
  return "";
}

}  // namespace soilweave::io
