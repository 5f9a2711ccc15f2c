// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The files that the `<include>` elements of an MJCF file are replaced by.

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include <rigor/read/workspace.h>
#include <rigor/xml/document.h>

namespace rigor::read {

class MjcfIncludes {
 public:
  bool empty() const { return files_.empty(); }
  /// `file` has a document with a root, and outlives this.
  void add(xml::Element include, const File& file) { files_.emplace(key(include), &file); }
  /// What the children of are in the place of the include; nothing where it leads nowhere.
  std::optional<xml::Element> root_of(xml::Element include) const {
    const auto found = files_.find(key(include));
    if (found == files_.end()) return std::nullopt;
    return found->second->document->root();
  }

 private:
  using Key = std::pair<SourceId, std::uint32_t>;
  static Key key(xml::Element include) { return {include.tag_span().source, include.index()}; }

  std::map<Key, const File*> files_;
};

}  // namespace rigor::read
