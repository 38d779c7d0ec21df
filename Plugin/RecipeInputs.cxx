// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RecipeInputs.h"

#include <pqActiveObjects.h>
#include <pqApplicationCore.h>
#include <pqChangeInputDialog.h>
#include <pqCoreUtilities.h>
#include <pqOutputPort.h>
#include <pqPipelineSource.h>
#include <pqServer.h>
#include <pqServerManagerModel.h>

#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMSessionProxyManager.h>

#include <QStringList>

namespace
{
QList<pqOutputPort*> selectedPorts()
{
  QList<pqOutputPort*> ports;
  for (pqServerManagerModelItem* item : pqActiveObjects::instance().selection())
  {
    if (auto* port = qobject_cast<pqOutputPort*>(item))
    {
      ports << port;
    }
    else if (auto* source = qobject_cast<pqPipelineSource*>(item))
    {
      ports << source->getOutputPort(0);
    }
  }
  return ports;
}

/**
 * As Python: a port is the id of its proxy, which is unique, as names are not, and its number.
 */
QString asArguments(const QList<pqOutputPort*>& inputs, const QList<pqOutputPort*>& tools)
{
  QStringList ports;
  for (pqOutputPort* port : inputs + tools)
  {
    ports << QString("(%1, %2)")
               .arg(port->getSource()->getProxy()->GetGlobalID())
               .arg(port->getPortNumber());
  }
  const QString sources = QString("sources=gui.chosen([%1])").arg(ports.join(", "));
  return inputs.size() > 1 ? sources + QString(", inputs=%1").arg(inputs.size()) : sources;
}

RecipeInputs asked(const char* filter, const QList<pqOutputPort*>& selected)
{
  vtkSMProxy* prototype =
    pqActiveObjects::instance().proxyManager()->GetPrototypeProxy("filters", filter);
  vtkSMPropertyHelper input(prototype, "Input");
  if (!selected.isEmpty()) // as the filter's menu entry has it, the first one is proposed
  {
    input.Set(selected[0]->getSource()->getProxy(), selected[0]->getPortNumber());
  }
  pqChangeInputDialog dialog(prototype, pqCoreUtilities::mainWidget());
  dialog.setObjectName("SelectInputDialog");
  const bool accepted = dialog.exec() == QDialog::Accepted;
  input.RemoveAllValues(); // the prototype is everybody's
  const auto& chosen = dialog.selectedInputs();
  return { !accepted, asArguments(chosen.value("Input"), chosen.value("Tool")) };
}
}

RecipeInputs selectedOrAsked(const char* filter, int least, int most)
{
  const QList<pqOutputPort*> selected = selectedPorts();
  const auto* model = pqApplicationCore::instance()->getServerManagerModel();
  const bool somethingThere = !model->findItems<pqPipelineSource*>().isEmpty();
  if (somethingThere && (selected.size() < least || selected.size() > most))
  {
    return asked(filter, selected);
  }
  return {};
}
