// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/roots.h>

#include <algorithm>
#include <string>

#include <rigor/convert/written_number.h>
#include <rigor/model/subject.h>

namespace rigor::convert {
namespace {

using model::Id;

/// A list of roots is cut here: more would not be read.
constexpr std::size_t kMaxRootsReported = 12;

std::string end_text(const std::string& name, const char* which) {
  return name.empty() ? std::string("it has no ") + which : std::string(which) + " " + name;
}

}  // namespace

UrdfRoots urdf_roots(const Source& source, const UrdfOptions& options, const UrdfTree& tree) {
  UrdfRoots roots;
  if (tree.links.empty()) return roots;
  const Id<model::Model> model = tree.models.front();
  const auto X_WM = source.frames.pose(model);
  roots.has_model_pose =
      options.model_pose == ModelPosePolicy::kWorldLink && X_WM && !is_identity(*X_WM);
  const bool several = tree.roots.size() + (tree.on_world ? 1 : 0) > 1;
  roots.is_static = model::is_static(source.root, model) && !tree.roots.empty() &&
                    (several || options.static_model == StaticPolicy::kWorldLink);
  if (tree.on_world && !several) {
    roots.kind = UrdfRoots::Kind::kWorld;
  } else if (roots.is_static || roots.has_model_pose) {
    roots.kind = UrdfRoots::Kind::kWorld;
  } else if (!several && options.root.empty()) {
    roots.kind = UrdfRoots::Kind::kLink;
  } else if (!several || options.roots == RootPolicy::kAddRoot) {
    roots.kind = tree.on_world ? UrdfRoots::Kind::kWorld : UrdfRoots::Kind::kAdded;
  }
  return roots;
}

Note note_on_roots(const Source& source, const UrdfTree& tree) {
  const model::Model& model = source.root[tree.models.front()];
  Note note{.kind = NoteKind::kSeveralRoots,
            .where = model.site.name,
            .subject = model::subject(source.root, model),
            .count = tree.roots.size()};
  if (tree.links.empty()) {
    note.kind = NoteKind::kNoModel;
    note.written = "with links";
    note.count = 1;
    return note;
  }
  std::string names;
  for (std::size_t i = 0; i < std::min(tree.roots.size(), kMaxRootsReported); ++i) {
    names += (i == 0 ? "" : ", ") + model::name_in(source.root, tree.models.front(), tree.roots[i]);
  }
  if (tree.roots.size() > kMaxRootsReported) names += ", …";
  if (tree.on_world) names += " (others are joined to the world)";
  note.written = names;
  return note;
}

Note note_on(const Source& source, const UrdfTree& tree, const UrdfTree::LeftOut& left_out) {
  const model::Joint& joint = source.root[left_out.joint];
  Note note{.kind = NoteKind::kDanglingJoint,
            .where = joint.site.name,
            .subject = model::subject(source.root, joint)};
  const model::Frames::Ends& ends = source.frames.ends(left_out.joint);
  switch (left_out.flaw) {
    case UrdfTree::Flaw::kDangling:
      note.written = ends.parent && ends.parent == ends.child
                         ? "parent and child are one link"
                         : end_text(joint.parent.value, "parent") + ", " +
                               end_text(joint.child.value, "child");
      break;
    case UrdfTree::Flaw::kSecondParent:
      note.kind = NoteKind::kLoop;
      note.where = joint.child.written ? joint.child.span : note.where;
      note.written = model::name_in(source.root, tree.models.front(), ends.child);
      note.instead = source.root[left_out.carrier].name.value;
      break;
    case UrdfTree::Flaw::kCycle:
      note.kind = NoteKind::kNoRoot;
      note.written = "joint " + joint.name.value + " leads back to " +
                     model::name_in(source.root, tree.models.front(), ends.child);
      break;
  }
  return note;
}

}  // namespace rigor::convert
