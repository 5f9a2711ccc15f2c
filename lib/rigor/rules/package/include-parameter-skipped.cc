// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::include_parameter_skipped {

using read::ParameterFault;

std::string quoted_name(const std::string& name) { return "'" + name + "'"; }

/// What is wrong with it, of a fact whose detail is `detail`.
std::string fault_of(ParameterFault fault, const std::string& detail) {
  switch (fault) {
    case ParameterFault::kNoElementId: return "there is no element_id";
    case ParameterFault::kNoLastName: return "element_id ends in '::'";
    case ParameterFault::kNoAction: return "there is no action";
    case ParameterFault::kUnknownAction: return "action " + quoted_name(detail) + " is unknown";
    case ParameterFault::kNoName: return "what is added has no name";
    case ParameterFault::kExists:
      return quoted_name(detail) + " already exists in the included model";
    case ParameterFault::kNotFound: return "it does not exist in the included model";
    case ParameterFault::kOneLetterName: return "libsdformat finds no name of one letter";
    case ParameterFault::kInInclude: return "the included model includes it; not checked";
    case ParameterFault::kNotSdf: return "SDFormat does not describe this element by itself";
    case ParameterFault::kNotAChild: return "<" + detail + "> has no such child in SDFormat";
    case ParameterFault::kNotInElement:
    case ParameterFault::kRemovesNothing:
      return "the <" + detail + "> in the included model has no such child";
    case ParameterFault::kBadContent: return detail;
    case ParameterFault::kNoSuchAttribute:
      return "attribute " + quoted_name(detail) + " is unknown";
    case ParameterFault::kBadValue: return quoted_name(detail) + " is not a value of it";
  }
  return {};
}

std::string why_of(ParameterFault fault) {
  switch (fault) {
    case ParameterFault::kRemovesNothing:
      return "libsdformat 12 crashes on the removal of a child that does not exist, where the "
             "action "
             "is that of the parameter itself.";
    case ParameterFault::kOneLetterName:
      return "libsdformat compares positions in the element_id, and a name of one letter at its "
             "start "
             "is not after the start: it reports that the element does not exist.";
    case ParameterFault::kInInclude:
      return "libsdformat applies the parameter to the model inside; rigor reads that model "
             "without "
             "it.";
    default: return {};
  }
}

std::string help_for(ParameterFault fault) {
  switch (fault) {
    case ParameterFault::kNoElementId:
      return "add element_id: names below the included model, joined by '::'";
    case ParameterFault::kNoAction:
    case ParameterFault::kUnknownAction: return "use action add, modify, remove or replace";
    case ParameterFault::kExists: return "use action=\"modify\" or \"replace\", or another name";
    case ParameterFault::kNotFound:
      return "write the names below the included model, without the model's own, and the kind of "
             "element that has them";
    case ParameterFault::kOneLetterName:
      return "rename the element in the included model to two letters or more";
    case ParameterFault::kNotInElement:
      return "use action=\"add\", or \"replace\" of the element around it";
    case ParameterFault::kRemovesNothing: return "remove the name of what does not exist";
    default: return {};
  }
}

void check(const read::Fact& fact, Context& context) {
  const ParameterFault fault = fact.parameter_fault;
  const bool inside = fault == ParameterFault::kInInclude;
  context.report({.where = fact.where,
                  .message = "parameter " + fact.name + ": " + fault_of(fault, fact.tried.front()),
                  .help = help_for(fault),
                  .refused = !inside,
                  .why = why_of(fault),
                  .severity = inside ? std::optional(Severity::kInfo) : std::nullopt});
}

Rule rule() {
  return {
      .name = "include-parameter-skipped",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays},
      .formats = Formats::kSdf,
      .summary = "a parameter of an <include> cannot be applied to the included model",
      .why = "libsdformat skips the parameter with an error, which makes the file one that it "
             "rejects: gz sim does not start. The included model stays as it is in its own file.",
      .what_to_do =
          "Name an element that is in the included model: element_id is a path of names below the "
          "model, of action=\"add\" that of the parent. What is added needs a new name; what is "
          "modified must be written in the included file. New elements are read as SDFormat 1.9: "
          "give them their required attributes.",
      .checks = {on_read({read::FactKind::kParameterSkipped}, check)},
  };
}

}  // namespace rigor::rules::include_parameter_skipped
