// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/split.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/verbs/block.h>
#include <rigor/author/verbs/draft.h>
#include <rigor/author/verbs/inertial_block.h>
#include <rigor/author/verbs/lump/link_settings.h>
#include <rigor/author/verbs/placed.h>
#include <rigor/mass/link_body.h>
#include <rigor/xml/edit.h>
#include <rigor/xml/style.h>

namespace rigor::author {
namespace {

using model::Id;
using model::Pose;

class Splitter {
 public:
  Splitter(const EditedModel& edited, std::string_view link, const SplitRequest& request)
      : edited_(edited),
        root_(edited.root()),
        request_(request),
        draft_(edited),
        link_(link),
        new_(request.name.empty() ? link_ + "_part" : request.name),
        joint_(link_ + "_to_" + new_) {}

  Change split() {
    if (std::string fault = fault_of_request(); !fault.empty()) return refusal(std::move(fault));
    if (std::string fault = take(); !fault.empty()) return refusal(std::move(fault));
    if (std::string fault = share_mass(); !fault.empty()) return refusal(std::move(fault));
    write_links();
    rewrite_joints();
    if (!draft_.problem().empty()) return refusal(draft_.problem());
    Change change;
    change.steps = draft_.take();
    change.expected = law();
    change.notes = std::move(notes_);
    change.asks_for_setting = [names = std::pair(link_, new_)](const robot::Difference& each) {
      const std::string subjects = each.a + ' ' + each.b;
      return subjects.find(names.first) != std::string::npos ||
             subjects.find(names.second) != std::string::npos;
    };
    return change;
  }

 private:
  std::string fault_of_request() {
    if (edited_.loaded.file->expanded) return "it is a template";
    id_ = edited_.link(link_);
    if (!id_) return fmt::format("no link is named '{}'", link_);
    if (!root_.own(root_[id_].site) || root_[id_].model != edited_.model)
      return fmt::format("link '{}' is in another model or file", link_);
    const auto is_taken = [&](const std::string& name) {
      return edited_.link(name) || edited_.joint(name) || edited_.frame(name);
    };
    for (const std::string& name : {new_, joint_}) {
      if (is_taken(name))
        return fmt::format("the name '{}' is taken: choose one with --name", name);
    }
    if (root_[id_].inertial.automatic.value)
      return "the link's inertial is computed from its shapes";
    if (!edited_.is_urdf() && root_[edited_.model].version == 0)
      return "it is SDF 1.0: upgrade it first";
    return {};
  }

  // --- What goes ---

  std::string take() {
    std::map<std::string, std::size_t> count;
    std::set<std::string> missing(request_.take.begin(), request_.take.end());
    const auto is_asked = [&](const std::string& name) {
      return !name.empty() &&
             std::find(request_.take.begin(), request_.take.end(), name) != request_.take.end();
    };
    for (const xml::Element child : edited_.element(root_[id_].site).children()) {
      const std::string kind(child.name());
      if (kind != "visual" && kind != "collision" && kind != "sensor" && kind != "light") continue;
      const std::string numbered = kind + '/' + std::to_string(++count[kind]);
      const auto attribute = child.attribute("name");
      const std::string name(attribute ? attribute->value() : std::string_view());
      if (!is_asked(name) && !is_asked(numbered)) continue;
      missing.erase(name);
      missing.erase(numbered);
      taken_.insert(child.index());
    }
    for (const robot::Joint& joint : edited_.robot.joints) {
      if (!is_asked(joint.name) || joint.parent != edited_.body_index(link_)) continue;
      const Id<model::Joint> id = edited_.joint(joint.name);
      if (root_[id].parent.value != link_)
        return fmt::format("joint '{}' names the link otherwise than as its parent", joint.name);
      missing.erase(joint.name);
      joints_.insert(joint.name);
    }
    if (missing.empty()) return {};
    return fmt::format("link '{}' holds nothing that is named '{}'", link_, *missing.begin());
  }

  bool is_taken(const model::Site& site) const {
    return taken_.contains(edited_.element(site).index());
  }

  // --- Mass ---

  std::string share_mass() {
    const robot::Body& body = edited_.robot.bodies[edited_.body_index(link_)];
    whole_ = mass::transformed(inverse(X_BL()), body.mass);
    stays_ = whole_;
    if (request_.share == SplitMass::kStays) {
      if (edited_.is_urdf()) return {};
      return "a link of SDF weighs 1 kg where nothing is written: give its part of the mass with "
             "--mass KG, or --mass shapes";
    }
    const auto [taken, left] = shapes();
    double mass = request_.mass;
    if (request_.share == SplitMass::kShapes) {
      if (!(taken.mass > 0)) return "what is taken has no volume: give its mass with --mass KG";
      mass = whole_.mass * taken.mass / (taken.mass + left.mass);
    }
    if (!(mass > 0) || !(mass < whole_.mass || (left.mass == 0 && mass == whole_.mass)))
      return fmt::format("the new link can have a mass between 0 and {} kg", whole_.mass);
    if (taken.mass > 0) {
      goes_ = with_mass(taken, mass);
      stays_ = subtract(whole_, goes_);
      if (judge(stays_).possible()) return {};
      notes_.push_back(
          "what remains would be no body if the new link had the mass of its shapes: "
          "it has a share of each piece of the link's matter instead");
    }
    const double share = mass / whole_.mass;
    goes_ = {mass, whole_.com, share * whole_.about_com};
    stays_ = {whole_.mass - mass, whole_.com, (1 - share) * whole_.about_com};
    return {};
  }

  /// At density 1, in the link.
  std::pair<mass::MassProperties, mass::MassProperties> shapes() const {
    mass::MassProperties taken, left;
    for (const mass::From from : {mass::From::kCollisions, mass::From::kVisuals}) {
      const mass::LinkBody body = link_body(root_, edited_.frames, id_, from, edited_.find_mesh);
      std::size_t k = 0;
      const auto sort = [&](const auto& ids) {
        for (const auto part : ids) {
          if (k == body.parts.size()) return;
          const mass::PartBody& each = body.parts[k++];
          if (each.why != mass::NoSolid::kNone) continue;
          mass::MassProperties& sum = is_taken(root_[part].site) ? taken : left;
          sum = sum.mass == 0 ? each.unit : mass::add(sum, each.unit);
        }
      };
      if (from == mass::From::kCollisions)
        sort(root_[id_].collisions);
      else
        sort(root_[id_].visuals);
      if (taken.mass > 0) break;
    }
    return {taken, left};
  }

  // --- The file ---

  void write_links() {
    const xml::Document& document = edited_.document();
    const xml::Element element = edited_.element(root_[id_].site);
    const std::string line(xml::line_end(document, 0));
    const std::string in = xml::indentation(document, element);
    const std::string unit = xml::indent_unit(document, element);
    const std::vector<Edit> edits = poses_in_new();
    std::string text = line + in + fmt::format("<link name=\"{}\">", xml::escaped(new_)) + line;
    const auto add = [&](const std::string& xml) {
      text += indented_by(xml, in + unit, line) + line;
    };
    if (!edited_.is_urdf()) add(pose_text());
    if (goes_.mass > 0) {
      add(inertial_block(goes_, edited_.is_urdf() ? InertialForm::kUrdf : InertialForm::kSdf,
                         inverse(request_.X_LN)));
    }
    for (const xml::Element child : element.children()) {
      if (!edited_.is_urdf() && is_link_setting(child.name()))
        text += xml::indentation(document, child) + bytes_of(child) + line;
      if (!taken_.contains(child.index())) continue;
      text += xml::indentation(document, child) +
              part_after(document, child.span().begin, child.span().end, edits) + line;
      draft_.remove(child);
    }
    text += in + "</link>" + line + in +
            fmt::format("<joint name=\"{}\" type=\"fixed\">", xml::escaped(joint_)) + line;
    if (edited_.is_urdf()) {
      add(fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", xyz_text(request_.X_LN),
                      rpy_text(request_.X_LN)));
      add(fmt::format("<parent link=\"{}\"/>", xml::escaped(link_)));
      add(fmt::format("<child link=\"{}\"/>", xml::escaped(new_)));
    } else {
      add(fmt::format("<parent>{}</parent>", xml::escaped(link_)));
      add(fmt::format("<child>{}</child>", xml::escaped(new_)));
    }
    text += in + "</joint>" + block_of_settings(in, unit, line);
    const Span span = element.span();
    draft_.add({{{span.source, span.end, span.end}, std::move(text)}});
    if (goes_.mass == 0) return;
    set_inertial(draft_, edited_, root_[id_], stays_);
  }

  std::string bytes_of(xml::Element element) const {
    return std::string(edited_.sources.bytes(element.span()));
  }

  /// URDF: what the link's `<gazebo>` blocks say of it, for the new one.
  std::string block_of_settings(const std::string& in, const std::string& unit,
                                const std::string& line) const {
    std::string content;
    for (const model::GazeboBlock& block : root_.gazebo_blocks) {
      if (block.reference.value != link_ || !root_.own(block.site)) continue;
      for (const xml::Element child : edited_.element(block.site).children()) {
        if (is_block_setting(child.name())) content += in + unit + bytes_of(child) + line;
      }
    }
    if (content.empty()) return {};
    return line + in + fmt::format("<gazebo reference=\"{}\">", xml::escaped(new_)) + line +
           content + in + "</gazebo>";
  }

  std::string pose_text() const {
    if (root_[edited_.model].version >= 7) {
      return fmt::format("<pose relative_to=\"{}\">{} {}</pose>", xml::escaped(link_),
                         xyz_text(request_.X_LN), rpy_text(request_.X_LN));
    }
    const Pose X_MN = compose(X_ML(), request_.X_LN);
    return fmt::format("<pose>{} {}</pose>", xyz_text(X_MN), rpy_text(X_MN));
  }

  /// Of what goes: what is in the default frame of the link is in that of the new one.
  std::vector<Edit> poses_in_new() {
    Draft moved(edited_);
    for (const Placed& each : placed_in(edited_)) {
      if (!taken_.contains(each.holder.index()) || !each.field.relative_to.value.empty()) continue;
      moved.set_pose(each.field, each.holder,
                     compose(inverse(request_.X_LN), each.field.pose.value));
    }
    return draft_.edits_for_copy(std::move(moved));
  }

  /// SDF: a joint's pose is in its child, and stays.
  void rewrite_joints() {
    for (const std::string& name : joints_) {
      const model::Joint& joint = root_[edited_.joint(name)];
      draft_.add({{joint.parent.span, xml::escaped(new_)}});
      if (edited_.is_urdf())
        draft_.set_pose(joint.pose, edited_.element(joint.site),
                        compose(inverse(request_.X_LN), joint.pose.pose.value));
    }
  }

  // --- The law ---

  Pose X_ML() const {
    return compose(inverse(*edited_.frames.pose(edited_.model)), *edited_.frames.pose(id_));
  }
  /// Of the link's frame in that of its body.
  Pose X_BL() const {
    return compose(inverse(edited_.robot.bodies[edited_.body_index(link_)].X_MB), X_ML());
  }

  robot::Robot law() const {
    robot::Robot after = edited_.robot;
    const std::uint32_t old = edited_.body_index(link_);
    const Pose X_BN = compose(X_BL(), request_.X_LN);
    const Pose X_NB = inverse(X_BN);
    robot::Body part;
    part.name = new_;
    const auto move = [&](const auto& ids, std::vector<robot::Part>& from,
                          std::vector<robot::Part>& to) {
      std::vector<robot::Part> stay;
      for (std::size_t i = 0; i < from.size(); ++i) {
        if (!is_taken(root_[ids[i]].site)) {
          stay.push_back(from[i]);
          continue;
        }
        from[i].X_BS = compose(X_NB, from[i].X_BS);
        to.push_back(from[i]);
      }
      from = std::move(stay);
    };
    robot::Body& body = after.bodies[old];
    move(root_[id_].collisions, body.collisions, part.collisions);
    move(root_[id_].visuals, body.visuals, part.visuals);
    if (goes_.mass > 0) {
      body.mass = mass::transformed(X_BL(), stays_);
      part.mass = mass::transformed(inverse(request_.X_LN), goes_);
    }
    // `world` is last.
    auto index = static_cast<std::uint32_t>(after.bodies.size());
    after.bodies.push_back(std::move(part));
    robot::Joint joint;
    joint.name = joint_;
    joint.type = model::JointType::kFixed;
    joint.parent = old;
    joint.child = index;
    joint.X_PJ = X_BN;
    for (robot::Joint& each : after.joints) {
      if (!joints_.contains(each.name)) continue;
      each.parent = index;
      each.X_PJ = compose(X_NB, each.X_PJ);
    }
    after.joints.push_back(std::move(joint));
    robot::connect(after);
    return after;
  }

  const EditedModel& edited_;
  const model::Root& root_;
  const SplitRequest& request_;
  Draft draft_;
  std::string link_, new_, joint_;
  Id<model::Link> id_;
  std::set<std::uint32_t> taken_;  // elements
  std::set<std::string> joints_;
  mass::MassProperties whole_, stays_, goes_;  // in the link
  std::vector<std::string> notes_;
};

}  // namespace

std::optional<Pose> place_in_link(const EditedModel& edited, std::string_view link,
                                  std::string_view name) {
  const Id<model::Link> holder = edited.link(link);
  if (!holder) return std::nullopt;
  std::optional<Pose> X_WN;
  if (const auto id = edited.link(name)) X_WN = edited.frames.pose(id);
  if (const auto id = edited.frame(name); id && !X_WN) X_WN = edited.frames.pose(id);
  if (const auto id = edited.joint(name); id && !X_WN) X_WN = edited.frames.pose(id);
  const auto X_WL = edited.frames.pose(holder);
  if (!X_WN || !X_WL) return std::nullopt;
  return compose(inverse(*X_WL), *X_WN);
}

Change split(const EditedModel& edited, std::string_view link, const SplitRequest& request) {
  return Splitter(edited, link, request).split();
}

}  // namespace rigor::author
