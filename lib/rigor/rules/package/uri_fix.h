// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What it means for a model that one of its URIs, which led nowhere, now leads to a file.

#pragma once

#include <string_view>

#include <rigor/rules/context.h>
#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

namespace rigor::rules {

/// Unsafe where links or their mass come with the file: in an include, and in a link whose inertial is
/// computed from its meshes.
inline Applicability fix_of_uri(Span uri, const Context& context) {
  auto at = context.document().element_at(uri.begin);
  for (; at; at = at->parent()) {
    if (at->name() == "include") return Applicability::kUnsafe;
    if (at->name() != "link") continue;
    const auto inertial = at->child("inertial");
    if (inertial && inertial->attribute("auto")) return Applicability::kUnsafe;
  }
  return Applicability::kSafe;
}

}  // namespace rigor::rules
