#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# restarted_runs.sh <folder of the tools> <plan> <library kill_at_step> <number of random moments>
# Kills pcl_indoor_pipeline (kill -9) and starts it again with the same command, until it ends: all files must be those
# of a run that was not killed, and no work file may be left. What is
# finished is not done again. After another command, or with damaged work files, all is as new.
set -u
tools=$1 plan=$2 library=$3 moments=$4
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
export ASAN_OPTIONS=verify_asan_link_order=0

fail() { echo "$*"; ls -lAR now; exit 1; }

"$tools"/pcl_scan_simulation "$plan" scan.pcd -leaf 0.12 -quiet || exit 1
"$tools"/pcl_scan_simulation "$plan" other.pcd -leaf 0.12 -seed 2 -quiet || exit 1

run() { exec "$tools"/pcl_indoor_pipeline "${scan:-scan.pcd}" now -up z -quiet "$@"; } # in a process of its own

as_new() { # <when>: now holds the results of an undisturbed run, and no more
  diff -rq -x '*.part*' now expected > differences || fail "$1: $(cat differences)"
}

killed_at() { # <step> <options>: kills it before the step
  local step=$1
  shift
  (export LD_PRELOAD=$library KILL_AT=$step; run "$@")
  [ $? -eq 137 ] || fail "it was not killed"
}

a_room() { find now/.unfinished -name 'room_?' 2> /dev/null | sort | head -n 1; } # that is finished

begin=$(date +%s%N)
(run) || fail "the pipeline fails"
length=$((($(date +%s%N) - begin) / 1000000 + 1)) # milliseconds
mv now expected

# a few steps in each run; what is finished is not done again
numbers() { (cd now/.unfinished 2> /dev/null && ls -i1 | grep -v part); } # of the files, and their names
for ((starts = 1; starts < 100; ++starts)); do
  before=$(numbers)
  (export LD_PRELOAD=$library KILL_AT=$((starts < 9 ? 5 : 99)); run -threads 2)
  status=$?
  [ $status -eq 137 ] || break
  [ -z "$(comm -23 <(sort <<< "$before") <(numbers | sort))" ] || fail "start $starts makes finished files again"
done
[ $status -eq 0 ] && [ $starts -eq 9 ] || fail "it ends with start $starts, status $status"
grep -q room_ <<< "$before" || fail "no room was finished in eight starts"
as_new "after $starts starts"

# at random moments, with several threads
again=0
for ((moment = 0; moment < moments; ++moment)); do
  rm -rf now
  for ((start = 0; start < 3; ++start)); do
    run -threads $((1 + RANDOM % 3)) &
    sleep "$(printf '%d.%03d' $((RANDOM % length / 1000)) $((RANDOM % length % 1000)))"
    kill -KILL $! 2> /dev/null
    wait $! 2> /dev/null
    [ $? -ne 137 ] || again=$((again + 1))
  done
  [ ! -e now/.unfinished/scene ] || kept=$((${kept:-0} + 1))
  (run) || fail "the start after moment $moment fails"
  as_new "moment $moment"
done
echo "killed $again times in $moments runs, of which ${kept:-0} went on from finished rooms"

# other settings, another scan: nothing of the first run is used
rm -rf now
killed_at 13
[ -e "$(a_room)" ] || fail "no room was finished in time"
(run -voxel_resolution 0.05) || fail "other settings fail"
mv now changed
(run -voxel_resolution 0.05) || fail "other settings fail"
diff -rq -x '*.part*' now changed || fail "other settings use what was found with the first"
rm -rf now changed
killed_at 13
(scan=other.pcd; run) || fail "the other scan fails"
mv now changed
(scan=other.pcd; run) || fail "the other scan fails"
diff -rq -x '*.part*' now changed || fail "the other scan uses what was found in the first"

# how results are shown does not matter for what was found
rm -rf now
killed_at 13
before=$(numbers)
killed_at 4 -colour room -report none
[ -n "$before" ] && [ -z "$(comm -23 <(sort <<< "$before") <(numbers | sort))" ] || fail "other colours make rooms again"

# what another command has left is removed, which a line says
(run -voxel_resolution 0.05) 2> said
grep -q 'unfinished is removed' said || fail "it is not said that finished rooms are removed"

# two runs do not share a folder
rm -rf now
run &
first=$!
while [ ! -e now/.unfinished/lock ] && kill -0 $first 2> /dev/null; do sleep 0.01; done
kill -STOP $first
(run) 2> said && fail "a second run uses the folder of the first"
grep -q 'another run is at work' said || fail "not said: $(cat said)"
kill -CONT $first
wait $first || fail "the first of two runs fails"
as_new "beside a second run"

# damaged and missing files are done again
while IFS='|' read -r file damage; do
  rm -rf now
  killed_at 13
  target=now/.unfinished/$file
  [ "$file" != room ] || target=$(a_room)
  eval "${damage//FILE/$target}"
  (run < /dev/null) || fail "after '$damage' of $file it fails"
  as_new "after '$damage' of $file"
done << 'END'
scene|truncate -s -1 FILE
room|printf x > byte; dd if=byte of=FILE conv=notrunc bs=1 seek=60 status=none
run|truncate -s 0 FILE
room|rm FILE
END

# what others have put into the folder stays
rm -rf now
killed_at 13
echo mine > now/.unfinished/notes
(run) || fail "with a foreign file it fails"
[ "$(ls -A now/.unfinished)" = notes ] || fail "the foreign file is gone, or more is left"

# a full disk gives one line
rm -rf now
(ulimit -f 40; run) 2> said && fail "it needs no disk"
[ "$(wc -l < said)" -eq 1 ] || fail "not one line: $(cat said)"
grep -q 'cannot be written' said || fail "the line does not say why: $(cat said)"
(run) || fail "after a full disk it does not go on"
as_new "after a full disk"
