// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_tag_malformed {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-tag-malformed",
      .severity = Severity::kError,
      .summary = "a tag or a substitution of xacro is written wrongly",
      .why = "A tag of xacro lacks an attribute, gives two that exclude each other, or has a "
             "name that none may have; or `$(…)` is no command. xacro ends with an error, so "
             "nothing is loaded.",
      .what_to_do = "Write the tag as the message says.",
      .checks = {on_xacro(
          {FactKind::kMissingAttribute, FactKind::kPropertyConflict, FactKind::kBadName,
           FactKind::kNoParentScope, FactKind::kUnknownCommand, FactKind::kBadCommand},
          report_fact)},
  };
}

}  // namespace rigor::rules::xacro_tag_malformed
