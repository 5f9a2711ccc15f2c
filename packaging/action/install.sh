#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# Fetches the tarball of a release and unpacks it, unless its checksum is another than the one that was asked for.
# RIGOR_VERSION, RIGOR_SHA256 (else the release's own list), RIGOR_REPOSITORY (owner/name), RIGOR_SERVER (a URL),
# RIGOR_FOLDER (where to).
set -euo pipefail

[[ $RIGOR_VERSION =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] || {
  echo "::error::rigor: version \"$RIGOR_VERSION\" is not of the form 0.1.0"
  exit 2
}
name="rigor-$RIGOR_VERSION-linux-$(uname -m)"
url="$RIGOR_SERVER/$RIGOR_REPOSITORY/releases/download/v$RIGOR_VERSION"
mkdir -p "$RIGOR_FOLDER"
cd "$RIGOR_FOLDER"

fetch() { curl --fail --silent --show-error --location --retry 3 --output "$1" "$url/$1"; }

fetch "$name.tar.gz"
if [ -n "${RIGOR_SHA256:-}" ]; then
  sum=$RIGOR_SHA256
else
  # It guards against a broken download; only a checksum in the workflow guards against a changed release.
  fetch SHA256SUMS
  sum=$(awk -v name="$name.tar.gz" '$2 == name { print $1 }' SHA256SUMS)
fi
echo "$sum  $name.tar.gz" | sha256sum --check --status || {
  echo "::error::rigor: $name.tar.gz has the checksum $(sha256sum "$name.tar.gz" | cut -d ' ' -f 1), not ${sum:-any that the release lists}"
  exit 2
}
tar xzf "$name.tar.gz"
echo "$RIGOR_FOLDER/$name/bin" >>"$GITHUB_PATH"
"$RIGOR_FOLDER/$name/bin/rigor" --version
