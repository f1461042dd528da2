#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# install_and_build.sh <cmake> <build folder> <version>
# Installs the built project to a temporary prefix, builds the consumer project from it alone, runs it, and demands
# that an unknown component and a newer version are refused.
set -euo pipefail
cmake=$1 build=$2 version=$3
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$cmake" --install "$build" --prefix "$folder/prefix" > "$folder/install.log"
mkdir "$folder/source"
cp "$here/CMakeLists.txt" "$here/consumer.cpp" "$folder/source"
"$here/gather_readme.sh" "$here/../../README.md" "$folder/source/readme.cpp"

configure() {
  "$cmake" -S "$folder/source" -B "$1" -Wno-dev -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$folder/prefix" > "$1.log" 2>&1
}

configure "$folder/build" || { cat "$folder/build.log"; exit 1; }
"$cmake" --build "$folder/build"
"$folder/build/consumer"

sed -i 's/COMPONENTS segmentation features/COMPONENTS no_such_module/' "$folder/source/CMakeLists.txt"
if configure "$folder/unknown"; then
  echo "An unknown component is found"
  exit 1
fi
sed -i 's/0.1 REQUIRED COMPONENTS no_such_module/99.0 REQUIRED/' "$folder/source/CMakeLists.txt"
if configure "$folder/newer"; then
  echo "Version 99.0 is found, there is only $version"
  exit 1
fi

# tools run from where they are installed, with the libraries installed beside them
"$folder/prefix/bin/pcl_room_segmentation" -h > /dev/null
