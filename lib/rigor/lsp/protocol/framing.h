// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The base protocol: messages of a stream, each behind a header that says its length in bytes.
//
//   FrameReader reader;
//   reader.add(bytes);
//   while (std::optional<std::string> body = reader.next()) handle(*body);
//   write(framed(answer));

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace rigor::lsp {

/// A message holds one document at most, which holds 64 MiB (read/workspace.h) and may be escaped.
inline constexpr std::size_t kMaxMessageBytes = std::size_t{256} << 20U;
/// Two short fields.
inline constexpr std::size_t kMaxHeaderBytes = 4096;

class FrameReader {
 public:
  void add(std::string_view bytes) { buffer_ += bytes; }

  /// The next whole message; nothing while it is not there, or the stream is broken.
  std::optional<std::string> next();

  /// Whether a header without a usable Content-Length was read: nobody knows where the next message begins.
  bool broken() const { return broken_; }

 private:
  std::string buffer_;
  bool broken_ = false;
};

/// The body with its header.
std::string framed(std::string_view body);

}  // namespace rigor::lsp
