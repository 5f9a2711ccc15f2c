// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What changed about worlds: the step size in 1.4, gravity in 1.6, states in 1.3 and 1.12.

#include <array>
#include <optional>
#include <string>
#include <utility>

#include <rigor/author/upgrade/step.h>
#include <rigor/read/values.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

std::optional<xml::Element> grandchild(xml::Element element, std::string_view a,
                                       std::string_view b) {
  const auto child = element.child(a);
  return child ? child->child(b) : std::nullopt;
}

std::string renamed_copy(std::string_view name, xml::Element element) {
  const std::string tag(name);
  return '<' + tag + '>' + xml::escaped(read::trimmed(element.text())) + "</" + tag + '>';
}

/// The step size of a world's physics up to 1.3, which each engine had for itself.
std::optional<xml::Element> old_step_size(xml::Element physics) {
  const auto solver = grandchild(physics, "ode", "solver");
  const auto ode = solver ? solver->child("dt") : std::nullopt;
  const auto bullet = grandchild(physics, "bullet", "dt");
  const auto type = physics.attribute("type");
  if (bullet && (!ode || (type && read::trimmed(type->value()) == "bullet"))) return bullet;
  return ode;
}

void move_gravity(UpgradeStep& step, xml::Element world) {
  const auto physics = world.child("physics");
  if (!physics) return;
  std::string moved;
  for (const std::string_view name : {"gravity", "magnetic_field"}) {
    const auto element = physics->child(name);
    if (!element || world.child(name)) continue;
    if (!moved.empty()) moved += '\n';
    moved += renamed_copy(name, *element);
    step.edit(xml::remove_element(step.document(), *element));
  }
  if (!moved.empty()) step.edit(xml::insert_child(step.document(), world, physics, moved));
}

}  // namespace

void upgrade_state_time(UpgradeStep& step) {
  step.for_each("world", "state", [&](xml::Element state) {
    const auto time = state.child("time");
    if (!time || state.child("sim_time")) return;
    step.edit(xml::rename_element(step.document(), *time, "sim_time"));
  });
}

void upgrade_step_size(UpgradeStep& step) {
  const xml::Document& document = step.document();
  step.for_each("world", "physics", [&](xml::Element physics) {
    const auto rate = physics.child("update_rate");
    if (rate && !physics.child("real_time_update_rate")) {
      step.edit(xml::rename_element(document, *rate, "real_time_update_rate"));
    }
    const auto size = old_step_size(physics);
    if (!size || physics.child("max_step_size")) return;
    step.edit(xml::remove_element(document, *size));
    step.edit(
        xml::insert_child(document, physics, std::nullopt, renamed_copy("max_step_size", *size)));
  });
}

void upgrade_actor_static(UpgradeStep& step) {
  step.for_each([&](xml::Element actor) {
    const auto fixed = actor.attribute("static");
    if (actor.name() != "actor" || !fixed || actor.child("static")) return;
    step.edit(xml::remove_attribute(step.document(), *fixed));
    step.edit(xml::insert_child(step.document(), actor, std::nullopt,
                                "<static>" + xml::escaped(fixed->value()) + "</static>"));
  });
}

void upgrade_gravity(UpgradeStep& step) {
  step.for_each([&](xml::Element world) {
    if (world.name() == "world") move_gravity(step, world);
  });
}

void upgrade_states(UpgradeStep& step) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kNames{
      {{"model", "model_state"},
       {"joint", "joint_state"},
       {"link", "link_state"},
       {"light", "light_state"},
       {"collision", "collision_state"}}};
  std::vector<bool> is_state(
      step.document().element_count());  // or part of one, but for insertions
  step.for_each([&](xml::Element element) {
    if (element.name() == "state") is_state[element.index()] = true;
    const auto parent = element.parent();
    if (!parent || !is_state[parent->index()]) return;
    for (const auto& [old_name, name] : kNames) {
      if (element.name() != old_name) continue;
      is_state[element.index()] = true;
      step.edit(xml::rename_element(step.document(), element, name));
    }
  });
}

}  // namespace rigor::author
