// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <rigor/mesh/asset/readers.h>
#include <rigor/mesh/line_counter.h>
#include <rigor/mesh/text_cursor.h>
#include <rigor/text/letter_case.h>

namespace rigor::mesh {
namespace {

using State = FileReference::State;

// A library of materials takes some kilobytes; of more materials that are used none is looked for.
constexpr std::uint64_t kMaxLibraryBytes = std::uint64_t{64} << 20U;
constexpr std::size_t kMaxMaterials = 100'000;

/// Calls `use(word, rest, offset)` for each line that says something.
template <class Use>
void for_each_statement(std::string_view bytes, const Use& use) {
  for (TextCursor cursor(bytes); !cursor.at_end(); cursor.skip_line()) {
    cursor.skip_blanks();
    if (cursor.at_line_end()) continue;
    const std::size_t offset = cursor.offset();
    const std::string_view word = cursor.word();
    use(word, cursor.rest_of_line(), offset);
  }
}

bool names_texture(std::string_view word) {
  const std::string low = lowered(word);
  return low.starts_with("map_") || low == "bump" || low == "disp" || low == "decal" ||
         low == "refl" || low == "norm";
}

/// How many words follow an option of a texture (MTL format, "Texture map options"); of three
/// numbers the last two may be left out.
struct Option {
  std::string_view name;
  int words;
};
constexpr Option kOptions[] = {{"-blendu", 1}, {"-blendv", 1}, {"-bm", 1},      {"-boost", 1},
                               {"-cc", 1},     {"-clamp", 1},  {"-imfchan", 1}, {"-mm", 2},
                               {"-o", 3},      {"-s", 3},      {"-t", 3},       {"-texres", 1},
                               {"-type", 1}};

/// The file's name, which may hold blanks, behind the options.
std::string_view texture_name(std::string_view rest) {
  for (;;) {
    TextCursor cursor(rest);
    const std::string_view word = cursor.word();
    const auto* const option = std::find_if(std::begin(kOptions), std::end(kOptions),
                                            [&](const Option& o) { return o.name == word; });
    if (option == std::end(kOptions)) return rest;
    for (int i = 0; i < option->words; ++i) {
      cursor.skip_blanks();
      if (option->words == 1) {
        cursor.word();
      } else if (!cursor.number()) {
        break;
      }
    }
    rest = cursor.rest_of_line();
  }
}

class ObjAssetReader {
 public:
  ObjAssetReader(const Disk& disk, const std::string& path) : disk_(disk), path_(path) {}

  Asset run(std::string_view bytes) {
    LineCounter lines(bytes);
    for_each_statement(bytes, [&](std::string_view word, std::string_view rest, std::size_t at) {
      if (word == "mtllib") name_libraries(rest, lines.at(at));
      if (word == "usemtl") now_ = {rest, lines.at(at)};
      if (word == "f") use_material();
    });
    for (const FileReference& library : facts_.libraries) read(library);
    return {.obj = std::move(facts_),
            .textures = std::move(textures_),
            .undefined_materials = undefined()};
  }

 private:
  /// One file whose name has blanks, if there is one; else a file a word.
  void name_libraries(std::string_view rest, std::uint64_t line) {
    constexpr std::string_view kBlanks = " \t";
    if (facts_.libraries.size() == kMaxReferences) return;
    FileReference whole = resolve(disk_, path_, rest, line);
    const bool one = rest.find_first_of(kBlanks) == std::string_view::npos;
    if (one || whole.state != State::kMissing) return keep(std::move(whole));
    while (!rest.empty() && facts_.libraries.size() < kMaxReferences) {
      const std::size_t end = std::min(rest.find_first_of(kBlanks), rest.size());
      keep(resolve(disk_, path_, rest.substr(0, end), line));
      rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks, end), rest.size()));
    }
  }

  /// That of the last `usemtl`, which a face has now.
  void use_material() {
    if (now_.first.empty()) return;
    if (used_.size() < kMaxMaterials && known_.insert(now_.first).second) used_.push_back(now_);
    now_ = {};
  }

  std::vector<Mention> undefined() const {
    std::vector<Mention> names;
    if (!complete_) return names;
    for (const auto& [material, line] : used_) {
      if (defined_.contains(material) || names.size() == kMaxReferences) continue;
      names.push_back({std::string(material.substr(0, kMaxCopiedText)), line});
    }
    return names;
  }

  void keep(FileReference library) {
    if (facts_.libraries.size() < kMaxReferences) facts_.libraries.push_back(std::move(library));
  }

  /// Once each.
  void read(const FileReference& library) {
    if (!is_there(library)) complete_ = false;
    if (!is_there(library) || !seen_.insert(library.path).second) return;
    const ReadResult file = disk_.read(library.path, kMaxLibraryBytes);
    if (!file.bytes) complete_ = false;
    if (!file.bytes) return;
    LineCounter lines(*file.bytes);
    for_each_statement(
        *file.bytes, [&](std::string_view word, std::string_view rest, std::size_t at) {
          if (word == "newmtl") define(rest);
          if (!names_texture(word) || textures_.size() == kMaxReferences) return;
          // Consumers look next to the library, which is next to the mesh as a rule.
          textures_.push_back(resolve(disk_, library.path, texture_name(rest), lines.at(at)));
          textures_.back().from = library.path;
        });
  }

  void define(std::string_view material) {
    // What is known is a view of the mesh file, and stays.
    if (const auto known = known_.find(material); known != known_.end()) defined_.insert(*known);
  }

  const Disk& disk_;
  const std::string& path_;
  ObjFacts facts_;
  std::vector<FileReference> textures_;
  std::pair<std::string_view, std::uint64_t> now_;  ///< a material that no face has yet, its line
  std::vector<std::pair<std::string_view, std::uint64_t>> used_;
  std::set<std::string_view> known_;    ///< materials that are used
  std::set<std::string_view> defined_;  ///< and those of them that a library has
  bool complete_ = true;                ///< all libraries could be read
  std::set<std::string> seen_;          ///< libraries
};

}  // namespace

Asset obj_asset(const Disk& disk, const std::string& path, std::string_view bytes) {
  return ObjAssetReader(disk, path).run(bytes);
}

}  // namespace rigor::mesh
