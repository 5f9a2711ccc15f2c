// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/merge.h>

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/patched_text.h>
#include <rigor/author/verbs/block.h>
#include <rigor/author/verbs/moved_paths.h>
#include <rigor/convert/settings.h>
#include <rigor/read/documents.h>
#include <rigor/read/load.h>
#include <rigor/text/path.h>
#include <rigor/xml/edit.h>
#include <rigor/xml/style.h>

namespace rigor::author {
namespace {

using model::Id;
using model::Pose;

/// In which libsdformat 12 and later read a world that includes URDF.
constexpr int kVersionOfIncludes = 9;

std::string sdf_version(const EditedModel& edited) {
  return fmt::format("1.{}",
                     edited.is_urdf() ? kVersionOfIncludes : edited.root()[edited.model].version);
}

class WorldMerger {
 public:
  WorldMerger(const EditedModel& a, const EditedModel& b, const WorldRequest& request)
      : a_(a), b_(b), request_(request), folder_(parent_path(request.out)) {}

  MergedWorld merge() {
    if (world_.refused = fault_of_parts(); !world_.refused.empty()) return std::move(world_);
    name_models();
    world_.notes = namespace_conflicts(bound_before(), a_.path(), namespaces(b_), b_.path());
    if (a_.root().worlds.empty()) {
      make_world();
    } else if (!add_to_world()) {
      world_.refused = "its world has no content";
    }
    if (world_.refused.empty()) prove(a_, 0);
    if (world_.refused.empty()) prove(b_, 1);
    return std::move(world_);
  }

 private:
  bool is_copied() const { return request_.parts == WorldParts::kCopied; }

  std::string fault_of_parts() const {
    for (const EditedModel* each : {&a_, &b_}) {
      if (each->loaded.file->expanded && is_copied())
        return each->path() + " is a template: expand it first";
      if (each->is_urdf() && is_copied())
        return each->path() + " is URDF: convert it with urdf2sdf, or use --include";
    }
    if (!a_.root().worlds.empty() && !is_copied())
      return "a world is given whose models are copied: leave out --include";
    if (is_copied() && sdf_version(a_) != sdf_version(b_)) {
      return fmt::format("one is SDF {} and one {}: upgrade the older one first", sdf_version(a_),
                         sdf_version(b_));
    }
    if (is_copied() && a_.root()[a_.model].version == 0) return "it is SDF 1.0: upgrade it first";
    return {};
  }

  void name_models() {
    world_.names = {a_.robot.name, b_.robot.name};
    const auto is_taken = [&](const std::string& name) {
      return name == world_.names.front() ||
             std::any_of(a_.root().models.begin(), a_.root().models.end(), [&](const auto& model) {
               return !model.parent && model.name.value == name;
             });
    };
    for (int i = 2; is_taken(world_.names.back()); ++i)
      world_.names.back() = fmt::format("{}_{}", b_.robot.name, i);
  }

  void make_world() {
    const std::string version = is_newer(b_, a_) ? sdf_version(b_) : sdf_version(a_);
    const std::string name =
        request_.name.empty() ? world_.names[0] + "_and_" + world_.names[1] : request_.name;
    world_.text =
        fmt::format("<?xml version=\"1.0\"?>\n<sdf version=\"{}\"{}>\n  <world name=\"{}\">\n",
                    version, declarations(), xml::escaped(name));
    world_.text += "    " + part(a_, 0, std::nullopt) + "\n";
    world_.text += "    " + part(b_, 1, request_.X_WB) + "\n  </world>\n</sdf>\n";
    world_.text = with_line_ends(world_.text, xml::line_end(a_.document(), 0));
  }

  /// Of the prefixes in a copied model.
  std::vector<Namespace> namespaces(const EditedModel& of) const {
    if (!is_copied()) return {};
    const Span copied = of.element(of.root()[of.model].site).span();
    return namespaces_used(of.document(), copied.begin, copied.end);
  }

  /// At the root of a new world: ` xmlns:gz="…"`.
  std::string declarations() const {
    std::map<std::string, std::string> all;
    for (const EditedModel* each : {&a_, &b_}) {
      for (const auto& [prefix, uri] : namespaces(*each)) all.emplace(prefix, uri);
    }
    std::string text;
    for (const auto& [prefix, uri] : all)
      text += fmt::format(" xmlns:{}=\"{}\"", prefix, xml::escaped(uri));
    return text;
  }

  /// What the world binds prefixes to before the second model is in it.
  std::vector<Namespace> bound_before() const {
    if (a_.root().worlds.empty()) return namespaces(a_);
    return declared_namespaces(*a_.document().root());
  }

  static bool is_newer(const EditedModel& a, const EditedModel& b) {
    const auto minor = [](const EditedModel& each) {
      return each.is_urdf() ? kVersionOfIncludes : each.root()[each.model].version;
    };
    return minor(a) > minor(b);
  }

  bool add_to_world() {
    const xml::Document& document = a_.document();
    const xml::Element world = a_.element(a_.root().worlds.front().site);
    const auto edit = block_at_end(document, world,
                                   child_indentation(document, world) + part(b_, 1, request_.X_WB));
    if (!edit) return false;
    std::vector<Edit> edits = moved_paths(document, a_.path(), folder_);
    edits.push_back(*edit);
    append(edits, declared(document, *document.root(), namespaces(b_)));
    world_.text = apply_edits(document.bytes(), std::move(edits)).value_or("");
    return !world_.text.empty();
  }

  // --- A model in the world ---

  std::string part(const EditedModel& of, std::size_t index, const std::optional<Pose>& X) const {
    return is_copied() ? copied(of, index, X) : included(of, index, X);
  }

  std::string copied(const EditedModel& of, std::size_t index, const std::optional<Pose>& X) const {
    const xml::Document& document = of.document();
    const xml::Element element = of.element(of.root()[of.model].site);
    std::vector<Edit> edits = moved_paths(document, of.path(), folder_);
    if (of.robot.name != world_.names[index])
      append(edits, xml::set_attribute(document, element, "name", world_.names[index]));
    if (X) {
      const std::string text = fmt::format("<pose>{} {}</pose>", xyz_text(*X), rpy_text(*X));
      if (const auto pose = element.child("pose")) {
        append(edits, xml::replace_element(document, *pose, text));
      } else {
        append(edits, xml::insert_child(document, element, std::nullopt, text));
      }
    }
    return part_after(document, element.span().begin, element.span().end, std::move(edits));
  }

  std::string included(const EditedModel& of, std::size_t index,
                       const std::optional<Pose>& X) const {
    std::string text = fmt::format("<include>\n      <uri>{}</uri>\n      <name>{}</name>\n",
                                   xml::escaped(uri_of(of)), xml::escaped(world_.names[index]));
    if (X) text += fmt::format("      <pose>{} {}</pose>\n", xyz_text(*X), rpy_text(*X));
    return text + "    </include>";
  }

  /// `model://FOLDER` where that leads to the file, else its path.
  std::string uri_of(const EditedModel& of) const {
    const std::string model_folder(parent_path(of.path()));
    const read::Resolver& resolver = of.environment.resolver;
    if (!model_folder.empty() &&
        resolver.disk().kind(join_path(model_folder, "model.config")) == PathKind::kFile) {
      std::string uri = "model://" + std::string(file_name(normalize_path(model_folder)));
      const auto found = resolver.resolve(uri, request_.out);
      if (found.path && normalize_path(*found.path) == normalize_path(model_folder)) return uri;
    }
    return relative_path(folder_, of.path());
  }

  // --- The proof ---

  robot::Robot expected(const EditedModel& of, std::size_t index) const {
    robot::Robot robot = of.robot;
    robot.name = world_.names[index];
    if (index == 1 && request_.X_WB) robot.X_WM = *request_.X_WB;
    if (!robot.X_WM) robot.X_WM = Pose{};
    if (!robot.is_static) robot.is_static = false;
    if (!is_copied()) return robot;
    move_paths(robot, of, folder_);
    return robot;
  }

  void prove(const EditedModel& of, std::size_t index) {
    read::Workspace workspace(of.environment.resolver, of.sources);
    const read::Reader reader{workspace, of.environment.resolver, of.environment.sdf,
                              of.environment.urdf};
    read::Loaded loaded = read::load(reader, workspace.put(request_.out, world_.text));
    const std::vector<model::Model>& models = loaded.root.models;
    const auto found = std::find_if(models.begin(), models.end(), [&](const model::Model& model) {
      return !model.parent && model.name.value == world_.names[index];
    });
    if (found == models.end()) {
      world_.refused = "the world, read again, has no model " + world_.names[index];
      return;
    }
    const Id<model::Model> id{static_cast<std::uint32_t>(found - models.begin())};
    const EditedModel after(workspace, of.environment, of.sources, std::move(loaded), id,
                            of.find_mesh);
    append_all(robot::compare(
        expected(of, index), after.robot,
        {.helpers = robot::Helpers::kReported, .placement = robot::Placement::kReported}));
    if (of.is_urdf()) return;
    const read::Documents documents(of.workspace), changed(workspace);
    append_all(convert::compare_settings({of.root(), documents, of.environment.sdf, of.model},
                                         {after.root(), changed, of.environment.sdf, after.model}));
  }

  void append_all(std::vector<robot::Difference> differences) {
    for (robot::Difference& each : differences) world_.unasked.push_back(std::move(each));
  }

  const EditedModel& a_;
  const EditedModel& b_;
  const WorldRequest& request_;
  std::string folder_;
  MergedWorld world_;
};

/// The model with a new root, on which the old one is fixed at the identity.
Change with_root(const EditedModel& edited, const std::string& root, const std::string& joint) {
  const std::vector<robot::Body>& bodies = edited.robot.bodies;
  std::vector<std::uint32_t> roots;
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].carrier == robot::kNoIndex) roots.push_back(i);
  }
  if (roots.size() != 1)
    return refusal(fmt::format("{} has {} roots", edited.path(), roots.size()));
  const xml::Document& document = edited.document();
  const xml::Element holder = edited.element(edited.root()[edited.model].site);
  const std::string in = child_indentation(document, holder);
  const std::string line(xml::line_end(document, 0));
  const std::string unit = xml::indent_unit(document, *document.root());
  std::string text =
      fmt::format("{0}<link name=\"{1}\"/>{3}{0}<joint name=\"{2}\" type=\"fixed\">{3}", in,
                  xml::escaped(root), xml::escaped(joint), line);
  text += fmt::format("{0}<parent link=\"{1}\"/>{3}{0}<child link=\"{2}\"/>{3}", in + unit,
                      xml::escaped(root), xml::escaped(bodies[roots.front()].name), line);
  const auto edit = block_at_end(document, holder, text + in + "</joint>");
  if (!edit) return refusal("it has no content");
  Change change;
  change.steps.push_back({*edit});
  change.expected = edited.robot;
  robot::Body body;
  body.name = root;
  robot::Joint fixed;
  fixed.name = joint;
  fixed.type = model::JointType::kFixed;
  fixed.parent = static_cast<std::uint32_t>(bodies.size());
  fixed.child = roots.front();
  change.expected.bodies.push_back(std::move(body));
  change.expected.joints.push_back(std::move(fixed));
  robot::connect(change.expected);
  return change;
}

}  // namespace

MergedWorld merged_world(const EditedModel& a, const EditedModel& b, const WorldRequest& request) {
  return WorldMerger(a, b, request).merge();
}

Change merged_robot(ModelReader& reader, const EditedModel& a, const EditedModel& b,
                    const AttachRequest& request) {
  const std::string& root = request.link;
  if (a.link(root))
    return refusal(
        fmt::format("it has a link '{0}' already: to put the other one on it, use "
                    "attach … --to {0}",
                    root));
  if (a.loaded.file->expanded) return refusal("it is a template");
  std::string joint = fmt::format("{}_to_{}", root, a.robot.name);
  while (a.joint(joint)) joint += '_';
  ProvenChange rooted = prove(reader, a, with_root(a, root, joint));
  if (!rooted.refused.empty()) return refusal(rooted.refused);
  if (!rooted.holds()) return refusal("a new root would change the robot");
  Change change = attached(reader, *rooted.after, b, request);
  if (!change.refused.empty()) return change;
  PatchedText text(std::string(a.document().bytes()));
  std::vector<Edit> edits;
  for (std::vector<Edit>& step : change.steps) append(edits, std::move(step));
  if (!text.apply(rooted.files.front().edits) || !text.apply(std::move(edits)))
    return refusal("two changes meet in one place");
  change.steps = {text.edits(a.document().source())};
  return change;
}

}  // namespace rigor::author
