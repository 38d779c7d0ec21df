// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceConnections.h
 * @brief The surfaces that a filter's connections deliver, kept from one update to the next: what
 * is made of one of them is made again only when that one has changed.
 */
#ifndef SurfaceConnections_h
#define SurfaceConnections_h

#include "AttributeUnion.h"
#include "Boolean.h"
#include "FilterFailure.h"
#include "OperandSurface.h"
#include "SurfaceInput.h"
#include "sbSurfaceModule.h" // for the export macro

#include <memory>
#include <string>
#include <vector>

class vtkInformationVector;

namespace sbvtk
{

/** A condition of the kernel that ends an update. */
SBSURFACE_EXPORT FilterFailure FailureOf(sb::Status condition, const std::string& name = "Input");

/** One connection of a port, and what is known of it from the last update. */
struct SurfaceConnection
{
  std::string Name; ///< for sentences: "Input", "Tool 2"
  sb::Group Side = sb::Group::Input;
  SurfaceInput Input;
  std::shared_ptr<OperandSurface> Surface;
};

using SurfaceConnections = std::vector<SurfaceConnection>;

/** List the connections of the ports Input (0) and Tool (1); those of the last update serve again.
 */
void MatchConnections(SurfaceConnections& connections, vtkInformationVector** inputs);

/**
 * Read what the connections deliver now.
 * @param notASurface the Status of a connection that delivers no surface
 * @param tolerance how far points may be moved (SnappedPoints.h)
 * @throw FilterFailure
 */
void ReadConnections(SurfaceConnections& connections, vtkInformationVector** inputs,
  int notASurface, double tolerance, sb::Executor& executor);

std::vector<std::shared_ptr<OperandSurface>> SurfacesOf(const SurfaceConnections& connections);

/** The names of all connections' blocks, in the order of their numbers. */
BlockNames BlockNamesOf(const SurfaceConnections& connections);

/** The point or cell arrays of one connection, for an AttributeUnion. */
AttributeUnion::Source AttributesOf(const SurfaceConnection& connection, bool ofPoints);

/** A remark as a sentence with the connection's name and cell. */
std::string RemarkSentence(const sb::Remark& remark, const SurfaceConnections& connections);

/** Add the kernel's times to `all`; examinations made before it was called belong to its first
 * stage. */
void AppendTimes(const std::vector<sb::StageTime>& ofKernel, double secondsOfExaminations,
  std::vector<sb::StageTime>& all);

/** Whether all points are floats. */
bool HaveFloatPoints(const SurfaceConnections& connections);

} // namespace sbvtk

#endif
