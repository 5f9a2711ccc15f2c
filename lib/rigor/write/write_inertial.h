// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A link's inertial written into a user's file: numbers are replaced where they stand, and order,
// comments and layout stay the author's.
//
//   std::vector<Edit> edits = write_inertial(document, link, body, BlockFormat::kSdf);
//
// A value whose text already reads as the body's keeps its bytes, so writing twice is writing once.

#pragma once

#include <vector>

#include <rigor/mass/mass_properties.h>
#include <rigor/text/edit.h>
#include <rigor/write/inertial_text.h>
#include <rigor/xml/document.h>

namespace rigor::write {

/// `body` is in the link frame, and so is what is written: a rotation in the inertial's pose becomes
/// zero, a frame that it names is removed. What is missing is added, but no zero that the format has
/// by default. A link without `<inertial>` gets one, in SDF behind a leading `<pose>`, else as its
/// first child. SDF 1.0, which kept the numbers in attributes, keeps them there. An automatic
/// inertial (SDF 1.11) becomes one of numbers: `auto` and `<density>` go.
///
/// No edits for MJCF, which rigor does not read, and for a document that was cut.
std::vector<Edit> write_inertial(const xml::Document& document, xml::Element link,
                                 const mass::MassProperties& body, BlockFormat format);

}  // namespace rigor::write
