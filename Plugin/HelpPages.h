// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HelpPages.h
 * @brief Lets F1 find the pages of these filters, which help_pages.py has made and this plugin
 * holds.
 *
 * ParaView registers the pages that it makes of a plugin's XML by itself, but makes none with Qt 6.
 */
#ifndef HelpPages_h
#define HelpPages_h

/**
 * To be called once, when there is a window.
 */
void registerHelpPages();

#endif
