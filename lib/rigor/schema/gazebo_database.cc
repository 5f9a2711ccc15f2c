// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/schema/gazebo_database.h>

#include <algorithm>

#include <rigor/schema/embedded.h>

namespace rigor::schema {

bool in_gazebo_database(std::string_view model) {
  if (model.empty() || model.front() == '#') return false;
  std::string_view names = gazebo_models_text();
  while (!names.empty()) {
    const std::string_view name = names.substr(0, names.find('\n'));
    if (name == model) return true;
    names.remove_prefix(std::min(name.size() + 1, names.size()));
  }
  return false;
}

}  // namespace rigor::schema
