// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/simplify/primitive_element.h>

#include <variant>

#include <fmt/core.h>

#include <rigor/write/numbers.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

double six_digits(double value) {
  return write::number_in(fmt::format("{:.6g}", value)).value_or(value);
}

}  // namespace

mesh::Primitive readable_primitive(mesh::Primitive primitive) {
  struct Rounder {
    void operator()(mesh::Box& s) const {
      s.size = {six_digits(s.size.x), six_digits(s.size.y), six_digits(s.size.z)};
    }
    void operator()(mesh::Sphere& s) const { s.radius = six_digits(s.radius); }
    void operator()(mesh::Cylinder& s) const {
      s.radius = six_digits(s.radius);
      s.length = six_digits(s.length);
    }
    void operator()(mesh::Capsule& s) const {
      s.radius = six_digits(s.radius);
      s.length = six_digits(s.length);
    }
  };
  std::visit(Rounder{}, primitive);
  return primitive;
}

robot::Shape primitive_shape(const mesh::Primitive& primitive) {
  struct Numbers {
    robot::Shape operator()(const mesh::Box& s) const {
      return {"box", {s.size.x, s.size.y, s.size.z}};
    }
    robot::Shape operator()(const mesh::Sphere& s) const { return {"sphere", {s.radius}}; }
    robot::Shape operator()(const mesh::Cylinder& s) const {
      return {"cylinder", {s.radius, s.length}};
    }
    robot::Shape operator()(const mesh::Capsule& s) const {
      return {"capsule", {s.radius, s.length}};
    }
  };
  return std::visit(Numbers{}, primitive);
}

std::string primitive_element(const mesh::Primitive& primitive, GeometryForm form) {
  const robot::Shape of = primitive_shape(primitive);
  const bool urdf = form == GeometryForm::kUrdf;
  if (of.kind == "box") {
    const std::string size = write::joined(of.numbers);
    return urdf ? "<box size=\"" + size + "\"/>" : "<box>\n  <size>" + size + "</size>\n</box>";
  }
  std::string text = urdf ? '<' + of.kind : '<' + of.kind + ">\n";
  const auto add = [&](const char* name, double value) {
    text += urdf ? fmt::format(" {}=\"{}\"", name, write::joined({value}))
                 : fmt::format("  <{0}>{1}</{0}>\n", name, write::joined({value}));
  };
  add("radius", of.numbers[0]);
  if (of.numbers.size() > 1) add("length", of.numbers[1]);
  return text + (urdf ? "/>" : "</" + of.kind + '>');
}

std::string mesh_element(const std::string& uri, const model::Vector3& scale, GeometryForm form) {
  const std::string factors = write::joined({scale.x, scale.y, scale.z});
  const bool scaled = scale != model::Vector3{1, 1, 1};
  if (form == GeometryForm::kUrdf) {
    return "<mesh filename=\"" + xml::escaped(uri) + '"' +
           (scaled ? " scale=\"" + factors + '"' : "") + "/>";
  }
  return "<mesh>\n  <uri>" + xml::escaped(uri) + "</uri>\n" +
         (scaled ? "  <scale>" + factors + "</scale>\n" : "") + "</mesh>";
}

}  // namespace rigor::author
