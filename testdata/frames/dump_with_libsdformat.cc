// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes what libsdformat resolves in each case to standard output: this is how facts.tsv was made.
// Not part of the build. With libsdformat-dev 12.3 of Debian 12, in the folder of this file:
//
//   g++ -std=c++17 dump_with_libsdformat.cc $(pkg-config --cflags --libs sdformat12) -o /tmp/dump
//   /tmp/dump cases/*.sdf > facts.tsv
//
// Columns: file, kind, scoped name, x y z qw qx qy qz in the frame of the world or of `__root__`,
// and for a link its mass, center of mass and tensor about that in the link's axes (xx xy xz yy yz
// zz), for a joint `parent child type` and its axes. Of a rejected file there is only its verdict,
// with the code of the first error, or `throws` where libsdformat's own assertions fail.

#include <cstdio>
#include <initializer_list>
#include <string>

#include <sdf/sdf.hh>

namespace {

using ignition::math::Pose3d;
using ignition::math::Vector3d;

std::string numbers(std::initializer_list<double> values, char separator) {
  std::string text;
  for (double value : values) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.12g", value == 0 ? 0.0 : value);
    if (!text.empty()) text += separator;
    text += buffer;
  }
  return text;
}

void row(const std::string& file, const char* kind, const std::string& name, const Pose3d& pose,
         const std::string& extra = {}) {
  const auto& p = pose.Pos();
  const auto q = pose.Rot().W() < 0 ? -pose.Rot() : pose.Rot();
  std::printf("%s\t%s\t%s\t%s\t%s\n", file.c_str(), kind, name.c_str(),
              numbers({p.X(), p.Y(), p.Z(), q.W(), q.X(), q.Y(), q.Z()}, '\t').c_str(),
              extra.c_str());
}

template <class Entity>
Pose3d pose_in(const Entity& entity, const std::string& scope) {
  Pose3d pose;
  const auto errors = entity.SemanticPose().Resolve(pose, scope);
  if (!errors.empty()) throw errors.front();
  return pose;
}

std::string inertia(const ignition::math::Inertiald& inertial) {
  const Vector3d& c = inertial.Pose().Pos();
  const auto I = inertial.Moi();  // about the center of mass, in the link's axes
  return numbers({inertial.MassMatrix().Mass(), c.X(), c.Y(), c.Z(), I(0, 0), I(0, 1), I(0, 2),
                  I(1, 1), I(1, 2), I(2, 2)},
                 ' ');
}

std::string ends_and_axes(const sdf::Joint& joint, const Pose3d& X_WM) {
  std::string parent = "?";
  std::string child = "?";
  joint.ResolveParentLink(parent);
  joint.ResolveChildLink(child);
  std::string text = parent + ' ' + child + ' ' + std::to_string(static_cast<int>(joint.Type()));
  for (unsigned i = 0; i < 2; ++i) {
    Vector3d axis;
    if (joint.Axis(i) == nullptr || !joint.Axis(i)->ResolveXyz(axis, "__model__").empty()) continue;
    axis = X_WM.Rot() * axis;
    text += ' ' + numbers({axis.X(), axis.Y(), axis.Z()}, ' ');
  }
  return text;
}

void dump(const std::string& file, const sdf::Model& model, const std::string& outer,
          const Pose3d& X_WM) {
  const std::string name = outer + model.Name();
  row(file, "model", name, X_WM);
  for (uint64_t i = 0; i < model.LinkCount(); ++i) {
    const sdf::Link& link = *model.LinkByIndex(i);
    const std::string link_name = name + "::" + link.Name();
    const Pose3d X_WL = X_WM * pose_in(link, "__model__");
    row(file, "link", link_name, X_WL, inertia(link.Inertial()));
    for (uint64_t k = 0; k < link.CollisionCount(); ++k) {
      const auto& part = *link.CollisionByIndex(k);
      row(file, "collision", link_name + "::" + part.Name(), X_WM * pose_in(part, "__model__"));
    }
    for (uint64_t k = 0; k < link.VisualCount(); ++k) {
      const auto& part = *link.VisualByIndex(k);
      row(file, "visual", link_name + "::" + part.Name(), X_WM * pose_in(part, "__model__"));
    }
  }
  for (uint64_t i = 0; i < model.FrameCount(); ++i) {
    const sdf::Frame& frame = *model.FrameByIndex(i);
    row(file, "frame", name + "::" + frame.Name(), X_WM * pose_in(frame, "__model__"));
  }
  for (uint64_t i = 0; i < model.JointCount(); ++i) {
    const sdf::Joint& joint = *model.JointByIndex(i);
    row(file, "joint", name + "::" + joint.Name(), X_WM * pose_in(joint, "__model__"),
        ends_and_axes(joint, X_WM));
  }
  for (uint64_t i = 0; i < model.ModelCount(); ++i) {
    const sdf::Model& nested = *model.ModelByIndex(i);
    dump(file, nested, name + "::", X_WM * pose_in(nested, "__model__"));
  }
}

void dump(const std::string& file) {
  sdf::Root root;
  const sdf::Errors errors = root.Load(file);
  if (!errors.empty()) {
    std::printf("%s\tverdict\terror %d\n", file.c_str(), static_cast<int>(errors.front().Code()));
    std::fprintf(stderr, "%s: %s\n", file.c_str(), errors.front().Message().c_str());
    return;
  }
  std::printf("%s\tverdict\tvalid\n", file.c_str());
  if (root.Model() != nullptr) dump(file, *root.Model(), "", pose_in(*root.Model(), "__root__"));
  for (uint64_t w = 0; w < root.WorldCount(); ++w) {
    const sdf::World& world = *root.WorldByIndex(w);
    for (uint64_t i = 0; i < world.FrameCount(); ++i) {
      const sdf::Frame& frame = *world.FrameByIndex(i);
      row(file, "frame", frame.Name(), pose_in(frame, "world"));
    }
    for (uint64_t i = 0; i < world.ModelCount(); ++i) {
      const sdf::Model& model = *world.ModelByIndex(i);
      dump(file, model, "", pose_in(model, "world"));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  sdf::addURIPath("model://", "models");
  sdf::Console::Instance()->SetQuiet(true);
  for (int i = 1; i < argc; ++i) {
    try {
      dump(argv[i]);
    } catch (const sdf::Error& error) {
      std::fprintf(stderr, "%s: no pose: %s\n", argv[i], error.Message().c_str());
    } catch (const sdf::Exception&) {  // a failed assertion of its own, which ends other programs
      std::printf("%s\tverdict\tthrows\n", argv[i]);
    }
  }
}
