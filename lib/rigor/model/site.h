// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where an entity stands in its file.

#pragma once

#include <cstdint>

#include <rigor/text/span.h>

namespace rigor::model {

struct Site {
  Span span;                            ///< the whole element
  Span tag;                             ///< its start tag
  Span name;                            ///< the element's name in the start tag
  std::uint32_t element = 0xffffffffU;  ///< its index in the document of `span.source`
};

}  // namespace rigor::model
