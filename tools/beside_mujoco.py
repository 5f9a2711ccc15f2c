#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Runs robots in `rigor simulate` and in MuJoCo with the same set-up, and prints both, a line a test.

    tools/beside_mujoco.py build/release/rigor --corpus DIR --robots FILE [--results FILE]
    tools/beside_mujoco.py build/release/rigor --corpus DIR --draw N --seed S --besides FILE

FILE has a line a robot: its path, a tab, its tests ("settle,drive"). The base, the commands, the positions that joints begin
at and the effort limits are those of rigor's run; MuJoCo reads the URDF itself (an SDF file as `sdf2urdf` writes it), meshes as
their convex hulls. --draw draws other robots than those of FILE. Needs gcc and Debian's libmujoco-dev.
"""

import argparse
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

import wild

HERE = os.path.dirname(os.path.abspath(__file__))
TESTS = {"wheels": "settle,drive,turn", "joints": "settle,hold,joint-sweep", "none": "settle,drop"}


class Judge:
    def __init__(self, program, corpus):
        self.program, self.corpus = os.path.abspath(program), corpus
        self.folder = tempfile.mkdtemp(prefix="beside-mujoco-")
        self.run = os.path.join(self.folder, "run")
        subprocess.run(["gcc", "-O2", os.path.join(HERE, "beside_mujoco", "run.c"), "-o", self.run, "-lmujoco", "-lm"], check=True)
        self.paths, self.meshes = {}, {}

    def search(self, path):
        name = path.split("/")[0]
        if name not in self.paths:
            self.paths[name] = wild.search_path(self.corpus, name)
        return self.paths[name]

    def rigor(self, *words, seconds=300):
        return subprocess.run([self.program, *words], cwd=self.corpus, capture_output=True, text=True, check=False, timeout=seconds)

    def simulated(self, path, tests):
        done = self.rigor("simulate", path, "--test", tests, "--format", "json", "--fail-on", "never", *self.search(path))
        said = json.loads(done.stdout) if done.stdout else None
        return said[0] if isinstance(said, list) else said

    def urdf(self, path):
        """The model as a tree of URDF, or why there is none."""
        if path.endswith(".urdf"):
            with open(os.path.join(self.corpus, path), encoding="utf-8", errors="replace") as file:
                return ET.fromstring(file.read())
        out = os.path.join(self.folder, "source.urdf")
        if os.path.exists(out):
            os.remove(out)
        done = self.rigor("sdf2urdf", path, "-o", out, "--allow-loss", *self.search(path))
        if not os.path.exists(out):
            raise ValueError("no URDF: " + done.stderr.strip()[-120:])
        return ET.parse(out).getroot()

    def hull(self, name, path):
        """The file of a mesh's convex hull; None when there is none."""
        if name in self.meshes:
            return self.meshes[name]
        where = self.rigor("resolve", name, "--from", path, *self.search(path)).stdout.strip().splitlines()
        found = None
        for candidate in [name] + where + [os.path.join(os.path.dirname(path), name)]:
            file = os.path.join(self.corpus, candidate.replace("file://", "").strip())
            if os.path.isfile(file):
                found = file
                break
        out = os.path.join(self.folder, f"mesh{len(self.meshes)}.stl")
        if found:
            self.rigor("mesh-check", found, "-o", out, "--convex-hull")
        self.meshes[name] = out if os.path.exists(out) else None
        return self.meshes[name]

    def mjcf(self, path):
        root = self.urdf(path)
        friction = {}
        for block in root.findall("gazebo"):
            mu = block.find("mu1")
            if block.get("reference") and mu is not None:
                try:
                    friction[block.get("reference")] = float(mu.get("value") or mu.text)
                except (TypeError, ValueError):
                    pass
        for unused in root.findall("gazebo") + root.findall("transmission") + root.findall("ros2_control"):
            root.remove(unused)
        for link in root.findall("link"):
            for visual in link.findall("visual"):
                link.remove(visual)
            for collision in link.findall("collision"):
                mesh = collision.find("geometry/mesh")
                if mesh is None:
                    continue
                hull = self.hull(mesh.get("filename"), path)
                if hull:
                    mesh.set("filename", hull)
                else:
                    link.remove(collision)
        joints = root.findall("joint")
        for joint in joints:  # limits are rigor's business: a servo may not reach them
            limit = joint.find("limit")
            if limit is not None and joint.get("type") == "revolute":
                lower, upper = float(limit.get("lower") or 0), float(limit.get("upper") or 0)
                if lower >= upper:
                    limit.set("lower", "-1e-6")
                    limit.set("upper", "1e-6")
        children = {joint.find("child").get("link") for joint in joints}
        top = [link.get("name") for link in root.findall("link") if link.get("name") not in children]
        if top and top[0] != "world":
            ET.SubElement(root, "link", name="rigor_world")
            free = ET.SubElement(root, "joint", name="rigor_base", type="fixed")
            ET.SubElement(free, "parent", link="rigor_world")
            ET.SubElement(free, "child", link=top[0])
        extension = ET.Element("mujoco")
        ET.SubElement(extension, "compiler", strippath="false", meshdir="/", balanceinertia="true", boundmass="1e-6", boundinertia="1e-12", fusestatic="false")
        root.insert(0, extension)
        source, out = os.path.join(self.folder, "in.urdf"), os.path.join(self.folder, "out.xml")
        with open(source, "w", encoding="utf-8") as file:
            file.write(ET.tostring(root, encoding="unicode"))
        done = subprocess.run([self.run, "convert", source, out], capture_output=True, text=True, check=False, cwd=self.folder)
        if done.returncode:
            raise ValueError(" ".join(done.stdout.split())[:160])
        return ET.parse(out), friction

    def model(self, path, hangs, has_floor):
        """MJCF with a floor, whose links do not touch each other."""
        tree, friction = self.mjcf(path)
        root = tree.getroot()
        root.find("compiler").set("boundmass", "1e-6")
        root.find("compiler").set("boundinertia", "1e-12")
        option = root.find("option")
        option = ET.SubElement(root, "option") if option is None else option
        for key, value in (("timestep", "0.001"), ("cone", "elliptic"), ("impratio", "10"), ("gravity", "0 0 -9.8")):
            option.set(key, value)
        size = root.find("size")
        size = ET.SubElement(root, "size") if size is None else size
        size.set("nconmax", "2000")
        size.set("njmax", "8000")
        world = root.find("worldbody")
        for holder in world.findall("body[@name='rigor_world']"):  # only a body of the world may have a free joint
            world.remove(holder)
            bodies = holder.findall("body")
            world.extend(bodies)
            if not hangs and bodies:
                bodies[0].insert(0, ET.Element("freejoint", name="rigor_base"))
        for body in world.iter("body"):
            for joint in body.findall("joint"):
                joint.attrib.pop("actuatorfrcrange", None)
            for geom in body.findall("geom"):
                mu = friction.get(body.get("name"), 1)
                geom.set("friction", f"{max(min(mu, 1), 1e-5)} 0.005 0.0001")
                geom.set("priority", "1" if mu < 1 else "0")
                geom.set("contype", "0")
                geom.set("conaffinity", "1")
        for geom in world.findall("geom"):  # of what is fixed to the world
            geom.set("contype", "0")
            geom.set("conaffinity", "0")
        if has_floor:
            ET.SubElement(world, "geom", name="rigor_floor", type="plane", size="100 100 1", friction="1 0.005 0.0001")
        out = os.path.join(self.folder, "model.xml")
        tree.write(out)
        return out

    def limits(self, path):
        """Of each joint: (effort, nearest position to zero)."""
        known = {}
        for joint in self.urdf(path).findall("joint"):
            limit = joint.find("limit")
            if limit is None:
                continue
            effort = float(limit.get("effort") or 0)
            lower, upper = float(limit.get("lower") or 0), float(limit.get("upper") or 0)
            start = min(max(0.0, lower), upper) if joint.get("type") in ("revolute", "prismatic") and lower <= upper else 0.0
            known[joint.get("name")] = (effort if 0 < effort < 1e15 else math.inf, start)
        return known

    def beside(self, path, run):
        last = lambda name: name.rsplit("::", 1)[-1]
        try:
            limits = self.limits(path)
        except (ValueError, ET.ParseError) as problem:
            return str(problem)
        commands = [(last(c["joint"]), c) for c in run["commands"]]
        told = {name for name, c in commands}
        if run["test"] in ("settle", "drop", "drive", "turn"):  # rigor's brakes are no commands
            told |= {name for name, (effort, start) in limits.items() if self.is_limited(path, name)}
        efforts = {name: limits.get(name, (math.inf, 0))[0] for name in told}
        hangs = run["base"] != "free"
        plan = [f"duration {run['duration']}", "down"]
        if run["test"] == "drop":
            plan.append("drop 0.05")
        starts = run.get("start", {})
        plan += [f"start {last(name)} {value}" for name, value in starts.items()]
        plan += [f"start {name} {start}" for name, (_, start) in limits.items() if start and not starts]
        plan += [f"limit {name} {effort}" for name, effort in efforts.items()]
        for name, c in commands:
            if c["kind"] in ("velocity", "position"):
                plan.append(f"{c['kind']} {name} {c['value']} {c['begin']} {c['end']} {c['ramp']}")
        try:
            model = self.model(path, hangs, run["base"] != "hang")
        except (ValueError, ET.ParseError) as problem:
            return str(problem)
        try:
            done = subprocess.run([self.run, model], input="\n".join(plan) + "\n", capture_output=True, text=True, check=False, cwd=self.folder, timeout=240)
        except subprocess.TimeoutExpired:
            return "no answer in 240 s"
        return " ".join((done.stdout + done.stderr).split())[:240]

    def is_limited(self, path, name):
        joint = self.urdf(path).find(f"joint[@name='{name}']")
        return joint is not None and joint.get("type") in ("revolute", "prismatic")


def moved(run):
    """Where rigor's base ended: the first link of the model."""
    poses = list(run["final"]["pose"].values())
    if not poses:
        return ""
    x, y, z, w, i, j, k = poses[0]
    return f"at {x:.3f} {y:.3f} yaw {math.atan2(2 * (w * k + i * j), 1 - 2 * (j * j + k * k)):.3f}"


def show(judge, path, tests, results):
    said = judge.simulated(path, tests)
    if said is None:
        print(f"## {path}: no answer", flush=True)
        return
    print(f"\n## {path}: {said['verdict']}", flush=True)
    for finding in said["diagnostics"]:
        if finding["severity"] != "info":
            print(f"  {finding['severity']} {finding['rule']}: {finding['subject']} {finding['message']}\n      help: {finding['help']}")
    for note in said["notes"] + said["left_out"]:
        print(f"  note: {note}")
    for run in said["runs"]:
        bad = " ".join(f"{m['id']}={m['value']:.4g}({m['verdict']})" for m in run["metrics"] if m["verdict"] != "pass" and m["value"] is not None)
        other = judge.beside(path, run)
        print(f"  {run['test']:12} {run['verdict']:7} {run['base']:5} {moved(run)} {bad}\n      mujoco: {other}", flush=True)
        if results:
            results.write(json.dumps({"path": path, "test": run["test"], "verdict": run["verdict"], "mujoco": other}) + "\n")


def kind_of(judge, path):
    """Which tests fit: what rigor leaves out tells; nothing where nothing moves or nothing can be run."""
    if judge.simulated(path, "drive")["runs"]:
        return "wheels"
    said = judge.simulated(path, "settle,hold")
    if said is None or not said["runs"]:
        return None
    tests = {run["test"] for run in said["runs"]}
    return "joints" if "hold" in tests else "none"


def draw(judge, options):
    """Robots in a random order, not more of one kind than their share, one a folder, none of `--besides`."""
    with open(options.besides, encoding="utf-8") as file:
        known = {os.path.dirname(line.split("\t")[0].strip()) for line in file}
    candidates = []
    for folder, folders, files in os.walk(options.corpus):
        folders.sort()
        for file in sorted(files):
            path = os.path.relpath(os.path.join(folder, file), options.corpus)
            if file.endswith(".urdf") or file == "model.sdf":
                candidates.append(path)
    random.Random(options.seed).shuffle(candidates)
    share = {"wheels": options.draw * 3 // 10, "joints": options.draw * 4 // 10, "none": options.draw - options.draw * 7 // 10}
    for path in candidates:
        if not any(share.values()):
            break
        if os.path.dirname(path) in known:
            continue
        kind = kind_of(judge, path)
        if kind is None or not share[kind]:
            continue
        known.add(os.path.dirname(path))
        share[kind] -= 1
        print(f"{path}\t{TESTS[kind]}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rigor")
    parser.add_argument("--corpus", required=True)
    parser.add_argument("--robots", help="paths and tests, a line each")
    parser.add_argument("--results", help="lines of JSON")
    parser.add_argument("--draw", type=int, help="draw so many robots instead")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--besides", help="robots that are not drawn")
    options = parser.parse_args()
    judge = Judge(options.rigor, options.corpus)
    if options.draw:
        return draw(judge, options)
    results = open(options.results, "w", encoding="utf-8") if options.results else None
    with open(options.robots, encoding="utf-8") as file:
        for line in file:
            path, tests = (line.rstrip("\n").split("\t") + ["settle"])[:2]
            if path and not path.startswith("#"):
                show(judge, path, tests, results)
    return 0


if __name__ == "__main__":
    sys.exit(main())
