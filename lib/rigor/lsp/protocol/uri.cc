// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/protocol/uri.h>

#include <charconv>

namespace rigor::lsp {
namespace {

constexpr std::string_view kFileScheme = "file://";

/// What a path of a URI may have as it is (RFC 3986, section 3.3).
bool stands_unescaped(char c) {
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  return letter || std::string_view("-._~/!$&'()*+,;=:@").find(c) != std::string_view::npos;
}

std::string unescaped(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(text.data() + i + 1, text.data() + i + 3, code, 16).ptr ==
            text.data() + i + 3) {
      plain += static_cast<char>(code);
      i += 2;
    } else {
      plain += text[i];
    }
  }
  return plain;
}

}  // namespace

std::string path_of_uri(std::string_view uri) {
  if (!uri.starts_with(kFileScheme)) return std::string(uri);
  const std::string_view rest = uri.substr(kFileScheme.size());
  const std::size_t slash = rest.find('/');  // behind the host, which is empty or localhost
  return slash == std::string_view::npos ? std::string(uri) : unescaped(rest.substr(slash));
}

std::string uri_of_path(std::string_view path) {
  if (!path.starts_with('/')) return std::string(path);
  std::string uri(kFileScheme);
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  for (const char c : path) {
    if (stands_unescaped(c)) {
      uri += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      uri += {'%', kDigits[byte >> 4U], kDigits[byte & 15U]};
    }
  }
  return uri;
}

}  // namespace rigor::lsp
