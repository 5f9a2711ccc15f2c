# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""The elements of an XML file by their bytes, for edits that leave all other bytes as they are.

    robot = Text(data)
    for joint in robot.all("joint"):
        value = joint.child("origin").attribute("xyz")   # begin, end, text
"""

import re

TOKEN = re.compile(rb"<!--.*?-->|<!\[CDATA\[.*?\]\]>|<\?.*?\?>|<!DOCTYPE[^>]*>|"
                   rb"</\s*([\w:.\-]+)\s*>|<([\w:.\-]+)((?:\s+[\w:.\-]+\s*=\s*(?:\"[^\"]*\"|'[^']*'))*)\s*(/?)>", re.S)
ATTRIBUTE = re.compile(rb"([\w:.\-]+)\s*=\s*(\"[^\"]*\"|'[^']*')")


class Value:
    """Bytes between two offsets: of an attribute, or the text of an element."""

    def __init__(self, begin, end, text):
        self.begin, self.end, self.text = begin, end, text

    def numbers(self):
        try:
            return [float(word) for word in self.text.split()]
        except ValueError:
            return []


class Element:
    def __init__(self, name, begin, parent):
        self.name, self.begin, self.parent = name, begin, parent
        self.tag_end = self.inner_end = self.end = begin
        self.attributes, self.children, self.data = {}, [], b""

    def attribute(self, name):
        return self.attributes.get(name)

    def get(self, name):
        """The text of an attribute, empty when there is none."""
        value = self.attributes.get(name)
        return value.text if value else ""

    def child(self, *names):
        """The first child of that name, then its first child of the next; none is falsy."""
        found = self
        for name in names:
            found = next((child for child in found.children if child.name == name), None)
            if found is None:
                return None
        return found

    def kids(self, name):
        return [child for child in self.children if child.name == name]

    def value(self, *names):
        """The text within a child of these names, without the blanks around it."""
        found = self.child(*names) if names else self
        if found is None or found.children or found.inner_end == found.tag_end:
            return None
        raw = found.data[found.tag_end:found.inner_end]
        text = raw.strip()
        if not text or b"<" in text:
            return None
        begin = found.tag_end + raw.index(text)
        return Value(begin, begin + len(text), text.decode("latin-1"))

    def within(self, *names):
        """Itself or the nearest element around it that has one of these names."""
        found = self
        while found is not None and found.name not in names:
            found = found.parent
        return found

    def walk(self):
        yield self
        for child in self.children:
            yield from child.walk()

    def bytes(self):
        return self.data[self.begin:self.end]


class Text:
    def __init__(self, data):
        self.data = data
        self.root = None
        self.elements = []
        open_element = None
        for token in TOKEN.finditer(data):
            if token.group(2):
                open_element = self.opened(token, open_element)
            elif token.group(1) and open_element is not None:
                open_element.inner_end, open_element.end = token.start(), token.end()
                open_element = open_element.parent

    def opened(self, token, parent):
        """The element whose start tag this is; its parent when it ends here."""
        element = Element(token.group(2).decode("latin-1"), token.start(), parent)
        element.data = self.data
        element.tag_end = element.inner_end = element.end = token.end()
        for found in ATTRIBUTE.finditer(self.data, token.start(3), token.end(3)):
            begin, end = found.start(2) + 1, found.end(2) - 1
            element.attributes[found.group(1).decode("latin-1")] = Value(begin, end, self.data[begin:end].decode("latin-1"))
        if parent is not None:
            parent.children.append(element)
        elif self.root is None:
            self.root = element
        self.elements.append(element)
        return parent if token.group(4) else element

    def all(self, *names):
        return [element for element in self.elements if element.name in names]

    @property
    def is_urdf(self):
        return self.root is not None and self.root.name == "robot"

    def line(self, offset):
        """1-based."""
        return self.data.count(b"\n", 0, offset) + 1
