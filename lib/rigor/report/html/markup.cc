// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/html/markup.h>

#include <rigor/report/terminal/printable.h>

namespace rigor::report {

std::string escaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const char c = text.front();
    if (c == '\n') {
      out += c;
      text.remove_prefix(1);
      continue;
    }
    const Glyph glyph = first_glyph(text);
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      default: out += glyph.shown;
    }
    text.remove_prefix(glyph.size);
  }
  return out;
}

}  // namespace rigor::report
