#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# Converts models of testdata to MJCF and compiles the results in the MuJoCo that npm has. Its package is fetched
# into the build folder, once. Exit code 77, which CTest takes for skipped, where it cannot be had.
#
#   load.sh RIGOR BUILD_FOLDER MODEL...
set -eu
here=$(cd "$(dirname "$0")" && pwd)
rigor=$1 work=$2/mjcf_test
shift 2
mkdir -p "$work"
cp "$here/package.json" "$here/load.mjs" "$work"
(cd "$work" && { [ -d node_modules/@mujoco/mujoco ] || npm install --no-audit --no-fund --silent; }) || exit 77
rm -rf "$work/robots"
scenes=()
for model in "$@"; do
  format=sdf
  case $model in *.urdf) format=urdf ;; esac
  folder=$work/robots/${#scenes[@]}
  mkdir -p "$folder"
  "$rigor" "${format}2mjcf" "$model" -o "$folder/robot.xml" --fail-on never >"$folder/report.txt" 2>&1 || {
    cat "$folder/report.txt"
    exit 1
  }
  scenes+=("$folder/scene.xml")
done
cd "$work"
node load.mjs "${scenes[@]}"
