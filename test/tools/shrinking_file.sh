#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# shrinking_file.sh <folder of the tools> <plan> <library shrink_file>
# Cuts a scan between any two steps by which a tool reads it. The tool either has all of it already and writes what it
# writes otherwise, or says in one line what is wrong.
set -u
tools=$1 plan=$2 library=$3
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

"$tools"/pcl_scan_simulation "$plan" scan.pcd -leaf 0.12 || exit 1
"$tools"/pcl_room_segmentation scan.pcd scan.ply -quiet || exit 1
for name in scan.pcd scan.ply; do
  "$tools"/pcl_room_segmentation $name expected.pcd -quiet || exit 1
  refused=0
  for ((step = 1; step <= 20; ++step)); do
    cp $name cut_$name
    LD_PRELOAD=$library SHRINK=$folder/cut_$name SHRINK_AT=$step \
      "$tools"/pcl_room_segmentation cut_$name out.pcd -quiet > /dev/null 2> said
    status=$?
    if [ $status -eq 0 ]; then
      cmp -s out.pcd expected.pcd || { echo "$name, step $step: other results"; exit 1; }
    elif [ $status -ne 1 ] || [ "$(wc -l < said)" -ne 1 ] || [ -e out.pcd ]; then
      echo "$name, step $step: status $status"
      cat said
      exit 1
    else
      refused=$((refused + 1))
    fi
    rm -f out.pcd
  done
  [ $refused -gt 2 ] || { echo "$name: never cut while it was read"; exit 1; }
  echo "$name: refused $refused times"
done
