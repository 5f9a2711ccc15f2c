// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/template_branches.h>

#include <string_view>

namespace rigor::rules {

void TemplateBranches::add(const xacro::Expansion& expansion) {
  if (expansion.files.empty()) return;
  const SourceId own = expansion.files.front().source;
  for (const Span tag : expansion.skipped_conditions) {
    if (tag.source == own) skipped_.try_emplace(tag.begin, tag);
  }
  for (const xacro::Frame& frame : expansion.frames) {
    if (frame.kind == xacro::FactFrame::Kind::kCondition && frame.where.source == own)
      taken_.insert(frame.where.begin);
  }
}

std::vector<xacro::Fact> TemplateBranches::dead(const Sources& sources) const {
  std::vector<xacro::Fact> facts;
  for (const auto& [begin, tag] : skipped_) {
    const std::string_view written = sources.bytes(tag);
    const bool is_constant = written.find('$') == written.npos;  // a rule of its own tells of it
    if (taken_.contains(begin) || is_constant || written.find(" and ") != written.npos) continue;
    facts.push_back({xacro::FactKind::kDeadBranch, tag});
  }
  return facts;
}

}  // namespace rigor::rules
