#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Compiles source files each by itself with clang, so that one that forgot an include is found.

    tools/files_alone.py build/clang/compile_commands.json [--part I/N] [FILE...]

Builds compile the files of a room together, which hides it. --part takes every Nth file, beginning with the Ith (from 0),
in the order of a hash of their names: parts that follow each other cover all. Nothing is written.
"""

import argparse
import concurrent.futures
import hashlib
import json
import os
import shlex
import subprocess
import sys


def commands(database):
    """file → words of its compilation, which checks the syntax only."""
    with open(database, encoding="utf-8") as stream:
        for entry in json.load(stream):
            words = shlex.split(entry["command"])
            out = words.index("-o")
            del words[out:out + 2]
            words[words.index("-c")] = "-fsyntax-only"
            # A launcher, as ccache with its environment, comes before the compiler.
            compiler = next(i for i, word in enumerate(words) if os.path.basename(word).startswith("clang++"))
            yield entry["file"], words[compiler:], entry["directory"]


def compile_alone(job):
    path, words, folder = job
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False)
    return path, done.returncode, done.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("database")
    parser.add_argument("--part", default="0/1")
    parser.add_argument("files", nargs="*", metavar="FILE")
    arguments = parser.parse_args()
    part, parts = (int(number) for number in arguments.part.split("/"))

    root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    wanted = {os.path.abspath(path) for path in arguments.files}
    jobs = [job for job in commands(arguments.database) if job[0].startswith((f"{root}/lib/", f"{root}/tools/", f"{root}/tests/"))
            and "/build/" not in os.path.relpath(job[0], root)]
    jobs.sort(key=lambda job: hashlib.sha256(os.path.relpath(job[0], root).encode()).digest())
    jobs = [job for job in jobs if job[0] in wanted] if wanted else jobs[part % parts::parts]

    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for path, code, errors in pool.map(compile_alone, jobs):
            if code != 0:
                failed += 1
                print(f"{os.path.relpath(path, root)} does not compile alone:\n{errors}")
    print(f"{len(jobs) - failed} files compile alone, {failed} do not")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
