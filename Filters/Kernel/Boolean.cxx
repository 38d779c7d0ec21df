// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Boolean.h"

#include "Arrangement.h"
#include "Classification.h"
#include "CurveJoining.h"
#include "Ingest.h"
#include "OutputAssembly.h"
#include "Scene.h"
#include "Stages.h"

#include <algorithm>

namespace sb
{

namespace
{

/** Runs the stages one after the other. */
class BooleanRun
{
public:
  BooleanRun(const BooleanRequest& request, SeamPoints seams, Executor& executor, Monitor& monitor)
    : Request(request)
    , Seams(seams)
    , Threads(executor)
    , Watch(monitor)
    , Clock(this->Result.Times, monitor)
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
      this->Clock.Timed("Check", 0.02, [&] { return Ingest(this->Request, this->Threads); });
    this->Result.Operands = ingested.Reports;
    this->Result.Remarks = ingested.Remarks;
    if (HasError(this->Result.Remarks))
    {
      return this->Finish();
    }
    const Scene scene = this->Clock.Timed(
      "Lattice", 0.1, [&] { return Scene(this->Request, ingested, this->Threads); });
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
    const std::vector<TrianglePair> pairs = this->Clock.Timed(
      "Near pairs", 0.15, [&] { return FindNearPairs(scene, self, this->Threads, this->Watch); });
    std::vector<std::uint8_t> collapsed;
    const ContactSet contacts = this->Clock.Timed("Contacts", 0.3,
      [&] { return FindStitchedContacts(scene, pairs, collapsed, this->Threads, this->Watch); });
    const Arrangement cuts = this->Clock.Timed("Cuts", 0.5, [&] {
      return MakeArrangement(scene, contacts, self, collapsed, this->Threads, this->Watch);
    });
    Classification classes = this->Clock.Timed("Winding numbers", 0.7, [&] {
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
    this->Clock.Timed("Output", 0.9, [&] {
      this->Result.Intersection = JoinCurves(scene, cuts);
      AssembleOutput(scene, cuts, std::move(classes), this->Seams, this->Result, this->Threads);
      return 0;
    });
    return true;
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
    this->Result.Condition = GravestCondition(this->Result.Remarks);
    this->Watch.Progress(1.0, "Done");
    return std::move(this->Result);
  }

  const BooleanRequest& Request;
  const SeamPoints Seams;
  Executor& Threads;
  Monitor& Watch;
  BooleanResult Result;
  StageClock Clock;
};

} // namespace

BooleanResult ComputeBoolean(
  const BooleanRequest& request, SeamPoints seams, Executor& executor, Monitor& monitor)
{
  return BooleanRun(request, seams, executor, monitor).Run();
}

} // namespace sb
