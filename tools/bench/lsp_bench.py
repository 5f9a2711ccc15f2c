#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""How long an editor waits for `rigor lsp`: from a key to the findings, for completions, for hover, from the start.

  tools/bench/lsp_bench.py [--cpu] build/release/rigor [FILE...]

Types into a world of 1 MB, a URDF of 30,000 lines, and the files that are named: single letters, deletions within
tags, a pasted line, each undone, with pauses of up to 0.15 s. Then opens a workspace of 3,000 files, and asks for what
takes a look at all of them. With RIGOR_CORPUS the largest robot of the xacro corpus beside it is typed into as well.

"key" ends with the first findings that reflect it: in a large document those of the part that it is typed in. "whole" is
what it takes until all of it was checked, without the pause of 60 ms for which that waits, and not on a thread of its own.

Milliseconds of wall clock, until the last byte of an answer has come, on a machine that does nothing else; with --cpu
of the time that the thread which answers was computing, on one that does. The limits are goals; one that is passed ends
with exit code 1.
"""

import json
import os
import random
import subprocess
import sys
import tempfile
import time

KEYS = 400
STARTS = 5
# Of which each checks all of the document.
WHOLE_CHECKS = 10
# Seconds before a key, at most.
PAUSE = 0.15
WORKSPACE_FILES = 3000
CPU = "--cpu" in sys.argv

# Milliseconds and MB.
LIMITS = {"start": 150, "key p50": 10, "key p99": 40, "whole p50": 100, "completion p99": 10, "hover p99": 10, "memory": 200}

# Of the xacro corpus, the file that expands to most.
LARGEST_TEMPLATE = "pr2_common/pr2_description/robots/pr2.urdf.xacro"


class Server:
    def __init__(self, program):
        self.began = time.perf_counter()
        self.process = subprocess.Popen([program, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.last = 0
        self.cpu = CPU

    def now(self):
        """Seconds, of which differences count."""
        if not self.cpu:
            return time.perf_counter()
        with open(f"/proc/{self.process.pid}/task/{self.process.pid}/schedstat", encoding="utf-8") as file:
            return int(file.read().split()[0]) / 1e9

    def send(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self.process.stdin.flush()

    def body(self):
        length = 0
        while (line := self.process.stdout.readline().strip()):
            if line.lower().startswith(b"content-length:"):
                length = int(line.split(b":")[1])
        return self.process.stdout.read(length)

    def receive(self):
        return json.loads(self.body())

    def request(self, method, params):
        self.last += 1
        self.send({"id": self.last, "method": method, "params": params})
        while True:
            message = self.receive()
            if message.get("id") == self.last:
                return message

    def findings(self, uri, version):
        """The time when they had come: a client's own parser is not measured."""
        while True:
            body = self.body()
            came = self.now()
            if b"publishDiagnostics" not in body:
                continue
            params = json.loads(body)["params"]
            if params["uri"] == uri and params.get("version") == version:
                return came

    def change(self, uri, version, change):
        self.send({"method": "textDocument/didChange",
                   "params": {"textDocument": {"uri": uri, "version": version}, "contentChanges": [change]}})

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
        <inertial><mass>600</mass><inertia><ixx>100</ixx><iyy>100</iyy><izz>100</izz></inertia></inertial>
        <collision name="collision"><geometry><box><size>1 1 1</size></box></geometry></collision>
        <visual name="visual"><geometry><box><size>1 1 1</size></box></geometry></visual>
      </link>
    </model>
"""
    models = "".join(model.format(i) for i in range(2450))
    return f'<sdf version="1.9">\n  <world name="w">\n{models}  </world>\n</sdf>\n'


def robot():
    link = """  <link name="l{0}">
    <inertial>
      <origin xyz="0 0 0"/>
      <mass value="600"/>
      <inertia ixx="100" ixy="0" ixz="0" iyy="100" iyz="0" izz="100"/>
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


def change_of(text, offset, old, new):
    return {"range": {"start": position(text, offset), "end": position(text, offset + len(old))}, "text": new}


def share(values, part):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(len(ordered) * part))]


def opened(program, path, text):
    """A server that has shown what it found in the text, and the milliseconds until then."""
    server = Server(program)
    server.request("initialize", {"capabilities": {}, "rootUri": "file://" + os.path.dirname(path)})
    server.send({"method": "initialized", "params": {}})
    uri = "file://" + path
    document = {"uri": uri, "languageId": "xml", "version": 1, "text": text}
    server.send({"method": "textDocument/didOpen", "params": {"textDocument": document}})
    came = server.findings(uri, 1)
    return server, (came - (0 if server.cpu else server.began)) * 1e3


def measure(program, path, text):
    uri = "file://" + path
    starts = []
    for _ in range(STARTS - 1):
        server, start = opened(program, path, text)
        starts.append(start)
        server.end()
    server, start = opened(program, path, text)
    starts.append(start)
    version = 1
    # Nobody types before there is something to see; what is prepared for requests is prepared then.
    time.sleep(0.5)
    generator = random.Random(26)
    keys, completions, hovers = [], [], []
    for offset, removed, written in edits(text, generator):
        changed = text[:offset] + written + text[offset + removed :]
        taken = text[offset : offset + removed]
        for before, old, new in ((text, taken, written), (changed, written, taken)):
            version += 1
            change = change_of(before, offset, old, new)
            time.sleep(generator.random() * PAUSE)
            begin = server.now()
            server.change(uri, version, change)
            keys.append((server.findings(uri, version) - begin) * 1e3)
        place = {"textDocument": {"uri": uri}, "position": position(text, offset)}
        for method, times in (("completion", completions), ("hover", hovers)):
            begin = server.now()
            server.request("textDocument/" + method, place)
            times.append((server.now() - begin) * 1e3)
    wholes = []
    for _ in range(WHOLE_CHECKS):
        version += 1
        offset = max(0, text.find("/>", len(text) // 2))
        change = change_of(text, offset, "", " ")
        text = text[:offset] + " " + text[offset:]
        begin = server.now()
        server.change(uri, version, change)
        server.findings(uri, version)
        server.request("textDocument/diagnostic", {"textDocument": {"uri": uri}})
        wholes.append((server.now() - begin) * 1e3)
    memory = server.memory()
    server.end()
    print(f"{os.path.basename(path)} ({len(text) / 1e6:.2f} MB)", flush=True)
    return held({"start": share(starts, 0.5), "key p50": share(keys, 0.5), "key p99": share(keys, 0.99),
                 "whole p50": share(wholes, 0.5), "completion p99": share(completions, 0.99), "hover p99": share(hovers, 0.99), "memory": memory})


def held(measured):
    """Whether every number is within its limit."""
    for name, value in measured.items():
        print(f"  {name:15} {value:7.1f} (limit {LIMITS[name]}){'' if value <= LIMITS[name] else ' MISSED'}", flush=True)
    return all(value <= LIMITS[name] for name, value in measured.items())


def measure_workspace(program, folder):
    """Memory of a session that has looked at every file."""
    text = '<robot name="robot_{0}">\n' + "".join(
        f'  <link name="link_{i}"><inertial><mass value="1"/></inertial></link>\n' for i in range(20)) + "</robot>\n"
    for i in range(WORKSPACE_FILES):
        with open(os.path.join(folder, f"robot_{i}.urdf"), "w", encoding="utf-8") as file:
            file.write(text.replace("{0}", str(i)))
    server = Server(program)
    server.request("initialize", {"capabilities": {}, "rootUri": "file://" + folder})
    server.send({"method": "initialized", "params": {}})
    uri = f"file://{folder}/robot_7.urdf"
    shown = text.replace("{0}", "7")
    document = {"uri": uri, "languageId": "xml", "version": 1, "text": shown}
    server.send({"method": "textDocument/didOpen", "params": {"textDocument": document}})
    server.findings(uri, 1)
    place = {"textDocument": {"uri": uri}, "position": position(shown, shown.index("link_3") + 2)}
    server.request("workspace/symbol", {"query": "link"})
    server.request("textDocument/references", {**place, "context": {"includeDeclaration": True}})
    server.request("textDocument/rename", {**place, "newName": "renamed"})
    memory = server.memory()
    server.end()
    print(f"a workspace of {WORKSPACE_FILES} files")
    return held({"memory": memory})


def main():
    program, *paths = [argument for argument in sys.argv[1:] if argument != "--cpu"]
    passed = True
    corpus = os.environ.get("RIGOR_CORPUS")
    largest = os.path.join(corpus, "..", "corpus-xacro", LARGEST_TEMPLATE) if corpus else None
    if largest and os.path.exists(largest):
        paths.append(os.path.normpath(largest))
    with tempfile.TemporaryDirectory() as folder:
        texts = [(os.path.join(folder, "small.urdf"), '<robot name="r"><link name="a"/></robot>\n'),
                 (os.path.join(folder, "world.sdf"), world()), (os.path.join(folder, "robot.urdf"), robot())]
        for path in paths:
            with open(path, encoding="utf-8", newline="") as file:
                texts.append((os.path.abspath(path), file.read()))
        for path, text in texts:
            passed = measure(program, path, text) and passed
        passed = measure_workspace(program, os.path.join(folder)) and passed
    sys.exit(0 if passed else 1)


if __name__ == "__main__":
    main()
