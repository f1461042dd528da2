#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# same_scene.sh <cmake> <prefix>: a program of three lines, built with what is installed there by CMake and by pkg-config,
# gives byte for byte the scene.json of the installed pcl_indoor_pipeline.
set -euo pipefail
cmake=$1 prefix=$2
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

mkdir "$folder/source"
cp "$here/describe_building.cpp" "$folder/source"
cat > "$folder/source/CMakeLists.txt" << 'END'
cmake_minimum_required(VERSION 3.18)
project(describe_building LANGUAGES CXX)
find_package(pcl_indoor REQUIRED COMPONENTS scene)
add_executable(describe_building describe_building.cpp)
target_link_libraries(describe_building PRIVATE pcl_indoor::scene)
END
"$cmake" -S "$folder/source" -B "$folder/build" -Wno-dev -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" \
  > "$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
"$cmake" --build "$folder/build" > "$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }

"$prefix/bin/pcl_scan_simulation" "$prefix/share/pcl_indoor/plans/flat.json" "$folder/flat.pcd" -quiet
"$prefix/bin/pcl_indoor_pipeline" "$folder/flat.pcd" "$folder/result" -quiet
"$folder/build/describe_building" "$folder/flat.pcd" "$folder/scene.json"
cmp "$folder/result/scene.json" "$folder/scene.json"

described=$(find "$prefix" -name pcl_indoor_scene.pc) # only shared libraries are
if [ -n "$described" ] && command -v pkg-config > /dev/null; then
  PKG_CONFIG_PATH=$(dirname "$described")
  export PKG_CONFIG_PATH
  read -ra flags < <(pkg-config --cflags --libs pcl_indoor_scene)
  c++ -std=c++17 -O1 "$folder/source/describe_building.cpp" -o "$folder/by_pkg_config" "${flags[@]}" \
    "-Wl,-rpath,$(pkg-config --variable=libdir pcl_indoor_scene)"
  "$folder/by_pkg_config" "$folder/flat.pcd" "$folder/again.json"
  cmp "$folder/result/scene.json" "$folder/again.json"
fi
