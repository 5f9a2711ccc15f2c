#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# run.sh BUILD WORK: packs the extension with the program of BUILD, installs it into a VS Code that npm fetches into WORK,
# and works in it with a browser (drive.mjs). Exit code 77, which CTest takes for skipped, where something is missing, unless
# RIGOR_REQUIRE_BROWSER is in the environment; 77 in any case where npm fetches nothing. RIGOR_REWRITE_GOLDEN=1 writes the pictures of docs/images.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source_tree=$(cd "$here/../../.." && pwd)
build=$(cd "$1" && pwd)
mkdir -p "$2"
work=$(cd "$2" && pwd)

leave() {
  echo "the extension for VS Code is not tested: $1" >&2
  [ -z "${RIGOR_REQUIRE_BROWSER:-}" ] || exit 1
  exit 77
}

# What the network denies is no fault of the extension, required or not.
not_fetched() {
  echo "the extension for VS Code is not tested: $1" >&2
  exit 77
}

browser=${RIGOR_CHROMIUM:-/usr/bin/chromium}
[ -x "$browser" ] || leave "there is no $browser (apt install chromium)"
command -v npm >/dev/null || leave 'npm is not installed'
[ "$(node -p 'process.versions.node.split(".")[0]')" -ge 20 ] || leave 'it needs node 20 or later'
command -v strip >/dev/null || leave 'binutils are not installed'

# code-server is the workbench and the extension host of VS Code, served to a browser. Of its native modules the one for
# terminals is built; the others are for watching files and for passwords; the last is asked for even without one.
if ! cmp -s "$here/package-lock.json" "$work/fetched"; then
  cp "$here/package.json" "$here/package-lock.json" "$work"
  options=(--ignore-scripts --force --no-audit --no-fund --loglevel=error)
  (cd "$work" && npm ci "${options[@]}") || not_fetched 'npm could not fetch code-server'
  # It has a shrinkwrap of its own, which `npm ci` finds incomplete.
  (cd "$work/node_modules/code-server/lib/vscode" && npm install --omit=dev "${options[@]}") ||
    not_fetched 'npm could not fetch what VS Code is made of'
  echo "module.exports = {hash: async () => '', verify: async () => false};" >"$work/node_modules/argon2/argon2.js"
  cp "$here/package-lock.json" "$work/fetched"
fi

# With a compiler and node's headers.
pty="$work/node_modules/code-server/lib/vscode/node_modules/node-pty"
node_folder=$(dirname "$(dirname "$(readlink -f "$(command -v node)")")")
for gyp in "$(npm root -g)/npm/node_modules/node-gyp" /usr/share/nodejs/node-gyp; do
  [ ! -e "$pty/build/Release/pty.node" ] && [ -e "$gyp/bin/node-gyp.js" ] && [ -e "$node_folder/include/node/node.h" ] || continue
  (cd "$pty" && node "$gyp/bin/node-gyp.js" rebuild --nodedir="$node_folder") >"$work/node-pty.log" 2>&1 || true
done
[ ! -e "$pty/build/Release/pty.node" ] || export RIGOR_TERMINALS=1

rm -rf "$work/root" "$work/extensions" "$work/user" "$work"/*.vsix
mkdir -p "$work/root/bin"
for program in rigor rigor-worker rigor-page-server.so rigor-collider.so; do
  strip -o "$work/root/bin/$program" "$build/$program"
done
vsix=$("$source_tree/packaging/vsix.py" "$work/root" "$work" "$work/extension")
code=(node "$work/node_modules/code-server/out/node/entry.js" --config "$work/config.yaml"
      --user-data-dir "$work/user" --extensions-dir "$work/extensions")
echo 'auth: none' >"$work/config.yaml"
"${code[@]}" --install-extension "$vsix" >"$work/install.log" 2>&1 || { cat "$work/install.log" >&2; exit 1; }

cp "$here"/*.mjs "$work"
export RIGOR_CHROMIUM=$browser
[ -z "${RIGOR_REWRITE_GOLDEN:-}" ] || export RIGOR_IMAGES=$source_tree/docs/images
exec node "$work/drive.mjs" "$work" "${code[@]}"
