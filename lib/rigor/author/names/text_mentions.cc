// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/text_mentions.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/names/parameter_names.h>
#include <rigor/text/path.h>

namespace rigor::author {
namespace {

constexpr std::array<std::string_view, 5> kConfigurations{".launch", ".xml", ".rviz", ".json",
                                                          ".lua"};
constexpr std::array<std::string_view, 6> kCode{".py", ".cpp", ".cc", ".hpp", ".h", ".cxx"};

/// A shorter word is most often something else: `x`, `id`.
constexpr std::size_t kMinWord = 3;
/// What people write; what is larger is data.
constexpr std::uint64_t kMaxTextBytes = std::uint64_t{1} << 20U;
/// Files that are listed one by one.
constexpr std::size_t kMaxLines = 20;
constexpr std::size_t kMaxNames = 3;

template <std::size_t N>
bool has_ending(std::string_view path, const std::array<std::string_view, N>& endings) {
  return std::find(endings.begin(), endings.end(), extension(path)) != endings.end();
}

bool continues_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool is_quote(char c) { return c == '"' || c == '\''; }

}  // namespace

bool is_mentioning_text(std::string_view path) {
  return file_name(path) != "package.xml" &&
         (has_ending(path, kConfigurations) || has_ending(path, kCode));
}

std::vector<Span> text_mentions(std::string_view path, std::string_view bytes, SourceId source,
                                std::string_view name) {
  std::vector<Span> places;
  const bool is_code = has_ending(path, kCode);
  if (name.size() < (is_code ? 1 : kMinWord)) return places;
  for (std::size_t at = 0; (at = bytes.find(name, at)) != std::string_view::npos;) {
    const char before = at == 0 ? ' ' : bytes[at - 1];
    const std::size_t end = at + name.size();
    const char after = end == bytes.size() ? ' ' : bytes[end];
    const bool is_word = !continues_word(before) && !continues_word(after);
    if (is_word && (!is_code || is_quote(before) || is_quote(after))) {
      places.push_back({source, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)});
    }
    at = end;
  }
  return places;
}

std::vector<Span> names_in_text(const Disk& disk, Sources& sources, const std::string& path,
                                const std::set<std::string>& names) {
  std::vector<Span> places;
  const auto format = parameter_format(path);
  if (!format && !is_mentioning_text(path)) return places;
  const ReadResult read = disk.read(path, kMaxTextBytes);
  if (!read.bytes) return places;
  const SourceId source = sources.add(path, *read.bytes);
  const std::string_view bytes = sources.bytes(source);
  for (const std::string& name : names) {
    if (!format) {
      for (const Span where : text_mentions(path, bytes, source, name)) places.push_back(where);
      continue;
    }
    for (const ParameterName& use : parameter_names(bytes, *format, source, name))
      places.push_back(use.where);
  }
  return places;
}

std::vector<std::string> mention_lines(const Sources& sources, const std::vector<Span>& places) {
  struct Mention {
    Span first;
    std::vector<std::string> names;
    std::size_t count = 0;
  };
  std::vector<Mention> mentions;
  for (const Span where : places) {
    auto known = std::find_if(mentions.begin(), mentions.end(), [&](const Mention& each) {
      return sources.path(each.first.source) == sources.path(where.source);
    });
    if (known == mentions.end()) known = mentions.insert(known, {where, {}, 0});
    if (where.begin < known->first.begin) known->first = where;
    std::string name(sources.bytes(where));
    if (std::find(known->names.begin(), known->names.end(), name) == known->names.end())
      known->names.push_back(std::move(name));
    ++known->count;
  }
  std::vector<std::string> lines;
  for (const auto& [where, names, count] : mentions) {
    if (lines.size() == kMaxLines) {
      lines.push_back(fmt::format("{} more files may hold a name", mentions.size() - kMaxLines));
      break;
    }
    std::string line =
        fmt::format("{}:{}: may be the name{}", sources.path(where.source),
                    sources.position(where.source, where.begin).line, names.size() > 1 ? "s" : "");
    for (std::size_t i = 0; i < std::min(names.size(), kMaxNames); ++i)
      line += fmt::format("{} '{}'", i == 0 ? "" : ",", names[i]);
    if (names.size() > kMaxNames) line += fmt::format(" and {} more", names.size() - kMaxNames);
    if (count > 1) line += fmt::format(" ({} places)", count);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace rigor::author
