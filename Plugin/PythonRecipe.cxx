// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PythonRecipe.h"

#include <pqPVApplicationCore.h>
#include <pqPythonManager.h>

#include <vtkNew.h>
#include <vtkPVPluginTracker.h>
#include <vtkPythonInterpreter.h>
#include <vtkResourceFileLocator.h>

#include <QFileInfo>

#include <string>
#include <vector>

namespace
{
/**
 * The file that this code was loaded from.
 */
QString pluginFile()
{
  vtkPVPluginTracker* tracker = vtkPVPluginTracker::GetInstance();
  for (unsigned int k = 0; k < tracker->GetNumberOfPlugins(); ++k)
  {
    if (std::string(tracker->GetPluginName(k)) == "SurfaceBooleans")
    {
      return tracker->GetPluginFileName(k);
    }
  }
  return {};
}
}

void findPythonPackage()
{
  vtkNew<vtkResourceFileLocator> locator;
  const std::string folder = locator->Locate(QFileInfo(pluginFile()).absolutePath().toStdString(),
    std::vector<std::string>{ "python3/dist-packages" }, "surfacebooleans/__init__.py");
  if (!folder.empty())
  {
    vtkPythonInterpreter::PrependPythonPath(folder.c_str());
  }
}

void runRecipe(const QString& call)
{
  static const char* const code = "from importlib.util import find_spec\n"
                                  "if find_spec('surfacebooleans') is None:\n"
                                  "    from vtkmodules.vtkCommonCore import vtkOutputWindow\n"
                                  "    vtkOutputWindow.GetInstance().DisplayErrorText('The buttons "
                                  "of Surface Booleans need the Python package '\n"
                                  "        'surfacebooleans, which is not where Python looks: add "
                                  "its folder to PYTHONPATH and start ParaView again.\\n')\n"
                                  "else:\n"
                                  "    from surfacebooleans import gui\n"
                                  "    gui.%1\n";
  pqPVApplicationCore::instance()->pythonManager()->executeCode(QString(code).arg(call).toUtf8());
}
