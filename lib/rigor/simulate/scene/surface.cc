// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How a shape's surface behaves: SDF's `<surface>`, URDF's `<gazebo>` blocks of its link. What is said
// of whom, and what becomes of it, is the table in docs/simulate.md.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>

#include <rigor/schema/value.h>
#include <rigor/simulate/scene/draft.h>

namespace rigor::simulate {
namespace {

/// More points of one pair would say nothing more of a shape that rests on another.
constexpr double kMaxContactsOfPair = 1000;

class SurfaceReader {
 public:
  SurfaceReader(SceneDraft& draft, const model::Collision& collision)
      : draft_(draft), collision_(collision) {}

  ContactSurface read() {
    const model::Link& link = draft_.root[collision_.link];
    const model::Model& model = draft_.root[link.model];
    if (model.format == model::Format::kSdf) {
      read_collision(draft_.element(collision_.site));
    } else {
      for (const auto* given : draft_.blocks.find(model, link.name.value, {"collision"})) {
        read_collision(draft_.element(given->site));
      }
      for (const auto* given :
           draft_.blocks.find(model, link.name.value,
                              {"mu1", "mu", "mu2", "fdir1", "kp", "kd", "maxContacts",
                               "max_contacts", "maxVel", "minDepth"})) {
        read_block(*given);
      }
    }
    return out_;
  }

 private:
  void read_collision(xml::Element collision) {
    if (const auto most = read::child_text(collision, "max_contacts")) take_contacts(*most);
    const auto surface = collision.child("surface");
    if (!surface) return;
    if (const auto bounce = surface->child("bounce")) {
      take(out_.restitution, *bounce, "restitution_coefficient");
      take(out_.bounce_threshold, *bounce, "threshold");
    }
    if (const auto friction = element_at(*surface, {"friction", "ode"})) {
      take_friction(out_.mu, read::child_text(*friction, "mu"));
      take_friction(out_.mu2, read::child_text(*friction, "mu2"));
      take(out_.slip1, *friction, "slip1");
      take(out_.slip2, *friction, "slip2");
      take_direction(read::child_text(*friction, "fdir1"));
    }
    if (const auto contact = surface->child("contact")) read_contact(*contact);
    const auto torsional = element_at(*surface, {"friction", "torsional"});
    for (const std::string_view radius : {"patch_radius", "surface_radius"}) {
      if (torsional) ignore_unless(torsional->child(radius), "torsional", 0);
    }
  }

  void read_contact(xml::Element contact) {
    if (const auto text = read::child_text(contact, "collide_without_contact")) {
      out_.collide_without_contact = read::bool_field(text, false).value;
    }
    if (const auto text = read::child_text(contact, "collide_bitmask")) {
      const auto bits = schema::parse_uint(text->text);
      if (const std::uint32_t* value = std::get_if<std::uint32_t>(&bits)) {
        out_.collide_bitmask = *value;
      }
    }
    ignore_unless(contact.child("category_bitmask"), "category_bitmask", 0xffff);
    if (const auto ode = contact.child("ode")) {
      take(out_.kp, *ode, "kp");
      take(out_.kd, *ode, "kd");
      ignore_unless(ode->child("max_vel"), "max_vel", 0.01);
      ignore_unless(ode->child("min_depth"), "min_depth", 0);
    }
  }

  void read_block(const model::Parameter& given) {
    const read::Text text{given.value.value, given.value.span};
    const std::string_view name = given.name;
    if (name == "mu1" || name == "mu") take_friction(out_.mu, text);
    if (name == "mu2") take_friction(out_.mu2, text);
    if (name == "fdir1") take_direction(text);
    if (name == "kp") take(out_.kp, text, name);
    if (name == "kd") take(out_.kd, text, name);
    if (name == "maxContacts" || name == "max_contacts") take_contacts(text);
    if (name == "maxVel") ignore_unless(text, "max_vel", 0.01);
    if (name == "minDepth") ignore_unless(text, "min_depth", 0);
  }

  void take(double& out, xml::Element holder, std::string_view name) {
    take(out, read::child_text(holder, name), name);
  }

  /// None of them means anything below zero.
  void take(double& out, const std::optional<read::Text>& text, std::string_view name) {
    const double value = draft_.number(text, out, name, collision_);
    if (value >= 0) {
      out = value;
    } else {
      ignore(text->span, name, value);
    }
  }

  /// Negative is SDF's and ODE's old word for infinite.
  void take_friction(double& out, const std::optional<read::Text>& text) {
    if (!text) return;
    const auto field = read::number_field(text, out);
    if (std::isinf(field.value) && field.value > 0) {
      out = kInfinity;
    } else {
      const double value = draft_.number(text, out, "mu", collision_);
      out = value < 0 ? kInfinity : value;
    }
  }

  void take_direction(const std::optional<read::Text>& text) {
    if (!text || read::trimmed(text->text).empty()) return;
    const auto field = read::vector_field(text, {});
    if (!field.written) {
      draft_.say(FactKind::kNotFinite, text->span, collision_, "fdir1");
    } else if (const double size = length(field.value); size > 0) {
      out_.fdir1 = 1 / size * field.value;
    }
  }

  void take_contacts(const read::Text& text) {
    const double value = draft_.number(text, out_.max_contacts, "max_contacts", collision_);
    out_.max_contacts = static_cast<int>(std::clamp(value, 0.0, kMaxContactsOfPair));
  }

  void ignore_unless(std::optional<xml::Element> e, std::string_view name, double neutral) {
    if (e) ignore_unless(read::Text{e->text(), e->text_span()}, name, neutral);
  }

  void ignore_unless(const read::Text& text, std::string_view name, double neutral) {
    const auto value = SceneDraft::parsed_number(text.text);
    if (value && *value != neutral) ignore(text.span, name, *value);
  }

  /// Once a model: what its first shape has, the others have as well.
  void ignore(Span where, std::string_view name, double value) {
    const model::Id<model::Model> model = draft_.root[collision_.link].model;
    if (!draft_.surface_words.emplace(model.value, name).second) return;
    draft_.say(FactKind::kElementIgnored, where, collision_, std::string(name), value);
  }

  SceneDraft& draft_;
  const model::Collision& collision_;
  ContactSurface out_;
};

}  // namespace

ContactSurface surface_of(SceneDraft& draft, const model::Collision& collision) {
  return SurfaceReader(draft, collision).read();
}

}  // namespace rigor::simulate
