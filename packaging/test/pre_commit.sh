#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# packaging/test/pre_commit.sh RIGOR PACKAGES: from a repository without any configuration to a commit that the
# real pre-commit blocks, and then to one that it lets through. RIGOR is the program that the hooks of this
# repository run; the wheel and the npm package in PACKAGES are what pre-commit installs by itself. Needs git, pre-commit and npm.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source_tree=$(cd "$here/../.." && pwd)
rigor=$(realpath "$1")
packages=$(realpath "$2")

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Nothing of this machine's user counts, and nothing is left behind.
export HOME=$work PRE_COMMIT_HOME=$work/cache GIT_CONFIG_NOSYSTEM=1 RIGOR_CACHE=off npm_config_offline=true PIP_NO_INDEX=1
git config --global user.name Somebody
git config --global user.email somebody@example.com
git config --global init.defaultBranch main
git config --global protocol.file.allow always
mkdir "$work/bin"
ln -s "$rigor" "$work/bin/rigor"

passed=0 failed=0
ok() { echo "ok: $*"; passed=$((passed + 1)); }
bad() {
  echo "FAILED: $*"
  failed=$((failed + 1))
  [ ! -e "$work/said" ] || cat "$work/said"
}

# The manifest as a repository of its own, so that what is not committed yet is tested too.
git init -q "$work/hooks"
cp "$source_tree/.pre-commit-hooks.yaml" "$work/hooks/"
git -C "$work/hooks" add -A
git -C "$work/hooks" commit -qm 'Hooks'
revision=$(git -C "$work/hooks" rev-parse HEAD)

# repository NAME: one with a broken model, a sane one and a text that is none of rigor's business.
repository() {
  rm -rf "${work:?}/$1"
  git init -q "$work/$1"
  cd "$work/$1"
  mkdir models
  cp "$here/broken.sdf" models/
  sed 's/boby/world/' "$here/broken.sdf" >models/sane.sdf
  echo 'a robot' >notes.txt
  git add -A
}

commit() { git commit -qm 'Add robots' >"$work/said" 2>&1; }

# blocks_and_lets_through WHAT: in the current repository, whose configuration is staged.
blocks_and_lets_through() {
  if commit; then
    bad "$1: the commit of a broken model went through"
    return
  fi
  if grep -q 'joint-parent-missing' "$work/said" && grep -q 'models/broken.sdf:11:15' "$work/said" &&
      ! grep -q 'sane.sdf' "$work/said"; then
    ok "$1 blocks the commit of a broken model, and says where it is broken"
  else
    bad "$1: the commit is blocked by something else"
  fi
  sed -i 's/boby/world/' models/broken.sdf
  git add -A
  if commit; then ok "$1 lets the mended model through"; else bad "$1 blocks the mended model"; fi
}

# ---- The hooks of this repository, with a rigor that is installed

begin=$(date +%s.%N)
repository plain
cat >.pre-commit-config.yaml <<YAML
repos:
  - repo: $work/hooks
    rev: $revision
    hooks:
      - id: rigor-validate
YAML
git add -A
pre-commit install >/dev/null
PATH=$work/bin:$PATH blocks_and_lets_through rigor-validate
awk -v from="$begin" -v to="$(date +%s.%N)" 'BEGIN { printf "both commits: %.1f s\n", to - from }'

repository inertia
sed 's/<ixx>0.1</<ixx>9</' "$here/broken.sdf" | sed 's/boby/world/' >models/broken.sdf
sed 's/id: rigor-validate/id: rigor-inertia/' ../plain/.pre-commit-config.yaml >.pre-commit-config.yaml
git add -A
pre-commit install >/dev/null
if PATH=$work/bin:$PATH commit; then
  bad 'rigor-inertia lets an impossible inertia through'
elif grep -q '\[inertia-[a-z-]*\]' "$work/said"; then
  ok 'rigor-inertia blocks an impossible inertia'
else
  bad 'rigor-inertia fails for another reason'
fi

repository fix
sed 's/boby/world/; s/"axle" type/"axle"type/' "$here/broken.sdf" >models/broken.sdf
sed 's/id: rigor-validate/id: rigor-fix/' ../plain/.pre-commit-config.yaml >.pre-commit-config.yaml
git add -A
pre-commit install >/dev/null
if PATH=$work/bin:$PATH commit; then
  bad 'rigor-fix lets through what it should have mended'
elif grep -q 'files were modified by this hook' "$work/said" && cmp -s models/broken.sdf models/sane.sdf; then
  ok 'rigor-fix mends what has a safe fix, and shows it'
  git add -A
  if PATH=$work/bin:$PATH commit; then ok 'then it lets the model through'; else bad 'rigor-fix blocks the mended model'; fi
else
  bad 'rigor-fix fails for another reason'
fi

# ---- What pre-commit installs by itself

# installs LANGUAGE PACKAGE VERSION: a repository whose hook has pre-commit install PACKAGE.
installs() {
  local begin
  begin=$(date +%s.%N)
  repository "$1"
  cat >.pre-commit-config.yaml <<YAML
repos:
  - repo: local
    hooks:
      - id: rigor-validate
        name: rigor validate
        language: $1
        language_version: $3
        additional_dependencies: ["$2"]
        entry: rigor validate --force-exclude
        files: '\.(sdf|world|urdf|srdf|xacro)$|(^|/)model\.config$'
        require_serial: true
YAML
  git add -A
  pre-commit install >/dev/null
  blocks_and_lets_through "$(basename "$2")"
  awk -v from="$begin" -v to="$(date +%s.%N)" 'BEGIN { printf "both commits: %.1f s\n", to - from }'
}

installs python "$(ls "$packages"/rigor-*.whl)" default
installs node "$(ls "$packages"/rigor-robot-*.tgz)" system

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
