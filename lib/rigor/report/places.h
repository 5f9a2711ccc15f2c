// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines and columns for a whole report: each source is walked once, and no question afterwards costs
// more for a long line than for a short one (a file may be a single line with a finding in each
// tag).
//
//   Places places(sources);
//   Position begin = places.begin(span);

#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>

namespace rigor::report {

class Places {
 public:
  explicit Places(const Sources& sources) : sources_(sources) {}

  /// Of spans that stand somewhere.
  Position begin(Span span) { return position(span.source, span.begin); }
  Position end(Span span) { return position(span.source, span.end); }

  std::string_view path(Span span) const { return sources_.path(span.source); }
  std::string_view bytes(SourceId source) const { return sources_.bytes(source); }

  /// The file a finding is in, whether or not it stands in a text.
  std::string_view path(const Diagnostic& diagnostic) const;

 private:
  /// A place whose line and column are known.
  struct Anchor {
    std::uint32_t offset;
    Position position;
  };
  static std::vector<Anchor> anchors_of(std::string_view bytes);
  Position position(SourceId source, std::uint32_t offset);

  const Sources& sources_;
  std::map<SourceId, std::vector<Anchor>> anchors_;  // by offset
};

}  // namespace rigor::report
