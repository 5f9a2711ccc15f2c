// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An MJCF file in the making; private to the room. `to_mjcf` decides on models and tree; what a body and a
// joint hold is converted here, part by part.

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <rigor/convert/ledger.h>
#include <rigor/convert/mjcf/assembly.h>
#include <rigor/convert/mjcf/contact.h>
#include <rigor/convert/mjcf/element.h>
#include <rigor/convert/to_mjcf.h>
#include <rigor/mesh/read.h>
#include <rigor/model/unique_names.h>
#include <rigor/robot/look.h>

namespace rigor::convert {

/// Entities of the source by the start tag that a body, joint or part of a robot names. One that is
/// included twice is there once: it is written once.
class MjcfEntities {
 public:
  explicit MjcfEntities(const model::Root& root);

  const model::Link* link(Span tag) const { return find(links_, tag); }
  const model::Joint* joint(Span tag) const { return find(joints_, tag); }
  const model::Collision* collision(Span tag) const { return find(collisions_, tag); }
  const model::Visual* visual(Span tag) const { return find(visuals_, tag); }

 private:
  using Key = std::pair<SourceId, std::uint32_t>;
  static Key key(Span tag) { return {tag.source, tag.begin}; }
  template <class T>
  static const T* find(const std::map<Key, const T*>& map, Span tag) {
    const auto found = map.find(key(tag));
    return tag.nowhere() || found == map.end() ? nullptr : found->second;
  }

  std::map<Key, const model::Link*> links_;
  std::map<Key, const model::Joint*> joints_;
  std::map<Key, const model::Collision*> collisions_;
  std::map<Key, const model::Visual*> visuals_;
};

inline constexpr std::string_view kMjcfAssetFolder = "assets/";

struct MjcfDraft {
  const MjcfSource& source;
  const MjcfOptions& options;
  Ledger& ledger;
  const MjcfAssembly& assembly;
  MjcfEntities entities;
  std::vector<bool> fixed;  ///< bodies that never move
  MjcfModelBits model_bits;

  MjcfElement asset{"asset"}, equality{"equality"}, actuator{"actuator"}, sensor{"sensor"};
  std::vector<SideFile> files;
  /// Of each joint of the robot: a name for each of its axes; one of a ball or a free joint.
  std::vector<std::vector<std::string>> joint_names;
  double next_to_nothing = 0;  ///< kg

  std::map<std::string, model::UniqueNames, std::less<>> names = {};  ///< by kind: "geom"
  std::map<std::string, std::string> mesh_names = {};  ///< of what was written, by what it holds
  std::map<std::string, std::vector<std::string>> group_files =
      {};  ///< likewise, one for each look
  std::map<std::string, std::shared_ptr<const mesh::TriangleMesh>> outlines = {};
  std::map<std::string, std::string> material_names = {};           ///< by name, color and texture
  std::map<std::string, std::string> texture_names = {};            ///< by type and picture
  std::set<std::pair<SourceId, std::uint32_t>> told_pictures = {};  ///< elements, by their begin
  /// What the last mesh file holds: another visual or a collision may be of it.
  std::string mesh_path = {};
  std::shared_ptr<const mesh::LoadedMesh> mesh = nullptr;

  const model::Root& root() const { return source.source.root; }
  const robot::Robot& robot() const { return assembly.robot; }
  /// Of one of the root's visuals; none where nobody was given who finds them.
  std::vector<robot::Look> looks_of(const model::Visual& visual,
                                    const mesh::TriangleMesh& shape) const;
  /// The name, or one with a number behind it where an element of that kind has it.
  std::string name_for(std::string_view kind, const std::string& name);
};

// --- bodies ---

/// Its inertial element; nothing for a body without mass that a parent carries.
std::vector<MjcfElement> mjcf_inertial(MjcfDraft& draft, std::uint32_t body);

/// What the assembly did to inertias.
void tell_moved_inertias(MjcfDraft& draft);

/// The joints by which it hangs on its parent.
std::vector<MjcfElement> mjcf_joints(MjcfDraft& draft, std::uint32_t joint);

/// Collisions and visuals.
std::vector<MjcfElement> mjcf_geoms(MjcfDraft& draft, std::uint32_t body);

/// Sites, cameras and the sensors on them: of the sensors of its link, and of the joint that carries it.
std::vector<MjcfElement> mjcf_sensors(MjcfDraft& draft, std::uint32_t body);

// --- what refers to joints ---

/// Mimic joints, screws, joints that cannot move, and loops.
void add_mjcf_equalities(MjcfDraft& draft);

void add_mjcf_actuators(MjcfDraft& draft);

/// Names of the joints' degrees, for all of them.
std::vector<std::vector<std::string>> mjcf_joint_names(MjcfDraft& draft);

/// rad or m: what is given by the name of a joint, else 0, or the limit that is next to it; what follows is
/// where its leader puts it.
robot::Positions home_positions(const robot::Robot& robot,
                                const std::map<std::string, double>& given);

// --- the account ---

/// Takes what every model, link and joint says of itself in the words that MJCF has; what else they say is
/// lost when the account is closed.
void take_mjcf_model(MjcfDraft& draft, model::Id<model::Model> model);
void take_mjcf_joint(MjcfDraft& draft, const model::Joint& joint);

/// The note's kind for an element that no code took.
NoteKind mjcf_kind_of(xml::Element element);

/// A mesh asset, and how it looks where the source says so.
struct MjcfMesh {
  std::string name;
  std::optional<robot::Look> look = std::nullopt;
  std::string material = {};  ///< what the mesh's file calls it
};

/// What represents a shape which MuJoCo has as a mesh: one, or one for each look of a visual. None when it cannot be,
/// with a note.
std::vector<MjcfMesh> mjcf_meshes(MjcfDraft& draft, const robot::Part& part,
                                  const model::Visual* visual, const std::string& subject,
                                  Span where);

}  // namespace rigor::convert
