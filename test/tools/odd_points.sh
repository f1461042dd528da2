#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# odd_points.sh <folder of the tools> <plan>
# Copies of points, thousands of points at one place, and normals that are none change no result, in memory or in parts,
# and a line says what was found.
set -u
tools=$1 plan=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

fail() { echo "$*"; cat said; exit 1; }

"$tools"/pcl_scan_simulation "$plan" scan.ply -leaf 0.06 -quiet || exit 1
fields=$(sed -n '/^end_header/q;/^property/p' scan.ply | wc -l) # of 4 bytes each
LC_ALL=C sed '1,/^end_header$/d' scan.ply | od -An -v -w$((4 * fields)) -t f4 | awk '{ print $1, $2, $3 }' > once.xyz
points=$(wc -l < once.xyz)

value() { sed -n "s/^ *\"$2\": \([0-9.]*\).*/\1/p" "$1"/scene.json | head -n 1; }
objects() { grep -c '"upright_box"' "$1"/scene.json; }
run() { # <input> <result> <options>: what is said goes to a file
  "$tools"/pcl_indoor_pipeline "$@" -quiet 2> all_said || fail "$1 fails"
  grep -v '^Note' all_said > said
}
same() { # <result>: as many rooms and objects as those of the scan alone
  [ "$(grep -c '"footprint"' "$1"/scene.json)" = "$(grep -c '"footprint"' once/scene.json)" ] || fail "$1: other rooms"
  [ "$(objects "$1")" = "$(objects once)" ] || fail "$1: $(objects "$1") objects, not $(objects once)"
}
says() { [ "$(wc -l < said)" = 1 ] && grep -q "$1" said || fail "it does not say '$1'"; }

run once.xyz once
[ -s said ] && fail "something is odd about a plain scan"
[ "$(objects once)" -gt 5 ] || fail "there are no objects"

cat once.xyz once.xyz > twice.xyz
run twice.xyz twice
says "$points of $((2 * points)) points lie exactly at the place of another"
same twice

(cat once.xyz; yes "1.5 1.25 1.125" | head -n 3000) > zeros.xyz
run zeros.xyz zeros
says "3000 of $((points + 3000)) points lie at 1.5 1.25 1.125,"
same zeros
[ "$(value zeros finite_points)" = "$points" ] || fail "they are points"
[ "$(value zeros points)" = $((points + 3000)) ] || fail "they are not in the output"

(echo x y z nx ny nz; sed 's/$/ 0 0 0/' once.xyz) > no_normals.xyz
run no_normals.xyz no_normals
says "0 of $points have length 1"
same no_normals

# in parts: of binary files
"$tools"/pcl_room_segmentation zeros.xyz zeros.pcd -quiet 2> /dev/null || fail "the rooms fail"
run zeros.pcd zeros_in_parts -points_at_once 10000
says "3000 of $((points + 3000)) points lie at 1.5 1.25 1.125,"
[ "$(value zeros_in_parts finite_points)" = "$points" ] || fail "in parts they are points"
"$tools"/pcl_room_segmentation no_normals.xyz no_normals.pcd -quiet 2> /dev/null || fail "the rooms fail"
run no_normals.pcd no_normals_in_parts -points_at_once 10000
says "0 of .* have length 1"
[ "$(objects no_normals_in_parts)" = "$(objects zeros_in_parts)" ] || fail "in parts zeros are normals"
exit 0
