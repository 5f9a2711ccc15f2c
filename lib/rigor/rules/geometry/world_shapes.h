// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The models of a world as its file tells of them: what stands in it, and what it includes.

#pragma once

#include <optional>
#include <string>

#include <rigor/model/model.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// Where the file says that the model is there: its own element, or the include that brings it.
/// Nothing for what an included file includes.
inline std::optional<Span> place_of(const model::Model& model, const model::Root& root) {
  if (root.own(model.site)) return model.site.name;
  if (model.include >= root.includes.size()) return std::nullopt;
  const model::Include& include = root.includes[model.include];
  if (!root.own(include.site)) return std::nullopt;
  return include.site.name;
}

/// Whether the collision says itself what it touches, by bits, or that touching does nothing.
inline bool is_choosy(const model::Collision& collision, const Context& context) {
  return context.root().own(collision.site) && collision.surface.chooses_contacts;
}

}  // namespace rigor::rules
