// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/assembled.h>
#include <rigor/rules/assembly/twin_numbers.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_of_other_side {

/// Null for what is no mesh.
const model::Mesh* mesh_of(const model::Geometry& geometry) {
  return std::get_if<model::Mesh>(&geometry.shape);
}

std::string_view file_name(std::string_view uri) { return uri.substr(uri.rfind('/') + 1); }

/// The URIs of all meshes of the model.
std::set<std::string> used_meshes(const model::Root& root) {
  std::set<std::string> result;
  const auto add = [&result](const auto& shapes) {
    for (const auto& shape : shapes) {
      if (const model::Mesh* mesh = mesh_of(shape.geometry)) result.insert(mesh->uri.value);
    }
  };
  add(root.collisions);
  add(root.visuals);
  return result;
}

/// The mesh of the other side that the model uses as well; empty without one.
std::string mirrored_mesh(const std::string& uri, const std::set<std::string>& used) {
  const std::string_view file = file_name(uri);
  const std::string folder = uri.substr(0, uri.size() - file.size());
  for (const std::string& name : robot::mirrored_names(file, robot::Side::kAcross)) {
    if (used.contains(folder + name)) return folder + name;
  }
  return {};
}

/// Whether this mesh says left, of the two.
bool says_left(const std::string& uri, const std::string& mirrored) {
  const auto pairs = robot::twins({file_name(uri), file_name(mirrored)}, robot::Side::kAcross);
  return !pairs.empty() && pairs.front().a == 0;
}

class Check {
 public:
  explicit Check(Context& context) : context_(context), used_(used_meshes(context.root())) {}

  void run() {
    const model::Root& root = context_.root();
    for (const robot::Twins& pair : context_.assembled().link_twins) {
      compare(root.links[pair.a], root.links[pair.b], &model::Link::collisions);
      compare(root.links[pair.a], root.links[pair.b], &model::Link::visuals);
    }
  }

 private:
  template <class Shapes>
  void compare(const model::Link& left, const model::Link& right, Shapes shapes) {
    const model::Root& root = context_.root();
    if ((left.*shapes).size() != (right.*shapes).size()) return;
    for (std::size_t i = 0; i < (left.*shapes).size(); ++i) {
      const auto& of_left = root[(left.*shapes)[i]];
      const auto& of_right = root[(right.*shapes)[i]];
      const model::Mesh* a = mesh_of(of_left.geometry);
      const model::Mesh* b = mesh_of(of_right.geometry);
      if (!a || !b || a->uri.value != b->uri.value || !(a->scale.value == b->scale.value)) continue;
      const std::string other = mirrored_mesh(a->uri.value, used_);
      if (other.empty()) continue;
      says_left(a->uri.value, other) ? report(of_right, *b, left, other)
                                     : report(of_left, *a, right, other);
    }
  }

  template <class Part>
  void report(const Part& part, const model::Mesh& mesh, const model::Link& twin,
              const std::string& other) {
    const std::string meant(file_name(other));
    Finding finding{.where = mesh.uri.span,
                    .message = fmt::format("the mesh '{}' is that of the other side, of link '{}'",
                                           file_name(mesh.uri.value), twin.name.value),
                    .subject = context_.subject(part),
                    .help = fmt::format("the model has '{}', too", meant)};
    if (context_.bytes(mesh.uri.span) == mesh.uri.value)
      finding.fix = Fix{"write " + other, Applicability::kUnsafe, {{mesh.uri.span, other}}};
    context_.report(std::move(finding));
  }

  Context& context_;
  std::set<std::string> used_;
};

void check(const model::Root& root, Context& context) {
  constexpr std::size_t kFewest = 3;
  if (root.links.size() >= kFewest) Check(context).run();
}

Rule rule() {
  return {
      .name = "mesh-of-other-side",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a left part has the mesh of the right one, or a right part that of the left",
      .why = "The part is seen, or collides, where its mirror image is. Both parts of a pair have "
             "the same mesh file, whose name says one side, and the model uses the file of the "
             "other side elsewhere: the block was copied and this name was not changed.",
      .what_to_do = "Name the file of the part's own side. If it is meant, give the one that both "
                    "have a name without a side.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::mesh_of_other_side
