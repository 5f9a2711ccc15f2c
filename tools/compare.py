#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the official checkers over testdata/faults, and writes docs/comparison.md.

    tools/compare.py build/release/rigor > docs/comparison.md

Needs `ign sdf` (libsdformat-dev, ignition-tools) and `check_urdf` (liburdfdom-tools).
"""

import json
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FAULTS = os.path.join(ROOT, "testdata", "faults")
SANE = os.path.join(ROOT, "testdata", "sane")
SECONDS = 20  # a file that is not checked by then never is: check_urdf goes round in a loop of joints

SILENT, SAYS, REFUSES = "silent", "says", "refuses"


def run(command, folder):
    """Exit code and all output, without colors; None when it did not end."""
    environment = dict(os.environ, SDF_PATH=folder, IGN_FILE_PATH=folder)
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=SECONDS, env=environment, check=False)
    except subprocess.TimeoutExpired:
        return None, ""
    text = done.stdout.decode("utf-8", "replace")
    return done.returncode, re.sub(r"\x1b\[[0-9;]*m", "", text)


def complaints(text, path):
    """Lines that are an error or a warning, without what differs from file to file anyhow."""
    lines = [line for line in text.split("\n") if re.search(r"error|warn|fail|not ", line, re.I)]
    lines = [line for line in lines if "backward" not in line]
    return {re.sub(r"\bline \d+|:\d+", "", line.replace(path, "FILE")) for line in lines}


def sdf_check(path):
    code, text = run(["ign", "sdf", "-k", path], os.path.dirname(path))
    return code is not None and code == 0 and "Valid." in text, complaints(text, path)


def urdf_check(path):
    code, text = run(["check_urdf", path], os.path.dirname(path))
    return code == 0, complaints(text, path)


def verdict(check, path, base):
    """What a checker makes of a fault: only what it does not say of the base counts."""
    taken, said = check(path)
    taken_base, said_base = base
    if taken_base and not taken:
        return REFUSES
    return SAYS if said - said_base else SILENT


def rigor_names(program, path, rule):
    done = subprocess.run([program, "validate", "--format", "json", "--fail-on", "never", path],
                          capture_output=True, check=True)
    return rule in {found["rule"] for found in json.loads(done.stdout)["diagnostics"]}


def rows():
    with open(os.path.join(FAULTS, "suite.tsv"), encoding="utf-8") as table:
        for line in table:
            fields = line.rstrip("\n").split("\t")
            if not line.startswith("#") and fields[0] != "-":
                yield fields


def version_of_package(name):
    done = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", name], capture_output=True,
                          text=True, check=False)
    return done.stdout.split("-")[0].split("+")[0] or "unknown"


class Counts:
    """How many faults a checker could look at, refused, and said something of."""

    def __init__(self):
        self.all = {"rigor": 0, "sdf": 0, "urdf": 0}
        self.refused = {"rigor": 0, "sdf": 0, "urdf": 0}
        self.said = {"rigor": 0, "sdf": 0, "urdf": 0}

    def add(self, who, what):
        self.all[who] += 1
        self.refused[who] += what == REFUSES
        self.said[who] += what == SAYS

    def cell(self, who):
        if self.all[who] == 0:
            return "–"
        caught = self.refused[who] + self.said[who]
        return f"{caught} of {self.all[who]}"

    def share(self, who):
        caught = self.refused[who] + self.said[who]
        return f"{100 * caught / self.all[who]:.0f} %"


def table(title, counts):
    lines = [f"| {title} | rigor | `ign sdf -k` | `check_urdf` |", "|---|---|---|---|"]
    for name, count in counts.items():
        cells = " | ".join(count.cell(who) for who in ("rigor", "sdf", "urdf"))
        lines.append(f"| {name} | {cells} |")
    return "\n".join(lines)


def main():
    program = os.path.abspath(sys.argv[1])
    categories, rules, total = {}, {}, Counts()
    bases = {}
    for file, rule, _, base, _ in rows():
        if file.startswith("mjcf/"):
            continue  # neither reads MJCF
        path, base = os.path.join(FAULTS, file), os.path.join(SANE, base)
        counts = [categories.setdefault(file.split("/")[0], Counts()),
                  rules.setdefault(rule, Counts()), total]

        def add(who, what, counts=counts):
            for count in counts:
                count.add(who, what)

        add("rigor", SAYS if rigor_names(program, path, rule) else SILENT)
        if file.endswith("model.config"):
            continue
        judges = [("sdf", sdf_check)]
        if file.endswith(".urdf"):
            judges.append(("urdf", urdf_check))
        for who, check in judges:
            if (who, base) not in bases:
                bases[who, base] = check(base)
            add(who, verdict(check, path, bases[who, base]))

    print(f"""# Against the official checkers

Generated by `tools/compare.py`; do not edit.

`testdata/faults` holds {total.all["rigor"]} robots, worlds and packages with one planted fault each, written for rigor's tests. Here the same
files go through `ign sdf -k` of libsdformat {version_of_package("libsdformat-dev")}, which also reads URDF, and through `check_urdf` of urdfdom {version_of_package("liburdfdom-tools")}.

- rigor has found a fault when the rule that is named for it fires. Some of those are of the severity info.
- A checker has found a fault when it refuses the file, or says anything of it with an error or a warning in it that it does not
  say of the same model without the fault. Whether it says what is wrong is not asked.
- A checker that crashes, or does not end within 20 seconds, has refused the file.
- `ign sdf -k` is given all files but `model.config`, `check_urdf` the URDF ones. Files that a model includes are found from its own folder
  (`SDF_PATH`).

The suite was made by those who made the rules, so that rigor finds all of it is no wonder: its tests ask for that. What it shows is
what the checkers that come with the formats let pass. They read a file as a simulator does: neither opens a mesh, holds an inertia
against the shapes of its link, or looks into the parameters of a plugin. Version 12 of libsdformat reads SDF up to 1.9.

Of all faults, {total.share("rigor")} are found by rigor, {total.share("sdf")} by `ign sdf -k` (which refuses {total.refused["sdf"]} of {total.all["sdf"]} and warns of {total.said["sdf"]}) and {total.share("urdf")} of those in URDF by `check_urdf`
(which refuses {total.refused["urdf"]} of {total.all["urdf"]} and warns of {total.said["urdf"]}).

## By category

{table("category", {**categories, "**all**": total})}

## By rule

{table("rule", rules)}""")


if __name__ == "__main__":
    main()
