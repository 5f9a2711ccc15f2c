// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures made smaller.
//
//   const Picture small = shrunk(texture, 1024);

#pragma once

#include <cstdint>

#include <rigor/view/image/picture.h>

namespace rigor::view {

/// At most `side` pixels wide and high, of the same shape; each pixel is the mean of those in its place. One
/// that is no larger stays as it is.
Picture shrunk(const Picture& picture, std::uint32_t side);

}  // namespace rigor::view
