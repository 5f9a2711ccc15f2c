#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# Runs `rigor validate`: annotations for the pull request, and SARIF for code scanning, in one run.
# RIGOR_PATHS and RIGOR_ARGUMENTS (words, each on a line of its own or between blanks), RIGOR_FAIL_ON, RIGOR_SARIF.
set -euo pipefail

read -r -d '' -a paths <<<"$RIGOR_PATHS" || true
read -r -d '' -a arguments <<<"$RIGOR_ARGUMENTS" || true
options=(--output github --fail-on "$RIGOR_FAIL_ON")
if [ -n "$RIGOR_SARIF" ]; then
  options+=(--output "sarif:$RIGOR_SARIF")
  echo "sarif=$RIGOR_SARIF" >>"$GITHUB_OUTPUT"
fi
# Models of a pull request are somebody else's, and the log may be read by anybody.
if [[ "${GITHUB_EVENT_NAME:-}" == pull_request* && " ${arguments[*]-} " != *" --confine"* ]]; then
  options+=(--confine .)
fi
code=0
rigor validate "${options[@]}" ${arguments[@]+"${arguments[@]}"} -- "${paths[@]}" || code=$?
echo "exit-code=$code" >>"$GITHUB_OUTPUT"
exit "$code"
