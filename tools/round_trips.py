#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Robots to MJCF and back: each difference that `rigor diff` finds must be named by one of the two conversions.

    tools/round_trips.py RIGOR FOLDER [--every N] [--show KIND]

Of the URDF and SDF files in the folder each Nth is converted with --allow-loss, and the result back. A difference is
named where a finding of either conversion has one of the rules that speak of such differences (NAMED_BY below) and is
about the same link or joint, or about the whole robot. What is not is counted by kind, with an example, after the files
that have such; --show lists all of one kind. Ends with 1 when a difference is not named.
"""

import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile

# Kind of difference: rules of conversions that say so.
MISSING = ["convert-mjcf-mesh-missing"]
SHAPES = MISSING + ["convert-mjcf-mesh", "convert-shape-lost", "convert-collision-lost"]
MASSES = ["convert-mjcf-massless", "convert-mjcf-inertia", "convert-mjcf-inertia-moved", "convert-massless-moving"]
LIMITS = ["convert-mjcf-locked", "convert-limit-inverted"]
JOINTS = ["convert-axis-zero", "convert-mjcf-loop", "convert-from-mjcf-loop", "convert-joint-type-lost",
          "convert-mjcf-joint-type"]
FIXED = ["convert-mjcf-fixed-joint"]
EXTRAS = ["convert-mjcf-not-carried", "convert-mjcf-contact", "convert-from-mjcf-contact", "convert-mjcf-look",
          "convert-mjcf-sensor", "convert-sensor", "convert-plugin", "convert-gravity", "convert-self-collide"]
NAMED_BY = {
    "part-renamed": ["convert-renamed"],
    "joint-renamed": FIXED + ["convert-renamed"] + JOINTS,
    "link-renamed": ["convert-renamed"],
    "velocity": ["convert-mjcf-velocity"] + JOINTS,
    "effort": ["convert-mjcf-effort"] + JOINTS,
    "mesh": ["convert-uri"] + SHAPES,
    "shape": SHAPES,
    "collision-only-in-a": SHAPES + ["convert-mjcf-not-carried"],
    "visual-only-in-a": SHAPES + ["convert-mjcf-not-carried"],
    "visual-only-in-b": ["convert-mjcf-look"],
    "mimic": ["convert-mimic-lost"],
    # Parts without names are compared in their order.
    "collision-moved": MISSING,
    "visual-moved": MISSING,
    "link-moved": MISSING,
    "color": ["convert-mjcf-look"],
    "mass": MASSES,
    "inertia": MASSES,
    "center-of-mass": MASSES + MISSING,
    "total-mass": MASSES,
    "lower-limit": LIMITS + JOINTS,
    "upper-limit": LIMITS + JOINTS,
    "joint-only-in-a": JOINTS + FIXED,
    "joint-only-in-b": JOINTS,
    "joint-type": JOINTS,
    "joint-axis": JOINTS,
    "joint-child": JOINTS,
    "joint-moved": JOINTS + ["convert-mjcf-model-pose"],
    "damping": JOINTS,
    "friction": JOINTS,
    "link-only-in-b": JOINTS + ["convert-from-mjcf-free"],
    "frame-only-in-b": ["convert-mjcf-sensor"],
    "model-pose": ["convert-mjcf-model-pose"],
    "root-pose": ["convert-mjcf-model-pose"],
    "static": FIXED,
    "link-only-in-a": FIXED + JOINTS,
    "setting": EXTRAS,
    "attachment-only-in-a": EXTRAS,
    "attachment-only-in-b": EXTRAS,
}


def run(command, cwd):
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True, timeout=120, check=False)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr.strip()[:300]}")
    return json.loads(done.stdout) if done.stdout.strip().startswith("{") else {}


def names_in(subject):
    """Of a finding: "panda/link hand/visual" is about hand, "robot panda" about no part of it."""
    parts = [part.split(" ", 1) for part in subject.split("/") if " " in part]
    return {name for kind, part in parts if kind not in ("robot", "model") for name in part.split("::")}


def is_named(difference, findings):
    rules = NAMED_BY.get(difference["kind"], [])
    about = set()
    for side in ("a", "b"):
        if difference[side]:
            path = difference[side]["subject"].partition(" ")[2].split("/")
            about.update(path[0].split("::"), path[1:] if difference["kind"].startswith("attachment") else [])
            if difference[side]["subject"] == "robot":  # what differs of it stands in the words
                about.update(re.split(r"[/ \[]", difference["message"]))
    # Consumers of SDF 1.6 put this behind the name of a joint that a link has, too.
    about |= {name.removesuffix("_joint") for name in about}
    # What is new has a name of its own, and `world` is there with its joints.
    anywhere = (difference["kind"].endswith("only-in-b") or difference["kind"] == "static"
                or difference["kind"] == "link-only-in-a" and "world" in about)
    for finding in findings:
        if finding["rule"] not in rules:
            continue
        for place in [finding] + finding.get("places", []):
            names = names_in(place.get("subject", ""))
            told = {word.strip('",:') for word in re.split("[/ ]", place.get("message", ""))}
            if not names or anywhere or (names | told) & about:
                return True
    return False


def round_trip(rigor, path, folder):
    """What differs, and what the conversions said; nothing where the source is not converted."""
    kind = "urdf" if path.suffix == ".urdf" else "sdf"
    there = run([rigor, f"{kind}2mjcf", path, "--allow-loss", "-o", "there.xml", "--format", "json"], folder)
    if not (folder / "there.xml").exists():
        return None
    back = run([rigor, f"mjcf2{kind}", "there.xml", "--allow-loss", "-o", f"back.{kind}", "--format", "json"], folder)
    if not (folder / f"back.{kind}").exists():
        why = str(back.get("diagnostics", ""))[:500]
        return [{"kind": "no-way-back", "a": {"subject": ""}, "b": None, "message": why}], []
    compared = run([rigor, "diff", path, f"back.{kind}", "--format", "json"], folder)
    return compared.get("differences", []), there.get("diagnostics", []) + back.get("diagnostics", [])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("rigor", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--show", default="")
    options = parser.parse_args()
    rigor = options.rigor.resolve()
    files = sorted(path.resolve() for path in options.folder.rglob("*") if path.suffix in (".urdf", ".sdf"))
    files = files[::options.every]
    named, unnamed, examples = collections.Counter(), collections.Counter(), {}
    same = told = not_converted = several = 0
    open_ = []
    for path in files:
        with tempfile.TemporaryDirectory() as scratch:
            try:
                result = round_trip(rigor, path, pathlib.Path(scratch))
            except (RuntimeError, subprocess.TimeoutExpired) as error:
                if "choose one with --model" in str(error):
                    several += 1
                    continue
                print(f"{path}: {error}", file=sys.stderr)
                continue
        if result is None:
            not_converted += 1
            continue
        differences, findings = result
        missing = [d for d in differences if not is_named(d, findings)]
        same += not differences
        told += bool(differences) and not missing
        open_ += [path] if missing else []
        named.update(d["kind"] for d in differences if d not in missing)
        for difference in missing:
            unnamed[difference["kind"]] += 1
            subject = (difference["a"] or difference["b"])["subject"]
            line = f"{path}: {subject}: {difference['message']}"
            examples.setdefault(difference["kind"], line)
            if options.show == difference["kind"]:
                print(line)
    print(f"{len(files)} files: {same} the same, {told} with differences that are all named, {len(open_)} with others, "
          f"{not_converted} not converted, {several} of several models, which are not compared")
    for path in open_:
        print(f"  {path}")
    for kind, count in unnamed.most_common():
        print(f"{count:6} of {count + named[kind]:6} {kind:24} {examples[kind]}")
    return 1 if open_ else 0


if __name__ == "__main__":
    sys.exit(main())
