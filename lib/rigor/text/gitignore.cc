// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/gitignore.h>

#include <algorithm>

#include <rigor/text/byte_order_mark.h>
#include <rigor/text/path.h>

namespace rigor {
namespace {

/// Spaces at the end of a line are none of the pattern's, but for one behind a backslash.
std::string_view without_last_spaces(std::string_view line) {
  std::size_t end = line.size();
  while (end > 0 && line[end - 1] == ' ') --end;
  std::size_t backslashes = 0;
  while (backslashes < end && line[end - 1 - backslashes] == '\\') ++backslashes;
  const bool escaped = backslashes % 2 == 1 && end < line.size();
  return line.substr(0, escaped ? end + 1 : end);
}

/// What is left of a pattern without `!`, the slash that ties it to its folder, and the one that says
/// "a folder".
std::string_view core_of(std::string_view text) {
  if (text.starts_with('!')) text.remove_prefix(1);
  if (text.ends_with('/')) text.remove_suffix(1);
  if (text.starts_with('/')) text.remove_prefix(1);
  return text;
}

std::string_view plain_beginning(std::string_view core) {
  return core.substr(0, std::min(core.find_first_of("*?[\\"), core.size()));
}

}  // namespace

IgnorePattern::IgnorePattern(std::string_view its_text, std::size_t its_line)
    : text(its_text),
      line(its_line),
      ignores(!its_text.starts_with('!')),
      beginning_(plain_beginning(core_of(its_text))),
      rest_(core_of(its_text).substr(beginning_.size())),
      plain_(core_of(its_text).size() == beginning_.size()) {
  std::string_view body = its_text;
  if (!ignores) body.remove_prefix(1);
  folders_only_ = body.ends_with('/');
  if (folders_only_) body.remove_suffix(1);
  name_only_ = body.find('/') == std::string_view::npos;
}

bool IgnorePattern::matches(std::string_view path, PathKind kind) const {
  if (folders_only_ && kind != PathKind::kFolder) return false;
  const std::string_view wanted = name_only_ ? file_name(path) : path;
  if (!wanted.starts_with(beginning_)) return false;
  // `**` behind such a beginning stands first in what is left, and git takes it for "any folders".
  const std::string_view left = wanted.substr(beginning_.size());
  return plain_ ? left.empty() : rest_.matches(left);
}

IgnorePatterns::IgnorePatterns(std::string_view bytes) {
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  for (std::size_t line = 1; !bytes.empty(); ++line) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    std::string_view text = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    if (text.ends_with('\r')) text.remove_suffix(1);
    text = without_last_spaces(text.substr(0, text.find('\0')));
    if (!text.empty() && !text.starts_with('#')) patterns_.emplace_back(text, line);
  }
}

const IgnorePattern* IgnorePatterns::last_match(std::string_view path, PathKind kind) const {
  for (auto pattern = patterns_.rbegin(); pattern != patterns_.rend(); ++pattern) {
    if (pattern->matches(path, kind)) return &*pattern;
  }
  return nullptr;
}

}  // namespace rigor
