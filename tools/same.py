#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Says where two builds of rigor differ: in what they print of real models, and in what they offer.

    tools/same.py OLD/rigor NEW/rigor [--corpus DIR] [--only COMMAND,...] [--every N] [--tests OLD/rigor_tests NEW/rigor_tests]

Over every model of the corpus (RIGOR_CORPUS): `validate --format json` a folder at a time, `inspect --format tsv`,
`sdf2urdf`, `urdf2sdf`, and `simulate --format json` a file at a time: same bytes, same exit code. Then the names of
rules and the options of every command: none may be gone. --every N takes each Nth file. Exits 1 where they differ.
"""

import argparse
import concurrent.futures
import json
import os
import re
import subprocess
import sys

COMMANDS = {
    "validate": lambda path: ["validate", "--format", "json", "--fail-on", "never", path],
    "inspect": lambda path: ["inspect", "--format", "tsv", path],
    "sdf2urdf": lambda path: ["sdf2urdf", path],
    "urdf2sdf": lambda path: ["urdf2sdf", path],
    "simulate": lambda path: ["simulate", "--format", "json", path],
}
ENDINGS = {"validate": None, "inspect": (".sdf", ".world", ".urdf"), "sdf2urdf": (".sdf", ".world"),
           "urdf2sdf": (".urdf",), "simulate": (".sdf", ".world", ".urdf")}
SECONDS = 300


def run(program, words, folder):
    """Exit code and what it printed: on stdout, and of conversions also what they say on stderr."""
    environment = dict(os.environ, RIGOR_CACHE="off")
    try:
        done = subprocess.run([program, *words], capture_output=True, timeout=SECONDS, cwd=folder,
                              env=environment, check=False)
    except subprocess.TimeoutExpired:
        return None, b""
    return done.returncode, done.stdout + (done.stderr if words[0].startswith(("sdf2", "urdf2")) else b"")


def cases(corpus, commands, every):
    """(command, path in the corpus) of all that is compared."""
    for command in commands:
        if ENDINGS[command] is None:
            folders = sorted(e.name for e in os.scandir(corpus) if e.is_dir())
            yield from ((command, folder) for folder in folders[::every])
            continue
        files = []
        for folder, _, names in os.walk(corpus):
            files += [os.path.relpath(os.path.join(folder, name), corpus)
                      for name in names if name.endswith(ENDINGS[command])]
        yield from ((command, path) for path in sorted(files)[::every])


def names_of_rules(program):
    done = subprocess.run([program, "rules", "--format", "json"], capture_output=True, check=True)
    found = json.loads(done.stdout)
    rules = found["rules"] if isinstance(found, dict) else found
    return {rule["name"] for rule in rules}


def options(program):
    """"validate --fix" and the like, of every command."""
    top = subprocess.run([program, "--help"], capture_output=True, text=True, check=False).stdout
    found = set()
    for command in re.findall(r"^  ([a-z][a-z0-9-]+)  ", top, re.M):
        text = subprocess.run([program, command, "--help"], capture_output=True, text=True, check=False).stdout
        found.add(command)
        found |= {f"{command} {name}" for name in re.findall(r"^\s+(?:-\w,\s*)?(--[a-z][a-z0-9-]*)", text, re.M)}
    return found


def names_of_tests(program):
    done = subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True, check=True)
    found, suite = set(), ""
    for line in done.stdout.splitlines():
        if not line.startswith(" "):
            suite = line.split()[0]
        else:
            found.add(suite + line.split()[0])
    return found


def report_gone(what, old, new):
    for name in sorted(old - new):
        print(f"gone: {what} {name}")
    print(f"{what}s: {len(old)} before, {len(new)} now, {len(old - new)} gone")
    return bool(old - new)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--corpus", default=os.environ.get("RIGOR_CORPUS"))
    parser.add_argument("--only", default=",".join(COMMANDS))
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--tests", nargs=2, metavar=("OLD", "NEW"))
    arguments = parser.parse_args()
    old, new = os.path.abspath(arguments.old), os.path.abspath(arguments.new)

    differ = report_gone("rule", names_of_rules(old), names_of_rules(new))
    differ |= report_gone("option", options(old), options(new))
    if arguments.tests:
        differ |= report_gone("test", *(names_of_tests(program) for program in arguments.tests))
    if not arguments.corpus:
        print("RIGOR_CORPUS is not set: no models are compared")
        return int(differ)

    def compare(case):
        words = COMMANDS[case[0]](case[1])
        return case, run(old, words, arguments.corpus) == run(new, words, arguments.corpus)

    counts = {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for (command, path), same in pool.map(compare, cases(arguments.corpus, arguments.only.split(","), arguments.every)):
            counts.setdefault(command, [0, 0])[0 if same else 1] += 1
            if not same:
                print(f"differs: {command} {path}", flush=True)
    for command, (same, other) in counts.items():
        print(f"{command}: {same} the same, {other} different")
        differ |= other > 0
    return int(differ)


if __name__ == "__main__":
    sys.exit(main())
