#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Writes the cases of this folder: small valid SDF files full of what real files rarely use.

Run `python3 generate.py` here; the same files come out every time. After a change here, make the
facts anew with dump_with_libsdformat.cc.

A case is a random tree of models. Entities are made one after another, and each refers only to
those made before it, so no reference is missing and none goes in a circle; they are then written in
another order. `names` maps what a scope can refer to (`link`, `nested::frame`) to the link it moves
with.
"""

import pathlib
import random
import shutil

HERE = pathlib.Path(__file__).parent
JOINT_TYPES = ["revolute", "prismatic", "fixed", "ball", "universal", "revolute2", "screw",
               "gearbox", "continuous"]
LONGEST = 60  # lines of a case; a longer one is drawn again
QUATERNIONS = ["0.6 0 0 0.8", "0 0.6 0 -0.8", "0.5 0.5 0.5 0.5", "-0.36 0.48 0.64 0.48",
               "0 0 1 0", "0.1 0.7 -0.1 0.7"]

# Models to include: their file's version, body, and the names they offer (to the link meant).
SHARED = {
    "base": (9, '<model name="base">', """
    <link name="chassis"><pose>0.1 0 0.2 0 0 0.3</pose></link>
    <link name="wheel"><pose relative_to="chassis">0.5 -0.2 0 1.5 0 0</pose></link>
    <frame name="mount" attached_to="wheel"><pose>0 0 0.4 0.1 0.2 0</pose></frame>
    <joint name="spin" type="revolute"><parent>chassis</parent><child>mount</child>
      <axis><xyz expressed_in="__model__">0 1 1</xyz></axis></joint>""",
             {"chassis": "chassis", "wheel": "wheel", "mount": "wheel", "spin": "wheel"}),
    "placed": (9, '<model name="placed" placement_frame="grip" canonical_link="tip">', """
    <pose>0.3 0 0 0 0.5 0</pose>
    <link name="root"><pose>0 0.2 0 0 0 1.2</pose></link>
    <link name="tip"><pose relative_to="grip">0 0 -0.7 0.4 0 0</pose></link>
    <frame name="grip" attached_to="root"><pose>1 0 0.5 0 1 0</pose></frame>""",
               {"tip": "tip", "root": "root", "grip": "root"}),
    "tree": (8, '<model name="tree" placement_frame="branch::twig">', """
    <link name="trunk"/>
    <model name="branch"><pose relative_to="knot">0 0.1 1 0 0 0.7</pose>
      <link name="twig"><pose>0.2 0 0.3 0.6 0 0</pose></link>
      <frame name="bud" attached_to="twig"><pose>0 0 0.1 0 0 0</pose></frame></model>
    <frame name="knot"><pose>0 0 0.8 0.2 0 0</pose></frame>
    <joint name="grown" type="fixed"><parent>trunk</parent><child>branch::bud</child></joint>""",
             {"trunk": "trunk", "branch::twig": "branch::twig", "branch::bud": "branch::twig",
              "knot": "trunk"}),
    "hollow": (9, '<model name="hollow">', """
    <model name="core"><pose>0.4 0 0 0 0 0.9</pose>
      <link name="seed"><pose>0 0 0.2 0 0.3 0</pose></link></model>
    <frame name="rim"><pose>0 0.6 0 0 0 0</pose></frame>""",
               {"core::seed": "core::seed", "core": "core::seed", "rim": "core::seed"}),
    "outer": (9, '<model name="outer">', """
    <link name="plate"/>
    <include><uri>model://base</uri><name>inner</name>
      <pose relative_to="shelf">0.1 0.2 0.3 0 0 0.4</pose></include>
    <frame name="shelf" attached_to="plate"><pose>0 0 1.1 0 0.2 0</pose></frame>
    <frame name="top" attached_to="inner::mount"><pose>0 0 0.2 0 0 0</pose></frame>""",
              {"plate": "plate", "inner::wheel": "inner::wheel", "shelf": "plate",
               "top": "inner::wheel"}),
    "old14": (4, '<model name="old14">', """
    <pose>0 0 0.5 0 0 0.1</pose>
    <link name="a"><pose>0 0 0.2 0 0.3 0</pose></link>
    <link name="b"><pose>0.4 0 0.2 0.5 0 0</pose></link>
    <joint name="j" type="revolute"><parent>a</parent><child>b</child>
      <pose>0 0 0.1 0 0 0.2</pose><axis><xyz>1 0 1</xyz></axis></joint>""",
              {"a": "a", "b": "b", "j": "b"}),
    "old16": (6, '<model name="old16">', """
    <link name="a"><pose>0 0 0.2 0 0.3 0</pose></link>
    <link name="b"><pose frame="a">0.4 0 0.2 0.5 0 0</pose></link>
    <joint name="b" type="revolute"><parent>a</parent><child>b</child><axis><xyz>1 0 1</xyz>
      <use_parent_model_frame>true</use_parent_model_frame></axis></joint>""",
              {"a": "a", "b": "b", "b_joint": "b"}),
    "fused": (9, '<model name="fused">', """
    <link name="body"/>
    <include merge="true"><uri>model://base</uri><pose relative_to="body">0.3 0 0 0 0.6 0</pose>
    </include>
    <frame name="end" attached_to="mount"><pose relative_to="__model__">0 0 1 0 0 0</pose>
    </frame>""",
              {"body": "body", "chassis": "chassis", "wheel": "wheel", "mount": "wheel",
               "end": "wheel"}),
    "flat": (7, '<model name="flat">', """
    <static>true</static>
    <link name="x::y"><pose>0 0.3 0.1 0 0.2 0</pose></link>
    <frame name="x::__model__" attached_to="x::y"><pose relative_to="__model__">1 0 0 0 0 0</pose>
    </frame>""",
             {"x::y": "x::y"}),
    "fixed": (7, '<model name="fixed">', """
    <static>true</static>
    <link name="slab"><pose>0 0 0.1 0 0 0</pose>
      <collision name="c"><pose>0.1 0 0 0 0 0.5</pose><geometry><box><size>1 1 1</size></box>
      </geometry></collision></link>""",
              {"slab": "slab"}),
}


# What the shared models are called, and the models in them, and how random names of models begin.
MODELS = tuple(SHARED) + ("branch", "core", "inner")
MODEL_STEMS = ("model_", "model ", "part_", "part ")


def is_model(name):
    """A model can be a joint's child but, for libsdformat 12, not its parent."""
    last = name.split("::")[-1]
    return last in MODELS or last.startswith(MODEL_STEMS)


class Case:
    """One file in the making: its version, its luck, and what it is to have (`wishes`)."""

    def __init__(self, rng, version, **wishes):
        self.rng, self.version, self.wishes = rng, version, wishes
        self.count = 0

    def chance(self, wish, otherwise=0.0):
        return self.rng.random() < self.wishes.get(wish, otherwise)

    def number(self, limit=2.0):
        return f"{round(self.rng.uniform(-limit, limit) * 20) / 20:g}"

    def vector(self):
        return self.rng.choice(["0 0 1", "1 0 0", "0 -1 0", "1 2 2", "0.6 0 0.8", "-1 1 0",
                                "1 1 1"])

    def fresh(self, stem):
        self.count += 1
        space = " " if self.chance("spaces") else "_"
        return f"{stem}{space}{self.count}"

    def pick(self, names):
        plain = [n for n in names if "::" not in n]
        scoped = [n for n in names if "::" in n]
        if scoped and (not plain or self.chance("scoped", 0.5)):
            return self.rng.choice(scoped)
        return self.rng.choice(plain) if plain else None

    def pose(self, names, wish="relative", otherwise=0.4):
        if self.rng.random() < 0.15:
            return ""
        attributes = ""
        target = self.pick(names)
        if self.version >= 5 and target and self.chance(wish, otherwise):
            attributes = f' {"relative_to" if self.version >= 7 else "frame"}="{target}"'
        place = " ".join(self.number() for _ in range(3))
        turn = " ".join(self.number(3) for _ in range(3))
        if self.chance("upright"):  # a pitch that comes back from a quaternion as it was
            turn = f"{self.number(3)} {self.number(1.5)} {self.number(3)}"
        elif self.version >= 9 and self.chance("degrees", 0.1):
            attributes += ' degrees="true"'
            turn = " ".join(str(self.rng.randrange(-180, 181, 15)) for _ in range(3))
        elif self.version >= 9 and self.chance("quaternion", 0.1):
            attributes += ' rotation_format="quat_xyzw"'
            turn = self.rng.choice(QUATERNIONS)
        return f"<pose{attributes}>{place} {turn}</pose>"

    def with_self(self, names):
        return list(names) + ["__model__"] * (self.version >= 7)

    def inertial(self):
        r = self.rng
        moments = {"ixx": r.choice([0.7, 0.8, 1.1]), "iyy": r.choice([0.8, 0.9, 1.2]),
                   "izz": r.choice([0.75, 1, 1.3]), "ixy": r.choice([0.05, -0.1]),
                   "ixz": r.choice([0.02, -0.04]), "iyz": r.choice([0.1, -0.03])}
        if self.chance("partial", 0.2):
            moments = {k: v for k, v in moments.items() if r.random() < 0.6}
        tensor = "".join(f"<{k}>{v}</{k}>" for k, v in moments.items())
        pose = self.pose([], "none", 0) if r.random() < 0.7 else ""
        mass = f"<mass>{r.choice([0.5, 2, 12.5])}</mass>" if r.random() < 0.8 else ""
        return f"<inertial>{mass}{pose}<inertia>{tensor}</inertia></inertial>"

    def link(self, name, names):
        parts = [self.pose(self.with_self(names))]
        if self.chance("inertial", 0.3):
            parts.append(self.inertial())
        for kind in ("collision", "visual"):
            for _ in range(self.rng.randint(1, 2) if self.chance("parts", 0.2) else 0):
                pose = self.pose(self.with_self(names) + [name], "relative_parts", 0.3)
                parts.append(f'<{kind} name="{self.fresh(kind)}">{pose}<geometry><sphere>'
                             f"<radius>0.1</radius></sphere></geometry></{kind}>")
        return [f'<link name="{name}">'] + ["  " + p for p in parts if p] + ["</link>"]

    def axis(self, tag, names):
        inside = f"<xyz>{self.vector()}</xyz>"
        if self.version >= 7 and self.chance("expressed", 0.3):
            target = self.pick(self.with_self(names))
            inside = f'<xyz expressed_in="{target}">{self.vector()}</xyz>'
        elif self.version in (5, 6) and self.rng.random() < 0.6:
            flag = self.rng.choice(["true", "false", "1", "0"])
            inside += f"<use_parent_model_frame>{flag}</use_parent_model_frame>"
        if self.version <= 6 or self.rng.random() < 0.3:
            inside += "<limit><lower>-1</lower><upper>1</upper></limit>"
        return f"<{tag}>{inside}</{tag}>"

    def joint(self, name, names):
        """A joint between two things that move with different links; None when there are none."""
        ends = {n: b for n, b in names.items() if n in self.links or self.version >= 8 or
                (self.version == 7 and not is_model(n))}
        child = self.pick(ends)
        parents = [n for n in ends if ends[n] != ends.get(child) and not is_model(n)] + ["world"]
        if child is None:
            return None
        kind = self.rng.choice(JOINT_TYPES[:-1] if self.version < 4 else JOINT_TYPES)
        lines = [f'<joint name="{name}" type="{kind}">',
                 f"  <parent>{self.pick(parents)}</parent>", f"  <child>{child}</child>",
                 "  " + self.pose(names if self.version >= 7 else self.links,
                                  "relative_joint", 0.3)]
        if kind not in ("fixed", "ball"):
            lines.append("  " + self.axis("axis", names))
        if kind in ("universal", "revolute2", "gearbox"):
            lines.append("  " + self.axis("axis2", names))
        if kind == "screw":
            lines.append("  <thread_pitch>2</thread_pitch>")
        if kind == "gearbox":
            lines.append(f"  <gearbox_ratio>3</gearbox_ratio><gearbox_reference_body>{child}"
                         "</gearbox_reference_body>")
        names[name] = names[child]
        return [line for line in lines if line.strip()] + ["</joint>"]

    def frame(self, name, names):
        target = self.pick(names) if self.chance("attached", 0.6) else None
        attached = f' attached_to="{target}"' if target else ""
        lines = [f'<frame name="{name}"{attached}>{self.pose(names)}</frame>']
        names[name] = names.get(target)  # None: the model's canonical link
        return lines

    def include(self, names):
        """An include of a shared model; in a model it may be merged."""
        shared = self.rng.choice(self.wishes["shared"])
        offered = SHARED[shared][3]
        merge = self.chance("merge")
        renamed = self.rng.random() < 0.6 or shared in self.included
        name = self.fresh("part") if renamed else shared
        file = "/model.sdf" if self.rng.random() < 0.2 else ""
        lines = ["<include merge=\"true\">" if merge else "<include>",
                 f"  <uri>model://{shared}{file}</uri>"]
        if renamed:
            lines.append(f"  <name>{name}</name>")
        if self.rng.random() < 0.2 and not merge:
            lines.append(f"  <static>{self.rng.choice(['true', 'false'])}</static>")
        if self.chance("placement_include"):
            pose = self.pose(names) or "<pose>0.5 0 0 0 0 0.25</pose>"
            frame = self.rng.choice([n for n in offered])
            lines += ["  " + pose, f"  <placement_frame>{frame}</placement_frame>"]
        else:
            lines.append("  " + self.pose(names))
        self.included.add(shared)
        if merge:
            self.wishes["shared"] = [s for s in self.wishes["shared"] if s != shared]
            names.update({n: b for n, b in offered.items()})
        else:
            names[name] = f"{name}::{next(iter(offered.values()))}"
            names.update({f"{name}::{n}": f"{name}::{b}" for n, b in offered.items()})
        return [line for line in lines if line.strip()] + ["</include>"]

    included = frozenset()
    links = ()

    def model(self, name, outer=(), depth=0):
        """Lines of a model, and the names it offers."""
        names, blocks, links = {}, [], []
        wishes = self.wishes
        kinds = ["link"] * (self.rng.randint(1, 3) if not self.chance("linkless") or not
                            (depth < wishes.get("depth", 0)) else 0)
        kinds += ["frame"] * self.rng.randint(*wishes.get("frames", (0, 2)))
        if depth < wishes.get("depth", 0):
            kinds += ["model"] * self.rng.randint(1, 2)
        if "shared" in wishes and not wishes.get("world_includes"):
            kinds += ["include"] * self.rng.randint(1, 2)
        if self.version < 7:
            kinds = [k for k in kinds if k != "frame"]
        self.rng.shuffle(kinds)
        included, self.included = self.included, set()
        for kind in kinds:
            new = self.fresh(kind)
            if kind == "link":
                blocks.append(self.link(new, names))
                names[new] = new
                links.append(new)
            elif kind == "model":
                lines, offered, body = self.model(new, self.with_self(names), depth + 1)
                blocks.append(lines)
                names.update({f"{new}::{n}": f"{new}::{b}" for n, b in offered.items()})
                names[new] = f"{new}::{body}"
                links += [f"{new}::{n}" for n, b in offered.items() if n == b]
            elif kind == "include":
                before = set(names)
                blocks.append(self.include(names))
                links += [n for n in names if n not in before and n == names[n]]
            else:
                blocks.append(self.frame(new, names))
        self.included = included
        direct = [n for n in links if "::" not in n]
        canonical, attributes = (direct + links + [None])[0], ""
        if self.version >= 7 and links and self.chance("canonical", 0.1):
            canonical = self.pick(links if self.version >= 8 else direct) or canonical
            attributes += f' canonical_link="{canonical}"'
        names = {n: b or canonical for n, b in names.items()}
        self.links = links
        for _ in range(self.rng.randint(*wishes.get("joints", (0, 2)))):
            blocks.append(self.joint(self.fresh("joint"), names) or [])
        if self.version >= 8 and names and self.chance("placement", 0.05):
            attributes += f' placement_frame="{self.pick(names)}"'
        if self.chance("shuffle", 0.5):
            blocks = self.shuffled(blocks)
        head = [f'<model name="{name}"{attributes}>']
        if self.chance("static", 0.05):
            head.append("  <static>true</static>")
        pose = self.pose(outer)
        lines = head + (["  " + pose] if pose else [])
        return lines + ["  " + line for b in blocks for line in b] + ["</model>"], names, canonical

    def shuffled(self, blocks):
        """Frames and joints anywhere; links and models keep their order, which means something."""
        movable = [b for b in blocks if b and b[0].startswith(("<frame", "<joint"))]
        rest = [b for b in blocks if b and b not in movable]
        for block in movable:
            rest.insert(self.rng.randint(0, len(rest)), block)
        return rest

    def world(self):
        names, lines = {}, ['<world name="w">']
        kinds = ["model"] * self.rng.randint(1, 2)
        if "shared" in self.wishes:
            kinds = ["include"] * self.rng.randint(1, 2) + kinds[:1]
        if self.version >= 7:
            kinds += ["frame"] * self.rng.randint(0, 2)
            names["world"] = ""
        self.rng.shuffle(kinds)
        self.included = set()
        for kind in kinds:
            new = self.fresh(kind)
            if kind == "model":
                block, offered, _ = self.model(new, names)
                names[new] = new
                if self.version >= 8:
                    names.update({f"{new}::{n}": new for n in offered})
            elif kind == "frame":
                block = self.frame(new, names)
            else:
                block = self.include(names)
            lines += ["  " + line for line in block]
        return lines + ["</world>"]

    def document(self, body):
        lines = ['<?xml version="1.0"?>', f'<sdf version="1.{self.version}">']
        return "\n".join(lines + ["  " + line for line in body] + ["</sdf>", ""])


def in_model(rng, versions, **wishes):
    case = Case(rng, rng.choice(versions), **wishes)
    return case.document(case.model("top")[0])


def in_world(rng, versions, **wishes):
    case = Case(rng, rng.choice(versions), world_includes=True, **wishes)
    return case.document(case.world())


def clash(rng):
    """Siblings of one name, which 1.6 and older allow."""
    case = Case(rng, rng.choice([4, 5, 6]))
    links = "".join(f'<link name="{n}">{case.pose([])}</link>\n    ' for n in "abc")
    joints = "".join(
        f'<joint name="{n}" type="revolute"><parent>a</parent><child>{child}</child>'
        f'{case.pose([])}{case.axis("axis", [])}</joint>\n    '
        for n, child in rng.choice([[("b", "b"), ("c", "c")], [("c", "b"), ("c_joint", "c")],
                                    [("a", "c")], [("b_joint", "c"), ("b", "b")]]))
    nested = f'<model name="{rng.choice("dbc")}2"><link name="a"/></model>\n    '
    return case.document([f'<model name="m">\n    {links}{joints}{nested}</model>'])


def flattened(rng):
    """Names with `::`, as 1.7 and older wrote a nested model that had been included."""
    case = Case(rng, rng.choice([4, 5, 6, 7, 7, 7]))

    def placed(target):
        attribute = {4: "", 7: f' relative_to="{target}"'}.get(case.version, f' frame="{target}"')
        return f"<pose{attribute}>{' '.join(case.number() for _ in range(6))}</pose>"

    inner, frame, axis = "body", "", case.axis("axis", [])
    if case.version == 7:
        inner = "arm::__model__"
        frame = (f'<frame name="arm::__model__" attached_to="arm::base">{placed("__model__")}'
                 '</frame>\n    <frame name="arm::tool" attached_to="arm::hand">'
                 f'{placed("arm::base")}</frame>\n    ')
        if rng.random() < 0.5:
            axis = axis.replace("<xyz>", '<xyz expressed_in="arm::__model__">')
    deeper = ""
    if rng.random() < 0.5:
        deeper = (f'<link name="arm::gripper::finger">{placed("arm::hand")}</link>\n'
                  '    <joint name="arm::gripper::close" type="prismatic">'
                  '<parent>arm::hand</parent>'
                  f'<child>arm::gripper::finger</child>{axis}</joint>\n    ')
    return case.document([
        '<model name="m">\n    '
        f'<link name="body">{case.pose([])}</link>\n    {frame}'
        f'<link name="arm::base">{placed(inner)}</link>\n    '
        f'<link name="arm::hand">{placed("arm::base")}</link>\n    {deeper}'
        f'<joint name="arm::wrist" type="revolute"><parent>arm::base</parent>'
        f'<child>arm::hand</child>{case.pose(["arm::base"])}{axis}</joint>\n    '
        f'<joint name="weld" type="fixed"><parent>body</parent><child>arm::base</child></joint>\n  '
        "</model>"])


REJECTED = {
    "missing_relative_to": '<link name="a"><pose relative_to="b"/></link>',
    "missing_attached_to": '<link name="a"/><frame name="f" attached_to="g"/>',
    "missing_child": '<link name="a"/><joint name="j" type="fixed"><parent>a</parent>'
                     '<child>b</child></joint>',
    "missing_parent": '<link name="a"/><joint name="j" type="fixed"><parent>b</parent>'
                      '<child>a</child></joint>',
    "child_is_world": '<link name="a"/><joint name="j" type="fixed"><parent>a</parent>'
                      '<child>world</child></joint>',
    "same_link": '<link name="a"/><frame name="f" attached_to="a"/><joint name="j" type="fixed">'
                 '<parent>a</parent><child>f</child></joint>',
    "relative_to_cycle": '<link name="a"><pose relative_to="b"/></link>'
                         '<link name="b"><pose relative_to="a"/></link>',
    "attached_to_cycle": '<link name="a"/><frame name="f" attached_to="g"/>'
                         '<frame name="g" attached_to="f"/>',
    "into_the_parent": '<link name="a"/><model name="n"><link name="b">'
                       '<pose relative_to="a"/></link></model>',
    "no_link": '<frame name="f"/>',
    "sibling_names": '<link name="a"/><frame name="a"/>',
    "reserved_name": '<link name="__a__"/>',
    "reserved_reference": '<link name="a"><pose relative_to="__root__"/></link>',
    "zero_axis": '<link name="a"/><link name="b"/><joint name="j" type="revolute">'
                 '<parent>a</parent><child>b</child><axis><xyz>0 0 0</xyz></axis></joint>',
}

TWO = ('<link name="a"><pose>0.1 0 0.2 0 0.3 0</pose></link>'
       '<link name="b"><pose>1 0 0 0.5 0 0</pose></link>')


def joint(kind, inside, parent="a", child="b"):
    return (f'<joint name="j" type="{kind}"><parent>{parent}</parent><child>{child}</child>{inside}'
            "</joint>")


# Single odd things: the version and what stands in the model.
ODD = {
    "spelling": (9, '<link name="a"><pose>\n  +1 .5\t-2e-1\n 1E0 0. -0 </pose></link>'),
    "empty_poses": (9, '<link name="a"><pose/></link><link name="b"><pose relative_to="a"> </pose>'
                       '</link><frame name="f" attached_to="b"><pose relative_to=""/></frame>'),
    "trimmed_names": (9, TWO + joint("fixed", "", " a ", "\n b\n")),
    "type_in_capitals": (9, TWO + joint("Revolute", "<axis><xyz>1 0 0</xyz></axis>")),
    "axis_without_xyz": (9, TWO + joint(
        "revolute", "<axis><limit><lower>0</lower></limit></axis>")),
    "fixed_with_axis": (9, TWO + joint("fixed", "<axis><xyz>1 0 0</xyz></axis>")),
    "fixed_with_axis_1_4": (4, TWO + joint("fixed", "<axis><xyz>1 0 0</xyz></axis>")),
    "ball_with_axes": (7, TWO + joint("ball", "<axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz>"
                                              "</axis2>")),
    "no_axis": (9, TWO + joint("revolute", "")),
    "no_axis2": (9, TWO + joint("universal", "<axis><xyz>1 0 0</xyz></axis>")),
    "axis2_alone": (9, TWO + joint("universal", "<axis2><xyz>1 0 0</xyz></axis2>")),
    "revolute_with_axis2": (8, TWO + joint("revolute", "<axis><xyz>1 0 0</xyz></axis><axis2>"
                                                       "<xyz>0 2 0</xyz></axis2>")),
    "parent_model_frame_1_4": (4, TWO + joint(
        "revolute", "<axis><xyz>1 0 1</xyz><use_parent_model_frame>false</use_parent_model_frame>"
                    "</axis>")),
    "parent_model_frame_1_7": (7, TWO + joint(
        "revolute", "<axis><xyz>1 0 1</xyz><use_parent_model_frame>true</use_parent_model_frame>"
                    "</axis>")),
    "parent_model_frame_empty": (6, TWO + joint(
        "revolute", "<axis><xyz>1 0 1</xyz><use_parent_model_frame/></axis>")),
    "expressed_in_1_6": (6, TWO + joint(
        "revolute", '<axis><xyz expressed_in="a">1 0 1</xyz></axis>')),
    "axis2_1_6": (6, TWO + joint(
        "universal", "<axis><xyz>1 0 1</xyz></axis><axis2><xyz>1 1 0</xyz><use_parent_model_frame>"
                     "true</use_parent_model_frame></axis2>")),
    "parent_world_1_6": (6, TWO + joint(
        "revolute", "<pose>0 0 1 0.4 0 0</pose><axis><xyz>1 0 1</xyz><use_parent_model_frame>1"
                    "</use_parent_model_frame></axis>", "world")),
    "relative_to_1_6": (6, '<link name="a"><pose>1 0 0 0 0 1</pose></link><link name="b">'
                           '<pose relative_to="a">1 0 0 0 0 1</pose></link>'),
    "frame_1_7": (7, '<link name="a"><pose>1 0 0 0 0 1</pose></link><link name="b">'
                     '<pose frame="a">1 0 0 0 0 1</pose></link>'),
    "frame_1_4": (4, '<link name="a"><pose>1 0 0 0 0 1</pose></link><link name="b">'
                     '<pose frame="a">1 0 0 0 0 1</pose></link>'),
    "frame_element_1_6": (6, '<frame name="f"><pose>0 0 1 0 0.5 0</pose></frame><link name="a">'
                             '<pose frame="f">1 0 0 0 0 1</pose></link>'),
    "attached_frame_1_6": (6, '<link name="a"><pose>1 0 0 0 0 1</pose><frame name="f">'
                              '<pose>0 0 1 0 0.5 0</pose></frame></link>'),
    "canonical_1_6": (6, TWO),
    "inertial_empty": (9, '<link name="a"><inertial/></link><link name="b"><inertial><mass>3</mass>'
                          '</inertial></link><link name="c"><inertial><inertia/></inertial>'
                          "</link>"),
    "inertial_relative": (6, '<link name="a"><pose>1 0 0 0 0 1</pose></link><link name="b">'
                             "<inertial>"
                             '<pose frame="a">1 0 0 0 0 1</pose></inertial></link>'),
    "quaternion_long": (9, '<link name="a"><pose rotation_format="quat_xyzw">1 2 3 0 0 3 4</pose>'
                           "</link>"),
    "quaternion_degrees": (9, '<link name="a"><pose rotation_format="quat_xyzw" degrees="false">'
                              "1 2 3 0 0.6 0 0.8</pose></link>"),
    "euler_said": (9, '<link name="a"><pose rotation_format="euler_rpy" degrees="1">1 2 3 90 0 30'
                      "</pose></link>"),
    "degrees_1_8": (8, '<link name="a"><pose degrees="true">1 2 3 90 0 30</pose></link>'),
    "gimbal": (9, '<link name="a"><pose>0 0 0 1 1.5707963267948966 2</pose></link>'),
    "child_is_nested_joint": (9, '<link name="a"/><model name="n"><link name="c"/>' + TWO +
                              joint("fixed", "<pose>0 0 1 0 0 0.2</pose>") + "</model>" +
                              joint("revolute", "<axis><xyz>1 1 0</xyz></axis>", "a", "n::j")),
    "child_is_model": (8, '<link name="a"/><model name="n"><pose>0 0 1 0 0.2 0</pose>'
                          '<link name="b"/></model>' + joint("fixed", "", "a", "n")),
    "child_is_own_model": (9, '<link name="a"/><model name="n"><link name="b"/></model>' +
                           joint("fixed", "", "n::b", "__model__")),
    "parent_is_nested_model_frame": (9, '<link name="a"/><model name="n"><link name="b"/></model>' +
                                     joint("fixed", "", "n::__model__", "a")),
    "nested_model_frame": (9, '<link name="a"><pose relative_to="n::__model__">1 0 0 0 0 0</pose>'
                              '</link><model name="n"><pose>0 0 1 0 0.2 0</pose><link name="b"/>'
                              "</model>"),
    "placed_at_model_frame": (9, '<link name="a"/><model name="n" placement_frame="__model__">'
                                 '<pose>0 0 1 0 0.2 0</pose><link name="b"/></model>'),
    "placed_nested": (9, '<link name="a"><pose relative_to="n">1 0 0 0 0 0</pose></link>'
                         '<model name="n" placement_frame="b"><pose relative_to="f">0 0 1 0 0.2 0'
                         '</pose><link name="b"><pose>1 1 1 0 0 1</pose></link></model>'
                         '<frame name="f"><pose>0 2 0 0.3 0 0</pose></frame>'),
    "same_names_in_scopes": (9, '<link name="a"/><model name="m"><link name="a"><pose>1 0 0 0 0 0'
                                '</pose></link></model><frame name="f" attached_to="m::a"/>'),
    "two_same_links": (6, '<link name="a"/><link name="a"><pose>1 0 0 0 0 0</pose></link>'),
    "include_urdf_style": (9, '<include><uri>model://base</uri></include><include>'
                              "<uri>model://base</uri><name>base2</name><pose/></include>"),
    "include_same_name": (9, "<include><uri>model://base</uri></include><include>"
                             "<uri>model://base</uri></include>"),
    "include_placement_alone": (9, "<include><uri>model://base</uri><placement_frame>mount"
                                   "</placement_frame></include>"),
    "include_keeps_pose": (9, "<include><uri>model://placed</uri></include>"),
    "include_empty_pose": (9, "<include><uri>model://old14</uri><pose/></include>"),
    "include_relative_1_6": (6, '<link name="a"><pose>1 0 0 0 0 1</pose></link><include>'
                                '<uri>model://base</uri><pose frame="a">1 0 0 0 0 1</pose>'
                                "</include>"),
    "include_static_flattened": (7, '<link name="a"/><include><uri>model://flat</uri></include>'),
    "merge_keeps_pose": (9, '<link name="a"/><include merge="true"><uri>model://old14</uri><name>o'
                            "</name></include>"),
    "merge_first": (9, '<include merge="true"><uri>model://base</uri></include><link name="a"/>'
                       '<frame name="f"><pose>1 0 0 0 0 0</pose></frame>'),
    "merge_static": (9, '<link name="a"/><include merge="true"><uri>model://fixed</uri></include>'),
    "merge_into_static": (9, '<static>true</static><include merge="true"><uri>model://base</uri>'
                             "</include>"),
    "merge_with_name_taken": (9, '<link name="wheel"/><include merge="true"><uri>model://base</uri>'
                                 "</include>"),
    "merge_in_nested": (9, '<link name="a"/><model name="n"><pose>1 0 0 0 0 0.4</pose>'
                           '<include merge="true"><uri>model://outer</uri></include></model>'),
    "merge_in_1_8": (8, '<link name="a"/><include merge="true"><uri>model://base</uri></include>'),
    "screw_1_9": (9, TWO + joint("screw", "<thread_pitch>0.5</thread_pitch><axis><xyz>0 3 4</xyz>"
                                          "</axis>")),
    "nested_1_4": (4, '<link name="a"/><model name="n"><pose>1 0 0 0 0 0</pose><link name="b"/>'
                      "</model>"),
    "world_as_name": (9, '<link name="world"/>'),
    "colons_1_8": (8, '<link name="a::b"/>'),
    "colons_1_7": (7, '<link name="a::b"><pose>1 0 0 0 0 0</pose></link>'),
    "colons_in_frame_1_7": (7,
                            '<link name="c"/><frame name="a::b"><pose>1 0 0 0 0 0</pose></frame>'),
    "colons_and_model_1_7": (7, '<link name="c"/><model name="a"><link name="d"/></model>'
                                '<link name="a::b"><pose>1 0 0 0 0 0</pose></link>'),
}

# Whole documents.
DOCUMENTS = {
    "two_worlds": '<sdf version="1.6"><world name="w"><model name="m"><link name="a"/></model>'
                  '</world><world name="v"><model name="n"><link name="a"/></model></world></sdf>',
    "two_models_1_6": '<sdf version="1.6"><model name="m"><link name="a"/></model>'
                      '<model name="n"><link name="b"/></model></sdf>',
    "world_and_model": '<sdf version="1.7"><world name="w"><model name="m"><link name="a"/></model>'
                       '</world><model name="n"><link name="b"/></model></sdf>',
    "version_1_0": '<sdf version="1.0"><model name="m"><origin pose="1 0 0 0 0 0.5"/>'
                   '<link name="a">'
                   '<origin pose="0 2 0 0.3 0 0"/><inertial mass="2"><origin pose="0 0 1 0 0 0"/>'
                   '<inertia ixx="0.7" ixy="0.1" ixz="0" iyy="0.8" iyz="0" izz="0.9"/></inertial>'
                   '</link><link name="b"/><joint name="j" type="revolute"><parent link="a"/>'
                   '<child link="b"/><axis xyz="1 0 1"/></joint></model></sdf>',
    "urdf_included": '<sdf version="1.9"><model name="m"><link name="l"/><include>'
                     "<uri>model://urdf</uri><pose>1 0 0 0 0 0.4</pose></include></model></sdf>",
    "urdf_merged": '<sdf version="1.9"><model name="m"><link name="l"/><include merge="true">'
                   "<uri>model://urdf</uri><pose>1 0 0 0 0 0.4</pose></include></model></sdf>",
    "flattened_world": '<sdf version="1.7"><world name="w"><model name="m"><link name="body">'
                       '<pose>1 0 0 0 0 0.3</pose></link><link name="arm::base"><pose>0 1 0 0.2 0 0'
                       '</pose></link><link name="arm::hand"><pose relative_to="arm::base">'
                       '0 0 1 0 0.4 0</pose></link><joint name="arm::wrist" type="revolute">'
                       '<parent>arm::base</parent><child>arm::hand</child><axis><xyz>1 0 0</xyz>'
                       '</axis></joint><joint name="weld" type="fixed"><parent>body</parent>'
                       '<child>arm::base</child></joint></model></world></sdf>',
    "deep_world_frames": '<sdf version="1.9"><world name="w"><frame name="f" attached_to="m::n::b">'
                         '<pose>0 0 1 0.2 0 0</pose></frame><frame name="g" attached_to="f">'
                         '<pose relative_to="world">3 0 0 0 0 1</pose></frame><model name="m">'
                         '<pose relative_to="h">1 0 0 0 0 0</pose><model name="n"><link name="b">'
                         '<pose>0 1 0 0 0.4 0</pose></link></model></model><frame name="h">'
                         "<pose>0 0 5 0 0 0</pose></frame></world></sdf>",
}

URDF = """<robot name="urdf">
  <link name="base"/>
  <link name="arm"/>
  <joint name="turn" type="revolute">
    <origin xyz="0.1 0.2 0.3" rpy="0.4 0 0.5"/>
    <parent link="base"/><child link="arm"/><axis xyz="0 0.6 0.8"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
"""
INERTIAL = """
    <inertial><origin xyz="0 0.1 0" rpy="0.2 0 0"/><mass value="2"/>
      <inertia ixx="0.7" ixy="0.05" ixz="0" iyy="0.8" iyz="0" izz="0.9"/></inertial>
  """
URDF = URDF.replace('"base"/>\n', f'"base">{INERTIAL}</link>\n').replace(
    '"arm"/>\n', f'"arm">{INERTIAL}</link>\n')

SOME = ["base", "placed", "tree", "hollow", "outer", "old14", "old16", "fixed", "fused"]

TOPICS = [
    ("old_1_2", 12, in_model, dict(versions=[2], joints=(1, 3), inertial=0.6)),
    ("old_1_3", 12, in_model, dict(versions=[3], joints=(1, 3), parts=0.6)),
    ("old_1_4", 14, in_model, dict(versions=[4], joints=(1, 4))),
    ("old_1_5", 16, in_model, dict(versions=[5], joints=(1, 4), depth=1)),
    ("old_1_6", 24, in_model, dict(versions=[6], joints=(1, 4), depth=1, parts=0.4)),
    ("world_1_6", 10, in_world, dict(versions=[5, 6], joints=(1, 2))),
    ("frames_1_7", 16, in_model, dict(versions=[7], frames=(2, 5), joints=(1, 3))),
    ("nested_1_7", 10, in_model, dict(versions=[7], depth=1, scoped=0.0)),
    ("chains", 18, in_model, dict(versions=[8, 9], frames=(4, 8), relative=0.9, attached=0.9)),
    ("nested", 26, in_model, dict(versions=[8, 9], depth=2, joints=(1, 2), scoped=0.7)),
    ("axes", 20, in_model, dict(versions=[7, 8, 9], joints=(3, 5), expressed=0.9)),
    ("joint_poses", 12, in_model, dict(versions=[8, 9], joints=(3, 5), relative_joint=0.9)),
    ("rotations", 14, in_model, dict(versions=[9], degrees=0.5, quaternion=0.6, depth=1)),
    ("inertials", 20, in_model, dict(versions=[2, 5, 6, 7, 9], inertial=1.0, partial=0.5)),
    ("parts", 14, in_model, dict(versions=[7, 8, 9], parts=0.9, relative_parts=0.8, frames=(1, 3))),
    ("canonical", 14, in_model, dict(versions=[7, 8, 9], canonical=0.9, depth=2, frames=(1, 3))),
    ("placement", 18, in_model, dict(versions=[8, 9], placement=0.9, depth=2, frames=(1, 3))),
    ("linkless", 12, in_model, dict(versions=[8, 9], linkless=1.0, depth=2, frames=(1, 2))),
    ("worlds", 20, in_world, dict(versions=[7, 8, 9], frames=(0, 3), depth=1, placement=0.3)),
    ("static", 6, in_world, dict(versions=[6, 8, 9], static=0.8, depth=1)),
    ("spaces", 6, in_model, dict(versions=[7, 9], spaces=0.7, depth=1, frames=(1, 2))),
    ("include_model", 22, in_model, dict(versions=[8, 9], shared=SOME, frames=(1, 3))),
    ("include_old", 10, in_model, dict(versions=[5, 6, 7], shared=SOME, scoped=0.0)),
    ("include_world", 18, in_world, dict(versions=[6, 7, 8, 9], shared=SOME, depth=0)),
    ("include_nested", 12, in_model, dict(versions=[9], shared=SOME, depth=1, scoped=0.8)),
    ("include_placement", 18, in_model, dict(versions=[8, 9], shared=SOME, placement_include=0.9)),
    ("include_placement_world", 12, in_world,
     dict(versions=[8, 9], shared=SOME, placement_include=0.9)),
    ("merge", 24, in_model, dict(versions=[9], merge=0.8, frames=(0, 2), upright=1.0,
                                shared=["outer", "old14", "base", "hollow"])),
    ("merge_twice", 10, in_model,
     dict(versions=[9], merge=0.8, upright=1.0, shared=["fused", "old14"])),
    ("merge_placement", 20, in_model, dict(versions=[9], merge=0.9, placement_include=0.5,
                                           shared=["base", "placed", "tree", "outer", "hollow"])),
    ("clash", 12, clash, {}),
    ("flattened", 16, flattened, {}),
]


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def main():
    for folder in ("cases", "models"):
        shutil.rmtree(HERE / folder, ignore_errors=True)
    for name, (version, start, body, _) in SHARED.items():
        write(HERE / "models" / name / "model.sdf",
              f'<?xml version="1.0"?>\n<sdf version="1.{version}">\n  {start}{body}\n'
              "  </model>\n</sdf>\n")
        write(HERE / "models" / name / "model.config",
              f'<?xml version="1.0"?>\n<model>\n  <name>{name}</name>\n'
              f'  <sdf version="1.{version}">model.sdf</sdf>\n</model>\n')
    write(HERE / "models" / "urdf" / "model.urdf", URDF)
    write(HERE / "models" / "urdf" / "model.config",
          '<?xml version="1.0"?>\n<model>\n  <name>urdf</name>\n'
          "  <sdf>model.urdf</sdf>\n</model>\n")
    number = 0
    for topic, text in DOCUMENTS.items():
        number += 1
        write(HERE / "cases" / f"{number:03}_{topic}.sdf", text.replace("><", ">\n<") + "\n")
    for topic, count, make, wishes in TOPICS:
        for i in range(count):
            number += 1
            rng = random.Random(f"{topic} {i}")
            text = make(rng, **wishes)
            while text.count("\n") > LONGEST:
                text = make(rng, **wishes)
            write(HERE / "cases" / f"{number:03}_{topic}.sdf", text)
    for topic, (version, body) in [*ODD.items(), *(("rejected_" + topic, (9, body))
                                                   for topic, body in REJECTED.items())]:
        number += 1
        write(HERE / "cases" / f"{number:03}_{topic}.sdf",
              f'<?xml version="1.0"?>\n<sdf version="1.{version}">\n  <model name="m">\n'
              f"    {body}\n  </model>\n</sdf>\n")


if __name__ == "__main__":
    main()
