#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""What commands cost on models that have many of one thing: time must grow nearly in proportion.

    tools/bench/sizes.py build/release/rigor [--sizes 2000 8000 32000] [--kind NAME]... [--command NAME]...

A row is a kind of thing and a command, with the seconds of CPU time for each size; a command that ended by what it
says (too large, exit 2) is in parentheses. A row ends with `!` when four times as many took over six times as long, and
with `>` when the largest took longer than --limit. Exit 1 when there is such a row.
"""

import argparse
import ctypes
import os
import signal
import subprocess
import sys
import tempfile
import threading

PR_SET_CHILD_SUBREAPER = 36  # <linux/prctl.h>: workers that the program left are counted, too
INERTIAL = "<inertial><mass>1</mass><inertia><ixx>.1</ixx><iyy>.1</iyy><izz>.1</izz></inertia></inertial>"
URDF_INERTIAL = "<inertial><mass value='1'/><inertia ixx='.1' ixy='0' ixz='0' iyy='.1' iyz='0' izz='.1'/></inertial>"
TOLERANCE = 1.5  # of the proportion: caches grow out of the processor's
NOISE = 0.2  # seconds: below, the start of a process is most


def sdf(inside):
    return f"<sdf version='1.9'><model name='m'>{inside}</model></sdf>"


def chain(n):
    links = "".join(f"<link name='l{i}'>{INERTIAL}</link>" for i in range(n))
    return sdf(links + "".join(
        f"<joint name='j{i}' type='revolute'><pose>0 0 .1 0 0 0</pose><parent>l{i - 1}</parent><child>l{i}</child><axis><xyz>0 0 1</xyz></axis></joint>"
        for i in range(1, n)))


def star(n):
    links = "".join(f"<link name='l{i}'>{INERTIAL}</link>" for i in range(n))
    return sdf(links + "".join(
        f"<joint name='j{i}' type='fixed'><parent>l0</parent><child>l{i}</child></joint>" for i in range(1, n)))


def shapes(kind, shape):
    def make(n):
        return sdf("<link name='l'>" + INERTIAL + "".join(
            f"<{kind} name='s{i}'><pose>{i} 0 0 0 0 0</pose><geometry>{shape}</geometry></{kind}>" for i in range(n)) + "</link>")
    return make


def urdf_chain(n, mimic=lambda i: ""):
    return ("<robot name='m'>" + "".join(f"<link name='l{i}'>{URDF_INERTIAL}</link>" for i in range(n)) + "".join(
        f"<joint name='j{i}' type='revolute'><parent link='l{i - 1}'/><child link='l{i}'/><axis xyz='0 0 1'/>"
        f"<limit lower='-1' upper='1' effort='1' velocity='1'/>{mimic(i)}</joint>" for i in range(1, n)) + "</robot>")


def urdf_mimics(n):
    return urdf_chain(n, lambda i: f"<mimic joint='j{i - 1}'/>" if i > 1 else "")


def urdf_materials(n):
    return ("<robot name='m'>" + "".join(f"<material name='c{i}'><color rgba='{i % 7 / 7} 0 0 1'/></material>" for i in range(n)) +
            f"<link name='l'>{URDF_INERTIAL}" + "".join(
                f"<visual><geometry><box size='1 1 1'/></geometry><material name='c{i}'/></visual>" for i in range(n)) + "</link></robot>")


def urdf_shapes(n):
    return ("<robot name='m'>" + "".join(
        f"<link name='l{i}'>{URDF_INERTIAL}<collision><geometry><sphere radius='1'/></geometry></collision></link>" for i in range(n)) + "".join(
            f"<joint name='j{i}' type='fixed'><origin xyz='{3 * i} 0 0'/><parent link='l0'/><child link='l{i}'/></joint>"
            for i in range(1, n)) + "</robot>")


def models(n):
    return "<sdf version='1.9'><world name='w'>" + "".join(
        f"<model name='m{i}'><pose>{3 * i} 0 0 0 0 0</pose><link name='l'>{INERTIAL}<collision name='c'><geometry><box><size>1 1 1</size></box></geometry></collision>"
        "<visual name='v'><geometry><box><size>1 1 1</size></box></geometry></visual></link></model>" for i in range(n)) + "</world></sdf>"


def frames(n):
    return sdf(f"<link name='l'>{INERTIAL}</link>" + "".join(
        f"<frame name='f{i}' attached_to='{f'f{i - 1}' if i else 'l'}'><pose>0 0 1 0 0 0</pose></frame>" for i in range(n)))


def plugins(n):
    return sdf(f"<link name='l'>{INERTIAL}</link>" + "".join(
        f"<plugin name='p{i}' filename='lib.so'><a>{i}</a><topic>t{i}</topic></plugin>" for i in range(n)))


def sensors(n):
    return sdf(f"<link name='l'>{INERTIAL}" + "".join(
        f"<sensor name='s{i}' type='imu'><topic>t{i}</topic></sensor>" for i in range(n)) + "</link>")


def unknown(n):
    return sdf(f"<link name='l'>{INERTIAL}</link>" + "".join(f"<thing{i} a='1'/>" for i in range(n)))


def twins(n):
    return sdf("".join(f"<link name='l'>{INERTIAL}</link>" for _ in range(n)))


def missing(n):
    return sdf(f"<link name='l'>{INERTIAL}</link>" + "".join(f"<include><uri>model://m{i}</uri></include>" for i in range(n)))


def polyline(n):
    points = "".join(f"<point>{i} {i * i % 101}</point>" for i in range(n))
    return sdf(f"<link name='l'>{INERTIAL}<collision name='c'><geometry><polyline>{points}<height>1</height></polyline></geometry></collision></link>")


def mjcf(inside):
    return f"<mujoco><worldbody>{inside}</worldbody></mujoco>"


def mjcf_twins(n):
    return mjcf("<body name='b'><geom size='1'/>" + "<body name='b'><geom name='g' size='1'/></body><site name='b'/>" * (n // 4) + "</body>")


def mjcf_replicate(n):
    return mjcf(f"<replicate count='{n}' offset='3 0 0'><body name='b'><joint name='j'/><geom size='1'/><site name='s'/></body></replicate>")


def mjcf_attach(n):
    return mjcf("<body name='b'><joint/><geom size='1'/></body>" + "".join(f"<attach body='b' prefix='p{i}'/>" for i in range(n // 100)))


KINDS = {
    "chain": (chain, ".sdf"), "star": (star, ".sdf"), "ellipsoids": (shapes("visual", "<ellipsoid><radii>1 2 3</radii></ellipsoid>"), ".sdf"),
    "collisions": (shapes("collision", "<box><size>1 1 1</size></box>"), ".sdf"), "models": (models, ".sdf"), "frames": (frames, ".sdf"),
    "plugins": (plugins, ".sdf"), "sensors": (sensors, ".sdf"), "unknown": (unknown, ".sdf"), "twins": (twins, ".sdf"), "missing": (missing, ".sdf"),
    "polyline": (polyline, ".sdf"), "urdf-chain": (urdf_chain, ".urdf"), "urdf-mimics": (urdf_mimics, ".urdf"), "urdf-materials": (urdf_materials, ".urdf"), "urdf-star": (urdf_shapes, ".urdf"),
    "mjcf-twins": (mjcf_twins, ".xml"), "mjcf-replicate": (mjcf_replicate, ".xml"), "mjcf-attach": (mjcf_attach, ".xml"),
}
COMMANDS = {
    "validate": "validate {0}", "inspect": "inspect {0}", "inertia": "inertia {0} --material abs", "convert": "{convert} {0} --allow-loss -o {out}.model",
    "render": "render {0} -o {out}.png --size 160x120", "view": "view {0} -o {out}.html", "report": "report {0} --no-simulate -o {out}.html",
    "diff": "diff {0} {0}", "upgrade": "upgrade {0} --to 1.9 --diff", "mesh-check": "mesh-check {0}", "simulate": "simulate {0} --test settle", "fmt": "fmt {0} --diff",
}


def cpu_seconds(arguments, limit):
    """CPU time and exit code; None for the code when it was ended."""
    child = subprocess.Popen(arguments, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                             start_new_session=True, env={**os.environ, "RIGOR_CACHE": "off"})
    ended = threading.Event()

    def end():
        ended.set()
        os.killpg(child.pid, signal.SIGKILL)

    timer = threading.Timer(3 * limit, end)
    timer.start()
    _, status, used = os.wait4(child.pid, 0)
    seconds = used.ru_utime + used.ru_stime
    while True:
        try:
            _, _, used = os.wait4(-child.pid, 0)
        except ChildProcessError:
            break
        seconds += used.ru_utime + used.ru_stime
    timer.cancel()
    child.returncode = os.waitstatus_to_exitcode(status)
    return seconds, None if ended.is_set() else child.returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rigor")
    parser.add_argument("--sizes", type=int, nargs="+", default=[2000, 8000, 32000])
    parser.add_argument("--kind", action="append", choices=KINDS)
    parser.add_argument("--command", action="append", choices=COMMANDS)
    parser.add_argument("--limit", type=float, default=30, help="CPU seconds of a run")
    a = parser.parse_args()
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    bad = 0
    with tempfile.TemporaryDirectory(prefix="rigor-sizes-") as folder:
        print(f"{'':14} {'':11}" + "".join(f"{n:>10}" for n in a.sizes))
        for kind in a.kind or KINDS:
            make, ending = KINDS[kind]
            paths = []
            for n in a.sizes:
                paths.append(os.path.join(folder, f"{kind}-{n}{ending}"))
                with open(paths[-1], "w", encoding="utf-8") as file:
                    file.write(make(n))
            for command in a.command or COMMANDS:
                line, mark, before = "", "", None
                for n, path in zip(a.sizes, paths):
                    words = COMMANDS[command].format(path, out=os.path.join(folder, "out"), convert={".urdf": "urdf2sdf", ".xml": "mjcf2sdf"}.get(ending, "sdf2urdf"))
                    seconds, code = cpu_seconds([a.rigor, *words.split()], a.limit)
                    text = f"{seconds:.2f}"
                    line += f"{'(' + text + ')' if code == 2 else text:>10}"
                    if seconds > a.limit or code is None or code > 2 or code < 0:
                        mark = ">"
                        break
                    if before and seconds > max(NOISE, TOLERANCE * before[1] * n / before[0]):
                        mark = mark or "!"
                    before = (n, max(seconds, NOISE / 4))
                bad += bool(mark)
                print(f"{kind:14} {command:11}{line} {mark}", flush=True)
            for path in paths:
                os.remove(path)
    print(f"{bad} rows grow too fast")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
