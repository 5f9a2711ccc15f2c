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

/// Where lines begin: behind a line feed, and behind a carriage return that none follows.
class LineBegins {
 public:
  LineBegins(std::string_view bytes, std::size_t at)
      : bytes_(bytes), feed_(bytes.find('\n', at)), lone_return_(lone_return(at)) {}

  /// The next one, or the end of the bytes.
  std::uint32_t next() {
    const std::size_t end = std::min(feed_, lone_return_);
    if (end == bytes_.npos) return static_cast<std::uint32_t>(bytes_.size());
    if (end == feed_) feed_ = bytes_.find('\n', end + 1);
    if (end == lone_return_) lone_return_ = lone_return(end + 1);
    return static_cast<std::uint32_t>(end + 1);
  }

 private:
  std::size_t lone_return(std::size_t at) const {
    for (at = bytes_.find('\r', at); at != bytes_.npos; at = bytes_.find('\r', at + 1)) {
      if (at + 1 == bytes_.size() || bytes_[at + 1] != '\n') return at;
    }
    return at;
  }

  std::string_view bytes_;
  std::size_t feed_;
  std::size_t lone_return_;
};

}  // namespace

std::string_view Places::path(const Diagnostic& diagnostic) const {
  return diagnostic.where.nowhere() ? std::string_view(diagnostic.path) : path(diagnostic.where);
}

/// An anchor at each line's begin, and within a long line one every kApart bytes. Never inside a
/// character: there the code points on both sides would not add up to those of the whole.
std::vector<Places::Anchor> Places::anchors_of(std::string_view bytes) {
  const std::uint32_t first = bytes.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  const auto size = static_cast<std::uint32_t>(bytes.size());
  std::vector<Anchor> anchors = {{0, {}}, {first, {}}};
  LineBegins lines(bytes, first);
  for (std::uint32_t begin = first; begin < size;) {
    const std::uint32_t next = lines.next();
    for (std::uint32_t at = begin + kApart; at < next;) {
      if (continues(bytes[at])) {
        ++at;
        continue;
      }
      const Anchor last = anchors.back();
      const auto between = bytes.substr(last.offset, at - last.offset);
      anchors.push_back(
          {at, {last.position.line, last.position.column + count_code_points(between)}});
      at += kApart;
    }
    if (next < size) anchors.push_back({next, {anchors.back().position.line + 1, 1}});
    begin = next;
  }
  if (bytes.ends_with('\n') || bytes.ends_with('\r'))
    anchors.push_back({size, {anchors.back().position.line + 1, 1}});
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
