// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/template_suppressions.h>

#include <map>
#include <string_view>
#include <utility>

#include <rigor/xml/document.h>

namespace rigor::rules {

Diagnostics TemplateSuppressions::uncovered(Diagnostics found, const xacro::Expansion& expansion) {
  for (const xacro::FileUse& file : expansion.files) {
    const std::string_view bytes = sources_.bytes(file.source);
    if (bytes.find("rigor:") == std::string_view::npos) continue;
    const bool is_own = file.source == expansion.files.front().source;
    Diagnostics here;
    Diagnostics elsewhere;
    for (const Diagnostic& each : found.list())
      (is_own || each.where.source == file.source ? here : elsewhere).add(each);
    Suppressions written(xml::parse(bytes, file.source));
    found = written.uncovered(std::move(here));
    found.take(std::move(elsewhere));
    if (!is_own) continue;
    if (own_) {
      own_->take_uses(written);
    } else {
      own_ = std::move(written);
    }
  }
  return found;
}

void TemplateSuppressions::count_copies(const Diagnostics& all, const Diagnostics& left) {
  if (!own_ || all.list().size() == left.list().size()) return;
  std::map<std::pair<std::string_view, std::string_view>, int> covered;
  for (const Diagnostic& each : all.list()) ++covered[{each.rule, each.category}];
  for (const Diagnostic& each : left.list()) --covered[{each.rule, each.category}];
  for (const auto& [names, count] : covered) {
    if (count == 0) continue;
    own_->use(names.first);
    own_->use(names.second);
  }
}

SuppressionFacts TemplateSuppressions::facts(const Registry& registry, const Runner& runner,
                                             MeshPolicy meshes) const {
  return own_ ? own_->facts(registry, runner, meshes) : SuppressionFacts{};
}

}  // namespace rigor::rules
