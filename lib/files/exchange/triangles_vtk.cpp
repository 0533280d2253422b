// Surfaces of triangles from VTK files. Only this file and display/vtk.cpp include VTK.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <new>

#include "core/error.h"
#include "files/exchange/triangles.h"

namespace soilweave::io {

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
  const auto polygons = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell()) {
    vtkIdType corners = 0;
    const vtkIdType* corner = nullptr;
    polygons->GetCurrentCell(corners, corner);
    for (vtkIdType k = 0; k < corners; ++k)
      if (corner[k] < 0 || corner[k] >= points)
        throw DataError(fmt::format("'{}' has a polygon on a point it does not have", path));
    for (vtkIdType k = 2; k < corners; ++k)
      soup.triangles.push_back({static_cast<std::size_t>(corner[0]), static_cast<std::size_t>(corner[k - 1]),
                                static_cast<std::size_t>(corner[k])});
  }
  return soup;
}

}  // namespace soilweave::io
