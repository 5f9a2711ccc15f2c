#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""tools/site.py [--build] SITE: checks the site that mkdocs built in the folder SITE; with --build it is built there first.

Each link leads to a page of the site and to an anchor in it, no page loads anything from the network, and the index of
the search has every page. Exits with 1 and names what is wrong.
"""

import html.parser
import json
import pathlib
import subprocess
import sys
import urllib.parse

# What a browser loads by itself; links to other sites are the reader's choice.
LOADED = {("script", "src"), ("img", "src"), ("link", "href"), ("iframe", "src"), ("source", "src")}


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.anchors, self.links, self.loads = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            elif (tag, name) in LOADED:
                self.loads.append(value)
            elif (tag, name) == ("a", "href"):
                self.links.append(value)


def check(site):
    pages = {path: Page(path.read_text()) for path in sorted(site.rglob("*.html"))}
    problems, links = [], 0
    for path, page in pages.items():
        if path.name == "404.html":  # its links begin at the top of a server
            continue
        for url in page.links + page.loads:
            parts = urllib.parse.urlsplit(url or "")
            where = f"{path.relative_to(site)}: {url}"
            if parts.scheme or parts.netloc:
                if url in page.loads:
                    problems.append(f"{where} is loaded from the network")
                continue
            links += 1
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if target.is_dir():
                target /= "index.html"
            anchor = urllib.parse.unquote(parts.fragment)
            if not target.is_relative_to(site) or not target.exists():
                problems.append(f"{where} leads nowhere")
            elif anchor and target in pages and anchor not in pages[target].anchors:
                problems.append(f"{where} has no such anchor")

    index = json.loads((site / "search/search_index.json").read_text())
    found = {entry["location"].split("#")[0] or "index.html" for entry in index["docs"]}
    for path in pages:
        name = str(path.relative_to(site))
        if name not in found and name not in ("404.html", "search.html"):
            problems.append(f"{name} is not found by the search")
    return pages, links, problems


def main():
    site = pathlib.Path(sys.argv[-1]).resolve()
    if sys.argv[1] == "--build":
        configuration = pathlib.Path(__file__).resolve().parent.parent / "mkdocs.yml"
        subprocess.run(["mkdocs", "build", "--quiet", "--clean", "-f", configuration, "-d", site], check=True)
    pages, links, problems = check(site)
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"{site}: {len(pages)} pages, {links} links, {len(problems)} problems")
    return 1 if problems or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
