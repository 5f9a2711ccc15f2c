// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The frame of pages that load nothing, light and dark, for the screen and for paper. They are well-formed XML.
//
//   return begin_page({.title = "rigor simulate"}) + "<h1>…</h1>" + end_page();

#pragma once

#include <string>
#include <string_view>

namespace rigor::report {

struct PageHead {
  std::string_view title;
  std::string_view style = {};        ///< on top of that of all pages
  std::string_view images = {};       ///< where pictures may come from: "data:", "'self'"
  std::string_view script_hash = {};  ///< of the only script that may run: "sha256-…"
};

/// Up to the beginning of the body. What the head does not name the page cannot load or run, whatever it holds.
std::string begin_page(const PageHead& head);
std::string end_page();

}  // namespace rigor::report
