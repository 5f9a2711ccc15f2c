// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/schema/dialect.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include <rigor/schema/embedded.h>

namespace rigor::schema {
namespace {

constexpr std::size_t kDialectColumns = 4;
using DialectLine = std::array<std::string_view, kDialectColumns>;

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \r") - begin + 1);
}

/// The column that a line begins with, which is taken from it.
std::string_view take_column(std::string_view& line) {
  const std::size_t bar = line.find('|');
  const std::string_view column = without_blanks(line.substr(0, bar));
  line.remove_prefix(std::min(bar, line.size() - 1) + 1);
  return column;
}

/// The table is short, and asked only for names that a format does not have. Of most lines only the beginning is
/// read. An empty `parent` is any.
template <class Visit>
void for_each_dialect_line(std::string_view format, std::string_view parent, const Visit& visit) {
  std::string_view text = dialects_table_text();
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (!line.starts_with(format)) continue;
    DialectLine columns;
    columns[0] = take_column(line);
    if (columns[0] != format) continue;
    columns[1] = take_column(line);
    if (!parent.empty() && columns[1] != parent) continue;
    for (std::size_t i = 2; i < kDialectColumns; ++i) columns[i] = take_column(line);
    visit(columns);
  }
}

template <class Visit>
void for_each_dialect_name(std::string_view names, const Visit& visit) {
  while (!names.empty()) {
    const std::string_view name = names.substr(0, names.find(' '));
    if (!name.empty()) visit(name);
    names.remove_prefix(std::min(name.size() + 1, names.size()));
  }
}

}  // namespace

std::optional<std::string_view> find_dialect(std::string_view format, std::string_view parent,
                                             std::string_view name) {
  std::optional<std::string_view> reader;
  for_each_dialect_line(format, parent, [&](const DialectLine& line) {
    for_each_dialect_name(line[2], [&](std::string_view known) {
      if (!reader && known == name) reader = line[3];
    });
  });
  return reader;
}

std::vector<std::string_view> dialect_names(std::string_view format, std::string_view parent) {
  std::vector<std::string_view> names;
  for_each_dialect_line(format, parent, [&](const DialectLine& line) {
    for_each_dialect_name(line[2], [&](std::string_view name) { names.push_back(name); });
  });
  return names;
}

std::vector<std::string_view> dialect_sections(std::string_view format) {
  std::vector<std::string_view> parents;
  std::vector<std::string_view> elements;
  for_each_dialect_line(format, {}, [&](const DialectLine& line) {
    parents.push_back(line[1]);
    for_each_dialect_name(line[2], [&](std::string_view name) {
      if (!name.starts_with('@')) elements.push_back(name);
    });
  });
  std::sort(elements.begin(), elements.end());
  std::sort(parents.begin(), parents.end());
  parents.erase(std::unique(parents.begin(), parents.end()), parents.end());
  std::erase_if(parents, [&](std::string_view parent) {
    return !std::binary_search(elements.begin(), elements.end(), parent);
  });
  return parents;
}

}  // namespace rigor::schema
