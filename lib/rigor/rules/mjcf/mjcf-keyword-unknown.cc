// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/mjcf/space_around.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/place.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::mjcf_keyword_unknown {

void check(const read::SchemaFact& fact, Context& context) {
  if (!fact.attribute) return;
  const std::string attribute(fact.attribute->name());
  std::vector<std::string_view> words;
  for (const std::string_view word : fact.node->enumeration()) words.push_back(word);
  const auto near = schema::near(fact.text, words);
  context.report({.where = fact.where,
                  .message = "'" + std::string(fact.text) + "' is not a value of " + attribute +
                             std::string(space_around(fact.text)),
                  .help = near.empty() ? "" : "did you mean '" + std::string(near.front()) + "'?"});
}

Rule rule() {
  return {
      .name = "mjcf-keyword-unknown",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "unknown keyword",
      .why = "MuJoCo rejects the file: the attribute takes one of a few words, in this spelling.",
      .what_to_do = "Write one of the words that the attribute takes.",
      .checks = {on_schema({read::SchemaFactKind::kNotInEnumeration}, check)},
  };
}

}  // namespace rigor::rules::mjcf_keyword_unknown
