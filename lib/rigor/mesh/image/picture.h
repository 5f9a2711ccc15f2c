// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How large a picture is, from the first bytes of its file.

#pragma once

#include <cstdint>

#include <rigor/text/disk.h>

namespace rigor::mesh {

/// In pixels; 0 by 0 when it is no PNG or JPEG, or is damaged.
struct PictureSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  bool operator==(const PictureSize&) const = default;
};

PictureSize picture_size(const OpenFile& file);

}  // namespace rigor::mesh
