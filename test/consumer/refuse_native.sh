#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# refuse_native.sh <cmake> <source folder>: flags that align memory otherwise than PCL does are refused, with the reason.
set -euo pipefail
cmake=$1 source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
says_why() { # <flag>
  tr -s '\n ' ' ' < "$folder/log" | grep -qe "\(contain $1\|turn on AVX\).*alignment.*packaged PCL" ||
    { echo "The reason for refusing $1 is missing:"; cat "$folder/log"; exit 1; }
}
if "$cmake" -S "$source" -B "$folder/build" -Wno-dev -DCMAKE_CXX_FLAGS="-O2 -march=native" > "$folder/log" 2>&1; then
  echo "Configuring with -march=native is accepted"
  exit 1
fi
says_why -march=native

# a PCL that was built with AVX, as its header says from 1.15 on, asks for that flag
mkdir -p "$folder/project" "$folder/include/pcl"
cat > "$folder/project/CMakeLists.txt" << END
cmake_minimum_required(VERSION 3.18)
project(alignment VERSION 1.0 LANGUAGES CXX)
list(APPEND CMAKE_MODULE_PATH "$source/cmake")
include(PclAddon)
set(PCL_INCLUDE_DIRS "$folder/include")
pcl_addon_refuse_other_alignment()
END
# configures <0|1 of PCL's header> <flag>
configures() {
  echo "#define PCL_USES_EIGEN_HANDMADE_ALIGNED_MALLOC $1" > "$folder/include/pcl/pcl_config.h"
  rm -rf "$folder/build"
  "$cmake" -S "$folder/project" -B "$folder/build" -DCMAKE_CXX_FLAGS="$2" > "$folder/log" 2>&1
}
configures 1 -mavx || { echo "AVX is refused where PCL has it:"; cat "$folder/log"; exit 1; }
configures 0 -O2 || { echo "Usual flags are refused:"; cat "$folder/log"; exit 1; }
if configures 1 -O2; then echo "Flags without AVX are accepted where PCL has it"; exit 1; fi
tr -s '\n ' ' ' < "$folder/log" | grep -q "do not turn on AVX" || { cat "$folder/log"; exit 1; }
for flag in -mavx -mavx2 -march=haswell; do
  if configures 0 "-O2 $flag"; then echo "$flag is accepted where PCL has no AVX"; exit 1; fi
  says_why "$flag"
done
