// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/template_findings.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace rigor::rules {
namespace {

bool is_same_fix(const Diagnostic& a, const Diagnostic& b, const Sources& sources) {
  if (a.fixes.empty() || b.fixes.empty()) return a.fixes.empty() && b.fixes.empty();
  const auto& x = a.fixes.front().edits;
  const auto& y = b.fixes.front().edits;
  // Another expansion read the file anew, so the sources differ.
  const auto is_same = [&sources](const Edit& one, const Edit& other) {
    return one.span.begin == other.span.begin && one.span.end == other.span.end &&
           one.text == other.text &&
           sources.path(one.span.source) == sources.path(other.span.source);
  };
  return std::equal(x.begin(), x.end(), y.begin(), y.end(), is_same);
}

/// A path that `$(find …)` writes is right on every machine.
bool is_found_by_xacro(const Diagnostic& diagnostic, const Sources& sources) {
  if (diagnostic.rule != "uri-absolute-path" || diagnostic.where.nowhere()) return false;
  const auto& where = diagnostic.where;
  const std::string_view written =
      sources.bytes(where.source).substr(where.begin, where.end - where.begin);
  return written.find("$(find ") != written.npos;
}

void tell_instances(Diagnostic& diagnostic) {
  if (diagnostic.instances < 2) return;
  diagnostic.related.push_back(
      {{}, "shown " + std::to_string(diagnostic.instances) + " times in the expanded model"});
}

}  // namespace

Diagnostics in_source(Diagnostics found, const read::File& file, const Sources& sources) {
  if (!file.expanded || !file.document) return found;
  Diagnostics reported;
  for (const Diagnostic& each : found.list()) {
    Diagnostic placed = file.expanded->in_source(*file.document, each, sources);
    if (!is_found_by_xacro(placed, sources)) reported.add(std::move(placed));
  }
  return reported;
}

Diagnostics with_calls(Diagnostics found, const std::vector<xacro::Fact>& facts) {
  Diagnostics reported;
  for (Diagnostic each : found.list()) {
    const auto fact = std::find_if(facts.begin(), facts.end(), [&each](const xacro::Fact& one) {
      return one.where.source == each.where.source && one.where.begin <= each.where.begin &&
             each.where.end <= one.where.end;
    });
    if (fact != facts.end()) {
      each.origin = read::macro_calls(fact->stack);
      each.instances = fact->count;
    }
    reported.add(std::move(each));
  }
  return reported;
}

void TemplateFindings::add(Diagnostics found) {
  for (const Diagnostic& each : found.list()) {
    const bool has_place = !each.where.nowhere();
    // What is counted only has no place of its own; nor has what is about a file as a whole.
    if (!has_place || each.count > 1) {
      list_.push_back(each);
      continue;
    }
    const auto key = [&](Span where, std::string message) {
      return Key{each.rule, std::string(sources_.path(where.source)), where.begin, where.end,
                 std::move(message)};
    };
    // One value that several elements take, and that all of them show the same of, is one cause, too.
    const Span set = read::where_set(each);
    auto entry = known_.find(key(each.where, {}));
    if (entry == known_.end() && !set.nowhere()) {
      entry = known_.find(key(set, each.message));
      if (entry != known_.end()) {
        add_place(entry->second.index, each);
        known_.try_emplace(key(each.where, {}),
                           Entry{entry->second.index, list_[entry->second.index].others.size()});
        continue;
      }
    }
    if (entry == known_.end()) {
      known_.try_emplace(key(each.where, {}), Entry{list_.size(), 0});
      if (!set.nowhere()) known_.try_emplace(key(set, each.message), Entry{list_.size(), 0});
      list_.push_back(each);
      continue;
    }
    Diagnostic& first = list_[entry->second.index];
    first.severity = std::min(first.severity, each.severity);
    Diagnostic& shown = entry->second.other > 0 ? first.others[entry->second.other - 1] : first;
    shown.instances += each.instances;
    if (!is_same_fix(shown, each, sources_)) shown.fixes.clear();
  }
}

void TemplateFindings::add_place(std::size_t index, const Diagnostic& each) {
  Diagnostic& first = list_[index];
  first.severity = std::min(first.severity, each.severity);
  first.others.push_back(each);
}

Diagnostics TemplateFindings::take() {
  Diagnostics found;
  for (Diagnostic& each : list_) {
    tell_instances(each);
    for (Diagnostic& other : each.others) {
      other.severity = each.severity;
      tell_instances(other);
    }
    found.add(std::move(each));
  }
  list_.clear();
  return found;
}

}  // namespace rigor::rules
