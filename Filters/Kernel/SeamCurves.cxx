// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SeamCurves.h"

#include "SeamTarget.h"

#include <algorithm>
#include <cstddef>

namespace sb
{
namespace
{

constexpr std::int64_t Grain = 64;

class Tracing
{
public:
  Tracing(const Curves& curves, const CombinedMesh& before, const SeamSnap& snap,
    const SeamSnapRequest& request, Executor& executor)
    : Found(curves)
    , Before(before)
    , Snap(snap)
    , Request(request)
    , Threads(executor)
  {
  }

  SeamCurves Run()
  {
    this->FindMakers();
    this->NumberPoints();
    this->PlacePoints();
    this->MakeCurves();
    this->MeasureChords();
    this->CountEnds();
    return std::move(this->Traced);
  }

private:
  /** The tool's triangle of each segment, and one for each point. */
  void FindMakers()
  {
    this->TriangleOfPoint.assign(this->Found.Points.size(), -1);
    std::size_t segment = 0;
    for (std::size_t c = 0; c + 1 < this->Found.Offsets.size(); ++c)
    {
      for (std::int32_t k = this->Found.Offsets[c]; k + 1 < this->Found.Offsets[c + 1]; ++k)
      {
        const Curves::Makers& makers = this->Found.Segments[segment++];
        const std::int32_t triangle = makers.Triangle[makers.Operand[0] == 1 ? 0 : 1];
        this->TriangleOfSegment.push_back(triangle);
        this->TriangleOfPoint[static_cast<std::size_t>(
          this->Found.Connectivity[static_cast<std::size_t>(k)])] = triangle;
        this->TriangleOfPoint[static_cast<std::size_t>(
          this->Found.Connectivity[static_cast<std::size_t>(k + 1)])] = triangle;
      }
    }
  }

  /** Which points of the mesh those of the curves are, found by their places: points that were
   * collapsed into one are one. */
  void NumberPoints()
  {
    const std::size_t inMesh = this->Before.OriginalPoint.size();
    std::vector<double> places = this->Before.Points;
    for (const std::array<double, 3>& point : this->Found.Points)
    {
      places.insert(places.end(), point.begin(), point.end());
    }
    const std::vector<std::int32_t> first =
      FirstAtPlace(places.data(), places.size() / 3, this->Threads);
    std::vector<std::int32_t> numberOf(this->Snap.Mesh.OriginalPoint.size(), -1);
    this->Number.resize(this->Found.Points.size());
    for (std::size_t i = 0; i < this->Number.size(); ++i)
    {
      const std::size_t at = static_cast<std::size_t>(first[inMesh + i]);
      const std::int32_t point = at < inMesh ? this->Snap.PointMap[at] : -1;
      std::int32_t next = static_cast<std::int32_t>(this->PointOfMesh.size());
      if (point >= 0)
      {
        std::int32_t& known = numberOf[static_cast<std::size_t>(point)];
        known = known < 0 ? next : known;
        next = known;
      }
      this->Number[i] = next;
      if (next == static_cast<std::int32_t>(this->PointOfMesh.size()))
      {
        this->PointOfMesh.push_back(point);
        this->Traced.Points.push_back(
          point >= 0 ? this->Snap.Mesh.Point(point) : Real3(this->Found.Points[i]));
        this->Traced.Triangle.push_back(this->TriangleOfPoint[i]);
      }
    }
  }

  /** A point that is in no triangle of the result is moved onto both surfaces here. */
  void PlacePoints()
  {
    this->Traced.Normals.resize(this->Traced.Points.size());
    this->Traced.Residuals.resize(this->Traced.Points.size());
    this->ForAll(this->Traced.Points.size(), [&](std::size_t i, auto& near) {
      Real3& place = this->Traced.Points[i];
      if (this->PointOfMesh[i] < 0)
      {
        const SeamTarget target = this->TargetFrom(place, this->Traced.Triangle[i], near);
        place = target.Reached ? target.Place : place;
      }
      const SurfaceValue f = this->Request.Cloud->EvaluateAt(place, 1, near);
      const double steepness = Length(f.Gradient);
      if (steepness > 0.0)
      {
        this->Traced.Normals[i] = Scaled(f.Gradient, 1.0 / steepness);
        this->Traced.Residuals[i] = std::abs(f.Value) / steepness;
      }
    });
  }

  SeamTarget TargetFrom(
    const Real3& place, std::int32_t triangle, MovingLeastSquares::Neighbourhood& near) const
  {
    return FindSeamTarget(*this->Request.Cloud, *this->Request.Tool,
      FreedomOn(*this->Request.Tool, { triangle }, place), place, this->Request.Spacing, near);
  }

  void MakeCurves()
  {
    std::size_t segment = 0;
    for (std::size_t c = 0; c + 1 < this->Found.Offsets.size(); ++c)
    {
      SeamCurve curve;
      const std::size_t firstChord = this->Chords.size();
      for (std::int32_t k = this->Found.Offsets[c]; k < this->Found.Offsets[c + 1]; ++k)
      {
        const std::int32_t point = this->Number[static_cast<std::size_t>(
          this->Found.Connectivity[static_cast<std::size_t>(k)])];
        const bool starts = k == this->Found.Offsets[c];
        if (!starts && point != curve.Points.back())
        {
          this->Chords.push_back({ curve.Points.back(), point, this->TriangleOfSegment[segment],
            this->Traced.Curves.size() });
        }
        segment += starts ? 0 : 1;
        if (starts || point != curve.Points.back())
        {
          curve.Points.push_back(point);
        }
      }
      curve.Closed = curve.Points.size() > 3 && curve.Points.front() == curve.Points.back();
      const bool degenerate = curve.Points.size() < 2 ||
        (curve.Points.size() == 3 && curve.Points.front() == curve.Points.back());
      if (degenerate)
      {
        this->Chords.resize(firstChord);
        continue;
      }
      this->Traced.Curves.push_back(std::move(curve));
    }
  }

  /** From the middle of each chord to the curve. */
  void MeasureChords()
  {
    std::vector<double> errors(this->Chords.size(), 0.0);
    this->ForAll(this->Chords.size(), [&](std::size_t i, auto& near) {
      const Chord& chord = this->Chords[i];
      const Real3 middle =
        Scaled(PlusScaled(this->Traced.Points[static_cast<std::size_t>(chord.From)], 1.0,
                 this->Traced.Points[static_cast<std::size_t>(chord.To)]),
          0.5);
      const SeamTarget target = this->TargetFrom(middle, chord.Triangle, near);
      errors[i] = target.Reached ? Length(Difference(target.Place, middle)) : target.Residual;
    });
    for (std::size_t i = 0; i < errors.size(); ++i)
    {
      double& largest = this->Traced.Curves[this->Chords[i].Curve].ChordError;
      largest = std::max(largest, errors[i]);
      this->Traced.LargestChordError = std::max(this->Traced.LargestChordError, errors[i]);
    }
  }

  void CountEnds()
  {
    std::vector<std::int32_t> ends;
    for (const SeamCurve& curve : this->Traced.Curves)
    {
      if (curve.Points.front() != curve.Points.back())
      {
        ends.push_back(curve.Points.front());
        ends.push_back(curve.Points.back());
      }
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      const bool shared =
        (i > 0 && ends[i - 1] == ends[i]) || (i + 1 < ends.size() && ends[i + 1] == ends[i]);
      this->Traced.NumberOfEnds += shared ? 0 : 1;
    }
  }

  template <class Body>
  void ForAll(std::size_t count, const Body& body)
  {
    this->Threads.For(
      static_cast<std::int64_t>(count), Grain, [&](std::int64_t begin, std::int64_t end) {
        MovingLeastSquares::Neighbourhood near;
        for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end);
             ++i)
        {
          body(i, near);
        }
      });
  }

  struct Chord
  {
    std::int32_t From;
    std::int32_t To;
    std::int32_t Triangle;
    std::size_t Curve;
  };

  const Curves& Found;
  const CombinedMesh& Before;
  const SeamSnap& Snap;
  const SeamSnapRequest& Request;
  Executor& Threads;
  SeamCurves Traced;
  std::vector<std::int32_t> TriangleOfSegment;
  std::vector<std::int32_t> TriangleOfPoint; ///< as Found.Points, and so is the next
  std::vector<std::int32_t> Number; ///< in Traced.Points
  std::vector<std::int32_t> PointOfMesh; ///< as Traced.Points; -1 if the result does not use it
  std::vector<Chord> Chords;
};

} // namespace

SeamCurves TraceSeam(const Curves& curves, const CombinedMesh& before, const SeamSnap& snap,
  const SeamSnapRequest& request, Executor& executor)
{
  return Tracing(curves, before, snap, request, executor).Run();
}

} // namespace sb
