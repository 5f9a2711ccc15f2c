#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""packaging/vsix.py ROOT OUT [WORK]: the extension of editors/vscode, with the program installed in ROOT, as a .vsix in the
folder OUT. Its path is printed. Needs node and npm; WORK keeps what npm fetches for the next time.

The same files give the same bytes. A .vsix is a zip archive after the Open Packaging Conventions; its manifest is that of
vsce, the tool of VS Code's authors.
"""

import filecmp
import json
import os
import pathlib
import platform
import shutil
import subprocess
import sys
import tempfile
import time
import xml.sax.saxutils
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent / "editors/vscode"
# Of ROOT; what packaging/tarball.sh packs, and what `cmake --install` does.
FOLDERS = ("bin", "lib", "libexec", "share")
# Of the extension, beside dist/.
FILES = ("README.md", "icon.png", "language-configuration.json", "syntaxes", "walkthrough")
MACHINES = {"x86_64": "x64", "aarch64": "arm64", "armv7l": "armhf"}

MANIFEST = """\
<?xml version="1.0" encoding="utf-8"?>
<PackageManifest Version="2.0.0" xmlns="http://schemas.microsoft.com/developer/vsx-schema/2011">
  <Metadata>
    <Identity Language="en-US" Id="{name}" Version="{version}" Publisher="{publisher}" TargetPlatform="{target}"/>
    <DisplayName>{display_name}</DisplayName>
    <Description xml:space="preserve">{description}</Description>
    <Tags>{tags}</Tags>
    <Categories>{categories}</Categories>
    <GalleryFlags>Public</GalleryFlags>
    <Properties>
      <Property Id="Microsoft.VisualStudio.Code.Engine" Value="{engine}"/>
      <Property Id="Microsoft.VisualStudio.Code.ExtensionKind" Value="workspace"/>
    </Properties>
    <License>extension/LICENSE.txt</License>
    <Icon>extension/icon.png</Icon>
  </Metadata>
  <Installation>
    <InstallationTarget Id="Microsoft.VisualStudio.Code"/>
  </Installation>
  <Dependencies/>
  <Assets>
    <Asset Type="Microsoft.VisualStudio.Code.Manifest" Path="extension/package.json" Addressable="true"/>
    <Asset Type="Microsoft.VisualStudio.Services.Content.Details" Path="extension/README.md" Addressable="true"/>
    <Asset Type="Microsoft.VisualStudio.Services.Content.License" Path="extension/LICENSE.txt" Addressable="true"/>
    <Asset Type="Microsoft.VisualStudio.Services.Icons.Default" Path="extension/icon.png" Addressable="true"/>
  </Assets>
</PackageManifest>
"""


def built(work):
    """The extension's script in WORK/dist."""
    lock = work / "package-lock.json"
    fetched = lock.exists() and filecmp.cmp(lock, SOURCE / lock.name, shallow=False) and (work / "node_modules").exists()
    shutil.copytree(SOURCE, work, dirs_exist_ok=True, ignore=shutil.ignore_patterns("node_modules", "dist"))
    if not fetched:
        subprocess.run(["npm", "ci", "--no-audit", "--no-fund", "--loglevel=error"], cwd=work, check=True, stdout=sys.stderr)
    subprocess.run(["node", "node_modules/typescript/bin/tsc"], cwd=work, check=True, stdout=sys.stderr)
    subprocess.run(["node", "build.mjs"], cwd=work, check=True, stdout=sys.stderr)
    return work


class Archive:
    def __init__(self, path):
        self.zip = zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9)
        epoch = max(int(os.environ.get("SOURCE_DATE_EPOCH", 0)), 315532800)  # zip begins in 1980
        self.time = time.gmtime(epoch)[:6]
        self.extensions = set()

    def add(self, name, data, executable=False):
        entry = zipfile.ZipInfo(name, self.time)
        entry.compress_type = zipfile.ZIP_DEFLATED
        entry.create_system = 3  # Unix, whose modes VS Code keeps
        entry.external_attr = (0o100755 if executable else 0o100644) << 16
        self.zip.writestr(entry, data)
        self.extensions.add(pathlib.PurePosixPath(name).suffix)

    def add_file(self, name, path):
        self.add(name, path.read_bytes(), executable=os.access(path, os.X_OK))

    def add_tree(self, name, folder):
        for path in sorted(path for path in folder.rglob("*") if path.is_file()):
            self.add_file(f"{name}/{path.relative_to(folder).as_posix()}", path)

    def close(self):
        known = {".json": "application/json", ".vsixmanifest": "text/xml", ".md": "text/markdown", ".png": "image/png"}
        types = "".join(
            f'<Default Extension="{suffix}" ContentType="{known.get(suffix, "application/octet-stream")}"/>'
            for suffix in sorted(filter(None, self.extensions))
        )
        schema = "http://schemas.openxmlformats.org/package/2006/content-types"
        self.add("[Content_Types].xml", f'<?xml version="1.0" encoding="utf-8"?><Types xmlns="{schema}">{types}</Types>')
        self.zip.close()


def manifest(package, target):
    values = {
        "name": package["name"],
        "version": package["version"],
        "publisher": package["publisher"],
        "target": target,
        "display_name": package["displayName"],
        "description": package["description"],
        "tags": ",".join(package["keywords"]),
        "categories": ",".join(package["categories"]),
        "engine": package["engines"]["vscode"],
    }
    return MANIFEST.format(**{key: xml.sax.saxutils.escape(value, {'"': "&quot;"}) for key, value in values.items()})


def pack(root, out, work):
    said = subprocess.run([root / "bin/rigor", "--version", "--format", "json"], capture_output=True, check=True)
    package = json.loads((work / "package.json").read_text())
    package["version"] = json.loads(said.stdout)["tool"]["version"]
    del package["devDependencies"]
    target = f"linux-{MACHINES.get(platform.machine(), platform.machine())}"
    path = out / f"rigor-{package['version']}-{target}.vsix"
    archive = Archive(path)
    archive.add("extension.vsixmanifest", manifest(package, target))
    archive.add("extension/package.json", json.dumps(package, indent=2, ensure_ascii=False) + "\n")
    archive.add_file("extension/LICENSE.txt", HERE.parent / "LICENSE")
    archive.add_tree("extension/dist", work / "dist")
    for name in FILES:
        if (work / name).is_dir():
            archive.add_tree(f"extension/{name}", work / name)
        else:
            archive.add_file(f"extension/{name}", work / name)
    for folder in FOLDERS:
        if (root / folder).exists():
            archive.add_tree(f"extension/program/{folder}", root / folder)
    archive.close()
    return path


def main():
    root, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    if len(sys.argv) > 3:
        print(pack(root, out, built(pathlib.Path(sys.argv[3]))))
        return
    with tempfile.TemporaryDirectory() as work:
        print(pack(root, out, built(pathlib.Path(work))))


if __name__ == "__main__":
    main()
