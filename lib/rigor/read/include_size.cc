// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/include_size.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/read/sdf_reader.h>

namespace rigor::read {
namespace {

constexpr std::size_t kTooMany = kMaxIncludedParts + 1;

bool is_part(std::string_view name) {
  constexpr std::array<std::string_view, 10> kParts{"link",  "joint",  "collision", "visual",
                                                    "model", "sensor", "light",     "plugin",
                                                    "frame", "include"};
  return std::find(kParts.begin(), kParts.end(), name) != kParts.end();
}

/// Goes down to what is included and adds up on the way back. Not by recursion: a chain of includes
/// may be as long as a folder has files.
class Count {
 public:
  explicit Count(const Reader& reader) : reader_(reader) {}

  std::size_t of(const File& file) {
    if (const auto known = reader_.workspace.parts(file.path)) return *known;
    entered_.insert(&file);
    open_.push_back({&file});
    std::size_t last = 0;
    while (!open_.empty()) {
      Open& top = open_.back();
      if (const File* next = advance(top)) {
        open_.push_back({next});
        continue;
      }
      last = std::min(top.parts, kTooMany);
      reader_.workspace.keep_parts(top.file->path, last);
      open_.pop_back();
      if (!open_.empty()) open_.back().parts += last;
    }
    return last;
  }

 private:
  struct Open {
    const File* file;
    std::uint32_t element = 0;  ///< the next to look at
    std::size_t parts = 0;
  };

  /// Counts on, up to an include of a file that is not counted yet.
  const File* advance(Open& open) {
    if (!open.file->document) return nullptr;
    const xml::Document& document = *open.file->document;
    while (open.element < document.element_count() && open.parts < kTooMany) {
      const xml::Element element = document.element(open.element++);
      if (!is_part(element.name())) continue;
      ++open.parts;
      if (element.name() != "include") continue;
      const File* file = included(*open.file, element);
      if (file == nullptr) continue;
      if (const auto known = reader_.workspace.parts(file->path)) {
        open.parts += *known;
      } else if (entered_.insert(file).second) {
        return file;
      }
    }
    return nullptr;
  }

  const File* included(const File& from, xml::Element include) const {
    const std::string uri = include_uri(include).value;
    if (uri.empty()) return nullptr;
    const Resolution& found = reader_.workspace.resolve(reader_.resolver, uri, from.path);
    std::vector<Fact> unsaid;  // told when the file is followed
    return found.path ? open_model(reader_, *found.path, {}, unsaid) : nullptr;
  }

  const Reader& reader_;
  std::vector<Open> open_;
  std::set<const File*> entered_;
};

}  // namespace

std::size_t parts_with_includes(const Reader& reader, const File& file) {
  return Count(reader).of(file);
}

}  // namespace rigor::read
