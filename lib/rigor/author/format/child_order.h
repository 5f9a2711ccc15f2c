// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `order = "canonical"`: the children of links, joints, inertials, shapes and sensors in the order in which the schema
// lists them. Children of one name keep theirs, as the first link is the canonical one, and so do those of worlds,
// models, robots, <gazebo> and plugins. A comment moves with the element that it stands before, or behind on its line.
//
//   const ChildOrder order(environment.sdf, environment.urdf);
//   const std::string text = order.ordered(document);  // as it was, when all is in order
//
// What holds an element that no schema knows there, or one of xacro's, stays as it is.

#pragma once

#include <string>

#include <rigor/schema/schema.h>
#include <rigor/xml/document.h>

namespace rigor::author {

class ChildOrder {
 public:
  /// Both outlive it.
  ChildOrder(const schema::Schema& sdf, const schema::Schema& urdf) : sdf_(sdf), urdf_(urdf) {}

  /// The bytes of a complete document with its children in order.
  std::string ordered(const xml::Document& document) const;

 private:
  const schema::Schema& sdf_;
  const schema::Schema& urdf_;
};

/// Whether two documents have the same elements, where children of other names may come in another order, and the
/// same comments: what `ordered` may change, and nothing else.
bool same_but_for_order(const xml::Document& a, const xml::Document& b);

}  // namespace rigor::author
