#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# failed_allocations.sh <folder of the tools> <plan> <library fail_allocation> <first n>[/step] <random n> <last n> [pipeline|rooms|objects]
# Lets tools run out of memory at each step-th of their first n allocations, one in each run, at random later ones, and at the last n. A tool then
# either says so in one line with exit status 1 and leaves nothing but finished rooms, or does without the memory and writes what it
# writes otherwise; pictures, which a process of its own draws, may be missing, if a line says so.
set -u
tools=$1 plan=$2 library=$3 first=${4%/*} step=1 random=$5 last=$6
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
RANDOM=1
[[ $4 != */* ]] || step=${4#*/}

pipeline() { "$tools"/pcl_indoor_pipeline scan.pcd out/scene -quiet -threads 2; }
rooms() { "$tools"/pcl_room_segmentation scan.pcd out/rooms.pcd -map out/map -json out/rooms.json -quiet -threads 2; }
objects() { "$tools"/pcl_noise_resilient_lccp scan.pcd out/objects.ply -threads 2; }

fail() { echo "$*"; head -c 2000 said; ls -lR out; exit 1; }

try() { # <tool> <n>
  rm -rf out
  mkdir out
  (LD_PRELOAD=$library FAIL_AT=$2 "$1" > /dev/null 2> said)
  local status=$?
  if [ $status -eq 0 ]; then
    local unlike=(-x .unfinished) # which needs memory to be removed
    ! grep -q 'cannot be drawn' said || unlike+=(-x '*.png')
    diff -rq "${unlike[@]}" out "expected_$1" > /dev/null || fail "$1, allocation $2: other results"
    survived=$((survived + 1))
    return
  fi
  [ $status -eq 1 ] || fail "$1, allocation $2: status $status"
  [ "$(grep -vc 'cannot be drawn' said)" -eq 1 ] || fail "$1, allocation $2: not one line"
  [ -z "$(find out -name .unfinished -prune -o -type f -print)" ] || fail "$1, allocation $2: an output beside an error"
}

"$tools"/pcl_scan_simulation "$plan" scan.pcd -leaf 0.16 || exit 1
# no process can be started: the pictures are left out, which one line says, and all else is as ever
for tool in pipeline rooms; do
  rm -rf out with
  mkdir out
  ($tool > /dev/null 2> said) || fail "$tool fails"
  mv out with
  mkdir out
  (LD_PRELOAD=$library FAIL_AT=-1 FAIL_FORK=1 $tool > /dev/null 2> said) || fail "$tool fails where no process can be started"
  diff -rq -x '*.png' out with > /dev/null || fail "$tool writes other results where no process can be started"
  [ -z "$(find out -name '*.png')" ] || fail "$tool draws where no process can be started"
  [ "$(grep -c 'cannot be drawn' said)" -eq 1 ] || fail "$tool does not say once that its pictures are missing"
done

for tool in ${7:-pipeline rooms objects}; do
  rm -rf out
  mkdir out
  (LD_PRELOAD=$library FAIL_AT=0 $tool > /dev/null 2> said) || fail "$tool fails"
  count=$(sed -n 's/ allocations$//p' said)
  mv out expected_$tool
  survived=0
  for ((n = 1; n <= first; n += step)); do
    try $tool $n
  done
  for ((n = 0; n < random; ++n)); do
    try $tool $((1 + (RANDOM * 32768 + RANDOM) % count))
  done
  for ((n = count - last + 1; n <= count; ++n)); do
    try $tool $n
  done
  echo "$tool: $(((first + step - 1) / step + random + last)) of $count allocations failed, $survived of them without harm"
done
