// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/parameter_names.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <rigor/author/names/parameter_texts.h>
#include <rigor/text/letter_case.h>
#include <rigor/text/path.h>

namespace rigor::author {
namespace {

/// Words in keys whose values are joints. Controllers of mobile bases call theirs wheels.
constexpr std::array<std::string_view, 4> kJointKeyWords{"joint", "wheel", "interface", "gains"};
constexpr std::array<std::string_view, 6> kLinkKeyWords{"link",     "frame",       "body",
                                                        "position", "orientation", "footprint"};

}  // namespace

std::optional<ParameterFormat> parameter_format(std::string_view path) {
  const std::string ending = extension(path);
  if (ending == ".yaml" || ending == ".yml") return ParameterFormat::kYaml;
  if (ending == ".toml") return ParameterFormat::kToml;
  return std::nullopt;
}

bool ParameterName::is_of(NameKinds kinds) const {
  const auto has_any = [this](const auto& words) {
    return std::any_of(keys.begin(), keys.end(), [&words](const std::string& key) {
      const std::string small = lowered(key);
      return std::any_of(words.begin(), words.end(), [&small](std::string_view word) {
        return small.find(word) != std::string::npos;
      });
    });
  };
  if (kinds.has(NameKind::kJoint)) return has_any(kJointKeyWords);
  return (kinds.has(NameKind::kLink) || kinds.has(NameKind::kFrame)) && has_any(kLinkKeyWords);
}

std::vector<ParameterName> parameter_names(std::string_view bytes, ParameterFormat format,
                                           SourceId source, std::string_view name) {
  std::vector<ParameterName> found;
  if (name.empty()) return found;
  const auto is_name = [name](std::string_view text, ParameterRole) {
    return text.starts_with(name) && (text.size() == name.size() || text[name.size()] == '/');
  };
  for (ParameterText& text : parameter_texts(bytes, format, source, is_name)) {
    text.where.end = text.where.begin + static_cast<std::uint32_t>(name.size());
    found.push_back({text.where, std::move(text.keys)});
  }
  return found;
}

}  // namespace rigor::author
