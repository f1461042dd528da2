#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# stations_in_a_file.sh <folder of the tools>
# A file with scans from two stations (PTX): what the pipeline makes of it, in memory, in parts and beside another file.
set -u
tools=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

fail() { echo "$*"; ls -lAR; exit 1; }
pipeline() { "$tools"/pcl_indoor_pipeline "$@" -quiet; }

# a room of 5 x 4 x 2.5 m as a scanner sees it that stands at x y 1.5 and is turned by a right angle: local x is y of
# the room, local y is -x
scan() { # <x> <y>
  awk -v sx="$1" -v sy="$2" 'BEGIN {
    step = 0.04; count = 0
    for (u = 0; u <= 5; u += step) for (v = 0; v <= 2.5; v += step) { put(u, 0, v); put(u, 4, v) }
    for (u = 0; u <= 4; u += step) for (v = 0; v <= 2.5; v += step) { put(0, u, v); put(5, u, v) }
    for (u = 0; u <= 5; u += step) for (v = 0; v <= 4; v += step) { put(u, v, 0); put(u, v, 2.5) }
    for (i = 0; i < 100; ++i) line[count++] = "0 0 0 0.5"
    printf "%d\n1\n%s %s 1.5\n0 1 0\n-1 0 0\n0 0 1\n", count, sx, sy
    printf "0 1 0 0\n-1 0 0 0\n0 0 1 0\n%s %s 1.5 1\n", sx, sy
    for (i = 0; i < count; ++i) print line[i]
  }
  function put(x, y, z) { line[count++] = sprintf("%.4f %.4f %.4f 0.25", y - sy, sx - x, z - 1.5) }'
}
scan 1 1 > both.ptx
scan 4 3 >> both.ptx
count() { sed -n 's/^POINTS //p;/^DATA/q' "$1"; }

pipeline both.ptx whole > said 2>&1 || fail "a file of two scans fails: $(cat said)"
grep -q "both.ptx: points at 0 0 0 saw no return and are left out: 200" said || fail "no returns are not said: $(cat said)"
grep -q '^FIELDS x y z intensity row column station ' whole/cloud.pcd || fail "fields are missing"
json=$(tr -d ' \n' < whole/scene.json)
grep -q '"stations":\["scan1","scan2"\]' <<< "$json" || fail "the stations have no names"
grep -q '"station_positions":\[\[1.0,1.0,1.5\],\[4.0,3.0,1.5\]\]' <<< "$json" || fail "the stations have no places"
[ "$(grep -c '"footprint"' whole/scene.json)" = 1 ] || fail "the scans do not fit each other: it is not one room"

pipeline both.ptx parts -points_at_once 20000 > said 2>&1 || fail "in parts it fails: $(cat said)"
grep -q "saw no return and are left out: 200" said || fail "in parts no returns are not said: $(cat said)"
[ "$(count parts/cloud.pcd)" = "$(count whole/cloud.pcd)" ] || fail "not all points came back in parts"
tr -d ' \n' < parts/scene.json | grep -q '"station_positions":\[\[1.0,1.0,1.5\],\[4.0,3.0,1.5\]\]' ||
  fail "in parts the stations have no places"

printf 'x,y,z\n0.5,0.5,0.5\n1.5,1,0.5\n' > more.csv
pipeline both.ptx more.csv joined 2> /dev/null || fail "beside another file it fails"
json=$(tr -d ' \n' < joined/scene.json)
grep -q '"stations":\["both.ptx:scan1","both.ptx:scan2","more.csv"\]' <<< "$json" || fail "stations of files are not named"
grep -q '"station_positions":\[\[1.0,1.0,1.5\],\[4.0,3.0,1.5\],null\]' <<< "$json" || fail "stations of files have no places"

head -n 5000 both.ptx > cut.ptx
pipeline cut.ptx cut > said 2>&1 && fail "a file that is cut is taken"
[ "$(wc -l < said)" = 1 ] && grep -q "cut.ptx: the file is truncated" said || fail "$(cat said)"
exit 0
