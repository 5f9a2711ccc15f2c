// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/sources.h>

#include <algorithm>
#include <utility>

#include <rigor/text/byte_order_mark.h>

namespace rigor {
SourceId Sources::add(std::string path, std::string bytes) {
  const std::lock_guard lock(mutex_);
  sources_.push_back({std::move(path), std::move(bytes)});
  return SourceId{static_cast<std::uint32_t>(sources_.size() - 1)};
}

const Sources::Source& Sources::at(SourceId id) const {
  const std::lock_guard lock(mutex_);
  return sources_.at(static_cast<std::size_t>(id));
}

std::string_view Sources::path(SourceId id) const { return at(id).path; }

std::string_view Sources::bytes(SourceId id) const { return at(id).bytes; }

std::size_t Sources::total_bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t total = 0;
  for (const Source& source : sources_) total += source.bytes.size();
  return total;
}

std::string_view Sources::bytes(Span span) const {
  if (span.nowhere()) return {};
  return bytes(span.source).substr(span.begin, span.size());
}

Position Sources::position(SourceId id, std::uint32_t offset) const {
  return LineTable(bytes(id).substr(0, offset)).position(offset);
}

LineTable::LineTable(std::string_view bytes) : bytes_(bytes) {
  starts_.push_back(0);
  for (std::size_t at = bytes.find_first_of("\r\n"); at != std::string_view::npos;
       at = bytes.find_first_of("\r\n", at)) {
    at += bytes.substr(at, 2) == "\r\n" ? 2 : 1;
    starts_.push_back(static_cast<std::uint32_t>(at));
  }
}

Position LineTable::position(std::uint32_t offset) const {
  const auto after = std::upper_bound(starts_.begin(), starts_.end(), offset);
  const auto index = static_cast<std::uint32_t>(after - starts_.begin()) - 1;
  std::string_view before = bytes_.substr(starts_[index], offset - starts_[index]);
  if (index == 0 && before.starts_with(kByteOrderMark)) before.remove_prefix(3);
  return {index + 1, count_code_points(before) + 1};
}

std::string_view LineTable::line(std::uint32_t number) const {
  if (number == 0 || number > starts_.size()) return {};
  const std::uint32_t begin = starts_[number - 1];
  const std::size_t end = std::min(bytes_.find_first_of("\r\n", begin), bytes_.size());
  std::string_view text = bytes_.substr(begin, end - begin);
  if (number == 1 && text.starts_with(kByteOrderMark)) text.remove_prefix(3);
  return text;
}

std::uint32_t count_code_points(std::string_view utf8) {
  // A sequence's continuation bytes are the ones not counted. A continuation byte that continues
  // nothing is malformed and counts, so that columns still advance over it.
  std::uint32_t count = 0;
  int expected = 0;
  for (const char c : utf8) {
    const auto byte = static_cast<unsigned char>(c);
    if (expected > 0 && (byte & 0xC0) == 0x80) {
      --expected;
      continue;
    }
    ++count;
    expected = byte >= 0xF0 && byte < 0xF8 ? 3 : byte >= 0xE0 ? 2 : byte >= 0xC2 ? 1 : 0;
    if (byte >= 0xF8) expected = 0;
  }
  return count;
}

}  // namespace rigor
