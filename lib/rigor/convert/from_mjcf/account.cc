// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The account of an MJCF file: what of each element the result says, whatever default class it is in. What no
// line here names is lost.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/convert/from_mjcf/plan.h>
#include <rigor/convert/number_text.h>
#include <rigor/model/subject.h>
#include <rigor/read/mjcf/mjcf_settings.h>
#include <rigor/read/values.h>
#include <rigor/text/path.h>

namespace rigor::convert {
namespace {

/// Lists of words in one text, which a look-up goes through.
struct Words {
  std::string_view element;
  std::string_view both;         ///< attributes that both targets have
  std::string_view sdf = {};     ///< that SDF has, too
  std::string_view silent = {};  ///< that say nothing of the robot
  bool placed = false;           ///< by `kPlaceWords`
};

constexpr std::string_view kPlaceWords = "pos quat axisangle xyaxes zaxis euler";

constexpr Words kBodyWords[] = {
    {"worldbody", ""},
    {.element = "body", .both = "name childclass", .placed = true},
    {.element = "frame", .both = "name childclass", .placed = true},
    {.element = "replicate", .both = "count sep offset", .placed = true},
    {"attach", "model body frame prefix"},
    {.element = "inertial", .both = "mass diaginertia fullinertia", .placed = true},
    {"freejoint", "name", "", "group align"},
    {"joint",
     "name class type pos axis range limited ref damping frictionloss actuatorfrcrange "
     "actuatorfrclimited stiffness springref springdamper",
     "", "group user"},
    {"geom",
     "name class type size fromto mesh material rgba contype conaffinity group mass density "
     "shellinertia",
     "friction", "user", true},
};
constexpr Words kSite{"site", "", "name class fromto", "user", true};
constexpr Words kAssetWords[] = {
    {"mesh", "name class file vertex face scale refpos refquat inertia content_type", "",
     "maxhullvert smoothnormal"},
    {"material", "name class rgba"},
    {"model", "name file content_type"},
};
constexpr Words kCoupling{"joint", "name class active joint1 joint2 polycoef"};
constexpr Words kLoopWords{"", "",
                           "name class active body1 body2 anchor relpose site1 site2 objtype"};
/// What of an actuator becomes the effort limit of its joint.
constexpr Words kDrive{"",
                       "name class joint jointinparent gear ctrlrange ctrllimited forcerange "
                       "forcelimited biastype gaintype gainprm"};

bool has_word(std::string_view list, std::string_view word) {
  while (!list.empty()) {
    const std::string_view first = list.substr(0, list.find(' '));
    if (first == word) return true;
    list.remove_prefix(std::min(first.size() + 1, list.size()));
  }
  return false;
}

const Words* words_for(std::string_view element, MjcfTarget target) {
  if (element == "site" && target == MjcfTarget::kSdf) return &kSite;
  for (const Words& words : kBodyWords) {
    if (words.element == element) return &words;
  }
  for (const Words& words : kAssetWords) {
    if (words.element == element) return &words;
  }
  return nullptr;
}

class MjcfAccountant {
 public:
  MjcfAccountant(const MjcfPlan& plan, Ledger& ledger)
      : plan_(plan), ledger_(ledger), root_(plan.root()) {}

  void take() {
    open(plan_.scope.tree.root());
    open_attached(plan_.scope.tree, 0);
    for (const xml::Element element : plan_.locks) take(element, kCoupling, Outcome::kRewritten);
    for (const MjcfLoop& loop : plan_.loops) take_loop(loop);
    take_couplings();
    take_drives();
    for (std::size_t i = 0; i < plan_.joint_ids.size(); ++i) {
      const robot::Joint& joint = plan_.robot.joints[i];
      if (joint.type == model::JointType::kBall && plan_.chosen[joint.child])
        lose_of_ball(root_[plan_.joint_ids[i]]);
    }
    for (std::size_t i = 0; i < plan_.free_joint.size(); ++i) {
      if (plan_.free_joint[i] && plan_.chosen[i]) lose_of_free(root_[*plan_.free_joint[i]]);
    }
  }

 private:
  static constexpr int kMaxAttachDepth = 20;

  /// A file, or the content of an include, which is in the file that includes it.
  void open(xml::Element top) {
    ledger_.open(read::site_of(top));
    ledger_.take(top);
    if (const auto name = top.attribute("model")) ledger_.take_value(name->value_span());
    for (const xml::Element section : plan_.scope.tree.children(top)) take_section(section);
    take_includes(top);
  }

  void take_includes(xml::Element parent) {
    for (const xml::Element child : parent.children()) {
      if (child.name() != "include") {
        take_includes(child);
        continue;
      }
      ledger_.take_all(child);
      for (const xml::Element inner : plan_.scope.tree.children_of_include(child)) {
        const auto top = inner.parent();
        if (!top) continue;
        ledger_.open(read::site_of(*top));
        ledger_.take(*top);
        if (const auto name = top->attribute("model")) ledger_.take_value(name->value_span());
        take_includes(*top);
        break;
      }
    }
  }

  /// Models that are attached, by their own files.
  void open_attached(const read::MjcfTree& tree, int depth) {
    if (depth > kMaxAttachDepth) return;
    for (const xml::Element element : tree.in_sections("asset")) {
      const auto file = read::attribute_text(element, "file");
      if (element.name() != "model" || !file) continue;
      const std::string path = join_path(parent_path(tree.file().path), file->text);
      read::Workspace& workspace = plan_.source.workspace;
      if (workspace.disk().kind(path) != PathKind::kFile) continue;
      const read::File& inner = workspace.open(path);
      if (!inner.document || !inner.document->complete() || !inner.document->root()) continue;
      // One that no body attaches was not read.
      if (!plan_.source.source.documents.hold(inner.source)) continue;
      read::MjcfFacts of_its_own;
      const read::MjcfTree attached(workspace, inner, of_its_own);
      ledger_.open(read::site_of(attached.root()));
      ledger_.take(attached.root());
      for (const xml::Element section : attached.children(attached.root())) {
        take_section(section);
      }
      open_attached(attached, depth + 1);
    }
  }

  void take_section(xml::Element section) {
    const std::string_view name = section.name();
    if (name == "worldbody") {
      ledger_.take(section);
      take_world(section);
    } else if (name == "compiler") {
      ledger_.take_all(section);
    } else if (name == "option") {
      tell_gravity(section);
    } else if (name == "default") {
      take_default(section);
    } else if (has_word("actuator contact equality sensor tendon", name)) {
      ledger_.take(section, Outcome::kImplied);  // what is lost of it is told one by one
    } else if (name == "asset") {
      ledger_.take(section, Outcome::kImplied);
      for (const xml::Element child : plan_.scope.tree.children(section)) {
        if (const Words* words = words_for(child.name(), plan_.target)) take(child, *words);
      }
    }
  }

  /// A model has no gravity of its own: its world has, by default that of Earth.
  void tell_gravity(xml::Element option) {
    const auto text = read::attribute_text(option, "gravity");
    const auto g = text ? read::mjcf_numbers(text->text) : std::nullopt;
    if (!g || g->size() != 3) return;
    constexpr double kOfEarth = 0.05;  // m/s², from pole to equator and beyond
    const bool earth = (*g)[0] == 0 && (*g)[1] == 0 && std::abs((*g)[2] + 9.81) < kOfEarth;
    if (earth) return;
    ledger_.take(option, Outcome::kImplied);
    ledger_.take_value(text->span, Outcome::kLost);
    ledger_.note({.kind = NoteKind::kFromMjcfGravity,
                  .where = text->span,
                  .subject = "option",
                  .written = std::string(text->text)});
  }

  /// The shapes of the world, and the bodies of the top level, are converted or not as was chosen.
  void take_world(xml::Element parent) {
    for (const xml::Element child : plan_.scope.tree.children(parent)) {
      const std::string_view tag = child.name();
      if (tag == "frame" || tag == "replicate") {
        take(child, *words_for(tag, plan_.target));
        take_world(child);
      } else if (tag == "body" && !plan_.options.body.empty() &&
                 read::string_field(read::attribute_text(child, "name")).value !=
                     plan_.options.body) {
        lose(child, NoteKind::kFromMjcfLeftOut);
      } else if ((tag == "geom" || tag == "site") && !plan_.shows_world) {
        lose(child, NoteKind::kFromMjcfWorld);
      } else {
        take_tree(child);
      }
    }
  }

  void lose(xml::Element element, NoteKind kind) {
    const auto name = element.attribute("name");
    std::string words(element.name());
    if (name) words += " " + std::string(name->value());
    ledger_.lose(read::site_of(element), {.kind = kind, .written = std::move(words)});
  }

  void take_tree(xml::Element element) {
    const Words* words = words_for(element.name(), plan_.target);
    if (words == nullptr) return;
    take(element, *words);
    for (const xml::Element child : plan_.scope.tree.children(element)) take_tree(child);
  }

  /// A default says something where an element takes it: of what is lost, the element is the loss.
  void take_default(xml::Element element) {
    ledger_.take(element);
    if (const auto name = element.attribute("class")) ledger_.take_value(name->value_span());
    for (const xml::Element child : plan_.scope.tree.children(element)) {
      if (child.name() == "default") {
        take_default(child);
      } else if (const Words* words = words_for(child.name(), plan_.target)) {
        take(child, *words);
      } else {
        ledger_.take_all(child, Outcome::kImplied);
      }
    }
  }

  void take(xml::Element element, const Words& words, Outcome outcome = Outcome::kConverted) {
    ledger_.take(element, outcome);
    const bool sdf = plan_.target == MjcfTarget::kSdf;
    if (sdf && words.element == "geom") tell_friction(element);
    for (const xml::Attribute attribute : element.attributes()) {
      const std::string_view name = attribute.name();
      const bool known =
          has_word(words.both, name) || (words.placed && has_word(kPlaceWords, name));
      if (known || (sdf && has_word(words.sdf, name))) {
        ledger_.take_value(attribute.value_span(), outcome);
      } else if (has_word(words.silent, name)) {
        ledger_.take_value(attribute.value_span(), Outcome::kImplied);
      }
    }
  }

  /// The first number of three is in the result: sliding; torsional and rolling friction, m, are not, where they are
  /// others than MuJoCo's own.
  void tell_friction(xml::Element geom) {
    constexpr std::array<double, 2> kOwn{0.005, 0.0001};
    const auto text = read::attribute_text(geom, "friction");
    const auto numbers = text ? read::mjcf_numbers(text->text) : std::nullopt;
    if (!numbers || numbers->size() < 2 || numbers->size() > 3 ||
        std::equal(numbers->begin() + 1, numbers->end(), kOwn.begin(),
                   kOwn.begin() + std::ssize(*numbers) - 1))
      return;
    ledger_.note(
        {.kind = NoteKind::kFromMjcfContact,
         .where = text->span,
         .subject = std::string(geom.name()) + " " + mjcf_word(geom, "name"),
         .written = "torsional and rolling friction, of " + std::string(text->text) + ","});
  }

  void take_loop(const MjcfLoop& loop) {
    const bool urdf = plan_.target == MjcfTarget::kUrdf;
    for (const xml::Element element : loop.elements) {
      if (!urdf) {
        take(element, kLoopWords, Outcome::kSubstituted);
        continue;
      }
      ledger_.lose(read::site_of(element), {.kind = NoteKind::kFromMjcfLoop,
                                            .subject = "equality " + loop.name,
                                            .written = std::string(element.name())});
    }
  }

  void lose_of(const model::Joint& joint, const char* type, Span where, std::string words) {
    ledger_.take_value(where, Outcome::kLost);
    ledger_.note({.kind = NoteKind::kFromMjcfLimit,
                  .outcome = Outcome::kLost,
                  .where = where,
                  .subject = model::subject(root_, joint),
                  .written = std::move(words),
                  .instead = type});
  }

  /// The three joints that a ball becomes in URDF have its damping each.
  void lose_of_ball(const model::Joint& joint) {
    if (joint.axes.empty()) return;
    const model::Axis& axis = joint.axes[0];
    const auto lose = [&](const model::Field<double>& field, const char* what) {
      lose_of(joint, "ball", field.span, what + (' ' + to_text({field.value, {}})));
    };
    if (axis.limit_written) lose(axis.upper, "range");
    if (axis.damping.value != 0 && plan_.target == MjcfTarget::kSdf) lose(axis.damping, "damping");
    if (axis.friction.value != 0) lose(axis.friction, "frictionloss");
    if (axis.spring_stiffness.value != 0) lose(axis.spring_stiffness, "stiffness");
    const xml::Element element = plan_.source.source.documents.element(joint.site);
    const auto tuned = read::attribute_text(element, "springdamper");
    if (axis.spring_damper && tuned)
      lose_of(joint, "ball", tuned->span, "springdamper " + std::string(tuned->text));
  }

  /// Of its own, as the model has no axis of it.
  void lose_of_free(const model::Joint& joint) {
    const xml::Element element = plan_.source.source.documents.element(joint.site);
    for (const char* what : {"damping", "frictionloss", "stiffness"}) {
      const auto field = read::number_field(read::attribute_text(element, what), 0);
      if (field.value == 0) continue;
      lose_of(joint, "free", field.span, what + (' ' + to_text({field.value, {}})));
    }
  }

  /// What follows another joint by more than a line follows its tangent.
  void take_couplings() {
    for (const model::Joint& joint : root_.joints) {
      if (joint.axes.empty() || !joint.axes[0].mimic) continue;
      const model::Mimic& mimic = *joint.axes[0].mimic;
      const xml::Element element = plan_.source.source.documents.element(mimic.site);
      take(element, kCoupling);
      const auto text = read::attribute_text(element, "polycoef");
      const auto numbers = text ? read::mjcf_numbers(text->text) : std::nullopt;
      if (!numbers) continue;
      const bool curved =
          std::any_of(numbers->begin() + std::min<std::ptrdiff_t>(2, std::ssize(*numbers)),
                      numbers->end(), [](double c) { return c != 0; });
      if (!curved) continue;
      ledger_.take_value(text->span, Outcome::kSubstituted);
      ledger_.note({.kind = NoteKind::kFromMjcfMimic,
                    .outcome = Outcome::kSubstituted,
                    .where = text->span,
                    .subject = model::subject(root_, joint),
                    .written = std::string(text->text)});
    }
  }

  /// An actuator of a joint with an effort limit; how it is controlled is lost.
  void take_drives() {
    for (const xml::Element element : plan_.scope.tree.in_sections("actuator")) {
      auto joint = read::attribute_text(element, "joint");
      if (!joint) joint = read::attribute_text(element, "jointinparent");
      if (!joint) continue;
      const auto index = plan_.joint_named(std::string(joint->text));
      if (!index) continue;
      const robot::Joint& driven = plan_.robot.joints[*index];
      if (driven.axes.size() != 1 || !std::isfinite(driven.axes[0].effort)) continue;
      take(element, kDrive, Outcome::kSubstituted);
      tell_one_sided(element);
    }
  }

  /// An effort limit is the same to both sides.
  void tell_one_sided(xml::Element drive) {
    for (const char* name : {"ctrlrange", "forcerange"}) {
      const auto text = read::attribute_text(drive, name);
      const auto range = text ? read::mjcf_numbers(text->text) : std::nullopt;
      if (!range || range->size() != 2 || (*range)[0] == -(*range)[1]) continue;
      ledger_.note(
          {.kind = NoteKind::kFromMjcfActuator,
           .outcome = Outcome::kSubstituted,
           .where = text->span,
           .subject = std::string(drive.name()) + " " + mjcf_word(drive, "name"),
           .written = std::string("the smaller side of ") + name + " " + std::string(text->text)});
    }
  }

  const MjcfPlan& plan_;
  Ledger& ledger_;
  const model::Root& root_;
};

std::string_view last_two(std::string_view path) {
  const std::size_t last = path.rfind('/');
  const std::size_t before = last == std::string_view::npos || last == 0
                                 ? std::string_view::npos
                                 : path.rfind('/', last - 1);
  return before == std::string_view::npos ? path : path.substr(before + 1);
}

}  // namespace

void take_mjcf_source(const MjcfPlan& plan, Ledger& ledger) { MjcfAccountant(plan, ledger).take(); }

NoteKind mjcf_source_kind(xml::Element element) {
  static constexpr std::pair<std::string_view, NoteKind> kKinds[] = {
      {"composite", NoteKind::kFromMjcfBodies},  {"flexcomp", NoteKind::kFromMjcfBodies},
      {"deformable", NoteKind::kFromMjcfBodies}, {"tendon", NoteKind::kFromMjcfTendon},
      {"equality", NoteKind::kFromMjcfEquality}, {"actuator", NoteKind::kFromMjcfActuator},
      {"sensor", NoteKind::kFromMjcfSensor},     {"contact", NoteKind::kFromMjcfContact},
      {"light", NoteKind::kFromMjcfLook},        {"camera", NoteKind::kFromMjcfLook},
      {"texture", NoteKind::kFromMjcfLook},      {"material", NoteKind::kFromMjcfLook},
      {"visual", NoteKind::kFromMjcfLook},       {"site", NoteKind::kFromMjcfSite},
      {"geom", NoteKind::kFromMjcfContact},      {"joint", NoteKind::kFromMjcfDynamics},
      {"option", NoteKind::kFromMjcfSetting},    {"size", NoteKind::kFromMjcfSetting},
      {"statistic", NoteKind::kFromMjcfSetting}, {"keyframe", NoteKind::kFromMjcfSetting},
      {"custom", NoteKind::kFromMjcfSetting},    {"extension", NoteKind::kFromMjcfSetting},
  };
  for (auto at = std::optional(element); at; at = at->parent()) {
    if (at->name() == "body" || at->name() == "default") break;
    const auto parent = at->parent();
    // A joint of a tendon or an equality is none of a body.
    const bool inner = parent && (parent->name() == "equality" || parent->name() == "actuator" ||
                                  parent->name() == "sensor" || parent->name() == "tendon");
    if (inner) continue;
    for (const auto& [name, kind] : kKinds) {
      if (at->name() == name) return kind;
    }
  }
  return NoteKind::kFromMjcfOther;
}

Account close_mjcf_account(Ledger ledger) {
  Account account = std::move(ledger).close(
      [](const model::Site&, xml::Element element) {
        return element.children().empty() && element.attributes().empty();
      },
      [](xml::Element, xml::Attribute attribute) {
        return attribute.name().substr(0, 5) == "xmlns";
      },
      mjcf_source_kind);
  for (Note& note : account.notes) {
    const bool path =
        note.kind >= NoteKind::kFromMjcfBodies && note.kind <= NoteKind::kFromMjcfOther;
    // Of a constraint that is in the result, which is as hard as a joint.
    const bool softness =
        note.kind == NoteKind::kFromMjcfEquality &&
        (note.written.ends_with("/@solref") || note.written.ends_with("/@solimp"));
    if (softness) note.kind = NoteKind::kFromMjcfDynamics;
    if (path && note.outcome == Outcome::kLost && note.instead.empty()) {
      note.written = std::string(last_two(note.written));
    }
  }
  return account;
}

}  // namespace rigor::convert
