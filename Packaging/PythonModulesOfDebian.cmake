# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause

# To be included before find_package(ParaView), for the packages of Debian 13. Its paraview-dev lists Python's modules as
# x.so, its python3-paraview has them as x.cpython-313-x86_64-linux-gnu.so, and CMake refuses ParaView, as files that it
# lists are missing. Nothing of ours links these modules, so they need not be there: CMake does not look for the file of a
# target that has its .xcframework. Does nothing where no file is missing.
foreach (sb_folder IN ITEMS "${ParaView_DIR}" "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/paraview-5.13")
  file(GLOB sb_lists "${sb_folder}/*Python*-targets-*.cmake" "${sb_folder}/vtk/*Python*-targets-*.cmake")
  foreach (sb_list IN LISTS sb_lists)
    file(STRINGS "${sb_list}" sb_lines REGEX "_cmake_import_check_files_for_.*dist-packages/.*[.]so\"")
    foreach (sb_line IN LISTS sb_lines)
      string(REGEX REPLACE ".*_cmake_import_check_files_for_([^ ]+) .*" "\\1" sb_target "${sb_line}")
      string(REGEX REPLACE ".*(/lib/[^\"]+)\".*" "/usr\\1" sb_file "${sb_line}")
      if (NOT EXISTS "${sb_file}")
        set("_cmake_import_check_xcframework_for_${sb_target}" "${CMAKE_CURRENT_LIST_DIR}")
      endif ()
    endforeach ()
  endforeach ()
endforeach ()
