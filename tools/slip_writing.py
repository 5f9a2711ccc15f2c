# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Kinds of slips in what is written: XML, numbers, names, files, mimics, materials; and edits that are none."""

import re

from slip_kinds import Slip, ends, joints, kind, limit_value, mass_value, misspelt, put


def named(text, *names):
    return [element for element in text.all(*names) if element.attribute("name")]


# XML.

def solid(text):
    return [element for element in text.all("link", "joint", "collision", "visual", "inertial", "geometry") if element.inner_end > element.tag_end]


@kind("xml", "end tag left out")
def no_end(text):
    return (Slip(one, (one.inner_end, one.end, b"")) for one in solid(text))


@kind("xml", "end tag misspelt")
def wrong_end(text):
    return (Slip(one, (one.inner_end, one.end, f"</{misspelt(one.name)}>".encode())) for one in solid(text))


@kind("xml", "quote left out")
def no_quote(text):
    return (Slip(one, (one.attribute("name").end, one.attribute("name").end + 1, b"")) for one in named(text, "link", "joint"))


@kind("xml", "bare ampersand")
def ampersand(text):
    return (Slip(one, put(one.attribute("name"), one.get("name") + "&co"), meant=[put(one.attribute("name"), one.get("name") + "&amp;co")])
            for one in named(text, "link", "joint", "visual"))


@kind("xml", "attribute twice")
def attribute_twice(text):
    for one in named(text, "link", "joint"):
        end = one.attribute("name").end + 1
        yield Slip(one, (end, end, b' name="again"'))


@kind("xml", "element misspelt")
def element(text):
    for one in text.all("collision", "inertial", "limit", "geometry", "origin", "axis", "mass"):
        wrong = misspelt(one.name).encode()
        edits = [(one.begin + 1, one.begin + 1 + len(one.name), wrong)]
        if one.inner_end > one.tag_end or one.end > one.tag_end:
            edits.append((one.inner_end + 2, one.inner_end + 2 + len(one.name), wrong))
        yield Slip(one, *edits)


@kind("xml", "attribute misspelt")
def attribute(text):
    for one in text.all("origin", "limit", "axis", "mesh", "parent", "child", "inertia"):
        for name, value in one.attributes.items():
            begin = value.begin - 2 - len(name)
            if len(name) > 2 and text.data[begin:begin + len(name)] == name.encode():
                yield Slip(one, (begin, begin + len(name), misspelt(name).encode()))
                break


# Numbers.

def numbers(text):
    """(element, value) of masses, limits, origins and poses."""
    for link in text.all("link"):
        if (mass := mass_value(link)) and mass.numbers():
            yield link, mass
    for joint in joints(text):
        for name in ("upper", "effort"):
            if (value := limit_value(joint, name)) and value.numbers():
                yield joint, value
    for origin in text.all("origin"):
        if (value := origin.attribute("xyz")) and value.numbers():
            yield origin, value
    for pose in text.all("pose"):
        if (value := pose.value()) and value.numbers():
            yield pose, value


def number_kind(name, change):
    kind("numbers", name)(lambda text: (Slip(one, put(value, new)) for one, value in numbers(text) if (new := change(value.text))))


number_kind("decimal comma", lambda old: old.replace(".", ",", 1) if "." in old else None)
number_kind("unit behind the number", lambda old: old + "m")
number_kind("letter O for zero", lambda old: old.replace("0", "O", 1) if "0" in old else None)
number_kind("two decimal points", lambda old: old.replace(".", "..", 1) if "." in old else None)
number_kind("a number too few", lambda old: " ".join(old.split()[:-1]) if len(old.split()) > 1 else None)
number_kind("a number too many", lambda old: old + " 0" if len(old.split()) > 1 else None)
number_kind("sign twice", lambda old: "-" + old if old.startswith("-") else None)
number_kind("nothing", lambda old: " " if len(old.split()) == 1 else None)


# Names.

@kind("names", "parent misspelt")
def parent(text):
    return (Slip(joint, put(value, misspelt(value.text))) for joint in joints(text) if (value := ends(joint)[0]) and value.text != "world")


@kind("names", "child misspelt")
def child(text):
    return (Slip(joint, put(value, misspelt(value.text))) for joint in joints(text) if (value := ends(joint)[1]))


@kind("names", "link name misspelt")
def link_name(text):
    used = {value.text: joint for joint in joints(text) for value in ends(joint) if value}
    return (Slip(link, put(link.attribute("name"), misspelt(link.get("name"))), also=[used[link.get("name")]])
            for link in named(text, "link") if link.get("name") in used)


def twice(what):
    def slips(text):
        found = named(text, what)
        for one, other in zip(found[1:], found):
            if one.parent is other.parent and one.get("name") != other.get("name"):
                yield Slip(one, put(one.attribute("name"), other.get("name")), also=[other])
    return slips


kind("names", "link name twice")(twice("link"))
kind("names", "joint name twice")(twice("joint"))


@kind("names", "name in another case")
def case(text):
    return (Slip(joint, put(value, value.text.swapcase())) for joint in joints(text) if (value := ends(joint)[1]))


@kind("names", "blank behind a name")
def blank(text):
    return (Slip(joint, (value.end, value.end, b" ")) for joint in joints(text) if text.is_urdf and (value := ends(joint)[0]))


@kind("names", "name empty")
def empty(text):
    return (Slip(one, put(one.attribute("name"), "")) for one in named(text, "link", "joint"))


@kind("names", "two parents")
def two_parents(text):
    found = joints(text)
    for one, other in zip(found[1:], found):
        a, b = ends(one)[1], ends(other)[1]
        if a and b and a.text != b.text:
            yield Slip(one, put(a, b.text), also=[other] + [link for link in text.all("link") if link.get("name") in (a.text, b.text)])


# Files.

def files(text):
    for mesh in text.all("mesh"):
        value = mesh.attribute("filename") or mesh.value("uri")
        if value:
            yield mesh, value


def file_kind(name, change):
    kind("formats", name)(lambda text: (Slip(one, put(value, new)) for one, value in files(text) if (new := change(value.text)) and new != value.text))


file_kind("mesh file misspelt", lambda old: old.rsplit("/", 1)[0] + "/" + misspelt(old.rsplit("/", 1)[-1].rsplit(".", 1)[0]) + "." + old.rsplit(".", 1)[-1]
          if "/" in old else None)
file_kind("mesh of another format", lambda old: re.sub(r"\.(\w+)$", ".step", old))
file_kind("package misspelt", lambda old: re.sub(r"^(package|model)://(\w+)", lambda m: m.group(1) + "://" + misspelt(m.group(2)), old))
file_kind("scheme misspelt", lambda old: old.replace("package://", "pakage://").replace("model://", "modle://"))
file_kind("backslashes", lambda old: re.sub(r"(?<![/:])/(?!/)", r"\\", old))
file_kind("path of one's own machine", lambda old: "file:///home/me/ws/src/" + old.rsplit("//", 1)[-1])


@kind("formats", "version of SDF that does not exist")
def version(text):
    return (Slip(one, put(one.attribute("version"), "2.5")) for one in text.all("sdf") if one.attribute("version"))


# Mimics.

def mimics(text):
    return [mimic for mimic in text.all("mimic") if mimic.attribute("joint")]


@kind("mimic", "joint misspelt")
def mimic_joint(text):
    return (Slip(one, put(one.attribute("joint"), misspelt(one.get("joint")))) for one in mimics(text))


@kind("mimic", "mimics itself")
def mimic_self(text):
    return (Slip(one, put(one.attribute("joint"), one.within("joint").get("name"))) for one in mimics(text) if one.within("joint"))


@kind("mimic", "multiplier zero")
def mimic_zero(text):
    return (Slip(one, put(one.attribute("multiplier"), "0")) for one in mimics(text) if one.attribute("multiplier"))


@kind("mimic", "multiplier times ten")
def mimic_ten(text):
    return (Slip(one, put(value, str(float(value.text) * 10))) for one in mimics(text) if (value := one.attribute("multiplier")))


@kind("mimic", "fixed joint")
def mimic_fixed(text):
    fixed = next((joint.get("name") for joint in joints(text) if joint.get("type") == "fixed"), None)
    return (Slip(one, put(one.attribute("joint"), fixed)) for one in mimics(text) if fixed)


# Materials.

@kind("materials", "material misspelt")
def material(text):
    for one in named(text, "material"):
        if text.is_urdf and one.within("visual") and not one.children and one.get("name"):
            yield Slip(one, put(one.attribute("name"), misspelt(one.get("name"))))


def colors(text):
    for one in text.all("color"):
        if (value := one.attribute("rgba")) and len(value.text.split()) == 4:
            yield one, value


@kind("materials", "color of 0 to 255")
def color_bytes(text):
    for one, value in colors(text):
        words = [str(round(float(word) * 255)) for word in value.text.split()[:3]]
        if any(float(word) > 1 for word in words):
            yield Slip(one, put(value, " ".join(words + ["1"])))


@kind("materials", "color of three numbers")
def color_three(text):
    return (Slip(one, put(value, " ".join(value.text.split()[:3]))) for one, value in colors(text))


@kind("materials", "color invisible")
def color_invisible(text):
    return (Slip(one, put(value, " ".join(value.text.split()[:3] + ["0"]))) for one, value in colors(text) if value.text.split()[3] != "0")


# Nothing is wrong with these.

@kind("harmless", "comment")
def comment(text):
    return (Slip(one, (one.begin, one.begin, b"<!-- as measured -->")) for one in text.all("link", "joint"))


@kind("harmless", "blanks and line breaks")
def blanks(text):
    return (Slip(one, (one.begin, one.begin, b"\n  \n\t")) for one in text.all("link", "joint", "visual"))


@kind("harmless", "blank before the end of a tag")
def tag_blank(text):
    for one in text.all("origin", "axis", "mass", "link", "joint", "mesh"):
        at = one.tag_end - (2 if text.data[one.tag_end - 2:one.tag_end] == b"/>" else 1)
        yield Slip(one, (at, at, b"  "))


@kind("harmless", "order of attributes")
def order(text):
    for one in text.all("origin", "joint", "limit"):
        pairs = [(name, value) for name, value in one.attributes.items()]
        if len(pairs) > 1:
            begin, end = pairs[0][1].begin - 2 - len(pairs[0][0]), pairs[-1][1].end + 1
            written = b" ".join(f'{name}="{value.text}"'.encode("latin-1") for name, value in reversed(pairs))
            if text.data[begin:begin + len(pairs[0][0])] == pairs[0][0].encode() and b"&" not in written:
                yield Slip(one, (begin, end, written))


@kind("harmless", "other quotes")
def quotes(text):
    for one in text.all("link", "joint"):
        edits = []
        for value in one.attributes.values():
            if "'" not in value.text and '"' not in value.text:
                mark = b"'" if text.data[value.begin - 1:value.begin] == b'"' else b'"'
                edits += [(value.begin - 1, value.begin, mark), (value.end, value.end + 1, mark)]
        if edits:
            yield Slip(one, *edits)


@kind("harmless", "zeros behind a number")
def zeros(text):
    for one, value in numbers(text):
        if all(re.fullmatch(r"-?\d+\.\d+", word) for word in value.text.split()):
            yield Slip(one, put(value, " ".join(word + "0" for word in value.text.split())))


@kind("harmless", "1.0 as 1")
def shorter(text):
    for one, value in numbers(text):
        new = " ".join(re.sub(r"\.0+$", "", word) for word in value.text.split())
        if new != value.text:
            yield Slip(one, put(value, new))


@kind("harmless", "number with an exponent")
def exponent(text):
    for one, value in numbers(text):
        if all(re.fullmatch(r"-?\d+\.\d+", word) for word in value.text.split()):
            yield Slip(one, put(value, " ".join(f"{float(word):.15e}" for word in value.text.split())))


@kind("harmless", "lines that end with CR LF")
def carriage(text):
    if b"\r" not in text.data and text.root is not None:
        yield Slip(text.root, *((m.start(), m.start(), b"\r") for m in re.finditer(b"\n", text.data)))


@kind("harmless", "rename throughout")
def rename(text):
    for one in named(text, "joint"):
        name = one.get("name").encode("latin-1")
        if len(name) > 6 and re.fullmatch(rb"\w+", name):
            found = list(re.finditer(rb"(?<![\w:/.\-])" + name + rb"(?![\w:/.\-])", text.data))
            if b"::" + name not in text.data:
                yield Slip(one, *((m.start(), m.end(), name + b"_x") for m in found))


@kind("harmless", "a lamp more")
def lamp(text):
    for one in text.all("world"):
        light = (b'<light name="reading_lamp" type="point"><pose>1 2 4 0 0 0</pose><diffuse>0.8 0.8 0.8 1</diffuse>'
                 b"<attenuation><range>10</range></attenuation></light>")
        yield Slip(one, (one.inner_end, one.inner_end, light))


@kind("harmless", "another color")
def color(text):
    for one, value in colors(text):
        yield Slip(one, put(value, "0.3 0.4 0.5 1"))
    for one in text.all("diffuse"):
        if one.value() and one.within("material"):
            yield Slip(one, put(one.value(), "0.3 0.4 0.5 1"))


@kind("harmless", "mass a hundredth more")
def mass(text):
    for link in text.all("link"):
        if (value := mass_value(link)) and value.numbers() and value.numbers()[0] > 0:
            yield Slip(link, put(value, f"{value.numbers()[0] * 1.01:.9g}"))


@kind("harmless", "a limit a little smaller")
def limit(text):
    for joint in joints(text):
        if (value := limit_value(joint, "upper")) and value.numbers() and 0.2 < value.numbers()[0] < 4 \
                and not {"mimic", "safety_controller"} & {child.name for child in joint.children}:
            yield Slip(joint, put(value, f"{value.numbers()[0] * 0.99:.6g}"))
