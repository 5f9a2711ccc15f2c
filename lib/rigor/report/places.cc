// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/places.h>

#include <algorithm>
#include <iterator>

#include <rigor/text/byte_order_mark.h>

namespace rigor::report {
namespace {

/// Bytes between the anchors of a long line: what a question has to count at most.
constexpr std::uint32_t kApart = 1024;

/// Whether the byte is a later one of a character in UTF-8.
bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

std::string_view Places::path(const Diagnostic& diagnostic) const {
  return diagnostic.where.nowhere() ? std::string_view(diagnostic.path) : path(diagnostic.where);
}

/// An anchor at each line's begin, and within a long line one every kApart bytes. Never inside a
/// character: there the code points on both sides would not add up to those of the whole.
std::vector<Places::Anchor> Places::anchors_of(std::string_view bytes) {
  const std::uint32_t first = bytes.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  std::vector<Anchor> anchors = {{0, {}}, {first, {}}};
  for (std::uint32_t at = first; at < bytes.size(); ++at) {
    const Anchor last = anchors.back();
    const bool line_begins =
        at > first && (bytes[at - 1] == '\n' || (bytes[at - 1] == '\r' && bytes[at] != '\n'));
    if (line_begins) {
      anchors.push_back({at, {last.position.line + 1, 1}});
    } else if (at - last.offset >= kApart && !continues(bytes[at])) {
      const auto between = bytes.substr(last.offset, at - last.offset);
      anchors.push_back(
          {at, {last.position.line, last.position.column + count_code_points(between)}});
    }
  }
  if (bytes.ends_with('\n') || bytes.ends_with('\r')) {
    anchors.push_back(
        {static_cast<std::uint32_t>(bytes.size()), {anchors.back().position.line + 1, 1}});
  }
  return anchors;
}

Position Places::position(SourceId source, std::uint32_t offset) {
  const std::string_view bytes = sources_.bytes(source);
  auto found = anchors_.find(source);
  if (found == anchors_.end()) found = anchors_.emplace(source, anchors_of(bytes)).first;
  const auto after = std::upper_bound(
      found->second.begin(), found->second.end(), offset,
      [](std::uint32_t wanted, const Anchor& anchor) { return wanted < anchor.offset; });
  const Anchor& anchor = *std::prev(after);
  const std::string_view between = bytes.substr(anchor.offset, offset - anchor.offset);
  // Within the byte-order mark nothing has been written yet.
  if (anchor.offset == 0 && bytes.starts_with(kByteOrderMark)) return {};
  return {anchor.position.line, anchor.position.column + count_code_points(between)};
}

}  // namespace rigor::report
