// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/mjcf/element.h>

#include <cmath>

#include <fmt/core.h>

#include <rigor/convert/xml_writer.h>

namespace rigor::convert {
namespace {

/// A quaternion of two right angles has parts of 6e-17 that mean 0: a hundredth of the last digit of 1.
constexpr double kQuaternionNoise = 1.5e-16;

void write_element(XmlWriter& out, const MjcfElement& element) {
  for (const std::string& comment : element.comments) out.comment(comment);
  XmlAttributes attributes;
  for (const auto& [name, value] : element.attributes) attributes.push_back({name, value});
  if (element.children.empty()) return out.empty(element.name, attributes);
  out.open(element.name, attributes);
  for (const MjcfElement& child : element.children) write_element(out, child);
  out.close();
}

}  // namespace

std::string mjcf_text(const MjcfElement& root) {
  XmlWriter out;
  for (const std::string& comment : root.comments) out.comment(comment);
  XmlAttributes attributes;
  for (const auto& [name, value] : root.attributes) attributes.push_back({name, value});
  out.open(root.name, attributes);
  for (std::size_t i = 0; i < root.children.size(); ++i) {
    if (i > 0) out.blank_line();
    write_element(out, root.children[i]);
  }
  out.close();
  return std::move(out).take();
}

std::string mjcf_number(double value) { return value == 0 ? "0" : fmt::format("{}", value); }

std::string mjcf_numbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += ' ';
    text += mjcf_number(value);
  }
  return text;
}

std::string mjcf_quaternion(const model::Quaternion& q) {
  const double sign = q.w < 0 ? -1 : 1;
  const auto part = [sign](double value) {
    return std::abs(value) < kQuaternionNoise ? 0 : sign * value;
  };
  return mjcf_numbers({part(q.w), part(q.x), part(q.y), part(q.z)});
}

void set_placement(MjcfElement& element, std::string pos, const model::Quaternion& rotation) {
  if (pos != "0 0 0") element.set("pos", std::move(pos));
  std::string quat = mjcf_quaternion(rotation);
  if (quat != "1 0 0 0") element.set("quat", std::move(quat));
}

void set_placement(MjcfElement& element, const model::Pose& X) {
  const model::Vector3& p = X.translation;
  set_placement(element, mjcf_numbers({p.x, p.y, p.z}), X.rotation);
}

}  // namespace rigor::convert
