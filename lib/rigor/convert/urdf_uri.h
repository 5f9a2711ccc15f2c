// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a mesh's URI becomes in a URDF file, whose readers know packages and no models. Private to the
// room.
//
//   UrdfMesh mesh{.filename = urdf_uri(draft, shape.uri, subject)};

#pragma once

#include <optional>
#include <string>

#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/convert/urdf_draft.h>
#include <rigor/model/field.h>
#include <rigor/text/span.h>

namespace rigor::convert {

/// The path of the file that a source was read from.
std::string path_of(const Source& source, SourceId id);

/// Where the URI leads; nothing when it leads nowhere.
std::optional<std::string> file_of(const Source& source, const model::Field<std::string>& uri);

/// By the options' policy; takes the URI, and notes a change, one that only some readers will
/// find, and one that leads nowhere.
std::string urdf_uri(UrdfDraft& draft, const model::Field<std::string>& uri,
                     const std::string& subject);

}  // namespace rigor::convert
