// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/model/subject.h>

#include <string_view>

namespace rigor::model {
namespace {

std::string inside(std::string outer, std::string_view kind, const std::string& name) {
  outer.reserve(outer.size() + kind.size() + name.size() + 2);
  if (!outer.empty()) outer += '/';
  outer += kind;
  if (!name.empty()) outer.append(1, ' ').append(name);
  return outer;
}

std::string of_scope(const Root& root, Id<Model> model, Id<World> world) {
  if (model) return scoped_name(root, model);
  return world ? subject(root, root[world]) : std::string();
}

}  // namespace

std::string subject(const Root& /*root*/, const World& world) {
  return inside({}, "world", world.name.value);
}

std::string subject(const Root& root, const Model& model) {
  const std::string outer = scoped_name(root, model.parent);
  return outer.empty() ? model.name.value : outer + "::" + model.name.value;
}

std::string subject(const Root& root, const Link& link) {
  return inside(scoped_name(root, link.model), "link", link.name.value);
}

std::string subject(const Root& root, const Joint& joint) {
  return inside(of_scope(root, joint.model, joint.world), "joint", joint.name.value);
}

std::string subject(const Root& root, const Frame& frame) {
  return inside(of_scope(root, frame.model, frame.world), "frame", frame.name.value);
}

std::string subject(const Root& root, const Collision& collision) {
  return inside(subject(root, root[collision.link]), "collision", collision.name.value);
}

std::string subject(const Root& root, const Visual& visual) {
  return inside(subject(root, root[visual.link]), "visual", visual.name.value);
}

std::string subject(const Root& root, const Sensor& sensor) {
  std::string outer;
  if (sensor.link) outer = subject(root, root[sensor.link]);
  if (sensor.joint) outer = subject(root, root[sensor.joint]);
  return inside(std::move(outer), "sensor", sensor.name.value);
}

std::string subject(const Root& root, const Light& light) {
  return inside(light.link ? subject(root, root[light.link]) : std::string(), "light",
                light.name.value);
}

std::string subject(const Root& root, const Plugin& plugin) {
  std::string outer = of_scope(root, plugin.model, plugin.world);
  if (plugin.link) outer = subject(root, root[plugin.link]);
  if (plugin.sensor) outer = subject(root, root[plugin.sensor]);
  return inside(std::move(outer), "plugin", plugin.name.value);
}

}  // namespace rigor::model
