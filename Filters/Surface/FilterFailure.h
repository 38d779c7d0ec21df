// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FilterFailure.h
 * @brief What ends an update.
 */
#ifndef FilterFailure_h
#define FilterFailure_h

#include <string>

namespace sbvtk
{

/** Ends an update: why, as a number for scripts and as a sentence for users. */
struct FilterFailure
{
  int Status;
  std::string Sentence;
};

} // namespace sbvtk

#endif
