// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pqSurfaceBooleansToolBar.h"

#include "HelpPages.h"
#include "PythonRecipe.h"
#include "RecipeInputs.h"

#include <pqUndoStack.h>

#include <QAction>
#include <QCoreApplication>
#include <QIcon>
#include <QMainWindow>

namespace
{
/**
 * One button. As many sources as the recipe wants are selected, or the inputs of the filter are
 * asked for.
 */
struct Button
{
  const char* name; // of the action, for recorded clicks
  const char* text;
  const char* toolTip;
  const char* icon;
  const char* recipe; // a function of surfacebooleans.gui; %1 are its sources
  const char* filter;
  int least;
  int most;
};

constexpr int any = 1000000;

const Button buttons[] = {
  { "Union", "Union", "Unite the selected surfaces.", "Union", "boolean('Union', %1)",
    "SurfaceBoolean", 2, any },
  { "Intersection", "Intersection", "Keep what the first selected surface and the others share.",
    "Intersection", "boolean('Intersection', %1)", "SurfaceBoolean", 2, any },
  { "Difference", "Difference", "Take the other selected surfaces away from the first one.",
    "Difference", "boolean('Difference', %1)", "SurfaceBoolean", 2, any },
  { "SymmetricDifference", "Symmetric Difference",
    "Keep what is inside the first selected surface or the others, but not inside both.",
    "SymmetricDifference", "boolean('Symmetric Difference', %1)", "SurfaceBoolean", 2, any },
  { "Curves", "Curves", "Show the curves in which the two selected surfaces meet.",
    "SurfaceIntersection", "curves(%1)", "SurfaceIntersection", 2, 2 },
  { "DistanceMap", "Distance Map",
    "Colour the first selected source by its distance to the second one, with a histogram.",
    "DistanceMap", "distance_map(%1)", "SurfaceDistance", 2, 2 },
  { "Clip", "Clip", "Clip the selected closed surface by a plane that can be dragged.",
    "ClosedSurfaceClip", "clip(%1)", "ClosedSurfaceClip", 1, 1 },
  { "PointCloud", "Point Cloud",
    "Make the surface of the selected cloud of points, without the body that is selected after it.",
    "PointSetSurface", "point_cloud(%1)", "PointSetSurface", 1, 2 },
  { "Check", "Check", "Show what is wrong with the selected surface, and where.", "SurfaceCheck",
    "check(%1)", "SurfaceCheck", 1, 1 },
  { "ShowTool", "Show Tool",
    "Show the Tool of the selected filter, seen through, or hide it again.", "ShowTool",
    "show_tool()", nullptr, 0, any },
  { "Blocks", "Blocks",
    "Colour the selected result by the blocks that its parts come from, with their names.",
    "Blocks", "blocks()", nullptr, 0, any },
};

void run(const Button& button)
{
  const RecipeInputs inputs =
    button.filter ? selectedOrAsked(button.filter, button.least, button.most) : RecipeInputs();
  if (inputs.cancelled)
  {
    return;
  }
  // All of it is one step, with what the panel of the new filter sets when it is shown.
  BEGIN_UNDO_SET(button.text);
  runRecipe(QString(button.recipe).replace("%1", inputs.arguments));
  QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents);
  END_UNDO_SET();
}
}

pqSurfaceBooleansToolBar::pqSurfaceBooleansToolBar(QWidget* parent)
  : QToolBar("Surface Booleans", parent)
{
  this->setObjectName("SurfaceBooleans");
  if (auto* window = qobject_cast<QMainWindow*>(parent))
  {
    window->addToolBarBreak(); // beside ParaView's own toolbars most buttons would not be seen
  }
  findPythonPackage();
  registerHelpPages();
  bool makesFilters = true;
  for (const Button& button : buttons)
  {
    if (makesFilters && !button.filter)
    {
      this->addSeparator();
    }
    makesFilters = button.filter != nullptr;
    auto* action = this->addAction(
      QIcon(QString(":/SurfaceBooleans/Icons/%1.svg").arg(button.icon)), button.text);
    action->setObjectName(button.name);
    action->setToolTip(button.toolTip);
    action->setStatusTip(button.toolTip);
    QObject::connect(action, &QAction::triggered, this, [&button]() { run(button); });
  }
}
