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
"$here/make_project.sh" "$folder/source"

configure() {
  "$cmake" -S "$folder/source" -B "$1" -Wno-dev -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_FLAGS=-O0 -DCMAKE_PREFIX_PATH="$folder/prefix" > "$1.log" 2>&1
}

configure "$folder/build" || { cat "$folder/build.log"; exit 1; }
"$cmake" --build "$folder/build"
"$folder/build/consumer"

# the program of docs/guide/cpp.md, by its own CMakeLists.txt
mkdir "$folder/guide"
firstBlock() { awk -v begin="\`\`\`$1" '/^```/ { if (inside) exit; inside = $0 == begin; next } inside' "$here/../../docs/guide/cpp.md"; }
firstBlock cpp > "$folder/guide/describe_building.cpp"
firstBlock cmake > "$folder/guide/CMakeLists.txt"
"$cmake" -S "$folder/guide" -B "$folder/guide/build" -Wno-dev -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_FLAGS=-O0 -DCMAKE_PREFIX_PATH="$folder/prefix" > "$folder/guide.log" 2>&1 \
  || { cat "$folder/guide.log"; exit 1; }
"$cmake" --build "$folder/guide/build"

# who trains networks needs none of libtorch's headers; the component is there only where it was built
cat > "$folder/source/training.cpp" << 'END'
#include <pcl/ml/network_designs.h>
#include <pcl/ml/network_training.h>
int main()
{
  auto network = pcl::indoor::perceptron(2, {1, {4}, 0.0f});
  pcl::indoor::TrainingSet set{{{{0.0f}}, {{1.0f}}}, {0, 1}};
  pcl::indoor::fitScale(network, set);
  pcl::indoor::initializeWeights(network, 1);
  return pcl::indoor::trainNetwork(network, set, {}, {}).epochs.size() == 100 ? 0 : 1;
}
END
cp "$folder/source/CMakeLists.txt" "$folder/CMakeLists.txt"
sed -i 's/COMPONENTS scene segmentation features ml/COMPONENTS training/; /consumer PRIVATE/,$d' "$folder/source/CMakeLists.txt"
sed -i 's/consumer consumer.cpp/consumer training.cpp/' "$folder/source/CMakeLists.txt"
echo 'target_link_libraries(consumer PRIVATE pcl_indoor::training)' >> "$folder/source/CMakeLists.txt"
if [ -n "$(find "$folder/prefix" -name 'libpcl_indoor_training.*')" ]; then
  configure "$folder/training" || { cat "$folder/training.log"; exit 1; }
  "$cmake" --build "$folder/training"
  "$folder/training/consumer"
elif configure "$folder/training"; then
  echo "The component training is found, but was not built"
  exit 1
fi
mv "$folder/CMakeLists.txt" "$folder/source/CMakeLists.txt"

sed -i 's/COMPONENTS scene segmentation features ml/COMPONENTS no_such_module/' "$folder/source/CMakeLists.txt"
if configure "$folder/unknown"; then
  echo "An unknown component is found"
  exit 1
fi
sed -i 's/0.1 REQUIRED COMPONENTS no_such_module/99.0 REQUIRED/' "$folder/source/CMakeLists.txt"
if configure "$folder/newer"; then
  echo "Version 99.0 is found, there is only $version"
  exit 1
fi

# the library describes a building as the tool does
"$here/same_scene.sh" "$cmake" "$folder/prefix"

# tools run from where they are installed, with the libraries installed beside them
"$folder/prefix/bin/pcl_room_segmentation" -h > /dev/null
