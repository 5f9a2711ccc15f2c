// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/srdf/robot_name.h>

#include <rigor/xml/document.h>

namespace rigor::read {

std::string robot_name_in(std::string_view bytes) {
  constexpr std::string_view kRobot = "<robot";
  const std::size_t begin = bytes.find(kRobot);
  const std::size_t end = begin == std::string_view::npos ? begin : bytes.find('>', begin);
  if (end == std::string_view::npos) return {};
  std::string tag(bytes.substr(begin, end - begin));
  if (tag.ends_with('/')) tag.pop_back();
  tag += "/>";
  const xml::Document document = xml::parse_own(tag, SourceId{0});
  const auto root = document.root();
  const auto name = root ? root->attribute("name") : std::nullopt;
  if (!name || name->value().find('$') != std::string_view::npos) return {};
  return std::string(name->value());
}

}  // namespace rigor::read
