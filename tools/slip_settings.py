# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Kinds of slips in what is around a robot: contacts and physics, plugins, sensors, transmissions, worlds."""

import re

from slip_kinds import Slip, drop, finite, joints, kind, misspelt, number, put, scaled


def settings(text, *names):
    """(element, value) of each element of one of these names that holds a text."""
    for element in text.all(*names):
        value = element.value()
        if value:
            yield element, value


def set_kind(family, name, elements, new, where=lambda element: True):
    """`new` is the text, or a function of the old one; nothing when it does not fit."""
    def slips(text):
        for element, value in settings(text, *elements):
            changed = new(value.text) if callable(new) else new
            if changed is not None and changed != value.text and where(element):
                yield Slip(element, put(value, changed))
    kind(family, name)(slips)


def times(factor):
    def new(old):
        try:
            return number(float(old) * factor) if float(old) != 0 else None
        except ValueError:
            return None
    return new


def inside(*names):
    return lambda element: element.within(*names) is not None


CONTACT = inside("collision", "gazebo")


def is_grip(element):
    """Whether the friction is of a wheel or foot: elsewhere 0 is a choice."""
    about = element.within("link", "gazebo")
    name = (about.get("name") or about.get("reference")).lower() if about else ""
    return any(word in name for word in ("wheel", "foot", "shank", "tire"))


set_kind("contact", "friction zero", ("mu", "mu1"), "0", lambda e: CONTACT(e) and is_grip(e))
set_kind("contact", "friction negative", ("mu", "mu1"), "-1", CONTACT)
set_kind("contact", "contact stiffness too low", ("kp",), "10", CONTACT)
set_kind("contact", "contact stiffness zero", ("kp",), "0", CONTACT)
set_kind("contact", "contact stiffness negative", ("kp",), "-1e6", CONTACT)
set_kind("contact", "contact depth of a meter", ("min_depth", "minDepth"), "1", CONTACT)
set_kind("contact", "spring too stiff for the step", ("spring_stiffness",), "1e9", inside("joint"))
set_kind("contact", "spring stiffness negative", ("spring_stiffness",), lambda old: "-" + old if float(old) > 0 else None, inside("joint"))
set_kind("contact", "step of a second", ("max_step_size",), "1")
set_kind("contact", "step of zero", ("max_step_size",), "0")
set_kind("contact", "step times a hundred", ("max_step_size",), times(100))
set_kind("contact", "real-time factor zero", ("real_time_factor",), "0", inside("physics"))
set_kind("contact", "real-time factor negative", ("real_time_factor",), "-1", inside("physics"))
set_kind("contact", "gravity upward", ("gravity",), "0 0 9.8", lambda e: e.parent.name == "world")
set_kind("contact", "gravity along x", ("gravity",), "-9.8 0 0", lambda e: e.parent.name == "world")
set_kind("contact", "gravity ten times", ("gravity",), "0 0 -98", lambda e: e.parent.name == "world")
set_kind("contact", "bounce above one", ("restitution_coefficient",), "5")


@kind("contact", "engine misspelt")
def engine(text):
    return (Slip(e, put(e.attribute("type"), misspelt(e.get("type")))) for e in text.all("physics") if e.attribute("type"))


def standing(text):
    """Models of a world that have a pose of their own, stand on the ground and move."""
    for model in text.all("model"):
        value = model.value("pose")
        static = model.value("static")
        wheels = [j for j in joints(text) if j.within("model") is model]
        if model.parent.name == "world" and value and len(value.numbers()) == 6 and not (static and static.text in ("1", "true")):
            if wheels and not 0 in [len(model.kids("link"))] and not any(j.value("parent") and j.value("parent").text == "world" for j in wheels):
                yield model, value


def raised(by):
    def slips(text):
        for model, value in standing(text):
            words = value.text.split()
            words[2] = number(float(words[2]) + by)
            yield Slip(model, put(value, " ".join(words)))
    return slips


kind("contact", "model starts under the ground")(raised(-0.3))
kind("contact", "model starts above the ground")(raised(5))


# Plugins.

SEPARATION = ("wheel_separation", "wheelSeparation", "tracks_separation", "wheelbase", "wheel_base")
RADIUS = ("wheel_radius", "wheelRadius", "wheelDiameter", "wheel_diameter")
LEFT = ("left_joint", "leftJoint", "front_left_joint", "left_front")
RIGHT = ("right_joint", "rightJoint", "front_right_joint", "right_front")

for name, by in (("halved", 0.5), ("doubled", 2), ("in mm", 1000)):
    set_kind("plugin", f"wheel separation {name}", SEPARATION[:3], times(by))
    set_kind("plugin", f"wheel radius {name}", RADIUS, times(by))


def plugins(text):
    return [plugin for plugin in text.all("plugin") if plugin.attribute("filename")]


def texts_of(plugin, names):
    return [value for child in plugin.children if child.name in names and (value := child.value())]


@kind("plugin", "sides exchanged")
def sides(text):
    for plugin in plugins(text):
        left, right = texts_of(plugin, LEFT), texts_of(plugin, RIGHT)
        if left and len(left) == len(right):
            yield Slip(plugin, *(put(a, b.text) for a, b in zip(left, right)), *(put(b, a.text) for a, b in zip(left, right)))


@kind("plugin", "joint that is no wheel")
def no_wheel(text):
    for plugin in plugins(text):
        used = {value.text for child in plugin.children if (value := child.value())}
        model = plugin.within("model", "robot")
        for value in texts_of(plugin, LEFT):
            other = next((j for j in joints(text) if j.within("model", "robot") is model and j.get("name") not in used), None)
            if other is not None:
                yield Slip(plugin, put(value, other.get("name")))


@kind("plugin", "same joint on both sides")
def both_sides(text):
    for plugin in plugins(text):
        left, right = texts_of(plugin, LEFT), texts_of(plugin, RIGHT)
        if left and right:
            yield Slip(plugin, put(left[0], right[0].text))


def in_plugin(*words):
    def slips(text):
        for plugin in plugins(text):
            for child in plugin.walk():
                value = child.value()
                if child is not plugin and value and any(word in child.name.lower() for word in words):
                    if re.fullmatch(r"[A-Za-z]\w{4,}", value.text) and known(text, value.text):
                        yield Slip(child, put(value, misspelt(value.text)))
    return slips


def known(text, name):
    return any(element.get("name") == name for element in text.all("link", "joint", "sensor", "collision"))


kind("plugin", "joint misspelt")(in_plugin("joint"))
kind("plugin", "link or frame misspelt")(in_plugin("link", "frame", "body"))
kind("plugin", "collision misspelt")(in_plugin("collision", "contact"))


@kind("plugin", "parameter misspelt")
def parameter(text):
    for plugin in plugins(text):
        if re.search(r"diff.drive|joint-state|ackermann|mecanum|motor-model|odometry|thruster", plugin.get("filename")):
            for child in plugin.children:
                at, name = child.begin + 1, child.name
                if "_" in name and child.inner_end > child.tag_end:
                    wrong = misspelt(name).encode()
                    yield Slip(plugin, (at, at + len(name), wrong), (child.inner_end + 2, child.inner_end + 2 + len(name), wrong))


@kind("plugin", "library misspelt")
def library(text):
    for plugin in plugins(text):
        file = plugin.attribute("filename")
        if re.match(r"(lib)?(gz-sim|ignition-gazebo|gazebo_ros_)", file.text):
            yield Slip(plugin, put(file, misspelt(file.text.removesuffix("-system").removesuffix(".so")) + (
                "-system" if file.text.endswith("-system") else ".so" if file.text.endswith(".so") else "")))


@kind("plugin", "class misspelt")
def class_name(text):
    for plugin in plugins(text):
        name = plugin.attribute("name")
        if name and "::systems::" in name.text:
            yield Slip(plugin, put(name, misspelt(name.text)))


@kind("plugin", "library left out")
def no_library(text):
    return (Slip(plugin, put(plugin.attribute("filename"), "")) for plugin in plugins(text))


OTHER = [("gz-sim-diff-drive-system", "libgazebo_ros_diff_drive.so"), ("ignition-gazebo-diff-drive-system", "libgazebo_ros_diff_drive.so"),
         ("gz-sim-joint-state-publisher-system", "libgazebo_ros_joint_state_publisher.so"), ("gz-sim-imu-system", "libgazebo_ros_imu_sensor.so"),
         ("gz-sim-odometry-publisher-system", "libgazebo_ros_p3d.so"), ("gz-sim-contact-system", "libgazebo_ros_bumper.so"),
         ("gz-sim-thruster-system", "libgazebo_ros_force.so")]


@kind("plugin", "library of classic in a world of Gazebo Sim")
def of_classic(text):
    for plugin in plugins(text):
        for new, old in OTHER:
            if plugin.get("filename") == new:
                yield Slip(plugin, put(plugin.attribute("filename"), old))


@kind("plugin", "library of Gazebo Sim in a world of classic")
def of_new(text):
    others = [plugin.get("filename") for plugin in plugins(text)]
    for plugin in plugins(text):
        for new, old in OTHER + [("gz-sim-diff-drive-system", "libDiffDrivePlugin.so"), ("gz-sim-imu-system", "libgazebo_ros_imu.so"),
                                 ("gz-sim-lift-drag-system", "libLiftDragPlugin.so"), ("gz-sim-contact-system", "libgazebo_ros_bumper.so")]:
            if plugin.get("filename") == old and len(others) > 1:
                yield Slip(plugin, put(plugin.attribute("filename"), new))


@kind("plugin", "topic of another plugin or sensor")
def topic(text):
    for own in [plugins(text), text.all("sensor")]:
        found = [(child, value) for one in own for child in one.children
                 if child.name in ("topic", "odom_topic", "commandSubTopic") and (value := child.value())]
        for i, (child, value) in enumerate(found):
            for other, also in found[:i]:
                if other.name == child.name and also.text != value.text and other.parent.get("type") == child.parent.get("type") \
                        and other.within("model") is child.within("model"):
                    yield Slip(child, put(value, also.text), also=[other.parent])
                    break


@kind("plugin", "plugin twice")
def twice(text):
    for plugin in plugins(text):
        if plugin.parent.name == "model" and re.search(r"diff.drive|joint-state|mecanum|ackermann", plugin.get("filename")):
            yield Slip(plugin, (plugin.end, plugin.end, b"\n" + plugin.bytes()))


@kind("plugin", "system of a world left out")
def no_system(text):
    carried = {sensor.get("type") for sensor in text.all("sensor")}
    needs = {"sensors": {"camera", "gpu_lidar", "depth_camera", "rgbd_camera", "gpu_ray"}, "imu": {"imu"}, "contact": {"contact"},
             "altimeter": {"altimeter"}, "magnetometer": {"magnetometer"}, "forcetorque": {"force_torque"},
             "air-pressure": {"air_pressure"}, "navsat": {"navsat"}, "logical-camera": {"logical_camera"}}
    for plugin in plugins(text):
        match = re.fullmatch(r"(?:gz-sim|ignition-gazebo)-([a-z-]+)-system", plugin.get("filename"))
        if match and plugin.parent.name == "world":
            system = match.group(1)
            if needs.get(system, set()) & carried:
                yield Slip(plugin.parent, drop(plugin), also=[s for s in text.all("sensor") if s.get("type") in needs[system]])
            elif system == "physics":
                yield Slip(plugin.parent, drop(plugin), also=text.all("world"))


# Sensors.

set_kind("sensor", "image format misspelt", ("format",), lambda old: {"R8G8B8": "RGB8888", "L8": "L88", "RGB_INT8": "RGB_8"}.get(old), inside("camera"))
set_kind("sensor", "image width zero", ("width",), "0", inside("camera"))
set_kind("sensor", "image width ten times", ("width",), times(10), inside("camera"))
set_kind("sensor", "field of view in degrees", ("horizontal_fov",), "60", inside("camera"))
set_kind("sensor", "near behind far", ("near",), "500", inside("camera"))
set_kind("sensor", "noise type misspelt", ("type",), "gausian", inside("noise"))
set_kind("sensor", "noise a thousand times", ("stddev",), times(1000), inside("noise"))
set_kind("sensor", "noise negative", ("stddev",), "-0.01", inside("noise"))
set_kind("sensor", "update rate zero", ("update_rate",), "0", inside("sensor"))
set_kind("sensor", "update rate negative", ("update_rate",), "-10", inside("sensor"))
set_kind("sensor", "update rate a thousand times", ("update_rate",), times(1000), inside("sensor"))
set_kind("sensor", "lidar angle in degrees", ("max_angle",), "180", inside("scan"))
set_kind("sensor", "lidar samples zero", ("samples",), "0", inside("horizontal"))
set_kind("sensor", "lidar range in mm", ("max",), times(1000), lambda e: e.parent.name == "range")
set_kind("sensor", "lidar range inverted", ("max",), "0.01", lambda e: e.parent.name == "range")


def sensor_kind(name, change):
    def slips(text):
        for sensor in text.all("sensor"):
            kinds = [child.name for child in sensor.children]
            if sensor.attribute("type") and (new := change(sensor.get("type"), kinds)):
                yield Slip(sensor, put(sensor.attribute("type"), new))
    kind("sensor", name)(slips)


sensor_kind("block of another type", lambda old, kids: "imu" if {"ray", "lidar", "camera"} & set(kids) else "camera" if "imu" in kids else None)
sensor_kind("type misspelt", lambda old, _: misspelt(old) if len(old) > 3 else None)


@kind("sensor", "sensor name twice")
def sensor_twice(text):
    for sensor in text.all("sensor"):
        if sensor.parent.name == "link":
            yield Slip(sensor, (sensor.end, sensor.end, b"\n" + sensor.bytes()))


@kind("sensor", "collision of a contact sensor misspelt")
def contact_collision(text):
    for sensor in text.all("sensor"):
        value = sensor.value("contact", "collision")
        if value and sensor.get("type") == "contact" and known(text, value.text):
            yield Slip(sensor, put(value, misspelt(value.text)))


# Transmissions and <gazebo> blocks.

def transmissions(text):
    return [one for one in text.all("transmission") if one.child("joint")]


@kind("plugin", "transmission without actuator")
def no_actuator(text):
    return (Slip(one, drop(one.child("actuator"))) for one in transmissions(text) if one.child("actuator"))


@kind("plugin", "transmission type misspelt")
def transmission_type(text):
    return (Slip(one, put(value, misspelt(value.text))) for one in transmissions(text) if (value := one.value("type")))


@kind("plugin", "hardware interface misspelt")
def interface(text):
    return (Slip(one, put(value, misspelt(value.text))) for one in transmissions(text)
            if (value := one.value("joint", "hardwareInterface")))


@kind("plugin", "joint of a transmission misspelt")
def transmission_joint(text):
    for one in transmissions(text):
        name = one.child("joint").attribute("name")
        if name:
            yield Slip(one, put(name, misspelt(name.text)))


@kind("plugin", "reference of <gazebo> misspelt")
def reference(text):
    return (Slip(one, put(value, misspelt(value.text))) for one in text.all("gazebo")
            if (value := one.attribute("reference")) and known(text, value.text))


set_kind("plugin", "Gazebo material misspelt", ("material", "name"), lambda old: misspelt(old) if old.startswith("Gazebo/") else None)


# Worlds.

def has_direction(element):
    """Point lights read none."""
    return element.parent.name == "light" and element.parent.get("type") in ("directional", "spot")


@kind("world", "model twice in one place")
def model_twice(text):
    for one in text.all("include", "model"):
        if one.parent.name == "world" and not (one.value("static") and one.value("static").text in ("1", "true")):
            name = one.value("name") if one.name == "include" else one.attribute("name")
            copy = one.bytes()
            if name:
                at, end = name.begin - one.begin, name.end - one.begin
                copy = copy[:at] + name.text.encode("latin-1") + b"_2" + copy[end:]
                yield Slip(one, (one.end, one.end, b"\n" + copy))


set_kind("world", "light shines up", ("direction",), lambda old: " ".join(old.split()[:2] + [old.split()[2].lstrip("-")])
         if len(old.split()) == 3 and old.split()[2].startswith("-") else None, lambda e: has_direction(e) and e.parent.get("type") == "directional")
set_kind("world", "light has no direction", ("direction",), "0 0 0", has_direction)


@kind("world", "light type misspelt")
def light_type(text):
    return (Slip(one, put(one.attribute("type"), misspelt(one.get("type")))) for one in text.all("light") if one.attribute("type"))


def uris(text):
    return [(one, value) for one in text.all("include") if (value := one.value("uri"))]


@kind("world", "include without scheme")
def no_scheme(text):
    return (Slip(one, put(value, value.text.removeprefix("model://"))) for one, value in uris(text) if value.text.startswith("model://"))


@kind("world", "included model misspelt")
def include_misspelt(text):
    return (Slip(one, put(value, misspelt(value.text))) for one, value in uris(text) if value.text.startswith("model://"))


@kind("world", "include without uri")
def no_uri(text):
    return (Slip(one, drop(one.child("uri"))) for one, _ in uris(text))


@kind("world", "gravity inside physics")
def gravity_inside(text):
    for physics in text.all("physics"):
        gravity = physics.parent.child("gravity")
        if gravity and not physics.child("gravity") and physics.inner_end > physics.tag_end:
            yield Slip(physics, drop(gravity), (physics.inner_end, physics.inner_end, gravity.bytes()), also=[gravity])
        elif physics.parent.name == "world" and not gravity and physics.inner_end > physics.tag_end and not physics.child("gravity"):
            yield Slip(physics, (physics.inner_end, physics.inner_end, b"<gravity>0 0 -9.8</gravity>"))


@kind("world", "model pose in degrees")
def pose_degrees(text):
    for one in text.all("model", "include"):
        value = one.value("pose")
        if value and one.parent.name == "world" and len(value.numbers()) == 6 and abs(value.numbers()[5]) > 0.3:
            words = value.text.split()
            yield Slip(one, put(value, " ".join(words[:5] + [number(round(float(words[5]) * 57.29578))])))


@kind("world", "pose of five numbers")
def short_pose(text):
    return (Slip(one, put(value, " ".join(value.text.split()[:5]))) for one in text.all("model", "include", "link", "light")
            if (value := one.value("pose")) and len(value.numbers()) == 6)


@kind("world", "joint to a missing model")
def missing_model(text):
    for joint in joints(text):
        value = joint.value("child")
        if value and not text.is_urdf and finite(None) is False:
            yield Slip(joint, put(value, "chassis::" + value.text))


set_kind("world", "static misspelt", ("static",), lambda old: {"true": "ture", "1": "yes"}.get(old),
         lambda e: e.parent.name in ("model", "include"))
set_kind("world", "latitude beyond the pole", ("latitude_deg",), "137.4")
set_kind("world", "colors of 0 to 255", ("diffuse", "ambient"), lambda old: " ".join(
    [number(round(float(w) * 255)) for w in old.split()[:3]] + old.split()[3:]) if any(0 < float(w) <= 1 for w in old.split()[:3]) else None,
    lambda e: e.parent.name in ("material", "light"))
