// Surfaces of triangles from VTK files. Only this file and display/vtk.cpp include VTK.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <new>
#include <string>
#include <vector>

#include "core/error.h"
#include "files/exchange/triangles.h"

namespace soilweave::io {
namespace {

using Corners = std::vector<std::size_t>;

// Calls `each` with the corners of each cell. Throws DataError for one on a point beyond `points`.
template <class Each>
void visit_cells(vtkCellArray* cells, std::size_t points, const std::string& path, const Each& each) {
  if (cells == nullptr) return;
  const auto at = vtk::TakeSmartPointer(cells->NewIterator());
  for (at->GoToFirstCell(); !at->IsDoneWithTraversal(); at->GoToNextCell()) {
    vtkIdType corners = 0;
    const vtkIdType* corner = nullptr;
    at->GetCurrentCell(corners, corner);
    Corners cell;
    for (vtkIdType k = 0; k < corners; ++k) {
      if (corner[k] < 0 || static_cast<std::size_t>(corner[k]) >= points)
        throw DataError(fmt::format("'{}' has a polygon on a point it does not have", path));
      cell.push_back(static_cast<std::size_t>(corner[k]));
    }
    each(cell);
  }
}

// Returns whether the triangles from the first corner to each side all face the way of the polygon.
bool is_fan(const Corners& cell, const std::vector<Vec3>& points) {
  std::vector<Vec3> normals;
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 2; k < cell.size(); ++k) {
    const Vec3& x = points[cell[0]];
    normals.emplace_back((points[cell[k - 1]] - x).cross(points[cell[k]] - x));
    sum += normals.back();
  }
  return std::ranges::all_of(normals, [&](const Vec3& n) { return n.dot(sum) >= 0; });
}

// Adds the triangles of a polygon. Throws DataError for one that cannot be divided.
void add_polygon(const Corners& cell, const std::string& path, TriangleSoup& soup) {
  if (is_fan(cell, soup.points)) {
    for (std::size_t k = 2; k < cell.size(); ++k) soup.triangles.push_back({cell[0], cell[k - 1], cell[k]});
    return;
  }
  vtkNew<vtkPolygon> polygon;
  for (const std::size_t k : cell) {
    polygon->GetPointIds()->InsertNextId(static_cast<vtkIdType>(k));
    polygon->GetPoints()->InsertNextPoint(soup.points[k].data());
  }
  vtkNew<vtkIdList> triangles;
  if (polygon->EarCutTriangulation(triangles) == 0)
    throw DataError(
        fmt::format("'{}' has a polygon of {} corners, on point {}, that cuts itself or is not flat: "
                    "triangulate the surface where it is made",
                    path, cell.size(), cell[0]));
  const auto corner = [&](vtkIdType k) { return cell.at(static_cast<std::size_t>(triangles->GetId(k))); };
  for (vtkIdType k = 0; k + 2 < triangles->GetNumberOfIds(); k += 3)
    soup.triangles.push_back({corner(k), corner(k + 1), corner(k + 2)});
}

}  // namespace

TriangleSoup read_vtp(const std::string& path) {
  vtkObject::GlobalWarningDisplayOff();  // else VTK prints warnings about its own sources
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  try {
    reader->Update();
  } catch (const std::bad_alloc&) {
    throw DataError(fmt::format("'{}' claims more than fits into memory: it is damaged, or no VTK file", path));
  }
  vtkPolyData* data = reader->GetOutput();
  TriangleSoup soup;
  if (reader->GetErrorCode() != 0 || data == nullptr || data->GetPoints() == nullptr || data->GetPolys() == nullptr)
    throw DataError(fmt::format("'{}' is no VTK file of polygons", path));
  const vtkIdType points = data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < points; ++i) {
    Vec3 x;
    data->GetPoint(i, x.data());
    soup.points.push_back(x);
  }
  visit_cells(data->GetPolys(), soup.points.size(), path, [&](const Corners& cell) { add_polygon(cell, path, soup); });
  // Every second triangle of a strip has the other sense.
  visit_cells(data->GetStrips(), soup.points.size(), path, [&](const Corners& cell) {
    for (std::size_t k = 2; k < cell.size(); ++k)
      soup.triangles.push_back({cell[k - 2 + k % 2], cell[k - 1 - k % 2], cell[k]});
  });
  return soup;
}

}  // namespace soilweave::io
