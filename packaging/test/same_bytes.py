#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""packaging/test/same_bytes.py PACKAGES: the tarball, the wheel, the npm package and the extension for VS Code in the
folder PACKAGES hold the same program: in bin, lib, libexec and share the same paths, bytes and executable bits."""

import hashlib
import pathlib
import sys
import tarfile
import zipfile

FOLDERS = ("bin/", "lib/", "libexec/", "share/")


def from_tar(path):
    files = {}
    with tarfile.open(path) as archive:
        for entry in archive:
            name = entry.name.partition("/")[2]  # without the archive's own folder
            if entry.isfile() and name.startswith(FOLDERS):
                data = archive.extractfile(entry).read()
                files[name] = (hashlib.sha256(data).hexdigest(), bool(entry.mode & 0o100))
    return files


def from_zip(path, folder):
    files = {}
    with zipfile.ZipFile(path) as archive:
        for entry in archive.infolist():
            name = entry.filename.removeprefix(folder)
            if name != entry.filename and name.startswith(FOLDERS):
                data = archive.read(entry)
                files[name] = (hashlib.sha256(data).hexdigest(), bool(entry.external_attr >> 16 & 0o100))
    return files


def main():
    packages = pathlib.Path(sys.argv[1])
    (tarball,) = packages.glob("rigor-*-linux-*.tar.gz")
    (wheel,) = packages.glob("rigor-*.whl")
    expected = from_tar(tarball)
    others = {wheel.name: from_zip(wheel, "rigor/")}
    others |= {vsix.name: from_zip(vsix, "extension/program/") for vsix in packages.glob("rigor-*.vsix")}
    others |= {npm.name: from_tar(npm) for npm in packages.glob("rigor-robot-*.tgz")}
    failed = 0
    for name, files in others.items():
        different = sorted(path for path in expected | files if expected.get(path) != files.get(path))
        if different or "libexec/rigor" not in files:
            print(f"FAILED: {name} is not {tarball.name}: {', '.join(different[:10])}")
            failed += 1
        else:
            print(f"ok: {name} holds the same {len(files)} files as {tarball.name}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
