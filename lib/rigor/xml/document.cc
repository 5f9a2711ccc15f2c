// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xml/document.h>

#include <algorithm>
#include <iterator>

namespace rigor::xml {

std::optional<Element> Document::element_at(std::uint32_t offset) const {
  const auto after = std::upper_bound(
      elements_.begin(), elements_.end(), offset,
      [](std::uint32_t wanted, const ElementRecord& element) { return wanted < element.begin; });
  if (after == elements_.begin()) return std::nullopt;
  auto index = static_cast<std::uint32_t>(std::prev(after) - elements_.begin());
  while (index != kNone && offset >= elements_[index].end) index = elements_[index].parent;
  if (index == kNone) return std::nullopt;
  return Element(*this, index);
}

}  // namespace rigor::xml
