// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the expander found, in its own words, with the definition that matters.

#pragma once

#include <string_view>
#include <utility>

#include <rigor/rules/rule.h>
#include <rigor/xacro/fact.h>

namespace rigor::rules {

inline std::string_view label_of_related(rigor::xacro::FactKind kind) {
  using Kind = rigor::xacro::FactKind;
  switch (kind) {
    case Kind::kYaml:
    case Kind::kWrongValue: return "read here";
    case Kind::kRedefinedProperty:
    case Kind::kRedefinedMacro: return "defined before here";
    case Kind::kUndefinedName: return "defined here: after its use, or in a scope of its own";
    case Kind::kNamespaceConflict: return "the other is here";
    case Kind::kNotBoolean:
    case Kind::kWrongType: return "the value is set here";
    default: return "defined here";
  }
}

inline void report_fact(const rigor::xacro::Fact& fact, Context& context) {
  Finding finding{.where = fact.where, .message = describe(fact)};
  if (!fact.related.nowhere()) {
    finding.related.push_back({fact.related, std::string(label_of_related(fact.kind))});
  }
  context.report(std::move(finding));
}

}  // namespace rigor::rules
