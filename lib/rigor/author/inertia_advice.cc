// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/inertia_advice.h>

#include <algorithm>

#include <rigor/mass/mesh/survey.h>

namespace rigor::author {
namespace {

/// `model` is what is to be named to `rigor inertia`.
std::string inertia_to_compare(const std::string& model) {
  return "compare its inertia with that of its CAD model; `rigor inertia " + model +
         " --only all --diff` shows what its shapes would give";
}

constexpr const char* kInertiaByHand =
    "take its inertia from its CAD model: its shapes do not give one";
constexpr const char* kInertiaOfTemplate =
    "correct its inertia in the template; `rigor inertia MODEL` shows what its shapes give";

}  // namespace

std::string InertiaAdvice::help(Span link) {
  if (main_.file->expanded) return kInertiaOfTemplate;
  if (link.nowhere() || link.source == main_.root.source) return help_in(main_, link, "MODEL");
  const std::string path = included_path(link);
  const auto [known, is_new] = included_.try_emplace(path);
  if (is_new) known->second = load(path);
  if (!known->second.file->document) return kInertiaByHand;
  if (known->second.file->expanded) return kInertiaOfTemplate;
  const std::string help = help_in(known->second, link, path);
  return help.empty() ? "run `rigor inertia " + path + " --write`: the link is in that file" : help;
}

/// Without what parameters of an include have made of it (read/include_parameters.h).
std::string InertiaAdvice::included_path(Span link) const {
  const std::string path(sources_.path(link.source));
  const std::size_t parameters = path.rfind('#');
  return workspace_.disk().kind(path) == PathKind::kFile ? path : path.substr(0, parameters);
}

read::Loaded InertiaAdvice::load(const std::string& path) const {
  const read::Reader reader{workspace_, environment_.resolver, environment_.sdf, environment_.urdf};
  return read::load(reader, workspace_.open(path));
}

const ModelInertia& InertiaAdvice::table(const read::Loaded& loaded) {
  const auto known = tables_.find(loaded.file);
  if (known != tables_.end()) return known->second;
  mass::MeshSurveys surveys(environment_.disk, {.workers = &environment_.workers});
  return tables_.emplace(loaded.file, model_inertia(environment_, sources_, loaded, surveys, {}))
      .first->second;
}

/// `model` is what is to be named to `rigor inertia`.
std::string InertiaAdvice::help_in(const read::Loaded& loaded, Span link,
                                   const std::string& model) {
  const auto& links = table(loaded).links;
  const auto row = std::find_if(links.begin(), links.end(), [&](const LinkInertia& one) {
    const model::Field<std::string>& name = loaded.root[one.link].name;
    return name.span == link || (is_changed_copy(link) && name.value == text(link));
  });
  const bool known = row != links.end();
  if (known && row->chosen) return {};
  return known && row->computed ? inertia_to_compare(model) : kInertiaByHand;
}

bool InertiaAdvice::is_changed_copy(Span link) const {
  return link.source != main_.root.source && included_path(link) != sources_.path(link.source);
}

std::string_view InertiaAdvice::text(Span where) const {
  return sources_.bytes(where.source).substr(where.begin, where.size());
}

}  // namespace rigor::author
