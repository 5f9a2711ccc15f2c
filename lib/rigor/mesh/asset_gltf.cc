// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <charconv>
#include <optional>
#include <utility>
#include <vector>

#include <rigor/mesh/asset_readers.h>
#include <rigor/mesh/line_counter.h>
#include <rigor/xml/decode.h>

namespace rigor::mesh {
namespace {

// Names that are copied, which are some words long.
constexpr std::size_t kMaxText = 256;
constexpr std::size_t kMaxExtensions = 100;

// A .glb is 12 bytes of header, then chunks: length, "JSON", the text (glTF 2.0, 4.4).
constexpr std::size_t kChunkOffset = 12;
constexpr std::size_t kTextOffset = 20;

std::optional<std::string_view> json_of_glb(std::string_view bytes) {
  if (bytes.size() < kTextOffset || bytes.substr(kChunkOffset + 4, 4) != "JSON") {
    return std::nullopt;
  }
  std::size_t length = 0;
  for (std::size_t i = 4; i-- > 0;) {
    length = length << 8U | static_cast<unsigned char>(bytes[kChunkOffset + i]);
  }
  return bytes.substr(kTextOffset, length);
}

/// A string's value; what is no escape stays as it is.
std::string unescaped(std::string_view raw) {
  constexpr std::string_view kEscapes = "\"\\/bfnrt";
  constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
  std::string text;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (raw[i] != '\\' || i + 1 == raw.size()) {
      text += raw[i];
      continue;
    }
    const char next = raw[++i];
    std::uint32_t code = 0;
    const char* const digits = raw.data() + i + 1;
    if (const std::size_t known = kEscapes.find(next); known != std::string_view::npos) {
      text += kMeanings[known];
    } else if (next == 'u' && i + 4 < raw.size() &&
               std::from_chars(digits, digits + 4, code, 16).ptr == digits + 4) {
      xml::append_utf8(text, code);
      i += 4;
    }
  }
  return text;
}

/// Looks only at strings: how deep they stand, under which key of the outermost object, and behind
/// which key. Anything that is not JSON is passed over.
template <class Use>
void for_each_string(std::string_view json, const Use& use) {
  constexpr std::string_view kSpace = " \t\r\n";
  std::string_view section;
  std::string_view key;
  int depth = 0;
  for (std::size_t at = 0; at < json.size(); ++at) {
    const char c = json[at];
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (c != '"') continue;
    const std::size_t begin = at + 1;
    for (++at; at < json.size() && json[at] != '"'; ++at) {
      if (json[at] == '\\') ++at;
    }
    if (at >= json.size()) return;
    const std::string_view text = json.substr(begin, at - begin);
    const std::size_t next = json.find_first_not_of(kSpace, at + 1);
    if (next != std::string_view::npos && json[next] == ':') {
      key = text;
      if (depth == 1) section = text;
    } else {
      use(depth, section, key, text, begin);
    }
  }
}

class Reader {
 public:
  Reader(const Disk& disk, const std::string& path) : disk_(disk), path_(path) {}

  /// Without lines in a .glb.
  Asset run(std::string_view json, std::optional<LineCounter> lines) {
    for_each_string(json, [&](int depth, std::string_view section, std::string_view key,
                              std::string_view text, std::size_t at) {
      if (section == "asset" && depth == 2) about(key, text);
      if (section == "extensionsRequired" && depth == 2 &&
          facts_.extensions_required.size() < kMaxExtensions) {
        facts_.extensions_required.push_back(unescaped(text.substr(0, kMaxText)));
      }
      const bool names_file = depth == 3 && key == "uri";
      if (names_file && section == "buffers") name(facts_.buffers, text, at, lines);
      if (names_file && section == "images") name(textures_, text, at, lines);
    });
    return {.gltf = std::move(facts_), .textures = std::move(textures_)};
  }

 private:
  void about(std::string_view key, std::string_view text) {
    if (key == "version") facts_.version = unescaped(text.substr(0, kMaxText));
    if (key == "generator") facts_.generator = unescaped(text.substr(0, kMaxText));
  }

  void name(std::vector<FileReference>& into, std::string_view text, std::size_t at,
            std::optional<LineCounter>& lines) const {
    if (into.size() == kMaxReferences) return;
    into.push_back(resolve(disk_, path_, unescaped(text), lines ? lines->at(at) : 0));
  }

  const Disk& disk_;
  const std::string& path_;
  GltfFacts facts_;
  std::vector<FileReference> textures_;
};

}  // namespace

Asset gltf_asset(const Disk& disk, const std::string& path, std::string_view bytes) {
  Reader reader(disk, path);
  if (!bytes.starts_with("glTF")) return reader.run(bytes, LineCounter(bytes));
  const std::optional<std::string_view> json = json_of_glb(bytes);
  if (!json) return {.problem = "its first chunk is no JSON", .gltf = GltfFacts{}};
  return reader.run(*json, std::nullopt);
}

}  // namespace rigor::mesh
