// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Links as bodies: those that fixed joints hold together are one, those that are held by the world are
// the world's. A merged body does not drift apart, as one of two bodies and a joint does.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include <rigor/mass/resolve.h>
#include <rigor/simulate/scene/draft.h>
#include <rigor/text/disjoint_sets.h>

namespace rigor::simulate {
namespace {

using model::Id;
using model::JointType;

/// Numbers written to two digits break the triangle inequality of a flat body by up to 1 %, and ODE
/// integrates what does (reference: an inequality violated by a factor of five ran without trouble).
constexpr double kRoundedTensor = 0.01;

/// √(moment / mass) below this is no body's that has a size: a tensor of 1e-30 kg·m² ends in 10²⁷ rad/s.
constexpr double kMinGyration = 1e-6;  // m

class BodyBuilder {
 public:
  explicit BodyBuilder(SceneDraft& draft)
      : draft_(draft), root_(draft.root), scene_(draft.scene), sets_(root_.links.size() + 1) {}

  void build() {
    read_flags();
    pass_on_flags();
    join_links();
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      if (draft_.takes(root_.links[i].model)) add_link({i});
    }
    if (!say_if_only_drawn()) {
      for (SceneBody& body : scene_.bodies) judge_body(body);
    }
    for (SceneModel& model : scene_.models) {
      const Id<model::Link> base = draft_.input.frames.canonical_link(model.id);
      if (base && draft_.link_of[base.value] != kWorld) {
        model.base = scene_.links[draft_.link_of[base.value]].body;
      }
    }
  }

 private:
  std::uint32_t world() const { return static_cast<std::uint32_t>(root_.links.size()); }

  /// What must be alike for two links to be one body.
  struct Flags {
    bool gravity = true;
    bool kinematic = false;
    bool operator==(const Flags&) const = default;
  };

  void read_flags() {
    flags_.resize(root_.links.size());
    for (std::size_t i = 0; i < root_.links.size(); ++i) {
      const model::Link& link = root_.links[i];
      if (!draft_.takes(link.model)) continue;
      Flags& flags = flags_[i];
      flags = {link.gravity.value, link.kinematic.value};
      for (const auto* given : blocks(link, {"turnGravityOff", "gravity", "kinematic"})) {
        const bool value = read::bool_field(*given).value;
        if (given->name == "kinematic") flags.kinematic = value;
        if (given->name == "gravity") flags.gravity = value;
        if (given->name == "turnGravityOff") flags.gravity = !value;
      }
    }
  }

  std::vector<const model::Parameter*> blocks(const model::Link& link,
                                              std::initializer_list<std::string_view> names) const {
    return draft_.blocks.find(root_[link.model], link.name.value, names);
  }

  /// A URDF's link without mass is a frame of what it is fixed to: gravity and kinematics are not its own.
  /// It follows its parent, else what is fixed to it.
  void pass_on_flags() {
    std::vector<bool> known(root_.links.size());
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      const model::Link& link = root_.links[i];
      known[i] = root_[link.model].format != model::Format::kUrdf || link.inertial.mass.value > 0 ||
                 link.inertial.mass.value < 0;
      if (!known[i]) flags_[i] = {};
    }
    const auto pass = [&](bool down) {
      bool any = false;
      for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
        const model::Frames::Ends& ends = draft_.input.frames.ends({i});
        if (root_.joints[i].type != JointType::kFixed || !ends.child || !ends.parent) continue;
        const std::uint32_t from = down ? ends.parent.value : ends.child.value;
        const std::uint32_t to = down ? ends.child.value : ends.parent.value;
        if (!known[from] || known[to]) continue;
        flags_[to] = flags_[from];
        known[to] = any = true;
      }
      return any;
    };
    while (pass(true) || pass(false)) {
    }
  }

  void join_links() {
    std::vector<bool> is_child(root_.links.size());
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      const model::Frames::Ends& ends = draft_.input.frames.ends({i});
      if (ends.child) is_child[ends.child.value] = true;
      if (root_.joints[i].type != JointType::kFixed || !ends.child) continue;
      if (ends.parent_is_world) {
        sets_.join(ends.child.value, world());
      } else if (ends.parent && flags_[ends.parent.value] == flags_[ends.child.value]) {
        sets_.join(ends.child.value, ends.parent.value);
      }
    }
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      const model::Link& link = root_.links[i];
      if (!draft_.takes(link.model)) continue;
      // libsdformat takes a URDF's root of this name for the world itself.
      const bool named_world = root_[link.model].format == model::Format::kUrdf &&
                               link.name.value == "world" && !is_child[i];
      if (draft_.is_static[link.model.value] || named_world) sets_.join(i, world());
    }
    body_of_set_.resize(root_.links.size() + 1, kWorld);
  }

  void add_link(Id<model::Link> id) {
    const model::Link& link = root_[id];
    const auto X_WL = draft_.input.frames.pose(id);
    if (!X_WL) {
      draft_.say(FactKind::kUnreadable, place(link), link, "no pose");
      return;
    }
    draft_.link_of[id.value] = static_cast<std::uint32_t>(scene_.links.size());
    SceneLink out{.name = scoped_name(root_, id),
                  .X_BL = *X_WL,
                  .id = id,
                  .where = place(link),
                  .model = draft_.model_of[link.model.value]};
    const std::uint32_t set = sets_.find(id.value);
    if (set != sets_.find(world())) {
      std::uint32_t& body = body_of_set_[set];
      const bool first = body == kWorld;
      if (first) {
        body = static_cast<std::uint32_t>(scene_.bodies.size());
        scene_.bodies.push_back(new_body(link, out.name, *X_WL));
      }
      out.body = body;
      out.X_BL = first ? Pose{} : compose(inverse(scene_.bodies[body].X_WB), *X_WL);
      add_to_body(scene_.bodies[body], id, out.X_BL);
    }
    scene_.links.push_back(std::move(out));
  }

  SceneBody new_body(const model::Link& link, const std::string& name, const Pose& X_WL) const {
    const Flags& flags = flags_[static_cast<std::size_t>(&link - root_.links.data())];
    SceneBody body;
    body.name = name;
    body.X_WB = X_WL;
    body.gravity = flags.gravity;
    body.kinematic = flags.kinematic;
    body.model = draft_.model_of[link.model.value];
    body.where = place(link);
    return body;
  }

  void add_to_body(SceneBody& body, Id<model::Link> id, const Pose& X_BL) {
    const model::Link& link = root_[id];
    body.links.push_back(draft_.link_of[id.value]);
    const mass::MassProperties in_L =
        mass::resolve(root_, draft_.input.frames, id, draft_.input.find_mesh).body;
    judge_link(link, in_L);
    const mass::MassProperties in_B = X_BL == Pose{} ? in_L : mass::transformed(X_BL, in_L);
    if (in_B.mass > 0) body.mass = body.mass.mass > 0 ? mass::add(body.mass, in_B) : in_B;
    read_link_element(body, link);
  }

  void judge_link(const model::Link& link, const mass::MassProperties& in_L) {
    const mass::Verdict verdict = mass::judge(in_L);
    const model::Inertial& inertial = link.inertial;
    if (!verdict.mass_finite) {
      draft_.say(FactKind::kNotFinite, or_name(inertial.mass.span, link), link, "mass", in_L.mass);
    } else if (verdict.mass_sign == mass::Verdict::Sign::kNegative) {
      draft_.say(FactKind::kNoMass, or_name(inertial.mass.span, link), link, {}, in_L.mass);
    } else if (!verdict.tensor_finite) {
      draft_.say(FactKind::kNotFinite, tensor_place(link), link, "inertia");
    }
  }

  static bool impossible(const mass::Verdict& verdict) {
    const double slack = kRoundedTensor * verdict.principal[2];
    return verdict.principal[0] < -slack ||
           verdict.principal[0] + verdict.principal[1] < verdict.principal[2] - slack;
  }

  /// Of the first moment that is not positive; else of the tensor.
  static Span tensor_place(const model::Link& link) {
    const model::Inertial& inertial = link.inertial;
    for (const auto* moment : {&inertial.ixx, &inertial.iyy, &inertial.izz}) {
      if (moment->written && !(moment->value > 0)) return moment->span;
    }
    return inertial.tensor_written ? inertial.tensor_site.span : place(link);
  }

  void read_link_element(SceneBody& body, const model::Link& link) {
    if (root_[link.model].format == model::Format::kUrdf) {
      const auto whole = draft_.blocks.find(root_[link.model], "", {"self_collide", "selfCollide"});
      for (const auto* flag : whole) body.self_collide |= read::bool_field(*flag).value;
      for (const auto* flag : blocks(link, {"selfCollide", "self_collide"})) {
        body.self_collide |= read::bool_field(*flag).value;
      }
      for (const auto* factor : blocks(link, {"dampingFactor"})) {
        set_decay(body.linear_damping, *factor, link);
        set_decay(body.angular_damping, *factor, link);
      }
      return;
    }
    const xml::Element element = draft_.element(link.site);
    const model::Field<bool>& own = link.self_collide;
    body.self_collide |= own.written ? own.value : root_[link.model].self_collide.value;
    auto decay = element.child("velocity_decay");
    if (!decay) decay = element.child("damping");  // SDF 1.0
    if (decay) {
      const model::Parameter given = read::parameter_of(*decay);
      if (const auto* linear = find(given.children, "linear")) {
        set_decay(body.linear_damping, *linear, link);
      }
      if (const auto* turn = find(given.children, "angular")) {
        set_decay(body.angular_damping, *turn, link);
      }
    }
    const auto wind = read::child_text(element, "enable_wind");
    if (wind && read::bool_field(wind, false).value) {
      draft_.say(FactKind::kElementIgnored, wind->span, link, "enable_wind");
    }
    const auto water = element_at(element, {"inertial", "fluid_added_mass"});
    if (water) {
      draft_.say(FactKind::kElementIgnored, water->name_span(), link, "fluid_added_mass");
    }
  }

  /// A share of the velocity that is lost in each step.
  void set_decay(double& out, const model::Parameter& given, const model::Link& link) {
    out = std::max(out, std::clamp(draft_.number(given, 0, link), 0.0, 1.0));
  }

  /// A URDF in which no link has mass is a drawing: that is said once, of the model.
  bool say_if_only_drawn() {
    const bool drawn =
        root_.format == model::Format::kUrdf && !scene_.bodies.empty() &&
        std::all_of(root_.links.begin(), root_.links.end(), [](const model::Link& link) {
          return !(link.inertial.mass.value > 0) && !(link.inertial.mass.value < 0);
        });
    if (!drawn) return false;
    const model::Model& model = root_[scene_.models.front().id];
    draft_.say(FactKind::kNoMass, model.name.span, model, "all");
    return true;
  }

  void judge_body(SceneBody& body) {
    const mass::Verdict verdict = mass::judge(body.mass);
    const bool whole = body.mass.mass > 0 && verdict.tensor_finite && verdict.principal[0] > 0;
    if (body.kinematic) {
      if (!whole)
        body.mass = {1, {}, {1, 0, 0, 1, 0, 1}};  // it moves as commanded: nobody asks for it
      return;
    }
    if (!(body.mass.mass > 0)) {
      const model::Link& first = root_[scene_.links[body.links.front()].id];
      if (first.inertial.mass.value < 0) return;  // is said of the link
      const bool is_root = !is_carried(body);
      if (is_root && draft_.options.root == SceneOptions::Root::kHeld) {
        body.mass = {1, {}, {1, 0, 0, 1, 0, 1}};  // it does not move: nobody asks for it
        return;
      }
      const Span where = or_name(first.inertial.mass.span, first);
      draft_.say(FactKind::kNoMass, where, first, {}, body.mass.mass);
      if (is_root) {
        draft_.facts.back().help =
            "give the link a mass; of what is bolted down in use `--base fixed` does without one";
      }
      return;
    }
    const double least = kMinGyration * kMinGyration * body.mass.mass;
    if (!verdict.mass_finite || !verdict.tensor_finite) return;  // is said of its link
    if (impossible(verdict) || verdict.principal[0] <= least) say_impossible(body, verdict, least);
  }

  /// Whether a joint carries it that is not within the body.
  bool is_carried(const SceneBody& body) const {
    const auto holds = [&](Id<model::Link> link) {
      return std::any_of(body.links.begin(), body.links.end(),
                         [&](std::uint32_t index) { return scene_.links[index].id == link; });
    };
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      const model::Frames::Ends& ends = draft_.input.frames.ends({i});
      const bool inside = ends.parent && holds(ends.parent);
      if (ends.child && holds(ends.child) && !inside) return true;
    }
    return false;
  }

  /// Of the first link that has it on its own; else of the heaviest.
  void say_impossible(const SceneBody& body, const mass::Verdict& verdict, double least) {
    const model::Link* at_fault = nullptr;
    double heaviest = 0;
    for (const std::uint32_t index : body.links) {
      const Id<model::Link> id = scene_.links[index].id;
      const mass::MassProperties own =
          mass::resolve(root_, draft_.input.frames, id, draft_.input.find_mesh).body;
      const mass::Verdict of_link = mass::judge(own);
      if (own.mass > 0 && impossible(of_link)) {
        at_fault = &root_[id];
        break;
      }
      if (own.mass > heaviest) {
        heaviest = own.mass;
        at_fault = &root_[id];
      }
    }
    const bool triangle = impossible(verdict);
    draft_.say(FactKind::kInertiaImpossible, tensor_place(*at_fault), *at_fault, {},
               triangle ? verdict.principal[0] + verdict.principal[1] : verdict.principal[0],
               triangle ? verdict.principal[2] : least);
  }

  static Span place(const model::Link& link) {
    return link.name.written ? link.name.span : link.site.name;
  }
  static Span or_name(Span span, const model::Link& link) {
    return span.nowhere() ? place(link) : span;
  }

  SceneDraft& draft_;
  const model::Root& root_;
  Scene& scene_;
  DisjointSets sets_;  // of links that are one body; the last is the world
  std::vector<Flags> flags_;
  std::vector<std::uint32_t> body_of_set_;
};

}  // namespace

void add_bodies(SceneDraft& draft) { BodyBuilder(draft).build(); }

}  // namespace rigor::simulate
