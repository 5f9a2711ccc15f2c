// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Documents grown from the schema: a small robot, and in it any place that the schema knows, filled with
// a valid value that is not the default.
//
//   Plant robot = …;
//   for (const SchemaPlace& place : places_of(model_node)) {
//     Plant* leaf = grow(robot, node, place);   // with all that its parents must hold
//     leaf->text = value_of(place, 0);
//     const Grown text = write_plant(robot);    // and where the leaf stands in it
//   }

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/schema/schema.h>

namespace rigor::test {

/// An element in the making.
struct Plant {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes = {};
  std::string text = {};
  std::vector<Plant> children = {};
  // Where it came to stand in the text that was written last.
  std::size_t begin = 0, tag_end = 0, end = 0;

  std::string* attribute(std::string_view wanted) {
    for (auto& [key, value] : attributes) {
      if (key == wanted) return &value;
    }
    return nullptr;
  }
  Plant* child(std::string_view wanted) {
    for (Plant& plant : children) {
      if (plant.name == wanted) return &plant;
    }
    return nullptr;
  }
  Plant& must(std::string_view wanted) {
    Plant* found = child(wanted);
    return found != nullptr ? *found : children.emplace_back(Plant{std::string(wanted)});
  }
};

inline void write_plant(Plant& plant, std::string& out) {
  plant.begin = out.size();
  out += '<' + plant.name;
  for (const auto& [key, value] : plant.attributes) out += ' ' + key + "='" + value + '\'';
  out += '>';
  plant.tag_end = out.size();
  out += plant.text;
  for (Plant& child : plant.children) write_plant(child, out);
  out += "</" + plant.name + '>';
  plant.end = out.size();
}

inline std::string write_plant(Plant& plant) {
  std::string out;
  write_plant(plant, out);
  return out;
}

/// An element or attribute of the schema below some element.
struct SchemaPlace {
  std::vector<std::string> path;  ///< of the element
  std::string attribute;          ///< empty: the element itself
  schema::Node node;
  std::string name() const {
    std::string text;
    for (const std::string& step : path) text += (text.empty() ? "" : "/") + step;
    return attribute.empty() ? text : text + "/@" + attribute;
  }
};

/// Every place below an element, each block entered once on a way down; what `enter` refuses is passed
/// over with all that it holds. `open` places, whose content is nobody's business, have one child.
inline std::vector<SchemaPlace> places_of(
    schema::Node top, const std::function<bool(const std::vector<std::string>&)>& enter) {
  struct Step {
    schema::Node node;
    std::vector<std::string> path;
    std::set<std::uint32_t> above;
  };
  std::vector<SchemaPlace> places;
  std::vector<Step> todo{{top, {}, {top.declaration()}}};
  while (!todo.empty()) {
    const Step step = todo.back();
    todo.pop_back();
    for (const schema::Node attribute : step.node.attributes()) {
      places.push_back({step.path, std::string(attribute.name()), attribute});
    }
    for (const schema::Node child : step.node.children()) {
      Step next{child, step.path, step.above};
      next.path.emplace_back(child.name());
      if (!next.above.insert(child.declaration()).second || !enter(next.path)) continue;
      places.push_back({next.path, {}, child});
      todo.push_back(std::move(next));
    }
  }
  return places;
}

/// Values that are words: names of what the robot has, files, all that a type alone does not tell. By
/// the end of the place's name, the longest that fits; two values that mean different things.
using WordTable = std::map<std::string, std::pair<std::string, std::string>, std::less<>>;

inline bool ends_with_place(std::string_view name, std::string_view end) {
  return name.ends_with(end) &&
         (name.size() == end.size() || name[name.size() - end.size() - 1] == '/');
}

/// The first (0) or second (1) of two valid values, neither the default where the type has room;
/// nothing for a second one that there is not.
inline std::optional<std::string> value_of(const SchemaPlace& place, int which,
                                           const WordTable& words) {
  const std::string name = place.name();
  const std::pair<std::string, std::string>* found = nullptr;
  std::size_t longest = 0;
  for (const auto& [end, values] : words) {
    if (!ends_with_place(name, end) || end.size() < longest) continue;
    found = &values;
    longest = end.size();
  }
  if (found != nullptr) return which == 0 ? found->first : found->second;

  const schema::Node& node = place.node;
  const std::string fallback(node.default_value().value_or(""));
  // No two places have the same pose or color: equals may represent each other.
  std::size_t letters = 0;
  for (const char letter : name) letters += static_cast<unsigned char>(letter);
  const std::string own = "0.1" + std::to_string(letters);
  std::vector<std::string> choices;
  for (const std::string_view word : node.enumeration()) choices.emplace_back(word);
  const bool unit = node.maximum() && *node.maximum() == "1";
  switch (node.type()) {
    case schema::Type::kNone: break;
    case schema::Type::kString:
    case schema::Type::kChar:
      if (choices.empty()) choices = {"word", "other"};
      break;
    case schema::Type::kBool: choices = {"true", "false"}; break;
    case schema::Type::kInt:
    case schema::Type::kUint:
    case schema::Type::kUint64: choices = {"3", "7"}; break;
    case schema::Type::kDouble:
    case schema::Type::kFloat:
      choices = unit ? std::vector<std::string>{"0.25", "0.75"}
                     : std::vector<std::string>{"0.25", "1.75"};
      break;
    case schema::Type::kVector2: choices = {"0.5 0.25", "1.5 0.75"}; break;
    case schema::Type::kVector2i: choices = {"3 4", "5 6"}; break;
    case schema::Type::kVector3: choices = {"0.6 0 0.8", "0 0.6 0.8"}; break;
    case schema::Type::kPose:
      choices = {own + " 0.2 0.3 0.4 0.5 0.6", own + " 0.1 0.2 0.6 0.4 0.5"};
      break;
    case schema::Type::kColor: choices = {own + " 0.2 0.3 0.5", own + " 0.3 0.1 0.75"}; break;
    case schema::Type::kTime: choices = {"2 5", "3 6"}; break;
    case schema::Type::kAngle: choices = {"0.25", "0.75"}; break;
    case schema::Type::kQuaternion: choices = {"0 1 0 0", "0 0 1 0"}; break;
  }
  std::erase(choices, fallback);
  if (static_cast<std::size_t>(which) >= choices.size()) return std::nullopt;
  return choices[static_cast<std::size_t>(which)];
}

/// What an element must hold, filled.
inline void fill_required(Plant& plant, schema::Node node, const std::vector<std::string>& path,
                          const WordTable& words) {
  for (const schema::Node attribute : node.required_attributes()) {
    const std::string key(attribute.name());
    if (plant.attribute(key) != nullptr) continue;
    plant.attributes.emplace_back(key, value_of({path, key, attribute}, 0, words).value_or(""));
  }
  if (node.type() != schema::Type::kNone && plant.text.empty()) {
    plant.text = value_of({path, {}, node}, 0, words).value_or("");
  }
  for (const schema::Node child : node.required_children()) {
    std::vector<std::string> below = path;
    below.emplace_back(child.name());
    if (plant.child(child.name()) != nullptr) continue;
    // Blocks that must hold one of their own kind would have no end; there is none.
    fill_required(plant.must(child.name()), child, below, words);
  }
}

/// The way to a place, with what is missing on it; of several elements of a name the first. The last is
/// the place's element.
inline std::vector<Plant*> grow(Plant& top, schema::Node node, const SchemaPlace& place,
                                const WordTable& words) {
  std::vector<Plant*> way{&top};
  std::vector<std::string> path;
  schema::Node at = node;
  for (const std::string& step : place.path) {
    path.push_back(step);
    at = at.child(step).value();
    Plant* next = way.back()->child(step);
    if (next == nullptr) {
      next = &way.back()->must(step);
      fill_required(*next, at, path, words);
    }
    way.push_back(next);
  }
  return way;
}

}  // namespace rigor::test
