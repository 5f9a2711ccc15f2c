#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""tests/editors/snippets.py: the configurations in editors/ are what docs/editors.md shows, are read by the parsers of
their formats, and start `rigor lsp` for every kind of model. The extension for VS Code declares what its script does."""

import json
import pathlib
import re
import sys
import tomllib

TOP = pathlib.Path(__file__).resolve().parents[2]
EDITORS = TOP / "editors"
PAGE = (TOP / "docs/editors.md").read_text()
COMMAND = ["rigor", "lsp"]
EXTENSIONS = {"sdf", "world", "urdf", "xacro", "srdf"}

failed = []


def check(what, holds):
    if not holds:
        failed.append(what)


def without_header(text):
    """Lines behind the comment with the license."""
    lines = text.splitlines()
    while lines and ("Copyright" in lines[0] or "SPDX" in lines[0]):
        lines.pop(0)
    return "\n".join(lines)


def shown(language):
    return [block.strip() for block in re.findall(rf"```{language}\n(.*?)```", PAGE, re.S)]


def snippets():
    for path, language in [
        ("neovim/rigor.lua", "lua"),
        ("emacs/rigor.el", "elisp"),
        ("helix/languages.toml", "toml"),
        ("kate/settings.json", "json"),
    ]:
        text = (EDITORS / path).read_text()
        check(f"docs/editors.md shows {path} as it is", without_header(text).strip() in shown(language))
        if language in ("lua", "elisp"):
            check(f"{path} names every kind of model", EXTENSIONS <= set(re.findall(r"\w+", text)))


def helix():
    languages = tomllib.loads((EDITORS / "helix/languages.toml").read_text())
    server = languages["language-server"]["rigor"]
    check("Helix starts rigor lsp", [server["command"], *server["args"]] == COMMAND)
    (xml,) = languages["language"]
    check("Helix takes every kind of model for XML", xml["name"] == "xml" and EXTENSIONS <= set(xml["file-types"]))
    check("Helix asks the server for XML", xml["language-servers"] == ["rigor"])


def kate():
    (server,) = json.loads((EDITORS / "kate/settings.json").read_text())["servers"].values()
    check("Kate starts rigor lsp", server["command"] == COMMAND)
    check("Kate asks the server for XML", re.fullmatch(server["highlightingModeRegex"], "XML"))


def vscode():
    folder = EDITORS / "vscode"
    package = json.loads((folder / "package.json").read_text())
    source = "".join(path.read_text() for path in sorted((folder / "src").glob("*.ts")))
    contributed = package["contributes"]
    declared = {command["command"] for command in contributed["commands"]}
    registered = set(re.findall(r"registerCommand\(\s*'([\w.]+)'", source))
    check(f"commands are declared as registered: {sorted(declared ^ registered)}", declared == registered)
    in_menus = {item["command"] for menu in contributed["menus"].values() for item in menu}
    check("menus hold declared commands", in_menus <= declared)
    for name in contributed["configuration"]["properties"]:
        used = f"'{name.removeprefix('rigor.')}'" in source or name == "rigor.trace.server"  # the client library reads that
        check(f"the setting {name} is used", used)
        check(f"the setting {name} is in the README", f"`{name}`" in (folder / "README.md").read_text())
    suffixes = {suffix for language in contributed["languages"] for suffix in language.get("extensions", [])}
    check("every kind of model is a language", suffixes == {f".{name}" for name in EXTENSIONS})
    for path in folder.rglob("*.json"):
        if "node_modules" not in path.parts:
            json.loads(path.read_text())
    paths = [language["configuration"] for language in contributed["languages"] if "configuration" in language]
    paths += [grammar["path"] for grammar in contributed["grammars"]] + [package["icon"]]
    for walkthrough in contributed["walkthroughs"]:
        paths += [step["media"]["markdown"] for step in walkthrough["steps"]]
    for path in paths:
        check(f"{path} exists", (folder / path).is_file())
    matcher = contributed["problemMatchers"][0]["pattern"]
    line = "arm/model.sdf:12:7: error: the lower limit 1 rad is above the upper -1 rad [joint-limit-inverted]"
    match = re.match(matcher["regexp"], line)
    parts = ["file", "line", "column", "severity", "code"]
    found = match and [match[matcher[part]] for part in parts]
    check(f"findings are problems: {found}", found == ["arm/model.sdf", "12", "7", "error", "joint-limit-inverted"])


for part in (snippets, helix, kate, vscode):
    part()
for what in failed:
    print(f"FAILED: {what}")
sys.exit(bool(failed))
