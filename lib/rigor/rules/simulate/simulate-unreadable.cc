// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/simulate/told.h>

namespace rigor::rules::simulate_unreadable {
namespace {

std::string words_for(const std::string& name) {
  if (name == "no model") return "there is no model to simulate";
  if (name == "no such model") return "there is no model of this name";
  if (name == "no pose")
    return "nobody knows where it is: what its pose is relative to is not there";
  if (name == "no parent") return "the joint's parent is not there";
  if (name == "no child") return "the joint's child is not there";
  if (name == "expressed_in") return "the frame that the axis is expressed in is not there";
  if (name.starts_with("type ")) return "there is no joint of " + name;
  if (name.starts_with("include ")) return "the " + name + " leads nowhere";
  return "cannot be simulated: " + name;
}

}  // namespace

void check(const simulate::Fact& fact, Context& context) {
  context.report(shown(fact, words_for(fact.name)));
}

Rule rule() {
  return {
      .name = "simulate-unreadable",
      .category = Category::kSimulate,
      .severity = Severity::kError,
      .summary = "the file has no model that can be placed",
      .why =
          "A physics engine needs to know where every body is. Here there is no model, a name"
          " leads nowhere, or an include could not be followed, so nothing was simulated.",
      .what_to_do =
          "Run `rigor validate` on the file: it says which reference is wrong and where it "
          "was looked for.",
      .checks = {on_simulation({simulate::FactKind::kUnreadable}, check)},
  };
}

}  // namespace rigor::rules::simulate_unreadable
