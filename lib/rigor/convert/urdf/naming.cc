// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/naming.h>

#include <set>
#include <utility>
#include <vector>

#include <rigor/convert/urdf/joint/joint.h>
#include <rigor/model/subject.h>

namespace rigor::convert {
namespace {

using model::Id;

class UrdfNamer {
 public:
  UrdfNamer(const Source& source, const UrdfTree& tree, Ledger& ledger)
      : root_(source.root), tree_(tree), ledger_(ledger) {}

  UrdfNaming name_all(FramePolicy frames) && {
    name_links(frames);
    name_joints();
    for (std::size_t i = 1; i < tree_.models.size(); ++i) tell_nested(tree_.models[i]);
    return std::move(naming_);
  }

 private:
  template <class T>
  std::string inside(Id<T> id) const {
    return name_inside(tree_, root_, scoped_name(root_, id));
  }

  void name_links(FramePolicy policy) {
    std::vector<std::string> wanted;
    std::vector<Id<model::Frame>> frames_as_links;
    std::set<Id<model::Frame>> joints;
    for (const auto& [frame, joint] : tree_.fixed_by) joints.insert(joint);
    for (const auto id : tree_.links) wanted.push_back(inside(id));
    if (policy == FramePolicy::kLinks) {
      for (const auto id : tree_.frames) {
        if (joints.contains(id)) continue;
        frames_as_links.push_back(id);
        wanted.push_back(inside(id));
      }
    }
    std::vector<std::string> names = naming_.link_names.take(wanted);
    const std::size_t links = tree_.links.size();
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (i < links) {
        tell_renamed(root_[tree_.links[i]], wanted[i], names[i]);
        naming_.links.emplace(tree_.links[i], std::move(names[i]));
      } else {
        naming_.frames.emplace(frames_as_links[i - links], std::move(names[i]));
      }
    }
  }

  void name_joints() {
    std::vector<std::string> wanted;
    for (const UrdfTree::Edge& edge : tree_.edges) wanted.push_back(inside(edge.joint));
    std::vector<std::string> names = naming_.joint_names.take(wanted);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const Id<model::Joint> joint = tree_.edges[i].joint;
      tell_renamed(root_[joint], wanted[i], names[i]);
      naming_.joints.emplace(joint, row(names[i], root_[joint].type));
    }
  }

  /// The names of joints in a row for one, and of the links between.
  UrdfJointNames row(std::string first, model::JointType type) {
    UrdfJointNames names{{first}, {}};
    const bool screw = type == model::JointType::kScrew;
    for (std::size_t k = 2; k <= urdf_joint_count(type); ++k) {
      const std::string suffix = screw ? "_slide" : "_axis" + std::to_string(k);
      names.joints.push_back(naming_.joint_names.add(first + suffix));
      names.links.push_back(naming_.link_names.add(first + suffix + "_link"));
    }
    return names;
  }

  /// Of what stands in a nested model, the model tells that its name is in front.
  template <class T>
  void tell_renamed(const T& entity, std::string wanted, const std::string& name) {
    if (entity.model == tree_.models.front()) {
      wanted = entity.name.value;
    } else {
      for (std::size_t at = 0; (at = wanted.find("::", at)) != std::string::npos;) {
        wanted.replace(at, 2, "__");
      }
    }
    if (wanted == name) return;
    ledger_.note({.kind = NoteKind::kRenamed,
                  .outcome = Outcome::kRewritten,
                  .where = entity.name.written ? entity.name.span : entity.site.name,
                  .subject = model::subject(root_, entity),
                  .written = '"' + entity.name.value + '"',
                  .instead = name});
    ledger_.take(entity.name, Outcome::kRewritten);
  }

  void tell_nested(Id<model::Model> id) {
    const model::Model& model = root_[id];
    if (model.merged) return;
    const bool included = model.include < root_.includes.size();
    ledger_.note({.kind = NoteKind::kNested,
                  .outcome = Outcome::kRewritten,
                  .where = included ? root_.includes[model.include].site.name : model.site.name,
                  .subject = model::subject(root_, model),
                  .written = inside(id),
                  .instead = inside(id) + "__…"});
  }

  const model::Root& root_;
  const UrdfTree& tree_;
  Ledger& ledger_;
  UrdfNaming naming_;
};

}  // namespace

std::string name_inside(const UrdfTree& tree, const model::Root& root, const std::string& scoped) {
  const std::size_t prefix = scoped_name(root, tree.models.front()).size() + 2;
  return scoped.size() > prefix ? scoped.substr(prefix) : std::string();
}

UrdfNaming urdf_naming(const Source& source, const UrdfOptions& options, const UrdfTree& tree,
                       Ledger& ledger) {
  return UrdfNamer(source, tree, ledger).name_all(options.frames);
}

}  // namespace rigor::convert
