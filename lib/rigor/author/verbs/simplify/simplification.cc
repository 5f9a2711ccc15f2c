// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/simplify/simplification.h>

#include <fmt/core.h>

#include <rigor/author/verbs/simplify/primitive_element.h>

namespace rigor::author {
namespace {

std::string what_is(const mesh::Substitute& found) {
  if (found.primitive) return primitive_shape(found.primitive->shape).kind;
  switch (found.kind) {
    case mesh::SubstituteKind::kHull: return "convex hull";
    case mesh::SubstituteKind::kPieces: return fmt::format("{} convex pieces", found.meshes.size());
    default: return "reduced mesh";
  }
}

}  // namespace

std::string note(const Simplification& part) {
  if (!part.found) return fmt::format("{}: left: {}", part.name, part.why);
  const mesh::Substitute& found = *part.found;
  const std::string triangles =
      found.primitive ? fmt::format("{} triangles", part.triangles)
                      : fmt::format("{} of {} triangles", found.triangles, part.triangles);
  return fmt::format("{}: {} for {}: {:.3g} m off ({:.2g} % of the link), volume {:+.2g} %{}",
                     part.name, what_is(found), triangles, found.hausdorff,
                     100 * found.hausdorff / part.link_size, 100 * found.volume_error,
                     found.of_hull ? " of its hull's, as it is open" : "");
}

std::string_view file_suffix(mesh::SubstituteKind kind) {
  switch (kind) {
    case mesh::SubstituteKind::kHull: return "hull";
    case mesh::SubstituteKind::kPieces: return "piece";
    default: return "reduced";
  }
}

}  // namespace rigor::author
