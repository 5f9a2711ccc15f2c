// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/mjcf/mjcf_checks.h>
#include <rigor/text/path.h>

namespace rigor::read {
namespace {

std::string_view trimmed_attribute(xml::Element element, std::string_view name) {
  const auto attribute = element.attribute(name);
  return attribute ? trimmed(attribute->value()) : std::string_view();
}

/// Dimensions of what the flex is made of, as they are written; those of a file are not known.
double dimension_of(xml::Element flex) {
  const std::string_view type = trimmed_attribute(flex, "type");
  if (flex.name() == "flexcomp") {
    if (type == "box" || type == "cylinder" || type == "ellipsoid") return 3;
    if (type == "square" || type == "disc") return 2;
    if (type == "circle") return 1;
  }
  const auto dim = mjcf_numbers(trimmed_attribute(flex, "dim"));
  if (dim && dim->size() == 1) return dim->front();
  return type == "gmsh" ? 0 : 2;
}

void check_flex_file(const MjcfScope& scope, const Disk& disk, xml::Element flex,
                     MjcfFacts& facts) {
  const std::string_view type = trimmed_attribute(flex, "type");
  if (type != "mesh" && type != "gmsh") return;
  const auto file = mjcf_name(flex, "file");
  const auto report = [&](std::string why) {
    facts.push_back({.kind = MjcfFactKind::kFlexFile,
                     .where = file.written ? file.span : flex.tag_span(),
                     .name = file.value,
                     .detail = std::move(why)});
  };
  if (file.value.empty()) return report("is required by type=\"" + std::string(type) + '"');
  const std::string path = join_path(
      parent_path(scope.tree.path_of(flex)),
      mjcf_asset_path(scope.tree, scope.settings, flex, scope.settings.mesh_folder, file.value));
  if (disk.kind(path) != PathKind::kFile) return report("does not exist");
  if (type == "mesh" && extension(path) != ".obj") return;
  facts.push_back({.kind = type == "gmsh"            ? MjcfFactKind::kFlexSolid
                           : dimension_of(flex) == 1 ? MjcfFactKind::kFlexLines
                                                     : MjcfFactKind::kFlexSurface,
                   .where = file.span,
                   .name = file.value,
                   .detail = path});
}

/// Written last: several `<option>` are one.
model::Field<std::string> integrator_of(const MjcfTree& tree) {
  model::Field<std::string> integrator{"Euler", {}, false};
  for (const xml::Element section : tree.children(tree.root())) {
    if (section.name() != "option") continue;
    const auto text = mjcf_name(section, "integrator");
    if (text.written) integrator = text;
  }
  return integrator;
}

bool is_rigid(xml::Element flex) {
  if (trimmed_attribute(flex, "rigid") == "true") return true;
  const std::string_view body = trimmed_attribute(flex, "body");
  return flex.name() == "flex" && !body.empty() && body.find_first_of(" \n\t") == body.npos;
}

/// Elasticity that MuJoCo integrates: of solids, and of shells that bend or stretch.
bool is_elastic(xml::Element flex) {
  const auto elasticity = flex.child("elasticity");
  if (!elasticity) return false;
  const auto young = mjcf_numbers(trimmed_attribute(*elasticity, "young"));
  if (!young || young->empty() || !(young->front() > 0)) return false;
  const std::string_view shell = trimmed_attribute(*elasticity, "elastic2d");
  const double dimension = dimension_of(flex);
  return dimension == 3 || (dimension == 2 && !shell.empty() && shell != "none");
}

void check_flex_integrator(xml::Element flex, const model::Field<std::string>& integrator,
                           MjcfFacts& facts) {
  if (is_rigid(flex) || integrator.value == "discrete") return;
  const bool implicit = integrator.value == "implicit" || integrator.value == "implicitfast";
  const auto contact = flex.child("contact");
  const bool passive = contact && trimmed_attribute(*contact, "passive") == "true";
  if (!passive && !(implicit && is_elastic(flex))) return;
  facts.push_back({.kind = MjcfFactKind::kFlexIntegrator,
                   .where = flex.tag_span(),
                   .name = integrator.value,
                   .detail = passive ? "passive contact" : "elasticity",
                   .related = integrator.span});
}

}  // namespace

void check_mjcf_flexes(const MjcfScope& scope, const Disk& disk, MjcfFacts& facts) {
  const model::Field<std::string> integrator = integrator_of(scope.tree);
  for_each_mjcf_element(scope.tree, [&](std::string_view, xml::Element element) {
    const bool recipe = element.name() == "flexcomp";
    if (!recipe && element.name() != "flex") return;
    if (recipe) check_flex_file(scope, disk, element, facts);
    check_flex_integrator(element, integrator, facts);
  });
}

}  // namespace rigor::read
