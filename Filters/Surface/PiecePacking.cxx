// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PiecePacking.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <cstring>
#include <string>

namespace sbvtk
{
namespace
{

/** Bytes of the values of a plain array; bits are eight to a byte. */
std::size_t SizeOf(vtkAbstractArray* array)
{
  const auto values = static_cast<std::size_t>(array->GetNumberOfValues());
  return array->GetDataType() == VTK_BIT
    ? (values + 7) / 8
    : values * static_cast<std::size_t>(array->GetDataTypeSize());
}

class Writer
{
public:
  explicit Writer(std::vector<char>& bytes)
    : Bytes(bytes)
  {
  }

  void Number(std::int64_t value) { this->Block(&value, sizeof value); }

  void Text(const std::string& text)
  {
    this->Number(static_cast<std::int64_t>(text.size()));
    this->Block(text.data(), text.size());
  }

  void Array(vtkAbstractArray* array, PieceContents contents)
  {
    const bool empty = contents == PieceContents::OnlyArrays;
    this->Number(array->GetDataType());
    this->Number(array->GetNumberOfComponents());
    this->Number(empty ? 0 : array->GetNumberOfTuples());
    this->Number(array->GetName() ? 1 : 0);
    this->Text(array->GetName() ? array->GetName() : "");
    for (int i = 0; i < array->GetNumberOfComponents(); ++i)
    {
      this->Text(array->GetComponentName(i) ? array->GetComponentName(i) : "");
    }
    if (!empty)
    {
      this->Values(array);
    }
  }

  void Attributes(vtkFieldData* arrays, PieceContents contents)
  {
    vtkDataSetAttributes* attributes = vtkDataSetAttributes::SafeDownCast(arrays);
    std::vector<int> carried;
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      if (arrays->GetAbstractArray(i)->GetDataType() != VTK_VARIANT)
      {
        carried.push_back(i);
      }
    }
    this->Number(static_cast<std::int64_t>(carried.size()));
    for (const int i : carried)
    {
      this->Number(attributes ? attributes->IsArrayAnAttribute(i) : -1);
      this->Array(arrays->GetAbstractArray(i), contents);
    }
  }

  void Cells(vtkCellArray* cells)
  {
    this->Number(cells->IsStorage64Bit() ? 1 : 0);
    this->Array(cells->GetOffsetsArray(), PieceContents::All);
    this->Array(cells->GetConnectivityArray(), PieceContents::All);
  }

private:
  void Block(const void* data, std::size_t size)
  {
    const char* begin = static_cast<const char*>(data);
    this->Bytes.insert(this->Bytes.end(), begin, begin + size);
  }

  void Values(vtkAbstractArray* array)
  {
    if (vtkStringArray* texts = vtkStringArray::SafeDownCast(array))
    {
      for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i)
      {
        this->Text(texts->GetValue(i));
      }
    }
    else if (array->HasStandardMemoryLayout())
    {
      this->Block(array->GetVoidPointer(0), SizeOf(array));
    }
    else
    {
      const auto plain = vtkSmartPointer<vtkAbstractArray>::Take(
        vtkAbstractArray::CreateArray(array->GetDataType()));
      plain->DeepCopy(array);
      this->Block(plain->GetVoidPointer(0), SizeOf(plain));
    }
  }

  std::vector<char>& Bytes;
};

class Reader
{
public:
  explicit Reader(const std::vector<char>& bytes)
    : Next(bytes.data())
    , End(bytes.data() + bytes.size())
  {
  }

  bool AtEnd() const { return this->Next == this->End; }

  std::int64_t Number()
  {
    std::int64_t value = 0;
    this->Block(&value, sizeof value);
    return value;
  }

  std::string Text()
  {
    std::string text(static_cast<std::size_t>(this->Number()), ' ');
    this->Block(&text[0], text.size());
    return text;
  }

  vtkSmartPointer<vtkAbstractArray> Array()
  {
    const auto array = vtkSmartPointer<vtkAbstractArray>::Take(
      vtkAbstractArray::CreateArray(static_cast<int>(this->Number())));
    array->SetNumberOfComponents(static_cast<int>(this->Number()));
    const std::int64_t tuples = this->Number();
    const bool named = this->Number() != 0;
    const std::string name = this->Text();
    array->SetName(named ? name.c_str() : nullptr);
    for (int i = 0; i < array->GetNumberOfComponents(); ++i)
    {
      const std::string component = this->Text();
      if (!component.empty())
      {
        array->SetComponentName(i, component.c_str());
      }
    }
    array->SetNumberOfTuples(tuples);
    this->Values(array);
    return array;
  }

  void Attributes(vtkFieldData* arrays)
  {
    for (std::int64_t count = this->Number(); count > 0; --count)
    {
      const int role = static_cast<int>(this->Number());
      const int place = arrays->AddArray(this->Array());
      if (role >= 0)
      {
        static_cast<vtkDataSetAttributes*>(arrays)->SetActiveAttribute(place, role);
      }
    }
  }

  vtkSmartPointer<vtkCellArray> Cells()
  {
    const auto cells = vtkSmartPointer<vtkCellArray>::New();
    this->Number() != 0 ? this->CellsOf<vtkTypeInt64Array>(cells)
                        : this->CellsOf<vtkTypeInt32Array>(cells);
    return cells;
  }

private:
  void Block(void* data, std::size_t size)
  {
    std::memcpy(data, this->Next, size);
    this->Next += size;
  }

  void Values(vtkAbstractArray* array)
  {
    if (vtkStringArray* texts = vtkStringArray::SafeDownCast(array))
    {
      for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i)
      {
        texts->SetValue(i, this->Text());
      }
    }
    else if (array->GetNumberOfValues() > 0)
    {
      this->Block(array->GetVoidPointer(0), SizeOf(array));
    }
  }

  template <class Ids>
  void CellsOf(vtkCellArray* cells)
  {
    vtkNew<Ids> offsets;
    vtkNew<Ids> connectivity;
    offsets->ShallowCopy(vtkDataArray::SafeDownCast(this->Array()));
    connectivity->ShallowCopy(vtkDataArray::SafeDownCast(this->Array()));
    cells->SetData(offsets.Get(), connectivity.Get());
  }

  const char* Next;
  const char* End;
};

constexpr auto kinds = { &vtkPolyData::GetVerts, &vtkPolyData::GetLines, &vtkPolyData::GetPolys,
  &vtkPolyData::GetStrips };

} // namespace

//------------------------------------------------------------------------------
void PackPieces(const std::vector<Piece>& pieces, PieceContents contents, std::vector<char>& bytes)
{
  Writer writer(bytes);
  for (const Piece& piece : pieces)
  {
    writer.Number(piece.Place);
    writer.Number(piece.Type);
    writer.Attributes(piece.Data->GetFieldData(), PieceContents::All);
    writer.Attributes(piece.Data->GetPointData(), contents);
    writer.Attributes(piece.Data->GetCellData(), contents);
    writer.Number(piece.Data->GetPoints() ? 1 : 0);
    if (piece.Data->GetPoints())
    {
      writer.Array(piece.Data->GetPoints()->GetData(), contents);
    }
    for (const auto cellsOf : kinds)
    {
      vtkNew<vtkCellArray> none;
      writer.Cells(contents == PieceContents::All ? (piece.Data->*cellsOf)() : none.Get());
    }
  }
}

//------------------------------------------------------------------------------
std::vector<Piece> UnpackPieces(const std::vector<char>& bytes)
{
  std::vector<Piece> pieces;
  for (Reader reader(bytes); !reader.AtEnd();)
  {
    Piece piece;
    piece.Place = reader.Number();
    piece.Type = static_cast<int>(reader.Number());
    piece.Data = vtkSmartPointer<vtkPolyData>::New();
    reader.Attributes(piece.Data->GetFieldData());
    reader.Attributes(piece.Data->GetPointData());
    reader.Attributes(piece.Data->GetCellData());
    if (reader.Number() != 0)
    {
      vtkNew<vtkPoints> points;
      const auto coordinates = reader.Array();
      points->SetData(vtkDataArray::SafeDownCast(coordinates));
      piece.Data->SetPoints(points);
    }
    piece.Data->SetVerts(reader.Cells());
    piece.Data->SetLines(reader.Cells());
    piece.Data->SetPolys(reader.Cells());
    piece.Data->SetStrips(reader.Cells());
    pieces.push_back(piece);
  }
  return pieces;
}

} // namespace sbvtk
