// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Intersection.h"

#include "Arrangement.h"
#include "ContactCurves.h"
#include "CurveJoining.h"
#include "Ingest.h"
#include "Stages.h"
#include "SurfacePatches.h"

#include <algorithm>
#include <iterator>

namespace sb
{

namespace
{

/** Whether a remark matters where no surface needs an inside. */
bool Concerns(const Remark& remark)
{
  return remark.Condition != Status::OpenOperand && remark.Condition != Status::InsideOut &&
    remark.Condition != Status::InconsistentOrientation;
}

class IntersectionRun
{
public:
  IntersectionRun(const IntersectionRequest& request, Executor& executor, Monitor& monitor)
    : Request(request)
    , Threads(executor)
    , Watch(monitor)
    , Clock(this->Result.Times, monitor)
  {
    this->Surfaces.Operands = request.Operands;
  }

  IntersectionResult Run()
  {
    const std::size_t operands = this->Request.Operands.size();
    if (operands == 0 || this->Request.Split.size() != operands)
    {
      this->AddRemark(Status::BadRequest);
      return this->Finish();
    }
    Ingested ingested = this->Clock.Timed("Check", 0.02, [&] {
      for (Operand& operand : this->Surfaces.Operands)
      {
        if (!operand.Known)
        {
          operand.Known = Examine(operand.Mesh, this->Threads, OpenSurfaces::Accept);
        }
      }
      return Ingest(this->Surfaces, this->Threads);
    });
    this->Result.Operands = ingested.Reports;
    std::copy_if(ingested.Remarks.begin(), ingested.Remarks.end(),
      std::back_inserter(this->Result.Remarks), Concerns);
    if (HasError(this->Result.Remarks))
    {
      return this->Finish();
    }
    ingested.Swapped.assign(operands, 0); // pieces keep the orientation that they came with
    const Scene scene = this->Clock.Timed(
      "Lattice", 0.1, [&] { return Scene(this->Surfaces, ingested, this->Threads); });
    std::vector<std::uint8_t> self(operands, operands == 1);
    // Faces of one operand that cross each other on another one's face have to be cut against each
    // other, or their curves would cross without a common point.
    while (!this->Attempt(scene, self) && !this->Watch.Aborted())
    {
    }
    return this->Finish();
  }

private:
  /** @return whether the result is final; else `self` has grown. */
  bool Attempt(const Scene& scene, std::vector<std::uint8_t>& self)
  {
    const std::vector<TrianglePair> pairs = this->Clock.Timed(
      "Near pairs", 0.15, [&] { return FindNearPairs(scene, self, this->Threads, this->Watch); });
    std::vector<std::uint8_t> collapsed;
    const ContactSet contacts = this->Clock.Timed("Contacts", 0.3,
      [&] { return FindStitchedContacts(scene, pairs, collapsed, this->Threads, this->Watch); });
    this->Result.NumberOfContacts = contacts.NumberOfPairs;
    if (collapsed.empty() && !IsAny(self) && !IsAny(this->Request.Split) &&
      this->FindCurvesWithoutCuts(scene, contacts))
    {
      return true;
    }
    // Untouched faces do not matter, nor do those of an operand that is cut against itself.
    const std::vector<std::uint8_t> none(self.size(), 0);
    const Arrangement cuts = this->Clock.Timed("Cuts", 0.5, [&] {
      return MakeArrangement(scene, contacts, none, collapsed, this->Threads, this->Watch);
    });
    if (this->Watch.Aborted())
    {
      return true;
    }
    if (Grow(self, cuts.SelfIntersecting))
    {
      return false;
    }
    this->Clock.Timed("Output", 0.8, [&] {
      const std::vector<CurveSegment> segments =
        FindCurveSegments(scene, cuts, self.size() == 1 ? CurveKind::All : CurveKind::Mutual);
      this->Result.Intersection = JoinSegments(scene, cuts.Nodes, segments);
      this->Result.Surfaces.resize(self.size());
      for (std::size_t i = 0; i < self.size(); ++i)
      {
        if (this->Request.Split[i])
        {
          this->Result.Surfaces[i] = SplitAlongCurves(
            scene, cuts, segments, collapsed, static_cast<std::int32_t>(i), this->Threads);
        }
      }
      return 0;
    });
    return true;
  }

  /** @return whether that was possible. */
  bool FindCurvesWithoutCuts(const Scene& scene, const ContactSet& contacts)
  {
    return this->Clock.Timed("Cuts", 0.5, [&] {
      PointTable nodes;
      const auto segments = FindSegmentsOfContacts(scene, contacts, nodes, this->Threads);
      if (segments)
      {
        this->Result.Intersection = JoinSegments(scene, nodes, *segments);
        this->Result.Surfaces.resize(this->Request.Operands.size());
      }
      return segments.has_value();
    });
  }

  static bool IsAny(const std::vector<std::uint8_t>& flags)
  {
    return std::find(flags.begin(), flags.end(), 1) != flags.end();
  }

  static bool Grow(std::vector<std::uint8_t>& self, const std::vector<std::uint8_t>& found)
  {
    bool grown = false;
    for (std::size_t i = 0; i < self.size(); ++i)
    {
      grown = grown || (found[i] && !self[i]);
      self[i] = self[i] || found[i];
    }
    return grown;
  }

  Remark& AddRemark(Status condition)
  {
    this->Result.Remarks.emplace_back();
    this->Result.Remarks.back().Condition = condition;
    return this->Result.Remarks.back();
  }

  IntersectionResult Finish()
  {
    if (this->Watch.Aborted())
    {
      IntersectionResult empty;
      empty.Operands = std::move(this->Result.Operands);
      empty.Remarks = std::move(this->Result.Remarks);
      this->Result = std::move(empty);
      this->AddRemark(Status::Aborted);
    }
    this->Result.Condition = GravestCondition(this->Result.Remarks);
    this->Watch.Progress(1.0, "Done");
    return std::move(this->Result);
  }

  const IntersectionRequest& Request;
  BooleanRequest Surfaces; ///< what the stages in common look at
  Executor& Threads;
  Monitor& Watch;
  IntersectionResult Result;
  StageClock Clock;
};

} // namespace

IntersectionResult ComputeIntersection(
  const IntersectionRequest& request, Executor& executor, Monitor& monitor)
{
  return IntersectionRun(request, executor, monitor).Run();
}

} // namespace sb
