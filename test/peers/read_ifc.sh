#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# read_ifc.sh TOOLS PLAN.json [FOLDER]: scans a building, writes it as IFC and lets two programs read it that are not of
# this project: web-ifc (npm) and IfcPlusPlus (Debian's libifcplusplus-dev). Both must read it without a complaint, and as
# many elements as the scene has; the areas of spaces are compared with the plan. Takes node, npm, g++ and python3.
set -euo pipefail
tools=$(realpath "$1") plan=$(realpath "$2") here=$(realpath "$(dirname "$0")")
folder=${3:-$(mktemp -d)}
mkdir -p "$folder" && cd "$folder"

"$tools/pcl_scan_simulation" "$plan" scan.pcd -json truth.json -quiet
"$tools/pcl_indoor_pipeline" scan.pcd result -quiet
"$tools/pcl_indoor_export" result/scene.json building.ifc
[ -d node_modules/web-ifc ] || npm install --no-fund --no-audit --silent web-ifc
g++ -std=c++17 -w "$here/read_ifc.cpp" -o read_ifc -I/usr/include/ifcpp -lIfcPlusPlus
NODE_PATH=$PWD/node_modules node "$here/read_ifc.js" building.ifc > web_ifc.txt 2>&1
./read_ifc building.ifc > ifcplusplus.txt
python3 "$here/compare_ifc.py" result/scene.json truth.json web_ifc.txt ifcplusplus.txt
