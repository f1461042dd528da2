#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# without_torch.sh <cmake> <source folder>: OFF never looks for libtorch, AUTO says what is missing where there is none,
# ON fails there.
set -euo pipefail
cmake=$1 source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

configure() {
  rm -rf "$folder/build"
  "$cmake" -S "$source" -B "$folder/build" -Wno-dev -DPCL_INDOOR_BUILD_TOOLS=OFF -DPCL_INDOOR_BUILD_TESTS=OFF "$@" \
    > "$folder/log" 2>&1
}

says() {
  tr -s '\n ' ' ' < "$folder/log" | grep -q "$1"
}

fail() {
  echo "$1:"
  cat "$folder/log"
  exit 1
}

without=-DCMAKE_DISABLE_FIND_PACKAGE_Torch=ON # as if there was none
configure -DPCL_INDOOR_WITH_TORCH=OFF || fail "Configuring without libtorch fails"
! grep -q Torch_DIR "$folder/build/CMakeCache.txt" || fail "OFF looks for libtorch"
! "$cmake" --build "$folder/build" --target help | grep -q training || fail "OFF has a target for training"
configure -DPCL_INDOOR_WITH_TORCH=AUTO "$without" || fail "AUTO fails where there is no libtorch"
says "libtorch is not found.*pcl_indoor::training" || fail "AUTO does not say what is left out"
! configure -DPCL_INDOOR_WITH_TORCH=ON "$without" || fail "ON does without libtorch"
says "libtorch is not found: install libtorch-dev" || fail "ON does not say what is missing"
