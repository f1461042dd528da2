#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# distinct_names.sh SOURCE: with CMAKE_UNITY_BUILD, as in the demo, the sources of a folder are compiled as one. No two of
# them may have a constant, a structure or a class of one name in their unnamed namespaces.
set -euo pipefail
cd "$1"

find common features filters io ml model python scene segmentation simulation -path '*/src/*.cpp' | sort | xargs awk '
  FNR == 1 { inside = 0 }
  /^namespace \{/ { inside = 1 }
  /^\} \/\/ namespace$/ { inside = 0 }
  !inside { next }
  /^(struct|class|enum class|enum) [A-Za-z_]+/ { name = $1 == "enum" && $2 == "class" ? $3 : $2 }
  /^(constexpr|const) [^(]*=/ { name = $0; sub(/(\[.*)? *=.*/, "", name); sub(/.* /, "", name) }
  name != "" {
    sub(/[^A-Za-z_0-9].*/, "", name)
    folder = FILENAME; sub(/\/[^\/]*$/, "", folder)
    key = folder " " name
    if (key in file && file[key] != FILENAME) { print FILENAME " and " file[key] ": " name; found = 1 }
    file[key] = FILENAME; name = ""
  }
  END { if (length(file) < 100) { print "hardly a name was found: the check is broken"; found = 1 } exit found }'
