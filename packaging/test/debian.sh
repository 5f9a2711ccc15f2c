#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# debian.sh BUILD WORK: makes the Debian packages of a release build in the folder WORK, and asks lintian of them.
set -euo pipefail
build=$1 work=$2
rm -rf "$work"
mkdir -p "$work"
cpack --config "$build/CPackConfig.cmake" -B "$work" >/dev/null
lintian --fail-on error,warning "$work"/*.deb
