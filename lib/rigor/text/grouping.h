// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// One cause, one finding: a missing package is one finding, and not one for each of its forty meshes.
//
// Findings of the same rule, severity and cause become one, that of the first place; the others are its
// `others`, each with a message of its own. A rule may name the cause. Otherwise the message is the cause:
// findings of any file with the same message and help have the same cause, and those of
// one file whose messages differ only in the names of their subjects. So the message of a group is true of
// each of its places, but for the name of the first.
//
//   const Diagnostics shown = grouped(result.diagnostics);
//   shown.list()[0].others.size();  // 39

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <rigor/text/diagnostic.h>

namespace rigor {

/// What findings of one group share, and those of no other group.
std::string cause_of(const Diagnostic& finding);

/// Groups findings as they come.
class Grouping {
 public:
  void add(const Diagnostic& finding);
  /// Groups so far.
  std::size_t size() const { return groups_.size(); }
  /// Keeps what was added apart from what comes.
  void close() { known_.clear(); }
  Diagnostics take();

 private:
  std::vector<Diagnostic> groups_;
  std::unordered_map<std::string, std::size_t> known_;  // groups by what their findings share
};

/// In the order of their first places, places in the order of the list. To group twice changes nothing.
Diagnostics grouped(const Diagnostics& findings);

/// How many there are in such a list, for a summary.
struct GroupCounts {
  std::array<std::size_t, 3> by_severity{};  ///< those that are counted and not listed among them
  std::size_t places = 0;
  bool joined = false;  ///< some has several places
};

/// Of `grouped(findings)`, without making it.
GroupCounts count_groups(const Diagnostics& findings);

/// The findings before they were grouped: first those of the first group.
Diagnostics ungrouped(const Diagnostics& groups);

/// The message with an ellipsis for each quoted name that the subject holds: "the link '…' has no mass".
std::string without_names(const std::string& message, std::string_view subject);

}  // namespace rigor
