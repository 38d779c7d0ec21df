// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file pqSurfaceBooleansToolBar.h
 * @brief The toolbar of ParaView's window whose buttons run the recipes of the Python package.
 *
 * What a button does stands in surfacebooleans.gui, so that macros, scripts and traces do the same.
 * Here is only what needs Qt: icons, and the dialog that asks for the inputs where the selection
 * does not tell them.
 */
#ifndef pqSurfaceBooleansToolBar_h
#define pqSurfaceBooleansToolBar_h

#include <QToolBar>

class pqSurfaceBooleansToolBar : public QToolBar
{
  Q_OBJECT

public:
  explicit pqSurfaceBooleansToolBar(QWidget* parent = nullptr);
};

#endif
