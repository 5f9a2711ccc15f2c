// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <vector>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_name_repeated {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where,
       .message = fact.related.nowhere()
                      ? "a " + fact.detail + " is called '" + fact.name + "', as the world is"
                      : "two elements of kind " + fact.detail + " are called '" + fact.name + "'",
       .subject = fact.subject,
       .related = fact.related.nowhere() ? std::vector<Label>()
                                         : std::vector<Label>{{fact.related, "the first"}}});
}

Rule rule() {
  return {
      .name = "mjcf-name-repeated",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "name is used twice",
      .why = "MuJoCo rejects the file: names are unique among the elements of one kind, over all "
             "files that it includes. Elements of different kinds may share a name.",
      .what_to_do = "Rename one of them, and what refers to it.",
      .checks = {on_mjcf({read::MjcfFactKind::kNameRepeated}, check)},
  };
}

}  // namespace rigor::rules::mjcf_name_repeated
