#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# refuse_native.sh <cmake> <source folder>: flags that break Eigen's alignment are refused, with the reason.
set -euo pipefail
cmake=$1 source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for flag in -march=native -mavx2 -march=haswell; do
  if "$cmake" -S "$source" -B "$folder/build" -Wno-dev -DCMAKE_CXX_FLAGS="-O2 $flag" > "$folder/log" 2>&1; then
    echo "Configuring with $flag is accepted"
    exit 1
  fi
  if ! tr -s '\n ' ' ' < "$folder/log" | grep -qe "\(contain $flag\|turn on AVX\).*alignment.*packaged PCL"; then
    echo "The reason for refusing $flag is missing:"
    cat "$folder/log"
    exit 1
  fi
  rm -rf "$folder/build"
done
