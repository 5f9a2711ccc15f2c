// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Bytes as text that a page can hold.
//
//   "data:image/png;base64," + base64(png)

#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// RFC 4648, section 4: with padding, on one line.
std::string base64(std::string_view bytes);

}  // namespace rigor
