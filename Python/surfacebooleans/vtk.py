# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""All VTK classes of SurfaceBooleans: ``from surfacebooleans.vtk import vtkPolyDataBooleanOperationFilter``."""

from importlib import import_module as _import_module
from pkgutil import iter_modules as _iter_modules

from surfacebooleans import modules as _modules

__all__ = []
for _entry in _iter_modules(_modules.__path__):
    _module = _import_module(f"{_modules.__name__}.{_entry.name}")
    for _name, _class in vars(_module).items():
        if isinstance(_class, type) and _class.__module__ == _module.__name__:
            globals()[_name] = _class
            __all__.append(_name)
