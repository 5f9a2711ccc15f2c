// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/format/configured_style.h>

namespace rigor::author {

FormatStyle configured_style(const config::Layout& layout) {
  FormatStyle style;
  if (layout.indent) style.indent = layout.indent->value;
  if (layout.width) style.width = layout.width->value;
  if (layout.quotes && layout.quotes->value == "single") style.quotes = FormatQuotes::kSingle;
  if (layout.quotes && layout.quotes->value == "keep") style.quotes = FormatQuotes::kKeep;
  if (layout.order && layout.order->value == "canonical") style.order = FormatOrder::kCanonical;
  return style;
}

}  // namespace rigor::author
