// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The sentences of a rule's page that a report prints below a finding. Made when something is found: all rules'
// would be a fifth of the time that a command takes to start.
//
//   const PageInBrief page = page_in_brief({rule.why, rule.what_to_do}, model::Format::kUrdf);

#pragma once

#include <string_view>

#include <rigor/model/model.h>

namespace rigor::rules {

/// What a rule's page says; static data.
struct PageProse {
  std::string_view why;
  std::string_view what_to_do;
};

/// Views of the prose.
struct PageInBrief {
  std::string_view why;
  std::string_view help;
};

/// The first sentence of each that is not about readers of other formats.
PageInBrief page_in_brief(const PageProse& prose, model::Format format);

}  // namespace rigor::rules
