// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An SDF file, with those that it includes, converted to URDF, for tests.

#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/convert/urdf/robot.h>
#include <rigor/model/frames.h>
#include <rigor/read/documents.h>
#include <rigor/read/load.h>
#include <rigor/read/resolver.h>
#include <rigor/read/workspace.h>
#include <rigor/schema/embedded.h>
#include <rigor/schema/schema.h>
#include <rigor/text/disk.h>
#include <rigor/text/sources.h>

#include "support/workers.h"

namespace rigor::test {

inline const schema::Schema& sdf_schema() {
  static const auto parsed = schema::Schema::parse(schema::sdf_schema_text());
  return std::get<schema::Schema>(parsed);
}
inline const schema::Schema& urdf_schema() {
  static const auto parsed = schema::Schema::parse(schema::urdf_schema_text());
  return std::get<schema::Schema>(parsed);
}

/// All that a file was read into.
struct ReadRobot {
  ReadRobot(const Disk& disk, const std::string& path)
      : resolver(disk, {}),
        workspace(disk, sources),
        loaded(
            read::load({workspace, resolver, sdf_schema(), urdf_schema()}, workspace.open(path))),
        frames(loaded.root),
        documents(workspace) {}

  read::Resolver resolver;
  Sources sources;
  read::Workspace workspace;
  read::Loaded loaded;
  model::Frames frames;
  read::Documents documents;
};

/// `files["robot.sdf"]`, converted.
struct Converted {
  explicit Converted(std::map<std::string, std::string> files, convert::UrdfOptions options = {})
      : disk(std::move(files)), source(disk, "robot.sdf") {
    result = sdf_to_urdf({source.loaded.root, source.frames, source.documents, source.resolver,
                          sdf_schema(), workers(), "robot.sdf"},
                         options);
  }
  /// What stands in the one model of an SDF file of this version.
  explicit Converted(const std::string& model, const std::string& version = "1.9",
                     convert::UrdfOptions options = {})
      : Converted({{"robot.sdf",
                    "<sdf version='" + version + "'><model name='m'>" + model + "</model></sdf>"}},
                  std::move(options)) {}

  std::vector<convert::Note> notes(convert::NoteKind kind) const {
    std::vector<convert::Note> found;
    for (const convert::Note& note : result.account.notes) {
      if (note.kind == kind) found.push_back(note);
    }
    return found;
  }
  const convert::UrdfJoint& joint(const std::string& name) const {
    for (const convert::UrdfJoint& joint : result.robot.value().joints) {
      if (joint.name == name) return joint;
    }
    throw std::out_of_range("no joint " + name);
  }
  std::vector<std::string> link_names() const {
    std::vector<std::string> names;
    for (const convert::UrdfLink& link : result.robot.value().links) names.push_back(link.name);
    return names;
  }
  std::string text_at(const convert::Note& note) const {
    return std::string(source.sources.bytes(note.where));
  }

  MemoryDisk disk;
  ReadRobot source;
  convert::UrdfConversion result;
};

/// A link whose mass is reported, so that nothing of it has to be.
inline std::string sdf_link(const std::string& name, const std::string& pose = {}) {
  return "<link name='" + name + "'>" + (pose.empty() ? "" : "<pose>" + pose + "</pose>") +
         "<inertial><mass>1</mass></inertial></link>";
}

inline std::string sdf_joint(const std::string& name, const std::string& type,
                             const std::string& parent, const std::string& child,
                             const std::string& rest = {}) {
  return "<joint name='" + name + "' type='" + type + "'><parent>" + parent + "</parent><child>" +
         child + "</child>" + rest + "</joint>";
}

/// The digits as they will be written.
template <class Numbers>
std::string digits_of(const Numbers& numbers) {
  std::string text;
  for (const convert::Number& number : numbers) text += (text.empty() ? "" : " ") + to_text(number);
  return text;
}

}  // namespace rigor::test
