#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Types real files into `rigor lsp`, and holds what it shows after each key against what it shows of the same bytes
when they are opened.

  tests/lsp/client/typing.py build/release/rigor CORPUS [--files 200] [--edits 20000] [--largest 4000]

Each file is typed byte by byte from empty to its end, and then edited at random. The exit code is 1 when a text has other
findings than when it is opened, and when a server ends by itself. The test in typing_corpus_test.cc does a part of this.
"""

import argparse
import json
import os
import random
import subprocess
import sys

KINDS = (".sdf", ".world", ".urdf", ".xacro", ".config")


class Server:
    """Of one workspace; it counts characters as bytes."""

    def __init__(self, program):
        self.process = subprocess.Popen([program, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.version = 0
        capabilities = {"general": {"positionEncodings": ["utf-8"]}}
        self.send({"id": 1, "method": "initialize", "params": {"capabilities": capabilities, "rootUri": "file:///nowhere"}})
        self.receive()
        self.send({"method": "initialized", "params": {}})

    def send(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self.process.stdin.flush()

    def receive(self):
        length = 0
        while True:
            line = self.process.stdout.readline()
            if not line:
                sys.exit(f"the server has ended: {self.process.wait()}")
            if not line.strip():
                break
            if line.lower().startswith(b"content-length:"):
                length = int(line.split(b":")[1])
        return json.loads(self.process.stdout.read(length))

    def open(self, uri, text):
        self.version += 1
        document = {"uri": uri, "languageId": "xml", "version": self.version, "text": text}
        self.send({"method": "textDocument/didOpen", "params": {"textDocument": document}})

    def close(self, uri):
        self.send({"method": "textDocument/didClose", "params": {"textDocument": {"uri": uri}}})

    def change(self, uri, changes):
        self.version += 1
        document = {"uri": uri, "version": self.version}
        self.send({"method": "textDocument/didChange",
                   "params": {"textDocument": document, "contentChanges": changes}})

    def findings(self, uri):
        while True:
            params = self.receive().get("params", {})
            if params.get("uri") == uri and params.get("version") == self.version:
                return params["diagnostics"]


def position(text, offset):
    line = text.count("\n", 0, offset)
    return {"line": line, "character": len(text[text.rfind("\n", 0, offset) + 1 : offset].encode())}


class Typing:
    def __init__(self, program):
        self.typed, self.opened = Server(program), Server(program)
        self.compared, self.different = 0, []

    def compare(self, uri, text):
        """Of the last change. What is opened anew has no past."""
        self.opened.open(uri, text)
        shown, fresh = self.typed.findings(uri), self.opened.findings(uri)
        self.opened.close(uri)
        self.compared += 1
        if shown != fresh:
            self.different.append((uri, len(text), text[-40:]))
            print(f"{uri}: {len(text)} characters: {len(shown)} findings, {len(fresh)} when opened", flush=True)

    def prefixes(self, uri, text):
        self.typed.open(uri, "")
        for end in range(1, len(text) + 1):
            at = position(text, end - 1)
            self.typed.change(uri, [{"range": {"start": at, "end": at}, "text": text[end - 1]}])
            self.compare(uri, text[:end])

    def edits(self, uri, text, count, generator):
        for _ in range(count):
            begin = generator.randrange(len(text) + 1)
            end = min(len(text), begin + generator.randrange(12))
            start = generator.randrange(len(text) + 1)
            written = text[start : start + generator.randrange(12)]
            place = {"start": position(text, begin), "end": position(text, end)}
            self.typed.change(uri, [{"range": place, "text": written}])
            text = text[:begin] + written + text[end:]
            self.compare(uri, text)


def chosen(folder, count, largest, generator):
    paths = sorted(os.path.join(where, name) for where, _, names in os.walk(folder) for name in names
                   if name.endswith(KINDS))
    generator.shuffle(paths)
    files = []
    for path in paths:
        try:
            with open(path, encoding="utf-8", newline="") as file:
                text = file.read(largest + 1)
        except UnicodeDecodeError:
            continue
        if 0 < len(text) <= largest and "\r" not in text:
            files.append((path, text))
    return files[:count]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("--files", type=int, default=200)
    parser.add_argument("--edits", type=int, default=20000)
    parser.add_argument("--largest", type=int, default=4000, help="characters of a file")
    arguments = parser.parse_args()
    generator = random.Random(26)
    files = chosen(arguments.folder, arguments.files, arguments.largest, generator)
    typing = Typing(arguments.program)
    for path, text in files:
        uri = "file://" + path
        typing.prefixes(uri, text)
        typing.edits(uri, text, arguments.edits // len(files), generator)
        typing.typed.close(uri)
    print(f"{len(files)} files, {typing.compared} texts, {len(typing.different)} of them different")
    sys.exit(1 if typing.different or not files else 0)


if __name__ == "__main__":
    main()
