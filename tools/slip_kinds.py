# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Kinds of slips that people make in robot models and worlds, as edits of bytes.

A kind is a function from a `Text` to the slips of that kind which the file has room for. Those of the family
`harmless` change nothing that a consumer could notice.
"""

import math
import re

KINDS = []  # (family, name, function)


class Slip:
    """Bytes to replace, and the element that a finding has to be about; others whose names count, too. `meant` are
    the edits of who makes no slip, where these are not none."""

    def __init__(self, element, *edits, also=(), meant=()):
        self.element, self.edits, self.also, self.meant = element, list(edits), list(also), list(meant)

    def apply(self, data):
        return edited(data, self.edits)

    def right(self, data):
        return edited(data, self.meant)


def edited(data, edits):
    for begin, end, text in sorted(edits, reverse=True):
        data = data[:begin] + text + data[end:]
    return data


def kind(family, name):
    def register(function):
        KINDS.append((family, name, function))
        return function
    return register


def put(value, text):
    return (value.begin, value.end, str(text).encode())


def number(x):
    return f"{x:.10g}"


def scaled(value, factor, where=None):
    """Each number times `factor`, or the one at an index."""
    words = value.text.split()
    return put(value, " ".join(number(float(word) * factor) if where in (None, i) and float(word) != 0 else word
                               for i, word in enumerate(words)))


def drop(element):
    return (element.begin, element.end, b"")


def misspelt(text):
    """A letter left out of the middle, or two exchanged."""
    at = max(1, len(text) * 2 // 3)
    while at < len(text) - 1 and not (text[at].isalpha() and text[at + 1].isalpha() and text[at] != text[at + 1]):
        at += 1
    if at >= len(text) - 1:
        return text + "x"
    return text[:at] + text[at + 1] + text[at] + text[at + 2:]


class Origin:
    """Where an element is, in either format: numbers that can be set one by one."""

    def __init__(self, element):
        self.parts = None
        origin, pose = element.child("origin"), element.value("pose")
        if origin and origin.attribute("xyz"):
            xyz, rpy = origin.attribute("xyz"), origin.attribute("rpy")
            self.parts = [xyz, rpy]
            self.xyz, self.rpy = xyz.numbers(), rpy.numbers() if rpy else []
        elif pose and len(pose.numbers()) == 6:
            self.parts = [pose]
            self.xyz, self.rpy = pose.numbers()[:3], pose.numbers()[3:]

    def __bool__(self):
        return self.parts is not None and len(self.xyz) == 3

    def size(self):
        return max(map(abs, self.xyz))

    def set(self, xyz=None, rpy=None):
        """The edit that writes these numbers; others keep their text."""
        if len(self.parts) == 2:
            value, new = (self.parts[0], xyz) if xyz is not None else (self.parts[1], rpy)
            old = value.numbers()
        else:
            value = self.parts[0]
            old, new = value.numbers(), (xyz or self.xyz) + (rpy or self.rpy)
        words = value.text.split()
        return put(value, " ".join(word if a == b else number(b) for word, a, b in zip(words, old, new)))


def is_joint(element):
    """Whether it is a joint with two ends, and no mention of one."""
    return element.name == "joint" and element.child("parent") is not None


def joints(text):
    return [joint for joint in text.all("joint") if is_joint(joint)]


def placed(text):
    """What decides where a link is: the joint of a URDF, the link of an SDF. Of SDF those that a joint moves."""
    if text.is_urdf:
        return joints(text)
    children = {joint.value("child").text for joint in joints(text) if joint.value("child")}
    return [link for link in text.all("link") if link.get("name") in children]


def parts(text, name):
    return [part for part in text.all(name) if part.within("link") is not None]


def origins(text, which, least):
    for element in placed(text) if which == "joint" else parts(text, which):
        origin = Origin(element)
        if origin and origin.size() >= least:
            yield element, origin


WHERE = ("joint", "collision", "visual", "inertial")

# What moves a part by less than both is no fault that anybody sees: meters, and a share of the robot.
LEAST_MOVE = 0.002
LEAST_SHARE = 0.01


def reach(text):
    """How long a robot is at least: its longest origin or primitive shape."""
    lengths = [origin.size() for element in placed(text) + parts(text, "collision") + parts(text, "visual") if (origin := Origin(element))]
    for part in parts(text, "collision") + parts(text, "visual"):
        for shape, field, by in (("box", "size", 1), ("cylinder", "length", 1), ("cylinder", "radius", 2), ("sphere", "radius", 2)):
            found = part.child("geometry", shape)
            value = found and (found.attribute(field) or found.value(field))
            lengths += [by * abs(x) for x in value.numbers()] if value else []
    return max((x for x in lengths if x < 100), default=0.0)


def bodies(text):
    """Names of links that can be seen or touched or weigh something, and of those that carry such."""
    found = {link.get("name") for link in text.all("link") if any(link.child(name) for name in ("visual", "collision", "inertial"))}
    ends_of = [[end and (end.get("link") or getattr(end.value(), "text", "")) for end in (joint.child("parent"), joint.child("child"))]
               for joint in joints(text)]
    for _ in range(len(ends_of)):
        more = {parent for parent, child in ends_of if child in found} - found
        if not more:
            break
        found |= more
    return found


def visibly_moved(text, which, slips_of):
    """Those slips of (element, origin, new xyz) that move something far enough to be seen."""
    least = max(LEAST_MOVE, LEAST_SHARE * reach(text))
    solid = bodies(text)
    for element, origin, xyz in slips_of:
        moved = sum((a - b) ** 2 for a, b in zip(origin.xyz, xyz)) ** 0.5
        child = element.child("child")
        name = (child.get("link") or getattr(child.value(), "text", "")) if child else element.get("name")
        if moved >= least and (which != "joint" or name in solid):
            yield Slip(element, origin.set(xyz=xyz))


def origin_kinds():
    def by_factor(which, factor, least):
        return lambda text: visibly_moved(text, which, ((element, origin, [x * factor for x in origin.xyz])
                                                        for element, origin in origins(text, which, least)))

    def left_out(which):
        return lambda text: visibly_moved(text, which, ((element, origin, [0.0, 0.0, 0.0])
                                                        for element, origin in origins(text, which, 0.03)))

    def sign(which):
        def slips(text):
            for element, origin in origins(text, which, 0.03):
                at = max(range(3), key=lambda i: abs(origin.xyz[i]))
                yield element, origin, [-x if i == at else x for i, x in enumerate(origin.xyz)]
        return lambda text: visibly_moved(text, which, slips(text))

    for which in WHERE:
        kind("placement", f"{which} origin in mm")(by_factor(which, 1000, 0.01))
        kind("placement", f"{which} origin sign")(sign(which))
    for which in WHERE[:3]:
        kind("placement", f"{which} origin in cm")(by_factor(which, 100, 0.01))
        kind("placement", f"{which} origin times ten")(by_factor(which, 10, 0.03))
        kind("placement", f"{which} origin a tenth")(by_factor(which, 0.1, 0.05))
        kind("placement", f"{which} origin left out")(left_out(which))


origin_kinds()


@kind("placement", "components of a joint origin exchanged")
def exchanged(text):
    def slips():
        for element, origin in origins(text, "joint", 0.03):
            x, y, z = origin.xyz
            for new in ([y, x, z], [x, z, y]):
                if max(abs(a - b) for a, b in zip(new, origin.xyz)) > 0.03:
                    yield element, origin, new
                    break
    return visibly_moved(text, "joint", slips())


def turned(text, which, change):
    for element in placed(text) if which == "joint" else parts(text, which):
        origin = Origin(element)
        if origin and len(origin.rpy) == 3 and max(map(abs, origin.rpy)) > 0.5:
            yield Slip(element, origin.set(rpy=[change(r) for r in origin.rpy]))


@kind("placement", "joint rotation in degrees")
def joint_degrees(text):
    return turned(text, "joint", lambda r: round(r * 57.29578, 1))


@kind("placement", "collision rotation in degrees")
def collision_degrees(text):
    return turned(text, "collision", lambda r: round(r * 57.29578, 1))


@kind("placement", "collision rotation left out")
def collision_rotation(text):
    """Of shapes that fill another place then: half a turn leaves a box as it was, and any turn about z a cylinder."""
    for slip in turned(text, "collision", lambda r: 0.0):
        roll, pitch, yaw = (abs(math.sin(angle)) > 0.2 for angle in Origin(slip.element).rpy)
        box = slip.element.child("geometry", "box")
        size = box and (box.attribute("size") or box.value("size"))
        sides = size.numbers() if size else []
        if slip.element.child("geometry", "cylinder") and (roll or pitch):
            yield slip
        elif len(sides) == 3 and max(sides) > 1.1 * min(sides) and (roll or pitch or yaw):
            yield slip


def meshes(text, which):
    for part in parts(text, which):
        mesh = part.child("geometry", "mesh")
        value = mesh and (mesh.attribute("filename") or mesh.value("uri"))
        if value:
            yield part, value


@kind("placement", "collision mesh of another link")
def other_mesh(text):
    found = list(meshes(text, "collision"))
    for i, (part, value) in enumerate(found):
        for other, uri in found[i + 1:] + found[:i]:
            if uri.text != value.text and other.within("link") is not part.within("link"):
                yield Slip(part, put(value, uri.text))
                break


# Sizes.

def shapes(text, which, shape, *fields):
    """(part, values) of each shape of that name with all fields written."""
    for part in parts(text, which):
        found = part.child("geometry", shape)
        values = [found and (found.attribute(field) or found.value(field)) for field in fields]
        if all(values):
            yield part, values


def size_kinds():
    def factor(shape, field, by, which="collision"):
        return lambda text: (Slip(part, scaled(value, by)) for part, (value,) in shapes(text, which, shape, field))

    kind("size", "cylinder diameter as radius")(factor("cylinder", "radius", 2))
    kind("size", "cylinder radius halved")(factor("cylinder", "radius", 0.5))
    kind("size", "cylinder radius times ten")(factor("cylinder", "radius", 10))
    kind("size", "cylinder length in mm")(factor("cylinder", "length", 1000))
    kind("size", "cylinder length times ten")(factor("cylinder", "length", 10))
    kind("size", "sphere diameter as radius")(factor("sphere", "radius", 2))
    kind("size", "sphere radius a tenth")(factor("sphere", "radius", 0.1))
    kind("size", "box in mm")(factor("box", "size", 1000))
    kind("size", "box of half extents")(factor("box", "size", 0.5))
    kind("size", "box times ten")(factor("box", "size", 10))
    kind("size", "visual cylinder times ten")(factor("cylinder", "radius", 10, "visual"))

    def mesh_scale(which, by):
        def slips(text):
            for part in parts(text, which):
                mesh = part.child("geometry", "mesh")
                value = mesh and (mesh.attribute("scale") or mesh.value("scale"))
                if value and len(value.numbers()) == 3:
                    yield Slip(part, scaled(value, by))
                elif mesh and mesh.attribute("filename"):
                    end = mesh.attribute("filename").end + 1
                    yield Slip(part, (end, end, f' scale="{by:g} {by:g} {by:g}"'.encode()))
        return slips

    for which in ("collision", "visual"):
        kind("size", f"{which} mesh scale left out")(lambda text, which=which: (
            slip for slip in mesh_scale(which, 1000)(text)))
        kind("size", f"{which} mesh times ten")(mesh_scale(which, 10))
    kind("size", "collision mesh in inches")(mesh_scale("collision", 25.4))
    kind("size", "collision mesh mirrored")(mesh_scale("collision", -1))


size_kinds()


@kind("size", "radius and length exchanged")
def radius_length(text):
    for part, (radius, length) in shapes(text, "collision", "cylinder", "radius", "length"):
        a, b = radius.numbers(), length.numbers()
        if a and b and b[0] and not 0.5 < a[0] / b[0] < 2:
            yield Slip(part, put(radius, length.text), put(length, radius.text))


@kind("size", "one component of a box ten times")
def box_component(text):
    for part, (size,) in shapes(text, "collision", "box", "size"):
        if len(size.numbers()) == 3:
            yield Slip(part, scaled(size, 10, 1))


# Pairs.

SIDES = [("left", "right"), ("Left", "Right"), ("_l_", "_r_"), ("l_", "r_"), ("LF", "RF"), ("LH", "RH"), ("FL", "FR"), ("HL", "HR"),
         ("fl_", "fr_"), ("lf_", "rf_"), ("lh_", "rh_")]


def twins(text, elements):
    """(one, other) by their names."""
    by_name = {element.get("name"): element for element in elements}
    for name, one in by_name.items():
        for left, right in SIDES:
            other = by_name.get(name.replace(left, right, 1)) if left in name else None
            if other is not None and other is not one:
                yield one, other
                break


@kind("mirror", "origin of one side has the other's sign")
def side_sign(text):
    for one, other in twins(text, placed(text)):
        a, b = Origin(one), Origin(other)
        if a and b:
            for i in range(3):
                if abs(a.xyz[i]) > 0.02 and abs(a.xyz[i] + b.xyz[i]) < 1e-9:
                    yield Slip(one, a.set(xyz=[b.xyz[k] if k == i else x for k, x in enumerate(a.xyz)]), also=[other])


@kind("mirror", "origin of one side a little off")
def side_off(text):
    for one, other in twins(text, placed(text)):
        a, b = Origin(one), Origin(other)
        if a and b and a.size() > 0.03 and [abs(x) for x in a.xyz] == [abs(x) for x in b.xyz]:
            at = max(range(3), key=lambda i: abs(a.xyz[i]))
            yield Slip(one, a.set(xyz=[x * 1.2 if i == at else x for i, x in enumerate(a.xyz)]), also=[other])


def axis_value(joint):
    axis = joint.child("axis")
    return axis and (axis.attribute("xyz") or axis.value("xyz"))


@kind("mirror", "axis of one side negated")
def side_axis(text):
    for one, other in twins(text, joints(text)):
        a, b = axis_value(one), axis_value(other)
        if a and b and [abs(x) for x in a.numbers()] == [abs(x) for x in b.numbers()]:
            yield Slip(one, put(a, " ".join(number(-x + 0.0) for x in a.numbers())), also=[other])


def limit_value(joint, name):
    """Of what is read: a URDF's continuous joint has no position limits."""
    if joint.get("type") == "continuous" and name in ("lower", "upper"):
        return None
    limit = joint.child("limit") or joint.child("axis", "limit")
    return limit and (limit.attribute(name) or limit.value(name))


def finite(value, least=0.0, most=1e4):
    return bool(value and len(value.numbers()) == 1 and least < abs(value.numbers()[0]) < most)


@kind("mirror", "limit of one side changed")
def side_limit(text):
    for one, other in twins(text, joints(text)):
        a, b = limit_value(one, "upper"), limit_value(other, "upper")
        if finite(a, 0.1) and finite(b, 0.1):
            yield Slip(one, scaled(a, 1.3 if a.numbers()[0] > 0 else 0.7), also=[other])


def mass_value(link):
    mass = link.child("inertial", "mass")
    return mass and (mass.attribute("value") or mass.value())


@kind("mirror", "mass of one side doubled")
def side_mass(text):
    for one, other in twins(text, text.all("link")):
        a, b = mass_value(one), mass_value(other)
        if a and b and finite(a) and a.numbers() == b.numbers():
            yield Slip(one, scaled(a, 2), also=[other])


@kind("mirror", "center of mass of one side with the other's sign")
def side_center(text):
    for one, other in twins(text, text.all("link")):
        inertials = one.child("inertial"), other.child("inertial")
        a, b = (Origin(inertial) if inertial else None for inertial in inertials)
        if a and b:
            for i in range(3):
                if abs(a.xyz[i]) > 0.01 and abs(a.xyz[i] + b.xyz[i]) < 1e-9:
                    yield Slip(one, a.set(xyz=[b.xyz[k] if k == i else x for k, x in enumerate(a.xyz)]), also=[other])


@kind("mirror", "mesh of the other side")
def side_mesh(text):
    by_link = {}
    for part, value in meshes(text, "collision"):
        by_link.setdefault(part.within("link"), (part, value))
    for one, other in twins(text, by_link):
        (part, a), (_, b) = by_link[one], by_link[other]
        if a.text != b.text:
            yield Slip(part, put(a, b.text), also=[other])


# Inertia.

def inertias(text):
    """(link, {name: value}, mass) of each link whose six values are written."""
    for link in text.all("link"):
        tensor = link.child("inertial", "inertia")
        values = {name: tensor and (tensor.attribute(name) or tensor.value(name))
                  for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")}
        mass = mass_value(link)
        if all(values.values()) and mass and finite(mass) and all(len(v.numbers()) == 1 for v in values.values()):
            moments = [values[name].numbers()[0] for name in ("ixx", "iyy", "izz")]
            # A tensor that is no body's already is an error, and stays the same one.
            if min(moments) > 0 and 2 * max(moments) <= sum(moments) * 1.000001:
                yield link, values, mass


def inertia_factor(by):
    return lambda text: (Slip(link, *(scaled(v, by) for v in values.values())) for link, values, _ in inertias(text))


kind("inertia", "tensor in g·m²")(inertia_factor(1000))
kind("inertia", "tensor in kg·mm²")(inertia_factor(1e6))
kind("inertia", "tensor a thousandth")(inertia_factor(0.001))


@kind("inertia", "tensor about the link's origin")
def about_origin(text):
    for link, values, mass in inertias(text):
        origin, m = Origin(link.child("inertial")), mass.numbers()[0]
        if not origin:
            continue
        x, y, z = origin.xyz
        add = {"ixx": m * (y * y + z * z), "iyy": m * (x * x + z * z), "izz": m * (x * x + y * y),
               "ixy": -m * x * y, "ixz": -m * x * z, "iyz": -m * y * z}
        if max(add[k] / values[k].numbers()[0] for k in ("ixx", "iyy", "izz")) > 1:
            yield Slip(link, *(put(v, number(v.numbers()[0] + add[k])) for k, v in values.items()))


@kind("inertia", "axes of the tensor exchanged")
def axes_exchanged(text):
    for link, values, _ in inertias(text):
        moments = sorted(((values[k].numbers()[0], k) for k in ("ixx", "iyy", "izz")))
        if moments[2][0] > 2.5 * moments[0][0]:
            low, high = values[moments[0][1]], values[moments[2][1]]
            yield Slip(link, put(low, high.text), put(high, low.text))


@kind("inertia", "products negated")
def products(text):
    for link, values, _ in inertias(text):
        trace = sum(values[k].numbers()[0] for k in ("ixx", "iyy", "izz"))
        off = [values[k] for k in ("ixy", "ixz", "iyz")]
        if max(abs(v.numbers()[0]) for v in off) > 0.05 * trace:
            yield Slip(link, *(scaled(v, -1) for v in off))


@kind("inertia", "template's tensor")
def template(text):
    for link, values, mass in inertias(text):
        # One template in place of another changes little.
        is_template = len({values[k].numbers()[0] for k in ("ixx", "iyy", "izz")}) == 1
        if mass.numbers()[0] > 0.5 and not is_template:
            yield Slip(link, *(put(v, "0.001" if k[1] == k[2] else "0") for k, v in values.items()))


@kind("inertia", "identity tensor")
def identity(text):
    for link, values, mass in inertias(text):
        if mass.numbers()[0] < 5:
            yield Slip(link, *(put(v, "1" if k[1] == k[2] else "0") for k, v in values.items()))


@kind("inertia", "mass in grams")
def grams(text):
    return (Slip(link, scaled(mass, 1000)) for link, _, mass in inertias(text))


@kind("inertia", "mass a hundredth")
def hundredth(text):
    return (Slip(link, scaled(mass, 0.01)) for link, _, mass in inertias(text))


@kind("inertia", "one moment left zero")
def zero_moment(text):
    return (Slip(link, put(values["izz"], "0")) for link, values, _ in inertias(text))


@kind("inertia", "one moment ten times")
def one_moment(text):
    return (Slip(link, scaled(values["iyy"], 10)) for link, values, _ in inertias(text))


@kind("inertia", "inertial left out of a moving link")
def no_inertial(text):
    moved = {joint.child("child").get("link") or getattr(joint.value("child"), "text", "") for joint in joints(text)
             if joint.child("child") and joint.get("type") != "fixed"}
    return (Slip(link, drop(link.child("inertial"))) for link in text.all("link")
            if link.child("inertial") and link.get("name") in moved)


@kind("inertia", "inertial turned by a right angle")
def inertial_turned(text):
    for link, values, _ in inertias(text):
        origin = Origin(link.child("inertial"))
        if origin and len(origin.rpy) == 3 and values["izz"].numbers()[0] > 2 * values["ixx"].numbers()[0]:
            yield Slip(link, origin.set(rpy=[origin.rpy[0], origin.rpy[1] + 1.570796, origin.rpy[2]]))


# Joints.

MOVES = ("revolute", "continuous", "prismatic")


def moving(text):
    return [joint for joint in joints(text) if joint.get("type") in MOVES]


@kind("joint", "axis another one")
def axis_other(text):
    for joint in moving(text):
        value = axis_value(joint)
        if value and sorted(map(abs, value.numbers())) == [0, 0, 1]:
            yield Slip(joint, put(value, " ".join(value.text.split()[1:] + value.text.split()[:1])))


def with_dynamics(name, change):
    """`change` of the number that is written, or of none."""
    def slips(text):
        for joint in moving(text):
            dynamics = joint.child("dynamics") or joint.child("axis", "dynamics")
            value = dynamics and (dynamics.attribute(name) or dynamics.value(name))
            if value and change(value.text):
                yield Slip(joint, put(value, change(value.text)))
            elif text.is_urdf and not dynamics:
                yield Slip(joint, (joint.inner_end, joint.inner_end, f'<dynamics {name}="{change("0.5")}"/>'.encode()))
    return slips


def negated(text):
    """A minus before a number that is not zero."""
    return "-" + text if re.fullmatch(r"[0-9.eE+-]*[1-9][0-9.eE+-]*", text) and not text.startswith("-") else None


kind("joint", "damping that lets nothing move")(with_dynamics("damping", lambda old: "100000"))
kind("joint", "friction that lets nothing move")(with_dynamics("friction", lambda old: "100000"))
kind("joint", "damping negative")(with_dynamics("damping", negated))


def limit_factor(name, by, types, least):
    return lambda text: (Slip(joint, scaled(limit_value(joint, name), by)) for joint in moving(text)
                         if joint.get("type") in types and finite(limit_value(joint, name), least, 1000)
                 # A negative one is none.
                 and (name in ("lower", "upper") or limit_value(joint, name).numbers()[0] > 0))


kind("joint", "velocity in degrees")(limit_factor("velocity", 57.29578, ("revolute", "continuous"), 0.5))
kind("joint", "effort a thousandth")(limit_factor("effort", 0.001, MOVES, 0.2))
kind("joint", "upper limit in mm")(limit_factor("upper", 1000, ("prismatic",), 0.001))


@kind("joint", "limits in degrees")
def limit_degrees(text):
    for joint in moving(text):
        values = [value for name in ("lower", "upper") if finite(value := limit_value(joint, name), 0.3, 7)]
        if values and joint.get("type") == "revolute":
            yield Slip(joint, *(put(value, number(round(value.numbers()[0] * 57.29578, 1))) for value in values))


@kind("joint", "effort zero")
def effort_zero(text):
    return (Slip(joint, put(limit_value(joint, "effort"), "0")) for joint in moving(text)
            if finite(limit_value(joint, "effort")))


@kind("joint", "velocity zero")
def velocity_zero(text):
    return (Slip(joint, put(limit_value(joint, "velocity"), "0")) for joint in moving(text)
            if finite(limit_value(joint, "velocity")))


@kind("joint", "limits exchanged")
def limits_exchanged(text):
    for joint in moving(text):
        low, high = limit_value(joint, "lower"), limit_value(joint, "upper")
        if low and high and finite(high) and low.numbers() != high.numbers():
            yield Slip(joint, put(low, high.text), put(high, low.text))


@kind("joint", "limits of the other direction")
def limits_mirrored(text):
    """Of a joint that moves to one side, on a link that can be seen to move."""
    for joint in moving(text):
        low, high = limit_value(joint, "lower"), limit_value(joint, "upper")
        if joint.get("type") != "revolute" or not low or not finite(high, -1, 7) or not finite(low, -1, 7):
            continue
        a, b = low.numbers()[0], high.numbers()[0]
        if a <= 0 <= b and max(-a, b) > 1 and min(-a, b) < 0.3 * max(-a, b):
            yield Slip(joint, put(low, number(0 - b)), put(high, number(0 - a)))


@kind("joint", "limit sign lost")
def limit_sign(text):
    for joint in moving(text):
        low, high = limit_value(joint, "lower"), limit_value(joint, "upper")
        if finite(low, 0.1) and finite(high, 0.1) and low.text.startswith("-") and high.numbers()[0] > 0:
            yield Slip(joint, put(low, low.text[1:]))


@kind("joint", "both limits zero")
def limits_zero(text):
    for joint in moving(text):
        low, high = limit_value(joint, "lower"), limit_value(joint, "upper")
        if finite(high, 0.1) and low:
            yield Slip(joint, put(low, "0"), put(high, "0"))


def ends(joint):
    found = []
    for name in ("parent", "child"):
        end = joint.child(name)
        found.append(end and (end.attribute("link") or end.value()))
    return found


@kind("joint", "parent and child exchanged")
def ends_exchanged(text):
    for joint in joints(text):
        parent, child = ends(joint)
        if parent and child and parent.text != "world":
            yield Slip(joint, put(parent, child.text), put(child, parent.text),
                       also=[link for link in text.all("link") if link.get("name") in (parent.text, child.text)])


@kind("joint", "limit left out")
def no_limit(text):
    return (Slip(joint, drop(joint.child("limit"))) for joint in moving(text)
            if joint.child("limit") and joint.get("type") != "continuous")


def type_to(old, new):
    return lambda text: (Slip(joint, put(joint.attribute("type"), new)) for joint in joints(text) if joint.get("type") == old)


kind("joint", "fixed instead of revolute")(type_to("revolute", "fixed"))
kind("joint", "prismatic instead of revolute")(type_to("revolute", "prismatic"))
kind("joint", "type misspelt")(type_to("revolute", "revolut"))
