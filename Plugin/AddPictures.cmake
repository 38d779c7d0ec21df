# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause

# Usage: cmake -Dpages=FOLDER -Dpictures=FOLDER -P AddPictures.cmake
# ParaView makes the pages that F1 opens of the XML, where an image cannot be named. Each page for which there is a picture
# of the same name gets it above its text.
file(GLOB files RELATIVE "${pictures}" "${pictures}/*.png")
foreach (file IN LISTS files)
  string(REGEX REPLACE "[.]png$" ".html" page "${pages}/${file}")
  if (EXISTS "${page}")
    file(READ "${page}" text)
    string(REPLACE "<div class=\"description\">" "<p><img src=\"${file}\"></p><div class=\"description\">" text "${text}")
    file(WRITE "${page}" "${text}")
  endif ()
endforeach ()
