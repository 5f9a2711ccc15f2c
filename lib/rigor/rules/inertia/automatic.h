// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which inertials a consumer computes when it loads the model.

#pragma once

#include <rigor/mass/resolve.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// Asked for, in a version that has it: of an older one element-newer-than-version speaks.
inline bool is_computed(const model::Link& link, const Context& context) {
  return mass::is_automatic(link) && context.root()[link.model].version >= 11;
}

}  // namespace rigor::rules
