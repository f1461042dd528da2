#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# station_positions.sh <folder of the tools> <plan>
# Where the scanner stood, as the simulation writes it and as rooms, plans and normals use it; what is wrong is said in
# one line.
set -u
tools=$1 plan=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

fail() { echo "$*"; ls -lAR; exit 1; }
rooms() { "$tools"/pcl_room_segmentation scan.pcd "$1".pcd -json "$1".json -map "$1" -quiet "${@:2}"; }

"$tools"/pcl_scan_simulation "$plan" scan.pcd -stations_out positions.csv -json names.json -leaf 0.06 -quiet || exit 1
grep -aq '^FIELDS .* station' scan.pcd || fail "the points have no field station"
[ "$(wc -l < positions.csv)" = "$(tr -d ' \n' < names.json | sed 's/.*"trajectory"://' | grep -o '\[[^][]*\]' | wc -l)" ] ||
  fail "there are not as many positions as the trajectory has"

rooms without || exit 1
rooms with -stations positions.csv > said 2>&1 || fail "with stations it fails: $(cat said)"
[ "$(grep -c '"footprint"' with.json)" = "$(grep -c '"footprint"' without.json)" ] || fail "rooms that hold stations are lost"
grep -q '"station_positions"' with.json || fail "the stations are not in the JSON"
grep -q "from $(wc -l < positions.csv) stations" with.json || fail "what was understood does not tell them"
grep -q 'class="station"' with_rooms.svg || fail "the plan does not show them"
grep -q 'class="station"' without_rooms.svg && fail "the plan shows stations that are not known"
rooms ignored -stations positions.csv -ignore_stations || exit 1
cmp without.pcd ignored.pcd || fail "with -ignore_stations the rooms are others"
cmp without_rooms.svg ignored_rooms.svg || fail "with -ignore_stations the plan is another"

# of all positions the one that no other sees is enough to lose nothing; of none in the frame, it is said
awk '{ print $1 + 1000, $2, $3 }' positions.csv > shifted.csv
rooms shifted -stations shifted.csv > said 2>&1 || fail "positions of another frame fail: $(cat said)"
grep -q "No station stands in a room" said || fail "positions of another frame are not noticed: $(cat said)"
cmp without.pcd shifted.pcd || fail "positions of another frame change the rooms"

"$tools"/pcl_hough_normals scan.pcd turned.pcd -stations positions.csv -quiet || exit 1
"$tools"/pcl_hough_normals scan.pcd plain.pcd -quiet || exit 1
cmp -s turned.pcd plain.pcd && fail "normals are not turned to their stations"
"$tools"/pcl_hough_normals scan.pcd ignored.pcd -stations positions.csv -ignore_stations -quiet || exit 1
cmp plain.pcd ignored.pcd || fail "with -ignore_stations normals are others"

refused() { # <reason> <file>
  rooms refused -stations "$2" > said 2>&1 && fail "$2 is taken"
  [ "$(wc -l < said)" = 1 ] && grep -q "$1" said || fail "$2: $(cat said)"
  [ ! -e refused.pcd ] || fail "$2: an output is left"
}
refused "none.csv" none.csv
: > empty.csv
refused "empty.csv" empty.csv
printf '1 2\n3 4\n' > flat.csv
refused "flat.csv" flat.csv
printf '1 2 3\nnan 1 2\n' > nan.csv
refused "station 2" nan.csv

# a field that does not fit is said, and the positions are used all the same
head -2 positions.csv > two.csv
rooms two -stations two.csv > said 2>&1 || fail "two positions fail: $(cat said)"
grep -q "the field station does not fit the 2 positions" said || fail "a field that does not fit is not said: $(cat said)"
