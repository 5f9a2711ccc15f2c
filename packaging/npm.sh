#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# packaging/npm.sh ROOT OUT: an npm package of what packaging/tarball.sh packed from ROOT.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$1 out=$(cd "$2" && pwd)

version=$("$root/bin/rigor" --version --format json | sed -n 's/.*"version": *"\([^"]*\)".*/\1/p' | head -n 1)
case $(uname -m) in
  x86_64) cpu=x64 ;;
  aarch64) cpu=arm64 ;;
  *) cpu=$(uname -m) ;;
esac
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT
cp -r "$root/bin" "$root/lib" "$root/libexec" "$root/share" "$stage/"
cp "$root/share/doc/LICENSE" "$stage/LICENSE"
sed "s/@VERSION@/$version/; s/@CPU@/$cpu/" "$here/npm/package.json.in" >"$stage/package.json"
sed "s/@VERSION@/$version/" "$here/npm/README.md" >"$stage/README.md"
(cd "$stage" && npm pack --silent --pack-destination "$out" >/dev/null)
