#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""What `rigor edit simplify-collisions` makes of robots, in links: a table, and the share of links that get much simpler.

    tools/simplified.py RIGOR FILE ... [--max-error E] [--links N]

A link gets much simpler when each of its meshes that collide becomes a primitive or has at most a fifth of its triangles
afterwards, within the two-sided distance that the verb keeps (2 % of the link's size by default). Links with a mesh that
is not found, or that the verb does not measure for another reason than its shape, are not counted. Of files of less than
N links with meshes (default 1) nothing is said. Nothing is written.
"""

import argparse
import collections
import re
import subprocess

LINE = re.compile(r"collision (.+?)/.+?: (?:(left): (.*)|(.*?) for (?:(\d+) of )?(\d+) triangles: \S+ m off \((\S+) %.*volume (\S+) %.*)$")
NOT_MEASURED = ("is not found", "computed from its", "it is a part", "several shapes", "cannot be read", "scale is zero")
FEWER = 5


class Robot:
    def __init__(self, program, path, max_error):
        command = [program, "edit", "simplify-collisions", path, "--isolated", "--max-error", str(max_error)]
        said = subprocess.run(command, capture_output=True, text=True, check=False).stderr
        self.shapes = collections.Counter()
        self.links = {}
        self.worst, self.volume = 0.0, 0.0
        # A refusal has its collisions in one line.
        for line in re.split(r"\n|; (?=collision )|simpler shape: ", said):
            found = LINE.search(line.removesuffix(" is not changed"))
            if found:
                self.take(*found.groups())

    def take(self, link, left, why, shape, after, before, error, volume):
        if left:
            if any(reason in why for reason in NOT_MEASURED):
                self.links.pop(link, None)
                return
            simpler = False
        else:
            simpler = after is None or int(before) >= FEWER * int(after)
            self.shapes[re.sub(r"\d+ convex", "convex", shape)] += 1
            self.worst = max(self.worst, float(error))
            self.volume = max(self.volume, abs(float(volume)))
        self.links[link] = self.links.get(link, True) and simpler

    def simpler(self):
        return sum(self.links.values())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rigor")
    parser.add_argument("file", nargs="+")
    parser.add_argument("--max-error", type=float, default=0.02)
    parser.add_argument("--links", type=int, default=1)
    options = parser.parse_args()
    links = simpler = robots = 0
    print("| robot | links | much simpler | shapes | largest distance, % | largest error of volume, % |\n|---|---|---|---|---|---|")
    for path in options.file:
        robot = Robot(options.rigor, path, options.max_error)
        if len(robot.links) < options.links:
            continue
        robots += 1
        links += len(robot.links)
        simpler += robot.simpler()
        shapes = ", ".join(f"{count} {shape}" for shape, count in robot.shapes.most_common())
        print(f"| {path} | {len(robot.links)} | {robot.simpler()} | {shapes} | {robot.worst:.2g} | {robot.volume:.2g} |", flush=True)
    print(f"\n{simpler} of {links} links in {robots} robots" + (f": {100 * simpler / links:.0f} %" if links else ""))


if __name__ == "__main__":
    main()
