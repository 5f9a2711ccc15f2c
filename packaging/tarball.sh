#!/usr/bin/env bash
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# packaging/tarball.sh BUILD OUT: a tarball of what BUILD has built, with every library beside it. The same
# build gives the same bytes. Prints the folder that it packed; it is left for packaging/npm.sh.
# shellcheck disable=SC2016  # dollar signs that are not the shell's
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd) out=$(cd "$2" && pwd)
: "${SOURCE_DATE_EPOCH:=$(git -C "$here" log -1 --format=%ct)}"

version=$("$build/rigor" --version --format json | sed -n 's/.*"version": *"\([^"]*\)".*/\1/p' | head -n 1)
name="rigor-$version-linux-$(uname -m)"
root="$out/$name"
rm -rf "$root"
cmake --install "$build" --prefix "$root" --component program --strip >/dev/null
mkdir -p "$root/libexec" "$root/lib/glibc" "$root/share/doc/licenses"
mv "$root/bin/rigor" "$root/libexec/rigor"
mv "$root/libexec/rigor-worker" "$root/libexec/rigor-worker.program"
mv "$root/share/doc/rigor/LICENSE" "$root/share/doc/rigor/CHANGELOG.md" "$root/share/doc/"
[ -e "$root/share/doc/rigor/rules.md" ] && mv "$root/share/doc/rigor/rules.md" "$root/share/doc/"
rm -rf "$root/share/doc/rigor"

# Libraries that are opened by name: assimp reads scenes, Embree draws. Everything else shows in the programs.
opened=()
for pattern in 'libassimp\.so\.[0-9][0-9]*' 'libembree[0-9]\.so\.[0-9][0-9]*'; do
  name_in_program=$(grep -haom 1 "$pattern" "$build/rigor-worker" "$build/rigor") || continue  # a build without it
  name_in_program=${name_in_program%%$'\n'*}
  path=$(ldconfig -p | awk -v name="$name_in_program" '$1 == name && !path { path = $NF } END { print path }')
  [ -n "$path" ] || { echo "$name_in_program is not installed" >&2; exit 1; }
  opened+=("$name_in_program => $path")
done
modules=(rigor-page-server.so rigor-collider.so)
loader_path=$(patchelf --print-interpreter "$root/libexec/rigor")
loader=$(basename "$loader_path")

# The loader finds what the programs and these need, and what those need in turn.
printf 'library\tpackage\tversion\n' >"$root/share/doc/licenses/libraries.tsv"
{
  ldd "$build/rigor"
  ldd "$build/rigor-worker"
  for module in "${modules[@]}"; do ldd "$build/$module"; done
  for library in "${opened[@]}"; do
    ldd "${library#* => }"
    echo "$library"
  done
  echo "$loader => $loader_path"
} | awk '$2 == "=>" && $3 ~ /^\// { print $1, $3 }' | sort -u -k1,1 | while read -r soname path; do
  # A C library works with its own loader only. In a folder of their own no other loader finds it.
  case $soname in
    "$loader" | libc.so.6 | libm.so.6 | libpthread.so.0) folder=lib/glibc ;;
    *) folder=lib ;;
  esac
  install -m 644 "$(readlink -f "$path")" "$root/$folder/$soname"
  # Debian's database may know the file by the path from before /lib became a link.
  package=$(dpkg -S "$path" 2>/dev/null || dpkg -S "/usr$path" 2>/dev/null || dpkg -S "$(readlink -f "$path")")
  package=${package%%: *}
  printf '%s\t%s\t%s\n' "$soname" "${package%%:*}" "$(dpkg-query -W -f='${Version}' "$package")" \
    >>"$root/share/doc/licenses/libraries.tsv"
  install -m 644 "/usr/share/doc/${package%%:*}/copyright" "$root/share/doc/licenses/${package%%:*}"
done
for license in GPL-2 GPL-3 LGPL-2.1 LGPL-3 Apache-2.0; do  # which those files refer to
  if grep -qsr "common-licenses/$license" "$root/share/doc/licenses"; then
    install -m 644 "/usr/share/common-licenses/$license" "$root/share/doc/licenses/"
  fi
done
chmod 755 "$root/lib/glibc/$loader"

# Found without the launcher too. RPATH, unlike RUNPATH, counts for what is opened by name.
for program in "$root/libexec/rigor" "$root/libexec/rigor-worker.program" "${modules[@]/#/$root/libexec/}"; do
  patchelf --force-rpath --set-rpath '$ORIGIN/../lib' "$program"
done
for library in "$root"/lib/*.so.*; do patchelf --force-rpath --set-rpath '$ORIGIN' "$library"; done

needed=$(for file in "$root/libexec/rigor" "$root/libexec/rigor-worker.program" "${modules[@]/#/$root/libexec/}" \
             "$root"/lib/*.so.*; do
  objdump -T "$file" | grep -o 'GLIBC_[0-9.]*'
done | sort -Vu | tail -n 1)
glibc="glibc $(ldd --version | sed -n '1s/.* //p')"
kernel=$(file -L "$root/lib/glibc/libc.so.6" | sed -n 's/.*for GNU\/Linux \([0-9]*\.[0-9]*\).*/\1/p')
sed -e "s/@VERSION@/$version/; s/@MACHINE@/$(uname -m)/g; s/@GLIBC@/$glibc/; s/@KERNEL@/$kernel/; \
s/@NEEDED_GLIBC@/$needed/g" "$here/tarball/README" >"$root/README"
mkdir -p "$root/bin"
sed "s/@LOADER@/$loader/g; s/@PROGRAM@/rigor/g" "$here/tarball/launch.sh" >"$root/bin/rigor"
sed "s/@LOADER@/$loader/g; s/@PROGRAM@/rigor-worker.program/g" "$here/tarball/launch.sh" >"$root/libexec/rigor-worker"
chmod 755 "$root/bin/rigor" "$root/libexec/rigor-worker"

tar --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --format=gnu \
  -C "$out" -cf - "$name" | gzip -9n >"$out/$name.tar.gz"
echo "$root"
