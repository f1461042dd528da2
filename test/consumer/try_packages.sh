#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# try_packages.sh <folder with the packages> [installed]
# Unpacks the Debian packages into a root of their own (or, with "installed", takes those that are installed), builds
# the consumer project with what is there, runs it, and lets the tools and the Python package describe a simulated flat.
set -euo pipefail
packages=$1
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if [ "${2:-}" = installed ]; then
  usr=/usr
else
  for package in libpcl-indoor[0-9]* libpcl-indoor-dev pcl-indoor-tools python3-pcl-indoor; do
    # shellcheck disable=SC2086 # a pattern
    dpkg -x "$packages"/${package}_*.deb "$folder/root"
  done
  usr=$folder/root/usr
fi
"$here/make_project.sh" "$folder/source"
cmake -S "$folder/source" -B "$folder/build" -Wno-dev -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$usr" \
  > "$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
grep -q "pcl_indoor_DIR:PATH=$usr/" "$folder/build/CMakeCache.txt" || { echo "another pcl_indoor is found"; exit 1; }
cmake --build "$folder/build" > "$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
"$folder/build/consumer"
"$usr/bin/pcl_scan_simulation" "$usr/share/pcl_indoor/plans/flat.json" "$folder/flat.pcd" -quiet
"$usr/bin/pcl_indoor_pipeline" "$folder/flat.pcd" "$folder/flat" -quiet
"$usr/bin/pcl_indoor_query" "$folder/flat/scene.json" -class door
"$here/same_scene.sh" cmake "$usr"
PYTHONPATH=$usr/lib/python3/dist-packages python3 -W ignore -c "import pcl_indoor, sys
pcl_indoor.describe(sys.argv[1]).save(sys.argv[2])" "$folder/flat.pcd" "$folder/by_python.json"
cmp "$folder/flat/scene.json" "$folder/by_python.json"
for file in share/pcl_indoor/scene.schema.json share/man/man1/pcl_indoor_query.1 \
  share/bash-completion/completions/pcl_indoor_query; do
  [ -e "$usr/$file" ] || [ -e "$usr/$file.gz" ] || { echo "$file is missing"; exit 1; }
done
