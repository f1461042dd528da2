#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# documentation.sh <tools folder>: every tool has a man page and a completion that know all of its options.
set -euo pipefail
tools=$1
for tool in "$tools"/pcl_*; do
  name=$(basename "$tool")
  man=$tools/documentation/man/$name.1 completion=$tools/documentation/completions/$name
  mapfile -t options < <("$tool" -h | awk '/^    -/ { print $1 }')
  [ ${#options[@]} -ge 3 ]
  # shellcheck disable=SC1090
  source "$completion"
  COMP_WORDS=("$name" -) COMP_CWORD=1
  "_$name"
  [ "${COMPREPLY[*]}" = "${options[*]}" ] || { echo "$name completes - to ${COMPREPLY[*]}"; exit 1; }
  for option in "${options[@]}"; do
    grep -qF -- "${option//-/\\-}" "$man" || { echo "the man page of $name lacks $option"; exit 1; }
  done
  if command -v groff > /dev/null; then
    said=$(groff -ww -man -Tascii "$man" 2>&1 > /dev/null)
    [ -z "$said" ] || { echo "$said"; exit 1; }
  fi
done
COMP_WORDS=(pcl_indoor_pipeline -partition l) COMP_CWORD=2
_pcl_indoor_pipeline
[ "${COMPREPLY[*]}" = lccp ]
COMP_WORDS=(pcl_indoor_pipeline -vox) COMP_CWORD=1
_pcl_indoor_pipeline
[ "${COMPREPLY[*]}" = "-voxel_size -voxel_resolution" ]
