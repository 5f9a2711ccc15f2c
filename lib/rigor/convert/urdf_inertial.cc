// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include <rigor/convert/urdf_parts.h>
#include <rigor/convert/urdf_take.h>
#include <rigor/convert/urdf_uri.h>
#include <rigor/convert/written_number.h>
#include <rigor/mass/resolve.h>
#include <rigor/model/subject.h>

namespace rigor::convert {
namespace {

std::array<Number, 6> computed_tensor(const mass::Inertia& I) {
  return {Number{I.ixx, {}}, Number{I.ixy, {}}, Number{I.ixz, {}},
          Number{I.iyy, {}}, Number{I.iyz, {}}, Number{I.izz, {}}};
}

class InertialConverter {
 public:
  InertialConverter(UrdfDraft& draft, model::Id<model::Link> id, const model::Pose& X_JL)
      : draft_(draft),
        link_(draft.source.root[id]),
        X_JL_(X_JL),
        taken_(mass::resolve(draft.source.root, draft.source.frames, id, mesh_finder())) {}

  std::optional<UrdfInertial> convert() {
    take_written();
    switch (taken_.taken) {
      case mass::Taken::kNothing: return std::nullopt;
      case mass::Taken::kWritten: return written();
      case mass::Taken::kDefaults:
        tell(NoteKind::kInertialDefault, Outcome::kRewritten, {});
        return computed();
      case mass::Taken::kIdentity:
        tell(NoteKind::kInertialDefault, Outcome::kRewritten, "mass");
        return written();
      case mass::Taken::kAutomatic:
        tell(NoteKind::kInertialAutomatic, Outcome::kRewritten, "auto");
        return computed();
      case mass::Taken::kAutomaticUnknown:
        tell(NoteKind::kInertialAutomatic, Outcome::kLost, "auto");
        return computed();
    }
    return std::nullopt;
  }

 private:
  mass::FindMesh mesh_finder() {
    return [this](const model::Mesh& mesh) -> const mass::MeshSurvey* {
      const auto path = file_of(draft_.source, mesh.uri);
      if (!path) return nullptr;
      if (!surveys_) surveys_.emplace(draft_.source.resolver.disk());
      return &surveys_->find({*path, mesh.submesh.value, mesh.center.value});
    };
  }

  void take_written() {
    const model::Inertial& i = link_.inertial;
    Ledger& ledger = draft_.ledger;
    if (!i.written) return;
    ledger.take(i.site);
    take_pose(draft_.source, ledger, i.pose);
    if (i.tensor_written) ledger.take(i.tensor_site);
    for (const auto* number : {&i.mass, &i.ixx, &i.ixy, &i.ixz, &i.iyy, &i.iyz, &i.izz}) {
      ledger.take(*number);
    }
    ledger.take(i.automatic);
    if (!i.automatic.value) return;
    ledger.take(i.density);
    for (const model::Id<model::Collision> id : link_.collisions) {
      ledger.take(draft_.source.root[id].density);
    }
  }

  void tell(NoteKind kind, Outcome outcome, std::string written) {
    const Span where = link_.inertial.written ? link_.inertial.site.name : link_.site.name;
    draft_.ledger.note({.kind = kind,
                        .outcome = outcome,
                        .where = where,
                        .subject = subject(draft_.source.root, link_),
                        .written = std::move(written),
                        .instead = to_text({taken_.body.mass, {}}) + " kg"});
  }

  /// The tensor stays along the inertial's own axes, which URDF has, too.
  UrdfInertial written() const {
    const model::Inertial& i = link_.inertial;
    const Documents& documents = draft_.source.documents;
    UrdfInertial result{.origin = is_identity(X_JL_) ? written_origin(documents, i.pose)
                                                     : origin_of(compose(X_JL_, i.pose.pose.value)),
                        .mass = written_number(documents, i.mass),
                        .inertia = {}};
    const std::array entries{&i.ixx, &i.ixy, &i.ixz, &i.iyy, &i.iyz, &i.izz};
    for (std::size_t n = 0; n < entries.size(); ++n) {
      result.inertia[n] = written_number(documents, *entries[n]);
    }
    if (taken_.taken == mass::Taken::kIdentity) {
      result.inertia = computed_tensor({1, 0, 0, 1, 0, 1});
    }
    return result;
  }

  /// What was computed is along the axes of the SDF link.
  UrdfInertial computed() const {
    const mass::MassProperties& body = taken_.body;
    return {.origin = origin_of(compose(X_JL_, {body.com, {}})),
            .mass = {body.mass, {}},
            .inertia = computed_tensor(body.about_com)};
  }

  UrdfDraft& draft_;
  const model::Link& link_;
  const model::Pose& X_JL_;
  std::optional<mass::MeshSurveys> surveys_;
  mass::Resolved taken_;
};

}  // namespace

std::optional<UrdfInertial> urdf_inertial(UrdfDraft& draft, model::Id<model::Link> link,
                                          const model::Pose& X_JL) {
  return InertialConverter(draft, link, X_JL).convert();
}

}  // namespace rigor::convert
