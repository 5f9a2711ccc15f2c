#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Times the expansion of real robots by rigor and by the reference implementation (ros/xacro), each within
one process that has loaded everything: reading, expanding and printing, processor time, the fastest of a few runs.

    tools/bench/xacro_bench.py PROGRAM REFERENCE

PROGRAM is `rigor_xacro_bench`, REFERENCE a folder with the Python package `xacro`; where packages are, this
script answers in place of `ament_index_python`. The robots are the rows with links of
`oracle/xacro.jsonl.gz` beside RIGOR_CORPUS. A template of 3,000 calls of one macro comes last.
"""
import contextlib
import gzip
import io
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
import types

RUNS = 3


def packages_by_repository(root):
    """Of every package.xml its name and folder; of two of one name in a repository the last."""
    found = {}
    for folder, folders, files in os.walk(root):
        folders.sort()
        if 'package.xml' not in files:
            continue
        with open(os.path.join(folder, 'package.xml'), encoding='utf-8', errors='replace') as file:
            name = re.search(r'<name>\s*([^<\s]+)\s*</name>', file.read())
        if name:
            repository = os.path.relpath(folder, root).split(os.sep)[0]
            known = found.setdefault(repository, {})
            known[name[1]] = max(folder, known.get(name[1], ''))
    return found


def packages_of(repository, found):
    """In the same repository first, else in the first that has it."""
    merged = {}
    for other in sorted(found, reverse=True):
        merged.update(found[other])
    merged.update(found.get(repository, {}))
    return merged


def robots(corpus):
    root = os.path.realpath(os.path.join(corpus, '..', 'corpus-xacro'))
    found = packages_by_repository(root)
    with gzip.open(os.path.join(corpus, '..', 'oracle', 'xacro.jsonl.gz'), 'rt') as rows:
        for row in map(json.loads, rows):
            if row['rc'] == 0 and row['links'] > 0:
                yield (os.path.join(root, row['path']), row['args'],
                       packages_of(row['path'].split('/')[0], found))


def many_calls():
    """3,000 calls of a macro with a link, a joint and some arithmetic."""
    calls = '\n'.join(f'<xacro:segment i="{i}" mass="${{base + {i}}}"/>' for i in range(3000))
    return ('<robot name="chain" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
            '<xacro:property name="base" value="0.5"/>\n'
            '<xacro:macro name="segment" params="i mass"><link name="link_${i}"><inertial>'
            '<mass value="${mass}"/><inertia ixx="${mass * 0.1}" iyy="${mass * 0.1}" izz="${mass / 6}"'
            ' ixy="0" ixz="0" iyz="0"/></inertial></link>\n<joint name="joint_${i}" type="fixed">'
            '<parent link="link_${i - 1}"/><child link="link_${i}"/></joint></xacro:macro>\n'
            '<link name="link_-1"/>\n' + calls + '\n</robot>\n')


def package_index():
    """A module in place of `ament_index_python.packages`; its `known` says which packages there are."""
    index = types.ModuleType('ament_index_python.packages')
    index.known = {}
    index.PackageNotFoundError = KeyError
    index.get_package_share_directory = lambda name: index.known[name]
    package = types.ModuleType('ament_index_python')
    package.packages = index
    package.get_package_share_directory = index.get_package_share_directory
    sys.modules.update({'ament_index_python': package, 'ament_index_python.packages': index})
    return index


def reference_milliseconds(xacro, file, arguments):
    best = None
    for _ in range(RUNS):
        begin = time.process_time()
        with contextlib.redirect_stderr(io.StringIO()):
            document = xacro.process_file(file, mappings=dict(a.split(':=', 1) for a in arguments))
            document.toprettyxml(indent='  ')
        spent = (time.process_time() - begin) * 1000
        best = spent if best is None else min(best, spent)
    return best


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, folder = sys.argv[1:]
    corpus = os.environ.get('RIGOR_CORPUS') or sys.exit('RIGOR_CORPUS is not set')
    sys.path.insert(0, folder)
    temporary = tempfile.TemporaryDirectory()
    index = package_index()
    import xacro  # pylint: disable=import-outside-toplevel,import-error

    rows = list(robots(corpus))
    chain = os.path.join(temporary.name, 'chain.xacro')
    with open(chain, 'w', encoding='utf-8') as file:
        file.write(many_calls())
    asked = ''
    for file, arguments, packages in rows + [(chain, [], {})]:
        asked += ''.join(f'package\t{name}\t{path}\n' for name, path in packages.items())
        asked += '\t'.join(['robot', file, *arguments]) + '\n'
    answers = subprocess.run([program], input=asked, capture_output=True, text=True, check=True).stdout.split()
    if 'failed' in answers:
        sys.exit('rigor fails at ' + (rows + [(chain,)])[answers.index('failed')][0])
    own = [float(answer) for answer in answers]

    ratios = []
    for (file, arguments, packages), milliseconds in zip(rows, own):
        index.known = packages
        reference = reference_milliseconds(xacro, file, arguments)
        ratios.append(reference / milliseconds)
        print(f'{ratios[-1]:7.0f} times as fast  {milliseconds:8.2f} ms for {reference:8.1f} ms  '
              f'{os.path.basename(file)} {" ".join(arguments)}')
    print(f'{len(ratios)} robots: {statistics.median(ratios):.0f} times as fast in the middle '
          f'({min(ratios):.0f} to {max(ratios):.0f}); the slowest takes {max(own[:-1]):.1f} ms, '
          f'3,000 calls of a macro take {own[-1]:.1f} ms')


main()
