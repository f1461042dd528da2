#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# reader_coverage.sh <fuzz_readers compiled for gcov> <folder of its objects> <corpus>
# Gives each reader 20,000 changed files; prints for each of its sources the lines and the share of them that was reached.
set -eu
program=$1 objects=$2 corpus=$3
folder=$(mktemp -d /dev/shm/reader_coverage.XXXXXX 2> /dev/null || mktemp -d) # in memory: files are many
trap 'rm -rf "$folder"' EXIT
cd "$folder"
find "$objects" -name '*.gcda' -delete
"$program" "$corpus" 20000x
find "$objects" -name '*.gcda' ! -name 'fuzz_readers*' -exec gcov --no-output {} + 2> /dev/null | awk '
  /^File / { file = $2; gsub(/\047/, "", file); sub(/.*\//, "", file) }
  /^Lines executed:/ && file ~ /\.cpp$/ {
    split($0, part, /[:% ]+/)
    printf "%-22s %5d lines %6.1f %%\n", file, part[5], part[3]
    lines += part[5]; reached += part[5] * part[3] / 100; file = ""
  }
  END { printf "%-22s %5d lines %6.1f %%\n", "all", lines, 100 * reached / lines }' | sort
