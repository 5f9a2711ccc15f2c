// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The pages that node built of view/page, which are put into the library (cmake/EmbedPage.cmake). For sources of
// this room; others call page_template().

#pragma once

#include <string_view>

namespace rigor::report {

/// Empty when there was no node.
std::string_view embedded_page();
std::string_view embedded_live_page();

}  // namespace rigor::report
