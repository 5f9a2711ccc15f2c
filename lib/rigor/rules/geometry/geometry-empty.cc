// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <variant>

#include <rigor/rules/rule.h>

namespace rigor::rules::geometry_empty {
namespace {

template <class Part>
void check(const Part& part, Context& context) {
  const model::Geometry& geometry = part.geometry;
  if (!geometry.written || geometry.explicitly_empty) return;
  if (!std::holds_alternative<model::NoShape>(geometry.shape)) return;
  // A misspelt shape is told as an unknown element.
  if (!context.element(geometry.site).children().empty()) return;
  context.report({.where = geometry.site.name,
                  .message = "the geometry holds no shape",
                  .subject = context.subject(part)});
}

}  // namespace

Rule rule() {
  return {
      .name = "geometry-empty",
      .category = Category::kGeometry,
      .severity = Severity::kError,
      .summary = "a <geometry> holds no shape",
      .why =
          "urdfdom drops the collision or visual with an error and goes on; libsdformat takes "
          "it for nothing. Either way the part is not there.",
      .what_to_do =
          "Put a shape in, or take the visual or collision out. Where nothing is meant, "
          "SDF has <empty/>.",
      .bad = {{R"(<sdf version="1.9">
  <model name="arm">
    <static>true</static>
    <link name="body">
      <collision name="hull">
        <«geometry»/>
      </collision>
    </link>
  </model>
</sdf>
)"},
              {R"(<robot name="arm">
  <link name="base">
    <collision>
      <«geometry»/>
    </collision>
  </link>
</robot>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="arm">
    <static>true</static>
    <link name="body">
      <collision name="hull">
        <geometry>
          <box><size>1 2 3</size></box>
        </geometry>
      </collision>
    </link>
  </model>
</sdf>
)"},
               {R"(<sdf version="1.9">
  <model name="arm">
    <static>true</static>
    <link name="body">
      <collision name="hull">
        <geometry>
          <empty/>
        </geometry>
      </collision>
    </link>
  </model>
</sdf>
)"}},
      .checks = {on<model::Collision>(check), on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::geometry_empty
