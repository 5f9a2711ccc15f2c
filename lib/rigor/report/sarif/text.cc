// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/sarif/text.h>

#include <fmt/core.h>

namespace rigor::report {
namespace {

/// A text of ours may quote a file, and must not become a link to where that file wants.
std::string without_links(std::string text) {
  for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at)) {
    text.insert(at + 1, " ");
  }
  return text;
}

/// Text between the brackets of a link in a message.
std::string link_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\' || c == '[' || c == ']') out += '\\';
    out += c;
  }
  return out;
}

/// Whether a text names a place on this machine: help lists the folders where something was looked for.
bool names_machine(std::string_view text) {
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    const bool begins =
        at == 0 || std::string_view(" '\"(").find(text[at - 1]) != std::string_view::npos;
    if (text[at] == '/' && begins && text[at + 1] != ' ') return true;
  }
  return false;
}

}  // namespace

std::string percent_encoded(std::string_view path) {
  std::string uri;
  for (const char c : path) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      std::string_view("-._~/").find(c) != std::string_view::npos;
    uri += kept ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

std::string sarif_message(const Diagnostic& diagnostic) {
  std::string text = without_links(diagnostic.message) + '.';
  std::size_t id = 0;
  for (const Label& label : diagnostic.related) {
    ++id;
    text += label.where.nowhere() ? fmt::format(" {}.", without_links(label.message))
                                  : fmt::format(" [{}]({}).", link_text(label.message), id);
  }
  if (!diagnostic.help.empty() && !names_machine(diagnostic.help)) {
    text += fmt::format(" Help: {}.", without_links(diagnostic.help));
  }
  return text;
}

}  // namespace rigor::report
