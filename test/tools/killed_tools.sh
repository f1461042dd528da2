#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# killed_tools.sh <folder of the tools> <plan> <number of random moments> [tool]...
# Kills (kill -9) each of the tools that write files and that killed_runs.sh does not kill, at random moments. Every
# file under its final name must be whole: that of the run before or that of this run. Of a training that was killed,
# the same command goes on, and ends with the model of one that was not.
set -u
tools=$1 plan=$2 moments=$3
shift 3
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
RANDOM=${SEED:=$RANDOM}
echo "seed $SEED" # the same moments again: SEED=...

"$tools"/pcl_scan_simulation "$plan" scan.pcd -leaf 0.12 -json scan.json -quiet || exit 1
"$tools"/pcl_hough_normals scan.pcd object.pcd -quiet || exit 1
"$tools"/pcl_segment_collection scan.pcd objects -names scan.json -min_points 20 -quiet || exit 1
cp -r objects pairs # classes with something to train and something to test with
for class in pairs/*; do [ "$(find "$class" -type f | wc -l)" -ge 2 ] || rm -r "$class"; done
mkdir -p room/Annotations # as in S3DIS
for object in chair_1 wall_1; do
  awk -v n="${#object}" 'BEGIN { srand(n); for (i = 0; i < 30000; ++i) print rand(), rand(), rand(), n, 0, 0 }' > room/Annotations/$object.txt
done
model=$(realpath "$tools")/../share/pcl_indoor/indoor_objects.model

# each: <1|2>, by which an option and the results differ
objects() { exec "$tools"/pcl_noise_resilient_lccp scan.pcd now/cloud.ply -colour "$([ "$1" = 1 ] && echo object || echo height)"; }
normals() { exec "$tools"/pcl_hough_normals scan.pcd now/cloud.pcd -k 1"$1"; }
simulation() { exec "$tools"/pcl_scan_simulation "$plan" now/cloud.pcd -json now/scan.json -leaf 0.12 -seed "$1" -rays_per_pose 5000; }
descriptor() { exec "$tools"/pcl_eppf_estimation object.pcd now/descriptor.pcd -seed "$1"; }
evaluation() { exec "$tools"/pcl_segmentation_evaluation scan.pcd scan.pcd -truth_field object -predicted_field room -ignore "$1" -json now/result.json; }
collection() { exec "$tools"/pcl_segment_collection scan.pcd now/classes -names scan.json -min_points "$1"00; }
examples() { exec "$tools"/pcl_joining_examples scan.pcd now/examples -seed "$1"; }
classes() { exec "$tools"/pcl_eppf_classify "$model" "$([ "$1" = 1 ] && echo object || echo scan)".pcd -json now/classes.json; }
dataset() { exec "$tools"/pcl_dataset_scan room now/cloud.pcd -json now/names.json -structure "$([ "$1" = 1 ] && echo wall || echo chair,wall)"; }
comparison() {
  exec "$tools"/pcl_lccp_comparison scan.pcd -truth_field "$([ "$1" = 1 ] && echo object || echo room)" -json now/result.json \
    -picture now/picture.png
}
retrieval() {
  exec "$tools"/pcl_eppf_retrieval objects -descriptors eppf_short -distances "l$1" -repeats 2 -noise 0,"$1" -json now/result.json \
    -confusion now/confusion.txt -confusion_picture now/confusion.png -plot now/plot.png
}
training() {
  exec "$tools"/pcl_eppf_train pairs now/net.model -network perceptron -hidden 16 -draws 1 -epochs 3 -seed "$1" -split random:0.5 \
    -curves now/curves.png -confusion now/confusion.png -checkpoint now/checkpoint
}

fail() { echo "$*"; ls -lR now; exit 1; }

# What a run measures of itself differs each time.
unmeasured() { sed -E '/"milliseconds_per_object"/,/\}/d; /"(seconds|megabytes|seconds_all_distances)":/d' "$1"; }

is_of() { # <old|new> <file>
  case $tool:$2 in
    comparison:*.json | retrieval:*.json)
      tail -c 2 "now/$2" | grep -q '}' && cmp -s <(unmeasured "now/$2") <(unmeasured "$1/$2") ;;
    *) cmp -s "now/$2" "$1/$2" ;;
  esac
}

goes_on() { # as if it had not been killed
  (training 2 > /dev/null) && cmp -s now/net.model new/net.model
}

all=(objects normals simulation descriptor evaluation collection examples classes dataset comparison retrieval)
[ ! -x "$tools"/pcl_eppf_train ] || all+=(training) # built where libtorch is
[ $# -eq 0 ] || all=("$@")
for tool in "${all[@]}"; do
  rm -rf old new
  for run in 1 2; do
    rm -rf now
    mkdir now
    ($tool $run -quiet > /dev/null) || fail "$tool fails"
    rm -f now/checkpoint # of another seed, which no training goes on from
    mv now "$([ $run = 1 ] && echo old || echo new)"
  done
  diff -rq old new > /dev/null && fail "$tool: the two runs do not differ"
  begin=$(date +%s%N)
  rm -rf now
  mkdir now
  ($tool 2 > /dev/null) || fail "$tool fails"
  length=$((($(date +%s%N) - begin) / 1000000 + 1)) # milliseconds
  amid=0
  for ((moment = 0; moment < moments; ++moment)); do
    rm -rf now
    cp -r old now
    $tool 2 > /dev/null &
    delay=$(((RANDOM * 32768 + RANDOM) % length))
    sleep "$((delay / 1000)).$(printf '%03d' $((delay % 1000)))"
    kill -KILL $! 2> /dev/null
    wait $! 2> /dev/null
    [ $? -ne 137 ] || amid=$((amid + 1))
    while IFS= read -r file; do
      is_of old "$file" || is_of new "$file" || fail "$tool: $file is neither the old nor the new one"
    done < <(cd now && find . -type f ! -name '*.part*' ! -name checkpoint)
    [ "$tool" != training ] || goes_on || fail "$tool: it does not go on as if it had not been killed"
  done
  echo "$tool: ended amid its work at $amid of $moments random moments"
  all_moments=$((${all_moments:-0} + moments)) all_amid=$((${all_amid:-0} + amid))
done 2> /dev/null # bash tells of each program that is killed
[ $((3 * all_amid)) -ge "$all_moments" ] || fail "too few were ended amid their work to tell anything"
