// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/take.h>

#include <cstddef>
#include <string>
#include <string_view>

#include <rigor/model/subject.h>
#include <rigor/read/include_parameters.h>
#include <rigor/read/values.h>
#include <rigor/read/workspace.h>

namespace rigor::convert {
namespace {

void take_attribute(Ledger& ledger, xml::Element element, std::string_view name,
                    Outcome outcome = Outcome::kConverted) {
  if (const auto attribute = element.attribute(name)) {
    ledger.take_value(attribute->value_span(), outcome);
  }
}

void take_overridden(Ledger& ledger, xml::Element model, std::string_view name) {
  if (const auto child = model.child(name)) ledger.take_all(*child, Outcome::kImplied);
}

bool does_not_exist(read::ParameterFault fault) {
  return fault == read::ParameterFault::kNotFound || fault == read::ParameterFault::kInInclude ||
         fault == read::ParameterFault::kNotInElement ||
         fault == read::ParameterFault::kRemovesNothing;
}

/// The model was read with them done, but for what libsdformat skips.
void take_parameters(const Source& source, Ledger& ledger, const model::Include& include,
                     const std::string& subject) {
  const xml::Element element = source.documents.element(include.site);
  const auto parameters = element.child("experimental:params");
  if (!parameters) return;
  const ReadResult file = source.resolver.disk().read(include.path, read::kMaxModelBytes);
  if (file.bytes) {
    const xml::Document included = xml::parse(*file.bytes, {});
    const auto& document = source.documents.of(element.name_span().source);
    const auto changes = read::with_include_parameters(included, document, element, source.schema);
    for (const read::SkippedParameter& skipped : changes.skipped) {
      ledger.lose(read::site_of(skipped.element),
                  {.where = skipped.element.name_span(),
                   .subject = subject,
                   .written = "experimental:params/" + std::string(skipped.element.name()) +
                              (does_not_exist(skipped.fault) ? ", which does not exist,"
                                                             : ", which libsdformat skips,")});
    }
  }
  ledger.take(*parameters);
  std::size_t count = 0;
  for (const xml::Element parameter : parameters->children()) {
    if (++count > read::kMaxIncludeParameters) return;
    ledger.take_all(parameter);
  }
}

void take_include(const Source& source, Ledger& ledger, const model::Include& include,
                  xml::Element model, const std::string& subject) {
  ledger.take(include.site);
  take_parameters(source, ledger, include, subject);
  ledger.take(include.uri);
  ledger.take(include.name);
  ledger.take(include.merge);
  if (!include.pose.site.span.nowhere()) take_overridden(ledger, model, "pose");
  if (include.is_static.written) take_overridden(ledger, model, "static");
  if (include.placement_frame.written) {
    take_attribute(ledger, model, "placement_frame", Outcome::kImplied);
  }
}

}  // namespace

void take_pose(const Source& source, Ledger& ledger, const model::PoseField& pose,
               Outcome outcome) {
  if (pose.site.span.nowhere() || !pose.pose.written) return;
  ledger.take(pose.site, outcome);
  ledger.take(pose.pose, outcome);
  ledger.take(pose.relative_to, outcome);
  const xml::Element element = source.documents.element(pose.site);
  take_attribute(ledger, element, "rotation_format", outcome);
  take_attribute(ledger, element, "degrees", outcome);
}

void take_model(const Source& source, Ledger& ledger, model::Id<model::Model> id) {
  const model::Root& root = source.root;
  const model::Model& model = root[id];
  const xml::Element element = source.documents.element(model.site);
  if (model.include < root.includes.size()) {
    const model::Include& include = root.includes[model.include];
    const std::string subject = model::subject(root, model);
    ledger.open(include.site, subject);
    take_include(source, ledger, include, element, subject);
  }
  ledger.open(model.site, model::subject(root, model));
  ledger.take(model.site);
  take_attribute(ledger, element, "name");
}

}  // namespace rigor::convert
