// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/read/values.h>
#include <rigor/rules/inertia/solid_body.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/misspelt.h>

namespace rigor::rules::mass_not_written {

// A tensor that is within this factor of what 1 kg has in the link's shapes was made for 1 kg.
constexpr double kFits = 2;

bool is_made_for_one_kilogram(const model::Link& link, Context& context) {
  if (!has_tensor(link, context)) return false;
  const auto share = share_of_solid(link, 1, mass::tensor(link.inertial), context);
  return share && *share<kFits&& * share> 1 / kFits;
}

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (!inertial.written || inertial.mass.written || mass::is_automatic(link)) return;
  if (!is_dynamic(link, context)) return;
  if (misspelt_child(context.element(inertial.site), "mass", context)) return;  // unknown-element
  // One that cannot be read is reported by the schema's rules.
  const xml::Element element = context.element(inertial.site);
  const auto child = element.child("mass");
  const bool empty = child && child->attributes().empty() && read::trimmed(child->text()).empty();
  if ((child && !empty) || element.attribute("mass")) return;
  if (!empty && is_made_for_one_kilogram(link, context)) return;
  const char* tensor = inertial.tensor_written ? "" : ", with a moment of 1 kg·m² about every axis";
  context.report(
      {.where = empty ? child->name_span() : inertial.site.name,
       .message = fmt::format("the {}: it is taken to be 1 kg{}",
                              empty ? "<mass> is empty" : "<inertial> has no <mass>", tensor),
       .subject = context.subject(link)});
}

Rule rule() {
  return {
      .name = "mass-not-written",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "an <inertial> has no mass",
      .why = "SDF then takes 1 kg, which no checker mentions, and which fits neither the tensor "
             "nor the body.",
      .what_to_do = "Write the mass in kilograms. `rigor inertia MODEL --mass LINK=KG --write` "
                    "computes a tensor that fits.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::mass_not_written
