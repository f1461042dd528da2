#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# killed_runs.sh <folder of the tools> <plan> <library kill_at_step> <number of random moments> [pipeline|rooms]...
# Kills tools (kill -9) before each step by which they change files, and at random moments. Every file under its final
# name must be whole: that of the run before or that of this run, or absent. In the folder of pcl_indoor_pipeline, if
# scene.json is there, all files must be of the same run. After TERM and HUP, all files must be of one run in any case,
# and no unfinished one may be left. The folder of finished rooms does not count.
set -u
tools=$1 plan=$2 library=$3 random_moments=$4
shift 4
[ $# -gt 0 ] || set -- pipeline rooms
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
export ASAN_OPTIONS=verify_asan_link_order=0
RANDOM=${SEED:=$RANDOM}
echo "seed $SEED" # the same moments again: SEED=...

fail() { echo "$*"; ls -l now; exit 1; }

"$tools"/pcl_scan_simulation "$plan" scan.pcd -leaf 0.2 || exit 1

pipeline() { # old|new
  local options=(-model none -colour none)
  [ "$1" = old ] || options=(-colour height)
  exec "$tools"/pcl_indoor_pipeline scan.pcd now -up z -threads 1 "${options[@]}"
}

rooms() { # old|new
  local colour=room
  [ "$1" = old ] || colour=height
  exec "$tools"/pcl_room_segmentation scan.pcd now/cloud.ply -up z -map now/map -json now/rooms.json -threads 1 -colour $colour
}

is_of() { cmp -s "now/$2" "$1/$2"; } # old|new <file>

check() { # <when>
  local file run of_one_run=no
  for file in $(cd now && find . -name .unfinished -prune -o -type f ! -name '*.part*' -print); do
    is_of old "$file" || is_of new "$file" || fail "$1: $file is neither the old nor the new one"
  done
  [ -e now/scene.json ] || return
  for run in old new; do
    diff -r -x '*.part*' -x .unfinished -q now $run > /dev/null && of_one_run=yes
  done
  [ $of_one_run = yes ] || fail "$1: scene.json lies beside files of another run"
}

again() { rm -rf now && cp -r old now && [ -d now ] || fail "the test cannot copy its files"; }

is_of_one_run() { # what is finished of a run that was ended does not count
  diff -rq -x .unfinished now old > /dev/null || diff -rq -x .unfinished now new > /dev/null
}

for tool in "$@"; do
  rm -rf old new
  for run in old new; do
    rm -rf now
    mkdir now
    ($tool $run) || fail "$tool fails"
    mv now $run
  done
  diff -q old/cloud.* new/cloud.* > /dev/null && fail "the two runs do not differ"
  for ((step = 1; ; ++step)); do
    again
    (LD_PRELOAD=$library KILL_AT=$step $tool new)
    status=$?
    check "$tool, step $step"
    [ $status -eq 0 ] && break
    [ $status -eq 137 ] || fail "$tool, step $step: status $status"
  done
  [ "$step" -gt 5 ] || fail "$tool: only $step steps"
  echo "$tool: killed before each of $((step - 1)) steps"
  for ((n = 1; n < step; n += 4)); do
    again
    (LD_PRELOAD=$library KILL_AT=$n KILL_BY=15 $tool new)
    is_of_one_run || fail "$tool, TERM before step $n: files of two runs, or unfinished ones"
  done
  begin=$(date +%s%N)
  again
  ($tool new)
  length=$((($(date +%s%N) - begin) / 1000000 + 1)) # milliseconds
  amid=0
  for ((moment = 0; moment < random_moments; ++moment)); do
    for signal in KILL TERM HUP; do
      again
      $tool new &
      delay=$(((RANDOM * 32768 + RANDOM) % length))
      sleep "$((delay / 1000)).$(printf '%03d' $((delay % 1000)))"
      kill -$signal $! 2> /dev/null
      wait $! 2> /dev/null
      [ $? -le 128 ] || amid=$((amid + 1))
      check "$tool, $signal"
      [ $signal != KILL ] || continue
      is_of_one_run || fail "$tool, $signal: files of two runs, or unfinished ones"
    done
  done
  echo "$tool: ended amid its work at $amid of $((3 * random_moments)) random moments"
  all_moments=$((${all_moments:-0} + 3 * random_moments)) all_amid=$((${all_amid:-0} + amid))
done 2> /dev/null # bash tells of each program that is killed
[ $((3 * all_amid)) -ge "$all_moments" ] || fail "too few were ended amid their work to tell anything"
