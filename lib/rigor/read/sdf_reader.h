// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the elements of one SDF file into a `Root`; private to the room. `load.cc` starts it, and it
// starts another of itself for every include.
//
// The file's own version decides what things mean; see "Versions" in docs/architecture.md. Entities
// are appended in document order, so an id never changes.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/model/model.h>
#include <rigor/read/fact.h>
#include <rigor/read/load.h>
#include <rigor/read/values.h>
#include <rigor/xml/document.h>

namespace rigor::read {

/// Includes may nest this deep; real ones go four levels.
inline constexpr std::size_t kMaxIncludeDepth = 32;

/// The includes of a file may bring this many parts, themselves among them, however cleverly they
/// multiply: the largest real world has 30,000, and a million take a gigabyte.
inline constexpr std::size_t kMaxIncludedParts = 200'000;

/// Where something is read into: a model, a world, or the top of a file.
struct Scope {
  model::Id<model::Model> model;
  model::Id<model::World> world;
};

class SdfReader {
 public:
  /// `files` are the paths of the files that lead here, this one last; of an included file, `most` is
  /// how many parts the root may have.
  SdfReader(const Reader& reader, model::Root& root, std::vector<Fact>& facts,
            std::vector<std::string> files, int version, std::size_t most = 0)
      : reader_(reader),
        root_(root),
        facts_(facts),
        files_(std::move(files)),
        version_(version),
        max_(most) {}

  /// Worlds, and the models, actors and lights at the top.
  void read_top(xml::Element sdf);

  /// The first model, actor or light of an included file, as libsdformat chooses.
  model::Id<model::Model> read_included(xml::Element sdf, Scope scope);

 private:
  static model::WorldState read_state(xml::Element element);
  void read_world(xml::Element element);
  model::Id<model::Model> read_model(xml::Element element, Scope scope);
  void read_model_parts(xml::Element element, model::Id<model::Model> id);
  void read_include(xml::Element element, Scope scope);
  const File* file_of(xml::Element element) const;
  bool follow(model::Include& include, xml::Element element, Scope scope);
  const File* with_parameters(const File& file, xml::Element include);
  bool may_follow(const model::Include& include, const std::string& path);
  void override_model(const model::Include& include, std::uint32_t index);
  void read_frame(xml::Element element, Scope scope);
  void read_actor(xml::Element element, Scope scope);
  void read_physics(xml::Element element, Scope scope);
  model::Field<model::Vector3> gravity_of(xml::Element world) const;
  std::optional<Text> step_text(xml::Element physics) const;
  void read_light(xml::Element element, model::Id<model::Link> link);
  void read_plugin(xml::Element element, model::Plugin plugin);

  // sdf_link.cc
  void read_link(xml::Element element, model::Id<model::Model> model);
  model::Inertial read_inertial(xml::Element link) const;
  void read_collision(xml::Element element, model::Id<model::Link> link);
  void read_visual(xml::Element element, model::Id<model::Link> link);

  // sdf_joint.cc
  void read_joint(xml::Element element, Scope scope);
  model::Axis read_axis(xml::Element element) const;

  // sdf_sensor.cc
  void read_sensor(xml::Element element, model::Sensor sensor);

  model::PoseField read_pose(xml::Element parent) const;
  bool is_included() const { return files_.size() > 1; }
  /// The parts read so far, of all files.
  std::size_t parts() const;
  bool fits(const File& file, Span where);
  bool is_full(Span where);
  void tell_too_much(Span where);

  const Reader& reader_;
  model::Root& root_;
  std::vector<Fact>& facts_;
  std::vector<std::string> files_;
  int version_;
  std::size_t brought_ = 0;  ///< parts that the includes of the outermost file brought
  std::size_t max_ = 0;      ///< parts that may have been read when an include ends
};

/// The URI of an `<include>`, as any version writes it.
model::Field<std::string> include_uri(xml::Element include);

/// `<pose>` of what stands in a `<gazebo>` block, or in a camera: six numbers, relative to what it stands in.
model::PoseField read_plain_pose(xml::Element parent);

/// What a `<sensor>` says of itself: its place, pose and plugins are left to the caller (sdf_sensor.cc).
void read_measurement(xml::Element element, model::Sensor& sensor);

/// `<geometry>` of a collision or visual, in any version of SDF or URDF (geometry.cc).
model::Geometry read_geometry(xml::Element parent);

/// The file that including `path`, a file or a model's folder, means; facts say why there is none
/// (load.cc).
const File* open_model(const Reader& reader, const std::string& path, Span where,
                       std::vector<Fact>& facts);

}  // namespace rigor::read
