// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a verb of `rigor edit` works on: one model of a file, as elements in its bytes, as a model, and as the robot
// that it is.
//
//   ModelReader reader(environment, sources);
//   const auto model = reader.open("robot.urdf");
//   if (model) use(model->robot, model->document());
//
// Verbs are pure: they read an EditedModel and return a Change (change.h), which `prove` holds against the edited bytes.

#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/mass/mesh/survey.h>
#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/robot/robot.h>
#include <rigor/rules/environment.h>
#include <rigor/text/sources.h>
#include <rigor/xml/document.h>

namespace rigor::author {

/// A file's model, whole. Views of the reader that opened it, which outlives it.
struct EditedModel {
  EditedModel(read::Workspace& workspace, const Environment& environment, Sources& sources,
              read::Loaded loaded, model::Id<model::Model> model, mass::FindMesh find_mesh);
  EditedModel(const EditedModel&) = delete;
  EditedModel& operator=(const EditedModel&) = delete;

  read::Workspace& workspace;
  const Environment& environment;
  Sources& sources;
  read::Loaded loaded;
  model::Frames frames;           ///< at rest
  model::Id<model::Model> model;  ///< the one that is changed
  mass::FindMesh find_mesh;       ///< what automatic inertials are computed with
  robot::Robot robot;             ///< of that one

  const xml::Document& document() const { return *loaded.file->document; }
  const model::Root& root() const { return loaded.root; }
  const std::string& path() const { return loaded.file->path; }
  bool is_urdf() const { return root()[model].format == model::Format::kUrdf; }
  xml::Element element(const model::Site& site) const { return document().element(site.element); }

  /// Whether the entity's model is the one that is changed, or nested in it.
  bool inside(model::Id<model::Model> id) const;

  /// The robot that it would be with other values in the place of some of the root's.
  robot::Robot robot_with(const model::Root& changed) const;

  /// By the name it has inside the model ("hand::palm"); none when there is none, or it is in another model.
  model::Id<model::Link> link(std::string_view name) const;
  model::Id<model::Joint> joint(std::string_view name) const;
  model::Id<model::Frame> frame(std::string_view name) const;

  /// The index in the robot's bodies or joints; kNoIndex when there is none.
  std::uint32_t body_index(std::string_view name) const;
  std::uint32_t joint_index(std::string_view name) const;

  /// The name that the robot has for it: scoped inside the model.
  std::string name_of(model::Id<model::Link> id) const;
  std::string name_of(model::Id<model::Joint> id) const;
  std::string name_of(model::Id<model::Frame> id) const;
};

/// Behind the path of a file.
inline constexpr std::string_view kMjcfNotEdited =
    " is MJCF, which is not edited: convert it with mjcf2urdf or mjcf2sdf";

/// What a file's model is, or why it cannot be edited.
struct OpenedModel {
  std::unique_ptr<EditedModel> model;
  std::string problem;  ///< why there is none: "robot.urdf is not well-formed"
};

class ModelReader {
 public:
  ModelReader(const Environment& environment, Sources& sources);
  ~ModelReader();

  /// The model of that name; of a file with one model that one, whatever it is called.
  OpenedModel open(const std::string& path, const std::string& model = {});

  /// The same with other bytes in the place of what files hold, by their paths.
  OpenedModel open_changed(const std::string& path, const std::string& model,
                           const std::map<std::string, std::string>& texts);

  read::Workspace& workspace() { return workspace_; }

 private:
  OpenedModel opened(read::Workspace& workspace, const read::File& file, const std::string& model);

  const Environment& environment_;
  Sources& sources_;
  mass::MeshSurveys surveys_;
  read::Workspace workspace_;
  std::vector<std::unique_ptr<read::Workspace>> changed_;
};

}  // namespace rigor::author
