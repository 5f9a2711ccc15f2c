// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/edit_set.h>

#include <iterator>

namespace rigor::author {

bool EditSet::take(const std::vector<Edit>& edits) {
  ByBegin more;
  for (const Edit& edit : edits) {
    if (!fits(by_begin_, edit) || !fits(more, edit)) return false;
    more.emplace(edit.span.begin, edit);
  }
  by_begin_.merge(more);
  return true;
}

std::vector<Edit> EditSet::list() const {
  std::vector<Edit> edits;
  for (const auto& [begin, edit] : by_begin_) edits.push_back(edit);
  return edits;
}

bool EditSet::fits(const ByBegin& taken, const Edit& edit) {
  const auto next = taken.lower_bound(edit.span.begin);
  if (next != taken.end()) {
    if (next->first == edit.span.begin) return next->second == edit;
    if (next->first < edit.span.end) return false;
  }
  return next == taken.begin() || std::prev(next)->second.span.end <= edit.span.begin;
}

}  // namespace rigor::author
