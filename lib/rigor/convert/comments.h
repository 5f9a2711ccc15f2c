// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What an author remarked on an element. Private to the room.
//
//   visual.comments = remarks_on(documents, visual_site, CommentsFor::kUrdf);

#pragma once

#include <cstdint>

#include <rigor/convert/remark.h>
#include <rigor/model/site.h>
#include <rigor/read/documents.h>

namespace rigor::convert {

enum class CommentsFor : std::uint8_t { kUrdf, kSdf };

/// The comments before an element, in it, and on the line of its end, in the order of the file. A comment
/// on a line of its own refers to what follows, another one of what stands before it. Those on the
/// inertial, the visuals and the collisions in it are theirs, and those inside sensors and plugins go
/// where these go. None for a site that stands nowhere.
Remarks remarks_on(const read::Documents& documents, const model::Site& site, CommentsFor target);

/// Those before the file's root, but for the head of an earlier conversion and the banner of xacro.
Remarks remarks_on_file(const xml::Document& document);

}  // namespace rigor::convert
