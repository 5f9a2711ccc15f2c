// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <functional>

#include <rigor/mass/resolve.h>
#include <rigor/report/inspect/inspect.h>
#include <rigor/report/number.h>

namespace rigor::report {
namespace {

using model::Id;

constexpr int kTsvDigits = 12;

/// A name as one word.
std::string word(std::string_view name) {
  std::string out;
  for (const char c : name) {
    switch (c) {
      case ' ': out += "\\s"; break;
      case '\t': out += "\\t"; break;
      case '\n': out += "\\n"; break;
      case '\r': out += "\\r"; break;
      case '\\': out += "\\\\"; break;
      default: out += c;
    }
  }
  return out;
}

std::string pose_columns(const model::Pose& pose) {
  const model::Vector3& p = pose.translation;
  const model::Quaternion q = positive_w(pose.rotation);
  std::string out;
  for (const double value : {p.x, p.y, p.z, q.w, q.x, q.y, q.z}) {
    out += number(value, kTsvDigits) + '\t';
  }
  return out;
}

/// What stands side by side in one file, of lists of one kind each.
class FileOrder {
 public:
  explicit FileOrder(SourceId source) : source_(source) {}

  /// `place` gives an element's span. What was merged from another file follows what it stands behind.
  template <class T, class Place, class Write>
  void add(const std::vector<Id<T>>& list, const Place& place, const Write& write) {
    std::uint32_t at = 0;
    for (const Id<T> id : list) {
      const Span span = place(id);
      if (span.source == source_) at = span.begin;
      parts_.push_back({at, [&write, id] { write(id); }});
    }
  }

  /// While all that was given lives.
  void write() {
    std::stable_sort(parts_.begin(), parts_.end(),
                     [](const Part& a, const Part& b) { return a.at < b.at; });
    for (const Part& part : parts_) part.write();
  }

 private:
  struct Part {
    std::uint32_t at;
    std::function<void()> write;
  };

  SourceId source_;
  std::vector<Part> parts_;
};

class Rows {
 public:
  explicit Rows(const Inspection& inspection) : inspection_(inspection), root_(inspection.root) {}

  std::string all() {
    for (const Id<model::Model> top : top_models(root_)) {
      if (!root_[top].world) model(top);
    }
    for (const model::World& world : root_.worlds) {
      side_by_side(world.site.span.source, world.models, world.frames, world.joints, {});
    }
    return std::move(out_);
  }

 private:
  template <class T>
  void row(std::string_view kind, Id<T> id, const std::string& extra) {
    const std::optional<model::Pose> pose = inspection_.frames.pose(id);
    if (!pose) return;
    out_ += kind;
    out_ += '\t' + word(scoped_name(root_, id)) + '\t' + pose_columns(*pose) + extra + '\n';
  }

  void model(Id<model::Model> id) {
    row("model", id, {});
    const model::Model& model = root_[id];
    side_by_side(model.site.span.source, model.models, model.frames, model.joints, model.links);
  }

  void link(Id<model::Link> id) {
    row("link", id, link_extra(id));
    const auto place = [this](auto part) { return root_[part].site.span; };
    const auto collision = [this](auto part) { row("collision", part, {}); };
    const auto visual = [this](auto part) { row("visual", part, {}); };
    FileOrder order(root_[id].site.span.source);
    order.add(root_[id].collisions, place, collision);
    order.add(root_[id].visuals, place, visual);
    order.write();
  }

  void side_by_side(SourceId source, const std::vector<Id<model::Model>>& models,
                    const std::vector<Id<model::Frame>>& frames,
                    const std::vector<Id<model::Joint>>& joints,
                    const std::vector<Id<model::Link>>& links) {
    const auto place = [this](auto id) { return root_[id].site.span; };
    const auto place_of_model = [this](Id<model::Model> id) {
      const std::uint32_t include = root_[id].include;
      const bool included = include < root_.includes.size();
      return included ? root_.includes[include].site.span : root_[id].site.span;
    };
    const auto link = [this](auto id) { this->link(id); };
    const auto frame = [this](auto id) { row("frame", id, {}); };
    const auto joint = [this](auto id) { row("joint", id, joint_extra(id)); };
    const auto model = [this](auto id) { this->model(id); };
    FileOrder order(source);
    order.add(links, place, link);
    order.add(frames, place, frame);
    order.add(joints, place, joint);
    order.add(models, place_of_model, model);
    order.write();
  }

  std::string link_extra(Id<model::Link> link) const {
    const mass::MassProperties body = inspection_.inertial(link).body;
    const mass::Inertia& i = body.about_com;
    std::string out = number(body.mass, kTsvDigits) + ' ' + numbers(body.com, kTsvDigits);
    for (const double value : {i.ixx, i.ixy, i.ixz, i.iyy, i.iyz, i.izz}) {
      out += ' ' + number(value, kTsvDigits);
    }
    return out;
  }

  std::string joint_extra(Id<model::Joint> id) const {
    const auto named = [](const std::optional<std::string>& name) {
      return name ? word(*name) : "-";
    };
    std::string out =
        named(parent_name(inspection_, id)) + ' ' + named(child_name(inspection_, id)) + ' ';
    out += to_string(root_[id].type);
    for (std::size_t i = 0; i < root_[id].axes.size(); ++i) {
      const std::optional<model::Vector3> axis = inspection_.frames.axis(id, i);
      out += ' ' + (axis ? numbers(*axis, kTsvDigits) : "nan nan nan");
    }
    return out;
  }

  const Inspection& inspection_;
  const model::Root& root_;
  std::string out_;
};

}  // namespace

std::string inspect_tsv(const Inspection& inspection) { return Rows(inspection).all(); }

}  // namespace rigor::report
