// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Findings in an expanded template, as its author sees them: at the places that were written, each once.
//
//   Diagnostics reported = in_source(std::move(found), file, sources);
//   TemplateFindings merged(sources);
//   merged.add(std::move(reported));           // of each set of arguments, of each file
//   Diagnostics once = merged.take();

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <rigor/read/workspace.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/fact.h>

namespace rigor::rules {

/// As they are when the file is no template.
Diagnostics in_source(Diagnostics found, const read::File& file, const Sources& sources);

/// What a rule says of a fact of the expander gets the fact's calls and instances: `found` has a finding
/// for some of the facts, at the fact's place.
Diagnostics with_calls(Diagnostics found, const std::vector<xacro::Fact>& facts);

/// Findings of one rule at one place that was written are one, with the elements counted that show it. Those
/// at several places that take one value are one finding with `others`.
class TemplateFindings {
 public:
  explicit TemplateFindings(const Sources& sources) : sources_(sources) {}

  void add(Diagnostics found);

  Diagnostics take();

 private:
  void add_place(std::size_t index, const Diagnostic& each);

  using Key = std::tuple<std::string_view, std::string, std::uint32_t, std::uint32_t, std::string>;

  const Sources& sources_;
  /// In the list; `other` is the place among its `others`, counted from 1, or 0 for its own.
  struct Entry {
    std::size_t index;
    std::size_t other;
  };

  std::map<Key, Entry> known_;
  std::vector<Diagnostic> list_;
};

}  // namespace rigor::rules
