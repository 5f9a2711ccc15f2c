// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/mirror.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include <rigor/author/names/name_graph.h>
#include <rigor/author/verbs/block.h>
#include <rigor/author/verbs/draft.h>
#include <rigor/author/verbs/placed.h>
#include <rigor/author/verbs/robot_laws.h>
#include <rigor/text/path.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/style.h>

namespace rigor::author {
namespace {

using model::Id;
using model::Pose;
using model::Quaternion;
using model::Vector3;

/// A reflection in a plane through the origin that is normal to one of the axes.
class Reflection {
 public:
  explicit Reflection(MirrorPlane plane)
      : signs_{plane == MirrorPlane::kYz ? -1.0 : 1.0, plane == MirrorPlane::kXz ? -1.0 : 1.0,
               plane == MirrorPlane::kXy ? -1.0 : 1.0} {}

  Vector3 of(const Vector3& v) const {
    return {signs_[0] * v.x + 0.0, signs_[1] * v.y + 0.0, signs_[2] * v.z + 0.0};
  }
  /// What turns about the vector by an angle, turned by the same angle.
  Vector3 of_axis(const Vector3& a) const {
    const Vector3 s = of(a);
    return {0.0 - s.x, 0.0 - s.y, 0.0 - s.z};
  }
  /// S X S.
  Pose of(const Pose& X) const {
    const Quaternion& q = X.rotation;
    const Vector3 u = of_axis({q.x, q.y, q.z});
    return {of(X.translation), {q.w, u.x, u.y, u.z}};
  }
  /// S I S, matrix entries.
  mass::Inertia of(const mass::Inertia& I) const {
    const auto& [x, y, z] = signs_;
    return {I.ixx, x * y * I.ixy + 0.0, x * z * I.ixz + 0.0, I.iyy, y * z * I.iyz + 0.0, I.izz};
  }
  mass::MassProperties of(const mass::MassProperties& body) const {
    return {body.mass, of(body.com), of(body.about_com)};
  }
  bool turns_z() const { return signs_[2] < 0; }

 private:
  std::array<double, 3> signs_;
};

/// The law, for the bodies of a part. X_BL is the frame of the plane in the body that carries the part.
void mirror_bodies(robot::Robot& robot, const std::vector<bool>& part, const Reflection& S,
                   const Pose& X_BL) {
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    if (!part[i]) continue;
    robot::Body& body = robot.bodies[i];
    body.mass = S.of(body.mass);
    for (auto* parts : {&body.collisions, &body.visuals}) {
      for (robot::Part& each : *parts) {
        each.X_BS = S.of(each.X_BS);
        std::vector<double>& n = each.shape.numbers;
        if (each.shape.kind == "mesh" || each.shape.kind == "plane") {
          const Vector3 v = S.of(Vector3{n[0], n[1], n[2]});
          n = {v.x, v.y, v.z};
        } else if (each.shape.kind == "polyline") {
          for (std::size_t k = 1; k + 1 < n.size(); k += 2) {
            const Vector3 v = S.of(Vector3{n[k], n[k + 1], 0});
            n[k] = v.x, n[k + 1] = v.y;
          }
        }
      }
    }
  }
  for (robot::Joint& joint : robot.joints) {
    if (!part[joint.child]) continue;
    joint.X_PJ = part[joint.parent] ? S.of(joint.X_PJ)
                                    : compose(X_BL, S.of(compose(inverse(X_BL), joint.X_PJ)));
    // A ball joint has no axes of its own: what it turns about is the same by convention.
    if (joint.type == model::JointType::kBall) continue;
    for (robot::Axis& axis : joint.axes) {
      axis.direction = axis.motion == robot::Axis::Motion::kSlide ? S.of(axis.direction)
                                                                  : S.of_axis(axis.direction);
    }
  }
  for (robot::Frame& frame : robot.frames) {
    if (frame.body != robot::kNoIndex && part[frame.body]) frame.X_BF = S.of(frame.X_BF);
  }
  robot::connect(robot);
}

class Mirrorer {
 public:
  Mirrorer(const EditedModel& edited, std::uint32_t body, const MirrorRequest& request)
      : edited_(edited),
        root_(edited.root()),
        draft_(edited),
        request_(request),
        S_(request.plane),
        body_(body),
        part_(subtree_of(edited.robot, body)) {
    const std::uint32_t carrier = edited.robot.bodies[body].carrier;
    carrier_ = carrier == robot::kNoIndex ? body : edited.robot.joints[carrier].parent;
    const std::string& name = edited.robot.bodies[carrier_].name;
    const Id<model::Link> link = edited.link(name);
    X_WL_ = link ? *edited.frames.pose(link) : *edited.frames.pose(edited.model);
  }

  Change mirror() {
    if (const auto included = included_part(edited_))
      return refusal("a part of it is in " + *included);
    const std::uint32_t carrier = edited_.robot.bodies[body_].carrier;
    for (std::uint32_t i = 0; i < edited_.robot.joints.size(); ++i) {
      const robot::Joint& joint = edited_.robot.joints[i];
      if (i != carrier && part_[joint.parent] != part_[joint.child])
        return refusal(fmt::format("joint '{}' connects it with the rest, too", joint.name));
    }
    mirror_poses();
    mirror_links();
    mirror_joints();
    if (refused_.empty()) refused_ = draft_.problem();
    if (!refused_.empty()) return refusal(std::move(refused_));
    robot::Robot image = edited_.robot;
    const Pose X_WM = *edited_.frames.pose(edited_.model);
    const Pose X_BL = compose(inverse(image.bodies[carrier_].X_MB), compose(inverse(X_WM), X_WL_));
    mirror_bodies(image, part_, S_, X_BL);
    Change change;
    change.notes = std::move(notes_);
    change.asks_for_setting = [](const robot::Difference& difference) {
      return is_of_pose(difference) || difference.a.empty();
    };
    if (request_.from.empty()) {
      change.steps = draft_.take();
      change.expected = std::move(image);
      return change;
    }
    if (std::string fault = copy(change, image); !fault.empty()) return refusal(std::move(fault));
    return change;
  }

 private:
  bool in_part(Id<model::Link> link) const {
    if (!link || !edited_.inside(root_[link].model)) return false;
    const std::uint32_t body = edited_.body_index(edited_.name_of(link));
    return body != robot::kNoIndex && part_[body];
  }

  /// Whether a frame is the part's, by the name that something in the scope has for it.
  bool is_named_in_part(Id<model::Model> scope, const std::string& name) const {
    const model::Named found = edited_.frames.names().find({scope, {}}, name);
    if (const auto* link = std::get_if<Id<model::Link>>(&found)) return in_part(*link);
    if (const auto* joint = std::get_if<Id<model::Joint>>(&found))
      return in_part(edited_.frames.ends(*joint).child);
    if (const auto* frame = std::get_if<Id<model::Frame>>(&found))
      return in_part(edited_.frames.carrier(*frame));
    if (const auto* model = std::get_if<Id<model::Model>>(&found))
      return *model != edited_.model && in_part(edited_.frames.canonical_link(*model));
    return false;
  }

  /// Whether the frame that the pose is in is the part's own.
  bool is_in_own_frame(const Placed& each) const {
    if (each.kind == PlacedKind::kInertial) return true;  // whatever it names
    const std::string& name = each.field.relative_to.value;
    if (!name.empty()) return is_named_in_part(each.scope, name);
    switch (each.kind) {
      case PlacedKind::kModel:
      case PlacedKind::kInclude: return false;
      case PlacedKind::kLink: return is_nested(each.scope);
      case PlacedKind::kJoint:
        return edited_.is_urdf() ? in_part(edited_.frames.ends(Id<model::Joint>{each.index}).parent)
                                 : true;
      case PlacedKind::kFrame: {
        const std::string& attached = root_.frames[each.index].attached_to.value;
        return attached.empty() ? is_nested(each.scope) : is_named_in_part(each.scope, attached);
      }
      default: return true;
    }
  }
  bool is_nested(Id<model::Model> scope) const {
    return scope != edited_.model && in_part(edited_.frames.canonical_link(scope));
  }

  void mirror_poses() {
    for (const Placed& each : placed_in(edited_)) {
      const Id<model::Link> link =
          each.kind == PlacedKind::kModel ? edited_.frames.canonical_link({each.index}) : each.link;
      if (!in_part(link)) continue;
      if (!each.X_WF) {
        refused_ = "a pose cannot be resolved";
        continue;
      }
      const Pose& X = each.field.pose.value;
      if (is_in_own_frame(each)) {
        draft_.set_pose(each.field, each.holder, S_.of(X));
      } else {
        const Pose X_LF = compose(inverse(X_WL_), *each.X_WF);
        draft_.set_pose(each.field, each.holder, compose(inverse(X_LF), S_.of(compose(X_LF, X))));
      }
    }
  }

  void mirror_links() {
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      if (!in_part({i})) continue;
      const model::Inertial& inertial = root_.links[i].inertial;
      const mass::Inertia image =
          S_.of(mass::Inertia{inertial.ixx.value, inertial.ixy.value, inertial.ixz.value,
                              inertial.iyy.value, inertial.iyz.value, inertial.izz.value});
      draft_.set(inertial.ixy, image.ixy);
      draft_.set(inertial.ixz, image.ixz);
      draft_.set(inertial.iyz, image.iyz);
    }
    for (const model::Collision& each : root_.collisions) {
      if (in_part(each.link)) mirror_shape(each.geometry);
    }
    for (const model::Visual& each : root_.visuals) {
      if (in_part(each.link)) mirror_shape(each.geometry);
    }
  }

  void mirror_shape(const model::Geometry& geometry) {
    std::visit([&](const auto& shape) { mirror(geometry, shape); }, geometry.shape);
  }
  void mirror(const model::Geometry& geometry, const model::Mesh& shape) {
    const Vector3 scale = S_.of(shape.scale.value);
    const std::string note = "meshes have a negative scale: it turns their triangles inside out";
    if (notes_.empty()) notes_.push_back(note);
    if (shape.scale.written) return draft_.set(shape.scale, scale);
    const std::string text = write::joined({scale.x, scale.y, scale.z});
    const xml::Element mesh = edited_.element(geometry.site);
    if (edited_.is_urdf()) {
      draft_.set_attribute(mesh, "scale", text);
    } else {
      std::optional<xml::Element> last;
      for (const xml::Element child : mesh.children()) last = child;
      draft_.insert(mesh, last, "<scale>" + text + "</scale>");
    }
  }
  void mirror(const model::Geometry&, const model::Plane& shape) {
    draft_.set(shape.normal, S_.of(shape.normal.value));
  }
  void mirror(const model::Geometry&, const model::Polyline& shape) {
    if (S_.turns_z()) refused_ = "a polyline has no image in the xy plane";
    for (const auto& point : shape.points) {
      const Vector3 image = S_.of(point.value);
      draft_.set_first_numbers(point, {image.x, image.y});
    }
  }
  void mirror(const model::Geometry&, const model::Cone&) {
    if (S_.turns_z()) refused_ = "a cone has no image in the xy plane";
  }
  void mirror(const model::Geometry&, const model::Heightmap&) {
    refused_ = "a heightmap has no image";
  }
  void mirror(const model::Geometry&, const model::Image&) { refused_ = "an image has no image"; }
  template <class Symmetric>
  void mirror(const model::Geometry&, const Symmetric&) {}

  void mirror_joints() {
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      const model::Joint& joint = root_.joints[i];
      const Id<model::Joint> id{i};
      if (!edited_.inside(joint.model) || !in_part(edited_.frames.ends(id).child)) continue;
      if (joint.type == model::JointType::kScrew || joint.type == model::JointType::kPlanar ||
          joint.type == model::JointType::kGearbox) {
        refused_ = fmt::format("joint '{}' is {}: its image moves in another way", joint.name.value,
                               to_string(joint.type));
        return;
      }
      if (joint.type == model::JointType::kFixed || joint.type == model::JointType::kFloating ||
          joint.type == model::JointType::kBall)
        continue;
      for (std::size_t k = 0; k < joint.axes.size(); ++k)
        draft_.set_axis(joint, joint.axes[k], image_of_axis(id, joint.axes[k]));
    }
  }

  Vector3 image_of_axis(Id<model::Joint> id, const model::Axis& axis) const {
    const model::Joint& joint = root_[id];
    const auto image = [&](const Vector3& v) {
      return joint.type == model::JointType::kPrismatic ? S_.of(v) : S_.of_axis(v);
    };
    const std::string& in = axis.expressed_in.value;
    if (in.empty() || is_named_in_part(joint.model, in)) return image(axis.xyz.value);
    const model::Named found = edited_.frames.names().find({joint.model, {}}, in);
    std::optional<Pose> X_WF;
    std::visit(
        [&](const auto& frame) {
          if constexpr (!std::is_same_v<std::decay_t<decltype(frame)>, std::monostate>)
            X_WF = edited_.frames.pose(frame);
        },
        found);
    if (!X_WF) return image(axis.xyz.value);
    const Quaternion R_LF = conjugate(X_WL_.rotation) * X_WF->rotation;
    return rotate(conjugate(R_LF), image(rotate(R_LF, axis.xyz.value)));
  }

  // --- A copy ---

  std::string new_name(const std::string& name) const {
    std::string result = name;
    for (std::size_t at = 0; (at = result.find(request_.from, at)) != std::string::npos;
         at += request_.to.size())
      result.replace(at, request_.from.size(), request_.to);
    return result;
  }

  /// Elements of the model that are the part's, each with where it stands.
  std::vector<xml::Element> elements_of_part() const {
    std::set<std::uint32_t> elements;
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      if (in_part({i})) elements.insert(root_.links[i].site.element);
    }
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      if (in_part(edited_.frames.ends(Id<model::Joint>{i}).child))
        elements.insert(root_.joints[i].site.element);
    }
    for (std::uint32_t i = 0; i < root_.frames.size(); ++i) {
      if (in_part(edited_.frames.carrier(Id<model::Frame>{i})))
        elements.insert(root_.frames[i].site.element);
    }
    for (const model::GazeboBlock& block : root_.gazebo_blocks) {
      const std::string& name = block.reference.value;
      const Id<model::Joint> joint = edited_.joint(name);
      if (in_part(edited_.link(name)) || (joint && in_part(edited_.frames.ends(joint).child)))
        elements.insert(block.site.element);
    }
    std::vector<xml::Element> list;
    for (const std::uint32_t index : elements) list.push_back(edited_.document().element(index));
    return list;
  }

  std::string copy(Change& change, const robot::Robot& image) {
    if (edited_.loaded.file->expanded) return "in a template, call the macro once more";
    if (edited_.robot.bodies[body_].carrier == robot::kNoIndex)
      return "a root has no place beside it";
    NameGraph graph(edited_.workspace, edited_.environment.resolver);
    std::vector<Edit> edits;
    for (const std::vector<Edit>& step : draft_.take()) append(edits, step);
    const std::vector<xml::Element> elements = elements_of_part();
    for (const xml::Element element : elements) {
      const auto parent = element.parent();
      if (!parent || *parent != edited_.element(root_[edited_.model].site))
        return "a part of it is in a nested model";
    }
    std::set<EntityId> of_part;
    for (const NameUse& use : graph.uses(edited_.path())) {
      if (!use.defines) continue;
      const std::uint32_t begin = graph.entity(use.target).element.begin;
      if (std::any_of(elements.begin(), elements.end(),
                      [&](xml::Element each) { return each.span().begin == begin; }))
        of_part.insert(use.target);
    }
    for (const NameUse& use : graph.uses(edited_.path())) {
      if (!of_part.contains(use.target)) continue;
      const std::string& name = graph.entity(use.target).name;
      const std::string other = new_name(name);
      if (other == name) return fmt::format("'{}' has no '{}' in it", name, request_.from);
      if (const auto taken = graph.taken(use.target, other))
        return fmt::format("a {} is named '{}' already", to_string(graph.entity(*taken).kind),
                           other);
      edits.push_back({use.where, other});
    }
    const xml::Document& document = edited_.document();
    const std::string line(xml::line_end(document, 0));
    std::string text;
    for (const xml::Element element : elements) {
      const Span span = element.span();
      if (!text.empty()) text += line;
      text +=
          xml::indentation(document, element) + part_after(document, span.begin, span.end, edits);
    }
    auto block = block_at_end(document, edited_.element(root_[edited_.model].site), text);
    if (!block) return "it has no content";
    change.steps.push_back({*std::move(block)});
    change.expected = with_copy(image);
    return {};
  }

  robot::Robot with_copy(const robot::Robot& image) const {
    robot::Robot all = edited_.robot;
    std::vector<std::uint32_t> index(all.bodies.size());
    for (std::uint32_t i = 0; i < image.bodies.size(); ++i) {
      index[i] = i;
      if (!part_[i]) continue;
      index[i] = static_cast<std::uint32_t>(all.bodies.size());
      all.bodies.push_back(image.bodies[i]);
      all.bodies.back().name = new_name(image.bodies[i].name);
    }
    std::map<std::string, std::string> renamed;
    for (const robot::Joint& joint : image.joints) {
      if (part_[joint.child]) renamed.emplace(joint.name, new_name(joint.name));
    }
    for (robot::Joint joint : image.joints) {
      if (!part_[joint.child]) continue;
      joint.name = new_name(joint.name);
      joint.parent = index[joint.parent];
      joint.child = index[joint.child];
      for (robot::Axis& axis : joint.axes) {
        if (axis.follow && renamed.contains(axis.follow->joint))
          axis.follow->joint = renamed.at(axis.follow->joint);
      }
      all.joints.push_back(std::move(joint));
    }
    for (robot::Frame frame : image.frames) {
      if (frame.body == robot::kNoIndex || !part_[frame.body]) continue;
      frame.name = new_name(frame.name);
      frame.body = index[frame.body];
      all.frames.push_back(std::move(frame));
    }
    robot::connect(all);
    return all;
  }

  const EditedModel& edited_;
  const model::Root& root_;
  Draft draft_;
  const MirrorRequest& request_;
  Reflection S_;
  std::uint32_t body_;
  std::vector<bool> part_;     ///< by body
  std::uint32_t carrier_ = 0;  ///< body that the plane is of
  Pose X_WL_;                  ///< of the frame that the plane is of
  std::vector<std::string> notes_;
  std::string refused_;
};

}  // namespace

Change mirrored(const EditedModel& edited, std::string_view link, const MirrorRequest& request) {
  const std::uint32_t body = edited.body_index(link);
  if (body == robot::kNoIndex || !edited.link(link))
    return refusal(fmt::format("no link is named '{}'", link));
  return Mirrorer(edited, body, request).mirror();
}

}  // namespace rigor::author
