#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Checks what the rules' pages claim of consumers against those consumers, and writes docs/claims.md.

    tools/claims.py            check, and print what does not hold
    tools/claims.py --write    write docs/claims.md

Needs check_urdf (liburdfdom-tools), libsdformat 12 (libsdformat12-12), assimp 5 (libassimp5), MuJoCo 2.2.2
(libmujoco2.2.2), xmllint (libxml2-utils), g++ with DART 6.12 (libdart-utils-urdf-dev,
libdart-external-ikfast-dev) and, for MuJoCo 3.3.8, node and the package mujoco-js 0.0.7 in
node_modules of the working folder. What is missing is named, and its claims are not checked. Each judge runs
in a process of its own, since some of them crash or do not return.
"""

import argparse
import atexit
import functools
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

SDFORMAT = """
import ctypes, sys
library = ctypes.CDLL("libsdformat12.so.12")
sys.exit(library.cmdCheck(sys.argv[1].encode()) & 1)
"""
SDFORMAT_PRINT = """
import ctypes, sys
library = ctypes.CDLL("libsdformat12.so.12")
sys.exit(library.cmdPrint(sys.argv[1].encode(), 0, 0) & 1)
"""
ASSIMP = """
import ctypes, sys
library = ctypes.CDLL("libassimp.so.5")
library.aiImportFile.restype = ctypes.c_void_p
library.aiGetErrorString.restype = ctypes.c_char_p
scene = library.aiImportFile(sys.argv[1].encode(), 8)
print(library.aiGetErrorString().decode())
sys.exit(0 if scene else 1)
"""
MUJOCO = """
import ctypes, sys
library = ctypes.CDLL("libmujoco.so.2.2.2")
library.mj_loadXML.restype = ctypes.c_void_p
error = ctypes.create_string_buffer(1000)
model = library.mj_loadXML(sys.argv[1].encode(), None, error, 1000)
print(error.value.decode())
sys.exit(0 if model else 1)
"""
NEWER_MUJOCO = """
import load from 'mujoco-js';
import {readdirSync, readFileSync} from 'node:fs';
import {basename, dirname, join} from 'node:path';
const mujoco = await load();
const path = process.argv.at(-1);
for (const name of readdirSync(dirname(path))) mujoco.FS.writeFile('/' + name, readFileSync(join(dirname(path), name)));
try {
  mujoco.MjModel.loadFromXML('/' + basename(path));
} catch {
  process.exit(1);
}
"""
PYTHON = """
import sys, xml.etree.ElementTree
try:
    xml.etree.ElementTree.parse(sys.argv[1])
except Exception as problem:
    sys.exit(str(problem))
"""

JUDGES = {
    "urdfdom 3.0.1": ["check_urdf"],
    "libsdformat 12.3": [sys.executable, "-c", SDFORMAT],
    "libsdformat 12.3 (print)": [sys.executable, "-c", SDFORMAT_PRINT],
    "assimp 5.2.5": [sys.executable, "-c", ASSIMP],
    "MuJoCo 2.2.2": [sys.executable, "-c", MUJOCO],
    "MuJoCo 3.3.8": ["node", "--input-type=module", "-e", NEWER_MUJOCO],
    "Python 3.11 (expat)": [sys.executable, "-c", PYTHON],
    "libxml2 (xmllint)": ["xmllint", "--noout"],
    "DART 6.12 (a body's mass)": ["claims_dart", "mass"],
    "DART 6.12 (a joint under gravity)": ["claims_dart", "moves"],
}
URDFDOM, SDF, SDF_PRINT, ASSIMP_5, MUJOCO_2, MUJOCO_3, EXPAT, LIBXML2, DART_MASS, DART_MOTION = JUDGES

LINK = '<link name="a"/>'
BARE = '<link name="l"/>'
BARE_B = '<link name="b"/>'
BODY = ('<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>')


def robot(inside):
    return f'<robot name="r">{inside}</robot>'


def joint(inside, type_="revolute"):
    return robot('<link name="a"/><link name="b"/>'
                 f'<joint name="j" type="{type_}"><parent link="a"/><child link="b"/>{inside}</joint>')


def body(mass, inertia):
    return robot(f'<link name="a"><inertial><mass value="{mass}"/><inertia {inertia}/></inertial></link>')


def tensor(ixx, iyy, izz):
    return f'ixx="{ixx}" iyy="{iyy}" izz="{izz}" ixy="0" ixz="0" iyz="0"'


def model(inside, version="1.9"):
    return f'<sdf version="{version}"><model name="m">{inside}</model></sdf>'


def sdf_body(mass, moments):
    ixx, iyy, izz = moments
    return model(f'<link name="l"><inertial><mass>{mass}</mass><inertia><ixx>{ixx}</ixx><iyy>{iyy}</iyy>'
                 f'<izz>{izz}</izz></inertia></inertial></link>')


def sdf_joint(axis, type_="revolute", names=("a", "b")):
    return model('<link name="a"/><link name="b"/><joint name="j" type="%s"><parent>%s</parent>'
                 '<child>%s</child>%s</joint>' % (type_, *names, axis))


def collada(image):
    return f"""<COLLADA version="1.4.1"><asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>{image}
<library_effects><effect id="e"><profile_COMMON>
<newparam sid="f"><surface type="2D"><init_from>skin</init_from></surface></newparam>
<technique sid="t"><phong><diffuse><texture texture="f" texcoord="u"/></diffuse></phong></technique>
</profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="d" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
<technique_common><accessor source="#d" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4" material="s"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="w"><node id="n"><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#w"/></scene></COLLADA>"""


ACCEPTS, REJECTS, HANGS, REPORTS = "accepts", "rejects", "does not return", "accepts with an error in its log"
ASSERTS, HOLDS, MOVES, KEEPS = ("stops at an assertion", "holds it still", "lets it move",
                                "keeps the mass, with a warning")

LIMIT = '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>'
DECLARED = '<?xml version="1.0"?>'



def arm(inertial=BODY, axis='<axis xyz="0 0 1"/>', link="", more=""):
    """A link that a continuous joint moves."""
    return robot(f'<link name="a"/><link name="b">{inertial}{link}</link><joint name="j" type="continuous">'
                 f'<parent link="a"/><child link="b"/>{axis}</joint>{more}')


def pendulum(limit):
    """A body beside a vertical axis, which gravity along -x turns."""
    beside = BODY.replace("<mass", '<origin xyz="0 1 0"/><mass')
    return joint(f'<axis xyz="0 0 1"/><limit {limit}/>').replace(BARE_B, f'<link name="b">{beside}</link>')


def collided(geometry):
    return arm(link=f"<collision><geometry>{geometry}</geometry></collision>")


def stl(triangles, promised=None):
    """A binary STL of triangles of nine numbers each."""
    facets = b"".join(struct.pack("<12fH", 0, 0, 0, *triangle, 0) for triangle in triangles)
    return bytes(80) + struct.pack("<I", len(triangles) if promised is None else promised) + facets


O, X, Y, Z = (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)
TETRAHEDRON = [O + Y + X, O + X + Z, O + Z + Y, X + Y + Z]
MESH = collided('<mesh filename="a.stl"/>')
ASCII_STL = "solid a\n" + "".join(
    "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {t[i]} {t[i + 1]} {t[i + 2]}\n" for i in (0, 3, 6))
    + "endloop\nendfacet\n" for t in TETRAHEDRON) + "endsolid a\n"
TWO_PARENTS = robot(f'<link name="a"/><link name="b">{BODY}</link><link name="c">{BODY}</link>' + "".join(
    f'<joint name="{p}{c}" type="continuous"><parent link="{p}"/><child link="{c}"/><axis xyz="0 0 1"/></joint>'
    for p, c in ("ab", "ac", "bc")))


def of_engines(rule, subject, text, expected, engines=(MUJOCO_2, MUJOCO_3), ending="urdf", files=None):
    """The same claim of several engines."""
    return [(rule, f"{engine.split(' ')[0]} {expected} {subject}", engine, ending, text, expected, files or {})
            for engine in engines]


ENGINE_CLAIMS = [claim for claims in [
    of_engines("axis-zero", "a zero axis", arm(axis='<axis xyz="0 0 0"/>'), REJECTS),
    of_engines("inertia-triangle-inequality", "1 + 1 < 3", arm(BODY.replace('izz="1"', 'izz="3"')), REJECTS),
    of_engines("inertia-not-positive-definite", "a negative moment", arm(BODY.replace('ixx="1"', 'ixx="-1"')), REJECTS),
    of_engines("inertia-singular", "a moving body without a moment",
               arm(BODY.replace('"1" iyy="1" izz="1"', '"0" iyy="0" izz="0"')), REJECTS),
    of_engines("moving-link-massless", "a moving link without mass", arm(""), REJECTS),
    of_engines("two-parents", "a link with two parents", TWO_PARENTS, REJECTS),
    of_engines("size-not-positive", "a size of zero", collided('<sphere radius="0"/>'), REJECTS),
    of_engines("mimic-not-in-mujoco", "a mimic of a joint that does not exist", arm(axis='<axis xyz="0 0 1"/><mimic joint="k"/>'),
               ACCEPTS),
    of_engines("plane-on-moving-link", "a plane on a moving body",
               '<mujoco><worldbody><body><joint/><geom type="plane" size="1 1 1"/><geom size="1"/></body></worldbody></mujoco>',
               REJECTS, ending="xml"),
    of_engines("sdf-not-imported", "an SDF", model(BARE), REJECTS, ending="xml"),
    of_engines("mesh-not-beside-urdf", "a mesh beside the file, by its bare name",
               collided('<mesh filename="package://p/meshes/a.stl"/>'), ACCEPTS, files={"a.stl": stl(TETRAHEDRON)}),
    of_engines("mesh-format-not-in-mujoco", "Collada", collided('<mesh filename="a.dae"/>'), REJECTS,
               (MUJOCO_2, MUJOCO_3), files={"a.dae": collada("").encode()}),
    of_engines("mesh-ascii-stl", "an STL in text", MESH, REJECTS, files={"a.stl": ASCII_STL.encode()}),
    of_engines("mesh-mujoco-faces", "an STL of 200,001 facets", MESH, REJECTS,
               files={"a.stl": stl(TETRAHEDRON * 50001)}),
    of_engines("mesh-not-finite", "a vertex that is nan", MESH, REJECTS,
               files={"a.stl": stl(TETRAHEDRON + [(float("nan"),) * 9])}),
    of_engines("mesh-trailing-bytes", "an STL with bytes after its facets", MESH, REJECTS,
               files={"a.stl": stl(TETRAHEDRON) + b"more"}),
    of_engines("mesh-truncated", "an STL that is cut off", MESH, REJECTS,
               files={"a.stl": stl(TETRAHEDRON, 5)}),
    of_engines("mesh-empty", "an STL without facets", MESH, REJECTS, files={"a.stl": stl([])}),
    of_engines("mesh-too-few-vertices", "a mesh of three vertices", MESH, ACCEPTS, (MUJOCO_2,), files={"a.stl": stl([O + X + Y])}),
    of_engines("mesh-too-few-vertices", "a mesh of three vertices", MESH, REJECTS, (MUJOCO_3,),
               files={"a.stl": stl([O + X + Y])}),
    of_engines("mesh-flat", "a mesh without volume", MESH, REJECTS,
               files={"a.stl": stl([O + X + Y, X + (1, 1, 0) + Y])}),
] for claim in claims]

# rule, claim, judge, ending, text, what the judge does, files beside it
CLAIMS = [
    ("axis-zero", "urdfdom accepts a zero axis", URDFDOM, "urdf", joint('<axis xyz="0 0 0"/>', "continuous"), ACCEPTS),
    ("axis-zero", "libsdformat rejects a zero axis", SDF, "sdf", sdf_joint("<axis><xyz>0 0 0</xyz></axis>"), REJECTS),
    ("shape-newer-than-urdf", "urdfdom 3 stops reading the link at a capsule", URDFDOM, "urdf",
     robot('<link name="a"><visual><geometry><capsule radius="1" length="1"/></geometry></visual></link>'), REPORTS),
    ("duplicate-name", "urdfdom rejects a second link of the name", URDFDOM, "urdf", robot(LINK * 2), REJECTS),
    ("duplicate-name", "libsdformat rejects a second link of the name", SDF, "sdf", model('<link name="l"/>' * 2), REJECTS),
    ("duplicate-sibling-name", "from SDF 1.7 on libsdformat rejects a frame with the name of a link", SDF, "sdf",
     model('<link name="l"/><frame name="l"/>'), REJECTS),
    ("duplicate-sibling-name", "the check alone rejects a visual with the name of a collision", SDF, "sdf",
     model('<link name="l"><visual name="v"><geometry><sphere><radius>1</radius></sphere></geometry></visual>'
           '<collision name="v"><geometry><sphere><radius>1</radius></sphere></geometry></collision></link>'), REJECTS),
    ("duplicate-sibling-name", "the print command, which loads as Gazebo does, accepts it", SDF_PRINT, "sdf",
     model('<link name="l"><visual name="v"><geometry><sphere><radius>1</radius></sphere></geometry></visual>'
           '<collision name="v"><geometry><sphere><radius>1</radius></sphere></geometry></collision></link>'), ACCEPTS),
    ("duplicate-sibling-name", "libsdformat rejects a URDF joint with the name of a link", SDF, "urdf",
     robot(f'<link name="a">{BODY}</link><link name="b">{BODY}</link><joint name="b" type="continuous">'
           '<parent link="a"/><child link="b"/></joint>'), REJECTS),
    ("duplicate-sibling-name", "urdfdom accepts a joint with the name of a link", URDFDOM, "urdf",
     robot(f'<link name="a">{BODY}</link><link name="b">{BODY}</link><joint name="b" type="continuous">'
           '<parent link="a"/><child link="b"/></joint>'), ACCEPTS),
    ("geometry-several", "urdfdom uses the first shape and accepts the robot", URDFDOM, "urdf",
     robot('<link name="a"><visual><geometry><sphere radius="1"/><box size="1 1 1"/></geometry></visual></link>'), ACCEPTS),
    ("geometry-empty", "urdfdom stops reading the link with an error", URDFDOM, "urdf",
     robot('<link name="a"><visual><geometry/></visual></link>'), REPORTS),
    ("include-uri-missing", "libsdformat rejects an include without a URI", SDF, "sdf",
     '<sdf version="1.9"><world name="w"><include/></world></sdf>', REJECTS),
    ("inertia-not-finite", "urdfdom drops the inertial with an error", URDFDOM, "urdf",
     body("1", tensor("nan", "1", "1")), REPORTS),
    ("inertia-not-positive-definite", "urdfdom accepts a negative moment", URDFDOM, "urdf", body("1", tensor("-1", "1", "1")), ACCEPTS),
    ("inertia-not-positive-definite", "libsdformat rejects a negative moment", SDF, "sdf", sdf_body("1", ("-1", "1", "1")), REJECTS),
    ("inertia-singular", "libsdformat accepts a point", SDF, "sdf", sdf_body("1", ("0", "0", "0")), ACCEPTS),
    ("inertia-singular", "urdfdom accepts a point", URDFDOM, "urdf", body("1", tensor("0", "0", "0")), ACCEPTS),
    ("inertia-triangle-inequality", "libsdformat rejects 1 + 1 < 3", SDF, "sdf", sdf_body("1", ("1", "1", "3")), REJECTS),
    ("inertia-triangle-inequality", "urdfdom does not check it", URDFDOM, "urdf", body("1", tensor("1", "1", "3")), ACCEPTS),
    ("joint-limit-inverted", "urdfdom does not compare the limits", URDFDOM, "urdf",
     joint('<axis xyz="0 0 1"/><limit lower="1" upper="-1" effort="1" velocity="1"/>'), ACCEPTS),
    ("joint-limit-inverted", "libsdformat does not compare the limits", SDF, "sdf",
     sdf_joint("<axis><xyz>0 0 1</xyz><limit><lower>1</lower><upper>-1</upper></limit></axis>"), ACCEPTS),
    ("joint-parent-is-child", "check_urdf does not return", URDFDOM, "urdf",
     robot('<link name="a"/><link name="b"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>'
           '<joint name="k" type="fixed"><parent link="b"/><child link="b"/></joint>'), HANGS),
    ("joint-parent-is-child", "libsdformat rejects it", SDF, "sdf", sdf_joint("<axis><xyz>0 0 1</xyz></axis>", names=("a", "a")), REJECTS),
    ("joint-parent-missing", "urdfdom rejects a missing parent", URDFDOM, "urdf",
     robot('<link name="b"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>'), REJECTS),
    ("joint-child-missing", "urdfdom rejects a missing child", URDFDOM, "urdf",
     robot('<link name="a"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>'), REJECTS),
    ("joint-type-unknown", "urdfdom rejects 'Revolute'", URDFDOM, "urdf", joint(LIMIT, "Revolute"), REJECTS),
    ("joint-type-unknown", "libsdformat ignores the case of a joint type", SDF, "sdf",
     sdf_joint("<axis><xyz>0 0 1</xyz></axis>", "Revolute"), ACCEPTS),
    ("limit-missing", "urdfdom rejects a revolute joint without <limit>", URDFDOM, "urdf", joint('<axis xyz="0 0 1"/>'), REJECTS),
    ("limit-range-missing", "urdfdom accepts a <limit> without lower and upper", URDFDOM, "urdf",
     joint('<axis xyz="0 0 1"/><limit effort="1" velocity="1"/>'), ACCEPTS),
    ("mass-negative", "urdfdom accepts a negative mass", URDFDOM, "urdf", body("-1", tensor("1", "1", "1")), ACCEPTS),
    ("mass-negative", "libsdformat rejects a negative mass", SDF, "sdf", sdf_body("-1", ("1", "1", "1")), REJECTS),
    ("mass-zero", "libsdformat accepts a mass of zero", SDF, "sdf", sdf_body("0", ("1", "1", "1")), ACCEPTS),
    ("mesh-texture-undefined", "assimp loads a mesh whose texture is undefined", ASSIMP_5, "dae", collada(""), ACCEPTS),
    ("mesh-texture-undefined", "assimp rejects an <image> that names no file", ASSIMP_5, "dae",
     collada('<library_images><image id="skin"/></library_images>'), REJECTS),
    ("mesh-texture-undefined", "assimp stops at an empty <init_from>", ASSIMP_5, "dae",
     collada('<library_images><image id="skin"><init_from></init_from></image></library_images>'), REJECTS),
    ("mesh-texture-missing", "assimp loads a mesh whose texture file is missing", ASSIMP_5, "dae",
     collada('<library_images><image id="skin"><init_from>missing.png</init_from></image></library_images>'), ACCEPTS),
    ("mesh-lfs-pointer", "assimp rejects a Git LFS pointer", ASSIMP_5, "stl",
     "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n", REJECTS),
    ("mesh-malformed", "assimp rejects the text of a symbolic link", ASSIMP_5, "stl", "../../shared/meshes/shell.stl", REJECTS),
    ("misplaced-element", "libsdformat resolves an <include> directly in <sdf> (a missing one is rejected)", SDF, "sdf",
     '<sdf version="1.9"><include><uri>model://nowhere_at_all</uri></include></sdf>', REJECTS),
    ("name-reserved", "'::' is rejected from SDF 1.8 on", SDF, "sdf", model('<link name="a::b"/>', "1.8"), REJECTS),
    ("name-reserved", "'::' is accepted in SDF 1.7", SDF, "sdf", model('<link name="a::b"/>', "1.7"), ACCEPTS),
    ("reference-with-space", "urdfdom compares names byte by byte", URDFDOM, "urdf",
     robot('<link name="a"/><link name="b"/><joint name="j" type="fixed"><parent link="a "/><child link="b"/></joint>'), REJECTS),
    ("reference-with-space", "readers of SDF trim the name", SDF, "sdf",
     sdf_joint("<axis><xyz>0 0 1</xyz></axis>", names=("a ", " b")), ACCEPTS),
    ("several-roots", "urdfdom rejects two roots", URDFDOM, "urdf", robot('<link name="a"/><link name="b"/>'), REJECTS),
    ("size-not-positive", "urdfdom does not report a size of zero", URDFDOM, "urdf",
     robot('<link name="a"><collision><geometry><sphere radius="0"/></geometry></collision></link>'), ACCEPTS),
    ("size-not-positive", "libsdformat does not report a size of zero", SDF, "sdf",
     model('<link name="l"><collision name="c"><geometry><sphere><radius>0</radius></sphere></geometry></collision></link>'), ACCEPTS),
    ("unknown-element", "urdfdom ignores unknown elements", URDFDOM, "urdf", robot(LINK + "<note/>"), ACCEPTS),
    ("unknown-element", "libsdformat ignores unknown elements", SDF, "sdf", model('<link name="l"/><note/>'), ACCEPTS),
    ("urdf-version-unknown", "urdfdom rejects version 2.0", URDFDOM, "urdf", '<robot name="r" version="2.0"><link name="a"/></robot>', REJECTS),
    ("value-bad-color", "urdfdom drops a material whose color it cannot read, with an error", URDFDOM, "urdf",
     robot('<link name="a"><visual><geometry><sphere radius="1"/></geometry><material name="m">'
           '<color rgba="255 0 0 1"/></material></visual></link>'), REPORTS),
    ("value-decimal-comma", "urdfdom rejects the value", URDFDOM, "urdf", joint(LIMIT.replace('"1"', '"1,5"', 1)), REJECTS),
    ("value-trailing-text", "libsdformat reads 1.5kg as 1.5", SDF, "sdf", sdf_body("1.5kg", ("1", "1", "1")), ACCEPTS),
    ("value-trailing-text", "urdfdom rejects the value", URDFDOM, "urdf", joint(LIMIT.replace('effort="1"', 'effort="1Nm"')), REJECTS),
    ("value-trailing-text", "libsdformat reads a width of 818.0", SDF, "sdf",
     model('<link name="l"><sensor name="s" type="camera"><camera><image><width>818.0</width><height>480</height></image>'
           '</camera></sensor></link>'), ACCEPTS),
    ("value-not-finite", "urdfdom rejects a nan limit", URDFDOM, "urdf", joint(LIMIT.replace('upper="1"', 'upper="nan"')), REJECTS),
    ("xml-declaration-malformed", "Python's parser rejects a declaration without a version", EXPAT, "urdf", "<?xml?>" + robot(LINK), REJECTS),
    ("xml-declaration-malformed", "Python's parser reads a version that does not exist", EXPAT, "urdf",
     '<?xml version="0.0"?>' + robot(LINK), ACCEPTS),
    ("xml-declaration-malformed", "libxml2 rejects a version that does not exist", LIBXML2, "urdf",
     '<?xml version="0.0"?>' + robot(LINK), REJECTS),
    ("xml-declaration-malformed", "tinyxml2 ignores the declaration", SDF, "sdf", "<?xml?>" + model(BARE), ACCEPTS),
    ("xml-declaration-not-first", "tinyxml2 accepts a blank line before the declaration", SDF, "sdf",
     "\n" + DECLARED + model(BARE), ACCEPTS),
    ("xml-declaration-not-first", "Python's parser rejects it", EXPAT, "urdf", "\n" + DECLARED + robot(LINK), REJECTS),
    ("xml-declaration-not-first", "TinyXML 1, with which urdfdom 3 reads, accepts it after a comment", URDFDOM, "urdf",
     "<!-- a -->" + DECLARED + robot(LINK), ACCEPTS),
    ("xml-declaration-not-first", "tinyxml2 rejects it after a comment", SDF, "sdf",
     "<!-- a -->" + DECLARED + model(BARE), REJECTS),
    ("xml-double-hyphen-in-comment", "tinyxml2 accepts it", SDF, "sdf", model(BARE + "<!-- a -- b -->"), ACCEPTS),
    ("xml-double-hyphen-in-comment", "Python's parser rejects it", EXPAT, "urdf", robot(LINK + "<!-- a -- b -->"), REJECTS),
    ("xml-attributes-touch", "tinyxml2 accepts it", SDF, "sdf", '<sdf version="1.9"><model name="m"canonical_link="l"><link name="l"/></model></sdf>', ACCEPTS),
    ("xml-attributes-touch", "Python's parser rejects it", EXPAT, "urdf", '<robot name="r"version="1.0"><link name="a"/></robot>', REJECTS),
    ("xml-duplicate-attribute", "tinyxml2 rejects it", SDF, "sdf", '<sdf version="1.9" version="1.9"><model name="m"><link name="l"/></model></sdf>', REJECTS),
    ("xml-undefined-entity", "tinyxml2 leaves the characters", SDF, "sdf", model('<link name="a&b;"/>'), ACCEPTS),
    ("xml-undefined-entity", "Python's parser rejects it", EXPAT, "urdf", robot('<link name="a&b;"/>'), REJECTS),
    ("xml-unbound-prefix", "tinyxml2 accepts it", SDF, "sdf", model(BARE + "<a:b/>"), ACCEPTS),
    ("xml-unbound-prefix", "Python's parser rejects it", EXPAT, "urdf", robot(LINK + "<a:b/>"), REJECTS),
    ("xml-angle-in-attribute", "tinyxml2 accepts it", SDF, "sdf", model('<link name="l<1"/>'), ACCEPTS),
    ("xml-angle-in-attribute", "Python's parser rejects it", EXPAT, "urdf", '<robot name="r<1"><link name="a"/></robot>', REJECTS),
    ("xml-second-root", "tinyxml2 accepts it", SDF, "sdf", model(BARE) + model(BARE), ACCEPTS),
    ("xml-second-root", "Python's parser rejects it", EXPAT, "urdf", robot(LINK) + robot(LINK), REJECTS),
    ("joint-limit-inverted", "DART stops at an assertion", DART_MOTION, "urdf",
     pendulum('lower="1" upper="-1" effort="1" velocity="9"'), ASSERTS),
    ("velocity-zero", "DART holds the joint still", DART_MOTION, "urdf",
     pendulum('lower="-1" upper="1" effort="1" velocity="0"'), HOLDS),
    ("velocity-zero", "with a velocity it falls", DART_MOTION, "urdf",
     pendulum('lower="-1" upper="1" effort="1" velocity="9"'), MOVES),
    ("mass-zero", "DART keeps a mass of zero", DART_MASS, "urdf", arm(BODY.replace('mass value="1"', 'mass value="0"')), KEEPS),
    ("xml-empty", "Python's parser rejects an empty file", EXPAT, "urdf", "", REJECTS),
]

SECONDS = 20


@functools.cache
def dart():
    """The program that asks DART, or nothing where it cannot be compiled."""
    flags = subprocess.run(["pkg-config", "--cflags", "dart"], capture_output=True, text=True).stdout.split()
    program = pathlib.Path(tempfile.gettempdir()) / f"claims_dart_{os.getpid()}"
    run = subprocess.run(["g++", "-O1", *flags, "-std=c++17", str(ROOT / "tools" / "claims_dart.cc"), "-o", str(program),
                          "-ldart-utils-urdf", "-ldart", "-lassimp", "-lurdfdom_model"], capture_output=True, text=True)
    if run.returncode != 0:
        return None
    atexit.register(program.unlink)
    return str(program)


def command(judge):
    program, *options = JUDGES[judge]
    return [dart() if program == "claims_dart" else program, *options]


@functools.cache
def is_installed(judge):
    """Whether the judge can be asked; libraries that are missing show in what they say of a file."""
    program = JUDGES[judge][0]
    if judge in (DART_MASS, DART_MOTION):
        return dart() is not None
    if judge == MUJOCO_3:
        return os.path.isdir("node_modules/mujoco-js") and shutil.which(program) is not None
    if program != sys.executable:
        return shutil.which(program) is not None
    run = subprocess.run(JUDGES[judge] + ["/dev/null"], capture_output=True, text=True)
    return "cannot open shared object" not in run.stderr


def verdict(judge, ending, text, files):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / f"model.{ending}"
        path.write_text(text)
        for name, data in files.items():
            (path.parent / name).write_bytes(data)
        try:
            run = subprocess.run(command(judge) + [str(path)], capture_output=True, text=True, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return HANGS
    log = run.stdout + run.stderr
    if judge in (DART_MASS, DART_MOTION) and (run.stdout or "Assertion" in log):
        return ASSERTS if "Assertion" in log else run.stdout.splitlines()[-1]
    if run.returncode != 0:
        return REJECTS
    return REPORTS if judge == URDFDOM and "Error:" in log else ACCEPTS


HEAD = """# What the rules claim of consumers

Generated by `tools/claims.py --write`; do not edit.

Each row was checked by running the consumer on a file that has the defect and nothing else wrong. What libsdformat 12 does with every
example of every rule is in `testdata/compat`, and tests hold it.

Not checked by a run, but taken from sources and documentation: what the pages say of Gazebo and Gazebo classic beyond libsdformat, of
gz-physics (which drives DART in new Gazebo), Drake, ODE (but for `tests/simulate`), KDL, RViz, MoveIt, ros_control, ros2_control, Isaac Sim,
Ogre and of libsdformat 13 and later. Bullet's reader of URDF is in none of Debian's packages.

| rule | claim | consumer | what it does |
|---|---|---|---|
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--write", action="store_true", help="write docs/claims.md")
    options = parser.parse_args()
    rows, wrong, absent = [], 0, set()
    for rule, claim, judge, ending, text, expected, *files in sorted(
            CLAIMS + ENGINE_CLAIMS, key=lambda row: (row[0], list(JUDGES).index(row[2]))):
        if not is_installed(judge):
            absent.add(judge)
            continue
        found = verdict(judge, ending, text, files[0] if files else {})
        if found != expected:
            wrong += 1
            print(f"{rule}: {claim}: {judge} {found}", file=sys.stderr)
        rows.append(f"| `{rule}` | {claim} | {judge} | {found} |\n")
    for judge in sorted(absent):
        print(f"{judge} is not installed", file=sys.stderr)
    if options.write and not wrong and not absent:
        (ROOT / "docs" / "claims.md").write_text(HEAD + "".join(rows))
    print(f"{len(rows)} claims, {wrong} do not hold")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
