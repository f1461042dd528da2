#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# large_scans.sh <folder of the tools> <plan> <library kill_at_step> [mpirun]
# Reads a scan in parts, as if it were too large for the memory. The rooms must be those that are found otherwise, all
# points must come back in their order, and the files must be the same for any number of threads and processes, also
# when the pipeline is killed and started again.
set -u
tools=$1 plan=$2 library=$3 mpirun=${4:-}
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
export ASAN_OPTIONS=verify_asan_link_order=0
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

fail() { echo "$*"; ls -lA now; exit 1; }

"$tools"/pcl_scan_simulation "$plan" scan.ply -leaf 0.04 -quiet || exit 1
points=$(sed -n 's/^element vertex //p;/^end_header/q' scan.ply)
parts() { exec "$tools"/pcl_indoor_pipeline "${scan:-scan.ply}" now -quiet -points_at_once 20000 "$@"; }

value() { sed -n "s/^ *\"$2\": \([0-9.]*\).*/\1/p" "$1"/scene.json | head -n 1; }

"$tools"/pcl_indoor_pipeline scan.ply now -quiet -points_at_once "$points" || fail "the pipeline fails"
mv now whole
grep -q points_at_once whole/scene.json && fail "a scan in memory tells how large ones are read"
(parts -threads 1) || fail "in parts the pipeline fails"
mv now expected
grep -q '"points_at_once": 20000' expected/scene.json || fail "the scene does not tell how the scan was read"
for name in points finite_points; do
  [ "$(value whole $name)" = "$(value expected $name)" ] || fail "$name differs"
done

# the same rooms, the same points
agree() { # <field> <metric> <least>: of both results
  local score
  score=$("$tools"/pcl_segmentation_evaluation whole/cloud.pcd expected/cloud.pcd -truth_field "$1" -predicted_field "$1" |
    sed -n "s/^$2  *//p")
  awk -v score="$score" -v least="$3" 'BEGIN { exit !(score >= least) }' || fail "$1: $2 is $score, not at least $3"
}
agree room right_segments "$(grep -c '"footprint"' whole/scene.json)"
agree room precision 0.98
agree object weighted_overlap 0.8
agree part precision 1 # a field of the scan: all points are where they were

for threads in 2 3; do
  (parts -threads $threads) || fail "with $threads threads it fails"
  diff -rq now expected || fail "with $threads threads the results are others"
  rm -rf now
done
if [ -n "$mpirun" ]; then
  ("$mpirun" --map-by :OVERSUBSCRIBE -n 2 "$tools"/pcl_indoor_pipeline scan.ply now -quiet -points_at_once 20000) || fail "two processes fail"
  diff -rq now expected || fail "with two processes the results are others"
  rm -rf now
fi
for step in 3 4 6 9 15 25 33; do
  (export LD_PRELOAD=$library KILL_AT=$step; parts) 2> /dev/null
  [ $? -eq 137 ] || fail "at step $step it is not killed"
done
(parts) || fail "after it was killed it does not go on"
diff -rq -x '*.part*' now expected || fail "after it was killed the results are others"

# damaged and missing files of the points are made again
while IFS='|' read -r file damage; do
  rm -rf now
  (export LD_PRELOAD=$library KILL_AT=33; parts) 2> /dev/null < /dev/null
  [ -s "now/.unfinished/$file" ] || fail "$file was not written in time"
  eval "${damage//FILE/now/.unfinished/$file}"
  (parts < /dev/null) || fail "after '$damage' of $file it fails"
  diff -rq -x '*.part*' now expected || fail "after '$damage' of $file the results are others"
done << 'END'
points_1|truncate -s -1 FILE
points_filed|printf x > byte; dd if=byte of=FILE conv=notrunc bs=1 seek=60 status=none
points_rooms|truncate -s 0 FILE
points_1|rm FILE
END

# what is written in parts is a scan again; it and a frame of its own
cp expected/cloud.pcd parts.pcd
rm -rf now
(scan=parts.pcd parts) || fail "its own output in parts is refused"
mv expected/cloud.pcd ply.pcd && mv now/cloud.pcd expected/cloud.pcd && mv ply.pcd whole/cloud.pcd
agree room precision 1
agree object precision 1
rm -rf now
(parts -up y -unit ft -double -colour height 2> said) || fail "in a frame of its own it fails: $(cat said)"
head -c 400 now/cloud.pcd | grep -aq '^SIZE 8 8 8' || fail "-double writes no doubles"

# what cannot be read in parts is loaded
(parts -model none -report none > /dev/null) || fail "without a model it fails"
"$tools"/pcl_indoor_pipeline whole/cloud.pcd now -quiet -points_at_once 20000 2> /dev/null || fail "a second scan fails"
exit 0
