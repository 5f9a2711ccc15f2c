// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Every frame is a node; each has one node above it in the pose graph and a pose in that one. Chains
// are walked with a stack of our own, since a file decides how long they are.

#include <rigor/model/frames.h>

#include <algorithm>
#include <limits>
#include <utility>

#include <rigor/model/names.h>
#include <rigor/model/subject.h>

namespace rigor::model {
namespace {

constexpr std::uint32_t kTop = 0;  // the frame of the world, or `__root__`
constexpr std::uint32_t kBroken = std::numeric_limits<std::uint32_t>::max();

/// Names that only the parser's own machinery may use, but for the two that authors may.
bool is_reserved(std::string_view name) {
  return name.size() > 4 && name.starts_with("__") && name.ends_with("__") && name != "__model__";
}

bool in_urdf(const Root& root, Id<Model> model) {
  return model && root[model].format == Format::kUrdf;
}

}  // namespace

class FrameSolver {
 public:
  FrameSolver(Frames& frames, const Root& root)
      : frames_(frames), root_(root), names_(frames.names_) {
    std::uint32_t next = kTop + 1;
    const auto reserve = [&next](std::size_t count) {
      const std::uint32_t first = next;
      next += static_cast<std::uint32_t>(count);
      return first;
    };
    models_ = reserve(root.models.size());
    links_ = reserve(root.links.size());
    joints_ = reserve(root.joints.size());
    named_ = reserve(root.frames.size());
    collisions_ = reserve(root.collisions.size());
    visuals_ = reserve(root.visuals.size());
    sensors_ = reserve(root.sensors.size());
    lights_ = reserve(root.lights.size());
    nodes_.resize(next);
    carriers_.resize(next);
    nodes_[kTop].state = State::kDone;
  }

  void solve() {
    find_canonical_links();
    connect_models();
    connect_links();
    connect_joints();
    connect_frames();
    connect_parts();
    place_models();
    for (std::uint32_t node = kTop + 1; node < nodes_.size(); ++node) resolve(node);
    find_ends();
    resolve_axes();
    find_carriers();
    store();
  }

 private:
  enum class State : std::uint8_t { kOpen, kWalking, kDone, kFailed };

  struct Node {
    std::uint32_t up = kTop;
    Pose X_up;  // this node in the one above
    Pose X_top;
    State state = State::kOpen;
    Span reference;  // what names the node above, when something does
  };

  std::uint32_t node(Id<Model> id) const { return models_ + id.value; }
  std::uint32_t node(Id<Link> id) const { return links_ + id.value; }
  std::uint32_t node(Id<Joint> id) const { return joints_ + id.value; }
  std::uint32_t node(Id<Frame> id) const { return named_ + id.value; }
  std::uint32_t node(const Named& named) const {
    return std::visit(
        [this](const auto& id) -> std::uint32_t {
          if constexpr (std::is_same_v<std::decay_t<decltype(id)>, std::monostate>) {
            return kBroken;
          } else {
            return node(id);
          }
        },
        named);
  }
  std::uint32_t scope_node(ScopeId scope) const { return scope.model ? node(scope.model) : kTop; }

  /// The scope of a model's own parts: the parts of a merged one belong to the model around it.
  ScopeId inside(Id<Model> id) const { return {root_[id].merged ? root_[id].parent : id, {}}; }

  /// Names to suggest. Only for the first problems: each copies the names of its scope, and who has
  /// more needs no spelling help.
  std::vector<std::string> candidates(ScopeId scope) const {
    constexpr std::size_t kMaxWithCandidates = 20;
    if (frames_.problems_.size() >= kMaxWithCandidates) return {};
    return names_.in(scope);
  }

  template <class Entity>
  void problem(FrameProblemKind kind, const Entity& entity, const Field<std::string>& reference,
               ScopeId scope) {
    frames_.problems_.push_back({kind,
                                 reference.span,
                                 reference.value,
                                 subject(root_, entity),
                                 {},
                                 candidates(scope),
                                 scope.model,
                                 scope.world});
  }

  /// The node that a `relative_to` means, `fallback` when it says nothing.
  template <class Entity>
  std::uint32_t find(const Entity& entity, const Field<std::string>& reference, ScopeId scope,
                     std::uint32_t fallback) {
    const std::string& name = reference.value;
    if (name.empty()) return fallback;
    if (name == "world" && !scope.model) return kTop;
    const std::uint32_t found = node(names_.find(scope, name));
    if (found != kBroken) return found;
    problem(is_reserved(name) ? FrameProblemKind::kReservedReference
                              : FrameProblemKind::kRelativeToMissing,
            entity, reference, scope);
    return kBroken;
  }

  void connect(std::uint32_t node, std::uint32_t up, const PoseField& pose) {
    nodes_[node].up = up;
    nodes_[node].X_up = pose.pose.value;
    nodes_[node].reference = pose.relative_to.span;
    if (up == kBroken) nodes_[node].state = State::kFailed;
  }

  void find_canonical_links() {
    frames_.canonical_.resize(root_.models.size());
    // Nested models come after the one they are in.
    for (std::size_t i = root_.models.size(); i-- > 0;) {
      const Model& model = root_.models[i];
      const Id<Model> id{static_cast<std::uint32_t>(i)};
      Id<Link>& canonical = frames_.canonical_[i];
      if (!model.canonical_link.value.empty()) {
        const Named named = names_.find(inside(id), model.canonical_link.value);
        if (const auto* link = std::get_if<Id<Link>>(&named)) {
          canonical = *link;
        } else {
          problem(FrameProblemKind::kCanonicalLinkMissing, model, model.canonical_link, inside(id));
        }
      } else if (!model.links.empty()) {
        canonical = model.links.front();
      } else if (!model.models.empty()) {
        canonical = frames_.canonical_[model.models.front().value];
      }
    }
  }

  void connect_models() {
    for (std::size_t i = 0; i < root_.models.size(); ++i) {
      const Model& model = root_.models[i];
      const ScopeId scope{model.parent, model.world};
      connect(models_ + static_cast<std::uint32_t>(i),
              find(model, model.pose.relative_to, scope, scope_node(scope)), model.pose);
    }
  }

  void connect_links() {
    for (std::size_t i = 0; i < root_.links.size(); ++i) {
      const Link& link = root_.links[i];
      const std::uint32_t self = links_ + static_cast<std::uint32_t>(i);
      std::uint32_t up = node(link.model);
      if (in_urdf(root_, link.model)) {
        const Id<Joint> joint = names_.find_joint(link.model, link.pose.relative_to.value);
        if (joint) up = node(joint);
      } else {
        up = find(link, link.pose.relative_to, {link.model, {}}, up);
      }
      connect(self, up, link.pose);
    }
  }

  void connect_joints() {
    for (std::size_t i = 0; i < root_.joints.size(); ++i) {
      const Joint& joint = root_.joints[i];
      const std::uint32_t self = joints_ + static_cast<std::uint32_t>(i);
      const ScopeId scope{joint.model, joint.world};
      std::uint32_t up = kBroken;
      if (in_urdf(root_, joint.model)) {
        const Id<Link> parent = names_.find_link(joint.model, joint.parent.value);
        up = parent ? node(parent) : kBroken;
      } else {
        const std::uint32_t child = joint.child.value == "world" && !joint.model
                                        ? kTop
                                        : node(names_.find(scope, joint.child.value));
        up = find(joint, joint.pose.relative_to, scope, child);
      }
      connect(self, up, joint.pose);
    }
  }

  void connect_frames() {
    for (std::size_t i = 0; i < root_.frames.size(); ++i) {
      const Frame& frame = root_.frames[i];
      const ScopeId scope{frame.model, frame.world};
      std::uint32_t fallback = scope_node(scope);
      const std::string& attached = frame.attached_to.value;
      if (!attached.empty() && !(attached == "world" && !scope.model)) {
        fallback = node(names_.find(scope, attached));
        if (fallback == kBroken) {
          problem(is_reserved(attached) ? FrameProblemKind::kReservedReference
                                        : FrameProblemKind::kAttachedToMissing,
                  frame, frame.attached_to, scope);
        }
      }
      connect(named_ + static_cast<std::uint32_t>(i),
              find(frame, frame.pose.relative_to, scope, fallback), frame.pose);
    }
  }

  /// Collisions, visuals, sensors and lights: in a link's frame, unless they name one of its model.
  void connect_parts() {
    const auto connect_all = [this](const auto& parts, std::uint32_t first) {
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto& part = parts[i];
        const std::uint32_t self = first + static_cast<std::uint32_t>(i);
        if (!part.link) {  // a light of the world; a sensor of a joint comes below
          nodes_[self].X_up = part.pose.pose.value;
          continue;
        }
        const ScopeId scope{root_[part.link].model, {}};
        connect(self, find(part, part.pose.relative_to, scope, node(part.link)), part.pose);
      }
    };
    connect_all(root_.collisions, collisions_);
    connect_all(root_.visuals, visuals_);
    connect_all(root_.lights, lights_);
    connect_all(root_.sensors, sensors_);
    for (std::size_t i = 0; i < root_.sensors.size(); ++i) {
      const Sensor& sensor = root_.sensors[i];
      if (!sensor.joint) continue;
      const Joint& joint = root_[sensor.joint];
      connect(sensors_ + static_cast<std::uint32_t>(i),
              find(sensor, sensor.pose.relative_to, {joint.model, joint.world}, node(sensor.joint)),
              sensor.pose);
    }
  }

  /// A model's pose places its placement frame F; what the graph needs is that of the model M:
  /// X_PM = X_PF * inverse(X_MF). Inner models first, so that X_MF is settled.
  void place_models() {
    for (std::size_t i = root_.models.size(); i-- > 0;) {
      const Model& model = root_.models[i];
      if (model.placement_frame.value.empty()) continue;
      const Id<Model> id{static_cast<std::uint32_t>(i)};
      const std::uint32_t self = node(id);
      const std::uint32_t frame = node(names_.find(inside(id), model.placement_frame.value));
      if (frame == kBroken) {
        problem(FrameProblemKind::kPlacementFrameMissing, model, model.placement_frame, inside(id));
        nodes_[self].state = State::kFailed;
        continue;
      }
      Pose X_MF;
      std::size_t steps = 0;
      std::uint32_t at = frame;
      for (; at != self && at != kTop && at != kBroken && steps <= nodes_.size(); ++steps) {
        X_MF = compose(nodes_[at].X_up, X_MF);
        at = nodes_[at].up;
      }
      if (at == self) nodes_[self].X_up = compose(nodes_[self].X_up, inverse(X_MF));
    }
  }

  /// Walks up to what is settled, then back down.
  void resolve(std::uint32_t node) {
    std::vector<std::uint32_t>& stack = stack_;
    stack.clear();
    std::uint32_t at = node;
    while (nodes_[at].state == State::kOpen) {
      nodes_[at].state = State::kWalking;
      stack.push_back(at);
      at = nodes_[at].up;
    }
    const bool cycle = nodes_[at].state == State::kWalking;
    if (cycle) report_cycle(at);
    const bool failed = cycle || nodes_[at].state == State::kFailed;
    for (; !stack.empty(); stack.pop_back()) {
      Node& current = nodes_[stack.back()];
      current.state = failed ? State::kFailed : State::kDone;
      if (!failed) current.X_top = compose(nodes_[current.up].X_top, current.X_up);
    }
  }

  void report_cycle(std::uint32_t first) {
    FrameProblem found;
    found.kind = FrameProblemKind::kRelativeToCycle;
    std::uint32_t at = first;
    do {
      found.members.push_back(name_of(at));
      if (found.where.nowhere() && !nodes_[at].reference.nowhere()) {
        found.where = nodes_[at].reference;
        found.subject = subject_of(at);
        found.name = name_of(nodes_[at].up);
      }
      at = nodes_[at].up;
    } while (at != first);
    found.members.push_back(name_of(first));
    // A cycle made by `attached_to` alone is reported as that.
    if (found.where.nowhere()) {
      found.kind = FrameProblemKind::kAttachedToCycle;
      for (at = first; found.where.nowhere(); at = nodes_[at].up) {
        if (is_frame(at)) {
          found.where = root_.frames[at - named_].attached_to.span;
          found.subject = subject_of(at);
          found.name = name_of(nodes_[at].up);
        }
        if (nodes_[at].up == first) break;
      }
    }
    // In a URDF the joints make the cycle: a rule of their own tells it.
    if (!found.where.nowhere()) frames_.problems_.push_back(std::move(found));
  }

  bool is_frame(std::uint32_t node) const { return node >= named_ && node < collisions_; }

  /// Calls `use` with the entity of a node that a name can mean.
  template <class Use>
  std::string with_entity(std::uint32_t node, Use use) const {
    if (node >= models_ && node < links_) return use(root_.models[node - models_]);
    if (node >= links_ && node < joints_) return use(root_.links[node - links_]);
    if (node >= joints_ && node < named_) return use(root_.joints[node - joints_]);
    if (is_frame(node)) return use(root_.frames[node - named_]);
    return {};
  }
  std::string name_of(std::uint32_t node) const {
    return with_entity(node, [](const auto& entity) { return entity.name.value; });
  }
  std::string subject_of(std::uint32_t node) const {
    return with_entity(node, [this](const auto& entity) { return subject(root_, entity); });
  }

  /// The link that a name's frame moves with; none for the world, for nothing, and for a circle.
  Id<Link> carrier_of(ScopeId scope, std::string_view name) {
    std::vector<std::uint32_t> passed;  // joints and frames on the way, which share the answer
    Id<Link> carrier;
    while (passed.size() <= root_.frames.size() + root_.joints.size()) {
      const Named named = names_.find(scope, name);
      if (const auto* link = std::get_if<Id<Link>>(&named)) {
        carrier = *link;
        break;
      }
      if (const auto* model = std::get_if<Id<Model>>(&named)) {
        carrier = frames_.canonical_[model->value];
        break;
      }
      const std::uint32_t at = node(named);
      if (at == kBroken) break;
      if (carriers_[at]) {
        carrier = *carriers_[at];
        break;
      }
      passed.push_back(at);
      if (const auto* joint = std::get_if<Id<Joint>>(&named)) {
        scope = {root_[*joint].model, root_[*joint].world};
        name = root_[*joint].child.value;
      } else {
        const Frame& frame = root_.frames[at - named_];
        scope = {frame.model, frame.world};
        name = frame.attached_to.value;
        if (name.empty() && scope.model) name = "__model__";
      }
    }
    for (const std::uint32_t at : passed) carriers_[at] = carrier;
    return carrier;
  }

  void find_ends() {
    frames_.ends_.resize(root_.joints.size());
    for (std::size_t i = 0; i < root_.joints.size(); ++i) {
      const Joint& joint = root_.joints[i];
      const ScopeId scope{joint.model, joint.world};
      Frames::Ends& ends = frames_.ends_[i];
      ends.parent_is_world = joint.parent.value == "world" && !in_urdf(root_, joint.model);
      if (!ends.parent_is_world) ends.parent = end(joint, joint.parent, scope, End::kParent);
      ends.child = end(joint, joint.child, scope, End::kChild);
      if (ends.parent && ends.parent == ends.child) {
        problem(FrameProblemKind::kParentIsChild, joint, joint.child, scope);
      }
    }
  }

  enum class End { kParent, kChild };

  Id<Link> end(const Joint& joint, const Field<std::string>& reference, ScopeId scope, End which) {
    if (reference.value.empty()) return {};  // the schema's facts name what is not there
    if (in_urdf(root_, joint.model)) {
      const Id<Link> link = names_.find_link(joint.model, reference.value);
      if (!link) problem(missing(which), joint, reference, scope);
      return link;
    }
    if (which == End::kChild && reference.value == "world") {
      problem(FrameProblemKind::kChildIsWorld, joint, reference, scope);
      return {};
    }
    if (names_.find(scope, reference.value).index() == 0) {
      problem(missing(which), joint, reference, scope);
      return {};
    }
    return carrier_of(scope, reference.value);
  }

  static FrameProblemKind missing(End which) {
    return which == End::kParent ? FrameProblemKind::kParentMissing
                                 : FrameProblemKind::kChildMissing;
  }

  void find_carriers() {
    for (const Frame& frame : root_.frames) {
      frames_.carriers_.push_back(carrier_of({frame.model, frame.world}, frame.name.value));
    }
  }

  void resolve_axes() {
    frames_.axes_.resize(root_.joints.size());
    for (std::size_t i = 0; i < root_.joints.size(); ++i) {
      const Joint& joint = root_.joints[i];
      const ScopeId scope{joint.model, joint.world};
      for (std::size_t k = 0; k < joint.axes.size() && k < 2; ++k) {
        const Axis& axis = joint.axes[k];
        std::uint32_t frame = joints_ + static_cast<std::uint32_t>(i);
        if (!axis.expressed_in.value.empty()) {
          frame = axis.expressed_in.value == "world" && !scope.model
                      ? kTop
                      : node(names_.find(scope, axis.expressed_in.value));
        }
        if (frame == kBroken) {
          problem(FrameProblemKind::kExpressedInMissing, joint, axis.expressed_in, scope);
          continue;
        }
        const double norm = length(axis.xyz.value);
        if (nodes_[frame].state != State::kDone || norm == 0) continue;
        frames_.axes_[i][k] = (1 / norm) * rotate(nodes_[frame].X_top.rotation, axis.xyz.value);
      }
    }
  }

  void store() {
    const auto copy = [this](Frames::Poses& poses, std::uint32_t first, std::size_t count) {
      poses.resize(count);
      for (std::size_t i = 0; i < count; ++i) {
        const Node& from = nodes_[first + i];
        if (from.state == State::kDone) poses[i] = from.X_top;
      }
    };
    copy(frames_.models_, models_, root_.models.size());
    copy(frames_.links_, links_, root_.links.size());
    copy(frames_.joints_, joints_, root_.joints.size());
    copy(frames_.frames_, named_, root_.frames.size());
    copy(frames_.collisions_, collisions_, root_.collisions.size());
    copy(frames_.visuals_, visuals_, root_.visuals.size());
    copy(frames_.sensors_, sensors_, root_.sensors.size());
    copy(frames_.lights_, lights_, root_.lights.size());
  }

  Frames& frames_;
  const Root& root_;
  const Names& names_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> stack_;
  std::vector<std::optional<Id<Link>>> carriers_;  // by node; only of joints and frames
  std::uint32_t models_, links_, joints_, named_, collisions_, visuals_, sensors_, lights_;
};

Frames::Frames(const Root& root, const JointPositions& positions) : names_(root) {
  FrameSolver(*this, root).solve();
  if (!positions.empty()) move_joints(root, positions);
}

std::optional<Vector3> Frames::axis(Id<Joint> id, std::size_t index) const {
  return axes_[id.value][index];
}

}  // namespace rigor::model
