// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "HelpPages.h"

#include <pqApplicationCore.h>

#include <QHelpEngine>

void registerHelpPages()
{
  auto* application = pqApplicationCore::instance();
  // With Qt 6 the engine does not take in what is registered unless it is told to, and set up anew;
  // with Qt 5 there is no such property.
  QHelpEngine* engine = application->helpEngine();
  engine->setProperty("readOnly", false);
  engine->setupData();
  application->registerDocumentation(":/SurfaceBooleans/SurfaceBooleans.qch");
}
