// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/convert/comments.h>
#include <rigor/convert/urdf/draft.h>
#include <rigor/convert/urdf/material.h>
#include <rigor/convert/urdf/parts.h>
#include <rigor/convert/urdf/shape.h>
#include <rigor/convert/urdf/shape_file.h>
#include <rigor/convert/urdf/subtree.h>
#include <rigor/convert/urdf/surface.h>
#include <rigor/convert/urdf/take.h>
#include <rigor/convert/written_number.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>

namespace rigor::convert {
namespace {

using model::Id;
using model::Pose;

class LinkConverter {
 public:
  LinkConverter(UrdfDraft& draft, Id<model::Link> id, const Pose& X_JL)
      : draft_(draft), root_(draft.source.root), id_(id), X_JL_(X_JL) {}

  UrdfLink convert() {
    const model::Link& link = root_[id_];
    draft_.ledger.take(link.site);
    draft_.ledger.take(link.name);
    result_.name = draft_.link_names.at(id_);
    result_.inertial = urdf_inertial(draft_, id_, X_JL_);
    if (result_.inertial) result_.inertial->comments = comments_on(link.inertial.site);
    PartKeys keys{.script = common_script(draft_.source, link), .surface = {}};
    for (const Id<model::Visual> id : link.visuals) add_visual(id, keys.script);
    for (const Id<model::Collision> id : link.collisions) add_collision(id);
    keys.surface = surface_lines(draft_, id_, collisions_);
    if (!keys.script.empty()) rename_parts(result_.visuals, visuals_);
    if (!keys.surface.empty()) rename_parts(result_.collisions, collisions_);
    add_link_blocks(draft_, id_, X_JL_, keys);
    return std::move(result_);
  }

 private:
  void add_visual(Id<model::Visual> id, const std::string& script) {
    const model::Visual& visual = root_[id];
    const std::string whose = subject(root_, visual);
    const auto shapes = urdf_shapes(draft_, visual.geometry, whose);
    if (shapes.empty()) return lose(visual.site, visual.geometry, whose);
    visuals_.push_back(id);
    const std::size_t first = result_.visuals.size();
    const std::string material = urdf_material(draft_, visual, script);
    for (const auto& [name, origin, shape] :
         placed(visual, shapes, draft_.source.frames.pose(id))) {
      result_.visuals.push_back(
          {.name = name, .origin = origin, .geometry = shape->geometry, .material = material});
    }
    result_.visuals[first].comments = comments_on(visual.site);
    tell_extras(visual, whose, material);
  }

  void add_collision(Id<model::Collision> id) {
    const model::Collision& collision = root_[id];
    const std::string whose = subject(root_, collision);
    const auto shapes = urdf_shapes(draft_, collision.geometry, whose);
    if (shapes.empty()) {
      return lose(collision.site, collision.geometry, whose, NoteKind::kCollisionLost);
    }
    collisions_.push_back(id);
    const std::size_t first = result_.collisions.size();
    for (const auto& [name, origin, shape] :
         placed(collision, shapes, draft_.source.frames.pose(id))) {
      result_.collisions.push_back({.name = name, .origin = origin, .geometry = shape->geometry});
    }
    result_.collisions[first].comments = comments_on(collision.site);
  }

  Remarks comments_on(const model::Site& site) const {
    return remarks_on(draft_.source.documents, site, CommentsFor::kUrdf);
  }

  struct Placed {
    std::string name;
    UrdfOrigin origin;
    const UrdfShape* shape;
  };

  /// The parts of a visual or collision; its name and pose are taken.
  template <class Part>
  std::vector<Placed> placed(const Part& part, const std::vector<UrdfShape>& shapes,
                             const std::optional<Pose>& X_WP) {
    draft_.ledger.take(part.site);
    draft_.ledger.take(part.name);
    const UrdfOrigin origin = origin_in_link(draft_, id_, X_JL_, part.pose, X_WP);
    std::vector<Placed> result;
    for (const UrdfShape& shape : shapes) {
      const bool moved = !is_identity(shape.X_VS);
      result.push_back({part.name.value + shape.suffix,
                        moved ? origin_of(compose(pose_of(origin), shape.X_VS)) : origin, &shape});
    }
    return result;
  }

  /// Gazebo's reader (libsdformat 12.3, measured) gives what the block says to the visuals and
  /// collisions whose names begin with the link's, or that have none: others it takes for those of
  /// a link that was lumped into this one, and drops friction and material without a word.
  template <class Part, class Written>
  void rename_parts(std::vector<Part>& parts, const std::vector<Id<Written>>& written) {
    const auto is_found = [this](const std::string& name) {
      return name.empty() || name.starts_with(result_.name);
    };
    for (Part& part : parts) {
      if (!is_found(part.name)) part.name = result_.name + '_' + part.name;
    }
    for (const Id<Written> id : written) {
      const model::Field<std::string>& name = root_[id].name;
      if (is_found(name.value)) continue;
      draft_.ledger.take(name, Outcome::kRewritten);
      draft_.ledger.note({.kind = NoteKind::kRenamed,
                          .outcome = Outcome::kRewritten,
                          .where = name.span,
                          .subject = subject(root_, root_[id]),
                          .written = name.value,
                          .instead = result_.name + '_' + name.value});
    }
  }

  void lose(const model::Site& site, const model::Geometry& geometry, const std::string& whose,
            NoteKind kind = NoteKind::kShapeLost) {
    if (std::holds_alternative<model::NoShape>(geometry.shape) && geometry.explicitly_empty) {
      draft_.ledger.take_all(site, Outcome::kImplied);
      return;
    }
    const auto* mesh = std::get_if<model::Mesh>(&geometry.shape);
    const bool part = mesh != nullptr && !mesh->submesh.value.empty();
    if (part && kind == NoteKind::kShapeLost) kind = NoteKind::kSubmesh;
    // Of a shape that no reader knows nothing was touched before.
    if (std::holds_alternative<model::NoShape>(geometry.shape)) kind = NoteKind::kShapeLost;
    draft_.ledger.lose(site, {.kind = kind,
                              .outcome = Outcome::kLost,
                              .where = geometry.written ? geometry.site.name : site.name,
                              .subject = whose,
                              .written = part ? "submesh " + mesh->submesh.value
                                              : std::string(shape_name(geometry.shape)),
                              .instead = why_no_shape_file(draft_, geometry)});
  }

  /// A transparency without a color has nothing to act on.
  void tell_extras(const model::Visual& visual, const std::string& whose,
                   const std::string& material) {
    LostChildren lost(draft_, visual.site);
    for (const xml::Element child : draft_.source.documents.element(visual.site).children()) {
      const std::string_view name = child.name();
      if (name == "cast_shadows" || name == "laser_retro" || name == "visibility_flags" ||
          name == "meta" || (name == "transparency" && material.empty())) {
        lost.add(child);
      }
    }
    lost.tell(NoteKind::kVisualExtra, whose);
  }

  UrdfDraft& draft_;
  const model::Root& root_;
  Id<model::Link> id_;
  const Pose& X_JL_;
  UrdfLink result_;
  std::vector<Id<model::Visual>> visuals_;  // that were converted
  std::vector<Id<model::Collision>> collisions_;
};

}  // namespace

UrdfOrigin origin_in_link(UrdfDraft& draft, Id<model::Link> id, const Pose& X_JL,
                          const model::PoseField& pose, const std::optional<Pose>& X_WP) {
  take_pose(draft.source, draft.ledger, pose);
  const std::string& base = pose.relative_to.value;
  const auto X_WL = draft.source.frames.pose(id);
  const bool in_link = base.empty() || base == draft.source.root[id].name.value;
  if (in_link && is_identity(X_JL)) return written_origin(draft.source.documents, pose);
  const Pose X_LP = in_link || !X_WL || !X_WP ? pose.pose.value : compose(inverse(*X_WL), *X_WP);
  return origin_of(compose(X_JL, X_LP));
}

UrdfLink urdf_link(UrdfDraft& draft, Id<model::Link> link, const Pose& X_JL) {
  return LinkConverter(draft, link, X_JL).convert();
}

}  // namespace rigor::convert
