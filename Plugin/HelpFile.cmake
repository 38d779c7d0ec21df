# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause

# The help of the filters: pages from XML/ and Help/, packed for Qt's help, as a source file of the plugin (`help_source`).
# ParaView can do the first step with Qt 5 only.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(pages "${CMAKE_CURRENT_BINARY_DIR}/paraview_help")
file(GLOB pictures CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/Help/*.png")
add_custom_command(OUTPUT "${pages}/index.html"
  COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/help_pages.py"
    "${pages}" "${CMAKE_CURRENT_SOURCE_DIR}/Help" ${xml_files}
  DEPENDS help_pages.py ${xml_files} ${pictures}
  COMMENT "Writing the pages of the help")
# The namespace is the host of the pages' addresses, which Qt 6 looks up in small letters.
paraview_client_generate_help(
  NAME SurfaceBooleans
  TARGET SurfaceBooleans_qch
  NAMESPACE surfacebooleans.org
  FOLDER surfacebooleans
  OUTPUT_DIR "${pages}"
  OUTPUT_PATH help_file
  PATTERNS "*.html" "*.png"
  DEPENDS "${pages}/index.html")
configure_file(SurfaceBooleansHelp.qrc.in SurfaceBooleansHelp.qrc @ONLY)
set(help_source "${CMAKE_CURRENT_BINARY_DIR}/SurfaceBooleansHelp.cpp")
add_custom_command(OUTPUT "${help_source}"
  COMMAND "Qt${qt_version}::rcc" --name SurfaceBooleansHelp --output "${help_source}"
    "${CMAKE_CURRENT_BINARY_DIR}/SurfaceBooleansHelp.qrc"
  DEPENDS "${help_file}" "${CMAKE_CURRENT_BINARY_DIR}/SurfaceBooleansHelp.qrc"
  COMMENT "Packing the help")
set_source_files_properties("${help_source}" PROPERTIES SKIP_AUTOGEN ON)
