#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# packaging/test/from_source.sh RELEASE [COMMAND...]: unpacks a Debian release into a folder of its own, puts the
# committed sources there, and runs COMMAND in them (default: tools/dev test, which installs what it needs). Needs root,
# debootstrap, some 10 GB in TMPDIR, and an hour on two cores. RIGOR_CORPUS, if set, and what lies beside it are seen
# inside at the same place, read only.
# shellcheck disable=SC2016  # dollar signs that are not the shell's
set -euo pipefail
source_tree=$(cd "$(dirname "$0")/../.." && pwd)
release=${1:?usage: from_source.sh RELEASE [COMMAND...]}
shift
[ $# -gt 0 ] || set -- tools/dev test
[ "$(id -u)" -eq 0 ] || { echo 'from_source.sh must run as root: it makes a root and enters it' >&2; exit 2; }

root=$(mktemp -d "${TMPDIR:-/var/tmp}/rigor-source-XXXXXX")
chmod 755 "$root"
corpus=${RIGOR_CORPUS:+$(realpath "$RIGOR_CORPUS")}
beside=${corpus%/*}
clean_up() {
  local folder
  for folder in "$beside" /dev/pts /dev/shm /dev /proc; do
    if [ -n "$folder" ] && mountpoint -q "$root$folder"; then umount "$root$folder"; fi
  done
  rm -rf --one-file-system "$root"
}
trap clean_up EXIT

mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | sed -n '\,/debian/$,{p;q}')
debootstrap --variant=minbase "$release" "$root" "$mirror" >"$root.log" 2>&1 || { tail "$root.log" >&2; exit 1; }
rm -f "$root.log"
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
mount --bind /dev/pts "$root/dev/pts"
mount -t tmpfs tmpfs "$root/dev/shm"
if [ -n "$beside" ]; then
  mkdir -p "$root$beside"
  mount --bind "$beside" "$root$beside"
  mount -o remount,bind,ro "$root$beside"
fi

# Where a network has an authority of its own, npm has to know it.
certificates=${NODE_EXTRA_CA_CERTS:+/root/certificates.crt}
[ -z "$certificates" ] || cp "$NODE_EXTRA_CA_CERTS" "$root$certificates"

inside() { chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/local/bin:/usr/bin:/bin:/usr/sbin:/sbin \
  LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive RIGOR_CORPUS="$corpus" ${certificates:+NODE_EXTRA_CA_CERTS="$certificates"} "$@"; }

inside apt-get update -qq
inside apt-get install -y -qq --no-install-recommends git >/dev/null 2>&1
# A clone, since some tests and the date of packages ask git.
git clone -q --no-local --depth 1 "file://$source_tree" "$root/root/rigor"
inside sh -c 'cd /root/rigor && exec "$@"' sh "$@"
