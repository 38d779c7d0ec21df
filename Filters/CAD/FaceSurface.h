// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FaceSurface.h
 * @brief The surface of one face of a shape as a patch, and back.
 *
 * Planes, cylinders, cones, spheres, tori and all other surfaces that a rational B-spline can be
 * are converted without error; offset surfaces cannot be, and are approximated.
 */
#ifndef FaceSurface_h
#define FaceSurface_h

#include "NURBSSurface.h"

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Face.hxx>

namespace sbvtk
{

struct FaceSurface
{
  sb::NURBSSurface Patch; ///< Du x Dv points to where the forward face's normal points
  bool IsExact = true;
  double PeriodU = 0.0; ///< of the face's own parameters; 0: none
  double PeriodV = 0.0;

  /** A parameter of the face, by whole periods taken to where the patch has it. It is the patch's
   * own parameter, or near it on surfaces with circles. */
  void Near(double& u, double& v) const;
};

/** A rectangle of parameters. */
struct ParameterBox
{
  double FirstU = 0.0;
  double LastU = 0.0;
  double FirstV = 0.0;
  double LastV = 0.0;

  void Add(double u, double v);
};

/** @param used what of the face's parameters is needed; unbounded surfaces are cut off there. */
FaceSurface MakeFaceSurface(const TopoDS_Face& face, const ParameterBox& used);

Handle(Geom_BSplineSurface) MakeBSpline(const sb::NURBSSurface& patch);

} // namespace sbvtk

#endif
