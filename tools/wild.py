#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Draws what the rules say of real models for people to judge, and writes docs/rules-in-the-wild.md.

    tools/wild.py build/release/rigor --corpus DIR draw [--rule RULE] [--count N]
    tools/wild.py build/release/rigor --corpus DIR todo
    tools/wild.py build/release/rigor --corpus DIR page

DIR holds a folder for each set of models. `draw` shows ten hits of each rule of the severity error and five
of each warning, with their lines; `todo` lists those of them that nobody has judged; `page` writes the page
from testdata/wild/judgements.tsv and changes.md. --hits FILE keeps what rigor says, until rigor is newer.
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
JUDGEMENTS = os.path.join(ROOT, "testdata", "wild", "judgements.tsv")
CHANGES = os.path.join(ROOT, "testdata", "wild", "changes.md")
PAGE = os.path.join(ROOT, "docs", "rules-in-the-wild.md")
DRAWN = {"error": 10, "warning": 5, "info": 5}
BAR = {"error": 95, "warning": 80}  # the share of hits that must be right, in per cent
SEVERITIES = ["error", "warning", "info"]
MODELS = (".sdf", ".world", ".urdf")
CONTEXT = 4  # lines before and after a hit

# What a hit is known by: lines stay where they are, messages get better.
Key = collections.namedtuple("Key", "rule path line")


def hash_of(*parts):
    return hashlib.sha256("".join(str(part) for part in parts).encode()).hexdigest()


def search_path(corpus, name):
    """Options that let the files of a set find each other, as their users would have them set."""
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
    paths = [root] + sorted(models, key=lambda path: (-models[path], path))
    paths.append(os.path.join(corpus, "gazebo_models"))
    options = [word for path in paths for word in ("--model-path", os.path.relpath(path, corpus))]
    for package in sorted(wanted):
        where = packages.get(package) or named.get(package)
        if not where and package == name:
            where = root
        if where:
            options += ["--package", f"{package}={os.path.relpath(where, corpus)}"]
    return options


def run_rigor(program, corpus):
    """All diagnostics and the number of files, set by set."""
    hits, files, sets = [], 0, 0
    names = sorted(name for name in os.listdir(corpus) if os.path.isdir(os.path.join(corpus, name)))
    for name in names:
        command = [program, "validate", name, "--isolated", "--no-gitignore", "--format", "json",
                   "--fail-on", "never"] + search_path(corpus, name)
        done = subprocess.run(command, cwd=corpus, capture_output=True, check=False)
        if done.returncode == 2 and b"holds no" in done.stderr:
            continue  # no model in it
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)}: exit code {done.returncode}\n{done.stderr.decode()}")
        said = json.loads(done.stdout)
        files += said["summary"]["files"]
        sets += 1
        for found in said["diagnostics"]:
            for place in [found, *found.get("places", [])]:
                hits.append({field: place.get(field, found[field]) for field in
                             ("rule", "category", "severity", "message", "path", "line")})
    return {"sets": sets, "files": files, "hits": hits}


def all_hits(options):
    kept = options.hits
    if kept and os.path.exists(kept) and os.path.getmtime(kept) > os.path.getmtime(options.rigor):
        with open(kept, encoding="utf-8") as file:
            return json.load(file)
    found = run_rigor(os.path.abspath(options.rigor), options.corpus)
    if kept:
        with open(kept, "w", encoding="utf-8") as file:
            json.dump(found, file)
    return found


def key_of(hit):
    return Key(hit["rule"], hit["path"], str(hit["line"] or "-"))


def by_rule(found):
    rules = collections.defaultdict(list)
    for hit in found["hits"]:
        rules[hit["rule"]].append(hit)
    return dict(sorted(rules.items()))


def severity_of(hits):
    return min((hit["severity"] for hit in hits), key=SEVERITIES.index)


def draw(hits, count):
    """`count` hits of one rule in an order that only the hits decide: one of each file, round after round."""
    files, seen = collections.defaultdict(list), set()
    for hit in sorted(hits, key=lambda hit: hash_of(hit["rule"], hit["path"], hit["line"], hit["message"])):
        if key_of(hit) not in seen:  # two on one line are judged together
            seen.add(key_of(hit))
            files[hit["path"]].append(hit)
    order = sorted(files, key=lambda path: hash_of("rigor", hits[0]["rule"], path))
    rounds = max(len(of_file) for of_file in files.values())
    drawn = [files[path][i] for i in range(rounds) for path in order if i < len(files[path])]
    return drawn[:count]


def judgements():
    """What people said of each hit; the last word counts."""
    judged = {}
    with open(JUDGEMENTS, encoding="utf-8") as table:
        for number, line in enumerate(table, 1):
            if line.startswith("#") or not line.strip():
                continue
            fields = line.rstrip("\n").split("\t")
            if len(fields) != 5 or fields[3] not in ("right", "wrong"):
                sys.exit(f"{JUDGEMENTS}:{number}: not `rule path line right|wrong remark`")
            judged[Key(*fields[:3])] = (fields[3] == "right", fields[4])
    return judged


def checkers(corpus):
    """What the official checkers say of each file, where the corpus comes with that."""
    path = os.path.join(corpus, "MANIFEST.tsv")
    if not os.path.exists(path):
        return {}
    with open(path, encoding="utf-8") as table:
        names = table.readline().rstrip("\n").split("\t")
        rows = [dict(zip(names, line.rstrip("\n").split("\t"))) for line in table]
    told = ("sdf12_verdict", "sdf12_first_message", "check_urdf")
    return {row["path"]: " | ".join(row[name] for name in told if row.get(name)) for row in rows}


def show(hit, corpus, told, judged):
    key = key_of(hit)
    print(f"\n{hit['path']}:{key.line}: {hit['message']}")
    if told.get(hit["path"]):
        print(f"  [checkers: {told[hit['path']]}]")
    if key in judged:
        print(f"  [judged {'right' if judged[key][0] else 'wrong'}: {judged[key][1]}]")
    if hit["line"]:
        with open(os.path.join(corpus, hit["path"]), encoding="utf-8", errors="replace") as text:
            lines = text.read().split("\n")
        first = max(0, hit["line"] - 1 - CONTEXT)
        for number, line in enumerate(lines[first:hit["line"] + CONTEXT], first + 1):
            print(f"  {'>' if number == hit['line'] else ' '}{number:6} {line.rstrip()[:160]}")


def print_drawn(options, found):
    told = checkers(options.corpus)
    judged = judgements() if os.path.exists(JUDGEMENTS) else {}
    for rule, hits in by_rule(found).items():
        severity = severity_of(hits)
        if options.rule not in (None, rule) or (severity == "info" and options.rule is None):
            continue
        print(f"\n=== {severity} {rule}: {len(hits)} hits in {len({hit['path'] for hit in hits})} files")
        for hit in draw(hits, options.count or DRAWN[severity]):
            show(hit, options.corpus, told, judged)


def print_todo(found):
    judged = judgements()
    for rule, hits in by_rule(found).items():
        severity = severity_of(hits)
        if severity == "info":
            continue
        for hit in draw(hits, DRAWN[severity]):
            if key_of(hit) not in judged:
                print(f"{severity}: {hit['path']}:{key_of(hit).line}: {hit['message']} [{rule}]")
        right = verdicts(hits, judged)
        if right and 100 * sum(right) < BAR[severity] * len(right):
            print(f"{severity}: {rule}: only {sum(right)} of {len(right)} right", file=sys.stderr)


def verdicts(hits, judged):
    return [judged[key][0] for key in sorted({key_of(hit) for hit in hits}) if key in judged]


def write_page(found):
    judged = judgements()
    rules = by_rule(found)
    kept = {key_of(hit) for hits in rules.values() if severity_of(hits) != "info" for hit in hits}
    gone = sum(key not in kept for key in judged)
    of_copy = sum(bool(re.search("this copy|copy used here", remark)) and key in kept
                  for key, (_, remark) in judged.items())
    counts = collections.Counter(hit["severity"] for hit in found["hits"])
    rows = collections.defaultdict(list)
    totals = {severity: [0, 0] for severity in SEVERITIES}
    for rule, hits in rules.items():
        severity = severity_of(hits)
        if severity == "info":
            continue
        right = verdicts(hits, judged)
        totals[severity][0] += sum(right)
        totals[severity][1] += len(right)
        share = f"{100 * sum(right) / len(right):.0f} %" if right else "–"
        files = len({hit["path"] for hit in hits})
        rows[hits[0]["category"]].append((SEVERITIES.index(severity), rule,
                                          f"| `{rule}` | {severity} | {len(hits):,} | {files:,} | {len(right)} | {share} |"))
    lines = []
    for category in sorted(rows):
        lines += [f"### {category}", "", "| rule | severity | hits | files | judged | right |", "|---|---|---:|---:|---:|---:|"]
        lines += [row for _, _, row in sorted(rows[category])] + [""]
    with open(CHANGES, encoding="utf-8") as file:
        changes = file.read().strip()
    error, warning = totals["error"], totals["warning"]
    page = f"""# What the rules say of real models

Generated by `tools/wild.py`; do not edit.

`rigor validate` with the default rules, meshes opened, over {found["files"]:,} files of {found["sets"]} public collections, none of which was written for rigor:
{counts["error"]:,} errors, {counts["warning"]:,} warnings and {counts["info"]:,} infos. Includes and meshes are looked up as the users of each collection have them.

Of each rule that fires, ten hits were drawn for an error and five for a warning (or all, where there are fewer), the order decided by hashes of rule, file,
line and message, and from as many files as can be. Each was read in its file and judged:

- An error is right when a consumer that the rule's page names rejects the model, crashes on it or misreads it, and line and message say where and what.
- A warning is right when the author of the file would agree that it is a mistake worth mending, not merely that the sentence is true.

Of the errors judged {share_of(error)} are right, of the warnings {share_of(warning)}. What an error rule says must be right in 95 % of the hits, a warning in
80 %; what fell short was changed until it did not, and then other hits were drawn and judged.
`testdata/wild/judgements.tsv` holds all judgements with a remark. Of {gone} of them the hits are gone since the rule was changed, are infos, or come with a `--target` only; they are not
counted. Some files name meshes, textures and models that their collection has and the copy used here was not given, for their size. What is said of those is
counted as right ({of_copy} of the judgements), and the remark says so.

{chr(10).join(lines).rstrip()}

## What was changed because of it

{changes}
"""
    with open(PAGE, "w", encoding="utf-8") as file:
        file.write(page)


def share_of(total):
    right, judged = total
    return f"{right} of {judged} ({100 * right / judged:.1f} %)" if judged else "none"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rigor", help="the program")
    parser.add_argument("--corpus", required=True, help="a folder with a folder for each set of models")
    parser.add_argument("--hits", help="a file to keep what rigor says in")
    commands = parser.add_subparsers(dest="command", required=True)
    drawing = commands.add_parser("draw", help="show hits to judge")
    drawing.add_argument("--rule", help="of this rule only")
    drawing.add_argument("--count", type=int, help="so many of each rule")
    commands.add_parser("todo", help="list drawn hits that nobody judged")
    commands.add_parser("page", help="write docs/rules-in-the-wild.md")
    options = parser.parse_args()
    found = all_hits(options)
    if options.command == "draw":
        print_drawn(options, found)
    elif options.command == "todo":
        print_todo(found)
    else:
        write_page(found)


if __name__ == "__main__":
    main()
