// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/upgrade/downgrade.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/author/patched_text.h>
#include <rigor/author/upgrade/config.h>
#include <rigor/author/upgrade/step.h>
#include <rigor/author/verbs/block.h>
#include <rigor/model/frames.h>
#include <rigor/model/motion.h>
#include <rigor/model/subject.h>
#include <rigor/read/conformance.h>
#include <rigor/read/values.h>
#include <rigor/read/workspace.h>
#include <rigor/schema/value.h>
#include <rigor/text/sources.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

using model::Id;
using model::Pose;
using model::Vector3;
using xml::Element;

// First versions with what older ones have not.
constexpr int kNestedModels = 5;
constexpr int kWorldGravity = 6;
constexpr int kPoseFrames = 7;
constexpr int kNestedNames = 8;
constexpr int kRotationFormats = 9;
constexpr int kInfinities = 10;  // and the pitch of a screw in m, merged includes
constexpr int kAutomaticInertials = 11;
constexpr int kNamedStates = 12;

class Downgrader {
 public:
  Downgrader(const Environment& environment, const read::Loaded& loaded, schema::Version to,
             VersionLosses losses)
      : environment_(environment),
        loaded_(loaded),
        root_(loaded.root),
        document_(*loaded.file->document),
        frames_(loaded.root),
        to_(to.minor),
        losses_(losses) {
    result_.to = to;
    result_.text = document_.bytes();
  }

  Upgrade downgrade() {
    if (!may_be_downgraded() || result_.from == result_.to) return finish();
    refuse_what_cannot_be();
    if (!notes_.has_errors()) {
      write_poses();
      write_joints();
      write_models();
      write_worlds();
      edit(xml::set_attribute(document_, *document_.root(), "version", to_string(result_.to)));
      prove();
    }
    return finish();
  }

 private:
  // --- Notes ---

  void refuse(UpgradeNoteKind kind, Span where, std::string message) {
    notes_.add({kind, Severity::kError, where, std::move(message)});
  }
  void lose(Span where, std::string message) {
    const bool allowed = losses_ == VersionLosses::kAllowed;
    if (!allowed) message += ": --allow-loss leaves it out";
    notes_.add({UpgradeNoteKind::kLost, allowed ? Severity::kWarning : Severity::kError, where,
                std::move(message)});
  }

  bool may_be_downgraded() {
    const auto version = schema::parse_version(root_.version_text.value);
    if (!document_.complete()) {
      refuse(UpgradeNoteKind::kNotReadable, {}, "is not well-formed: validate says where");
    } else if (root_.format != model::Format::kSdf) {
      refuse(UpgradeNoteKind::kNotSdf, {}, "is no SDF file");
    } else if (!root_.version_text.written || !version || !environment_.sdf.knows(*version)) {
      refuse(UpgradeNoteKind::kVersionUnknown, root_.site.tag,
             "states no version that was published");
    } else if (*version < result_.to) {
      result_.from = *version;
      refuse(UpgradeNoteKind::kNewer, root_.version_text.span,
             fmt::format("is SDF {}, which is older than {}: use upgrade", root_.version_text.value,
                         to_string(result_.to)));
    } else {
      result_.from = *version;
    }
    return !notes_.has_errors();
  }

  void refuse_what_cannot_be() {
    for (const model::Include& include : root_.includes) {
      if (!root_.own(include.site)) continue;
      if (include.merge.value && to_ < kInfinities)
        refuse(UpgradeNoteKind::kLost, include.site.tag,
               "an included model is merged since 1.10: copy it in first");
      if (!include.placement_frame.value.empty() && to_ < kNestedNames)
        refuse(UpgradeNoteKind::kLost, include.site.tag,
               "an included model is placed by a frame of it since 1.8: write its pose first");
    }
    for (const model::Link& link : root_.links) {
      if (link.inertial.automatic.value && root_.own(link.site) && to_ < kAutomaticInertials)
        refuse(UpgradeNoteKind::kLost, link.inertial.site.tag,
               fmt::format("link '{}' gets its inertial from its shapes since 1.11: write it with "
                           "rigor inertia --only missing first",
                           link.name.value));
    }
    for (const model::Model& model : root_.models) {
      if (model.parent && root_.own(model.site) && to_ < kNestedModels)
        refuse(UpgradeNoteKind::kLost, model.site.tag, "models are nested since 1.5");
    }
  }

  void edit(std::vector<Edit> edits) { append(edits_, std::move(edits)); }
  Element element(const model::Site& site) const { return document_.element(site.element); }

  // --- Poses ---

  bool drops_frames() const { return result_.from.minor >= kPoseFrames && to_ < kPoseFrames; }

  template <class T>
  std::optional<Pose> in(const std::optional<Pose>& X_WF, Id<T> id) const {
    const auto X_WT = frames_.pose(id);
    if (!X_WF || !X_WT) return std::nullopt;
    return compose(inverse(*X_WF), *X_WT);
  }

  void write_poses() {
    each(root_.models, [&](auto id, const model::Model& model) {
      if (model.include != 0xffffffffU) return;
      const auto X_WP = model.parent ? frames_.pose(model.parent) : std::optional(Pose{});
      const bool placed = !model.placement_frame.value.empty() && to_ < kNestedNames;
      write_pose(model.pose, model.site, in(X_WP, id), placed);
    });
    each(root_.links, [&](auto id, const model::Link& link) {
      write_pose(link.pose, link.site, in(frames_.pose(link.model), id), false);
    });
    each(root_.joints, [&](auto id, const model::Joint& joint) {
      const Id<model::Link> child = frames_.ends(id).child;
      const bool is_frame =
          drops_frames() && child && joint.child.value != name_in(joint.model, child);
      write_pose(joint.pose, joint.site,
                 child ? in(frames_.pose(child), id) : std::optional<Pose>(), is_frame);
    });
    const auto of_link = [&](auto id, const auto& part) {
      if (part.link) write_pose(part.pose, part.site, in(frames_.pose(part.link), id), false);
    };
    each(root_.collisions, of_link);
    each(root_.visuals, of_link);
    each(root_.sensors, [&](auto id, const model::Sensor& sensor) {
      write_pose(sensor.pose, sensor.site,
                 in(sensor.joint ? frames_.pose(sensor.joint) : frames_.pose(sensor.link), id),
                 false);
    });
    each(root_.lights, [&](auto id, const model::Light& light) {
      const auto X_WF = light.link ? frames_.pose(light.link) : std::optional(Pose{});
      write_pose(light.pose, light.site, in(X_WF, id), false);
    });
    for (const model::Include& include : root_.includes) {
      if (!root_.own(include.site)) continue;
      const auto X_WP = include.model ? frames_.pose(include.model) : std::optional(Pose{});
      write_pose(include.pose, include.site,
                 include.loaded ? in(X_WP, include.loaded) : std::nullopt, false);
    }
    for (const model::Link& link : root_.links) {
      if (root_.own(link.site) && link.inertial.written)
        write_pose(link.inertial.pose, link.inertial.site, link.inertial.pose.pose.value, false);
    }
    // Of frames that stay.
    if (!drops_frames()) {
      each(root_.frames, [&](auto, const model::Frame& frame) {
        write_pose(frame.pose, frame.site, std::nullopt, false);
      });
    }
  }

  template <class T, class Visit>
  void each(const std::vector<T>& all, Visit visit) {
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (root_.own(all[i].site)) visit(Id<T>{i}, all[i]);
    }
  }

  /// `X` is in the frame that the older version takes for granted.
  void write_pose(const model::PoseField& field, const model::Site& holder,
                  const std::optional<Pose>& X, bool must_be_written) {
    const auto pose = element(holder).child("pose");
    const std::string& frame = field.relative_to.value;
    const bool in_frame =
        !frame.empty() &&
        (drops_frames() || (to_ < kNestedNames && frame.find("::") != std::string::npos));
    std::vector<xml::Attribute> gone;
    if (pose) {
      for (const xml::Attribute attribute : pose->attributes()) {
        const std::string_view name = attribute.name();
        const bool rotation = name == "rotation_format" || name == "degrees";
        if ((rotation && to_ < kRotationFormats) ||
            (name == "relative_to" && (in_frame || to_ < kPoseFrames)))
          gone.push_back(attribute);
      }
    }
    const bool other_words = std::any_of(gone.begin(), gone.end(), [](const xml::Attribute& each) {
      return each.name() != "relative_to";
    });
    for (const xml::Attribute attribute : gone) edit(xml::remove_attribute(document_, attribute));
    if (!in_frame && !must_be_written && !other_words) return;
    const bool moved = in_frame || must_be_written;
    if (moved && !X) {
      return refuse(UpgradeNoteKind::kNotTheSame, element(holder).tag_span(),
                    "where it is cannot be told");
    }
    const Pose& value = moved ? *X : field.pose.value;
    const std::string numbers = xyz_text(value) + ' ' + rpy_text(value);
    if (pose)
      edit(xml::set_text(document_, *pose, numbers));
    else if (!(value == Pose{}))
      edit(xml::insert_child(document_, element(holder), std::nullopt,
                             "<pose>" + numbers + "</pose>"));
  }

  // --- Joints ---

  std::string name_in(Id<model::Model> model, Id<model::Link> link) const {
    const std::string whole = scoped_name(root_, link);
    const std::size_t prefix = scoped_name(root_, model).size() + 2;
    return whole.size() > prefix ? whole.substr(prefix) : whole;
  }

  void write_joints() {
    each(root_.joints, [&](Id<model::Joint> id, const model::Joint& joint) {
      if (drops_frames()) {
        const model::Frames::Ends& ends = frames_.ends(id);
        if (!ends.parent_is_world) write_end(joint, "parent", joint.parent.value, ends.parent);
        write_end(joint, "child", joint.child.value, ends.child);
      }
      for (std::size_t k = 0; k < joint.axes.size(); ++k) {
        if (to_ < kPoseFrames && k < 2) write_axis(id, joint, k);
        write_limits(joint.axes[k]);
      }
      if (joint.type == model::JointType::kScrew) write_screw(joint);
    });
  }

  void write_end(const model::Joint& joint, const char* name, const std::string& written,
                 Id<model::Link> link) {
    const auto end = element(joint.site).child(name);
    if (!end) return;
    if (!link) return refuse(UpgradeNoteKind::kNotTheSame, end->tag_span(), "names no link");
    const std::string other = name_in(joint.model, link);
    if (other != written) edit(xml::set_text(document_, *end, xml::escaped(other)));
  }

  void write_axis(Id<model::Joint> id, const model::Joint& joint, std::size_t k) {
    const model::Axis& axis = joint.axes[k];
    const Element written = element(axis.site);
    const auto xyz = written.child("xyz");
    const auto flag = written.child("use_parent_model_frame");
    const bool of_model = axis.expressed_in.value == "__model__";
    const bool to_model = to_ < kNestedModels;  // 1.4: whatever is written
    if (const auto attribute = xyz ? xyz->attribute("expressed_in") : std::nullopt)
      edit(xml::remove_attribute(document_, *attribute));
    if (flag && to_model) edit(xml::remove_element(document_, *flag));
    if (of_model) {
      if (!to_model && !flag)
        edit(xml::insert_child(document_, written, xyz,
                               "<use_parent_model_frame>true</use_parent_model_frame>"));
      return;
    }
    if (!to_model && axis.expressed_in.value.empty()) return;
    const auto in_world = frames_.axis(id, k);
    const auto X_WF = to_model ? frames_.pose(joint.model) : frames_.pose(id);
    if (!in_world || !X_WF)
      return refuse(UpgradeNoteKind::kNotTheSame, written.tag_span(), "its direction is not known");
    const Vector3 v = length(axis.xyz.value) * rotate(conjugate(X_WF->rotation), *in_world);
    const auto number = [](double value) { return write::settled(value, 0, 1); };
    const std::string text = write::joined({number(v.x), number(v.y), number(v.z)});
    if (xyz)
      edit(xml::set_text(document_, *xyz, text));
    else
      edit(xml::insert_child(document_, written, std::nullopt, "<xyz>" + text + "</xyz>"));
  }

  void write_limits(const model::Axis& axis) {
    if (to_ >= kInfinities) return;
    const auto write = [&](const model::Field<double>& field, const char* none) {
      if (field.written && !field.span.nowhere() && std::isinf(field.value))
        edits_.push_back({field.span, none});
    };
    write(axis.lower, axis.lower.value < 0 ? "-1e16" : "1e16");
    write(axis.upper, axis.upper.value < 0 ? "-1e16" : "1e16");
    write(axis.effort, "-1");
    write(axis.velocity, "-1");
  }

  void write_screw(const model::Joint& joint) {
    if (to_ >= kInfinities || result_.from.minor < kInfinities) return;
    const Element written = element(joint.site);
    const auto pitch = written.child("screw_thread_pitch");
    if (pitch) edit(xml::remove_element(document_, *pitch));
    if (!pitch && written.child("thread_pitch")) return;
    const double lead = model::screw_lead(root_, joint);
    const std::string text = schema::to_shortest(-1 / lead);
    if (const auto old = written.child("thread_pitch"))
      edit(xml::set_text(document_, *old, text));
    else
      edit(xml::insert_child(document_, written, written.child("child"),
                             "<thread_pitch>" + text + "</thread_pitch>"));
  }

  // --- Models and worlds ---

  void write_models() {
    each(root_.models, [&](Id<model::Model> id, const model::Model& model) {
      const Element written = element(model.site);
      const auto drop = [&](const char* name) {
        if (const auto attribute = written.attribute(name))
          edit(xml::remove_attribute(document_, *attribute));
      };
      if (drops_frames()) {
        const Id<model::Link> canonical = frames_.canonical_link(id);
        if (!model.canonical_link.value.empty() && !model.links.empty() &&
            canonical != model.links.front())
          lose(model.canonical_link.span,
               fmt::format("model '{}': its canonical link is the first one up to 1.6",
                           model.name.value));
        drop("canonical_link");
      }
      if (to_ < kNestedNames) drop("placement_frame");
    });
    if (!drops_frames()) return;
    each(root_.frames, [&](auto, const model::Frame& frame) {
      lose(frame.site.tag, fmt::format("frame '{}': SDF has frames since 1.7", frame.name.value));
      edit(xml::remove_element(document_, element(frame.site)));
    });
  }

  void write_worlds() {
    constexpr std::array<std::string_view, 5> kStates{"model", "joint", "link", "light",
                                                      "collision"};
    for (std::uint32_t i = 0; i < document_.element_count(); ++i) {
      const Element each = document_.element(i);
      const std::string_view name = each.name();
      if (name == "world" && to_ < kWorldGravity && result_.from.minor >= kWorldGravity)
        move_gravity(each);
      if (to_ >= kNamedStates) continue;
      for (const std::string_view state : kStates) {
        if (name == std::string(state) + "_state")
          edit(xml::rename_element(document_, each, state));
      }
    }
  }

  void move_gravity(Element world) {
    std::string moved;
    const auto physics = world.child("physics");
    for (const std::string_view name : {"gravity", "magnetic_field"}) {
      const auto own = world.child(name);
      if (!own) continue;
      if (!physics)
        return lose(own->tag_span(), "gravity and magnetic field are in <physics> up to 1.5");
      moved += fmt::format("{0}<{1}>{2}</{1}>", moved.empty() ? "" : "\n", name,
                           read::trimmed(own->text()));
      edit(xml::remove_element(document_, *own));
    }
    if (!moved.empty()) edit(xml::insert_child(document_, *physics, std::nullopt, moved));
  }

  // --- The proof ---

  void prove() {
    PatchedText text(std::string(document_.bytes()));
    if (!text.apply(std::move(edits_))) {
      return refuse(UpgradeNoteKind::kNotReadable, root_.site.tag,
                    "two changes meet in one place; put each element on a line of its own");
    }
    Sources sources;
    read::Workspace workspace(environment_.disk, sources);
    const read::Reader reader{workspace, environment_.resolver, environment_.sdf,
                              environment_.urdf};
    const read::File& file = workspace.put(loaded_.file->path, text.text());
    const read::Loaded after = read::load(reader, file);
    name_losses(*file.document, PlacesBefore(text.edits(document_.source())));
    if (notes_.has_errors()) return;
    notes_.take(differences_after_downgrade(loaded_, after), [](Span span) { return span; });
    if (notes_.has_errors()) return;
    result_.edits = text.edits(document_.source());
    result_.text = text.text();
    ConfigUpgrade config = upgrade_config(environment_.disk, loaded_.file->path, result_.to);
    for (UpgradeNote& note : config.notes) notes_.add(std::move(note));
    result_.config = std::move(config.change);
  }

  /// What stays though the older version does not know it.
  void name_losses(const xml::Document& after, const PlacesBefore& places) {
    const auto top = after.root();
    const auto root = top ? environment_.sdf.root(top->name(), result_.to) : std::nullopt;
    if (!root) return;
    read::check_conformance(after, *root, [&](const read::SchemaFact& fact) {
      if (fact.kind != read::SchemaFactKind::kNewerThanVersion || !fact.node) return;
      const std::string what =
          fact.attribute
              ? fmt::format("attribute {} of <{}>", fact.attribute->name(), fact.element.name())
              : fmt::format("<{}>", fact.element.name());
      lose(places.of(fact.where),
           fmt::format("{}: consumers of SDF {} ignore it", what, to_string(result_.to)));
    });
  }

  Upgrade finish() {
    result_.notes = notes_.take_list();
    return std::move(result_);
  }

  const Environment& environment_;
  const read::Loaded& loaded_;
  const model::Root& root_;
  const xml::Document& document_;
  model::Frames frames_;
  int to_;
  VersionLosses losses_;
  std::vector<Edit> edits_;
  UpgradeNotes notes_;
  Upgrade result_;
};

}  // namespace

Upgrade downgrade(const Environment& environment, const read::Loaded& loaded, schema::Version to,
                  VersionLosses losses) {
  if (!loaded.file->document) {
    Upgrade result;
    result.to = to;
    result.notes.push_back({UpgradeNoteKind::kNotReadable,
                            Severity::kError,
                            {},
                            "cannot be read: " + loaded.file->problem});
    return result;
  }
  return Downgrader(environment, loaded, to, losses).downgrade();
}

}  // namespace rigor::author
