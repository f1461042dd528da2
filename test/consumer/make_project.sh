#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# make_project.sh <folder>
# Makes the folder of the consumer project, with the C++ examples of the README and of the guide.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..
mkdir "$1"
cp "$here/CMakeLists.txt" "$here/consumer.cpp" "$1"
"$here/gather_examples.sh" "$root/README.md" "$root/docs/guide/"{rooms,objects,normals,descriptors_and_classes}.md "$1/examples.cpp"
