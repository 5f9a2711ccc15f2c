// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An SRDF as a file: a new one, laid out as MoveIt's setup assistant does; or an existing one whose collision
// matrix is brought up to date by edits.
//
//   write(srdf_text(semantics));
//   const MatrixUpdate update = updated_matrix(document, semantics.disabled);
//   const auto text = apply_edits(document.bytes(), update.edits);

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <rigor/author/srdf/semantics.h>
#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

namespace rigor::author {

std::string srdf_text(const Semantics& semantics);

struct MatrixUpdate {
  std::vector<Edit> edits;
  std::size_t added = 0;
  std::size_t removed = 0;   ///< computed once, and no longer so
  std::size_t changed = 0;   ///< have another reason now
  std::size_t by_hand = 0;   ///< people's own, kept
  std::string refused = {};  ///< why there are no edits; empty when there may be
};

/// `<disable_collisions>` of the document made to be these pairs. Elements whose reason no assistant computes
/// ("User", others, none) stay as they are, and their pairs are not added again; so do all other elements, and
/// comments. Refuses what is not well-formed, no `<robot>`, or a URDF.
MatrixUpdate updated_matrix(const xml::Document& document,
                            const std::vector<DisabledPair>& disabled);

}  // namespace rigor::author
