// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/resolve.h>
#include <rigor/report/inspect/inspect.h>
#include <rigor/report/json/values.h>
#include <rigor/report/number.h>
#include <rigor/report/tool.h>

namespace rigor::report {
namespace {

using model::Id;

Json pose_of(const std::optional<model::Pose>& pose) {
  if (!pose) return nullptr;
  const model::Quaternion q = positive_w(pose->rotation);
  return {{"translation", vector_of(pose->translation)},
          {"quaternion_wxyz", Json::array({finite(q.w), finite(q.x), finite(q.y), finite(q.z)})}};
}

Json field_of(const model::Field<double>& field) {
  return {{"value", finite(field.value)}, {"default", !field.written}};
}

Json name_or_null(const std::optional<std::string>& name) {
  return name ? Json(*name) : Json(nullptr);
}

std::string_view format_name(model::Format format) {
  switch (format) {
    case model::Format::kSdf: return "sdf";
    case model::Format::kUrdf: return "urdf";
    case model::Format::kModelConfig: return "model-config";
    case model::Format::kMjcf: return "mjcf";
    case model::Format::kUnknown: break;
  }
  return "unknown";
}

struct ShapeSizes {
  Json operator()(const model::Box& s) const { return {{"size", vector_of(s.size.value)}}; }
  Json operator()(const model::Sphere& s) const { return {{"radius", finite(s.radius.value)}}; }
  Json operator()(const model::Cylinder& s) const { return round(s); }
  Json operator()(const model::Capsule& s) const { return round(s); }
  Json operator()(const model::Cone& s) const { return round(s); }
  Json operator()(const model::Ellipsoid& s) const { return {{"radii", vector_of(s.radii.value)}}; }
  Json operator()(const model::Plane& s) const { return {{"normal", vector_of(s.normal.value)}}; }
  Json operator()(const model::Mesh& s) const {
    return {{"uri", s.uri.value},
            {"scale", vector_of(s.scale.value)},
            {"submesh", s.submesh.written ? Json(s.submesh.value) : Json(nullptr)}};
  }
  Json operator()(const model::Heightmap& s) const {
    return {{"uri", s.uri.value}, {"size", vector_of(s.size.value)}};
  }
  Json operator()(const model::Image& s) const { return {{"uri", s.uri.value}}; }
  Json operator()(const model::Polyline& s) const {
    Json points = Json::array();
    for (const auto& p : s.points) points.push_back({finite(p.value.x), finite(p.value.y)});
    return {{"points", points}, {"height", finite(s.height.value)}};
  }
  Json operator()(const model::NoShape&) const { return Json::object(); }

  static Json round(const auto& s) {
    return {{"radius", finite(s.radius.value)}, {"length", finite(s.length.value)}};
  }
};

class Writer {
 public:
  explicit Writer(const Inspection& inspection) : inspection_(inspection), root_(inspection.root) {}

  Json all() const {
    Json models = Json::array();
    for (const Id<model::Model> top : top_models(root_)) models.push_back(model(top));
    return {{"tool", {{"name", kToolName}, {"version", tool_version()}}},
            {"schema_version", kSchemaVersion},
            {"path", inspection_.path},
            {"format", format_name(root_.format)},
            {"version", root_.version_text.value},
            {"worlds", worlds()},
            {"models", std::move(models)}};
  }

 private:
  template <class T>
  Json entity(Id<T> id) const {
    return {{"name", root_[id].name.value},
            {"scoped_name", scoped_name(root_, id)},
            {"pose", pose_of(inspection_.frames.pose(id))},
            {"pose_default", !root_[id].pose.pose.written}};
  }

  Json worlds() const {
    Json list = Json::array();
    for (const model::World& world : root_.worlds) {
      list.push_back({{"name", world.name.value},
                      {"gravity", vector_of(world.gravity.value)},
                      {"gravity_default", !world.gravity.written},
                      {"models", world.models.size()},
                      {"frames", each(world.frames, &Writer::frame)},
                      {"joints", each(world.joints, &Writer::joint)}});
    }
    return list;
  }

  template <class T>
  Json each(const std::vector<Id<T>>& ids, Json (Writer::*one)(Id<T>) const) const {
    Json list = Json::array();
    for (const Id<T> id : ids) list.push_back((this->*one)(id));
    return list;
  }

  Json model(Id<model::Model> id) const {
    const model::Model& model = root_[id];
    Json json = entity(id);
    json["world"] = model.world ? Json(root_[model.world].name.value) : Json(nullptr);
    json["static"] = model.is_static.value;
    const Id<model::Link> canonical = inspection_.frames.canonical_link(id);
    json["canonical_link"] = canonical ? Json(scoped_name(root_, canonical)) : Json(nullptr);
    json["links"] = each(model.links, &Writer::link);
    json["frames"] = each(model.frames, &Writer::frame);
    json["joints"] = each(model.joints, &Writer::joint);
    json["models"] = each(model.models, &Writer::model);
    const Totals sum = totals(inspection_, id);
    json["totals"] = {
        {"links", sum.links},           {"joints", sum.joints},
        {"collisions", sum.collisions}, {"visuals", sum.visuals},
        {"mass", finite(sum.mass)},     {"com", sum.com ? vector_of(*sum.com) : Json(nullptr)}};
    return json;
  }

  Json link(Id<model::Link> id) const {
    Json json = entity(id);
    json["inertial"] = inertial(id);
    json["collisions"] = each(root_[id].collisions, &Writer::collision);
    json["visuals"] = each(root_[id].visuals, &Writer::visual);
    return json;
  }

  Json inertial(Id<model::Link> id) const {
    const model::Inertial& written = root_[id].inertial;
    const mass::MassProperties body = inspection_.inertial(id).body;
    return {{"mass", finite(body.mass)},
            {"mass_default", !written.mass.written},
            {"com", vector_of(body.com)},
            {"com_default", !written.pose.pose.written},
            {"inertia", tensor_of(body.about_com)},
            {"inertia_default", !written.tensor_written},
            {"automatic", mass::is_automatic(root_[id])}};
  }

  template <class T>
  Json shaped(Id<T> id) const {
    Json json = entity(id);
    const model::Geometry& geometry = root_[id].geometry;
    json["shape"] = {{"type", shape_name(geometry.shape)}};
    json["shape"].update(std::visit(ShapeSizes{}, geometry.shape));
    return json;
  }
  Json collision(Id<model::Collision> id) const { return shaped(id); }
  Json visual(Id<model::Visual> id) const { return shaped(id); }

  Json frame(Id<model::Frame> id) const {
    Json json = entity(id);
    json["attached_to"] = root_[id].attached_to.value;
    return json;
  }

  Json joint(Id<model::Joint> id) const {
    const model::Joint& joint = root_[id];
    Json json = entity(id);
    json["type"] = to_string(joint.type);
    json["parent"] = name_or_null(parent_name(inspection_, id));
    json["child"] = name_or_null(child_name(inspection_, id));
    json["axes"] = Json::array();
    for (std::size_t i = 0; i < joint.axes.size(); ++i) json["axes"].push_back(axis(id, i));
    return json;
  }

  Json axis(Id<model::Joint> id, std::size_t index) const {
    const model::Axis& axis = root_[id].axes[index];
    const std::optional<model::Vector3> direction = inspection_.frames.axis(id, index);
    Json json = {{"direction", direction ? vector_of(*direction) : Json(nullptr)},
                 {"xyz", vector_of(axis.xyz.value)},
                 {"xyz_default", !axis.xyz.written},
                 {"lower", field_of(axis.lower)},
                 {"upper", field_of(axis.upper)},
                 {"effort", field_of(axis.effort)},
                 {"velocity", field_of(axis.velocity)},
                 {"damping", field_of(axis.damping)},
                 {"friction", field_of(axis.friction)},
                 {"mimic", nullptr}};
    if (axis.mimic) {
      json["mimic"] = {{"joint", axis.mimic->joint.value},
                       {"multiplier", finite(axis.mimic->multiplier.value)},
                       {"offset", finite(axis.mimic->offset.value)}};
    }
    return json;
  }

  const Inspection& inspection_;
  const model::Root& root_;
};

}  // namespace

std::string inspect_json(const Inspection& inspection) {
  return Writer(inspection).all().dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rigor::report
