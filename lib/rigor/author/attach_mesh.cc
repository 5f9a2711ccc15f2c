// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/attach_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <utility>
#include <variant>

#include <rigor/author/shape_names.h>
#include <rigor/mesh/read.h>
#include <rigor/model/frames.h>
#include <rigor/model/subject.h>
#include <rigor/schema/suggest.h>
#include <rigor/write/numbers.h>
#include <rigor/write/write_pose.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

using model::Vector3;
using write::PoseForm;
using xml::Element;
using Edits = std::vector<Edit>;

/// The middle of a shape's bounds, in its own frame. Nothing for a mesh, and where there is none.
std::optional<Vector3> middle_of(const model::Shape& shape) {
  if (std::holds_alternative<model::NoShape>(shape)) return std::nullopt;
  if (std::holds_alternative<model::Mesh>(shape)) return std::nullopt;
  const auto* outline = std::get_if<model::Polyline>(&shape);
  if (outline == nullptr || outline->points.empty()) return Vector3{};
  Vector3 min = outline->points.front().value;
  Vector3 max = min;
  for (const auto& point : outline->points) {
    min = {std::min(min.x, point.value.x), std::min(min.y, point.value.y), 0};
    max = {std::max(max.x, point.value.x), std::max(max.y, point.value.y), 0};
  }
  return 0.5 * (min + max) + Vector3{0, 0, outline->height.value / 2};
}

/// Scaled, m.
Vector3 middle_of(const NewMesh& mesh) {
  const mesh::Bounds& b = mesh.bounds;
  if (!(b.min.x <= b.max.x)) return {};
  const Vector3 middle = 0.5 * b.min + 0.5 * b.max;
  return {mesh.scale.x * middle.x, mesh.scale.y * middle.y, mesh.scale.z * middle.z};
}

std::vector<Vector3> scaled(std::span<const Vector3> vertices, const Vector3& scale) {
  std::vector<Vector3> result;
  result.reserve(vertices.size());
  for (const Vector3& v : vertices) result.push_back({scale.x * v.x, scale.y * v.y, scale.z * v.z});
  return result;
}

/// The mesh's, or the corners of its bounds where it has none: then the size of the bounds tells what it can.
std::vector<Vector3> scaled_vertices(const NewMesh& mesh) {
  if (!mesh.vertices.empty()) return scaled(mesh.vertices, mesh.scale);
  const mesh::Bounds& b = mesh.bounds;
  if (!(b.min.x <= b.max.x)) return {};
  std::vector<Vector3> corners;
  for (const double x : {b.min.x, b.max.x}) {
    for (const double y : {b.min.y, b.max.y}) {
      for (const double z : {b.min.z, b.max.z}) corners.push_back({x, y, z});
    }
  }
  return scaled(corners, mesh.scale);
}

double coordinate(const Vector3& v, Axis axis) {
  return axis == Axis::kX ? v.x : axis == Axis::kY ? v.y : v.z;
}

/// How long the part is along the axis, compared with what it measures across.
double slenderness(const std::vector<Vector3>& vertices, Axis axis) {
  const mesh::Bounds bounds = mesh::bounds_of(vertices);
  const Vector3 size = bounds.max - bounds.min;
  const double along = coordinate(size, axis);
  const double across = axis == Axis::kX ? size.y : size.x;
  return across > 0 ? along / across : std::numeric_limits<double>::infinity();
}

/// The axis of the frame that the unit vector is along, one way or the other, to some degrees.
std::optional<Axis> axis_along(const Vector3& direction) {
  constexpr double kParallel = 0.996;  // cos 5°
  for (const Axis axis : {Axis::kX, Axis::kY, Axis::kZ}) {
    if (std::abs(coordinate(direction, axis)) > kParallel) return axis;
  }
  return std::nullopt;
}

/// Round and round, as a wheel does: a hinge with limits may bend a part that is round about another axis.
bool turns_freely(const model::Joint& joint) {
  if (joint.type == model::JointType::kContinuous) return true;
  if (joint.type != model::JointType::kRevolute || joint.axes.empty()) return false;
  constexpr double kManyTurns = 100;  // rad
  const model::Axis& axis = joint.axes.front();
  return !axis.limit_written || axis.upper.value - axis.lower.value > kManyTurns;
}

std::string mesh_text(const std::string& uri, const Vector3& scale, PoseForm form) {
  const std::string factors = write::joined({scale.x, scale.y, scale.z});
  const bool scaled = scale != Vector3{1, 1, 1};
  if (form == PoseForm::kPose) {
    return "<mesh>\n  <uri>" + xml::escaped(uri) + "</uri>\n" +
           (scaled ? "  <scale>" + factors + "</scale>\n" : "") + "</mesh>";
  }
  return "<mesh filename=\"" + xml::escaped(uri) + '"' +
         (scaled ? " scale=\"" + factors + '"' : "") + "/>";
}

/// Each line a level deeper.
std::string indented(std::string_view text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result.append("  ").append(text.substr(begin, end - begin)).append("\n");
    begin = end + 1;
  }
  return result;
}

/// The mesh instead of all that the geometry holds.
Edits geometry_edits(const xml::Document& document, Element part, const std::string& mesh,
                     PoseForm form) {
  const auto geometry = part.child("geometry");
  if (!geometry) {
    const auto pose = part.child(form == PoseForm::kPose ? "pose" : "origin");
    return insert_child(document, part, pose, "<geometry>\n" + indented(mesh) + "</geometry>");
  }
  Edits edits;
  for (const Element child : geometry->children()) {
    append(edits, edits.empty() ? replace_element(document, child, mesh)
                                : remove_element(document, child));
  }
  return edits.empty() ? insert_child(document, *geometry, std::nullopt, mesh) : edits;
}

/// Names like this one: whole ones, and those without the outermost model's.
std::vector<std::string> like(const std::vector<ShapeName>& all, std::string_view name) {
  std::vector<std::string_view> names;
  for (const ShapeName& shape : all) {
    const std::string_view whole = shape.plain;
    names.push_back(whole);
    names.push_back(whole.substr(whole.find("::") + 2));
  }
  const auto near = schema::near(name, names);
  return {near.begin(), near.end()};
}

std::vector<std::string> candidates(const std::vector<ShapeName>& all,
                                    const std::vector<ShapeName>& found, std::string_view name) {
  std::vector<std::string> result;
  if (found.empty()) result = like(all, name);
  if (!result.empty()) return result;
  const std::vector<ShapeName> in_link = found.empty() ? neighbors(all, name) : found;
  for (const ShapeName& shape : in_link.empty() ? all : in_link) {
    if (result.size() == kMaxCandidates) break;
    result.push_back(to_type(all, shape));
  }
  return result;
}

class MeshAttacher {
 public:
  MeshAttacher(const Environment& environment, const Sources& sources, const read::Loaded& loaded,
               const NewMesh& mesh)
      : environment_(environment),
        resolver_(environment.resolver),
        sources_(sources),
        file_(*loaded.file),
        root_(loaded.root),
        mesh_(mesh) {}

  AttachedMesh attach(std::string_view name) {
    const std::vector<ShapeName> all = shape_names(root_);
    const std::vector<ShapeName> found = find_shapes(all, name);
    if (found.size() == 1) {
      std::visit([this](auto id) { put(root_[id]); }, found[0].shape);
      return std::move(result_);
    }
    result_.path = file_.path;
    result_.problem = found.empty() ? AttachProblem::kNotFound : AttachProblem::kAmbiguous;
    result_.candidates = candidates(all, found, name);
    return std::move(result_);
  }

 private:
  template <class Part>
  void put(const Part& part) {
    result_.subject = model::subject(root_, part);
    result_.path = sources_.path(part.site.span.source);
    result_.problem = edit(part);
    if (result_.problem != AttachProblem::kNone) result_.edits.clear();
  }

  template <class Part>
  AttachProblem edit(const Part& part) {
    if (!root_.own(part.site)) return AttachProblem::kIncluded;
    if (!file_.document->complete()) return AttachProblem::kCutDocument;
    const PoseForm form = write::pose_form(root_[root_[part.link].model]);
    const Element element = file_.document->element(part.site.element);
    if (const auto middle = middle_of(part.geometry.shape)) {
      auto pose = write_pose(*file_.document, element, form, part.pose.pose.value,
                             {.offset = *middle - middle_of(mesh_)});
      if (!pose) return AttachProblem::kPose;
      append(result_.edits, *std::move(pose));
    }
    compare_axes(part);
    NewUri named = new_uri(resolver_, root_.format, file_.path, mesh_.path);
    append(result_.edits,
           geometry_edits(*file_.document, element, mesh_text(named.uri, mesh_.scale, form), form));
    result_.uri = std::move(named.uri);
    result_.copy = std::move(named.copy);
    return AttachProblem::kNone;
  }

  /// Of the shape, or of the mesh that it is, as that is scaled.
  std::optional<Axis> axis_of(const model::Shape& shape) const {
    const auto* old = std::get_if<model::Mesh>(&shape);
    if (old == nullptr) return round_axis(shape);
    const auto found = resolver_.resolve(old->uri.value, file_.path).path;
    if (!found) return std::nullopt;
    const mesh::LoadedMesh loaded =
        mesh::read_mesh(environment_.disk, *found, environment_.workers);
    if (!loaded.usable()) return std::nullopt;
    return round_axis(scaled(loaded.mesh.positions, old->scale.value));
  }

  template <class Part>
  void compare_axes(const Part& part) {
    // A rod may swing about any axis; what is as wide as high, or flat, is a wheel, a rotor, a pulley.
    constexpr double kLongestWheel = 1.2;
    const std::vector<Vector3> vertices = scaled_vertices(mesh_);
    const std::optional<Axis> now = round_axis(vertices);
    if (!now) return;
    if (const std::optional<Axis> before = axis_of(part.geometry.shape)) {
      if (before != now) result_.mismatch = {*now, *before};
    } else if (slenderness(vertices, *now) <= kLongestWheel) {
      compare_with_joint(part, *now);
    }
  }

  template <class Part>
  void compare_with_joint(const Part& part, Axis now) {
    const model::Frames frames(root_);
    const auto& siblings = parts_like(part);
    const model::Id<Part> id{static_cast<std::uint32_t>(&part - siblings.data())};
    const auto pose = frames.pose(id);
    for (std::uint32_t i = 0; pose && i < root_.joints.size(); ++i) {
      const model::Id<model::Joint> joint{i};
      if (frames.ends(joint).child != part.link || !turns_freely(root_[joint])) continue;
      const auto direction = frames.axis(joint, 0);
      if (!direction) continue;
      const auto expected = axis_along(rotate(conjugate(pose->rotation), *direction));
      if (expected && expected != now) {
        result_.mismatch = {now, *expected, root_[joint].name.value};
      }
    }
  }

  const std::vector<model::Collision>& parts_like(const model::Collision& /*part*/) const {
    return root_.collisions;
  }
  const std::vector<model::Visual>& parts_like(const model::Visual& /*part*/) const {
    return root_.visuals;
  }

  const Environment& environment_;
  const read::Resolver& resolver_;
  const Sources& sources_;
  const read::File& file_;
  const model::Root& root_;
  const NewMesh& mesh_;
  AttachedMesh result_;
};

}  // namespace

AttachedMesh attach_mesh(const Environment& environment, const Sources& sources,
                         const read::Loaded& loaded, std::string_view name, const NewMesh& mesh) {
  return MeshAttacher(environment, sources, loaded, mesh).attach(name);
}

}  // namespace rigor::author
