// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/settings.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <rigor/convert/urdf/draft.h>
#include <rigor/read/values.h>
#include <rigor/schema/value.h>
#include <rigor/write/numbers.h>

namespace rigor::convert {
namespace {

using model::Id;

/// What `compare` looks at, what has settings of its own, and advice to converters.
constexpr std::string_view kKnownInModel[] = {"link", "joint",   "frame",  "model",
                                              "pose", "include", "static", "origin"};
constexpr std::string_view kKnownInLink[] = {"inertial", "collision", "visual",
                                             "pose",     "frame",     "origin"};
constexpr std::string_view kKnownInCollision[] = {"geometry", "pose", "origin", "density",
                                                  "auto_inertia_params"};
constexpr std::string_view kKnownInVisual[] = {"geometry", "pose", "material", "transparency"};
constexpr std::string_view kKnownInWorld[] = {"model", "include", "frame", "joint", "state"};
constexpr std::string_view kKnownInJoint[] = {
    "parent", "child", "axis", "axis2", "pose", "thread_pitch", "origin", "screw_thread_pitch"};
constexpr std::string_view kKnownInBlock[] = {"springReference", "springStiffness",
                                              "preserveFixedJoint", "disableFixedJointLumping",
                                              "canonicalBody"};

/// Of a URDF joint and of the robot.
constexpr std::string_view kFurtherInJoint[] = {"safety_controller", "calibration"};
constexpr std::string_view kFurtherInRobot[] = {"transmission", "ros2_control"};
/// Of the limit of an SDF axis.
constexpr std::string_view kFurtherInLimit[] = {"stiffness", "dissipation"};

/// Elements of MJCF that may hold what is not compared; an include leads to any.
constexpr std::string_view kUncomparedInMjcf[] = {"actuator", "contact", "equality", "extension",
                                                  "include",  "light",   "keyframe", "option",
                                                  "plugin",   "sensor",  "tendon"};

template <std::size_t Count>
bool is_one_of(std::string_view name, const std::string_view (&names)[Count]) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

std::span<const std::string_view> known_in(std::string_view element) {
  if (element == "model") return kKnownInModel;
  if (element == "link") return kKnownInLink;
  if (element == "collision") return kKnownInCollision;
  if (element == "visual") return kKnownInVisual;
  if (element == "world") return kKnownInWorld;
  if (element == "joint") return kKnownInJoint;
  return kKnownInBlock;
}

/// Parts with a name, of which a model may have several.
bool is_attachment(std::string_view name) {
  return name == "sensor" || name == "light" || name == "plugin" || name == "particle_emitter" ||
         name == "projector" || name == "battery";
}

struct Setting {
  std::string subject;  ///< "link base", "sensor base/camera"
  std::string path;     ///< "surface/friction/ode/mu"; empty of an attachment itself
  std::string text;
  Span span;
};

struct Settings {
  std::vector<Setting> all;
  std::map<std::string, std::string> owners;  ///< of each attachment
  std::set<std::string> known;                ///< links, joints, collisions and attachments
};

class SettingCollector {
 public:
  explicit SettingCollector(const SettingsSource& source) : source_(source), root_(source.root) {}

  Settings collect() {
    for (std::uint32_t i = 0; i < root_.models.size(); ++i) {
      if (is_inside({i})) add_model({i});
    }
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      if (is_inside(root_.links[i].model)) add_link(root_.links[i], inside(Id<model::Link>{i}));
    }
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      if (!is_inside(root_.joints[i].model)) continue;
      add_entity(root_.joints[i].site, "joint " + inside(Id<model::Joint>{i}));
    }
    if (!is_sdf()) add_blocks();
    return std::move(found_);
  }

  Settings collect_further() {
    found_.known.insert("robot");
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      const model::Joint& joint = root_.joints[i];
      if (is_inside(joint.model)) add_further(joint, "joint " + inside(Id<model::Joint>{i}));
    }
    if (format() == model::Format::kMjcf) {
      for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
        if (is_inside(root_.links[i].model)) add_friction({i});
      }
    }
    if (is_sdf()) add_surroundings();
    const model::Site& robot = root_[source_.model].site;
    if (format() != model::Format::kUrdf || robot.span.nowhere()) return std::move(found_);
    for (const xml::Element child : source_.documents.element(robot).children()) {
      if (is_one_of(child.name(), kFurtherInRobot)) add_attachment(child, "robot");
    }
    return std::move(found_);
  }

 private:
  model::Format format() const { return root_[source_.model].format; }

  /// Of the world that the model is in, and what of visuals only a renderer asks for.
  void add_surroundings() {
    const Id<model::World> world = root_[source_.model].world;
    if (world) add_entity(root_[world].site, "world");
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      if (!is_inside(root_.links[i].model)) continue;
      const std::string name = "visual " + inside(Id<model::Link>{i}) + '/';
      for (const Id<model::Visual> id : root_.links[i].visuals)
        add_entity(root_[id].site, name + root_[id].name.value);
    }
  }

  void add_further(const model::Joint& joint, const std::string& subject) {
    found_.known.insert(subject);
    if (format() == model::Format::kMjcf) {
      for (const model::Axis& axis : joint.axes) add_number(axis.armature, subject, "armature");
      return;
    }
    if (joint.site.span.nowhere()) return;
    for (const xml::Element child : source_.documents.element(joint.site).children()) {
      const std::string name(child.name());
      if (is_sdf() && name.starts_with("axis")) add_limit(child, subject, name + "/limit/");
      if (!is_sdf() && is_one_of(name, kFurtherInJoint)) add_inside(child, subject, name + '/');
    }
  }

  void add_limit(xml::Element axis, const std::string& subject, const std::string& path) {
    const auto limit = axis.child("limit");
    if (!limit) return;
    for (const xml::Element child : limit->children()) {
      if (is_one_of(child.name(), kFurtherInLimit))
        add(child, subject, path + std::string(child.name()));
    }
  }

  void add_friction(Id<model::Link> link) {
    std::size_t nth = 0;
    for (const Id<model::Collision> id : root_[link].collisions) {
      const std::string& name = root_[id].name.value;
      const std::string subject =
          "collision " + inside(link) + '/' + (name.empty() ? std::to_string(nth + 1) : name);
      ++nth;
      found_.known.insert(subject);
      add_number(root_[id].surface.mu, subject, "friction");
    }
  }

  void add_number(const model::Field<double>& number, const std::string& subject,
                  const std::string& path) {
    if (number.written)
      found_.all.push_back({subject, path, write::joined({number.value}), number.span});
  }

  bool is_sdf() const { return format() == model::Format::kSdf; }

  bool is_inside(Id<model::Model> id) const {
    while (id && id != source_.model) id = root_[id].parent;
    return id == source_.model;
  }

  /// "hand::palm"
  template <class T>
  std::string inside(Id<T> id) const {
    const std::string whole = scoped_name(root_, id),
                      top = scoped_name(root_, source_.model) + "::";
    return whole.starts_with(top) ? whole.substr(top.size()) : whole;
  }

  void add_model(Id<model::Model> id) {
    const bool top = id == source_.model;
    const std::string subject = top ? "robot" : "model " + inside(id);
    add_entity(root_[id].site, subject);
    if (root_[id].include >= root_.includes.size()) return;
    for (const xml::Element child :
         source_.documents.element(root_.includes[root_[id].include].site).children()) {
      if (is_attachment(child.name())) add_attachment(child, subject);
    }
  }

  void add_link(const model::Link& link, const std::string& name) {
    add_entity(link.site, "link " + name);
    for (const Id<model::Collision> id : link.collisions) {
      add_entity(root_[id].site, "collision " + name + '/' + root_[id].name.value);
    }
  }

  /// In URDF all of it is in blocks.
  void add_entity(const model::Site& site, const std::string& subject) {
    found_.known.insert(subject);
    if (site.span.nowhere() || !is_sdf()) return;
    add_children(source_.documents.element(site), subject);
  }

  void add_blocks() {
    for (const model::GazeboBlock& block : root_.gazebo_blocks) {
      const std::string& name = block.reference.value;
      std::string subject = name.empty() ? "robot" : "link " + name;
      if (!found_.known.contains(subject)) subject = "joint " + name;
      add_children(source_.documents.element(block.site), subject);
    }
  }

  void add_children(xml::Element element, const std::string& subject) {
    const auto known = known_in(element.name());
    for (const xml::Element child : element.children()) {
      if (std::find(known.begin(), known.end(), child.name()) != known.end()) continue;
      if (is_attachment(child.name())) {
        add_attachment(child, subject);
      } else {
        add(child, subject, std::string(child.name()));
      }
    }
  }

  void add_attachment(xml::Element element, const std::string& owner) {
    auto name = element.attribute("name");
    if (!name) name = element.attribute("filename");
    const std::size_t space = owner.find(' ');
    const std::string base = std::string(element.name()) + ' ' +
                             (space == std::string::npos ? "" : owner.substr(space + 1) + '/') +
                             (name ? std::string(name->value()) : std::string());
    const int nth = ++attachments_[base];
    const std::string subject = nth > 1 ? base + '[' + std::to_string(nth) + ']' : base;
    found_.known.insert(subject);
    found_.owners.emplace(subject, owner);
    found_.all.push_back({subject, {}, {}, element.name_span()});
    add_inside(element, subject, {});
  }

  /// Elements are as deep as the file, at most xml::kMaxDepth.
  void add(xml::Element element, const std::string& subject, const std::string& path) {
    if (is_sdf() && is_implied(source_.sdf, element)) return;
    const auto value = element.attribute("value");  // of a key: `<mu1 value="0.2"/>`
    bool is_key = !is_sdf() && value && element.children().empty();
    for (const xml::Attribute attribute : element.attributes()) {
      is_key = is_key && attribute.name() == "value";
    }
    if (is_key && path.find('/') == std::string::npos) {
      const std::string given(read::trimmed(value->value()));
      found_.all.push_back({subject, path, given, element.name_span()});
      return;
    }
    const std::string text(read::trimmed(element.text()));
    if (element.children().empty() && (!text.empty() || element.attributes().empty())) {
      found_.all.push_back({subject, path, text, element.name_span()});
    }
    add_inside(element, subject, path + '/');
  }

  void add_inside(xml::Element element, const std::string& subject, const std::string& path) {
    for (const xml::Attribute attribute : element.attributes()) {
      if (is_sdf() && is_implied(source_.sdf, element, attribute)) continue;
      found_.all.push_back({subject, path + std::string(attribute.name()),
                            std::string(read::trimmed(attribute.value())), attribute.name_span()});
    }
    std::map<std::string_view, int> seen;
    for (const xml::Element child : element.children()) {
      const int nth = ++seen[child.name()];
      add(child, subject,
          path + std::string(child.name()) + (nth > 1 ? '[' + std::to_string(nth) + ']' : ""));
    }
  }

  const SettingsSource& source_;
  const model::Root& root_;
  std::map<std::string, int> attachments_;  ///< of each name
  Settings found_;
};

/// An element or what is in it; a file is at most xml::kMaxDepth deep.
bool has_uncompared(xml::Element element) {
  for (const xml::Element child : element.children()) {
    if (is_one_of(child.name(), kUncomparedInMjcf) || has_uncompared(child)) return true;
  }
  return false;
}

bool same_setting(const std::string& a, const std::string& b) {
  if (a == b) return true;
  const auto x = write::numbers_in(a), y = write::numbers_in(b);
  if (x && y) {
    const double relative = robot::Tolerance{}.relative;
    return std::equal(x->begin(), x->end(), y->begin(), y->end(), [relative](double p, double q) {
      return p == q || std::abs(p - q) <= relative * std::max(std::abs(p), std::abs(q));
    });
  }
  const auto p = schema::parse_bool(a), q = schema::parse_bool(b);
  return std::holds_alternative<bool>(p) && p == q;
}

class SettingComparer {
 public:
  SettingComparer(const Settings& a, const Settings& b) : a_(a), b_(b) {
    for (const Setting& setting : b_.all)
      in_b_[{setting.subject, setting.path}].push_back(&setting);
  }

  std::vector<robot::Difference> compare() {
    for (const Setting& x : a_.all) {
      auto& others = in_b_[{x.subject, x.path}];
      if (others.empty()) {
        only(x, a_, b_, robot::DifferenceKind::kAttachmentOnlyInA);
        continue;
      }
      const Setting& y = *others.front();
      others.pop_front();
      taken_.insert(&y);
      if (!same_setting(x.text, y.text)) tell(&x, &y);
    }
    for (const Setting& y : b_.all) {
      if (!taken_.contains(&y)) only(y, b_, a_, robot::DifferenceKind::kAttachmentOnlyInB);
    }
    return std::move(found_);
  }

 private:
  void only(const Setting& setting, const Settings& own, const Settings& other,
            robot::DifferenceKind kind) {
    const bool in_a = &own == &a_;
    if (other.known.contains(setting.subject)) {
      return tell(in_a ? &setting : nullptr, in_a ? nullptr : &setting);
    }
    // What stands in an attachment is reported with it, and that with what it is part of.
    const auto owner = own.owners.find(setting.subject);
    if (!setting.path.empty() || owner == own.owners.end()) return;
    if (!other.known.contains(owner->second)) return;
    robot::Difference difference{.kind = kind};
    (in_a ? difference.a : difference.b) = setting.subject;
    (in_a ? difference.span_a : difference.span_b) = setting.span;
    found_.push_back(std::move(difference));
  }

  void tell(const Setting* x, const Setting* y) {
    const Setting& any = x != nullptr ? *x : *y;
    robot::Difference difference{
        .kind = robot::DifferenceKind::kSetting, .a = any.subject, .b = any.subject};
    difference.what = any.path;
    if (x != nullptr) difference.from.text = x->text, difference.span_a = x->span;
    if (y != nullptr) difference.to.text = y->text, difference.span_b = y->span;
    found_.push_back(std::move(difference));
  }

  const Settings& a_;
  const Settings& b_;
  std::map<std::pair<std::string, std::string>, std::deque<const Setting*>> in_b_;
  std::set<const Setting*> taken_;
  std::vector<robot::Difference> found_;
};

}  // namespace

std::vector<robot::Difference> compare_settings(const SettingsSource& a, const SettingsSource& b) {
  const Settings in_a = SettingCollector(a).collect(), in_b = SettingCollector(b).collect();
  return SettingComparer(in_a, in_b).compare();
}

bool has_settings(const SettingsSource& source) {
  return !SettingCollector(source).collect().all.empty();
}

std::vector<robot::Difference> compare_further_settings(const SettingsSource& a,
                                                        const SettingsSource& b) {
  const Settings in_a = SettingCollector(a).collect_further(),
                 in_b = SettingCollector(b).collect_further();
  return SettingComparer(in_a, in_b).compare();
}

bool has_further_settings(const SettingsSource& source) {
  return !SettingCollector(source).collect_further().all.empty();
}

bool has_uncompared_settings(const SettingsSource& source) {
  const model::Model& model = source.root[source.model];
  if (model.format != model::Format::kMjcf || model.site.span.nowhere()) return false;
  const auto root = source.documents.of(model.site.span.source).root();
  return root && has_uncompared(*root);
}

}  // namespace rigor::convert
