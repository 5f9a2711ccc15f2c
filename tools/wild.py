#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Draws findings on real models for people to judge, and writes docs/rules-in-the-wild.md.

    tools/wild.py collect build/release/rigor hits.json --corpus DIR...
    tools/wild.py draw hits.json [--from N] [--count N] [--todo]
    tools/wild.py robot hits.json PATH
    tools/wild.py page hits.json

Each DIR holds a folder for each collection of models. `collect` keeps what rigor finds in them. `draw` prints
the drawn hits (110 errors, 150 warnings, 40 infos) with their source lines; `robot` prints what is shown of one
model by default. A hit is a finding at its first place. `page` writes the page from testdata/wild/judgments.tsv
(three verdicts and a remark for each hit), robots.tsv (the same question for each finding on ten robots) and
changes.md.
"""

import argparse
import collections
import hashlib
import json
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
WILD = os.path.join(ROOT, "testdata", "wild")
PAGE = os.path.join(ROOT, "docs", "rules-in-the-wild.md")
SEED = "rigor"
DRAWN = {"error": 110, "warning": 150, "info": 40}
QUESTIONS = {"claim": 99, "severity": 95, "reason": 95}  # with the share that must be right, in percent
MODELS = (".sdf", ".world", ".urdf", ".xacro")
CONTEXT = 4  # lines before and after a hit

# A hit is known by its place: lines stay where they are, messages get better.
Key = collections.namedtuple("Key", "rule path line")


def hash_of(*parts):
    return hashlib.sha256("\0".join(str(part) for part in (SEED, *parts)).encode()).hexdigest()


def search_path(corpus, name):
    """Options that let the files of a collection find each other, as their users would have them set."""
    root = os.path.join(corpus, name)
    models, packages, named = collections.Counter(), {}, {}
    wanted = set()
    for folder, folders, files in os.walk(root):
        folders.sort()
        named.setdefault(os.path.basename(folder), folder)
        if "model.config" in files:
            models[os.path.dirname(folder)] += 1
        for file in files:
            if file == "package.xml" or file.endswith(MODELS):
                with open(os.path.join(folder, file), encoding="utf-8", errors="replace") as text:
                    content = text.read()
                if file == "package.xml":
                    found = re.search(r"<name>\s*(\S+?)\s*</name>", content)
                    if found:
                        packages.setdefault(found.group(1), folder)
                wanted |= set(re.findall(r"package://([^/\s\"'<>]+)", content))
                wanted |= set(re.findall(r"\$\(find ([^)\s]+)\)", content))
    paths = [root] + sorted(models, key=lambda path: (-models[path], path))
    if os.path.isdir(os.path.join(corpus, "gazebo_models")):
        paths.append(os.path.join(corpus, "gazebo_models"))
    options = [word for path in paths for word in ("--model-path", os.path.relpath(path, corpus))]
    for package in sorted(wanted):
        where = packages.get(package) or named.get(package)
        if not where and package == name:
            where = root
        if where:
            options += ["--package", f"{package}={os.path.relpath(where, corpus)}"]
    return options


def collect(options):
    """All findings, collection by collection."""
    findings, files, collections_read = [], 0, 0
    for corpus in options.corpus:
        for name in sorted(os.listdir(corpus)):
            if not os.path.isdir(os.path.join(corpus, name)):
                continue
            command = [os.path.abspath(options.rigor), "validate", name, "--isolated", "--no-gitignore",
                       "--format", "json", "--fail-on", "never"] + search_path(corpus, name)
            done = subprocess.run(command, cwd=corpus, capture_output=True, check=False)
            if done.returncode == 2 and b"holds no" in done.stderr:
                continue  # no model in it
            if done.returncode != 0:
                sys.exit(f"{' '.join(command)}: exit code {done.returncode}\n{done.stderr.decode()}")
            report = json.loads(done.stdout)
            files += report["summary"]["files"]
            collections_read += 1
            for finding in report["diagnostics"]:
                findings.append({field: finding[field] for field in
                                 ("rule", "severity", "message", "path", "line", "why", "help")}
                                | {"corpus": corpus, "places": len(finding["places"]) + 1})
    with open(options.hits, "w", encoding="utf-8") as file:
        json.dump({"collections": collections_read, "files": files, "findings": findings}, file)


def read_hits(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def key_of(hit):
    return Key(hit["rule"], hit["path"], str(hit["line"] or "-"))


def in_rounds(hits, group):
    """One hit of each group, round after round, all in an order that only the seed and the hits decide."""
    groups = collections.defaultdict(list)
    for hit in hits:
        groups[group(hit)].append(hit)
    order = sorted(groups, key=lambda name: hash_of(name, key_of(groups[name][0]).rule))
    rounds = max(map(len, groups.values()), default=0)
    return [groups[name][i] for i in range(rounds) for name in order if i < len(groups[name])]


def draw(findings):
    """The hits to judge: of each severity one of each rule, round after round, from as many collections as can be."""
    drawn = []
    for severity, count in DRAWN.items():
        first = {}
        for hit in sorted(findings, key=lambda hit: hash_of(*key_of(hit))):
            if hit["severity"] == severity:
                first.setdefault(key_of(hit), hit)  # two on one line are judged together
        rules = collections.defaultdict(list)
        for hit in first.values():
            rules[hit["rule"]].append(hit)
        mixed = [hit for hits in rules.values() for hit in in_rounds(hits, lambda hit: hit["path"].split("/")[0])]
        drawn += in_rounds(mixed, lambda hit: hit["rule"])[:count]
    return drawn


def table(name, columns):
    """The rows of a table of testdata/wild, each verdict as yes or no."""
    path = os.path.join(WILD, name)
    rows = []
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            if line.startswith("#") or not line.strip():
                continue
            fields = line.rstrip("\n").split("\t")
            if len(fields) != len(columns):
                sys.exit(f"{path}:{number}: not `{' '.join(columns)}`")
            rows.append(dict(zip(columns, fields)))
    return rows


def judgments():
    rows = table("judgments.tsv", ("rule", "path", "line", *QUESTIONS, "remark"))
    for row in rows:
        for question in QUESTIONS:
            if row[question] not in ("yes", "no"):
                sys.exit(f"judgments.tsv: {row['path']}:{row['line']}: {question} is not yes or no")
    return {Key(row["rule"], row["path"], row["line"]): row for row in rows}


def show(number, hit):
    print(f"\n#{number} {hit['severity']} {hit['rule']} ({hit['places']} places)")
    print(f"{hit['path']}:{hit['line'] or '-'}: {hit['message']}")
    print(f"  why: {hit['why']}\n  help: {hit['help']}")
    if hit["line"]:
        with open(os.path.join(hit["corpus"], hit["path"]), encoding="utf-8", errors="replace") as text:
            lines = text.read().split("\n")
        first = max(0, hit["line"] - 1 - CONTEXT)
        for number, line in enumerate(lines[first:hit["line"] + CONTEXT], first + 1):
            print(f"  {'>' if number == hit['line'] else ' '}{number:6} {line.rstrip()[:160]}")


def print_drawn(options):
    known = judgments() if options.todo else {}
    drawn = draw(read_hits(options.hits)["findings"])
    for number, hit in list(enumerate(drawn))[options.first:][:options.count]:
        if key_of(hit) not in known:
            show(number, hit)


def print_robot(options):
    for number, hit in enumerate(read_hits(options.hits)["findings"]):
        if hit["path"].startswith(options.path) and hit["severity"] != "info":
            show(number, hit)


def share(rows, question):
    right = sum(row[question] == "yes" for row in rows)
    return f"{right} of {len(rows)} ({100 * right / len(rows):.1f} %)" if rows else "–"


def robots_table():
    """What is shown of each robot by default, and how much of it the maintainer would act on."""
    robots = collections.defaultdict(list)
    for row in table("robots.tsv", ("robot", "rule", "line", "act", "remark")):
        robots[row["robot"]].append(row)
    lines = ["| robot | findings | acted on | not acted on |", "|---|---:|---:|---|"]
    for robot, rows in robots.items():
        idle = "; ".join(f"`{row['rule']}`: {row['remark']}" for row in rows if row["act"] == "no")
        lines.append(f"| {robot} | {len(rows)} | {sum(row['act'] == 'yes' for row in rows)} | {idle} |")
    every = [row for rows in robots.values() for row in rows]
    lines.append(f"| all | {len(every)} | {share(every, 'act')} | |")
    return "\n".join(lines)


def write_page(options):
    kept = read_hits(options.hits)
    drawn = draw(kept["findings"])
    known = judgments()
    todo = [key_of(hit) for hit in drawn if key_of(hit) not in known]
    if todo:
        sys.exit(f"{len(todo)} of the drawn hits are not judged, {' '.join(todo[0])} for one")
    for question, limit in QUESTIONS.items():
        right = sum(known[key_of(hit)][question] == "yes" for hit in drawn)
        if 100 * right < limit * len(drawn):
            print(f"{question}: {right} of {len(drawn)} is less than {limit} %", file=sys.stderr)
    counts = collections.Counter(hit["severity"] for hit in kept["findings"])
    places = sum(hit["places"] for hit in kept["findings"])
    totals, rules = [], collections.defaultdict(list)
    for severity in DRAWN:
        rows = [known[key_of(hit)] for hit in drawn if hit["severity"] == severity]
        totals.append(f"| {severity} | {counts[severity]:,} | {len(rows)} | "
                      + " | ".join(share(rows, question) for question in QUESTIONS) + " |")
    rows = [known[key_of(hit)] for hit in drawn]
    totals.append(f"| all | {len(kept['findings']):,} | {len(rows)} | "
                  + " | ".join(share(rows, question) for question in QUESTIONS) + " |")
    for hit in drawn:
        rules[hit["severity"], hit["rule"]].append(known[key_of(hit)])
    by_rule = []
    for (severity, rule), rows in sorted(rules.items(), key=lambda item: (list(DRAWN).index(item[0][0]), item[0][1])):
        right = [sum(row[question] == "yes" for row in rows) for question in QUESTIONS]
        by_rule.append(f"| `{rule}` | {severity} | {len(rows)} | " + " | ".join(map(str, right)) + " |")
    wrong = [f"- `{row['rule']}` at {row['path']}:{row['line']}: {row['remark']}" for hit in drawn
             for row in [known[key_of(hit)]] if any(row[question] == "no" for question in QUESTIONS)]
    with open(os.path.join(WILD, "changes.md"), encoding="utf-8") as file:
        changes = file.read().strip()
    newline = "\n"
    page = f"""# The rules on real models

Generated by `tools/wild.py`; do not edit.

`rigor validate` with the default rules over {kept["files"]:,} files of {kept["collections"]} public collections, none of which was written for rigor, finds
{counts["error"]:,} errors, {counts["warning"]:,} warnings and {counts["info"]:,} infos, at {places:,} places. Includes, packages and meshes are resolved as the users of
each collection have them.

{len(drawn)} of these findings were drawn by a fixed seed: of each severity one of each rule, round after round, from as many collections as can
be. So a rule that fires once weighs as much as one that fires in every file. Each was read in its source, and three questions were asked:

- *Claim*: what the message states is true of this file.
- *Severity*: an error if a default target (Gazebo, ROS) rejects, crashes on or misreads the file in a way that changes the robot; a warning if the
  author of a file that is meant to work would mend it (some are tests with planted mistakes); else an info.
- *Reason*: the printed `why` and `help` fit this case (format, version, consumer, value), not merely the rule.

| | findings | drawn | claim true | severity right | reason fitting |
|---|---:|---:|---:|---:|---:|
{newline.join(totals)}

`testdata/wild/judgments.tsv` holds all judgments with remarks. Some files name meshes and textures that their collection has and the copy used here
lacks, for their size; what is reported of those is counted as right, and the remark says so. Where a remark says "not counted anew", the number
was taken from rigor, and only what it says of it was judged.

## Judged wrong

{newline.join(wrong) or "None."}

## Ten robots

What `rigor validate` shows by default (errors and warnings, causes not places) of the robots of ten authors, and what their maintainers would
act on. What is reported of meshes and textures that the copy used here lacks is left out.

{robots_table()}

{changes}

## By rule

| rule | severity | drawn | claim | severity | reason |
|---|---|---:|---:|---:|---:|
{newline.join(by_rule)}
"""
    with open(PAGE, "w", encoding="utf-8") as file:
        file.write(page)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    collecting = commands.add_parser("collect", help="run rigor over the collections and keep its findings")
    collecting.add_argument("rigor", help="the program")
    drawing = commands.add_parser("draw", help="print drawn hits")
    robot = commands.add_parser("robot", help="print what is shown of one model")
    page = commands.add_parser("page", help="write docs/rules-in-the-wild.md")
    for command in (collecting, drawing, robot, page):
        command.add_argument("hits", help="the file with the findings")
    collecting.add_argument("--corpus", action="append", required=True, help="a folder with a folder for each collection")
    drawing.add_argument("--from", dest="first", type=int, default=0, metavar="N", help="skip N hits")
    drawing.add_argument("--count", type=int, default=25, metavar="N", help="print N hits")
    drawing.add_argument("--todo", action="store_true", help="only those that are not judged")
    robot.add_argument("path", help="the file or folder, as reports name it")
    options = parser.parse_args()
    {"collect": collect, "draw": print_drawn, "robot": print_robot, "page": write_page}[options.command](options)


if __name__ == "__main__":
    main()
