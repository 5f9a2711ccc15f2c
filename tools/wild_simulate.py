#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Simulates every model of a folder of sets and prints the table of docs/simulate-in-the-wild.md.

    tools/wild_simulate.py build/release/rigor --corpus DIR [--results FILE] [--test NAME,...] [--only FILE]

--test runs other tests than the default one, --only the models that a file lists, a path a line. --results keeps a line of JSON for each file: what rigor said, its CPU time and memory.
"""

import argparse
import collections
import json
import os
import resource
import subprocess

import wild

VERDICTS = ["pass", "warn", "fail", "solver", "invalid"]


def models(corpus, name):
    for folder, folders, files in os.walk(os.path.join(corpus, name)):
        folders.sort()
        for file in sorted(files):
            if file.endswith(wild.MODELS):
                yield os.path.relpath(os.path.join(folder, file), corpus)


def simulated(program, corpus, path, search, tests):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [program, "simulate", path, "--format", "jsonl", "--fail-on", "never"] + tests + search
    done = subprocess.run(command, cwd=corpus, capture_output=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    said = json.loads(done.stdout) if done.returncode == 0 else None
    return {"file": path, "code": done.returncode, "cpu": cpu, "memory": after.ru_maxrss, "said": said}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rigor")
    parser.add_argument("--corpus", required=True)
    parser.add_argument("--results")
    parser.add_argument("--test")
    parser.add_argument("--only")
    options = parser.parse_args()
    program = os.path.abspath(options.rigor)
    tests = ["--test", options.test] if options.test else []
    only = None
    if options.only:
        with open(options.only, encoding="utf-8") as file:
            only = {line.strip() for line in file}
    table, rows = collections.defaultdict(collections.Counter), []
    for name in sorted(os.listdir(options.corpus)):
        paths = [path for path in models(options.corpus, name) if only is None or path in only]
        search = wild.search_path(options.corpus, name) if paths else []
        for path in paths:
            row = simulated(program, options.corpus, path, search, tests)
            rows.append(row)
            verdict = row["said"]["verdict"] if row["said"] else "no answer"
            table[name][verdict] += 1
            table["all"][verdict] += 1
    if options.results:
        with open(options.results, "w", encoding="utf-8") as file:
            file.writelines(json.dumps(row) + "\n" for row in rows)
    print("| set | " + " | ".join(VERDICTS) + " |\n|---|" + "---|" * len(VERDICTS))
    for name in sorted(table, key=lambda name: (name == "all", name)):
        print(f"| {name} | " + " | ".join(str(table[name][word]) for word in VERDICTS) + " |")
    cpu = sorted(row["cpu"] for row in rows)
    print(f"\n{len(rows)} files, {sum(cpu):.0f} s of CPU time: half of them {cpu[len(cpu) // 2]:.2f} s or less, "
          f"95 % at most {cpu[len(cpu) * 95 // 100]:.2f} s, the slowest {cpu[-1]:.0f} s; "
          f"{table['all']['no answer']} gave no answer")


if __name__ == "__main__":
    main()
