// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Default classes: an attribute that an element does not have comes from its class, or from the class around
// that one.
//
//   MjcfDefaults defaults(tree, facts);
//   MjcfValues joint = defaults.values(element, "joint", class_id);
//   joint.number("damping", 0);

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/model/field.h>
#include <rigor/model/pose.h>
#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/read/mjcf/mjcf_tree.h>
#include <rigor/read/values.h>

namespace rigor::read {

/// The attributes of an element, its own before those of its class.
class MjcfValues {
 public:
  MjcfValues(xml::Element own, std::vector<xml::Element> defaults)
      : own_(own), defaults_(std::move(defaults)) {}

  xml::Element element() const { return own_; }
  std::optional<Text> text(std::string_view name) const;
  /// Only what the element itself has.
  std::optional<Text> own(std::string_view name) const { return attribute_text(own_, name); }
  model::Field<std::string> string(std::string_view name, std::string_view fallback = {}) const;
  /// The first number of the attribute.
  model::Field<double> number(std::string_view name, double fallback) const;
  /// Those that there are, the ones that the element does not give from its class; what cannot be read is none.
  std::vector<double> numbers(std::string_view name) const;
  model::Field<model::Vector3> vector(std::string_view name, model::Vector3 fallback) const;
  bool is_true(std::string_view name) const;

 private:
  xml::Element own_;
  std::vector<xml::Element> defaults_;  // of the innermost class first
};

class MjcfDefaults {
 public:
  static constexpr std::size_t kMain = 0;

  MjcfDefaults(const MjcfTree& tree, MjcfFacts& facts);

  std::optional<std::size_t> find(std::string_view name) const;
  std::vector<std::string> names() const;
  MjcfValues values(xml::Element element, std::string_view tag, std::size_t class_id) const;
  /// The same where several elements set one default, as all actuators do.
  MjcfValues values_of_any(xml::Element element, const std::vector<std::string_view>& tags,
                           std::size_t class_id) const;

 private:
  struct Class {
    std::string name;
    std::size_t parent;
    std::vector<xml::Element> elements;  // in their order
  };
  void add(std::string name, std::size_t parent);
  void read(const MjcfTree& tree, xml::Element element, std::size_t into, MjcfFacts& facts);

  std::vector<Class> classes_;
  std::map<std::string, std::size_t, std::less<>> index_;  // the first of each name
};

}  // namespace rigor::read
