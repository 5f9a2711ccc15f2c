#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# Drives `rigor lsp` by the library that VS Code's clients are made of. Its packages are fetched by npm into the
# build folder, once. Exit code 77, which CTest takes for skipped, where they cannot be had.
#
#   client.sh RIGOR BUILD_FOLDER
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$2/lsp_client"
cp "$here/package.json" "$here/client.mjs" "$2/lsp_client"
cd "$2/lsp_client"
if [ ! -d node_modules/vscode-languageserver-protocol ]; then
  npm install --no-audit --no-fund --silent || exit 77
fi
node client.mjs "$1"
