// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <rigor/mass/resolve.h>
#include <rigor/model/motion.h>
#include <rigor/report/page/json_page.h>
#include <rigor/write/inertial_text.h>

namespace rigor::report {
namespace {

using model::Id;
using model::JointType;

Json limit(double value) { return finite(model::position_limit(value)); }

bool can_be_set(JointType type) {
  switch (type) {
    case JointType::kRevolute:
    case JointType::kContinuous:
    case JointType::kPrismatic:
    case JointType::kUniversal:
    case JointType::kRevolute2:
    case JointType::kScrew:
    case JointType::kGearbox: return true;
    default: return false;
  }
}

class EntityWriter {
 public:
  EntityWriter(const ModelPage& page, PageFiles& files)
      : page_(page), root_(page.root), frames_(page.frames), files_(files) {
    for (const model::Model& model : root_.models) {
      model_index_.push_back(model.merged ? -1 : shown_models_++);
    }
    moved_by_.resize(root_.links.size(), -1);
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {  // of two the first one drives
      const Id<model::Link> child = frames_.ends(Id<model::Joint>{i}).child;
      if (child && moved_by_[child.value] < 0) moved_by_[child.value] = static_cast<int>(i);
    }
  }

  /// What is left of a merged model is no model.
  Json models() {
    Json list = Json::array();
    for (std::uint32_t i = 0; i < root_.models.size(); ++i) {
      const Id<model::Model> id{i};
      if (root_[id].merged) continue;
      Json json = {{"name", root_[id].name.value},
                   {"scoped", scoped_name(root_, id)},
                   {"parent", shown_model(root_[id].parent)}};
      files_.place(json, root_[id].site.tag);
      list.push_back(std::move(json));
    }
    return list;
  }

  Json links() {
    Json list = Json::array();
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) list.push_back(link({i}));
    return list;
  }

  Json joints() {
    Json list = Json::array();
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) list.push_back(joint({i}));
    return list;
  }

  /// After the links. Of those that can move, as `simulate` takes them.
  Json total_mass() const { return mass_ > 0 ? finite(mass_) : Json(nullptr); }
  Json center_of_mass() const {
    return mass_ > 0 && placed_ ? vector_of((1 / mass_) * moment_) : Json(nullptr);
  }

 private:
  int shown_model(Id<model::Model> id) const {
    for (std::size_t depth = 0; id && depth <= root_.models.size(); ++depth) {
      if (!root_[id].merged) return model_index_[id.value];
      id = root_[id].parent;
    }
    return -1;
  }

  Json link(Id<model::Link> id) {
    const model::Link& link = root_[id];
    const std::optional<model::Pose> X_WL = frames_.pose(id);
    Json json = {{"name", link.name.value},
                 {"scoped", scoped_name(root_, id)},
                 {"model", shown_model(link.model)},
                 {"pose", pose_array(X_WL)},
                 {"mass", nullptr},
                 {"com", nullptr},
                 {"inertia", nullptr},
                 {"inertialText", ""},
                 {"movedBy", moved_by_[id.value]}};
    const mass::Resolved taken = mass::resolve(root_, frames_, id, page_.find_mesh);
    const bool known =
        taken.taken != mass::Taken::kNothing && taken.taken != mass::Taken::kAutomaticUnknown;
    if (known) add_mass(json, link, taken.body);
    if (known && !is_static(root_, link.model)) add_to_total(X_WL, taken.body);
    files_.place(json, link.site.tag);
    return json;
  }

  void add_mass(Json& json, const model::Link& link, const mass::MassProperties& body) const {
    const mass::Inertia& I = body.about_com;
    json["mass"] = finite(body.mass);
    json["com"] = vector_of(body.com);
    json["inertia"] = Json::array(
        {finite(I.ixx), finite(I.ixy), finite(I.ixz), finite(I.iyy), finite(I.iyz), finite(I.izz)});
    const bool urdf = root_[link.model].format == model::Format::kUrdf;
    json["inertialText"] =
        write::inertial_text(body, urdf ? write::BlockFormat::kUrdf : write::BlockFormat::kSdf);
  }

  void add_to_total(const std::optional<model::Pose>& X_WL, const mass::MassProperties& body) {
    mass_ += body.mass;
    placed_ = placed_ && X_WL;
    if (X_WL) moment_ = moment_ + body.mass * transform(*X_WL, body.com);
  }

  Json joint(Id<model::Joint> id) {
    const model::Joint& joint = root_[id];
    const model::Frames::Ends& ends = frames_.ends(id);
    Json json = {{"name", joint.name.value},
                 {"scoped", scoped_name(root_, id)},
                 {"model", shown_model(joint.model)},
                 {"type", to_string(joint.type)},
                 {"parent", index_or_none(ends.parent)},
                 {"child", index_or_none(ends.child)},
                 {"pose", pose_array(frames_.pose(id))},
                 {"axes", axes(id)}};
    files_.place(json, joint.site.tag);
    return json;
  }

  /// Where the direction of one is not known, none of them can be set.
  Json axes(Id<model::Joint> id) const {
    const model::Joint& joint = root_[id];
    Json list = Json::array();
    for (std::size_t i = 0; i < joint.axes.size() && can_be_set(joint.type); ++i) {
      const std::optional<model::Vector3> direction = frames_.axis(id, i);
      if (!direction) return Json::array();
      const model::Axis& axis = joint.axes[i];
      const bool limited = joint.type != JointType::kContinuous;
      list.push_back({{"direction", vector_of(*direction)},
                      {"slides", joint.type == JointType::kPrismatic},
                      {"lower", limited ? limit(axis.lower.value) : Json(nullptr)},
                      {"upper", limited ? limit(axis.upper.value) : Json(nullptr)},
                      {"mimic", axis.mimic ? mimic(joint, *axis.mimic) : Json(nullptr)}});
    }
    return list;
  }

  /// Null where the leader is not there.
  Json mimic(const model::Joint& joint, const model::Mimic& mimic) const {
    const Id<model::Joint> leader = frames_.names().find_joint(joint.model, mimic.joint.value);
    if (!leader) return nullptr;
    return {{"joint", leader.value},
            {"axis", mimic.axis.value == "axis2" ? 1 : 0},
            {"multiplier", finite(mimic.multiplier.value)},
            {"offset", finite(mimic.offset.value)},
            {"reference", finite(mimic.reference.value)}};
  }

  const ModelPage& page_;
  const model::Root& root_;
  const model::Frames& frames_;
  PageFiles& files_;
  std::vector<int> model_index_;
  int shown_models_ = 0;
  std::vector<int> moved_by_;
  double mass_ = 0;
  model::Vector3 moment_;
  bool placed_ = true;
};

}  // namespace

void add_entities(Json& data, const ModelPage& page, PageFiles& files) {
  EntityWriter writer(page, files);
  Json models = writer.models();
  Json links = writer.links();
  std::map<view::Layer, std::size_t> triangles;
  for (const view::Body& body : page.drawing.bodies) {
    triangles[body.layer] += body.mesh->triangles.size();
  }
  data["totals"] = {{"links", page.root.links.size()},
                    {"joints", page.root.joints.size()},
                    {"visuals", page.root.visuals.size()},
                    {"collisions", page.root.collisions.size()},
                    {"triangles",
                     {{"visual", triangles[view::Layer::kVisual]},
                      {"collision", triangles[view::Layer::kCollision]}}},
                    {"mass", writer.total_mass()},
                    {"com", writer.center_of_mass()}};
  data["models"] = std::move(models);
  data["links"] = std::move(links);
  data["joints"] = writer.joints();
}

}  // namespace rigor::report
