// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/model/parameter.h>

namespace rigor::model {

const Parameter* find(const Parameters& parameters, std::string_view name) {
  for (const Parameter& parameter : parameters) {
    if (parameter.name == name) return &parameter;
  }
  return nullptr;
}

const Field<std::string>* attribute(const Parameter& parameter, std::string_view name) {
  for (const Attribute& attribute : parameter.attributes) {
    if (attribute.name == name) return &attribute.value;
  }
  return nullptr;
}

bool is_true(const Parameter& parameter) {
  return parameter.value.value == "true" || parameter.value.value == "1";
}

}  // namespace rigor::model
