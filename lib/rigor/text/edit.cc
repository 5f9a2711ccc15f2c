// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/edit.h>

#include <algorithm>
#include <iterator>

namespace rigor {

std::string_view to_string(Applicability applicability) {
  switch (applicability) {
    case Applicability::kSafe: return "safe";
    case Applicability::kUnsafe: return "unsafe";
    case Applicability::kManual: break;
  }
  return "manual";
}

void append(std::vector<Edit>& edits, std::vector<Edit> more) {
  edits.insert(edits.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
}

std::optional<std::string> apply_edits(std::string_view bytes, std::vector<Edit> edits) {
  std::stable_sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) {
    return a.span.begin != b.span.begin ? a.span.begin < b.span.begin : a.span.end < b.span.end;
  });
  edits.erase(std::unique(edits.begin(), edits.end()), edits.end());

  std::string result;
  std::size_t done = 0;
  const Edit* previous = nullptr;
  for (const Edit& edit : edits) {
    const bool same_place = previous != nullptr && previous->span.begin == edit.span.begin;
    if (edit.span.begin < done || edit.span.end < edit.span.begin || edit.span.end > bytes.size() ||
        same_place) {
      return std::nullopt;
    }
    result += bytes.substr(done, edit.span.begin - done);
    result += edit.text;
    done = edit.span.end;
    previous = &edit;
  }
  result += bytes.substr(done);
  return result;
}

}  // namespace rigor
