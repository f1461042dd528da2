#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# headers.sh <folder of the sources>
# Every public header must be named in docs/guide/headers.md, and every header that is named there must exist.
set -u
cd "$1" || exit 1
headers=$(find ./*/include ml/*/include -name '*.h' | sed 's#.*/include/##' | sort)
status=0
named=$(grep -o '[a-z_/]*\.h`' docs/guide/headers.md | tr -d '`' | sed 's#.*/##' | sort)
while read -r header; do
  grep -qx "${header##*/}" <<< "$named" || { echo "docs/guide/headers.md does not name $header"; status=1; }
done <<< "$headers"
while read -r name; do
  grep -qE "(^|/)$name\$" <<< "$headers" || { echo "docs/guide/headers.md names $name, which is not there"; status=1; }
done <<< "$named"
exit $status
