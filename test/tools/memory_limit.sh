#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# memory_limit.sh <tool>
# A scan that needs more memory than there may be is refused from its header alone, in one line.
set -u
tool=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1

fail() { echo "$*"; cat said; ls; exit 1; }

printf 'VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2000000000\nHEIGHT 1\nPOINTS 2000000000\nDATA binary\n' > large.pcd
printf 'ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n' > large.ply
for scan in large.pcd large.ply; do
  "$tool" $scan out.pcd -memory_limit 20 2> said && fail "$scan is not refused"
  [ "$(wc -l < said)" -eq 1 ] || fail "not one line"
  grep -qE "$scan: its 2000000000 points need about [0-9.]+ GB of memory, the limit is 20.00 GB; .*-memory_limit" said \
    || fail "the line names neither need nor limit"
  [ ! -e out.pcd ] || fail "an output beside an error"
  "$tool" $scan out.pcd -memory_limit 1e9 2> said && fail "$scan is not refused"
  grep -q "truncated" said || fail "with no limit the scan is not read"
done
"$tool" large.pcd out.pcd 2> said && fail "the default is no limit"
exit 0
