// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Bytes as text that a page can hold (RFC 4648, 4).

#pragma once

#include <string>
#include <string_view>

namespace rigor::report {

/// With padding, without line breaks.
std::string base64(std::string_view bytes);

}  // namespace rigor::report
