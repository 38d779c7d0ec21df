// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "HelpPages.h"

#include <pqApplicationCore.h>

void registerHelpPages()
{
  pqApplicationCore::instance()->registerDocumentation(":/SurfaceBooleans/SurfaceBooleans.qch");
}
