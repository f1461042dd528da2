#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# distinct_names.sh SOURCE: with CMAKE_UNITY_BUILD, as in the demo, the sources of a folder are compiled as one, and so are its
# tests. No two of them may have a constant, a structure or a class of one name in their unnamed namespaces, nor a function
# with the same parameters, nor different types of one name.
set -euo pipefail
cd "$1"

{
  find common features filters io ml model python scene segmentation simulation -path '*/src/*.cpp'
  # Those of test/tools and test/experiments are programs of their own
  find test -name 'test_*.cpp' ! -regex 'test/\(tools\|experiments\)/[^/]*'
} | sort | xargs awk '
  FNR == 1 { inside = 0 }
  /^namespace \{/ { inside = 1 }
  /^\} \/\/ namespace$/ { inside = 0 }
  !inside { next }
  /^(struct|class|enum class|enum) [A-Za-z_]+/ { name = $1 == "enum" && $2 == "class" ? $3 : $2 }
  /^(constexpr|const) [^(]*[=({]/ { name = $0; sub(/ *[[({=].*/, "", name); sub(/.* /, "", name) }
  name != "" { sub(/[^A-Za-z_0-9].*/, "", name) }
  /^[a-z][A-Za-z0-9]*\(.*\)( \{.*)?$/ { name = $0; sub(/\).*/, ")", name) }
  /^using [A-Za-z]+ = / { name = $2; same = $0 }
  name != "" {
    folder = FILENAME; sub(/\/[^\/]*$/, "", folder)
    key = folder " " name
    if (key in file && file[key] != FILENAME && (same == "" || same != text[key])) {
      print FILENAME " and " file[key] ": " name; found = 1
    }
    file[key] = FILENAME; text[key] = same; name = same = ""
  }
  END { if (length(file) < 100) { print "hardly a name was found: the check is broken"; found = 1 } exit found }'
