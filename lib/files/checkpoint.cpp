// A checkpoint as a file: a run with one state, plus the numbers that only the running program knows.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "files/file_head.h"
#include "files/files.h"
#include "files/part.h"
#include "store/bytes.h"

namespace soilweave::io {
namespace {

const std::string numbers_group = "/checkpoint";

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint, const History& history) {
  Writer file;
  write_head(file, "checkpoint", history);
  if (checkpoint.state.grains.size() > 0) {
    check(checkpoint.state, path.string());
    write_states(file, {&checkpoint.state}, history);
  } else {
    write_recorded(file, checkpoint.tables, checkpoint.frames, history);
  }
  write_columns(file, series_group, checkpoint.series);
  file.group(numbers_group);
  const Entry& e = entry("/checkpoint/<name>");
  for (const auto& [name, values] : checkpoint.numbers)
    file.write<double>(child_path(numbers_group, name), values, {values.size()},
                       {std::string(e.units), std::string(e.long_name)});
  write_own_bytes(path, file.image());
}

Checkpoint read_checkpoint(const std::filesystem::path& path, History& history) {
  OpenFile file(path, "checkpoint");
  file.demand_kind("checkpoint");
  history = read_history(file.reader);
  Checkpoint checkpoint;
  if (file.reader.has("/fields")) {
    checkpoint.tables = read_groups(file.reader);
    if (file.reader.has("/particles")) checkpoint.frames = read_frames(file.reader);
  } else {
    std::vector<Snapshot> states = read_frames(file.reader);
    if (states.size() != 1)
      file.reader.fail("/particles/grains", fmt::format("holds {} states, not one", states.size()));
    check(states.front(), path.string());
    checkpoint.state = std::move(states.front());
  }
  checkpoint.series = read_columns(file.reader, series_group);
  for (const std::string& name : file.reader.children(numbers_group)) {
    const std::string place = child_path(numbers_group, name);
    const Shape shape = file.reader.shape(place);
    if (shape.size() != 1) file.reader.fail(place, "is no list of numbers");
    checkpoint.numbers[name] = file.reader.read<double>(place, shape);
  }
  return checkpoint;
}

}  // namespace soilweave::io
