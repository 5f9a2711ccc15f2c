// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Edits that can be done together: those of a fix join as a whole or not at
// all.
//
//   EditSet set;
//   for (const Fix& fix : fixes) set.take(fix.edits);   // false: it has to
//   wait apply_edits(bytes, set.list());

#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include <rigor/text/edit.h>

namespace rigor::author {

class EditSet {
 public:
  /// Takes all, or none when one of them overlaps another one that is not the
  /// same, as `apply_edits` sees it.
  bool take(const std::vector<Edit>& edits);

  std::vector<Edit> list() const;

 private:
  using ByBegin = std::map<std::uint32_t, Edit>;

  static bool fits(const ByBegin& taken, const Edit& edit);

  ByBegin by_begin_;
};

}  // namespace rigor::author
