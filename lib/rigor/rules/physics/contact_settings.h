// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers of a collision's `<contact><ode>`, which the model does not hold all.

#pragma once

#include <optional>
#include <string_view>

#include <rigor/read/values.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// `<surface><contact><ode>` of a collision of an SDF; nothing when there is none.
inline std::optional<xml::Element> contact_settings(const model::Collision& collision,
                                                    const Context& context) {
  std::optional<xml::Element> element = context.element(collision.site);
  for (const char* name : {"surface", "contact", "ode"}) {
    if (element) element = element->child(name);
  }
  return element;
}

/// Not written when it is missing or no number.
inline model::Field<double> contact_setting(xml::Element settings, std::string_view name) {
  return read::number_field(read::child_text(settings, name), 0);
}

}  // namespace rigor::rules
