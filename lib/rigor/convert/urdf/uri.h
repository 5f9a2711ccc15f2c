// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a mesh's URI becomes in a URDF file, whose readers know packages and no models. Private to the
// room.
//
//   UrdfMesh mesh{.filename = urdf_uri(draft, shape.uri, subject)};

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/convert/urdf/draft.h>
#include <rigor/model/field.h>
#include <rigor/text/span.h>

namespace rigor::convert {

/// As seen from the root of the disk, where the working folder is known.
std::string whole_path(const Source& source, const std::string& path);
std::optional<std::string> file_uri(const Source& source, const std::string& file);

/// The path of the file that a source was read from.
std::string path_of(const Source& source, SourceId id);

/// Where the URI leads; nothing when it does not exist.
std::optional<std::string> file_of(const Source& source, const model::Field<std::string>& uri);

/// A URI in the result and whether it leads to the file from where that will stand.
struct PlacedUri {
  std::string uri;
  bool found = true;
};
enum class UriChoice : std::uint8_t { kOurs, kUsers };
/// `uri`, or what leads to the file where it does not: a path seen from the result, or a whole one. What
/// the user has chosen stays, and so does the name of a ROS package, which is found wherever that is known.
PlacedUri placed_uri(const Source& source, std::string uri, const std::string& file,
                     UriChoice choice);

/// By the options' policy; takes the URI, and notes a change, one that only some readers will
/// find, and one that does not exist.
std::string urdf_uri(UrdfDraft& draft, const model::Field<std::string>& uri,
                     const std::string& subject);

}  // namespace rigor::convert
