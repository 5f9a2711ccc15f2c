#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Shows where each finding of an old report is in a new one.

    rigor validate --format json . > old.json   # of the old program
    rigor validate --format json . > new.json   # of the new one
    tools/findings.py old.json new.json [--renamed old-rule=new-rule]... [--all]

A finding is found again where the new report has a place of its rule in the same lines; else where another
rule of the new report refers to those lines or to the same subject, which is what hides a consequence beside
its root; else it is dropped. Prints the numbers of both reports, and a line for each rule and what became of
its places; with --all a line for each place. Ends with 1 where a place of an error or a warning was dropped.
"""

import argparse
import collections
import json
import sys

SEVERITIES = ("error", "warning", "info")
LOUD = SEVERITIES[:2]


def places_of(finding):
    """Each place of a finding, whether the report groups or not."""
    yield finding
    yield from finding.get("places", [])


def place_key(place):
    return place["path"], place["line"], place["column"]


class Report:
    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.findings = json.load(file)["diagnostics"]
        self.by_place = collections.defaultdict(list)
        self.by_line = collections.defaultdict(list)
        self.by_subject = collections.defaultdict(list)
        self.places = 0
        for finding in self.findings:
            for place in places_of(finding):
                self.places += 1
                self.by_place[place_key(place)].append(finding)
                self.by_line[place["path"], place["line"]].append(finding)
                if place.get("subject"):
                    self.by_subject[place["path"], place["subject"]].append(finding)

    def numbers(self):
        counts = collections.Counter(finding["severity"] for finding in self.findings)
        return "%d errors, %d warnings, %d infos at %d places" % (
            counts["error"], counts["warning"], counts["info"], self.places)


def fate(finding, place, new, renamed):
    """What became of a place: a word and the finding that has it now."""
    rule = renamed.get(finding["rule"], finding["rule"])
    subject = place.get("subject") or finding.get("subject")
    line = new.by_line.get((place["path"], place["line"]), [])
    about = new.by_subject.get((place["path"], subject), []) if subject else []
    for found in new.by_place.get(place_key(place), []) + line + about:
        if found["rule"] == rule:
            return "kept", found
    for found in line + about:
        if SEVERITIES.index(found["severity"]) <= SEVERITIES.index(finding["severity"]):
            return "beside " + found["rule"], found
    return "dropped", None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--renamed", action="append", default=[], metavar="OLD=NEW")
    parser.add_argument("--all", action="store_true", help="a line for each place")
    arguments = parser.parse_args()
    renamed = dict(pair.split("=", 1) for pair in arguments.renamed)
    old, new = Report(arguments.old), Report(arguments.new)
    fates = collections.Counter()
    lost = 0
    for finding in old.findings:
        for place in places_of(finding):
            word, found = fate(finding, place, new, renamed)
            severity = finding["severity"]
            if found is not None and word == "kept" and found["severity"] != severity:
                word = "kept as " + found["severity"]
            fates[severity, finding["rule"], word] += 1
            lost += word == "dropped" and severity in LOUD
            if arguments.all:
                now = "-" if found is None else "%s:%s" % (found["path"], found["line"])
                print(place["path"], place["line"], severity, finding["rule"], word, now, sep="\t")
    if not arguments.all:
        print("old:", old.numbers())
        print("new:", new.numbers())
        for (severity, rule, word), count in sorted(fates.items()):
            print("%-8s %-42s %6d  %s" % (severity, rule, count, word))
    return 1 if lost else 0


if __name__ == "__main__":
    sys.exit(main())
