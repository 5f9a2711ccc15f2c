#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Asks libsdformat whether it loads what `rigor urdf2sdf` calls a success, of each URDF file of the corpus.

    tools/sdformat_loads.py build/release/rigor --corpus DIR [-j 2]

Prints a line for each set of options: how many files are converted, and how many of the results load; then each
result that does not. Exit 1 when there is one. Needs Debian's ignition-tools, sdformat-sdf and ruby.
"""

import argparse
import concurrent.futures
import os
import subprocess
import sys
import tempfile

import wild
import wild_simulate

OPTIONS = ([], ["--inertia", "nearest"], ["--allow-loss"], ["--allow-loss", "--inertia", "nearest"])


def loads(program, corpus, path, search, words):
    """None where rigor refuses; what libsdformat says of the result, nothing where it loads."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "model.sdf")
        done = subprocess.run([program, "urdf2sdf", path, "-o", out, *words, *search], cwd=corpus, capture_output=True, check=False)
        if done.returncode:
            return None
        said = subprocess.run(["ign", "sdf", "-k", out], capture_output=True, text=True, check=False)
        return "" if "Valid." in said.stdout.splitlines() else (said.stdout + said.stderr).strip() or "nothing"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rigor")
    parser.add_argument("--corpus", required=True)
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    program, corpus = os.path.abspath(options.rigor), os.path.abspath(options.corpus)
    sets = [name for name in sorted(os.listdir(corpus)) if os.path.isdir(os.path.join(corpus, name))]
    files = [path for name in sets for path in wild_simulate.models(corpus, name) if path.endswith(".urdf")]
    search = {name: wild.search_path(corpus, name) for name in sets}
    faults = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for words in OPTIONS:
            told = list(pool.map(lambda path: loads(program, corpus, path, search[path.split("/")[0]], words), files))
            made = [said for said in told if said is not None]
            print(f"{' '.join(words) or 'no option':36} {len(made):4} of {len(files)} converted, {made.count(''):4} load", flush=True)
            faults += [(" ".join(words), path, said) for path, said in zip(files, told) if said]
    for words, path, said in faults:
        print(f"\n{path} {words}\n  " + said.replace("\n", "\n  "))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
