// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The JSON of the protocol.
//
// What clients send is not trusted: members are read by functions that give a default where a member is not there
// or is of another type, and texts that are not UTF-8 are written with U+FFFD in place of the bytes at fault.

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace rigor::lsp {

using Json = nlohmann::json;

/// Nothing where the text is no JSON.
inline Json parsed_json(std::string_view text) {
  return Json::parse(text.begin(), text.end(), nullptr, false);
}

inline std::string json_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The member at a path such as "textDocument", "uri"; null where there is none.
template <class... Names>
const Json& member(const Json& json, std::string_view name, Names... more) {
  static const Json kNull;
  const auto found = json.is_object() ? json.find(std::string(name)) : json.end();
  const Json& value = json.is_object() && found != json.end() ? *found : kNull;
  if constexpr (sizeof...(more) > 0) {
    return member(value, more...);
  } else {
    return value;
  }
}

template <class... Names>
std::string text_at(const Json& json, Names... names) {
  const Json& value = member(json, names...);
  return value.is_string() ? value.get<std::string>() : std::string();
}

template <class... Names>
std::int64_t number_at(const Json& json, Names... names) {
  const Json& value = member(json, names...);
  return value.is_number_integer() ? value.get<std::int64_t>() : 0;
}

template <class... Names>
bool flag_at(const Json& json, Names... names) {
  const Json& value = member(json, names...);
  return value.is_boolean() && value.get<bool>();
}

}  // namespace rigor::lsp
