// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include <rigor/author/upgrade/downgrading.h>
#include <rigor/read/values.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

using model::Id;
using xml::Element;

class WorldDowngrader {
 public:
  explicit WorldDowngrader(Downgrading& work) : work_(work) {}

  void write_models() {
    work_.each(work_.root.models, [&](Id<model::Model> id, const model::Model& model) {
      const Element written = work_.element(model.site);
      const auto drop = [&](const char* name) {
        if (const auto attribute = written.attribute(name))
          work_.edit(xml::remove_attribute(work_.document, *attribute));
      };
      if (work_.drops_frames()) {
        const Id<model::Link> canonical = work_.frames.canonical_link(id);
        if (!model.canonical_link.value.empty() && !model.links.empty() &&
            canonical != model.links.front())
          work_.lose(model.canonical_link.span,
                     fmt::format("model '{}': its canonical link is the first one up to 1.6",
                                 model.name.value));
        drop("canonical_link");
      }
      if (work_.to < kNestedNames) drop("placement_frame");
    });
    if (!work_.drops_frames()) return;
    work_.each(work_.root.frames, [&](auto, const model::Frame& frame) {
      work_.lose(frame.site.tag,
                 fmt::format("frame '{}': SDF has frames since 1.7", frame.name.value));
      work_.edit(xml::remove_element(work_.document, work_.element(frame.site)));
    });
  }

  void write_worlds() {
    constexpr std::array<std::string_view, 5> kStates{"model", "joint", "link", "light",
                                                      "collision"};
    for (std::uint32_t i = 0; i < work_.document.element_count(); ++i) {
      const Element each = work_.document.element(i);
      const std::string_view name = each.name();
      if (name == "world" && work_.to < kWorldGravity && work_.from >= kWorldGravity)
        move_gravity(each);
      if (work_.to >= kNamedStates) continue;
      for (const std::string_view state : kStates) {
        if (name == std::string(state) + "_state")
          work_.edit(xml::rename_element(work_.document, each, state));
      }
    }
  }

 private:
  void move_gravity(Element world) {
    std::string moved;
    const auto physics = world.child("physics");
    for (const std::string_view name : {"gravity", "magnetic_field"}) {
      const auto own = world.child(name);
      if (!own) continue;
      if (!physics)
        return work_.lose(own->tag_span(), "gravity and magnetic field are in <physics> up to 1.5");
      moved += fmt::format("{0}<{1}>{2}</{1}>", moved.empty() ? "" : "\n", name,
                           read::trimmed(own->text()));
      work_.edit(xml::remove_element(work_.document, *own));
    }
    if (!moved.empty())
      work_.edit(xml::insert_child(work_.document, *physics, std::nullopt, moved));
  }

  Downgrading& work_;
};

}  // namespace

void downgrade_worlds(Downgrading& work) {
  WorldDowngrader downgrader(work);
  downgrader.write_models();
  downgrader.write_worlds();
}

}  // namespace rigor::author
