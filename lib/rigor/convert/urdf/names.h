// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names that URDF and its readers can live with: `hand::palm` is `hand__palm`, white space is `_`, no
// name is empty, and none is there twice. Private to the room.
//
//   UrdfNames links("link", {"world"});
//   std::vector<std::string> names = links.take({"hand::palm", "world"});  // hand__palm, world_2

#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/model/unique_names.h>

namespace rigor::convert {

class UrdfNames {
 public:
  /// `fallback` is the name of what has none; the `reserved` ones are given to nobody.
  explicit UrdfNames(std::string fallback, std::initializer_list<std::string> reserved = {})
      : fallback_(std::move(fallback)) {
    for (const std::string& name : reserved) names_.insert(name);
  }

  /// A name for each, in their order. What can keep its name keeps it, whatever else wants it.
  std::vector<std::string> take(const std::vector<std::string>& names);

  /// One that is like `name`.
  std::string add(std::string_view name);

 private:
  std::string legal(std::string_view name) const;

  std::string fallback_;
  model::UniqueNames names_;
};

}  // namespace rigor::convert
