# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# cmake -DOUTPUT=page.cpp -P embed.cmake: puts style and scripts into page.html, and the page into a C++ source.
set(here ${CMAKE_CURRENT_LIST_DIR})
file(READ ${here}/page.html page)
file(READ ${here}/page.css style)
file(READ ${here}/vendor/three.min.js viewer)
set(script "")
foreach(part model plan tables space main self_test)
  file(READ ${here}/${part}.js text)
  string(APPEND script "${text}")
endforeach()
string(REPLACE "{{STYLE}}" "${style}" page "${page}")
string(REPLACE "{{VIEWER}}" "${viewer}" page "${page}")
string(REPLACE "{{SCRIPT}}" "${script}" page "${page}")
file(WRITE ${OUTPUT} "// Made by scene/report/embed.cmake\n#include \"report/report_page.h\"\n"
  "namespace pcl::indoor::tool {\nextern const char* const report_template;\n"
  "const char* const report_template = R\"page~(${page})page~\";\n} // namespace pcl::indoor::tool\n")
