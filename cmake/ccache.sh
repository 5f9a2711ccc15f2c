#!/bin/sh
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# ccache.sh CCACHE COMPILER ARGUMENT...: compiles through ccache, precompiled headers as well.

# ccache takes a precompiled header that is there for a part of what makes a new one, and brings the old one again.
output=
for argument; do
  [ "$output" = -o ] && case $argument in *.gch) rm -f "$argument" ;; esac
  output=$argument
done

# What it asks for before it caches with precompiled headers: they hold system headers, which use no __TIME__.
CCACHE_SLOPPINESS=pch_defines,time_macros exec "$@"
