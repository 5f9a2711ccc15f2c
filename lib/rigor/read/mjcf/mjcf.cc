// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/mjcf/mjcf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/read/mjcf/mjcf_checks.h>
#include <rigor/read/mjcf/mjcf_geom.h>
#include <rigor/read/mjcf/mjcf_joint.h>
#include <rigor/read/mjcf/mjcf_naming.h>
#include <rigor/read/mjcf/mjcf_pose.h>
#include <rigor/read/mjcf/mjcf_scope.h>
#include <rigor/text/path.h>
#include <rigor/xml/fault.h>

namespace rigor::read {
namespace {

using model::Id;

/// Of links, joints, shapes and sites, as many as the includes of SDF may bring. Copies of copies multiply: a file of
/// a line could bring a billion.
constexpr std::size_t kMaxMjcfParts = 200'000;
/// Of elements and copies that are looked at, whether a part comes of them or not: some seconds.
constexpr std::size_t kMaxMjcfVisits = 4'000'000;
/// So many bytes of a name count as a visit: each copy has a name of its own.
constexpr std::size_t kNameBytesOfVisit = 16;
/// Of an element in what is included and attached. Files of that depth, one in another, are read.
constexpr int kMaxNested = 2 * xml::kMaxDepth;
/// Each is scaled by the sum of all.
constexpr std::size_t kMaxScaledBodies = 3000;
/// Files attach files that attach files. Each is held with its own defaults and assets.
constexpr std::size_t kMaxAttached = 1000;
constexpr std::string_view kWorld = "world";

/// Digits of a copy's number, as many as the count has.
std::string copy_number(std::size_t index, std::size_t count) {
  const std::string digits = std::to_string(index);
  return std::string(std::to_string(count).size() - digits.size(), '0') + digits;
}

class MjcfReader {
 public:
  MjcfReader(model::Root& root, Workspace& workspace, MjcfFacts& facts, Id<model::Model> id)
      : root_(root), workspace_(workspace), facts_(facts), model_(id) {}

  MjcfIncludes read(const File& file) {
    MjcfScope& scope = scopes_.emplace_back(workspace_, file, "", facts_);
    root_.mass_settings = scope.settings.masses;
    std::vector<xml::Element> worlds;
    for (const xml::Element section : scope.tree.children(scope.tree.root())) {
      if (section.name() == "worldbody") worlds.push_back(section);
    }
    MjcfPlace place{.scope = &scope, .in_world = true};
    const bool solid = std::any_of(worlds.begin(), worlds.end(), [&](xml::Element world) {
      return has_parts(scope.tree, world);
    });
    if (solid) place.link = add_link(site_of(worlds.front()), std::string(kWorld));
    for (const xml::Element world : worlds) read_parts(world, place);
    for (const xml::Element world : worlds) read_bodies(world, place);
    if (root_.mass_settings.total_mass > 0 && root_.links.size() > kMaxScaledBodies) {
      refuse(scope.tree.root(),
             "settotalmass scales more than " + std::to_string(kMaxScaledBodies) + " bodies");
    }
    for (const MjcfScope& one : scopes_) read_mjcf_couplings(one, joints_, root_);
    check(scope);
    return scope.tree.includes();
  }

 private:
  void check(const MjcfScope& scope) {
    const MjcfNames names = check_mjcf_names(scope, facts_);
    check_mjcf_references(scope, names, facts_);
    check_mjcf_elements(scope, facts_);
    check_mjcf_assets(scope, workspace_.disk(), facts_);
    check_mjcf_flexes(scope, workspace_.disk(), facts_);
    check_mjcf_plugins(scope, facts_);
    check_mjcf_bodies(scope, facts_);
    check_mjcf_places(scope, facts_);
    check_mjcf_values(scope, facts_);
    check_mjcf_targets(scope, facts_);
    check_mjcf_plausibility(scope, facts_);
    check_mjcf_states(scope, facts_);
    check_mjcf_contacts(scope, facts_);
    check_mjcf_actuators(scope, facts_);
    check_mjcf_keyframes(scope, facts_);
  }

  static bool has_parts(const MjcfTree& tree, xml::Element parent) {
    for (const xml::Element child : tree.children(parent)) {
      const std::string_view tag = child.name();
      if (tag == "geom" || tag == "site") return true;
      if ((tag == "frame" || tag == "replicate") && has_parts(tree, child)) return true;
    }
    return false;
  }

  /// Whether as much more may be looked at. What is left out is reported, once: where it is in the main file.
  bool has_room(xml::Element at, std::size_t visits = 1) {
    visits_ += visits;
    if (depth_ > kMaxNested) {
      refuse(at, "attached models are nested below more than " + std::to_string(kMaxNested) +
                     " elements");
      return false;
    }
    if (visits_ <= kMaxMjcfVisits && parts_ <= kMaxMjcfParts) return true;
    refuse(at, "copies and attached models bring more than 200,000 parts");
    return false;
  }

  void refuse(xml::Element at, std::string why) {
    if (refused_) return;
    refused_ = true;
    facts_.push_back({.kind = MjcfFactKind::kTooLarge,
                      .where = attached_at_.value_or(at.tag_span()),
                      .detail = why});
    root_.cut = {std::move(why), facts_.back().where, true};
  }

  std::string name_of(xml::Element element, const MjcfPlace& place) {
    std::string name = mjcf_name(element, "name").value;
    if (!name.empty()) name = place.scope->prefix + name + place.suffix;
    visits_ += name.size() / kNameBytesOfVisit;
    return name;
  }

  std::size_t class_in(xml::Element element, std::string_view attribute, std::size_t around,
                       const MjcfScope& scope) {
    const auto name = mjcf_name(element, attribute);
    if (!name.written) return around;
    return scope.defaults.find(name.value).value_or(around);
  }

  MjcfValues values_of(xml::Element element, const MjcfPlace& place) {
    const std::size_t id = class_in(element, "class", place.class_id, *place.scope);
    return place.scope->defaults.values(element, element.name(), id);
  }

  Id<model::Link> add_link(const model::Site& site, const std::string& name) {
    const Id<model::Link> id = next_id(root_.links);
    ++parts_;
    model::Link link;
    link.site = site;
    link.name = {naming_.link(name, id.value), site.name, true};
    link.model = model_;
    link.gravity.value = true;
    root_.links.push_back(std::move(link));
    root_.models[model_.value].links.push_back(id);
    return id;
  }

  /// Calls `use` with each element in the body, with frames and copies around it resolved.
  template <class Use>
  void each(xml::Element parent, const MjcfPlace& place, const Use& use) {
    ++depth_;
    each_child(parent, place, use);
    --depth_;
  }

  template <class Use>
  void each_child(xml::Element parent, const MjcfPlace& place, const Use& use) {
    for (const xml::Element child : place.scope->tree.children(parent)) {
      if (!has_room(child)) return;
      const std::string_view tag = child.name();
      if (tag == "frame") {
        MjcfPlace inside = place;
        const MjcfValues values(child, {});
        inside.X_BF = compose(place.X_BF, mjcf_pose(values, place.scope->settings));
        inside.class_id = class_in(child, "childclass", place.class_id, *place.scope);
        each(child, inside, use);
      } else if (tag == "replicate") {
        replicate(child, place, use);
      } else {
        use(child, place);
      }
    }
  }

  template <class Use>
  void replicate(xml::Element element, const MjcfPlace& place, const Use& use) {
    const MjcfValues values(element, {});
    const double written = values.number("count", 0).value;
    if (!(written >= 1)) return;
    if (written > static_cast<double>(kMaxMjcfVisits))
      return void(has_room(element, kMaxMjcfVisits));
    const auto count = static_cast<std::size_t>(written);
    const std::string separator = mjcf_name(element, "sep").value;
    const model::Pose step{values.vector("offset", {}).value,
                           mjcf_orientation(values, place.scope->settings)};
    model::Pose X;
    for (std::size_t i = 0; i < count && has_room(element); ++i) {
      MjcfPlace inside = place;
      inside.X_BF = compose(place.X_BF, X);
      inside.suffix = separator + copy_number(i, count) + place.suffix;
      visits_ += inside.suffix.size() / kNameBytesOfVisit;
      each(element, inside, use);
      X = compose(X, step);
    }
  }

  void read_parts(xml::Element body, const MjcfPlace& place) {
    each(body, place, [this](xml::Element element, const MjcfPlace& at) {
      const std::string_view tag = element.name();
      if (tag == "geom") read_geom(element, at);
      if (tag == "site") read_site(element, at);
      if (tag == "composite" || tag == "flexcomp") {
        facts_.push_back({MjcfFactKind::kNotExpanded, element.name_span(), {}, std::string(tag)});
      }
    });
  }

  void read_bodies(xml::Element body, const MjcfPlace& place) {
    each(body, place, [this](xml::Element element, const MjcfPlace& at) {
      if (element.name() == "body") read_body(element, at);
      if (element.name() == "attach") attach(element, at);
    });
  }

  void read_body(xml::Element element, const MjcfPlace& around) {
    MjcfPlace place = around;
    place.in_world = false;
    place.X_BF = {};
    place.class_id = class_in(element, "childclass", around.class_id, *around.scope);
    const model::Pose X_PB =
        compose(around.X_BF, mjcf_pose(MjcfValues(element, {}), around.scope->settings));
    const std::string name = name_of(element, around);

    std::vector<model::Joint> joints;
    each(element, place, [&](xml::Element child, const MjcfPlace& at) {
      if (child.name() != "joint" && child.name() != "freejoint") return;
      // A free joint has no defaults.
      const MjcfValues values =
          child.name() == "joint" ? values_of(child, at) : MjcfValues(child, {});
      ++parts_;
      joints.push_back(mjcf_joint(values, at));
      joints.back().name = {name_of(child, at), joints.back().site.name, true};
      if (const auto text = attribute_text(child, "name")) joints.back().name.span = text->span;
    });
    place.link = add_chain(element, name, around, X_PB, joints);
    read_inertial(element, place);
    read_parts(element, place);
    mark_automatic(place.link);
    read_bodies(element, place);
  }

  std::string link_name(const MjcfPlace& place) const {
    return place.link ? root_[place.link].name.value : std::string(kWorld);
  }

  /// The body's link, behind one link for each joint but the last.
  Id<model::Link> add_chain(xml::Element element, const std::string& name, const MjcfPlace& around,
                            const model::Pose& X_PB, std::vector<model::Joint>& joints) {
    const model::Site site = site_of(element);
    const bool fixed = joints.empty();
    if (fixed) {
      model::Joint joint;
      joint.site = site;
      joint.type = model::JointType::kFixed;
      joints.push_back(std::move(joint));
      ++parts_;
    }
    std::string parent = link_name(around);
    // A pose in the world without a link is one in the model.
    std::string above = around.link ? parent : std::string();
    Id<model::Link> link;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const bool last = i + 1 == joints.size();
      model::Joint& joint = joints[i];
      const std::string number = joints.size() > 1 ? std::to_string(i + 1) : "";
      if (last) {
        link = add_link(site, name);
      } else {
        const std::string part = joint.name.value.empty() ? "joint" + number : joint.name.value;
        link = add_link(joint.site, (name.empty() ? "body" : name) + "_" + part);
        root_.links[link.value].between_joints = true;
      }
      model::Link& made = root_.links[link.value];
      made.pose.pose.value = i == 0 ? X_PB : model::Pose{};
      made.pose.site = site;
      made.pose.pose.span = site.tag;
      made.pose.pose.written = i == 0;
      made.pose.relative_to.value = above;
      if (joint.name.value.empty()) {
        joint.name = {root_[link].name.value + (fixed ? "_fixed" : "_joint" + number), site.name,
                      false};
      }
      joint.model = model_;
      joint.parent.value = joint.type == model::JointType::kFloating ? std::string(kWorld) : parent;
      joint.child.value = made.name.value;
      parent = above = made.name.value;
      const Id<model::Joint> id = next_id(root_.joints);
      joints_.try_emplace(joint.name.value, id);
      naming_.joint(joint.name.value);
      root_.models[model_.value].joints.push_back(id);
      root_.joints.push_back(std::move(joint));
    }
    return link;
  }

  void read_inertial(xml::Element body, const MjcfPlace& place) {
    using From = MjcfSettings::InertiaFromGeom;
    const MjcfSettings& settings = place.scope->settings;
    if (settings.inertia_from_geom == From::kTrue) return;
    each(body, place, [&](xml::Element child, const MjcfPlace& at) {
      // MuJoCo takes it from frames, but not into copies.
      if (child.name() != "inertial" || at.suffix != place.suffix) return;
      const MjcfValues values(child, {});
      model::Inertial inertial;
      inertial.site = inertial.tensor_site = inertial.pose.site = site_of(child);
      inertial.written = inertial.tensor_written = true;
      inertial.mass = values.number("mass", 0);
      inertial.pose.pose = {compose(at.X_BF, mjcf_pose(values, settings)), child.tag_span(), true};
      if (!read_tensor(values, "fullinertia", 6, inertial)) {
        read_tensor(values, "diaginertia", 3, inertial);
      }
      root_.links[place.link.value].inertial = std::move(inertial);
    });
  }

  static bool read_tensor(const MjcfValues& values, std::string_view name, std::size_t count,
                          model::Inertial& inertial) {
    const std::vector<double> n = values.numbers(name);
    if (n.size() != count) return false;
    const Span span = values.text(name)->span;
    const auto field = [span](double value) { return model::Field<double>{value, span, true}; };
    inertial.ixx = field(n[0]);
    inertial.iyy = field(n[1]);
    inertial.izz = field(n[2]);
    if (count == 3) {
      // That the products are zero is said as well.
      inertial.ixy = inertial.ixz = inertial.iyz = field(0);
      return true;
    }
    inertial.ixy = field(n[3]);
    inertial.ixz = field(n[4]);
    inertial.iyz = field(n[5]);
    return true;
  }

  /// Whether shapes decide what the body weighs.
  void mark_automatic(Id<model::Link> id) {
    model::Link& link = root_.links[id.value];
    const auto weighs = [this](const auto part) { return root_[part].weight.has_value(); };
    link.inertial.automatic.value =
        std::any_of(link.collisions.begin(), link.collisions.end(), weighs) ||
        std::any_of(link.visuals.begin(), link.visuals.end(), weighs);
  }

  void read_geom(xml::Element element, const MjcfPlace& place) {
    if (!place.link) return;
    const MjcfValues values = values_of(element, place);
    MjcfScope& scope = *place.scope;
    const std::string own = mjcf_name(element, "name").value;
    const bool paired = !own.empty() && scope.in_pairs.contains(own);
    MjcfGeom geom =
        mjcf_geom(values, scope.settings, scope.assets, paired ? InPair::kYes : InPair::kNo);
    if (geom.fitted) {
      facts_.push_back({MjcfFactKind::kFitNotMade, element.tag_span(), {}, own});
    }
    model::Link& link = root_.links[place.link.value];
    using From = MjcfSettings::InertiaFromGeom;
    const bool explicit_mass =
        link.inertial.written || scope.settings.inertia_from_geom == From::kFalse || place.in_world;
    if (explicit_mass) geom.weight.reset();
    model::PoseField pose;
    pose.site = geom.geometry.site;
    pose.pose = {compose(place.X_BF, geom.X_BG), element.tag_span(), true};
    model::Field<std::string> name{name_of(element, place), element.name_span(), true};
    if (const auto text = attribute_text(element, "name")) name.span = text->span;
    if (geom.drawn) {
      model::Visual visual;
      visual.site = geom.geometry.site;
      visual.name = name;
      visual.link = place.link;
      visual.pose = pose;
      visual.geometry = geom.geometry;
      visual.material.site = visual.site;
      visual.material.rgba = geom.rgba;
      visual.transparency.value = 1 - geom.rgba[3];
      if (!geom.touches) visual.weight = geom.weight;
      ++parts_;
      link.visuals.push_back(next_id(root_.visuals));
      root_.visuals.push_back(std::move(visual));
    }
    if (!geom.touches) return;
    model::Collision collision;
    collision.site = geom.geometry.site;
    collision.name = std::move(name);
    collision.link = place.link;
    collision.pose = std::move(pose);
    collision.geometry = std::move(geom.geometry);
    collision.weight = geom.weight;
    const std::vector<double> friction = values.numbers("friction");
    const double mu = friction.empty() ? 1 : friction.front();
    collision.surface.mu = collision.surface.mu2 = {mu, element.tag_span(), !friction.empty()};
    ++parts_;
    link.collisions.push_back(next_id(root_.collisions));
    root_.collisions.push_back(std::move(collision));
  }

  void read_site(xml::Element element, const MjcfPlace& place) {
    std::string name = name_of(element, place);
    if (name.empty() || !place.link) return;
    const MjcfValues values = values_of(element, place);
    const auto segment = mjcf_segment(values);
    const model::Pose X = segment ? segment->pose : mjcf_pose(values, place.scope->settings);
    model::Frame frame;
    frame.site = site_of(element);
    frame.name = {std::move(name), element.name_span(), true};
    frame.model = model_;
    frame.attached_to.value = link_name(place);
    frame.pose.site = frame.site;
    frame.pose.pose = {compose(place.X_BF, X), element.tag_span(), true};
    ++parts_;
    frames_.push_back(std::move(frame));
  }

  /// The file that an attach names; its own without a name.
  const File* attached_file(xml::Element element, const MjcfScope& scope) {
    const auto name = mjcf_name(element, "model");
    if (!name.written) return &scope.tree.file();
    const auto asset = scope.assets.models.find(name.value);
    if (asset == scope.assets.models.end()) return nullptr;
    const auto file = mjcf_name(asset->second, "file");
    const std::string path = join_path(parent_path(scope.tree.file().path), file.value);
    if (workspace_.disk().kind(path) != PathKind::kFile) return nullptr;
    const File& inner = workspace_.open(path);
    const bool whole = inner.document && inner.document->complete() && inner.document->root();
    return whole ? &inner : nullptr;
  }

  void attach(xml::Element element, const MjcfPlace& place) {
    const File* file = attached_file(element, *place.scope);
    if (file == nullptr) return;
    // A model is not attached to itself as a whole.
    if (!element.attribute("model") && !element.attribute("body") && !element.attribute("frame")) {
      if (place.scope != &scopes_.front()) return;
      facts_.push_back({.kind = MjcfFactKind::kAttributeMissing,
                        .where = element.tag_span(),
                        .name = "attach",
                        .detail = "body or frame"});
      return;
    }
    if (place.scope == &scopes_.front() && place.suffix.empty()) check_prefix(element);
    const bool outermost = !attached_at_;
    if (outermost) attached_at_ = element.tag_span();
    if (scopes_.size() > kMaxAttached) {
      refuse(element, "more than " + std::to_string(kMaxAttached) + " models are attached");
    } else if (has_room(element, file->document->element_count() +
                                     place.scope->prefix.size() / kNameBytesOfVisit)) {
      // To find what is attached takes a look at all of the file.
      attach_file(element, *file, place);
    }
    if (outermost) attached_at_.reset();
  }

  /// The same part with the same prefix has the same names.
  void check_prefix(xml::Element element) {
    std::string key;
    for (const char* attribute : {"model", "body", "frame", "prefix"}) {
      key += mjcf_name(element, attribute).value + '\n';
    }
    const auto [known, is_new] = attached_.try_emplace(std::move(key), element.tag_span());
    if (is_new) return;
    const bool of_frame = element.attribute("frame").has_value();
    const char* part = of_frame ? "frame" : "body";
    facts_.push_back({.kind = MjcfFactKind::kNameRepeated,
                      .where = element.tag_span(),
                      .name = mjcf_name(element, "prefix").value + mjcf_name(element, part).value,
                      .detail = part,
                      .related = known->second});
  }

  void attach_file(xml::Element element, const File& file, const MjcfPlace& place) {
    const std::string prefix = mjcf_name(element, "prefix").value;
    MjcfFacts of_its_own;  // told when that file is checked
    MjcfScope& scope =
        scopes_.emplace_back(workspace_, file, place.scope->prefix + prefix, of_its_own);
    if (place.scope == &scopes_.front()) {
      check_mjcf_attached(*place.scope, scope, element, facts_);
    }
    MjcfPlace inside = place;
    inside.scope = &scope;
    inside.class_id = MjcfDefaults::kMain;
    const auto body = mjcf_name(element, "body");
    const auto frame = mjcf_name(element, "frame");
    const std::string& name = body.written ? body.value : frame.value;
    bool is_there = !body.written && !frame.written;
    for (const xml::Element section : scope.tree.children(scope.tree.root())) {
      if (section.name() != "worldbody") continue;
      if (!body.written && !frame.written) {
        read_parts(section, inside);
        read_bodies(section, inside);
        continue;
      }
      const bool whole = body.written && name == kWorld;
      const auto found =
          whole ? std::optional(section)
                : find_named(scope.tree, section, body.written ? "body" : "frame", name);
      if (!found) continue;
      is_there = true;
      if (body.written) {
        read_body(*found, inside);
      } else {
        inside.X_BF = compose(inside.X_BF, mjcf_pose(MjcfValues(*found, {}), scope.settings));
        inside.class_id = class_in(*found, "childclass", inside.class_id, scope);
        read_parts(*found, inside);
        read_bodies(*found, inside);
      }
    }
    if (is_there || place.scope != &scopes_.front()) return;
    facts_.push_back({.kind = MjcfFactKind::kReferenceMissing,
                      .where = body.written ? body.span : frame.span,
                      .name = name,
                      .detail = body.written ? "body" : "frame"});
  }

  static std::optional<xml::Element> find_named(const MjcfTree& tree, xml::Element parent,
                                                std::string_view tag, std::string_view name) {
    for (const xml::Element child : tree.children(parent)) {
      if (child.name() == tag) {
        if (mjcf_name(child, "name").value == name) return child;
      }
      if (auto found = find_named(tree, child, tag, name)) return found;
    }
    return std::nullopt;
  }

 public:
  /// Sites last: a name that a body or joint has is theirs.
  void add_frames() {
    for (model::Frame& frame : frames_) {
      frame.name.value = naming_.frame(frame.name.value);
      root_.models[model_.value].frames.push_back(next_id(root_.frames));
      root_.frames.push_back(std::move(frame));
    }
  }

 private:
  model::Root& root_;
  Workspace& workspace_;
  MjcfFacts& facts_;
  Id<model::Model> model_;
  std::deque<MjcfScope> scopes_;  // places point to them
  MjcfNaming naming_;
  MjcfJoints joints_;
  std::vector<model::Frame> frames_;
  std::size_t visits_ = 0, parts_ = 0;  // see has_room
  int depth_ = 0;                       // of elements, through what is attached
  bool refused_ = false;
  std::map<std::string, Span> attached_;  // by what is attached and its prefix
  std::optional<Span> attached_at_;       // the attach of the main file that is followed
};

}  // namespace

MjcfIncludes read_mjcf(model::Root& root, Workspace& workspace, const File& file,
                       MjcfFacts& facts) {
  const Id<model::Model> id = next_id(root.models);
  const xml::Element top = *file.document->root();
  model::Model model;
  model.site = site_of(top);
  model.format = model::Format::kMjcf;
  model.name = string_field(attribute_text(top, "model"), "MuJoCo Model");
  root.models.push_back(std::move(model));
  MjcfReader reader(root, workspace, facts, id);
  MjcfIncludes includes = reader.read(file);
  reader.add_frames();
  return includes;
}

}  // namespace rigor::read
