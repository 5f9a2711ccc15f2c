// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/protocol/framing.h>

#include <charconv>

#include <rigor/text/letter_case.h>

namespace rigor::lsp {
namespace {

constexpr std::string_view kHeaderEnd = "\r\n\r\n";
constexpr std::string_view kLengthField = "content-length:";

/// Nothing where no field says it, or it says more than a message may have.
std::optional<std::size_t> content_length(std::string_view header) {
  while (!header.empty()) {
    const std::size_t end = header.find("\r\n");
    std::string_view field = header.substr(0, end);
    header = end == std::string_view::npos ? std::string_view() : header.substr(end + 2);
    if (!lowered(field).starts_with(kLengthField)) continue;
    field.remove_prefix(kLengthField.size());
    while (field.starts_with(' ')) field.remove_prefix(1);
    std::size_t length = 0;
    const auto [past, error] = std::from_chars(field.data(), field.data() + field.size(), length);
    if (error != std::errc() || past == field.data() || length > kMaxMessageBytes)
      return std::nullopt;
    return length;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> FrameReader::next() {
  if (broken_) return std::nullopt;
  const std::size_t header = buffer_.find(kHeaderEnd);
  if (header == std::string::npos || header > kMaxHeaderBytes) {
    broken_ = buffer_.size() > kMaxHeaderBytes;
    return std::nullopt;
  }
  const auto length = content_length(std::string_view(buffer_).substr(0, header));
  if (!length) {
    broken_ = true;
    return std::nullopt;
  }
  const std::size_t begin = header + kHeaderEnd.size();
  if (buffer_.size() - begin < *length) return std::nullopt;
  std::string body = buffer_.substr(begin, *length);
  buffer_.erase(0, begin + *length);
  return body;
}

std::string framed(std::string_view body) {
  return "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + std::string(body);
}

}  // namespace rigor::lsp
