// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Entries of the cache of meshes as bytes and back, exactly.
//
//   const std::string bytes = encode({witnesses, importer, facts});
//   if (const auto same = decode(bytes)) use(same->found);

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <rigor/mass/mesh/cache.h>

namespace rigor::mass {

/// To be raised when the same members get another meaning. New members need not: the compiler stops
/// until they are named in facts_code.cc, and other programs' entries are not examined.
inline constexpr std::string_view kMeshFactsCode = "3";

std::string encode(CachedMesh entry);

/// Nothing of bytes that no `encode` has given.
std::optional<CachedMesh> decode(std::string_view bytes);

}  // namespace rigor::mass
