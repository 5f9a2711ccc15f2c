#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""How many of the project's headers each source file makes the compiler read.

Follows `#include <rigor/...>` (and the quoted includes of tools/rigor) transitively from every .cc
file of lib/rigor and tools, without the compiler; precompiled headers do not count, since they only
hide the cost. Prints the median and the worst files, and which headers most files read.

    tools/headers.py [--worst N] [--of HEADER]    # HEADER, as "rules/context.h": its own includes
"""

import argparse
import functools
import pathlib
import re
import statistics
from collections import Counter

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIBRARY, TOOLS = ROOT / "lib", ROOT / "tools" / "rigor"
INCLUDE = re.compile(r'^#include ([<"])([^>"]+)', re.MULTILINE)


@functools.cache
def included(path):
    """The project's files that this one names itself."""
    found = []
    for kind, name in INCLUDE.findall(path.read_text(encoding="utf-8")):
        target = LIBRARY / name if name.startswith("rigor/") else TOOLS / name
        if (kind == '"' or name.startswith("rigor/")) and target.exists():
            found.append(target)
    return found


@functools.cache
def closure(path):
    """All that the compiler reads for it, without itself."""
    seen, ahead = set(), list(included(path))
    while ahead:
        header = ahead.pop()
        if header not in seen:
            seen.add(header)
            ahead += included(header)
    return frozenset(seen - {path})


def short(path):
    base = LIBRARY / "rigor" if path.is_relative_to(LIBRARY) else ROOT
    return path.relative_to(base).as_posix()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--worst", type=int, default=10, help="files and headers to list (10)")
    parser.add_argument("--of", help="list what this header or source reads")
    arguments = parser.parse_args()
    if arguments.of:
        path = next(p for p in (LIBRARY / "rigor" / arguments.of, ROOT / arguments.of) if p.exists())
        for header in sorted(closure(path), key=lambda h: -len(closure(h))):
            print(f"{len(closure(header)):5} {short(header)}")
        return
    sources = sorted(p for top in (LIBRARY / "rigor", ROOT / "tools") for p in top.rglob("*.cc"))
    counts = {source: len(closure(source)) for source in sources}
    print(f"{len(sources)} files, median {statistics.median(counts.values()):g} headers")
    for source in sorted(sources, key=lambda s: -counts[s])[: arguments.worst]:
        print(f"{counts[source]:5} {short(source)}")
    readers = Counter(header for source in sources for header in closure(source))
    print("headers that most files read:")
    for header, files in readers.most_common(arguments.worst):
        print(f"{files:5} {short(header)}, {len(closure(header))} headers behind it")


if __name__ == "__main__":
    main()
