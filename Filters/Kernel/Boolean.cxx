// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Boolean.h"

#include "Arrangement.h"
#include "BroadPhase.h"
#include "Classification.h"
#include "CollapsedFaces.h"
#include "Contacts.h"
#include "CurveJoining.h"
#include "Ingest.h"
#include "OutputAssembly.h"
#include "Scene.h"

#include <algorithm>
#include <chrono>

namespace sb
{

namespace
{

/** Runs the stages one after the other, with the time of each. */
class BooleanRun
{
  template <class Stage>
  auto Timed(const char* name, double progress, Stage&& stage)
  {
    this->Watch.Progress(progress, name);
    const auto start = std::chrono::steady_clock::now();
    auto result = stage();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    const auto known = std::find_if(this->Result.Times.begin(), this->Result.Times.end(),
      [&](const StageTime& time) { return std::string(time.Name) == name; });
    if (known != this->Result.Times.end())
    {
      known->Seconds += elapsed.count();
    }
    else
    {
      this->Result.Times.push_back({ name, elapsed.count() });
    }
    return result;
  }

public:
  BooleanRun(const BooleanRequest& request, SeamPoints seams, Executor& executor, Monitor& monitor)
    : Request(request)
    , Seams(seams)
    , Threads(executor)
    , Watch(monitor)
  {
  }

  BooleanResult Run()
  {
    if (this->Request.Operands.empty())
    {
      this->AddRemark(Status::BadRequest);
      return this->Finish();
    }
    Ingested ingested =
      this->Timed("Check", 0.02, [&] { return Ingest(this->Request, this->Threads); });
    this->Result.Operands = ingested.Reports;
    this->Result.Remarks = ingested.Remarks;
    if (this->HasError())
    {
      return this->Finish();
    }
    const Scene scene =
      this->Timed("Lattice", 0.1, [&] { return Scene(this->Request, ingested, this->Threads); });
    std::vector<std::uint8_t> self(this->Request.Operands.size(), 0);
    if (this->Request.Op == Operation::Resolve)
    {
      for (std::size_t i = 0; i < self.size(); ++i)
      {
        self[i] = !ingested.Open[i];
      }
    }
    // Operands that turn out to overlap themselves where it matters are cut against themselves in
    // another round.
    while (!this->Attempt(scene, ingested, self) && !this->Watch.Aborted())
    {
    }
    return this->Finish();
  }

private:
  /** @return whether the result is final; else `self` has grown. */
  bool Attempt(const Scene& scene, const Ingested& ingested, std::vector<std::uint8_t>& self)
  {
    const std::vector<TrianglePair> pairs =
      this->Timed("Near pairs", 0.15, [&] { return this->FindPairs(scene, self); });
    ContactSet contacts;
    std::vector<std::uint8_t> collapsed;
    this->Timed("Contacts", 0.3, [&] {
      collapsed = FindCollapsedFaces(scene, pairs);
      contacts = FindContacts(scene, pairs, collapsed, this->Threads, this->Watch);
      StitchCollapsedFaces(scene, collapsed, contacts);
      return 0;
    });
    const Arrangement cuts = this->Timed("Cuts", 0.5, [&] {
      return MakeArrangement(scene, contacts, self, collapsed, this->Threads, this->Watch);
    });
    Classification classes = this->Timed("Winding numbers", 0.7, [&] {
      return Classify(
        { scene, cuts, this->Request.Op, self, ingested.Open, ingested.Rims, collapsed },
        this->Threads, this->Watch);
    });
    if (this->Watch.Aborted())
    {
      return true;
    }
    if (this->GrowSelf(classes.SelfIntersecting, ingested.Open, self))
    {
      return false;
    }
    for (std::size_t i = 0; i < classes.NonSeparating.size(); ++i)
    {
      if (classes.NonSeparating[i])
      {
        this->AddRemark(Status::NonSeparatingSheet).Operand = static_cast<std::int32_t>(i);
      }
    }
    this->Result.NumberOfContacts = contacts.NumberOfPairs;
    this->Timed("Output", 0.9, [&] {
      this->Result.Intersection = JoinCurves(scene, cuts);
      AssembleOutput(scene, cuts, std::move(classes), this->Seams, this->Result, this->Threads);
      return 0;
    });
    return true;
  }

  std::vector<TrianglePair> FindPairs(const Scene& scene, const std::vector<std::uint8_t>& self)
  {
    std::vector<BroadPhaseSurface> surfaces;
    for (std::int32_t i = 0; i < scene.NumberOfOperands(); ++i)
    {
      surfaces.push_back({ scene.NumberOfVertices() > 0
          ? scene.Position(0) + 3 * std::ptrdiff_t(scene.FirstVertex(i))
          : nullptr,
        scene.Mesh(i).Triangles, scene.Mesh(i).NumberOfTriangles, scene.Bounds(i),
        self[std::size_t(i)] != 0, &scene.Blocks(i) });
    }
    return FindOverlappingPairs(surfaces, this->Threads, this->Watch);
  }

  static bool GrowSelf(const std::vector<std::uint8_t>& found,
    const std::vector<std::uint8_t>& open, std::vector<std::uint8_t>& self)
  {
    bool grown = false;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      if (found[i] && !open[i] && !self[i])
      {
        self[i] = 1;
        grown = true;
      }
    }
    return grown;
  }

  Remark& AddRemark(Status condition)
  {
    this->Result.Remarks.emplace_back();
    this->Result.Remarks.back().Condition = condition;
    return this->Result.Remarks.back();
  }

  bool HasError() const
  {
    return std::any_of(this->Result.Remarks.begin(), this->Result.Remarks.end(),
      [](const Remark& remark) { return IsError(remark.Condition); });
  }

  BooleanResult Finish()
  {
    if (this->Watch.Aborted())
    {
      BooleanResult empty;
      empty.Operands = std::move(this->Result.Operands);
      empty.Remarks = std::move(this->Result.Remarks);
      this->Result = std::move(empty);
      this->AddRemark(Status::Aborted);
    }
    for (const Remark& remark : this->Result.Remarks)
    {
      this->Result.Condition = std::max(this->Result.Condition, remark.Condition);
    }
    this->Watch.Progress(1.0, "Done");
    return std::move(this->Result);
  }

  const BooleanRequest& Request;
  const SeamPoints Seams;
  Executor& Threads;
  Monitor& Watch;
  BooleanResult Result;
};

} // namespace

BooleanResult ComputeBoolean(
  const BooleanRequest& request, SeamPoints seams, Executor& executor, Monitor& monitor)
{
  return BooleanRun(request, seams, executor, monitor).Run();
}

} // namespace sb
