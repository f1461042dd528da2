#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# shared_runs.sh <folder of the tools> <plan> <mpirun>
# Runs pcl_indoor_pipeline with one, two and three processes: all files must be the same. When one of them is killed all
# end, and the same command goes on from the finished rooms. Bad options give one line.
set -u
tools=$1 plan=$2 mpirun=$3
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_btl_base_warn_component_unused=0

fail() { echo "$*"; ls -lAR now; exit 1; }

"$tools"/pcl_scan_simulation "$plan" scan.pcd -leaf 0.12 -quiet || exit 1
"$tools"/pcl_scan_simulation "$(dirname "$plan")"/flat.json flat.pcd -leaf 0.12 -quiet || exit 1
pipeline() { exec "$tools"/pcl_indoor_pipeline "${scan:-scan.pcd}" now -quiet -threads 1 "$@"; }
shared() { exec "$mpirun" --map-by :OVERSUBSCRIBE -n "$1" "$tools"/pcl_indoor_pipeline "${scan:-scan.pcd}" now -quiet "${@:2}"; }

(pipeline) || fail "the pipeline fails"
mv now expected
for ranks in 1 2 3; do
  (shared $ranks) || fail "$ranks processes fail"
  diff -rq now expected || fail "$ranks processes give other results"
  rm -rf now
done
(scan=flat.pcd; shared 2 -unit ft -up y -voxel_resolution 0.05 2> /dev/null) || fail "with a frame of its own it fails"
mv now framed
"$tools"/pcl_indoor_pipeline flat.pcd now -quiet -unit ft -up y -voxel_resolution 0.05 2> /dev/null
diff -rq now framed || fail "in a frame of its own the results are others"
rm -rf now framed

(scan=flat.pcd; pipeline) || fail "the pipeline fails on the flat"
mv now alone
(export OMPI_COMM_WORLD_SIZE=2 OMPI_COMM_WORLD_RANK=1; scan=flat.pcd; pipeline -single_process) ||
  fail "a process that is to work alone fails"
diff -rq now alone || fail "a process that works alone gives other results"
rm -rf now

rooms() { find now/.unfinished -name 'room_*' ! -name '*.part*' 2> /dev/null; }
killed=0
for rank in 1 2 3; do # counted from 1
  rm -rf now
  shared 3 2> /dev/null &
  run=$!
  for ((n = 0; n < 600; ++n)); do
    [ -z "$(rooms)" ] || break
    sleep 0.05
  done
  process=$(cut -d ' ' -f $rank "/proc/$run/task/$run/children" 2> /dev/null)
  [ -z "$process" ] || kill -KILL "$process"
  wait $run && continue # it was too late
  killed=$((killed + 1))
  before=$(ls -i $(rooms))
  [ -n "$before" ] || fail "when process $rank is killed the finished rooms are lost"
  (shared 2) || fail "after process $rank was killed it does not go on"
  diff -rq -x '*.part*' now expected || fail "after process $rank was killed the results are others"
done
[ $killed -gt 0 ] || fail "no process was killed in time"
echo "killed one of three processes $killed times"

(shared 3 -voxel_size none) > said 2>&1 && fail "a bad option is taken"
[ "$(grep -c voxel_size said)" -eq 1 ] || fail "not one line: $(cat said)"
exit 0
