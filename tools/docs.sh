#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# tools/docs.sh RIGOR OUT: writes the reference (commands, rules, schemas) that the program RIGOR prints of
# itself into the folder OUT, and removes pages of what is no more.
set -euo pipefail
rigor=$1 out=$2
mkdir -p "$out"
rm -rf "$out/rules"
mkdir "$out/rules"

"$rigor" man --format markdown >"$out/commands.md"
"$rigor" schema urdf >"$out/urdf.md"
"$rigor" schema 1.12 >"$out/sdf.md"

# One page of all rules is longer than a site shows: the table, and a page for each rule, which reports name
# (`docs` in JSON).
"$rigor" rules --format markdown | awk -v out="$out" '
  /^\| \[/ {  # | [axis-zero](#axis-zero) | kinematics | …
    split($0, cell, "[][]"); name = cell[2]
    known[name] = 1
    sub("\\(#" name, "(rules/" name ".md")
  }
  /^## / && ($2 in known) {
    if (page) close(page)
    page = out "/rules/" $2 ".md"
    blank = 0
    sub("^## ", "# ")
  }
  !page { print >(out "/rules.md"); next }
  # The blank line before a heading belongs to none of the two pages.
  /^$/ { ++blank; next }
  { for (; blank > 0; --blank) print "" >page; print >page }
'

cat >"$out/README.md" <<'TEXT'
# Reference

Written by `tools/dev docs` from the program; a test fails when it is stale.

- [Commands](commands.md): every command and option, exit codes, variables. Also as man pages: `man rigor-validate`.
- [Rules](rules.md): what `rigor validate` finds, why it matters and what to do. Also `rigor explain RULE`.
- [SDFormat](sdf.md) and [URDF](urdf.md): every element that rigor knows. Other versions: `rigor schema 1.6`.
TEXT
