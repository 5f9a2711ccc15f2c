// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/urdf.h>

#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/read/joint_type.h>
#include <rigor/read/values.h>
#include <rigor/schema/value.h>

namespace rigor::read {
namespace {

using model::Id;

/// `<origin xyz="…" rpy="…"/>`, or from URDF 1.2 `quat_xyzw`.
model::PoseField read_origin(xml::Element parent) {
  model::PoseField field;
  const auto origin = parent.child("origin");
  if (!origin) return field;
  field.site = site_of(*origin);
  const auto xyz = vector_field(attribute_text(*origin, "xyz"), {});
  const auto rpy = vector_field(attribute_text(*origin, "rpy"), {});
  field.malformed = xyz.written != origin->attribute("xyz").has_value() ||
                    rpy.written != origin->attribute("rpy").has_value();
  field.pose.value = {xyz.value, model::from_rpy(rpy.value.x, rpy.value.y, rpy.value.z)};
  field.pose.span = origin->tag_span();
  field.pose.written = true;
  if (const auto quaternion = attribute_text(*origin, "quat_xyzw")) {
    const auto parsed = schema::parse_pose("0 0 0 " + std::string(quaternion->text),
                                           schema::RotationFormat::kQuatXyzw);
    if (const auto* pose = std::get_if<schema::PoseNumbers>(&parsed)) {
      const auto& n = pose->numbers;
      field.pose.value.rotation = model::normalized({n[6], n[3], n[4], n[5]});
    }
  }
  return field;
}

model::Inertial read_inertial(xml::Element link) {
  model::Inertial inertial;
  const auto element = link.child("inertial");
  if (!element) return inertial;
  inertial.site = site_of(*element);
  inertial.written = true;
  inertial.pose = read_origin(*element);
  if (const auto mass = element->child("mass")) {
    inertial.mass = number_field(attribute_text(*mass, "value"), 0);
  }
  const auto tensor = element->child("inertia");
  if (!tensor) return inertial;
  inertial.tensor_written = true;
  inertial.tensor_site = site_of(*tensor);
  inertial.ixx = number_field(attribute_text(*tensor, "ixx"), 0);
  inertial.ixy = number_field(attribute_text(*tensor, "ixy"), 0);
  inertial.ixz = number_field(attribute_text(*tensor, "ixz"), 0);
  inertial.iyy = number_field(attribute_text(*tensor, "iyy"), 0);
  inertial.iyz = number_field(attribute_text(*tensor, "iyz"), 0);
  inertial.izz = number_field(attribute_text(*tensor, "izz"), 0);
  return inertial;
}

model::Material read_urdf_material(xml::Element element) {
  model::Material material;
  material.written = true;
  material.site = site_of(element);
  material.name = string_field(attribute_text(element, "name"));
  if (const auto texture = element.child("texture")) {
    material.texture = string_field(attribute_text(*texture, "filename"));
  }
  const auto color = element.child("color");
  const auto texture = element.child("texture");
  material.defines_color =
      (color && color->attribute("rgba")) || (texture && texture->attribute("filename"));
  return material;
}

model::Axis read_axis(xml::Element joint) {
  model::Axis axis;
  axis.site = site_of(joint);
  axis.xyz.value = {1, 0, 0};
  if (const auto element = joint.child("axis")) {
    axis.site = site_of(*element);
    // Only without an <axis> it is x: urdfdom leaves one without xyz at zero.
    axis.xyz = vector_field(attribute_text(*element, "xyz"), {0, 0, 0});
  }
  if (const auto limit = joint.child("limit")) {
    axis.limit_site = site_of(*limit);
    axis.limit_written = true;
    axis.lower = number_field(attribute_text(*limit, "lower"), 0);
    axis.upper = number_field(attribute_text(*limit, "upper"), 0);
    axis.effort = number_field(attribute_text(*limit, "effort"), 0);
    axis.velocity = number_field(attribute_text(*limit, "velocity"), 0);
  }
  if (const auto dynamics = joint.child("dynamics")) {
    axis.damping = number_field(attribute_text(*dynamics, "damping"), 0);
    axis.friction = number_field(attribute_text(*dynamics, "friction"), 0);
  }
  if (const auto element = joint.child("mimic")) {
    model::Mimic mimic;
    mimic.site = site_of(*element);
    mimic.joint = string_field(attribute_text(*element, "joint"));
    mimic.multiplier = number_field(attribute_text(*element, "multiplier"), 1);
    mimic.offset = number_field(attribute_text(*element, "offset"), 0);
    axis.mimic = std::move(mimic);
  }
  return axis;
}

class UrdfReader {
 public:
  UrdfReader(model::Root& root, Id<model::Model> model) : root_(root), model_(model) {}

  void read(xml::Element robot) {
    for (const xml::Element child : robot.children()) {
      const std::string_view name = child.name();
      if (name == "link") {
        read_link(child);
      } else if (name == "joint") {
        read_joint(child);
      } else if (name == "material") {
        const model::Material material = read_urdf_material(child);
        root_.materials.push_back({material.site, material.name, material.defines_color});
      } else if (name == "gazebo") {
        read_gazebo(child);
      } else if (name == "mujoco") {
        if (root_.mujoco.empty()) root_.mujoco = parameters_in(child);
      } else if (name == "transmission") {
        root_.transmissions.push_back(parameter_of(child));
        read_controlled_joints(root_.transmissions.back());
      } else if (name == "ros2_control") {
        root_.ros2_controls.push_back(parameter_of(child));
        read_controlled_joints(root_.ros2_controls.back());
      }
    }
    const LinksByName links = links_by_name();
    read_block_sensors(links);
    place_links(links);
  }

 private:
  void read_link(xml::Element element) {
    const Id<model::Link> id = next_id(root_.links);
    model::Link link;
    link.site = site_of(element);
    link.name = string_field(attribute_text(element, "name"));
    link.model = model_;
    link.inertial = read_inertial(element);
    link.gravity.value = true;
    root_.links.push_back(std::move(link));
    root_.models[model_.value].links.push_back(id);
    for (const xml::Element child : element.children()) {
      if (child.name() == "collision") read_collision(child, id);
      if (child.name() == "visual") read_visual(child, id);
    }
  }

  void read_collision(xml::Element element, Id<model::Link> link) {
    model::Collision collision;
    collision.site = site_of(element);
    collision.name = string_field(attribute_text(element, "name"));
    collision.link = link;
    collision.pose = read_origin(element);
    collision.geometry = read_geometry(element);
    root_.links[link.value].collisions.push_back(next_id(root_.collisions));
    root_.collisions.push_back(std::move(collision));
  }

  void read_visual(xml::Element element, Id<model::Link> link) {
    model::Visual visual;
    visual.site = site_of(element);
    visual.name = string_field(attribute_text(element, "name"));
    visual.link = link;
    visual.pose = read_origin(element);
    visual.geometry = read_geometry(element);
    if (const auto material = element.child("material"))
      visual.material = read_urdf_material(*material);
    root_.links[link.value].visuals.push_back(next_id(root_.visuals));
    root_.visuals.push_back(std::move(visual));
  }

  void read_joint(xml::Element element) {
    model::Joint joint;
    joint.site = site_of(element);
    joint.name = string_field(attribute_text(element, "name"));
    joint.type_name = string_field(attribute_text(element, "type"));
    joint.type = joint_type(joint.type_name.value);
    joint.model = model_;
    joint.world = root_[model_].world;
    if (const auto parent = element.child("parent")) {
      joint.parent = string_field(attribute_text(*parent, "link"));
    }
    if (const auto child = element.child("child")) {
      joint.child = string_field(attribute_text(*child, "link"));
    }
    joint.pose = read_origin(element);
    const bool has_axis = element.child("axis") || element.child("limit") ||
                          element.child("mimic") || element.child("dynamics");
    if (joint.type != model::JointType::kFixed || has_axis) {
      joint.axes.push_back(read_axis(element));
    }
    if (const auto safety = element.child("safety_controller")) {
      joint.safety = model::SafetyController{
          site_of(*safety), number_field(attribute_text(*safety, "soft_lower_limit"), 0),
          number_field(attribute_text(*safety, "soft_upper_limit"), 0)};
    }
    root_.models[model_.value].joints.push_back(next_id(root_.joints));
    root_.joints.push_back(std::move(joint));
  }

  void read_gazebo(xml::Element element) {
    model::GazeboBlock block;
    block.site = site_of(element);
    block.reference = string_field(attribute_text(element, "reference"));
    for (const xml::Element child : element.children()) {
      block.empty = false;
      if (child.name() == "sensor") {
        block_sensors_.push_back({child, block.reference.value});
      } else if (child.name() == "plugin") {
        read_plugin(child, {.model = model_}, block.reference.value);
      } else {
        block.content.push_back(block_key(child));
      }
    }
    root_.gazebo_blocks.push_back(std::move(block));
  }

  /// `<mu1 value="0.2"/>` says what `<mu1>0.2</mu1>` does: libsdformat's GetKeyValueAsString takes the
  /// attribute before the text.
  static model::Parameter block_key(xml::Element element) {
    model::Parameter key = parameter_of(element);
    if (const auto* value = attribute(key, "value")) key.value = *value;
    return key;
  }

  /// Written as in SDF. It belongs to a link; what is informed of a joint, or of none, belongs to no part
  /// of the model. The list of a link has only those that are written inside it.
  void read_sensor(xml::Element element, const std::string& reference, Id<model::Link> link) {
    const Id<model::Sensor> id = next_id(root_.sensors);
    model::Sensor sensor;
    read_measurement(element, sensor);
    sensor.link = link;
    sensor.gazebo_reference = reference;
    sensor.pose = read_plain_pose(element);
    for (const xml::Element child : element.children()) {
      if (child.name() == "plugin") read_plugin(child, {.sensor = id}, reference);
    }
    root_.sensors.push_back(std::move(sensor));
  }

  void read_plugin(xml::Element element, model::Plugin plugin, const std::string& reference) {
    plugin.site = site_of(element);
    plugin.name = string_field(attribute_text(element, "name"));
    plugin.filename = string_field(attribute_text(element, "filename"));
    plugin.parameters = parameters_in(element);
    plugin.gazebo_reference = reference;
    root_.plugins.push_back(std::move(plugin));
  }

  void read_controlled_joints(const model::Parameter& block) {
    for (const model::Parameter& child : block.children) {
      if (child.name != "joint") continue;
      model::ControlledJoint& joint = root_.controlled_joints.emplace_back();
      joint.site = child.site;
      if (const auto* name = attribute(child, "name")) joint.joint = *name;
      joint.ros2_control = block.name == "ros2_control";
      joint.parameters = child.children;
    }
  }

  using LinksByName = std::unordered_map<std::string_view, Id<model::Link>>;  // the first of each

  LinksByName links_by_name() const {
    LinksByName links;
    const model::Model& robot = root_[model_];
    for (const Id<model::Link> id : robot.links) links.try_emplace(root_[id].name.value, id);
    return links;
  }

  /// A block may stand before the link that it refers to.
  void read_block_sensors(const LinksByName& links) {
    for (const auto& [element, reference] : block_sensors_) {
      const auto link = links.find(reference);
      read_sensor(element, reference, link == links.end() ? Id<model::Link>() : link->second);
    }
  }

  /// A link stands where the last joint says whose child it is, as urdfdom decides.
  void place_links(const LinksByName& links) {
    const model::Model& robot = root_[model_];
    for (const Id<model::Joint> id : robot.joints) {
      const model::Joint& joint = root_[id];
      const auto child = links.find(joint.child.value);
      if (child == links.end()) continue;
      root_.links[child->second.value].pose.relative_to.value = joint.name.value;
    }
  }

  struct BlockSensor {
    xml::Element element;
    std::string reference;
  };

  model::Root& root_;
  Id<model::Model> model_;
  std::vector<BlockSensor> block_sensors_;
};

}  // namespace

Id<model::Model> read_urdf(model::Root& root, xml::Element robot, Scope scope) {
  const Id<model::Model> id = next_id(root.models);
  model::Model model;
  model.site = site_of(robot);
  model.format = model::Format::kUrdf;
  model.name = string_field(attribute_text(robot, "name"));
  model.parent = scope.model;
  model.world = scope.world;
  root.models.push_back(std::move(model));
  if (scope.model) {
    root.models[scope.model.value].models.push_back(id);
  } else if (scope.world) {
    root.worlds[scope.world.value].models.push_back(id);
  }
  UrdfReader(root, id).read(robot);
  return id;
}

}  // namespace rigor::read
