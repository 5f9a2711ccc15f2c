// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Text inside XML and HTML: whatever a file's names hold, it stays text.
//
//   out += "<td>" + escaped(link.name) + "</td>";

#pragma once

#include <string>
#include <string_view>

namespace rigor::report {

/// For content and for attributes in double or single quotes. What XML 1.0 cannot hold is shown by the
/// sign that represents it: a control character by its picture, a byte that is no UTF-8 by U+FFFD.
std::string escaped(std::string_view text);

}  // namespace rigor::report
