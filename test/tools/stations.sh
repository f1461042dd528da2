#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# stations.sh <folder of the tools> <plan>
# Several scans of a building, of three formats, are one: named one by one or by their folder, in memory or in parts;
# each point keeps its station. What is wrong is said in one line, and nothing is written.
set -u
tools=$1 plan=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

fail() { echo "$*"; ls -lAR; exit 1; }
pipeline() { "$tools"/pcl_indoor_pipeline "$@" -quiet; }

mkdir stations
seed=0
for name in a.pcd b.ply; do
  seed=$((seed + 1))
  "$tools"/pcl_scan_simulation "$plan" stations/$name -leaf 0.06 -seed $seed -quiet || exit 1
done
"$tools"/pcl_scan_simulation "$plan" whole.pcd -leaf 0.06 -seed 1 -quiet || exit 1
printf 'x,y,z\n0.5,0.5,0.5\n1.5,1,0.5\n' > stations/c.csv
touch stations/notes.md

count() { sed -n "s/^element vertex //p;s/^POINTS //p;/^end_header/q;/^DATA/q" "$1"; }
all=$(($(count stations/a.pcd) + $(count stations/b.ply) + 2))

pipeline stations named > said 2>&1 || fail "a folder of stations fails: $(cat said)"
grep -q "left out: .*part" said || fail "fields that the table lacks are not named: $(cat said)"
[ "$(count named/cloud.pcd)" = $all ] || fail "not all points came back"
grep -q '^FIELDS x y z station ' named/cloud.pcd || fail "there is no field station"
grep -q '"input": "stations"' named/scene.json || fail "the folder is not named"
tr -d ' \n' < named/scene.json | grep -q '"stations":\["a.pcd","b.ply","c.csv"\]' || fail "the stations are not named"
pipeline stations/a.pcd stations/b.ply stations/c.csv listed 2> /dev/null || fail "scans one by one fail"
cmp named/cloud.pcd listed/cloud.pcd || fail "one by one the points are others"
rooms() { grep -c '"footprint"' "$1"/scene.json; }
pipeline whole.pcd alone || exit 1
[ "$(rooms named)" = "$(rooms alone)" ] || fail "$(rooms named) rooms, of one scan alone $(rooms alone)"

# the table does not keep the others from being read in parts
pipeline stations mixed -points_at_once 20000 > said 2>&1 || fail "in parts, a table among them, stations fail: $(cat said)"
grep -q '"points_at_once"' mixed/scene.json || fail "a table turns reading in parts off"
[ "$(count mixed/cloud.pcd)" = $all ] || fail "not all points came back in parts"
grep -q "left out: notes.md: not read" said || fail "a file that is no scan is not named: $(cat said)"
rm stations/c.csv stations/notes.md
pipeline stations whole -points_at_once 0 || fail "two stations fail"
pipeline stations parts -points_at_once 20000 || fail "two stations in parts fail"
[ "$(rooms whole)" = "$(rooms parts)" ] || fail "in parts there are $(rooms parts) rooms, not $(rooms whole)"
grep -q '^FIELDS x y z .*part.* station ' whole/cloud.pcd || fail "a field that both have is lost"
for field in station part; do
  score=$("$tools"/pcl_segmentation_evaluation whole/cloud.pcd parts/cloud.pcd -truth_field $field -predicted_field $field |
    sed -n 's/^precision  *//p')
  awk -v score="$score" 'BEGIN { exit !(score == 1) }' || fail "in parts the points have another $field: $score"
done

# results among the scans are no scan
cp -r stations own
pipeline own own || fail "results among the scans fail"
cp own/cloud.pcd first.pcd
pipeline own own > said 2>&1 || fail "a second time they fail"
cmp own/cloud.pcd first.pcd || fail "the result of the first run is read as a scan"
grep -q "cloud.pcd beside scene.json is the result" said || fail "the result is not named: $(cat said)"

refused() { # <pattern> <arguments>
  local pattern=$1
  shift
  pipeline "$@" out > said 2>&1 && fail "$* is taken"
  [ "$(wc -l < said)" = 1 ] && grep -q "$pattern" said || fail "$*: $(cat said)"
  [ ! -e out/scene.json ] || fail "$*: something is written"
}
mkdir empty only named_so
touch only/a.fls only/b.fls
cp stations/b.ply named_so/
cp stations/a.pcd named_so/cloud.pcd
refused "only: the folder holds no .*, but a.fls and 1 more: a scan of FARO" only
refused "empty: the folder holds no" empty
refused "missing.pcd" stations/a.pcd missing.pcd
head -c 3000 stations/a.pcd > cut.pcd
refused "cut.pcd" stations/b.ply cut.pcd
pipeline named_so named_so > said 2>&1 && fail "a scan is replaced by the results"
grep -q "cloud.pcd: the results would replace this scan" said || fail "the scan in danger is not named: $(cat said)"
pipeline stations/a.pcd > said 2>&1 && fail "no output folder is taken"
grep -q "'output_dir'" said || fail "the missing folder is not named: $(cat said)"
exit 0
