// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/names.h>

namespace rigor::convert {

std::string UrdfNames::legal(std::string_view name) const {
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    if (name.substr(i, 2) == "::") {
      result += "__";
      ++i;
    } else {
      result += c <= ' ' || c == 0x7f ? '_' : name[i];
    }
  }
  return result.empty() ? fallback_ : result;
}

std::string UrdfNames::add(std::string_view name) { return names_.add(legal(name)); }

std::vector<std::string> UrdfNames::take(const std::vector<std::string>& names) {
  std::vector<std::string> result(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (legal(names[i]) == names[i] && names_.insert(names[i])) result[i] = names[i];
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (result[i].empty()) result[i] = add(names[i]);
  }
  return result;
}

}  // namespace rigor::convert
