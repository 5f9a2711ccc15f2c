// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// U+FEFF in UTF-8, with which some editors begin a file.

#pragma once

#include <string_view>

namespace rigor {

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace rigor
