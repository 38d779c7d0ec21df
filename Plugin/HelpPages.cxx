// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "HelpPages.h"

#include <pqApplicationCore.h>

#include <QHelpEngine>

void registerHelpPages()
{
  auto* application = pqApplicationCore::instance();
  // With Qt 6 it does not take in what is registered, unless it is told to; with Qt 5 there is no
  // such property.
  application->helpEngine()->setProperty("readOnly", false);
  application->registerDocumentation(":/SurfaceBooleans/SurfaceBooleans.qch");
}
