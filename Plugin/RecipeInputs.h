// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RecipeInputs.h
 * @brief What a recipe works on: the sources that are selected in the Pipeline Browser, or else
 * those that the user chooses in the dialog which ParaView shows for a filter of several inputs.
 */
#ifndef RecipeInputs_h
#define RecipeInputs_h

#include <QString>

struct RecipeInputs
{
  bool cancelled = false;
  QString arguments; // Python, for a function of surfacebooleans.gui; empty: it takes the selected
                     // sources
};

/**
 * No dialog if at least `least` and at most `most` sources are selected, or there is nothing to
 * choose from.
 */
RecipeInputs selectedOrAsked(const char* filter, int least, int most);

#endif
