#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Makes realistic slips in real robots and worlds, and counts which of them `rigor validate` finds.

    tools/slips.py build/release/rigor --corpus DIR [-j 2] [--per 24] [--seed 1]
    tools/slips.py build/release/rigor --corpus DIR --family plugin --misses
    tools/slips.py build/release/rigor --corpus DIR --suggestions
    tools/slips.py build/release/rigor --tenth --floors     (as CI runs it)

Of each kind (slip_kinds.py, slip_settings.py, slip_writing.py) up to --per slips are made by the seed, spread over
the files. One is found when the mutant has a finding which the file itself has not, at the place: within the
lines that were changed or the element that holds them, or naming that link, joint or sensor. What an edit of the
family `harmless` brings is listed. Nothing is written but the table: a mutant is given on stdin.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import random
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import slip_settings  # noqa: E402,F401  registers its kinds
import slip_writing  # noqa: E402,F401
from slip_kinds import KINDS, joints  # noqa: E402
from slip_text import Text  # noqa: E402

# By many authors, in both formats; relative to the corpus.
FILES = """
SO-ARM100/Simulation/SO100/so100.urdf
anymal_c_simple_description/urdf/anymal.urdf
aws-small-house-world/worlds/small_house.world
create3_sim/irobot_create_gz/irobot_create_gz_bringup/worlds/maze.sdf
dex-urdf/robots/hands/ability_hand/ability_hand_left.urdf
dex-urdf/robots/hands/allegro_hand/allegro_hand_right_glb.urdf
dex-urdf/robots/hands/leap_hand/leap_hand_right.urdf
dex-urdf/robots/hands/panda_gripper/panda_gripper_glb.urdf
example-robot-data/robots/baxter_description/urdf/baxter.urdf
example-robot-data/robots/double_pendulum_description/urdf/double_pendulum_simple.urdf
example-robot-data/robots/finger_edu_description/robots/finger_edu.urdf
example-robot-data/robots/hyq_description/robots/hyq_no_sensors.urdf
example-robot-data/robots/iris_description/robots/iris.urdf
example-robot-data/robots/kinova_description/robots/kinova.urdf
example-robot-data/robots/panda_description/urdf/panda_collision.urdf
example-robot-data/robots/quadruped_description/urdf/quadruped.urdf
example-robot-data/robots/solo_description/robots/solo12.urdf
example-robot-data/robots/ur_description/urdf/ur5_robot.urdf
gazebo_classic_2014/worlds/cart_demo.world
gazebo_models/cart_soft_suspension/model.sdf
gazebo_models/cessna/model.sdf
gazebo_models/create/model.sdf
gazebo_models/follower_vehicle/model.sdf
gazebo_models/husky/model.sdf
gazebo_models/pioneer2dx/model.sdf
gazebo_models/prius_hybrid/model.sdf
gazebo_models/simple_arm/model.sdf
gazebo_models/simple_gripper/model.sdf
gazebo_models/utility_cart/model.sdf
gz-sim/examples/worlds/ackermann_steering.sdf
gz-sim/examples/worlds/contact_sensor.sdf
gz-sim/examples/worlds/diff_drive.sdf
gz-sim/examples/worlds/joint_controller.sdf
gz-sim/examples/worlds/mecanum_drive.sdf
gz-sim/examples/worlds/sensors.sdf
gz-sim/examples/worlds/visualize_lidar.sdf
moveit_resources/fanuc_description/urdf/fanuc.urdf
nav2_minimal_turtlebot_simulation/nav2_minimal_tb3_sim/urdf/turtlebot3_waffle.urdf
rmf_demos/rmf_demos_assets/models/Caddy/model.sdf
rmf_demos/rmf_demos_assets/models/DeliveryRobot/model.sdf
ros_gz_project_template/ros_gz_example_description/models/diff_drive/model.sdf
turtlebot3_simulations/turtlebot3_gazebo/models/turtlebot3_burger/model-1_4.sdf
turtlebot3_simulations/turtlebot3_gazebo/models/turtlebot3_waffle/model.sdf
turtlebot3_simulations/turtlebot3_gazebo/worlds/turtlebot3_house.world
urdf_tutorial/urdf/07-physics.urdf
vrx/vrx_gz/models/roboboat01/model.sdf
""".split()

# Where there is no corpus: models that rigor's own tests take for faultless.
OWN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "testdata", "sane")
OWN_FILES = """
arm.sdf
drone.sdf
gripper.sdf
hauler.urdf
lab.world
quadruped.sdf
rover.sdf
walker.urdf
welder.urdf
""".split()

# Share of slips found at info and at warning, below which --floors fails where a family has so many.
FLOORS = {"joint": (0.6, 0.5), "contact": (0.75, 0.65), "plugin": (0.85, 0.8), "sensor": (0.75, 0.65), "world": (0.85, 0.8),
          "xml": (0.95, 0.95), "numbers": (0.95, 0.9), "names": (0.95, 0.95), "formats": (0.85, 0.85)}
LEAST_COUNT = 10

ENTITIES = ("link", "joint", "plugin", "sensor", "transmission", "light", "include", "physics", "gazebo", "material", "model", "world")
LARGE = ("model", "world", "robot", "sdf")

Mutant = collections.namedtuple("Mutant", "family kind path slip")
Place = collections.namedtuple("Place", "rule severity subject line message help related fix path")


def packages(corpus):
    """--package of each package of the corpus, and of each folder that could be named as one."""
    found = {name: os.path.join(corpus, name) for name in sorted(os.listdir(corpus)) if os.path.isdir(os.path.join(corpus, name))}
    for folder, inner, names in os.walk(corpus):
        if "package.xml" in names:
            found[os.path.basename(folder)] = folder
            inner.clear()
        elif folder.count(os.sep) - corpus.count(os.sep) > 3:
            inner.clear()
    return [f"--package={name}={path}" for name, path in sorted(found.items()) if "=" not in name]


class Rigor:
    def __init__(self, program, corpus, cache):
        self.command = [os.path.abspath(program), "validate", "-", "--format", "json", "--fail-on", "never", "--isolated", *packages(corpus)]
        self.corpus = corpus
        self.environment = dict(os.environ, XDG_CACHE_HOME=cache, LC_ALL="C.UTF-8")

    def places(self, path, data):
        """All places of all findings; what the file's includes and meshes have is left out."""
        run = subprocess.run([*self.command, "--stdin-filename", os.path.join(self.corpus, path)], input=data, cwd=self.corpus,
                             env=self.environment, capture_output=True, check=False)
        if run.returncode not in (0, 1):
            sys.exit(f"{path}: exit {run.returncode}: {run.stderr.decode(errors='replace')[-500:]}")
        found = []
        for one in json.loads(run.stdout)["diagnostics"]:
            related = [r["line"] for r in one["related"] if r["path"] == one["path"] and r["line"]]
            for place in [one, *one["places"]]:
                found.append(Place(one["rule"], one["severity"], place["subject"] or "", place["line"] or 0, one["message"], one["help"] or "",
                                   related, one["fix"], place["path"]))
        return found


def new_places(before, after):
    """Those of the mutant that the file has not: more of a rule, severity, subject and names than before."""
    def key(place):
        return place.rule, place.severity, place.subject, tuple(re.findall(r"'([^']+)'", place.message))

    left = collections.Counter(map(key, before))
    found = []
    for place in after:
        if left[key(place)] > 0:
            left[key(place)] -= 1
        else:
            found.append(place)
    return found


class Target:
    """Where a finding on a slip has to be."""

    def __init__(self, text, slip):
        after = slip.apply(text.data)
        self.lines, self.names = set(), set()
        edits = sorted(slip.edits)
        shift = 0
        for begin, end, new in edits:
            at = begin + shift
            first = after.count(b"\n", 0, at) + 1
            self.lines.update(range(first, first + new.count(b"\n") + 1))
            shift += len(new) - (end - begin)

        def moved(offset):
            return offset + sum(len(new) - (end - begin) for begin, end, new in edits if begin < offset)

        self.anywhere = False
        for element in [slip.element, *slip.also]:
            entity = element.within(*ENTITIES)
            if entity is None or entity.name == "world" and element is slip.element and element.name == "world":
                self.anywhere = True
                continue
            if entity.name not in LARGE:
                begin, end = moved(entity.begin), moved(entity.end)
                self.lines.update(range(after.count(b"\n", 0, begin) + 1, after.count(b"\n", 0, end) + 2))
            self.add_names(text, entity)

    def add_names(self, text, entity):
        name = entity.get("name") or entity.get("reference") or getattr(entity.value("name"), "text", "")
        if name:
            self.names.add(name)
        for joint in joints(text):
            child = joint.child("child")
            child = child.get("link") or getattr(joint.value("child"), "text", "")
            if entity is joint:
                self.names.add(child)
            if entity.name == "link" and child == name:
                self.names.add(joint.get("name"))

    def has(self, place):
        if self.anywhere or place.line in self.lines or any(line in self.lines for line in place.related):
            return True
        words = set(re.split(r"[/ ]|::", place.subject)) | set(re.findall(r"'([^']+)'", place.message))
        return bool(words & self.names)


def chosen(texts, per, rng):
    """Up to `per` slips of each kind: one of each file in turn."""
    for family, name, function in KINDS:
        by_file = []
        for path, text in texts.items():
            slips = list(function(text))
            rng.shuffle(slips)
            by_file.append([Mutant(family, name, path, slip) for slip in slips])
        rng.shuffle(by_file)
        taken = []
        while len(taken) < per and any(by_file):
            for slips in by_file:
                if slips and len(taken) < per:
                    taken.append(slips.pop())
        yield from taken


def restored(original, mutated, fix):
    """Whether the fix of a finding gives back the file, numbers to 1e-9."""
    for edit in sorted(fix["edits"], key=lambda edit: -edit["begin"]):
        mutated = mutated[:edit["begin"]] + edit["text"].encode() + mutated[edit["end"]:]
    a, b = original.split(), mutated.split()
    return len(a) == len(b) and all(x == y or close(x, y) for x, y in zip(a, b))


def close(x, y):
    split = re.compile(rb"([-+.\deE]+)")
    xs, ys = split.split(x), split.split(y)
    if len(xs) != len(ys):
        return False
    for p, q in zip(xs, ys):
        if p != q:
            try:
                if abs(float(p) - float(q)) > 1e-9 * max(1, abs(float(p))):
                    return False
            except ValueError:
                return False
    return True


class Campaign:
    def __init__(self, a):
        self.a = a
        corpus, files = (os.path.abspath(a.corpus), FILES) if a.corpus else (os.path.abspath(OWN), OWN_FILES)
        self.texts = {}
        for path in files:
            with open(os.path.join(corpus, path), "rb") as file:
                self.texts[path] = Text(file.read())
        self.cache = tempfile.TemporaryDirectory(prefix="rigor-slips-")
        self.rigor = Rigor(a.rigor, corpus, self.cache.name)
        mutants = list(chosen(self.texts, a.per, random.Random(a.seed)))
        if a.tenth:
            mutants = mutants[::10]
        self.mutants = [m for m in mutants if (not a.family or m.family in a.family) and (not a.kind or a.kind in m.kind)]
        self.before = {}
        self.misses, self.noise, self.by_rule = [], [], collections.Counter()
        self.count = collections.defaultdict(lambda: [0, 0, 0])  # by family and kind: slips, found at info, at warning
        self.suggested = collections.defaultdict(lambda: [0, 0])  # fixes, those that give back the file
        self.texts_of = collections.defaultdict(set)  # (old, new) of the edits of a kind

    def judge(self, mutant):
        text = self.texts[mutant.path]
        mutated = mutant.slip.apply(text.data)
        return mutated, new_places(self.before[mutant.path], self.rigor.places(mutant.path, mutated))

    def note(self, mutant, mutated, places):
        text = self.texts[mutant.path]
        count = self.count[mutant.family, mutant.kind]
        count[0] += 1
        self.texts_of[mutant.family, mutant.kind].update(
            (text.data[begin:end], new.strip()) for begin, end, new in mutant.slip.edits if text.data[begin:end] != new)
        line = text.line(mutant.slip.edits[0][0])
        if mutant.family == "harmless":
            # A name that was changed throughout makes another subject, and no other count.
            before = collections.Counter(place.rule for place in self.before[mutant.path])
            after = collections.Counter(place.rule for place in places) if mutant.kind != "rename throughout" else collections.Counter()
            if mutant.kind == "rename throughout":
                for place in self.rigor.places(mutant.path, mutated):
                    after[place.rule] += 1
                after -= before
            for rule in after:
                self.noise.append(f"{mutant.kind}: {mutant.path}:{line}: {rule}")
            count[1] += bool(after)
            return
        target = Target(text, mutant.slip)
        hits = [place for place in places if target.has(place)]
        strong = [place for place in hits if place.severity != "info"]
        count[1] += bool(hits)
        count[2] += bool(strong)
        for rule in {place.rule for place in hits}:
            self.by_rule[mutant.kind, rule] += 1
        fixes = [place.fix for place in hits if place.fix]
        if fixes:
            self.suggested[mutant.family, mutant.kind][0] += 1
            right = mutant.slip.right(text.data)
            self.suggested[mutant.family, mutant.kind][1] += any(restored(right, mutated, fix) for fix in fixes)
        if not strong:
            elsewhere = sorted({place.rule for place in places} - {place.rule for place in hits})
            said = ",".join(sorted({place.rule for place in hits}))
            begin, end, new = mutant.slip.edits[0]
            self.misses.append(f"{mutant.family}/{mutant.kind}: {mutant.path}:{line}: "
                               f"{text.data[begin:end][:40].decode(errors='replace')!r} -> {new[:40].decode(errors='replace')!r}"
                               f"{' info: ' + said if said else ''}{' elsewhere: ' + ','.join(elsewhere) if elsewhere else ''}")

    def run(self):
        with concurrent.futures.ThreadPoolExecutor(self.a.jobs) as pool:
            paths = list(self.texts)
            self.before = dict(zip(paths, pool.map(lambda path: self.rigor.places(path, self.texts[path].data), paths)))
            for done, (mutant, (mutated, places)) in enumerate(zip(self.mutants, pool.map(self.judge, self.mutants))):
                self.note(mutant, mutated, places)
                if sys.stderr.isatty() and done % 20 == 0:
                    print(f"{done} of {len(self.mutants)}", end="\r", file=sys.stderr)
        self.table()
        return self.below() if self.a.floors else 0

    def families(self):
        total = collections.defaultdict(lambda: [0, 0, 0])
        for (family, _), count in self.count.items():
            for name in (family, *(["all"] if family != "harmless" else [])):
                total[name] = [a + b for a, b in zip(total[name], count)]
        return total

    def table(self):
        print("| family | kind | n | info | warning |\n|---|---|---:|---:|---:|")
        for (family, name), (n, info, warning) in self.count.items():
            if not self.a.brief:
                print(f"| {family} | {name} | {n} | {info} | {warning} |")
        print("\n| family | n | at info | at warning |\n|---|---:|---:|---:|")
        for family, (n, info, warning) in self.families().items():
            print(f"| {family} | {n} | {info / n:.1%} | {warning / n:.1%} |")
        if self.a.misses:
            print("\nnot found at warning:", *self.misses, sep="\n  ")
        if self.a.rules:
            print("\nfound by:", *(f"{kind}: {rule} {n}" for (kind, rule), n in sorted(self.by_rule.items())), sep="\n  ")
        if self.a.suggestions:
            for title, lost in (("with a fix", False), ("with a fix, of kinds that leave nothing of the value", True)):
                rows = [(kind, row) for kind, row in self.suggested.items() if self.is_lost(kind) == lost]
                print(f"\n| kind | {title} | that gives back the file |\n|---|---:|---:|")
                for (family, name), (n, good) in rows:
                    print(f"| {family}: {name} | {n} | {good} |")
                print(f"| **all** | {sum(row[0] for _, row in rows)} | {sum(row[1] for _, row in rows)} |")
        if self.noise:
            print("\nharmless edits that bring a finding:", *self.noise, sep="\n  ")

    def is_lost(self, kind):
        """Whether what was written cannot be told from what the slip leaves: always the same text, or none."""
        olds, news = ({pair[i] for pair in self.texts_of[kind]} for i in (0, 1))
        return news <= {b"", b"0", b"1"} or len(news) <= 2 < len(olds)

    def below(self):
        """1 when a family is found less often than its floors, or a harmless edit brings a finding."""
        low = [family for family, (n, info, warning) in self.families().items()
               if family in FLOORS and n >= LEAST_COUNT and (info / n < FLOORS[family][0] or warning / n < FLOORS[family][1])]
        for family in low:
            print(f"{family}: below its floors of {FLOORS[family][0]:.0%} at info and {FLOORS[family][1]:.0%} at warning")
        return 1 if low or self.noise else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rigor")
    parser.add_argument("--corpus", default=os.environ.get("RIGOR_CORPUS"), help="folder of the real models; else those of testdata")
    parser.add_argument("--per", type=int, default=24, help="slips of a kind at most")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tenth", action="store_true", help="one mutant in ten")
    parser.add_argument("--family", action="append")
    parser.add_argument("--kind", help="a part of the kind's name")
    parser.add_argument("--misses", action="store_true", help="list what is not found at warning")
    parser.add_argument("--rules", action="store_true", help="list the rules that find each kind")
    parser.add_argument("--suggestions", action="store_true", help="apply fixes, and compare with the file")
    parser.add_argument("--floors", action="store_true", help="exit 1 when less is found than should be")
    parser.add_argument("--brief", action="store_true", help="families only")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count())
    sys.exit(Campaign(parser.parse_args()).run())


if __name__ == "__main__":
    main()
