// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The elements that a model's structs were read from, for what the structs do not hold: colors, the sizes of
// planes. A file is parsed when the first of its elements is asked for. Private to the room.
//
//   SourceElements elements(sources);
//   if (const auto element = elements.at(visual.site)) use(element->child("transparency"));

#pragma once

#include <map>
#include <optional>

#include <rigor/model/site.h>
#include <rigor/text/sources.h>
#include <rigor/xml/document.h>

namespace rigor::view {

class SourceElements {
 public:
  explicit SourceElements(const Sources& sources) : sources_(sources) {}

  /// Nothing for what no author wrote. Valid as long as this.
  std::optional<xml::Element> at(const model::Site& site) {
    const SourceId source = site.span.source;
    if (site.span.nowhere()) return std::nullopt;
    auto known = documents_.find(source);
    if (known == documents_.end()) {
      known = documents_.emplace(source, xml::parse(sources_.bytes(source), source)).first;
    }
    if (site.element >= known->second.element_count()) return std::nullopt;
    return known->second.element(site.element);
  }

 private:
  const Sources& sources_;
  std::map<SourceId, xml::Document> documents_;  // elements point at them: a map's stay in place
};

}  // namespace rigor::view
