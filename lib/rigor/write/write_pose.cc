// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/write/write_pose.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <string_view>

#include <rigor/model/pose.h>
#include <rigor/read/values.h>
#include <rigor/schema/value.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/edit.h>

namespace rigor::write {
namespace {

using model::Quaternion;
using xml::Element;
using PoseNumbers = std::vector<double>;

constexpr double kQuarter = std::numbers::pi / 2;
constexpr Quaternion kBack{std::numbers::sqrt2 / 2, -std::numbers::sqrt2 / 2, 0, 0};

/// An angle this near to a multiple of 90° is one, rad: π/2 with eleven decimals, as many files
/// have it, is off by 4.9e-12, which moves nothing within 200 m by more than a nanometer.
constexpr double kAngleNoise = 5e-12;

double roll_turned_back(double roll, double quarter) {
  double turned = roll - quarter;
  if (turned <= -2 * quarter) turned += 4 * quarter;
  const double whole = quarter * std::round(turned / quarter);
  if (std::abs(turned - whole) <= kAngleNoise / kQuarter * quarter) return whole + 0.0;
  return settled(turned, roll, quarter);
}

/// Of x, y, z, w.
PoseNumbers turned_back(const PoseNumbers& n) {
  const Quaternion q = normalized(Quaternion{n[3], n[0], n[1], n[2]}) * kBack;
  constexpr double kSize = 0.5;  // of a component, so that fifteen decimals are kept
  return {settled(q.x, n[0], kSize), settled(q.y, n[1], kSize), settled(q.z, n[2], kSize),
          settled(q.w, n[3], kSize)};
}

enum class Unit { kRadian, kDegree };

/// Three angles, or four numbers of a quaternion.
PoseNumbers turned(PoseNumbers rotation, Turn turn, Unit unit) {
  if (turn == Turn::kNone) return rotation;
  if (rotation.size() == 4) return turned_back(rotation);
  rotation[0] = roll_turned_back(rotation[0], unit == Unit::kDegree ? 90 : kQuarter);
  return rotation;
}

/// The numbers of a value, those of the identity where there is no text. Nothing when it is no
/// pose.
std::optional<PoseNumbers> read_numbers(std::string_view text, const PoseNumbers& identity) {
  if (read::trimmed(text).empty()) return identity;
  const auto numbers = numbers_in(text);
  if (!numbers || numbers->size() != identity.size()) return std::nullopt;
  const auto finite = [](double number) { return std::isfinite(number); };
  return std::all_of(numbers->begin(), numbers->end(), finite) ? numbers : std::nullopt;
}

/// The child that a new pose goes behind: what precedes the geometry, as in the schema.
std::optional<Element> before_geometry(Element part) {
  std::optional<Element> last;
  for (const Element child : part.children()) {
    if (child.name() == "geometry" || child.name() == "material") break;
    last = child;
  }
  return last;
}

class PoseWriter {
 public:
  PoseWriter(const xml::Document& document, Element part, PoseForm form, const model::Pose& X,
             const PoseChange& change)
      : document_(document), part_(part), form_(form), turn_(change.turn) {
    const Quaternion R = turn_ == Turn::kNone ? X.rotation : X.rotation * kBack;
    translation_ = X.translation + rotate(R, change.offset);
    size_ = std::max(length(X.translation), length(change.offset));
  }

  std::optional<std::vector<Edit>> write() const {
    const auto element = part_.child(form_ == PoseForm::kPose ? "pose" : "origin");
    if (!element) return inserted();
    return form_ == PoseForm::kUrdf ? urdf(*element) : sdf(*element);
  }

 private:
  PoseNumbers translation(const PoseNumbers& old) const {
    const auto& [x, y, z] = translation_;
    return {settled(x, old[0], size_), settled(y, old[1], size_), settled(z, old[2], size_)};
  }

  std::vector<Edit> inserted() const {
    const PoseNumbers xyz = translation({0, 0, 0});
    const PoseNumbers rpy = turned({0, 0, 0}, turn_, Unit::kRadian);
    if (xyz == PoseNumbers{0, 0, 0} && rpy == xyz) return {};
    std::string text;
    switch (form_) {
      case PoseForm::kPose: text = "<pose>" + joined(xyz) + ' ' + joined(rpy) + "</pose>"; break;
      case PoseForm::kOldOrigin:
        text = "<origin pose=\"" + joined(xyz) + ' ' + joined(rpy) + "\"/>";
        break;
      case PoseForm::kUrdf:
        text = "<origin xyz=\"" + joined(xyz) + "\" rpy=\"" + joined(rpy) + "\"/>";
        break;
    }
    return insert_child(document_, part_, before_geometry(part_), text);
  }

  std::optional<std::vector<Edit>> sdf(Element element) const {
    const auto format = read::attribute_text(element, "rotation_format");
    const bool quaternion = format && read::trimmed(format->text) == "quat_xyzw";
    const bool degrees = bool_field(read::attribute_text(element, "degrees"), false).value;

    const bool in_attribute = form_ == PoseForm::kOldOrigin;
    const auto attribute = read::attribute_text(element, "pose");
    std::string_view text = element.text();
    if (in_attribute) text = attribute ? attribute->text : std::string_view();
    const auto old = read_numbers(
        text, quaternion ? PoseNumbers{0, 0, 0, 0, 0, 0, 1} : PoseNumbers{0, 0, 0, 0, 0, 0});
    if (!old) return std::nullopt;

    PoseNumbers numbers = translation(*old);
    const PoseNumbers rotation =
        turned({old->begin() + 3, old->end()}, turn_, degrees ? Unit::kDegree : Unit::kRadian);
    numbers.insert(numbers.end(), rotation.begin(), rotation.end());
    if (numbers == *old) return std::vector<Edit>();
    return in_attribute ? set_numbers(document_, element, "pose", numbers)
                        : set_numbers(document_, element, numbers);
  }

  std::optional<std::vector<Edit>> urdf(Element origin) const {
    // From URDF 1.2 a quaternion takes the angles' place.
    const bool quaternion = origin.attribute("quat_xyzw").has_value();
    const std::string_view name = quaternion ? "quat_xyzw" : "rpy";
    const auto xyz = in_attribute(origin, "xyz", {0, 0, 0});
    const auto rotation =
        in_attribute(origin, name, quaternion ? PoseNumbers{0, 0, 0, 1} : PoseNumbers{0, 0, 0});
    if (!xyz || !rotation) return std::nullopt;
    return set_attributes(origin, {{"xyz", *xyz, translation(*xyz)},
                                   {name, *rotation, turned(*rotation, turn_, Unit::kRadian)}});
  }

  static std::optional<PoseNumbers> in_attribute(Element origin, std::string_view name,
                                                 const PoseNumbers& identity) {
    const auto text = read::attribute_text(origin, name);
    return read_numbers(text ? text->text : std::string_view(), identity);
  }

  struct Change {
    std::string_view attribute;
    PoseNumbers before;
    PoseNumbers after;
  };

  /// Those that are missing are added in one edit, since two would be in one place.
  std::vector<Edit> set_attributes(Element origin, const std::vector<Change>& changes) const {
    std::vector<Edit> edits;
    std::vector<xml::NamedValue> missing;
    for (const auto& [name, before, after] : changes) {
      if (before == after) continue;
      if (!origin.attribute(name)) {
        missing.push_back({name, joined(after)});
        continue;
      }
      const std::vector<Edit> set = set_numbers(document_, origin, name, after);
      edits.insert(edits.end(), set.begin(), set.end());
    }
    const std::vector<Edit> added = xml::set_attributes(document_, origin, missing);
    edits.insert(edits.end(), added.begin(), added.end());
    return edits;
  }

  const xml::Document& document_;
  Element part_;
  PoseForm form_;
  Turn turn_;
  model::Vector3 translation_;  // the new one, m
  double size_;                 // of what it was computed from, m
};

}  // namespace

PoseForm pose_form(const model::Model& model) {
  if (model.format == model::Format::kUrdf) return PoseForm::kUrdf;
  return model.version == 0 ? PoseForm::kOldOrigin : PoseForm::kPose;
}

std::optional<std::vector<Edit>> write_pose(const xml::Document& document, Element part,
                                            PoseForm form, const model::Pose& X,
                                            const PoseChange& change) {
  if (!document.complete() || part.cut()) return std::nullopt;
  return PoseWriter(document, part, form, X, change).write();
}

}  // namespace rigor::write
