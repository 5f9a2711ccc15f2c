#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""How long an editor waits for `rigor lsp`: from a key to the findings, for completions, for hover, from the start.

  tools/bench/lsp_bench.py build/bench/rigor [FILE...]

Types into a world of 1 MB, a URDF of 30,000 lines, and the files that are named: single letters, deletions within
tags, a pasted line, each undone. Milliseconds of wall clock.
"""

import json
import os
import random
import subprocess
import sys
import tempfile
import time

KEYS = 100


class Server:
    def __init__(self, program):
        self.began = time.perf_counter()
        self.process = subprocess.Popen([program, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.last = 0

    def send(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self.process.stdin.flush()

    def receive(self):
        length = 0
        while (line := self.process.stdout.readline().strip()):
            if line.lower().startswith(b"content-length:"):
                length = int(line.split(b":")[1])
        return json.loads(self.process.stdout.read(length))

    def request(self, method, params):
        self.last += 1
        self.send({"id": self.last, "method": method, "params": params})
        while True:
            message = self.receive()
            if message.get("id") == self.last:
                return message

    def findings(self, uri, version):
        while True:
            message = self.receive()
            params = message.get("params", {})
            if message.get("method") == "textDocument/publishDiagnostics" and params["uri"] == uri:
                if params.get("version") == version:
                    return

    def memory(self):
        with open(f"/proc/{self.process.pid}/status", encoding="utf-8") as status:
            return next(int(line.split()[1]) / 1024 for line in status if line.startswith("VmHWM"))

    def end(self):
        self.request("shutdown", None)
        self.send({"method": "exit"})
        return self.process.wait()


def world():
    model = """    <model name="box_{0}">
      <pose>{0} 0 0.5 0 0 0</pose>
      <link name="link">
        <inertial><mass>1</mass><inertia><ixx>0.1667</ixx><iyy>0.1667</iyy><izz>0.1667</izz></inertia></inertial>
        <collision name="collision"><geometry><box><size>1 1 1</size></box></geometry></collision>
        <visual name="visual"><geometry><box><size>1 1 1</size></box></geometry></visual>
      </link>
    </model>
"""
    models = "".join(model.format(i) for i in range(2100))
    return f'<sdf version="1.9">\n  <world name="w">\n{models}  </world>\n</sdf>\n'


def robot():
    link = """  <link name="l{0}">
    <inertial>
      <origin xyz="0 0 0"/>
      <mass value="1"/>
      <inertia ixx="0.1667" ixy="0" ixz="0" iyy="0.1667" iyz="0" izz="0.1667"/>
    </inertial>
    <collision>
      <geometry>
        <box size="1 1 1"/>
      </geometry>
    </collision>
  </link>
"""
    joint = """  <joint name="j{1}" type="revolute">
    <parent link="l{0}"/>
    <child link="l{1}"/>
    <origin xyz="0 0 1"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="1"/>
  </joint>
"""
    count = 30000 // 19
    links = "".join(link.format(i) for i in range(count))
    joints = "".join(joint.format(i, i + 1) for i in range(count - 1))
    return f'<robot name="r">\n{links}{joints}</robot>\n'


def position(text, offset):
    line = text.count("\n", 0, offset)
    return {"line": line, "character": offset - (text.rfind("\n", 0, offset) + 1)}


def edits(text, generator):
    """Offset, how much is removed, what is written: each and its undoing."""
    for _ in range(KEYS // 2):
        at = generator.randrange(len(text))
        kind = generator.randrange(3)
        if kind == 0:
            yield at, 0, generator.choice('ab1"<> .')
        elif kind == 1:
            yield at, min(1, len(text) - at), ""
        else:
            line = text.rfind("\n", 0, at) + 1
            yield line, 0, text[line : text.find("\n", at) + 1]


def share(values, part):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(len(ordered) * part))]


def measure(program, path, text):
    uri = "file://" + path
    server = Server(program)
    server.request("initialize", {"capabilities": {}, "rootUri": "file://" + os.path.dirname(path)})
    server.send({"method": "initialized", "params": {}})
    version = 1
    document = {"uri": uri, "languageId": "xml", "version": version, "text": text}
    server.send({"method": "textDocument/didOpen", "params": {"textDocument": document}})
    server.findings(uri, version)
    start = (time.perf_counter() - server.began) * 1e3
    generator = random.Random(26)
    keys, completions, hovers = [], [], []
    for offset, removed, written in edits(text, generator):
        changed = text[:offset] + written + text[offset + removed :]
        taken = text[offset : offset + removed]
        for before, old, new in ((text, taken, written), (changed, written, taken)):
            version += 1
            change = {"range": {"start": position(before, offset), "end": position(before, offset + len(old))}, "text": new}
            begin = time.perf_counter()
            server.send({"method": "textDocument/didChange",
                         "params": {"textDocument": {"uri": uri, "version": version}, "contentChanges": [change]}})
            server.findings(uri, version)
            keys.append((time.perf_counter() - begin) * 1e3)
        place = {"textDocument": {"uri": uri}, "position": position(text, offset)}
        for method, times in (("completion", completions), ("hover", hovers)):
            begin = time.perf_counter()
            server.request("textDocument/" + method, place)
            times.append((time.perf_counter() - begin) * 1e3)
    memory = server.memory()
    code = server.end()
    print(f"{os.path.basename(path)}: {len(text) / 1e6:.2f} MB; start {start:.0f} ms; key to findings p50 {share(keys, 0.5):.1f} "
          f"p99 {share(keys, 0.99):.1f} ms; completion p99 {share(completions, 0.99):.1f} ms; hover p99 "
          f"{share(hovers, 0.99):.1f} ms; {memory:.0f} MB; exit {code}", flush=True)


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (("small.urdf", '<robot name="r"><link name="a"/></robot>\n'), ("world.sdf", world()), ("robot.urdf", robot())):
            measure(program, os.path.join(folder, name), text)
    for path in sys.argv[2:]:
        with open(path, encoding="utf-8", newline="") as file:
            measure(program, os.path.abspath(path), file.read())


if __name__ == "__main__":
    main()
