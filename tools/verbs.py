#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Verbs of `rigor edit` that read a second file or write in another version, judged by the formats' own parsers.

    tools/verbs.py RIGOR FOLDER [--count N] [--verb NAME ...]

Of the SDF and URDF files of at most 400 kB below the folder, in an order that is the same each time, those that `ign sdf
-k` or `check_urdf` takes are changed by each verb until it has written N of them (default 230); what it writes is given to
the same parser. Prints a table, and what was rejected. Ends with 1 when anything was, or fewer than N were written. Needs
ignition-tools with libsdformat, and liburdfdom-tools. The other verbs are judged by tests/author/verbs.
"""

import argparse
import os
import random
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

LARGEST = 400_000
GRIPPER = {
    "urdf": """<robot name="gripper">
  <link name="palm"><inertial><mass value="0.2"/><inertia ixx="1e-4" iyy="1e-4" izz="1e-4" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="finger"><inertial><mass value="0.1"/><inertia ixx="1e-5" iyy="1e-5" izz="1e-5" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="grip" type="prismatic">
    <parent link="palm"/><child link="finger"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.04" effort="10" velocity="0.1"/>
  </joint>
</robot>
""",
    "sdf": """<sdf version="VERSION">
  <model name="gripper">
    <link name="palm"><inertial><mass>0.2</mass><inertia><ixx>1e-4</ixx><iyy>1e-4</iyy><izz>1e-4</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial></link>
    <link name="finger"><inertial><mass>0.1</mass><inertia><ixx>1e-5</ixx><iyy>1e-5</iyy><izz>1e-5</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial></link>
    <joint name="grip" type="prismatic">
      <parent>palm</parent><child>finger</child>
      <axis><xyz>0 1 0</xyz><limit><lower>0</lower><upper>0.04</upper></limit></axis>
    </joint>
  </model>
</sdf>
""",
}


class Model:
    """A file with its format, and the first link that stands in it."""

    def __init__(self, path):
        self.path = path
        root = ElementTree.parse(path).getroot()
        self.format = {"robot": "urdf", "sdf": "sdf"}.get(root.tag)
        self.version = root.get("version", "")
        models = [root] if self.format == "urdf" else root.findall("model")
        self.link = next((link.get("name") for model in models for link in model.findall("link")), None)

    def verb(self, name, tool):
        """The words of the command line, None where the verb does not apply."""
        if name == "rename":
            return [name, self.link, self.link + "_renamed", self.path, "--kind", "link"]
        if name == "attach":
            return [name, self.path, tool, "--to", self.link, "--prefix", "attached_", "--pose", "0.1 0 0 0 0 0.5"]
        if name == "merge":
            root = ["--to", "both"] if self.format == "urdf" else []
            return [name, self.path, tool, "--pose", "0 1 0 0 0 1"] + root
        if name.startswith("add "):
            return ["add", name[4:], self.path, "--to", self.link]
        if self.format == "urdf":
            return None
        return name.split() + [self.path]


VERBS = ["rename", "attach", "merge", "add imu", "add lidar", "downgrade 1.4", "upgrade 1.9"]


def accepted(path, kind):
    command = ["check_urdf", path] if kind == "urdf" else ["ign", "sdf", "-k", path]
    try:
        done = subprocess.run(command, capture_output=True, timeout=60, check=False)
    except subprocess.TimeoutExpired:
        return False
    return done.returncode == 0


def models(folder):
    paths = []
    for above, folders, files in os.walk(folder):
        folders.sort()
        paths += [os.path.join(above, file) for file in sorted(files) if file.endswith((".sdf", ".urdf", ".world"))]
    random.Random(1).shuffle(paths)
    for path in paths:
        if os.path.getsize(path) > LARGEST:
            continue
        try:
            model = Model(path)
        except (ElementTree.ParseError, UnicodeDecodeError):
            continue
        if model.format and model.link:
            yield model


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rigor")
    parser.add_argument("folder")
    parser.add_argument("--count", type=int, default=230)
    parser.add_argument("--verb", action="append", choices=VERBS)
    options = parser.parse_args()
    verbs = options.verb or VERBS
    applied, written, taken = (dict.fromkeys(verbs, 0) for _ in range(3))
    seen = 0
    with tempfile.TemporaryDirectory() as scratch:
        for model in models(options.folder):
            open_verbs = [verb for verb in verbs if written[verb] < options.count]
            if not open_verbs:
                break
            if not accepted(model.path, model.format):
                continue
            seen += 1
            tool = os.path.join(scratch, "gripper." + model.format)
            with open(tool, "w", encoding="utf-8") as file:
                file.write(GRIPPER[model.format].replace("VERSION", model.version))
            for verb in open_verbs:
                words = model.verb(verb, tool)
                if words is None:
                    continue
                applied[verb] += 1
                result = os.path.join(scratch, "result." + model.format)
                if os.path.exists(result):
                    os.remove(result)
                done = subprocess.run([options.rigor, "edit"] + words + ["-o", result, "--isolated"],
                                      capture_output=True, text=True, check=False)
                if done.returncode not in (0, 1, 2):
                    sys.exit(f"exit {done.returncode}: {words}")
                if done.returncode != 0 or not os.path.exists(result):
                    continue
                written[verb] += 1
                if accepted(result, model.format):
                    taken[verb] += 1
                else:
                    print(f"rejected: rigor edit {' '.join(words)}", flush=True)
    print(f"{seen} models\n\n| verb | tried | written | accepted |\n|---|---|---|---|")
    for verb in verbs:
        print(f"| {verb} | {applied[verb]} | {written[verb]} | {taken[verb]} |")
    return any(taken[verb] < options.count for verb in verbs)


if __name__ == "__main__":
    sys.exit(main())
