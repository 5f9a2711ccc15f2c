// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/convert/sdf/draft.h>
#include <rigor/convert/urdf/uri.h>

namespace rigor::convert {
namespace {

std::string sdf_uri_with_scheme(std::string_view scheme, std::string_view uri,
                                const std::string& name) {
  std::string_view rest = uri.substr(uri.find("://") + 3);
  std::string result = std::string(scheme) + "://";
  if (name.empty()) return result.append(rest);
  rest.remove_prefix(std::min(rest.find('/'), rest.size()));
  return result.append(name).append(rest);
}

std::string sdf_uri_by_policy(const Source& source, const SdfMeshUri& policy,
                              const std::string& uri, const std::optional<std::string>& file) {
  const std::string_view scheme = std::string_view(uri).substr(0, uri.find("://"));
  const bool named = scheme == "package" || scheme == "model";
  switch (policy.kind) {
    case SdfMeshUri::Kind::kKeep: return uri;
    case SdfMeshUri::Kind::kFile: return file ? file_uri(source, *file).value_or(uri) : uri;
    case SdfMeshUri::Kind::kModel:
      return named ? sdf_uri_with_scheme("model", uri, policy.name) : uri;
    case SdfMeshUri::Kind::kPackage:
      return named ? sdf_uri_with_scheme("package", uri, policy.name) : uri;
  }
  return uri;
}

}  // namespace

std::string sdf_uri(SdfDraft& draft, const model::Field<std::string>& uri,
                    const std::string& subject) {
  const auto file = file_of(draft.source, uri);
  const SdfMeshUri& policy = draft.options.mesh_uri;
  PlacedUri placed{sdf_uri_by_policy(draft.source, policy, uri.value, file)};
  if (file) {
    const bool chosen = policy.kind == SdfMeshUri::Kind::kKeep || !policy.name.empty();
    placed = placed_uri(draft.source, std::move(placed.uri), *file,
                        chosen ? UriChoice::kUsers : UriChoice::kOurs);
  }
  const std::string& result = placed.uri;
  const auto tell = [&](NoteKind kind, Outcome outcome) {
    draft.ledger.take(uri, outcome);
    draft.ledger.note({.kind = kind,
                       .outcome = outcome,
                       .where = uri.span,
                       .subject = subject,
                       .written = uri.value,
                       .instead = result});
  };
  if (result != uri.value) tell(NoteKind::kUri, Outcome::kRewritten);
  const bool remote = uri.value.find("http") == 0;
  if (!file && !remote) tell(NoteKind::kUriNotFound, Outcome::kConverted);
  if (!placed.found) tell(NoteKind::kUriElsewhere, Outcome::kConverted);
  draft.ledger.take(uri);
  return result;
}

}  // namespace rigor::convert
