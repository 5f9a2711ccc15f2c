// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xml/judge.h>

#include <tinyxml2.h>

namespace rigor::xml {

std::optional<Refusal> tinyxml2_refusal(std::string_view bytes) {
  tinyxml2::XMLDocument document;
  if (document.Parse(bytes.data(), bytes.size()) == tinyxml2::XML_SUCCESS) return std::nullopt;
  return Refusal{document.ErrorLineNum(), document.ErrorName()};
}

}  // namespace rigor::xml
