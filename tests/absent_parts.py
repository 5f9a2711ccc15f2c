#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Whether what stands in for a component (lib/rigor/**/*_absent.cc) still is what the rest links against.

    absent_parts.py LIBRIGOR LIB_FOLDER OBJECT...

CI builds with all components, so nobody else would notice. A stand-in defines the functions that its headers
declare and the library defines, with the same parameters, and no others. Of LIB_FOLDER/rigor/a/b_absent.cc the
object's name ends in rigor/a/b_absent.cc.o.
"""

import re
import subprocess
import sys


# Declared beside what a component does, and defined in a file that is compiled without it.
ELSEWHERE = {"rigor::results::names_database"}


def functions(binary):
    """Those with linkage of their own: no templates, nothing that is inline."""
    lines = subprocess.run(["nm", "-C", "--defined-only", "--extern-only", binary], check=True, capture_output=True,
                           text=True).stdout.splitlines()
    found = (line.split(" ", 2) for line in lines if line.count(" ") >= 2)
    return {part[2] for part in found if part[1] == "T" and part[2].startswith("rigor::")}


def is_declared(function, room, header):
    """Whether a function, as `rigor::room::Class::name(int) const`, is of the header."""
    namespace = f"rigor::{room}::"
    name = re.sub(r"\[abi:\w+\]", "", function).split("(")[0]
    if not name.startswith(namespace) or name in ELSEWHERE:
        return False
    path = name[len(namespace):].split("::")
    return bool(re.search(rf"[\s~]{re.escape(path[-1].lstrip('~'))}\(", header)) and all(
        re.search(rf"\bclass {re.escape(name)}\b", header) for name in path[:-1])


def main():
    library, folder, *objects = sys.argv[1:]
    present = functions(library)
    wrong = [] if objects else ["there are no stand-ins"]
    for binary in objects:
        source = re.search(r"(rigor/.*\.cc)\.o$", binary)[1]
        absent = functions(binary)
        wrong += [f"{source}: nobody declares {name}" for name in absent - present]
        with open(f"{folder}/{source}", encoding="utf-8") as file:
            headers = re.findall(r"^#include <(rigor/.*)>$", file.read(), re.MULTILINE)
        for header in headers:
            with open(f"{folder}/{header}", encoding="utf-8") as file:
                text = file.read()
            wrong += [f"{source}: {name} of {header} is missing"
                      for name in present - absent if is_declared(name, header.split("/")[1], text)]
    print("\n".join(sorted(wrong)))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
