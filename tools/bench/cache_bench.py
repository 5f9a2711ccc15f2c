#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""The cache of meshes against runs without it: user and system time, and answers.

    tools/bench/cache_bench.py build/release/rigor [--entries 100000] [--processes 8] [--runs 5]

Meshes of 1,500 to 100,000 triangles are checked without the cache, with an empty one, with a full one (of as many
entries as it holds), with one that is much too full, with a warm one, and by several processes at once. Exit 1 when
the cache costs more than 5 % of a run, changes an answer, or exceeds its size.
"""

import argparse
import hashlib
import math
import os
import resource
import struct
import subprocess
import sys
import tempfile

LIMIT = 1.05  # of the time without
MAX_ENTRIES = 16384  # FolderStore::kMaxEntries
OVERSHOOT = 1.02  # what is written between two listings of a part
SIZES = [1500, 3000, 10000, 100000]  # triangles


def write_blob(path, triangles, seed):
    """A closed surface in binary STL: a sphere whose radius varies with the seed."""
    n = max(3, int(math.sqrt(triangles / 2)))
    rows = []
    for i in range(n + 1):
        t = math.pi * i / n
        ring = []
        for j in range(n):
            f = 2 * math.pi * j / n
            r = 1 + 0.1 * math.sin(3 * t + seed) * math.sin(2 * f + seed) if 0 < i < n else 1
            s = math.sin(t) if 0 < i < n else 0
            ring.append((r * s * math.cos(f), r * s * math.sin(f), r * math.cos(t)))
        rows.append(ring)
    facets = []
    for i in range(n):
        for j in range(n):
            a, b = rows[i][j], rows[i][(j + 1) % n]
            c, d = rows[i + 1][(j + 1) % n], rows[i + 1][j]
            if i > 0:
                facets.append((a, d, b))
            if i < n - 1:
                facets.append((b, d, c))
    with open(path, "wb") as out:
        out.write(b" " * 80 + struct.pack("<I", len(facets)))
        for facet in facets:
            out.write(struct.pack("<12fH", 0, 0, 0, *[x for p in facet for x in p], 0))


def fill(folder, count):
    """Entries of somebody else's meshes, as the store names them: a part of 64 by the key's first byte."""
    store = os.path.join(folder, "rigor")
    for part in range(64):
        os.makedirs(os.path.join(store, f"{part:02x}"), exist_ok=True)
    names = set()
    for i in range(count):
        key = hashlib.md5(str(i).encode()).hexdigest()
        with open(os.path.join(store, f"{int(key[:2], 16) % 64:02x}", key + ".entry"), "wb") as out:
            out.write(b"x" * 2000)
        names.add(key + ".entry")
    return names


def count(folder):
    return sum(name.endswith(".entry") for _, _, names in os.walk(folder) for name in names)


def environment(cache):
    env = dict(os.environ)
    if cache is None:
        env["RIGOR_CACHE"] = "off"
    else:
        env["XDG_CACHE_HOME"] = cache
    return env


def seconds_of(command, cache, processes=1):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    running = [
        subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=environment(cache))
        for _ in range(processes)
    ]
    answers = {process.communicate()[0] for process in running}
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return used / processes, answers


class Bench:
    def __init__(self, options):
        self.options = options
        self.failed = False

    def check(self, good, text):
        self.failed = self.failed or not good
        print(("  " if good else "! ") + text, flush=True)

    def compare(self, what, command, right, make_cache, processes=1):
        """Pairs of runs, without the cache and with it; of each the least time, which is least disturbed."""
        without, with_cache = [], []
        for _ in range(self.options.runs):
            cache = make_cache()
            without.append(seconds_of(command, None, processes)[0])
            used, answers = seconds_of(command, cache, processes)
            with_cache.append(used)
            if answers != right:
                self.check(False, f"{what}: another answer")
        share = min(with_cache) / min(without)
        self.check(
            share <= LIMIT,
            f"{what}: {1000 * min(with_cache):.1f} ms with, {1000 * min(without):.1f} ms without, {share:.2f}",
        )

    def run(self):
        with tempfile.TemporaryDirectory() as work:
            caches = []
            for name, entries in (("full", MAX_ENTRIES), (f"{self.options.entries} entries", self.options.entries)):
                cache = os.path.join(work, f"cache_{entries}")
                caches.append((name, entries, cache, fill(cache, entries)))
            for size in SIZES:
                files = max(1, min(20, 60000 // size))
                meshes = [os.path.join(work, f"{size}_{i}.stl") for i in range(files)]
                for i, path in enumerate(meshes):
                    write_blob(path, size, size + i)
                    os.utime(path, (1e9, 1e9))
                self.of_size(work, size, meshes, caches)
        return 1 if self.failed else 0

    def of_size(self, work, size, meshes, caches):
        command = [self.options.rigor, "mesh-check", "--format", "json", *meshes]
        right = seconds_of(command, None)[1]
        print(f"{len(meshes)} meshes of {size} triangles")
        fresh = iter(range(10**6))

        def empty():
            return os.path.join(work, f"empty_{size}_{next(fresh)}")

        self.compare("empty", command, right, empty)
        for name, entries, cache, others in caches:

            def forgotten(cache=cache, others=others):
                # The meshes' own entries, that is.
                for folder, _, names in os.walk(cache):
                    for one in names:
                        if one not in others:
                            os.remove(os.path.join(folder, one))
                return cache

            self.compare(name, command, right, forgotten)
            self.compare(f"{name}, {self.options.processes} at once", command, right, forgotten, self.options.processes)
            if entries == MAX_ENTRIES:
                kept = count(cache)
                self.check(kept <= OVERSHOOT * MAX_ENTRIES, f"size: {kept} entries")
            self.compare("warm", command, right, lambda cache=cache: cache)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rigor")
    parser.add_argument("--entries", type=int, default=100000)
    parser.add_argument("--processes", type=int, default=8)
    parser.add_argument("--runs", type=int, default=5)
    return Bench(parser.parse_args()).run()


if __name__ == "__main__":
    sys.exit(main())
