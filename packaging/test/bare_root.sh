#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# packaging/test/bare_root.sh PACKAGES [RELEASE...]: unpacks each Debian release (default: bullseye bookworm trixie)
# into a folder of its own, installs there what PACKAGES holds as a user would, and lets rigor find the fault in
# broken.sdf. Needs root and debootstrap; the mirror is the one that this machine's apt uses.
# shellcheck disable=SC2016  # dollar signs that are not the shell's
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source_tree=$(cd "$here/../.." && pwd)
packages=$(cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- bullseye bookworm trixie
[ "$(id -u)" -eq 0 ] || { echo 'bare_root.sh must run as root: it makes roots and enters them' >&2; exit 2; }

root=
clean_up() {
  [ -n "$root" ] || return 0
  if mountpoint -q "$root/proc"; then umount "$root/proc"; fi
  rm -rf --one-file-system "$root"
  root=
}
trap clean_up EXIT

passed=0 failed=0 skipped=0
ok() { echo "ok: $*"; passed=$((passed + 1)); }
bad() { echo "FAILED: $*"; failed=$((failed + 1)); }
skip() { echo "skipped: $*"; skipped=$((skipped + 1)); }

inside() { chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/local/bin:/usr/bin:/bin:/usr/sbin:/sbin \
  DEBIAN_FRONTEND=noninteractive sh -c "cd /root && $1"; }

now() { date +%s.%N; }
since() { awk -v from="$1" -v to="$(now)" 'BEGIN { printf "%.1f s", to - from }'; }

# finds_the_fault WHAT PROGRAM: the finding with its place, exit code 1, and nothing on stderr but the count.
finds_the_fault() {
  local said code=0
  said=$(inside "$2 validate --format concise broken.sdf" 2>&1) || code=$?
  if [ "$code" -eq 1 ] && grep -q '^broken\.sdf:11:15: error: .*\[joint-parent-missing\]$' <<<"$said"; then
    ok "$1 finds the fault"
  else
    bad "$1: exit code $code"
    echo "$said"
  fi
}

# reads_a_scene WHAT PROGRAM: Collada is what assimp is for.
reads_a_scene() {
  local said
  if said=$(inside "$2 mesh-check tetrahedron.stl -o scene.dae && $2 mesh-check --format json scene.dae" 2>&1) &&
      grep -q '"triangles": 4,' <<<"$said" && grep -q '"watertight": true' <<<"$said"; then
    ok "$1 writes and reads a Collada scene"
  else
    bad "$1 reads no Collada scene"
    echo "$said"
  fi
}

# draws WHAT PROGRAM: with Embree, which is opened by name.
draws() {
  local said
  if said=$(inside "rm -rf drawn && $2 new drawn --template box && $2 render drawn -o drawn.png --size 64x48" 2>&1) &&
      [ "$(head -c 4 "$root/root/drawn.png" | tail -c 3)" = PNG ]; then
    ok "$1 draws an image"
  else
    bad "$1 draws nothing"
    echo "$said"
  fi
  rm -f "$root/root/drawn.png"
}

# holds_links WHAT PROGRAM: against each other with FCL, which is in a module.
holds_links() {
  local said
  if said=$(inside "rm -rf held && $2 new held --template arm && $2 srdf held/model.sdf --samples 100" 2>&1) &&
      grep -q '<disable_collisions ' <<<"$said"; then
    ok "$1 writes an SRDF"
  else
    bad "$1 writes no SRDF"
    echo "$said"
  fi
}

test_release() {
  local release=$1 mirror begin deb
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | sed -n '\,/debian/$,{p;q}')
  root=$(mktemp -d "${TMPDIR:-/var/tmp}/rigor-root-XXXXXX")
  chmod 755 "$root"  # apt leaves root's rights behind when it downloads
  echo "== $release"
  begin=$(now)
  if ! debootstrap --variant=minbase "$release" "$root" "$mirror" >"$root.log" 2>&1; then
    skip "the mirror has no $release, or debootstrap does not know it ($(tail -n 1 "$root.log"))"
    rm -f "$root.log"
    clean_up
    return
  fi
  rm -f "$root.log"
  echo "unpacked in $(since "$begin")"
  mount -t proc proc "$root/proc"
  cp "$here/broken.sdf" "$here/tetrahedron.stl" "$root/root/"
  cp "$packages"/*.deb "$packages"/*.tar.gz "$packages"/*.tgz "$packages"/*.whl "$root/root/" 2>/dev/null || true

  # The tarball first, while none of the libraries is there.
  begin=$(now)
  inside 'tar xf rigor-*.tar.gz -C /opt && ln -s /opt/rigor-*/bin/rigor /usr/local/bin/rigor-tarball'
  finds_the_fault 'the tarball' rigor-tarball
  echo "from the tarball to the first finding: $(since "$begin")"
  reads_a_scene 'the tarball' rigor-tarball
  draws 'the tarball' rigor-tarball
  holds_links 'the tarball' rigor-tarball
  check_direct_start

  deb=$(basename "$packages"/rigor_*.deb)
  inside 'apt-get update -qq'
  local plan
  if ! plan=$(inside "apt-get install -qq -s ./$deb" 2>&1); then
    skip "$deb was built for another release, and apt says so: $(grep -v '^[WN]:' <<<"$plan" | tail -n 4 | tr -s ' \n' ' ')"
  else
    begin=$(now)
    inside "apt-get install -y -qq ./$deb" >"$root/apt.log" 2>&1 || cat "$root/apt.log"
    finds_the_fault "$deb" rigor
    echo "from \`apt install\` to the first finding: $(since "$begin")"
    reads_a_scene "$deb" rigor
    draws "$deb" rigor
    holds_links "$deb" rigor
    check_files
    check_development
  fi
  check_wheel "$release"
  check_npm "$release"
  clean_up
}

# Without the launcher: it works, or the loader says which C library is missing.
check_direct_start() {
  local said
  if said=$(inside '/opt/rigor-*/libexec/rigor --version' 2>&1); then
    ok "the tarball's program starts without its launcher"
  elif grep -q "version \`GLIBC_[0-9.]*' not found" <<<"$said"; then
    ok "without its launcher the tarball's program says that it needs $(grep -o 'GLIBC_[0-9.]*' <<<"$said" | sort -Vu | tail -n 1)"
  else
    bad 'without its launcher the program fails obscurely'
    echo "$said"
  fi
}

# A minimal root leaves out man pages (dpkg's path-exclude), so they are looked for in the package.
check_files() {
  local listing
  listing=$(dpkg-deb -c "$packages"/rigor_*.deb)
  for file in libexec/rigor-worker libexec/rigor-page-server.so libexec/rigor-collider.so \
              share/man/man1/rigor-validate.1.gz share/bash-completion/completions/rigor \
              share/zsh/vendor-completions/_rigor share/fish/vendor_completions.d/rigor.fish; do
    if grep -q "$file\$" <<<"$listing"; then ok "it has $file"; else bad "no $file"; fi
  done
}

# The -dev package brings what its library is linked with: three lines of somebody else's project.
check_development() {
  cp -r "$source_tree/tests/consumer" "$root/root/"
  if inside 'apt-get install -y -qq --no-install-recommends ./librigor-dev_*.deb g++ cmake make >apt.log 2>&1 &&
             cmake -S consumer -B built >cmake.log && cmake --build built >>cmake.log &&
             built/consumer consumer/good.sdf'; then
    ok 'a project builds against librigor-dev'
  else
    bad 'no project builds against librigor-dev'
    tail -n 20 "$root/root/apt.log" "$root/root/cmake.log" || true
  fi
}

# By Debian's pip; those of bookworm and later want to be told that this is no machine of Debian's own packages.
check_wheel() {
  local wheel
  wheel=$(cd "$packages" && ls ./*.whl 2>/dev/null) || { skip 'there is no wheel'; return; }
  if ! inside 'apt-get install -y -qq --no-install-recommends python3-pip >apt.log 2>&1'; then
    skip "$1 has no pip"
    return
  fi
  if inside "PIP_BREAK_SYSTEM_PACKAGES=1 pip3 install --no-index $wheel >pip.log 2>&1"; then
    finds_the_fault 'the wheel' /usr/local/bin/rigor
    reads_a_scene 'the wheel' 'python3 -m rigor'
    draws 'the wheel' 'python3 -m rigor'
    holds_links 'the wheel' 'python3 -m rigor'
  else
    bad 'pip does not install the wheel'
    cat "$root/root/pip.log"
  fi
}

check_npm() {
  local package
  package=$(cd "$packages" && ls ./*.tgz 2>/dev/null) || { skip 'there is no npm package'; return; }
  if ! inside 'apt-get install -y -qq --no-install-recommends npm >apt.log 2>&1'; then
    skip "$1 has no npm"
    return
  fi
  if inside "npm install --global --offline --no-audit --no-fund --prefix /opt/npm $package >npm.log 2>&1"; then
    finds_the_fault 'the npm package' /opt/npm/bin/rigor
    reads_a_scene 'the npm package' /opt/npm/bin/rigor
    draws 'the npm package' /opt/npm/bin/rigor
    holds_links 'the npm package' /opt/npm/bin/rigor
  else
    bad 'npm does not install the package'
    cat "$root/root/npm.log"
  fi
}

for release in "$@"; do test_release "$release"; done
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
