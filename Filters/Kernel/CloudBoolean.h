// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloudBoolean.h
 * @brief Boolean operations of the solid that a scanned cloud encloses with a designed body.
 *
 * After P. Yang, X. Qian: "Direct Boolean intersection between acquired and designed geometry",
 * Computer-Aided Design, 2009, section 1, with a mesh for the result, so that it can be printed.
 * The cloud's surface is meshed, the body is refined near it, the exact Boolean of Boolean.h joins
 * the two, and the seam, which is then off by the chords of both, is moved onto the surfaces
 * themselves.
 */
#ifndef sb_CloudBoolean_h
#define sb_CloudBoolean_h

#include "CloudSurface.h"
#include "CombinedMesh.h"
#include "DesignedSurface.h"
#include "PointSurfaceMesh.h"
#include "SeamCurves.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace sb
{

enum class CloudOperation : std::uint8_t
{
  Union,
  Intersection,
  Difference, ///< the cloud without the tool
  ReverseDifference ///< the tool without the cloud
};

struct CloudBooleanRequest
{
  const CloudSurface* Cloud = nullptr; ///< has to be Ok
  const DesignedSurface* Tool = nullptr; ///< its ids and coordinates have to be valid
  CloudOperation Op = CloudOperation::Union;
  double Cell = 0.0; ///< edge of the cloud's mesh; 0: two spacings
  /** The cloud's mesh with such cells, as an earlier call gave it; null to make it. */
  std::shared_ptr<const PointSurfaceMesh> CloudMesh;
  bool WithNearestSamples = false; ///< fill in NearestSample
};

enum class CloudBooleanStatus : std::uint8_t
{
  Ok,
  OpenTool,
  BadTool, ///< Tool says what is wrong
  NoSurface, ///< the cloud's surface has no triangle
  InsideOut, ///< the cloud's normals point inwards, or some do
  TooFine,
  TooLarge,
  Aborted
};

/** What is known of the error of the result, as lengths. */
struct ErrorBudget
{
  double Noise =
    0.0; ///< of the cloud's surface: sigma s / (h sqrt(2 pi)), sigma from the residuals
  double Facet =
    0.0; ///< how far the middles of the cloud's triangles are from its surface, at most
  double Chord = 0.0; ///< of the seam, measured
  double Tool = 0.0; ///< how far the middles of the tool's facets are from their patches, at most
  double Seam =
    0.0; ///< how far seam vertices that had to stay are from the cloud's surface, at most
  double Sum() const { return this->Noise + this->Facet + this->Chord + this->Tool + this->Seam; }
};

struct CloudBooleanResult
{
  CloudBooleanStatus Status = CloudBooleanStatus::Ok;
  std::vector<Remark> ToolRemarks; ///< the kernel's, on the tool

  /** Operand 0 is the cloud, 1 the tool. Closed by point ids; but where the tool has patches each
   * of its faces, and the cloud, have points of their own, as each has its own u and v. */
  CombinedMesh Mesh;
  std::vector<std::uint8_t> Sides; ///< of each point: 1 of the cloud, 2 of the tool, 3 on the seam
  std::vector<double> Normals; ///< of each point, as the result shows them
  std::vector<double>
    Residuals; ///< of each point: distance from the cloud's surface; NaN on the tool
  std::vector<double> UV; ///< of each point, two; NaN on the cloud. Empty without patches
  /** Of each point that the cloud has, the nearest sample's number in the input; else -1. */
  std::vector<std::int32_t> NearestSample;
  std::vector<std::int32_t> ToolTriangle; ///< of each triangle: the tool's as it was given, or -1
  std::vector<std::int32_t> FaceId; ///< of each triangle, or -1. Empty without patches
  std::shared_ptr<const PointSurfaceMesh> CloudMesh; ///< for the next call
  SeamCurves Seam;
  std::vector<std::array<double, 2>> SeamUV; ///< of its points; empty without patches
  std::vector<std::int32_t> SeamSample; ///< of its points, the nearest sample; as NearestSample
  std::vector<std::uint8_t> KeptSamples; ///< of each sample, in the order of the cloud's tree

  bool ScanIsOpen = false;
  double Confidence = 1.0;
  std::int64_t NumberOfBorderEdges = 0; ///< of the result
  std::int64_t NumberOfSpecks = 0; ///< parts of the cloud's mesh that were too small, and left out
  std::int64_t NumberOfSnapped = 0;
  std::int64_t NumberOfBackedOff = 0;
  std::int64_t NumberOfFlipped = 0; ///< triangles that face away from their surface
  std::int64_t NumberOfCrossings = 0;
  double LargestResidual = 0.0; ///< of the seam
  double TangentShare = 0.0; ///< of the seam's vertices: where the surfaces hardly cross
  double CloudVolume = 0.0; ///< signed; without meaning for an open scan
  double ToolVolume = 0.0;
  double Volume = 0.0; ///< of the result; without meaning if it is open
  double Area = 0.0;
  ErrorBudget Errors;
  std::vector<StageTime> Times;
};

CloudBooleanResult ComputeCloudBoolean(
  const CloudBooleanRequest& request, Executor& executor, Monitor& monitor);

} // namespace sb

#endif
