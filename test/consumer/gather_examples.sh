#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# gather_examples.sh <page.md> ... <output.cpp>: gathers the C++ examples of pages in one source file, each as the body
# of a function that has a cloud and its normals.
set -euo pipefail
output=${*: -1}
pages=("${@:1:$#-1}")
{
  printf '#include <pcl/point_types.h>\n#include <cstdint>\n#include <iostream>\n#include <vector>\n'
  # shellcheck disable=SC2016 # backticks are Markdown's
  sed -n '/^```cpp$/,/^```$/ { /^#include/p }' "${pages[@]}" | sort -u
  awk '
    /^```cpp$/ { inside = 1
      print "static void\nexample" ++count "(pcl::PointCloud<pcl::PointXYZ>::Ptr cloud, pcl::PointCloud<pcl::Normal>::Ptr normals)"
      print "{\n  static_cast<void>(normals);"; next }
    /^```$/ { if (inside) print "}"; inside = 0 }
    inside && !/^#include/ { print "  " $0 }
    END { if (count == 0) exit 1
      print "int\nmain()\n{"
      for (i = 1; i <= count; ++i) print "  static_cast<void>(&example" i ");"
      print "}" }' "${pages[@]}"
} > "$output"
