#!/bin/sh
# Starts a program of rigor with the libraries that lie beside it, the C library too: what this machine has, and
# how old it is, does not matter. A link to this file works as well.
here=$(readlink -f -- "$0") || here=$0
root=${here%/*}/..
if [ ! -x "$root/lib/glibc/@LOADER@" ]; then
  echo "rigor: $root/lib/glibc/@LOADER@ is missing: keep bin, lib and libexec together, as they were unpacked" >&2
  exit 2
fi
exec "$root/lib/glibc/@LOADER@" --inhibit-cache --library-path "$root/lib/glibc:$root/lib" --argv0 rigor "$root/libexec/@PROGRAM@" "$@"
