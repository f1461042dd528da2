#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# static_configure.sh <cmake> <source folder>: with BUILD_SHARED_LIBS=OFF all libraries are static, and a program that finds
# them links what they use in turn. Nothing is compiled: the libraries are empty files (test/static_build compiles them).
set -euo pipefail
cmake=$1 source=$2
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$cmake" -S "$source" -B "$folder/build" -Wno-dev -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF -DPCL_INDOOR_BUILD_TESTS=OFF \
  > "$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }

# what would be installed of the CMake package
package=$folder/prefix/lib/cmake/pcl_indoor
mkdir -p "$package"
cp "$folder"/build/pcl_indoorConfig*.cmake "$package"
find "$folder/build/CMakeFiles/Export" -name 'pcl_indoorTargets*.cmake' -exec cp {} "$package" \;
if grep "add_library" "$package/pcl_indoorTargets.cmake" | grep -v "STATIC IMPORTED"; then
  echo "These libraries are not static"
  exit 1
fi
grep -oh '{_IMPORT_PREFIX}/[^";]*' "$package"/*.cmake | sed 's#^{_IMPORT_PREFIX}##' | sort -u > "$folder/names"
grep -q 'libpcl_indoor_scene\.a' "$folder/names" || { echo "There is no static library of scene"; exit 1; }
while read -r name; do
  case $name in
    *.a) mkdir -p "$(dirname "$folder/prefix$name")" && touch "$folder/prefix$name" ;;
    *) mkdir -p "$folder/prefix$name" ;;
  esac
done < "$folder/names"

"$here/make_project.sh" "$folder/consumer"
"$cmake" -S "$folder/consumer" -B "$folder/consumer/build" -G "Unix Makefiles" -Wno-dev -DCMAKE_PREFIX_PATH="$folder/prefix" \
  > "$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
for library in libpcl_indoor_io.a libpcl_indoor_rooms.a libpng libpugixml libarchive libpcl_segmentation libpcl_io; do
  grep -q "$library" "$folder/consumer/build/CMakeFiles/examples.dir/link.txt" || { echo "A program does not link $library"; exit 1; }
done
grep -q "PCL_INDOOR_STATIC" "$folder/consumer/build/CMakeFiles/examples.dir/flags.make" || { echo "A program is not told that libraries are static"; exit 1; }
