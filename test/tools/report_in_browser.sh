#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# report_in_browser.sh <tools folder> <plan file>: the report's self-test passes in Chromium, wide and as narrow as a
# phone, with and without classes, and the console stays silent. Skipped (77) without chromium.
set -euo pipefail
tools=$1 plan=$2
chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome) ||
  { echo "SKIPPED: chromium is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$tools/pcl_scan_simulation" "$plan" "$folder/scan.pcd" -quiet

# open <page> <width> <name of the profile>
open() {
  HOME=$folder timeout 100 "$chromium" --headless --no-sandbox --disable-dev-shm-usage --disable-background-networking \
    --enable-unsafe-swiftshader --use-angle=swiftshader --user-data-dir="$folder/profile-$3" --window-size="$2,900" \
    --virtual-time-budget=10000 --enable-logging=stderr --dump-dom "file://$1#self-test" 2> "$folder/log" > "$folder/dom" ||
    { tail -n 5 "$folder/log"; echo "chromium fails"; exit 1; }
  if ! grep -q '<title>self-test: passed</title>' "$folder/dom"; then
    grep -o '<title>[^<]*' "$folder/dom" || echo "no title"
    grep CONSOLE "$folder/log" || true
    exit 1
  fi
  # the browser itself remarks that reading pixels back is slow
  if grep 'CONSOLE' "$folder/log" | grep -v 'GPU stall due to ReadPixels'; then
    echo "the console is not silent"
    exit 1
  fi
}

"$tools/pcl_indoor_pipeline" "$folder/scan.pcd" "$folder/out" -quiet
open "$folder/out/report.html" 1400 wide
open "$folder/out/report.html" 500 narrow
"$tools/pcl_indoor_pipeline" "$folder/scan.pcd" "$folder/out" -model none -report "$folder/own.html" -quiet
open "$folder/own.html" 1400 own

# the test can fail
sed 's/return sorted/return 0/; s/nonStructure.filter(isFound)/nonStructure.slice(1)/' "$folder/own.html" > "$folder/wrong.html"
if (open "$folder/wrong.html" 1400 wrong) > /dev/null; then
  echo "the self-test passes on a page that is wrong"
  exit 1
fi
