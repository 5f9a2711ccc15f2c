// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include <rigor/convert/urdf/parts.h>
#include <rigor/convert/urdf/take.h>
#include <rigor/convert/urdf/uri.h>
#include <rigor/convert/written_number.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/mass/resolve.h>
#include <rigor/model/subject.h>

namespace rigor::convert {
namespace {

/// kg. libsdformat takes less for 0 where it reads URDF: `equal(mass, 0.0)` of its mathematics library.
constexpr double kMinMassInGazebo = 1e-6;

class InertialConverter {
 public:
  InertialConverter(UrdfDraft& draft, model::Id<model::Link> id, const model::Pose& X_JL)
      : draft_(draft),
        link_(draft.source.root[id]),
        X_JL_(X_JL),
        taken_(mass::resolve(draft.source.root, draft.source.frames, id, mesh_finder())) {}

  std::optional<UrdfInertial> convert() {
    std::optional<UrdfInertial> result = inertial();
    if (result && result->mass.value > 0 && result->mass.value < kMinMassInGazebo) {
      draft_.ledger.note(
          {.kind = NoteKind::kTinyMass,
           .outcome = Outcome::kConverted,
           .where = link_.inertial.mass.written ? link_.inertial.mass.span : link_.site.name,
           .subject = subject(draft_.source.root, link_),
           .written = to_text(result->mass)});
    }
    return result;
  }

 private:
  std::optional<UrdfInertial> inertial() {
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
        pass_over_overridden();
        tell(NoteKind::kInertialAutomatic, Outcome::kRewritten, "auto");
        return computed();
      case mass::Taken::kAutomaticUnknown:
        pass_over_overridden();
        draft_.ledger.take(link_.inertial.mass, Outcome::kLost);
        tell(NoteKind::kInertialAutomatic, Outcome::kLost, "auto");
        return computed();
    }
    return std::nullopt;
  }

  mass::FindMesh mesh_finder() {
    return [this](const model::Mesh& mesh) -> const mass::MeshSurvey* {
      const auto path = file_of(draft_.source, mesh.uri);
      if (!path) return nullptr;
      if (!surveys_)
        surveys_.emplace(draft_.source.resolver.disk(),
                         mass::MeshMemory{.workers = &draft_.source.workers});
      return &surveys_->find({*path, mesh.submesh.value, mesh.center.value});
    };
  }

  void take_written() {
    const model::Inertial& i = link_.inertial;
    Ledger& ledger = draft_.ledger;
    if (!i.written) return;
    ledger.take(i.site);
    ledger.take(i.mass);
    ledger.take(i.automatic);
    if (i.automatic.value) return take_densities();
    model::PoseField pose = i.pose;
    pose.relative_to = {};  // that of an inertial is always in its link
    take_pose(draft_.source, ledger, pose);
    if (i.tensor_written) ledger.take(i.tensor_site);
    for (const auto* number : {&i.ixx, &i.ixy, &i.ixz, &i.iyy, &i.iyz, &i.izz}) {
      ledger.take(*number);
    }
  }

  /// Where the mass is written only its distribution is computed: one density counts for nothing.
  void take_densities() {
    const auto take = [this](const model::Field<double>& density) {
      if (!link_.inertial.mass.written || link_.collisions.size() > 1) {
        return draft_.ledger.take(density);
      }
      if (!density.written) return;
      draft_.ledger.pass_over_value(density.span, subject(draft_.source.root, link_),
                                    "density of an automatic inertial whose mass is written");
    };
    take(link_.inertial.density);
    for (const model::Id<model::Collision> id : link_.collisions) {
      take(draft_.source.root[id].density);
    }
  }

  /// What is computed from the collisions instead.
  void pass_over_overridden() {
    const model::Inertial& i = link_.inertial;
    const std::string whose = subject(draft_.source.root, link_);
    const auto pass_over = [&](const model::Site& site) {
      const xml::Element element = draft_.source.documents.element(site);
      draft_.ledger.pass_over(element, whose,
                              std::string(element.name()) + " of an automatic inertial");
    };
    if (i.tensor_written) pass_over(i.tensor_site);
    if (!i.pose.site.span.nowhere()) pass_over(i.pose.site);
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
    const read::Documents& documents = draft_.source.documents;
    UrdfInertial result{.origin = is_identity(X_JL_) ? written_origin(documents, i.pose)
                                                     : origin_of(compose(X_JL_, i.pose.pose.value)),
                        .mass = written_number(documents, i.mass),
                        .inertia = {}};
    const std::array entries{&i.ixx, &i.ixy, &i.ixz, &i.iyy, &i.iyz, &i.izz};
    for (std::size_t n = 0; n < entries.size(); ++n) {
      result.inertia[n] = written_number(documents, *entries[n]);
    }
    if (taken_.taken == mass::Taken::kIdentity) {
      result.inertia = tensor_entries({1, 0, 0, 1, 0, 1});
    }
    return result;
  }

  /// What was computed is along the axes of the SDF link.
  UrdfInertial computed() const {
    const mass::MassProperties& body = taken_.body;
    return {.origin = origin_of(compose(X_JL_, {body.com, {}})),
            .mass = {body.mass, {}},
            .inertia = tensor_entries(body.about_com)};
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
