// VTK XML files as bytes. Only this file and files/exchange/triangles_vtk.cpp include VTK.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "display/vtk.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <array>

#include "core/error.h"

namespace soilweave::io {
namespace {

template <class Array, class Value>
vtkSmartPointer<vtkDataArray> filled(const std::vector<Value>& values, int components) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

vtkSmartPointer<vtkDataArray> convert(const VtkArray& source) {
  struct {
    int components;
    vtkSmartPointer<vtkDataArray> operator()(const std::vector<double>& v) {
      return filled<vtkDoubleArray>(v, components);
    }
    vtkSmartPointer<vtkDataArray> operator()(const std::vector<std::int64_t>& v) {
      return filled<vtkTypeInt64Array>(v, components);
    }
    vtkSmartPointer<vtkDataArray> operator()(const std::vector<std::int32_t>& v) {
      return filled<vtkTypeInt32Array>(v, components);
    }
    vtkSmartPointer<vtkDataArray> operator()(const std::vector<std::uint8_t>& v) {
      return filled<vtkUnsignedCharArray>(v, components);
    }
  } by_type{source.components};
  auto array = std::visit(by_type, source.values);
  array->SetName(source.name.c_str());
  constexpr std::array<const char*, 3> axes = {"X", "Y", "Z"};
  constexpr std::array<const char*, 9> pairs = {"XX", "XY", "XZ", "YX", "YY", "YZ", "ZX", "ZY", "ZZ"};
  for (int c = 0; c < source.components; ++c) {
    if (source.components == 3) array->SetComponentName(c, axes[static_cast<std::size_t>(c)]);
    if (source.components == 9) array->SetComponentName(c, pairs[static_cast<std::size_t>(c)]);
  }
  return array;
}

void attach(vtkFieldData* data, const std::vector<VtkArray>& arrays, std::size_t tuples) {
  for (const VtkArray& array : arrays) {
    const std::size_t size = std::visit([](const auto& values) { return values.size(); }, array.values);
    if (size != tuples * static_cast<std::size_t>(array.components))
      throw DataError("the array " + array.name + " has " + std::to_string(size) + " values, not " +
                      std::to_string(tuples) + " times " + std::to_string(array.components));
    data->AddArray(convert(array));
  }
}

void describe_data(vtkPointSet* set, const VtkPicture& picture) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(picture.points.size()));
  for (std::size_t i = 0; i < picture.points.size(); ++i)
    points->SetPoint(static_cast<vtkIdType>(i), picture.points[i].data());
  set->SetPoints(points);

  attach(set->GetPointData(), picture.point_data, picture.points.size());
  attach(set->GetCellData(), picture.cell_data, picture.points.size() / static_cast<std::size_t>(picture.shape));
  attach(set->GetFieldData(),
         {{"TimeValue", 1, std::vector<double>{picture.time}}, {"step", 1, std::vector<std::int64_t>{picture.step}}},
         1);
}

vtkSmartPointer<vtkCellArray> consecutive_cells(const VtkPicture& picture) {
  const auto size = static_cast<vtkIdType>(picture.shape);
  const auto points = static_cast<vtkIdType>(picture.points.size());
  if (points % size != 0) throw DataError("the points of a picture do not fill its cells");
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (vtkIdType start = 0; start < points; start += size) {
    cells->InsertNextCell(static_cast<int>(size));
    for (vtkIdType corner = 0; corner < size; ++corner) cells->InsertCellPoint(start + corner);
  }
  return cells;
}

template <class Writer>
std::string written(vtkDataObject* data, bool compress) {
  vtkNew<Writer> writer;
  writer->SetInputDataObject(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetHeaderTypeToUInt64();
  if (compress)
    writer->SetCompressorTypeToZLib();
  else
    writer->SetCompressorTypeToNone();
  writer->WriteToOutputStringOn();
  if (writer->Write() != 1) throw IoError("VTK could not encode its data");
  return writer->GetOutputString();
}

}  // namespace

std::string to_vtp(const VtkPicture& picture, bool compress) {
  vtkNew<vtkPolyData> data;
  describe_data(data, picture);
  const auto cells = consecutive_cells(picture);
  switch (picture.shape) {
    case VtkShape::vertex:
      data->SetVerts(cells);
      break;
    case VtkShape::line:
      data->SetLines(cells);
      break;
    case VtkShape::triangle:
    case VtkShape::quad:
      data->SetPolys(cells);
      break;
    case VtkShape::hexahedron:
      throw DataError("PolyData holds no hexahedra");
  }
  return written<vtkXMLPolyDataWriter>(data, compress);
}

std::string to_vtu(const VtkPicture& picture, bool compress) {
  vtkNew<vtkUnstructuredGrid> data;
  describe_data(data, picture);
  const int type = picture.shape == VtkShape::vertex     ? VTK_VERTEX
                   : picture.shape == VtkShape::line     ? VTK_LINE
                   : picture.shape == VtkShape::triangle ? VTK_TRIANGLE
                   : picture.shape == VtkShape::quad     ? VTK_QUAD
                                                         : VTK_HEXAHEDRON;
  data->SetCells(type, consecutive_cells(picture));
  return written<vtkXMLUnstructuredGridWriter>(data, compress);
}

}  // namespace soilweave::io
