#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""packaging/wheel.py ROOT OUT: a wheel of what packaging/tarball.sh packed from ROOT, in the folder OUT.

The same files give the same bytes. Format: PEP 427; tags: PEP 425 and PEP 600.
"""

import base64
import hashlib
import json
import os
import pathlib
import platform
import subprocess
import sys
import time
import zipfile

# The program brings its own C library, so the tag says on what it is tried: Debian 11 has glibc 2.31
# (packaging/test/bare_root.sh).
GLIBC = "2_31"
FOLDERS = ("bin", "lib", "libexec", "share")
HERE = pathlib.Path(__file__).resolve().parent

METADATA = """\
Metadata-Version: 2.1
Name: rigor
Version: {version}
Summary: Checks robot models (SDFormat, URDF) before a simulator loads them
License: Apache-2.0
Keywords: robotics,sdformat,urdf,gazebo,linter
Classifier: Environment :: Console
Classifier: Operating System :: POSIX :: Linux
Requires-Python: >=3.7
Description-Content-Type: text/markdown

{readme}"""

WHEEL = """\
Wheel-Version: 1.0
Generator: rigor
Root-Is-Purelib: false
Tag: {tag}
"""

ENTRY_POINTS = """\
[console_scripts]
rigor = rigor:main
"""


class Wheel:
    def __init__(self, path):
        self.archive = zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9)
        epoch = max(int(os.environ.get("SOURCE_DATE_EPOCH", 0)), 315532800)  # zip begins in 1980
        self.time = time.gmtime(epoch)[:6]
        self.record = []

    def add(self, name, data, executable=False):
        entry = zipfile.ZipInfo(name, self.time)
        entry.compress_type = zipfile.ZIP_DEFLATED
        entry.create_system = 3  # Unix, whose modes pip keeps
        entry.external_attr = (0o100755 if executable else 0o100644) << 16
        self.archive.writestr(entry, data)
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        self.record.append(f"{name},sha256={digest},{len(data)}\n")

    def close(self, record_name):
        self.record.append(f"{record_name},,\n")
        entry = zipfile.ZipInfo(record_name, self.time)
        entry.compress_type = zipfile.ZIP_DEFLATED
        entry.create_system = 3
        entry.external_attr = 0o100644 << 16
        self.archive.writestr(entry, "".join(self.record))
        self.archive.close()


def main():
    root, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    said = subprocess.run([root / "bin/rigor", "--version", "--format", "json"], capture_output=True, check=True)
    version = json.loads(said.stdout)["tool"]["version"]
    tag = f"py3-none-manylinux_{GLIBC}_{platform.machine()}"
    name = f"rigor-{version}-{tag}.whl"
    wheel = Wheel(out / name)
    for file in ("__init__.py", "__main__.py"):
        wheel.add(f"rigor/{file}", (HERE / "wheel" / file).read_bytes())
    for folder in FOLDERS:
        for path in sorted(p for p in (root / folder).rglob("*") if p.is_file()):
            wheel.add(f"rigor/{path.relative_to(root)}", path.read_bytes(), executable=os.access(path, os.X_OK))
    info = f"rigor-{version}.dist-info"
    readme = (HERE / "wheel/README.md").read_text().replace("@WHEEL@", name)
    wheel.add(f"{info}/METADATA", METADATA.format(version=version, readme=readme).encode())
    wheel.add(f"{info}/WHEEL", WHEEL.format(tag=tag).encode())
    wheel.add(f"{info}/entry_points.txt", ENTRY_POINTS.encode())
    wheel.add(f"{info}/LICENSE", (root / "share/doc/LICENSE").read_bytes())
    wheel.close(f"{info}/RECORD")


if __name__ == "__main__":
    main()
