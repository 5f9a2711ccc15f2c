#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Damages real models and meshes, and holds rigor to what SECURITY.md promises of them.

    tools/attack.py build/release/rigor --corpus DIR... [--count 20000] [--first 0] [-j 2]
    tools/attack.py build/release/rigor --corpus DIR --only 1234 --keep /tmp/case

Each number is one damaged file, the same for the same corpus and --seed: bytes flipped, cut out, doubled or
inserted, words swapped for others of the file or for what readers stumble over. Files go through the commands in
groups, and each through some by itself, by turns: of 20,000 files, each command sees 3,000 and more. What a group
does wrong is sought file by file. No run may end by a signal
or with exit 3, take longer than --seconds of CPU time or more memory than --megabytes, or write outside of its
folder for output. Exit 1 when one did.
"""

import argparse
import collections
import concurrent.futures
import ctypes
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

MODELS = (".sdf", ".world", ".urdf", ".xacro", ".srdf")
MJCF = ".xml"  # where it begins with <mujoco>: most others are something else
MESHES = (".stl", ".obj", ".dae", ".glb", ".gltf", ".ply")
GROUP = 20
ENOUGH_RUNS = 50  # of which one at least is not refused for what the file is
MOST_BESIDE = 40  # files and folders beside the original that the damaged one finds
PR_SET_CHILD_SUBREAPER = 36  # <linux/prctl.h>
# Alone, file by file: {0} is the file, out/ the folder for what is written. Each file takes its turn at --alone of them.
OF_MODEL = [
    "inertia {0} --material abs", "{convert} {0} -o out/{name}.converted", "simulate {0} --test settle",
    "render {0} -o out/{name}.png --size 120x90", "view {0} -o out/{name}.html", "diff {0} {0}",
    "{convert} {0} --allow-loss -o out/{name}.lossy", "inertia {0} --diff", "expand {0} -o out/{name}.xml",
    "validate {0} --fix --diff", "inspect {0}",
]
OF_MESH = [
    "mesh-check {0} --format json", "mesh-check {0} --repair -o out/{name}.repaired.obj",
    "mesh-check {0} --reduce 0.5 -o out/{name}.less.glb", "mesh-check {0} --convex-hull -o out/{name}.hull.stl",
    "mesh-check {0} --convex-pieces 4 -o out/{name}.piece.stl", "mesh-check {0} --split material -o out/{name}.part.obj",
    "mesh-check {0} --split component -o out/{name}.body.dae", "mesh-check {0} --fit best",
    "inertia mesh {0} --density 1000", "inertia {scene} --material abs", "render {scene} -o out/{name}.png --size 120x90",
    "view {scene} -o out/{name}.html", "validate {scene}", "simulate {scene} --test settle",
    "sdf2urdf {scene} -o out/{name}.urdf",
]
# Of each SDF file: of several at once, one that is not SDF any more is refused for all.
OF_SDF = "upgrade {0} --to 1.9 --diff"
# Of a group at once.
OF_GROUP = ["validate {all}", "mesh-check {meshes} --format json", "report {models} --no-simulate --no-pictures -o out/report.html",
            "fmt {models} --diff"]

NUMBERS = [b"0", b"-0", b"-1", b"1e308", b"-1e308", b"1e-320", b"1e999", b"nan", b"inf", b"-inf", b"4294967295",
           b"2147483648", b"18446744073709551616", b"0x10", b"1,5", b"1e", b"", b"00000000000000000001",
           b"3.402823466e+39", b"1 2 3 4 5 6 7", b"65536", b"1000000000"]
WORDS = [b"../../../../../x", b"/proc/self/environ", b"model://", b"package://", b"file:///", b"https://x/y", b"\x00",
         b"\xff\xfe", b"\xef\xbb\xbf", b"&#0;", b"&lt;", b"&amp;&amp;", b"<!--", b"-->", b"<![CDATA[", b"]]>", b"<?", b"<!DOCTYPE a [",
         b"::", b"__model__", b"world", b"${", b"${2**9999}", b"$(find x)", b"</link>", b"<link name='x'>", b"<model>",
         b"<include><uri>model.sdf</uri></include>", b"<static>true</static>", b"<scale>0 0 0</scale>",
         b"<mimic joint='x'/>", b"'", b'"', b">", b"<", b"/>", b"\n" * 50, b" " * 300, b"%s%n", b"a" * 5000]


def is_mjcf(path):
    if not path.lower().endswith(MJCF):
        return False
    with open(path, "rb") as file:
        return b"<mujoco" in file.read(4000)


def real_files(folders, largest=2_000_000):
    """Models and meshes of so many bytes at most, by folder and name; links are left out."""
    found = []
    for folder in folders:
        for place, inner, names in os.walk(folder):
            inner.sort()
            for name in sorted(names):
                path = os.path.join(place, name)
                if name.lower().endswith((*MODELS, *MESHES, MJCF)) and not os.path.islink(path):
                    if 0 < os.path.getsize(path) <= largest and (is_mjcf(path) or not name.lower().endswith(MJCF)):
                        found.append(path)
    return found


class Damage:
    """One damage after another, each a function from bytes to bytes."""

    def __init__(self, rng, text):
        self.rng, self.text = rng, text

    def at(self, data):
        return self.rng.randrange(len(data) + 1)

    def flip(self, data):
        data = bytearray(data)
        for _ in range(self.rng.choice([1, 1, 4, 32])):
            data[self.rng.randrange(len(data))] ^= 1 << self.rng.randrange(8)
        return bytes(data)

    def cut(self, data):
        at = self.at(data)
        return data[:at] + data[at + self.rng.choice([1, 10, 200, len(data)]):]

    def double(self, data):
        at, size = self.at(data), self.rng.choice([8, 100, 3000])
        return data[:at] + data[at:at + size] * self.rng.choice([2, 5, 40]) + data[at + size:]

    def insert(self, data):
        at = self.at(data)
        what = self.rng.choice(WORDS + NUMBERS) if self.text else os_bytes(self.rng, self.rng.choice([1, 4, 64]))
        return data[:at] + what + data[at:]

    def number(self, data):
        if not self.text:
            at = self.at(data)
            what = self.rng.choice([b"\xff" * 4, b"\0" * 4, b"\x7f\xff\xff\xff", b"\0\0\xc0\x7f", b"\0\0\x80\x7f", b"\xff\xff\x7f\x7f"])
            return data[:at] + what + data[at + 4:]
        found = list(re.finditer(rb"-?\d+(\.\d+)?([eE][-+]?\d+)?", data))
        if not found:
            return self.insert(data)
        one = self.rng.choice(found)
        return data[:one.start()] + self.rng.choice(NUMBERS) + data[one.end():]

    def word(self, data):
        found = list(re.finditer(rb"[A-Za-z_][\w:./-]*", data)) if self.text else []
        if not found:
            return self.number(data)
        one = self.rng.choice(found)
        by = self.rng.choice(WORDS) if self.rng.random() < 0.3 else self.rng.choice(found).group()
        return data[:one.start()] + by + data[one.end():]

    def of(self, data):
        kinds = [self.flip, self.cut, self.double, self.insert, self.number, self.number, self.word, self.word]
        for _ in range(self.rng.choice([1, 1, 2, 3, 8])):
            data = self.rng.choice(kinds)(data) if data else b"<"
        return data


def os_bytes(rng, count):
    return bytes(rng.randrange(256) for _ in range(count))


class Case:
    """A damaged file in a folder of its own, what stood beside the original linked to it."""

    def __init__(self, root, number, seed, files):
        rng = random.Random(f"{seed} {number}")
        models = [path for path in files if path.lower().endswith(MODELS)]
        mjcf = [path for path in files if path.lower().endswith(MJCF)]
        meshes = [path for path in files if path.lower().endswith(MESHES)]
        self.original = rng.choice(rng.choice([some for some in (models, models, mjcf, meshes, meshes) if some]))
        self.number = number
        self.folder = os.path.join(root, f"case{number}")
        name = os.path.basename(self.original)
        self.path = os.path.join(f"case{number}", name)
        self.mesh = name.lower().endswith(MESHES)
        self.scene = os.path.join(f"case{number}", "scene.sdf")
        os.makedirs(self.folder)
        beside = os.path.dirname(self.original)
        for other in sorted(os.listdir(beside))[:MOST_BESIDE]:
            if other not in (name, "scene.sdf", "rigor.toml"):
                os.symlink(os.path.join(os.path.abspath(beside), other), os.path.join(self.folder, other))
        with open(self.original, "rb") as file:
            data = file.read()
        text = b"\0" not in data[:2000]
        with open(os.path.join(self.folder, name), "wb") as file:
            file.write(Damage(rng, text).of(data))
        if self.mesh:
            shape = f"<geometry><mesh><uri>{name}</uri></mesh></geometry>"
            with open(os.path.join(self.folder, "scene.sdf"), "w", encoding="utf-8") as file:
                file.write(f"<sdf version='1.9'><model name='m'><link name='l'><inertial><mass>1</mass></inertial>"
                           f"<collision name='c'>{shape}</collision><visual name='v'>{shape}</visual></link></model></sdf>")

    def commands(self, alone):
        """`alone` of them, or all."""
        lines = OF_MESH if self.mesh else OF_MODEL
        chosen = lines if alone is None else [lines[(self.number * alone + k) % len(lines)] for k in range(alone)]
        ending = os.path.splitext(self.path.lower())[1]
        convert = {".urdf": "urdf2sdf", ".xacro": "urdf2sdf", MJCF: ("mjcf2sdf", "mjcf2urdf")[self.number % 2]}.get(ending, "sdf2urdf")
        if self.path.lower().endswith((".sdf", ".world")):
            chosen = [*chosen, OF_SDF]
        for line in chosen:
            yield [part.format(self.path, name=f"n{self.number}", scene=self.scene, convert=convert) for part in line.split()]


Run = collections.namedtuple("Run", "exit seconds megabytes stderr")


class Runner:
    """Runs rigor in a folder, with a home of its own and no cache."""

    def __init__(self, a, root):
        self.a, self.root = a, root
        self.room = os.path.join(root, "above", "room")
        self.tmp = os.path.join(root, "tmp")
        for folder in ("home", "tmp"):
            os.makedirs(os.path.join(root, folder))
        os.makedirs(os.path.join(self.room, "out"))
        self.environment = {"PATH": os.environ["PATH"], "HOME": os.path.join(root, "home"), "TMPDIR": self.tmp,
                            "RIGOR_CACHE": "off", "LC_ALL": "C.UTF-8"}

    def run(self, arguments):
        with tempfile.TemporaryFile() as err:
            child = subprocess.Popen([os.path.abspath(self.a.rigor), *arguments], cwd=self.room, env=self.environment,
                                     stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=err, start_new_session=True)
            # CPU time is the measure, since others may use the machine; the clock ends what waits forever.
            timer = threading.Timer(20 * self.a.seconds, os.killpg, (child.pid, signal.SIGKILL))
            timer.start()
            _, status, used = os.wait4(child.pid, 0)
            seconds, kilobytes = used.ru_utime + used.ru_stime, used.ru_maxrss
            # Workers that it has not waited for come to us.
            while True:
                try:
                    _, _, used = os.wait4(-child.pid, 0)
                except ChildProcessError:
                    break
                seconds, kilobytes = seconds + used.ru_utime + used.ru_stime, max(kilobytes, used.ru_maxrss)
            timer.cancel()
            child.returncode = os.waitstatus_to_exitcode(status)
            err.seek(max(0, err.seek(0, os.SEEK_END) - 2000))
            return Run(child.returncode, seconds, kilobytes / 1024, err.read().decode(errors="replace"))

    def written(self):
        """All that lies in the tree but in the folder for output, with sizes."""
        found = {}
        for place, inner, names in os.walk(self.root):
            if os.path.relpath(place, self.room) == "out":
                inner.clear()
                continue
            if place == self.tmp:
                inner.clear()
            for name in names:
                status = os.lstat(os.path.join(place, name))
                found[os.path.join(place, name)] = (status.st_size, status.st_mtime_ns)
        return found


class Campaign:
    def __init__(self, a):
        self.a = a
        self.files = real_files(a.corpus, a.largest)
        self.lock = threading.Lock()
        self.runs = collections.Counter()
        self.seen = collections.Counter()  # files by command
        self.exits = collections.Counter()  # by command and code
        self.most = {}  # seconds, megabytes by command
        self.faults = []

    def judge(self, run, arguments, files):
        """What is wrong with a run of so many files; nothing when all is well."""
        with self.lock:
            self.runs[arguments[0]] += 1
            self.seen[arguments[0]] += files
            self.exits[arguments[0], run.exit] += 1
            if files == 1:
                seconds, megabytes = self.most.get(arguments[0], (0, 0))
                self.most[arguments[0]] = (max(seconds, run.seconds), max(megabytes, run.megabytes))
        if run.exit < 0:
            return f"signal {-run.exit}"
        if run.exit not in (0, 1, 2):
            return f"exit {run.exit}: {run.stderr.strip()[-300:]}"
        if run.seconds > self.a.seconds * files:
            return f"{run.seconds:.1f} s"
        if run.megabytes > self.a.megabytes:
            return f"{run.megabytes:.0f} MB"
        return None

    def check(self, runner, arguments, cases):
        run = runner.run(arguments)
        wrong = self.judge(run, arguments, len(cases))
        if wrong and len(cases) == 1:
            self.fault(cases[0].number, f"{wrong}: {' '.join(arguments)}  ({cases[0].original})")
        return not wrong

    def fault(self, number, what):
        with self.lock:
            self.faults.append((number, what))
            print(f"{number}: {what}", flush=True)

    def group(self, numbers):
        with tempfile.TemporaryDirectory(prefix="rigor-attack-") as root:
            runner = Runner(self.a, root)
            cases = [Case(runner.room, number, self.a.seed, self.files) for number in numbers]
            before = runner.written()
            for line in OF_GROUP:
                self.together(runner, line, cases)
            for case in cases:
                for arguments in case.commands(self.a.alone):
                    self.check(runner, arguments, [case])
            after = runner.written()
            for path, _ in sorted(set(after.items()) ^ set(before.items())):
                self.fault(numbers[0], f"of the group from this number a command wrote {os.path.relpath(path, root)}")
            if self.a.keep:
                shutil.copytree(runner.room, self.a.keep, symlinks=True, dirs_exist_ok=True)
            return len(cases)

    def together(self, runner, line, cases):
        if "{meshes}" in line:
            cases = [case for case in cases if case.mesh]
        if "{models}" in line:
            cases = [case for case in cases if not case.mesh]
        if not cases:
            return

        def arguments(some):
            paths = [case.path for case in some]
            words = []
            for word in line.split():
                words += paths if word in ("{all}", "{meshes}", "{models}") else [word]
            return words

        # One that fails in company is sought by itself.
        if not self.check(runner, arguments(cases), cases) and len(cases) > 1:
            for case in cases:
                self.check(runner, arguments([case]), [case])

    def run(self):
        numbers = [self.a.only] if self.a.only is not None else list(range(self.a.first, self.a.first + self.a.count))
        groups = [numbers[i:i + GROUP] for i in range(0, len(numbers), GROUP)]
        begin, done = time.time(), 0
        with concurrent.futures.ThreadPoolExecutor(self.a.jobs) as pool:
            for count in pool.map(self.group, groups):
                done += count
                if sys.stderr.isatty() or done % 1000 == 0:
                    print(f"{done} of {len(numbers)} files, {sum(self.runs.values())} runs, {len(self.faults)} faults, "
                          f"{time.time() - begin:.0f} s", file=sys.stderr, flush=True)
        print(f"{done} damaged files of {len(self.files)} real ones, {sum(self.runs.values())} runs, {len(self.faults)} faults")
        for command, count in sorted(self.runs.items()):
            # A line that the program refuses for its options has tested nothing.
            if count >= ENOUGH_RUNS and self.exits[command, 2] == count:
                self.fault(-1, f"{command}: every run ended with exit 2")
            seconds, megabytes = self.most.get(command, (0, 0))
            codes = ", ".join(f"{self.exits[command, code]} exit {code}" for code in range(3))
            print(f"  {command:12} {self.seen[command]:7} files in {count:6} runs ({codes}); alone at most {seconds:5.1f} s and {megabytes:5.0f} MB")
        return 1 if self.faults else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rigor")
    parser.add_argument("--corpus", nargs="+", required=True, metavar="DIR", help="folders of real models and meshes")
    parser.add_argument("--count", type=int, default=20000, help="damaged files")
    parser.add_argument("--first", type=int, default=0, help="number of the first one")
    parser.add_argument("--only", type=int, help="the one of this number, by all commands")
    parser.add_argument("--keep", help="copy the damaged files there")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--largest", type=int, default=2_000_000, help="bytes of a file: larger ones say nothing new, and take long")
    parser.add_argument("--alone", type=int, default=4, help="commands for each file by itself")
    parser.add_argument("--seconds", type=float, default=10, help="CPU time of a run, of one file")
    parser.add_argument("--megabytes", type=float, default=1100, help="memory of a run: 1 GiB for an import, and what the program has itself")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count())
    a = parser.parse_args()
    if a.only is not None:
        a.alone = None
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    campaign = Campaign(a)
    if not campaign.files:
        sys.exit("there is no model or mesh in " + " ".join(a.corpus))
    sys.exit(campaign.run())


if __name__ == "__main__":
    main()
