// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SampleWidths.h
 * @brief How wide the weights of a cloud's samples are: 3.15 spacings, more where the cloud is
 * sparse, and less where a wall is thin.
 *
 * One width for all does for scans of about one density. Where the spacing varies more than chance
 * makes it vary, samples in sparse parts take 3.15 of their own spacings; else they would lose
 * their neighbours, and the surface would break up. What is dense keeps the common width: it may be
 * several scans on top of each other. Weights for the area of a sample do harm: the few wide
 * samples beside a dense part then pull it to their side.
 *
 * Sheets of a wall, or of a gap, that is thinner than the width run into each other: measured on
 * concentric spheres, they are off by 0.03 spacings where the width is the thickness, and cease to
 * be two at 0.8 of it. Where samples that face the other way lie opposite and nearer, the width is
 * their distance, but at least two spacings, without which there are too few neighbours. What is
 * thinner than that, or than a width that was asked for, is reported.
 */
#ifndef sb_SampleWidths_h
#define sb_SampleWidths_h

#include "PointTree.h"

#include <vector>

namespace sb
{

/** The width, where the cloud is as dense as mostly: more noise is averaged than with three, and
 * still a wall of four spacings is left as it is. */
constexpr double WidthInSpacings = 3.15;

struct SampleWidths
{
  double Typical = 0.0;
  std::vector<double>
    Widths; ///< of each sample in the order of the tree; empty if all are the same
  double ThinShare = 0.0; ///< of the samples, on walls thinner than their width
  double ThinWall = 0.0; ///< the median thickness of those walls
};

/**
 * @param normals unit vectors, three doubles for each point of the tree's input
 * @param spacing of the tree. @param width that was asked for; 0 if none was, and then `each` says
 * whether samples may have their own.
 */
SampleWidths WidthsOfSamples(const PointTree& tree, const double* normals, double spacing,
  double width, bool each, Executor& executor);

} // namespace sb

#endif
