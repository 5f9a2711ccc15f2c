// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The files that a drawing needs, from a disk: meshes through the cache that others use too, pictures decoded
// once.
//
//   mass::MeshReads reads(disk, environment.workers);
//   const Files files = files_of(resolver, sources, reads);
//   const Drawing drawing = draw(root, frames, sources, files, {});

#pragma once

#include <cstdint>

#include <rigor/mass/mesh/reads.h>
#include <rigor/read/resolver.h>
#include <rigor/text/sources.h>
#include <rigor/view/drawing/drawing.h>
#include <rigor/view/image/picture.h>

namespace rigor::view {

/// A larger file is not read as a picture: 4,096 x 4,096 pixels have 64 MB without any compression.
inline constexpr std::uint64_t kMaxPictureBytes = std::uint64_t{64} << 20U;
/// All pictures of a drawing together have at most so many pixels: 512 MB.
inline constexpr std::uint64_t kMaxPicturePixels = 2 * kMaxPixels;

/// URIs are looked up from the file they stand in, as `validate` does. A submesh is the parts of that name; its
/// middle is moved to the origin where `<center>` says so. All three arguments outlive the result, which is
/// not to be used by several threads at once; its copies share what was found.
Files files_of(const read::Resolver& resolver, const Sources& sources, mass::MeshReads& reads);

}  // namespace rigor::view
