// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A walk over the strings and numbers of a JSON text, for formats that are lists of objects under the
// keys of one outermost object, as glTF is. Nothing is built, nothing is believed: what is no JSON is
// passed over.
//
//   for_each_scalar(json, [&](const JsonScalar& scalar) {
//     if (scalar.section == "buffers" && scalar.of_item() && scalar.key == "uri") read(scalar.text);
//   });

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rigor::mesh {

struct JsonScalar {
  enum class Kind : std::uint8_t { kString, kNumber };

  Kind kind = Kind::kString;
  std::uint64_t depth = 0;        ///< how many objects and lists it is in
  std::string_view section = {};  ///< key of the outermost object
  std::uint64_t item = 0;         ///< in a list of objects there, the number of the object, from 0
  std::string_view key = {};      ///< the last one
  std::string_view text = {};     ///< as it is written; a string without its quotes
  std::size_t at = 0;             ///< offset of the text

  /// Whether it stands directly in an object of the section's list.
  bool of_item() const { return depth == 3; }
};

template <class Use>
void for_each_scalar(std::string_view json, const Use& use) {
  constexpr std::string_view kSpace = " \t\r\n";
  constexpr std::string_view kOfNumbers = "0123456789+-.eE";
  JsonScalar now;
  std::uint64_t objects = 0;  // of the section's list, so far
  const auto tell = [&](JsonScalar::Kind kind, std::size_t at, std::string_view text) {
    now.kind = kind;
    now.at = at;
    now.text = text;
    use(static_cast<const JsonScalar&>(now));
  };
  for (std::size_t at = 0; at < json.size(); ++at) {
    const char c = json[at];
    if (c == '{' || c == '[') {
      if (++now.depth == 3 && c == '{') now.item = objects++;
    } else if ((c == '}' || c == ']') && now.depth > 0) {
      --now.depth;
    } else if (c == '-' || (c >= '0' && c <= '9')) {
      std::size_t end = json.find_first_not_of(kOfNumbers, at);
      if (end == std::string_view::npos) end = json.size();
      tell(JsonScalar::Kind::kNumber, at, json.substr(at, end - at));
      at = end - 1;
    } else if (c == '"') {
      const std::size_t begin = at + 1;
      for (++at; at < json.size() && json[at] != '"'; ++at) {
        if (json[at] == '\\') ++at;
      }
      if (at >= json.size()) return;
      const std::string_view text = json.substr(begin, at - begin);
      const std::size_t next = json.find_first_not_of(kSpace, at + 1);
      if (next == std::string_view::npos || json[next] != ':') {
        tell(JsonScalar::Kind::kString, begin, text);
        continue;
      }
      now.key = text;
      if (now.depth != 1) continue;
      now.section = text;
      objects = 0;
    }
  }
}

}  // namespace rigor::mesh
