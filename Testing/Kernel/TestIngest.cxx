// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestIngest.cxx
 * @brief Every condition of an operand is recognised, with the place and the count; what is good is
 * measured.
 */
#include "Check.h"
#include "Ingest.h"
#include "Shapes.h"
#include "ThreadExecutor.h"

#include <limits>

namespace
{

using sb::Status;
using namespace shapes;

sb::Ingested Ingest(const Mesh& mesh)
{
  sb::SerialExecutor executor;
  return sb::Ingest(Case{ { mesh }, {}, sb::Operation::Union }.Request(), executor);
}

/** The one remark on a surface. */
sb::Remark RemarkOn(const Mesh& mesh)
{
  const sb::Ingested result = Ingest(mesh);
  CHECK_EQUAL(result.Remarks.size(), 1u);
  return result.Remarks.empty() ? sb::Remark() : result.Remarks.front();
}

void CheckRemark(
  const Mesh& mesh, Status condition, std::int64_t triangle, std::int64_t point, std::int64_t count)
{
  const sb::Remark remark = RemarkOn(mesh);
  CHECK_EQUAL(int(remark.Condition), int(condition));
  CHECK_EQUAL(remark.Operand, 0);
  CHECK_EQUAL(remark.Triangle, triangle);
  CHECK_EQUAL(remark.Point, point);
  CHECK_EQUAL(remark.Count, count);
}

Mesh Soup(const Mesh& mesh)
{
  Mesh soup;
  for (const Corners& t : mesh.Triangles)
  {
    soup.AddTriangle(mesh.At(t, 0), mesh.At(t, 1), mesh.At(t, 2));
  }
  return soup;
}

void CheckClosed()
{
  const Mesh box = Box({ -1, 2, 3 }, { 3, 4, 8 });
  for (const Mesh& mesh : { box, Soup(box) })
  {
    const sb::Ingested result = Ingest(mesh);
    CHECK(result.Remarks.empty());
    CHECK(result.Reports[0].Closed);
    CHECK_EQUAL(result.Reports[0].Volume, 40.0);
    CHECK_EQUAL(result.Reports[0].Area, 76.0);
    CHECK((result.Reports[0].Bounds == std::array<double, 6>{ -1, 3, 2, 4, 3, 8 }));
    CHECK_EQUAL(int(result.Open[0]), 0);
    CHECK_EQUAL(int(result.Swapped[0]), 0);
  }
  // The two zeros are one place.
  Mesh zeros = Soup(Cube(0, 1));
  for (std::size_t i = 0; i < zeros.Points.size(); i += 2)
  {
    for (double& x : zeros.Points[i])
    {
      x = x == 0.0 ? -0.0 : x;
    }
  }
  CHECK(Ingest(zeros).Remarks.empty());
  // Points that no triangle uses do not count, be they as bad as can be.
  Mesh spare = box;
  spare.Points.push_back({ 1e300, std::nan(""), 0 });
  const sb::Ingested result = Ingest(spare);
  CHECK(result.Remarks.empty());
  CHECK_EQUAL(result.Reports[0].Bounds[1], 3.0);
  // Closed without being a manifold: two boxes along a common edge; and a collapsed triangle is no
  // harm.
  Mesh two = Cube(0, 1);
  two.Append(Box({ 1, 1, 0 }, { 2, 2, 1 }));
  CHECK(Ingest(two).Remarks.empty());
  two.Triangles.push_back({ 3, 3, 5 });
  CHECK(Ingest(two).Remarks.empty());
}

void CheckOpen()
{
  for (std::size_t missing = 0; missing < 12; ++missing)
  {
    Mesh box = Cube(0, 1);
    box.Triangles.erase(box.Triangles.begin() + static_cast<std::ptrdiff_t>(missing));
    const sb::Remark remark = RemarkOn(box);
    CHECK(remark.Condition == Status::OpenOperand);
    CHECK_EQUAL(remark.Count, 3);
    // The triangle named has an edge in common with the missing one.
    const Corners gone = Cube(0, 1).Triangles[missing];
    int common = 0;
    for (const std::int32_t corner : box.Triangles[static_cast<std::size_t>(remark.Triangle)])
    {
      common += std::count(gone.begin(), gone.end(), corner) > 0;
    }
    CHECK_EQUAL(common, 2);
    const sb::Ingested result = Ingest(Soup(box));
    CHECK_EQUAL(int(result.Open[0]), 1);
    CHECK(!result.Reports[0].Closed);
    CHECK_EQUAL(result.Rims[0].size(), 3u);
    for (const sb::RimEdge& rim : result.Rims[0])
    {
      const Corners& t = box.Triangles[static_cast<std::size_t>(rim.Triangle)];
      const std::int32_t from = t[static_cast<std::size_t>(rim.Edge)];
      const std::int32_t to = t[static_cast<std::size_t>((rim.Edge + 1) % 3)];
      CHECK(std::count(gone.begin(), gone.end(), from) == 1 &&
        std::count(gone.begin(), gone.end(), to) == 1);
    }
  }
  CheckRemark(Triangle({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }), Status::OpenOperand, 0, -1, 3);
  CHECK_EQUAL(RemarkOn(Tube(1, 0, 1, 8)).Count, 16);
}

void CheckInconsistent()
{
  for (std::size_t turned = 0; turned < 12; ++turned)
  {
    Mesh box = Cube(0, 1);
    std::swap(box.Triangles[turned][1], box.Triangles[turned][2]);
    const sb::Remark remark = RemarkOn(box);
    CHECK(remark.Condition == Status::InconsistentOrientation);
    CHECK_EQUAL(remark.Count, 3);
    CHECK(remark.Triangle >= 0 && remark.Triangle <= static_cast<std::int64_t>(turned));
  }
  // An open surface of two triangles that disagree.
  Mesh sheet = Sheet({ 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 });
  std::swap(sheet.Triangles[1][1], sheet.Triangles[1][2]);
  CheckRemark(sheet, Status::InconsistentOrientation, 0, -1, 1);
}

void CheckInsideOut()
{
  const Mesh box = Cube(0, 2).Reversed();
  CheckRemark(box, Status::InsideOut, -1, -1, 0);
  const sb::Ingested result = Ingest(box);
  CHECK_EQUAL(int(result.Swapped[0]), 1);
  CHECK_EQUAL(result.Reports[0].Volume, -8.0);
  CHECK(result.Reports[0].Closed);
  // A cavity is not inside out.
  Mesh shell = Cube(0, 2);
  shell.Append(Cube(0.5, 1.5).Reversed());
  CHECK(Ingest(shell).Remarks.empty());
  CHECK_EQUAL(Ingest(shell).Reports[0].Volume, 7.0);
}

void CheckBadNumbers()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { std::nan(""), infinity, -infinity })
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      Mesh box = Cube(0, 1);
      box.Points[6][axis] = bad;
      std::int64_t first = 0;
      while (std::count(box.Triangles[static_cast<std::size_t>(first)].begin(),
               box.Triangles[static_cast<std::size_t>(first)].end(), 6) == 0)
      {
        ++first;
      }
      const sb::Remark remark = RemarkOn(box);
      CHECK(remark.Condition == Status::BadCoordinate);
      CHECK_EQUAL(remark.Triangle, first);
      CHECK_EQUAL(remark.Point, 6);
    }
  }
  for (const std::int32_t bad :
    { -1, 8, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max() })
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      Mesh box = Cube(0, 1);
      box.Triangles[7][corner] = bad;
      const sb::Remark remark = RemarkOn(box);
      CHECK(remark.Condition == Status::BadIndex);
      CHECK_EQUAL(remark.Triangle, 7);
    }
  }
  // Triangles without any point.
  Mesh none;
  none.Triangles.push_back({ 0, 1, 2 });
  CHECK(RemarkOn(none).Condition == Status::BadIndex);
  // The largest doubles are no reason to refuse.
  const sb::Ingested large = Ingest(Cube(-1e300, 1e300));
  for (const sb::Remark& remark : large.Remarks)
  {
    CHECK(!sb::IsError(remark.Condition));
  }
  CHECK(large.Reports[0].Closed);
}

void CheckTooLarge()
{
  const Mesh box = Cube(0, 1);
  sb::SerialExecutor executor;
  for (const bool triangles : { false, true })
  {
    sb::BooleanRequest request = Case{ { box }, {}, sb::Operation::Union }.Request();
    (triangles ? request.Operands[0].Mesh.NumberOfTriangles
               : request.Operands[0].Mesh.NumberOfPoints) = std::int64_t(1) << 31;
    const sb::Ingested result = sb::Ingest(request, executor);
    CHECK_EQUAL(result.Remarks.size(), 1u);
    CHECK(result.Remarks.front().Condition == Status::TooLarge);
  }
}

void CheckEmpty()
{
  CheckRemark(Mesh(), Status::EmptyOperand, -1, -1, 0);
  Mesh points;
  points.Points = Cube(0, 1).Points;
  CheckRemark(points, Status::EmptyOperand, -1, -1, 0);
  CHECK_EQUAL(int(Ingest(points).Open[0]), 0);
}

/** Several operands: each has its own entry, whatever the others are; a kept examination gives the
 * same. */
void CheckSeveral()
{
  Mesh open = Cube(0, 1);
  open.Triangles.pop_back();
  Case given{ { Cube(0, 1), open }, { Mesh(), Cube(1, 2).Reversed() }, sb::Operation::Union };
  sb::SerialExecutor executor;
  sb::BooleanRequest request = given.Request();
  for (const bool known : { false, true })
  {
    for (sb::Operand& operand : request.Operands)
    {
      operand.Known = known ? sb::Examine(operand.Mesh, executor) : nullptr;
    }
    const sb::Ingested result = sb::Ingest(request, executor);
    CHECK_EQUAL(result.Reports.size(), 4u);
    CHECK((result.Open == std::vector<std::uint8_t>{ 0, 1, 0, 0 }));
    CHECK((result.Swapped == std::vector<std::uint8_t>{ 0, 0, 0, 1 }));
    CHECK_EQUAL(result.Remarks.size(), 3u);
    for (std::size_t i = 0; i < result.Remarks.size(); ++i)
    {
      CHECK_EQUAL(result.Remarks[i].Operand, std::int32_t(i + 1));
    }
    CHECK(result.Remarks[0].Condition == Status::OpenOperand);
    CHECK(result.Remarks[1].Condition == Status::EmptyOperand);
    CHECK(result.Remarks[2].Condition == Status::InsideOut);
  }
}

/** A large surface, in several blocks: measures to rounding, and the same bits from two threads. */
void CheckLarge()
{
  const Mesh sphere = Sphere({ 1, 2, 3 }, 2.0, 100);
  const Case given{ { sphere }, {}, sb::Operation::Union };
  sb::SerialExecutor one;
  sb::ThreadExecutor two(2);
  const sb::Ingested first = sb::Ingest(given.Request(), one);
  const sb::Ingested second = sb::Ingest(given.Request(), two);
  CHECK(first.Remarks.empty() && first.Reports[0].Closed);
  CHECK(std::abs(first.Reports[0].Volume - Volume(sphere)) < 1e-10);
  CHECK(std::abs(first.Reports[0].Area - Area(sphere)) < 1e-10);
  CHECK(first.Reports[0].Volume == second.Reports[0].Volume);
  CHECK(first.Reports[0].Area == second.Reports[0].Area);
  // A hole far into it.
  Mesh open = sphere;
  open.Triangles.erase(open.Triangles.begin() + 70000);
  const sb::Remark remark = RemarkOn(open);
  CHECK(remark.Condition == Status::OpenOperand);
  CHECK_EQUAL(remark.Count, 3);
  // Where that does not matter, nothing is said, and nothing else is different.
  sb::SerialExecutor serial;
  const auto accepted = sb::Examine(open.View(), serial, sb::OpenSurfaces::Accept);
  CHECK(accepted->IsOpen && accepted->Remarks.empty() && accepted->Rim.empty());
  CHECK(accepted->Report.Bounds == sb::Examine(open.View(), serial)->Report.Bounds);
}

} // namespace

int main()
{
  CheckClosed();
  CheckOpen();
  CheckInconsistent();
  CheckInsideOut();
  CheckBadNumbers();
  CheckTooLarge();
  CheckEmpty();
  CheckSeveral();
  CheckLarge();
  return check::Verdict("TestIngest");
}
