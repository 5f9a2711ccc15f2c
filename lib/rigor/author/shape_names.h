// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The collisions and visuals of a model by name, as somebody types it.
//
//   std::vector<ShapeName> found = find_shapes(shape_names(root), "base::hull");

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <rigor/model/model.h>

namespace rigor::author {

struct ShapeName {
  std::variant<model::Id<model::Collision>, model::Id<model::Visual>> shape;
  std::string plain;      ///< "arm::base::hull"; without a name one of those below
  std::string with_kind;  ///< "arm::base::visual hull", of one without a name "arm::base::visual 2"
  std::string by_kind;    ///< of a link's only visual: "arm::base::visual"; else empty
};

std::vector<ShapeName> shape_names(const model::Root& root);

/// Those that the name means: the whole one, or else the ends of whole ones.
std::vector<ShapeName> find_shapes(const std::vector<ShapeName>& all, std::string_view name);

/// Those in the link that the name names, though it has no such shape.
std::vector<ShapeName> neighbors(const std::vector<ShapeName>& all, std::string_view name);

/// What to type for one of them: the plain name where no other has it.
std::string to_type(const std::vector<ShapeName>& all, const ShapeName& shape);

}  // namespace rigor::author
