#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# packaging/test/action.sh PACKAGES: does what a GitHub runner does with action.yml, with the release served from
# a folder: fills in the inputs, runs the steps in order, hands PATH and outputs on. Needs curl and python3-yaml.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source_tree=$(cd "$here/../.." && pwd)
packages=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

passed=0 failed=0
ok() { echo "ok: $*"; passed=$((passed + 1)); }
bad() {
  echo "FAILED: $*"
  failed=$((failed + 1))
  cat "$work/said"
}

tarball=$(basename "$packages"/rigor-*-linux-*.tar.gz)
version=${tarball#rigor-}
version=${version%%-linux-*}
release=$work/server/somebody/rigor/releases/download/v$version
mkdir -p "$release"
cp "$packages/$tarball" "$release/"
(cd "$release" && sha256sum -- * >SHA256SUMS)

# run_action KEY=VALUE...: the steps of action.yml with these inputs, in the folder of the models.
run_action() {
  rm -rf "$work/runner" "$work/models"
  mkdir -p "$work/runner" "$work/models"
  cp "$here/broken.sdf" "$work/models/"
  touch "$work/runner/path" "$work/runner/output"
  /usr/bin/python3 - "$source_tree/action.yml" "$work/runner" "file://$work/server" "$@" <<'PYTHON'
import re, shlex, sys, yaml

action, runner, server = sys.argv[1:4]
action = yaml.safe_load(open(action))
given = dict(argument.split("=", 1) for argument in sys.argv[4:])
inputs = {name: given.pop(name, each.get("default", "")) for name, each in action["inputs"].items()}
assert not given, f"action.yml has no input {given}"
known = {f"inputs.{name}": str(value) for name, value in inputs.items()}
known |= {"github.action_repository": "somebody/rigor", "github.server_url": server, "runner.temp": runner}
ids = {step.get("id") for step in action["runs"]["steps"]}
for output in action["outputs"].values():
    assert re.fullmatch(r"\$\{\{ steps\.(\w+)\.outputs\.[\w-]+ \}\}", output["value"])[1] in ids
for number, step in enumerate(action["runs"]["steps"]):
    assert step["shell"] == "bash"
    with open(f"{runner}/step{number}.sh", "w") as script:
        for name, value in step["env"].items():
            value = re.sub(r"\$\{\{ (.*?) \}\}", lambda match: known[match[1]], str(value))
            script.write(f"export {name}={shlex.quote(value)}\n")
        script.write(step["run"] + "\n")
PYTHON
  (
    cd "$work/models"
    export GITHUB_ACTION_PATH=$source_tree GITHUB_PATH=$work/runner/path GITHUB_OUTPUT=$work/runner/output
    for step in "$work"/runner/step*.sh; do
      while read -r folder; do PATH=$folder:$PATH; done <"$GITHUB_PATH"
      bash --noprofile --norc -eo pipefail "$step" || exit  # as the runner calls it
    done
  ) >"$work/said" 2>&1
}

code=0
run_action version="$version" || code=$?
if [ "$code" -eq 1 ] && grep -q '^::error .*file=broken\.sdf,line=11,' "$work/said" &&
    /usr/bin/python3 -c 'import json, sys; assert json.load(open(sys.argv[1]))["runs"][0]["results"]' \
      "$work/models/rigor.sarif" && grep -qx 'sarif=rigor.sarif' "$work/runner/output"; then
  ok 'annotates, writes SARIF and fails the job'
else
  bad "exit code $code"
fi

code=0
run_action version="$version" fail-on=never sarif= paths='broken.sdf' arguments='--select reference' || code=$?
if [ "$code" -eq 0 ] && [ ! -e "$work/models/rigor.sarif" ] && grep -qx 'exit-code=0' "$work/runner/output"; then
  ok 'inputs are taken'
else
  bad "exit code $code"
fi

code=0
run_action version="$version" sha256=0000000000000000000000000000000000000000000000000000000000000000 || code=$?
if [ "$code" -eq 2 ] && grep -q '^::error::rigor: .* has the checksum' "$work/said"; then
  ok 'refuses a tarball with another checksum'
else
  bad "exit code $code"
fi

code=0
# shellcheck disable=SC2016
run_action version='0.1.0$(touch evil)' || code=$?
if [ "$code" -eq 2 ] && [ ! -e "$work/models/evil" ]; then ok 'an input is never run'; else bad "exit code $code"; fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
