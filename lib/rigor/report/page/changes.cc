// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/page/changes.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <rigor/mass/resolve.h>
#include <rigor/report/json/values.h>
#include <rigor/report/number.h>
#include <rigor/report/terminal/summary.h>

namespace rigor::report {
namespace {

using model::Id;

/// Digits of what is compared: an edit that changes no more is none.
constexpr int kComparedDigits = 9;
constexpr int kReportedDigits = 4;

/// Nobody sees a turn or a step that is smaller, rad and m.
constexpr double kSeenTurn = 1e-7;
constexpr double kSeenStep = 1e-9;

std::string text_of(const model::Pose& X) {
  const model::Quaternion q = positive_w(X.rotation);
  return numbers(X.translation, kComparedDigits) + ' ' + number(q.w, kComparedDigits) + ' ' +
         numbers({q.x, q.y, q.z}, kComparedDigits);
}

std::string text_of(const mass::Inertia& I) {
  return numbers({I.ixx, I.iyy, I.izz}, kComparedDigits) + ' ' +
         numbers({I.ixy, I.ixz, I.iyz}, kComparedDigits);
}

PageFacts::Link link_facts(const ModelPage& page, Id<model::Link> id) {
  const mass::MassProperties body = mass::resolve(page.root, page.frames, id, page.find_mesh).body;
  return {page.frames.pose(id), body.mass,
          numbers(body.com, kComparedDigits) + ' ' + text_of(body.about_com)};
}

/// Where its frame is does not count: it moves with its links.
std::string joint_text(const ModelPage& page, Id<model::Joint> id) {
  const model::Joint& joint = page.root[id];
  std::string text =
      fmt::format("{} {} {}", to_string(joint.type), joint.parent.value, joint.child.value);
  for (const model::Axis& axis : joint.axes) {
    text += ' ' + numbers(axis.xyz.value, kComparedDigits) + axis.expressed_in.value + ' ' +
            number(axis.lower.value, kComparedDigits) + ' ' +
            number(axis.upper.value, kComparedDigits);
    if (!axis.mimic) continue;
    const model::Mimic& mimic = *axis.mimic;
    text += ' ' + mimic.joint.value + mimic.axis.value + ' ' +
            numbers({mimic.multiplier.value, mimic.offset.value, mimic.reference.value},
                    kComparedDigits);
  }
  return text;
}

/// Seen from its link.
std::string shape_text(const ModelPage& page, const view::Body& body) {
  model::Pose X = body.pose;
  if (const auto X_WL = body.link ? page.frames.pose(body.link) : std::nullopt) {
    X = compose(inverse(*X_WL), X);
  }
  // Of the mesh its size and a sum over its places: no two that anybody draws have the same.
  double sum = 0;
  for (const model::Vector3& p : body.mesh->positions) sum = 0.7 * sum + p.x + 2 * p.y + 3 * p.z;
  std::string text = text_of(X) + ' ' + numbers(body.scale, kComparedDigits) +
                     fmt::format(" {} {} {}", body.mesh->positions.size(),
                                 body.mesh->triangles.size(), number(sum, kComparedDigits));
  for (const view::Surface& surface : body.surfaces) {
    const view::Color& c = surface.color;
    text += fmt::format(" {} {} {} {} {}", c.r, c.g, c.b, c.a, surface.texture_path);
  }
  return text;
}

class ChangeTeller {
 public:
  void links(const std::map<std::string, PageFacts::Link>& before,
             const std::map<std::string, PageFacts::Link>& after) {
    came_and_went("link", before, after);
    for (const auto& [name, now] : after) {
      const auto old = before.find(name);
      if (old != before.end()) link(name, old->second, now);
    }
  }

  void others(const char* kind, const std::map<std::string, std::string>& before,
              const std::map<std::string, std::string>& after) {
    came_and_went(kind, before, after);
    for (const auto& [name, now] : after) {
      const auto old = before.find(name);
      if (old != before.end() && old->second != now) say(kind, name, "changed");
    }
  }

  /// One that says the same of the same thing with another number is neither new nor fixed.
  void findings(const std::vector<KnownFinding>& before, const std::vector<KnownFinding>& after) {
    const FindingChanges changes = what_changed(before, after);
    std::multiset<Finding> gone;
    for (const std::size_t i : changes.fixed) gone.insert(finding(before[i]));
    std::multiset<Finding> reworded;
    for (const std::size_t i : changes.fresh) {
      const auto same = gone.find(finding(after[i]));
      if (same == gone.end()) {
        sentences.push_back(
            fmt::format("new {}: {}", to_string(after[i].severity), after[i].message));
      } else {
        reworded.insert(gone.extract(same));
      }
    }
    for (const std::size_t i : changes.fixed) {
      const auto same = reworded.find(finding(before[i]));
      if (same == reworded.end()) {
        sentences.push_back("fixed: " + before[i].message);
      } else {
        reworded.erase(same);
      }
    }
  }

  std::vector<std::string> sentences;

 private:
  using Finding = std::array<std::string, 3>;
  static Finding finding(const KnownFinding& known) {
    return {known.path, known.rule, known.subject};
  }

  void say(const char* kind, const std::string& name, const std::string& what) {
    sentences.push_back(*kind == '\0' ? name + ' ' + what
                                      : fmt::format("{} {} {}", kind, name, what));
  }

  template <class T>
  void came_and_went(const char* kind, const std::map<std::string, T>& before,
                     const std::map<std::string, T>& after) {
    for (const auto& [name, now] : after) {
      if (!before.contains(name)) say(kind, name, "added");
    }
    for (const auto& [name, old] : before) {
      if (!after.contains(name)) say(kind, name, "removed");
    }
  }

  void link(const std::string& name, const PageFacts::Link& old, const PageFacts::Link& now) {
    if (old.pose && now.pose) {
      const double step = length(now.pose->translation - old.pose->translation);
      if (step > kSeenStep) say("link", name, "moved by " + number(step, kReportedDigits) + " m");
      const model::Quaternion turn = conjugate(old.pose->rotation) * now.pose->rotation;
      const double angle =
          2 * std::atan2(model::length({turn.x, turn.y, turn.z}), std::abs(turn.w));
      if (angle > kSeenTurn)
        say("link", name, "rotated by " + number(angle, kReportedDigits) + " rad");
    } else if (old.pose || now.pose) {
      say("link", name, now.pose ? "has a place again" : "has no place any more");
    }
    if (number(old.mass, kComparedDigits) != number(now.mass, kComparedDigits)) {
      say("link", name,
          fmt::format("weighs {} kg instead of {} kg", number(now.mass, kReportedDigits),
                      number(old.mass, kReportedDigits)));
    } else if (old.rest != now.rest) {
      say("link", name, "has another inertia");
    }
  }
};

}  // namespace

PageFacts facts_of(const ModelPage& page) {
  PageFacts facts;
  for (std::uint32_t i = 0; i < page.root.links.size(); ++i) {
    const Id<model::Link> id{i};
    facts.links.emplace(scoped_name(page.root, id), link_facts(page, id));
  }
  for (std::uint32_t i = 0; i < page.root.joints.size(); ++i) {
    const Id<model::Joint> id{i};
    facts.joints.emplace(scoped_name(page.root, id), joint_text(page, id));
  }
  for (const view::Body& body : page.drawing.bodies) {
    const bool shape = body.layer == view::Layer::kVisual || body.layer == view::Layer::kCollision;
    if (shape) facts.shapes.emplace(body.name, shape_text(page, body));
  }
  facts.findings = known_findings(page.findings, page.sources);
  return facts;
}

std::vector<std::string> page_changes(const PageFacts& before, const PageFacts& after) {
  ChangeTeller teller;
  teller.links(before.links, after.links);
  teller.others("joint", before.joints, after.joints);
  teller.others("", before.shapes, after.shapes);
  teller.findings(before.findings, after.findings);
  std::vector<std::string>& said = teller.sentences;
  if (said.size() > kMaxChanges) {
    const std::string rest = counted(said.size() - kMaxChanges, "other change");
    said.resize(kMaxChanges);
    said.push_back("and " + rest);
  }
  return std::move(said);
}

std::string page_changes_json(const std::vector<std::string>& changes) {
  const Json json = {{"changes", changes}, {"nothing", changes.empty()}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace rigor::report
