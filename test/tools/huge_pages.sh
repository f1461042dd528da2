#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# huge_pages.sh <folder of the tools>
# A tool starts itself again for a large scan, once, where huge pages are given on request; else not at all. The dynamic
# linker writes its figures at each start.
set -euo pipefail
tools=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
scan=$folder/table.pcd
"$tools/pcl_scan_simulation" random:table:1 "$scan" -quiet
{ cat "$scan"; head -c 9000000 /dev/zero; } > "$folder/large.pcd" # what follows the points does not count

# starts <expected number> <scan> [environment]
starts() {
  rm -f "$folder"/log.*
  env "${@:3}" LD_DEBUG=statistics LD_DEBUG_OUTPUT="$folder/log" \
    "$tools/pcl_room_segmentation" "$2" "$folder/rooms.pcd" -quiet 2> "$folder/stderr"
  local count
  count=$(cat "$folder"/log.* | grep -c 'total startup time')
  [ "$count" -eq "$1" ] || { echo "$count starts for $1: ${*:2}"; exit 1; }
}

on_request=1
grep -qF '[madvise]' /sys/kernel/mm/transparent_hugepage/enabled 2> /dev/null && on_request=2
unset GLIBC_TUNABLES
starts 1 "$scan"
cp "$folder/rooms.pcd" "$folder/small_pages.pcd"
starts "$on_request" "$folder/large.pcd"
cmp "$folder/rooms.pcd" "$folder/small_pages.pcd"
starts 1 "$folder/large.pcd" GLIBC_TUNABLES=glibc.malloc.hugetlb=0
