#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# scene_schema.sh <tools folder> <plan file> <schema>: what the pipeline writes fits the schema, with and without
# classes, in other units and with another axis up; and the schema refuses what is wrong. Skipped (77) without
# python3-jsonschema.
set -euo pipefail
tools=$1 plan=$2 schema=$3
python3 -c 'import jsonschema' 2> /dev/null || { echo "SKIPPED: python3-jsonschema is not installed"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$tools/pcl_scan_simulation" "$plan" "$folder/scan.pcd" -quiet

validate() {
  python3 - "$schema" "$1" << 'END'
import json, sys
import jsonschema
schema, scene = (json.load(open(name, encoding="utf-8")) for name in sys.argv[1:])
validator = jsonschema.validators.validator_for(schema)
validator.check_schema(schema)
errors = list(validator(schema).iter_errors(scene))
for error in errors[:5]:
    print("/".join(map(str, error.absolute_path)), error.message[:200])
sys.exit(1 if errors else 0)
END
}

number=0
for options in "" "-model none" "-up -y -unit ft" "-voxel_resolution 0.05 -partition lccp -threads 1"; do
  # shellcheck disable=SC2086 # options are words
  "$tools/pcl_indoor_pipeline" "$folder/scan.pcd" "$folder/out" $options -quiet 2> "$folder/said" ||
    { cat "$folder/said"; exit 1; }
  validate "$folder/out/scene.json" || { echo "with options '$options'"; exit 1; }
  number=$((number + 1))
done
[ $number -eq 4 ]
"$tools/pcl_indoor_pipeline" "$folder/scan.pcd" "$folder/scan.pcd" "$folder/stations" -quiet # one stands twice
validate "$folder/stations/scene.json" || { echo "of several scans"; exit 1; }

spoil() {
  python3 - "$folder/out/scene.json" "$1" > "$folder/wrong.json" << 'END'
import json, sys
scene = json.load(open(sys.argv[1], encoding="utf-8"))
exec(sys.argv[2])
json.dump(scene, sys.stdout)
END
  if validate "$folder/wrong.json" > /dev/null; then
    echo "The schema accepts a scene after: $1"
    exit 1
  fi
}

spoil 'scene["version"] = 1'
spoil 'del scene["walls"]'
spoil 'scene["walls"][0]["thickness"] = 0'
spoil 'scene["openings"][0]["kind"] = "gate"'
spoil 'del scene["axes"]'
spoil 'scene["rooms"][0]["area"] = -1'
spoil 'scene["rooms"][0]["name"] = "garage"'
spoil 'scene["rooms"][0]["name_probability"] = 1.1'
spoil 'del scene["rooms"][0]["name_top"][0]'
spoil 'scene["objects"][0]["points"] = 99'
spoil 'scene["objects"][0]["upright_box"]["size"] = [1, 2]'
