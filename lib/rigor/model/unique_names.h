// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names of which no two are the same: what is there already gets a number behind it.
//
//   UniqueNames names;
//   names.add("wheel");  // "wheel"
//   names.add("wheel");  // "wheel_2"

#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace rigor::model {

class UniqueNames {
 public:
  /// The second of a name gets `first_number`, after an underscore.
  explicit UniqueNames(int first_number = 2) : first_number_(first_number) {}

  bool contains(const std::string& name) const { return taken_.contains(name); }

  /// False when it is there already.
  bool insert(std::string name) { return taken_.insert(std::move(name)).second; }

  /// `name`, or that with the first number that is free. Thousands of one name do not try all numbers each.
  std::string add(const std::string& name) {
    if (insert(name)) return name;
    std::string result;
    int& number = next_.try_emplace(name, first_number_).first->second;
    do {
      result = name + '_' + std::to_string(number++);
    } while (!insert(result));
    return result;
  }

 private:
  int first_number_;
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> next_;  ///< numbers below it are taken, by name
};

}  // namespace rigor::model
