// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/to_mjcf.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <rigor/convert/comments.h>
#include <rigor/convert/mjcf/contact.h>
#include <rigor/convert/mjcf/draft.h>
#include <rigor/convert/mjcf/scene.h>
#include <rigor/convert/urdf/choice.h>
#include <rigor/convert/urdf/draft.h>
#include <rigor/convert/urdf/tree.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>

namespace rigor::convert {
namespace {

using model::Id;
using robot::kNoIndex;

/// Elements around the bodies of the deepest chain, and what stands in a body, that a reader of XML has to
/// take as well; tinyxml2 up to version 9 stops at 100 levels.
constexpr std::size_t kMaxBodyDepth = 90;

/// MuJoCo 2.2.2 reads no longer list.
constexpr std::size_t kMaxKeyframeNumbers = 1000;

class MjcfBuilder {
 public:
  MjcfBuilder(const MjcfSource& source, const MjcfOptions& options, Ledger& ledger,
              MjcfConversion& result, const MjcfAssembly& assembly)
      : result_(result),
        draft_{source,
               options,
               ledger,
               assembly,
               MjcfEntities(source.source.root),
               fixed_to_world(assembly.robot, assembly.world),
               MjcfModelBits(assembly)} {
    draft_.next_to_nothing = mjcf_massless_link(assembly.robot);
    draft_.joint_names = mjcf_joint_names(draft_);
  }

  bool is_too_deep() const {
    std::vector<std::size_t> depth(draft_.robot().bodies.size());
    for (const std::uint32_t i : draft_.robot().order) {
      const std::uint32_t carrier = draft_.robot().bodies[i].carrier;
      if (carrier != kNoIndex) depth[i] = depth[draft_.robot().joints[carrier].parent] + 1;
      if (depth[i] > kMaxBodyDepth) return true;
    }
    return false;
  }

  void build() {
    for (const auto model : result_.models) take_mjcf_model(draft_, model);
    tell_moved_inertias(draft_);
    MjcfElement world = nested_bodies();
    add_mjcf_equalities(draft_);
    add_mjcf_actuators(draft_);
    MjcfElement root{"mujoco", {{"model", model_name()}}};
    add_comments(root);
    MjcfElement compiler{"compiler", {{"angle", "radian"}, {"meshdir", "assets"}}};
    if (!draft_.texture_names.empty()) compiler.set("texturedir", "assets");
    compiler.set("inertiafromgeom", "false");
    root.add(std::move(compiler));
    if (const auto gravity = gravity_of()) root.add({"option", {{"gravity", *gravity}}});
    root.add(defaults());
    for (MjcfElement* section : {&draft_.asset}) add_section(root, *section);
    root.add(std::move(world));
    for (MjcfElement* section : {&draft_.equality, &draft_.actuator, &draft_.sensor}) {
      add_section(root, *section);
    }
    MjcfElement contact = excluded();
    add_section(root, contact);
    MjcfElement keyframe = home();
    add_section(root, keyframe);
    name_map();
    if (draft_.options.files == MjcfFiles::kWritten) {
      result_.files = std::move(draft_.files);
      if (draft_.options.file != "scene.xml") {
        result_.files.push_back(mjcf_scene(draft_.assembly, model_name(), draft_.options.file));
      }
    }
    result_.root = std::move(root);
  }

 private:
  static void add_section(MjcfElement& root, MjcfElement& section) {
    if (!section.children.empty()) root.add(std::move(section));
  }

  std::string model_name() const {
    return draft_.robot().name.empty() ? "robot" : draft_.robot().name;
  }

  void add_comments(MjcfElement& root) const {
    const auto& source = draft_.source.source;
    for (const Remark& remark :
         remarks_on_file(source.documents.of(source.root.site.span.source))) {
      root.comments.push_back(remark.text);
    }
  }

  std::optional<std::string> gravity_of() const {
    for (const model::World& world : draft_.root().worlds) {
      if (!world.gravity.written) continue;
      draft_.ledger.take(world.gravity);
      const model::Vector3& g = world.gravity.value;
      return mjcf_numbers({g.x, g.y, g.z});
    }
    return std::nullopt;
  }

  static MjcfElement defaults() {
    MjcfElement visual{"default", {{"class", "visual"}}};
    visual.add({"geom", {{"group", "2"}, {"contype", "0"}, {"conaffinity", "0"}}});
    MjcfElement collision{"default", {{"class", "collision"}}};
    collision.add({"geom",
                   {{"group", "3"},
                    {"contype", std::to_string(kMjcfOneModel.type)},
                    {"conaffinity", std::to_string(kMjcfOneModel.affinity)}}});
    MjcfElement all{"default"};
    all.add(std::move(visual));
    all.add(std::move(collision));
    return all;
  }

  // --- bodies ---

  /// From the leaves to the root, since a chain may be as long as its file.
  MjcfElement nested_bodies() {
    const robot::Robot& robot = draft_.robot();
    std::vector<MjcfElement> elements;
    for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) elements.push_back(body_element(i));
    std::vector<std::vector<std::uint32_t>> carried(robot.bodies.size());
    for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
      if (i == draft_.assembly.world) continue;
      const std::uint32_t carrier = robot.bodies[i].carrier;
      carried[carrier == kNoIndex ? draft_.assembly.world : robot.joints[carrier].parent].push_back(
          i);
    }
    order_qpos(carried);
    for (auto at = robot.order.rbegin(); at != robot.order.rend(); ++at) {
      if (*at != draft_.assembly.world) hang(elements, carried[*at], *at);
    }
    hang(elements, carried[draft_.assembly.world], draft_.assembly.world);
    return std::move(elements[draft_.assembly.world]);
  }

  static void hang(std::vector<MjcfElement>& elements, const std::vector<std::uint32_t>& carried,
                   std::uint32_t on) {
    for (const std::uint32_t i : carried) elements[on].add(std::move(elements[i]));
  }

  MjcfElement body_element(std::uint32_t i) {
    const robot::Robot& robot = draft_.robot();
    const robot::Body& body = robot.bodies[i];
    MjcfElement element{i == draft_.assembly.world ? "worldbody" : "body"};
    if (i != draft_.assembly.world) {
      element.set("name", body.name);
      const bool carried = body.carrier != kNoIndex;
      set_placement(element, carried ? robot.joints[body.carrier].X_PJ : body.X_MB);
      add_all(element, mjcf_inertial(draft_, i));
      if (carried) {
        add_all(element, mjcf_joints(draft_, body.carrier));
      } else {
        element.add({"freejoint", {{"name", free_name(i)}}});
      }
      remark(element, body.span);
    }
    add_all(element, mjcf_geoms(draft_, i));
    add_all(element, mjcf_sensors(draft_, i));
    return element;
  }

  static void add_all(MjcfElement& element, std::vector<MjcfElement> children) {
    for (MjcfElement& child : children) element.add(std::move(child));
  }

  std::string free_name(std::uint32_t body) {
    return draft_.name_for("joint", draft_.robot().bodies[body].name + "_free");
  }

  void remark(MjcfElement& element, Span tag) const {
    const model::Link* link = draft_.entities.link(tag);
    if (link == nullptr) return;
    for (const Remark& remark :
         remarks_on(draft_.source.source.documents, link->site, CommentsFor::kSdf)) {
      element.comments.push_back(remark.text);
    }
  }

  /// Pairs of bodies that do not touch; of links that were lumped, what holds them.
  MjcfElement excluded() {
    const auto& held_by = draft_.assembly.held_by;
    const auto body_of = [&](const std::string& link) {
      const auto held = held_by.find(link);
      const std::string& name = held == held_by.end() ? link : held->second;
      const auto& bodies = draft_.robot().bodies;
      const bool found = std::any_of(bodies.begin(), bodies.end(),
                                     [&](const auto& body) { return body.name == name; });
      return found && name != robot::kWorldBody ? name : std::string();
    };
    std::set<std::pair<std::string, std::string>> pairs;
    for (const auto& [first, second] : draft_.options.excluded) {
      std::string a = body_of(first), b = body_of(second);
      if (a.empty() || b.empty() || a == b) continue;
      if (b < a) std::swap(a, b);
      pairs.emplace(std::move(a), std::move(b));
    }
    for (const auto& [a, b] : bodies_to_exclude(draft_)) {
      pairs.emplace(draft_.robot().bodies[a].name, draft_.robot().bodies[b].name);
    }
    MjcfElement contact{"contact"};
    for (const auto& [a, b] : pairs) contact.add({"exclude", {{"body1", a}, {"body2", b}}});
    return contact;
  }

  // --- the keyframe ---

  /// MuJoCo numbers bodies from the root down, each with all that it carries before the next.
  void order_qpos(const std::vector<std::vector<std::uint32_t>>& carried) {
    std::vector<std::uint32_t> stack{draft_.assembly.world};
    while (!stack.empty()) {
      const std::uint32_t i = stack.back();
      stack.pop_back();
      downwards_.push_back(i);
      stack.insert(stack.end(), carried[i].rbegin(), carried[i].rend());
    }
  }

  MjcfElement home() const {
    const robot::Robot& robot = draft_.robot();
    const robot::Positions positions = home_positions(robot, draft_.options.home);
    std::string qpos;
    const auto append = [&qpos](const std::string& text) {
      qpos += (qpos.empty() ? "" : " ") + text;
    };
    const auto append_pose = [&append](const model::Pose& X) {
      const model::Vector3& p = X.translation;
      append(mjcf_numbers({p.x, p.y, p.z}));
      append(mjcf_quaternion(X.rotation));
    };
    for (const std::uint32_t i : downwards_) {
      const robot::Body& body = robot.bodies[i];
      if (i == draft_.assembly.world) continue;
      if (body.carrier == kNoIndex) {
        append_pose(body.X_MB);
        continue;
      }
      const robot::Joint& joint = robot.joints[body.carrier];
      if (joint.type == model::JointType::kFloating) {
        append_pose(joint.parent == draft_.assembly.world ? joint.X_PJ : model::Pose{});
      } else if (joint.type == model::JointType::kBall) {
        append("1 0 0 0");
      } else if (joint.type != model::JointType::kUnknown) {
        append_axes(joint, positions[body.carrier], append);
      }
    }
    MjcfElement keyframe{"keyframe"};
    const auto count = static_cast<std::size_t>(std::count(qpos.begin(), qpos.end(), ' ')) + 1;
    if (!qpos.empty() && count <= kMaxKeyframeNumbers)
      keyframe.add({"key", {{"name", "home"}, {"qpos", qpos}}});
    return keyframe;
  }

  template <class Append>
  static void append_axes(const robot::Joint& joint, const std::vector<double>& positions,
                          const Append& append) {
    for (std::size_t k = 0; k < joint.axes.size(); ++k) {
      if (length(joint.axes[k].direction) == 0) continue;
      const bool screw = joint.axes[k].motion == robot::Axis::Motion::kScrew;
      if (screw) append(mjcf_number(joint.axes[k].slide * positions[k]));
      append(mjcf_number(positions[k]));
    }
  }

  void name_map() {
    const robot::Robot& robot = draft_.robot();
    for (std::uint32_t i = 0; i < robot.joints.size(); ++i) {
      const auto& names = draft_.joint_names[i];
      if (!names.empty()) result_.joints.emplace(robot.joints[i].name, names);
    }
    for (const robot::Body& body : robot.bodies) result_.links.emplace(body.name, body.name);
    result_.held_by = draft_.assembly.held_by;
  }

  MjcfConversion& result_;
  MjcfDraft draft_;
  std::vector<std::uint32_t> downwards_;
};

/// Those of the file, or the one of that name.
std::vector<Id<model::Model>> chosen_models(const Source& source, const std::string& name,
                                            Notes& notes) {
  std::vector<Id<model::Model>> models;
  if (source.root.links.empty()) {
    notes.push_back({.kind = NoteKind::kNoModel, .where = source.root.site.name});
    return models;
  }
  for (std::uint32_t i = 0; i < source.root.models.size() && name.empty(); ++i) {
    const model::Model& model = source.root.models[i];
    if (!model.parent && !model.merged) models.push_back({i});
  }
  if (models.size() > 1) return models;
  UrdfChoice choice = choose_model(source, name);
  notes = std::move(choice.notes);
  return choice.model ? std::vector{choice.model} : std::vector<Id<model::Model>>{};
}

Notes mjcf_unresolved(const Source& source, const MjcfConversion& result) {
  Notes notes;
  for (const Id<model::Model> model : result.models) {
    Notes more = unresolved_in(source, urdf_tree(source.root, source.frames, model));
    notes.insert(notes.end(), more.begin(), more.end());
  }
  if (!notes.empty()) return notes;
  for (const std::string& unknown : result.robot.unknown) {
    const model::Model& model = source.root[result.models.front()];
    notes.push_back({.kind = NoteKind::kUnresolved,
                     .where = model.site.name,
                     .subject = model::subject(source.root, model),
                     .written = unknown});
  }
  return notes;
}

/// What a world holds beside its models.
void take_worlds(const Source& source, Ledger& ledger) {
  for (const model::World& world : source.root.worlds) {
    ledger.open(world.site);
    ledger.take(world.site);
    ledger.take(world.name);
    for (const model::Include& include : source.root.includes) {
      if (include.followed || !include.world) continue;
      ledger.lose(include.site,
                  {.kind = NoteKind::kMjcfWorld, .written = "include " + include.uri.value});
    }
    const xml::Element element = source.documents.element(world.site);
    for (const xml::Element child : element.children()) {
      if (child.name() == "model" || child.name() == "include" || child.name() == "gravity")
        continue;
      const bool joint = child.name() == "joint";
      ledger.lose(read::site_of(child),
                  {.kind = joint ? NoteKind::kJointTypeLost : NoteKind::kMjcfWorld,
                   .written = joint ? "world" : std::string(child.name())});
    }
  }
}

}  // namespace

MjcfConversion to_mjcf(const MjcfSource& source, const MjcfOptions& options) {
  MjcfConversion result;
  const Source& from = source.source;
  result.models = chosen_models(from, options.model, result.account.notes);
  if (result.models.empty()) return result;
  const MjcfAssembly assembly = mjcf_assembly(source, options, result.models);
  result.robot = assembly.robot;
  result.account.notes = mjcf_unresolved(from, result);
  if (!result.account.notes.empty()) return result;

  Ledger ledger(from.documents);
  MjcfBuilder builder(source, options, ledger, result, assembly);
  if (builder.is_too_deep()) {
    result.account.notes.push_back({.kind = NoteKind::kMjcfDepth,
                                    .where = from.root[result.models.front()].site.name,
                                    .written = std::to_string(kMaxBodyDepth)});
    return result;
  }
  if (options.model.empty()) take_worlds(from, ledger);
  builder.build();
  const bool sdf = from.root.format == model::Format::kSdf;
  result.account = std::move(ledger).close(
      [&](const model::Site& opened, xml::Element element) {
        return sdf && is_implied(from, opened, element);
      },
      [&](xml::Element element, xml::Attribute attribute) {
        return sdf ? is_implied(from, element, attribute)
                   : attribute.name().substr(0, 5) == "xmlns";
      },
      mjcf_kind_of);
  return result;
}

}  // namespace rigor::convert
