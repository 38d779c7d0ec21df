// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PythonRecipe.h
 * @brief Runs a recipe of surfacebooleans.gui, and lets Python find that package where the plugin
 * was built or installed.
 */
#ifndef PythonRecipe_h
#define PythonRecipe_h

#include <QString>

/**
 * Put the package that belongs to this plugin first on Python's path, for macros and the Python
 * Shell, too. It lies in python3/dist-packages beside one of the folders that the plugin is in;
 * nothing happens if it does not.
 */
void findPythonPackage();

/**
 * Call a function of surfacebooleans.gui. If there is no such package, the Output Messages say so.
 */
void runRecipe(const QString& call);

#endif
