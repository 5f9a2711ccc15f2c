// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The transform of a Collada node against its parent: its <matrix>, <translate>, <rotate> and <scale>
// children, which apply from the last to the first (Collada 1.4.1, <node>).
//
//   if (auto X_PN = node_transform(node)) place(X_WP * *X_PN);

#pragma once

#include <optional>

#include <rigor/mesh/affine.h>
#include <rigor/xml/document.h>

namespace rigor::mesh {

/// Nothing when a child has not the numbers it needs, or is a <skew> or <lookat>, which no robot
/// model uses for shapes.
std::optional<Affine> node_transform(xml::Element node);

}  // namespace rigor::mesh
