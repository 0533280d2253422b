// Judges links, storage and sizes of HDF5 objects before anything is read.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "store/hdf5_guard.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace soilweave::io::hdf5 {
namespace {

constexpr int most_soft_links = 16;  // HDF5's own limit

/// Returns the value of a soft or external link, as HDF5 stores it.
std::string link_value(hid_t file, const std::string& path, const H5L_info_t& info) {
  std::string value(info.u.val_size, '\0');
  if (H5Lget_val(file, path.c_str(), value.data(), value.size(), H5P_DEFAULT) < 0) value.clear();
  return value;
}

std::string refusal_of_link(hid_t file, const std::string& path, const H5L_info_t& info) {
  const std::string at = path + " ";
  if (info.type != H5L_TYPE_EXTERNAL) return at + "is a link of a kind that only the program that made it can follow";
  const std::string value = link_value(file, path, info);
  unsigned flags = 0;
  const char *name = nullptr, *object = nullptr;
  const bool known = !value.empty() && H5Lunpack_elink_val(value.data(), value.size(), &flags, &name, &object) >= 0;
  return at + "is a link into another file" + (known ? std::string(" (") + name + ")" : "") +
         ", which is not followed; copy the values into this file";
}

Extent times(Extent a, Extent b) {
  Extent product = 0;
  return __builtin_mul_overflow(a, b, &product) ? std::numeric_limits<Extent>::max() : product;
}

}  // namespace

Way way_to(hid_t file, const std::string& path) {
  std::string wanted = path;
  for (int soft = 0; soft <= most_soft_links; ++soft) {
    bool turned = false;
    for (std::size_t slash = wanted.find('/', 1); !turned; slash = wanted.find('/', slash + 1)) {
      const std::string step = wanted.substr(0, slash);
      H5L_info_t info;
      if (H5Lget_info(file, step.c_str(), &info, H5P_DEFAULT) < 0) return {};
      if (info.type == H5L_TYPE_SOFT) {
        const std::string target = link_value(file, step, info).c_str();
        const std::string rest = slash == std::string::npos ? "" : wanted.substr(slash);
        wanted = (target.starts_with('/') ? target : step.substr(0, step.rfind('/') + 1) + target) + rest;
        turned = true;
      } else if (info.type != H5L_TYPE_HARD) {
        return {false, refusal_of_link(file, step, info)};
      } else if (slash == std::string::npos) {
        return {H5Oexists_by_name(file, wanted.c_str(), H5P_DEFAULT) > 0, ""};
      }
    }
  }
  return {};
}

std::string refusal(hid_t dataset) {
  const Id list(H5Dget_create_plist(dataset), H5Pclose);
  if (list < 0) return "is damaged";
  switch (H5Pget_layout(list)) {
    case H5D_VIRTUAL:
      return "is put together from other files (a virtual dataset), which are not read; copy the values into this file";
    case H5D_CONTIGUOUS: {
      if (H5Pget_external_count(list) == 0) return "";
      std::array<char, 256> name{};
      if (H5Pget_external(list, 0, name.size() - 1, name.data(), nullptr, nullptr) < 0) name = {};
      return "keeps its values in another file (" + std::string(name.data()) +
             "), which is not read; copy the values into this file";
    }
    case H5D_CHUNKED:
      for (int k = 0; k < H5Pget_nfilters(list); ++k) {
        std::array<char, 64> name{};
        std::size_t parameters = 0;
        unsigned flags = 0, settings = 0;
        const H5Z_filter_t filter = H5Pget_filter2(list, static_cast<unsigned>(k), &flags, &parameters, nullptr,
                                                   name.size() - 1, name.data(), &settings);
        if (filter < 0 || H5Zfilter_avail(filter) <= 0)
          return "is packed by the HDF5 filter " + std::to_string(filter) + " (" + name.data() +
                 "), which this machine lacks; write it anew with gzip, or without a filter";
      }
      return "";
    default:
      return "";
  }
}

Unpacked unpacked(hid_t dataset, hid_t space, hid_t type) {
  const int rank = std::max(H5Sget_simple_extent_ndims(space), 0);
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank)), chunk(shape.size());
  if (rank > 0) H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  const auto values_of = [](const std::vector<hsize_t>& extents) {
    return count(Shape(extents.begin(), extents.end()));
  };
  const Extent size = H5Tget_size(type), claimed = times(values_of(shape), size);
  const Id list(H5Dget_create_plist(dataset), H5Pclose);
  if (claimed == 0) return {};
  if (list < 0 || H5Pget_layout(list) != H5D_CHUNKED) {
    const Extent stored = H5Dget_storage_size(dataset);
    if (stored >= claimed) return {claimed, ""};
    return {claimed, stored == 0
                         ? "was never written"
                         : "holds " + std::to_string(stored) + " bytes where " + std::to_string(claimed) + " belong"};
  }
  if (H5Pget_chunk(list, rank, chunk.data()) != rank) return {claimed, "is damaged"};
  Extent chunks = 1;
  for (std::size_t d = 0; d < shape.size(); ++d)
    chunks = times(chunks, (shape[d] - 1) / std::max<hsize_t>(chunk[d], 1) + 1);
  hsize_t stored = 0;
  if (H5Dget_num_chunks(dataset, space, &stored) < 0) return {claimed, "is damaged"};
  const std::string gap = stored >= chunks ? ""
                                           : "lacks " + std::to_string(chunks - stored) + " of its " +
                                                 std::to_string(chunks) + " chunks: it was never written to its end";
  return {times(chunks, times(values_of(chunk), size)), gap};
}

}  // namespace soilweave::io::hdf5
