// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include <rigor/convert/from_mjcf/sdf_builder.h>
#include <rigor/convert/number_text.h>
#include <rigor/convert/xml_writer.h>
#include <rigor/read/mjcf/mjcf_pose.h>
#include <rigor/read/mjcf/mjcf_settings.h>
#include <rigor/read/values.h>

namespace rigor::convert {
namespace {

using model::Pose;

/// SDF's camera looks along x, with z up; MuJoCo's along -z, with y up.
constexpr model::Quaternion kFromCameraOfSdf{0.5, 0.5, -0.5, -0.5};
/// The sides of an image, which MJCF leaves to who renders it.
constexpr int kImageWidth = 320, kImageHeight = 240;
/// degrees, of a camera that says nothing.
constexpr double kFieldOfView = 45;

std::string pose_words(const Pose& X) {
  const UrdfOrigin origin = origin_of(X);
  return number_texts(origin.xyz) + ' ' + number_texts(origin.rpy);
}

class MjcfSensorReader {
 public:
  MjcfSensorReader(const MjcfPlan& plan, Ledger& ledger) : plan_(plan), ledger_(ledger) {}

  MjcfSensors read() {
    std::vector<std::string> order;
    std::map<std::string, std::vector<xml::Element>> by_site;
    for (const xml::Element element : plan_.scope.tree.in_sections("sensor")) {
      std::string site = mjcf_word(element, "site");
      if (site.empty() && mjcf_word(element, "objtype") == "site")
        site = mjcf_word(element, "objname");
      if (site.empty()) continue;
      if (by_site[site].empty()) order.push_back(site);
      by_site[site].push_back(element);
    }
    for (const std::string& site : order) add_at(site, by_site[site]);
    for (std::uint32_t i = 0; i < plan_.root().links.size(); ++i) {
      if (i != plan_.world && plan_.chosen[i] && !plan_.is_between(i)) add_cameras(i);
    }
    return std::move(sensors_);
  }

 private:
  /// That no shape and no other sensor of the link has.
  std::string name_in(std::uint32_t body, const std::string& name) {
    const auto [taken, first] = taken_.try_emplace(body);
    if (first) {
      for (const auto* parts :
           {&plan_.robot.bodies[body].visuals, &plan_.robot.bodies[body].collisions}) {
        for (const robot::Part& part : *parts) taken->second.insert(part.name);
      }
    }
    return plan_.unique(taken->second, name);
  }

  struct Placed {
    std::uint32_t body;
    Pose X_LS;
  };

  std::optional<Placed> place_of(const std::string& site) const {
    std::uint32_t body = 0;
    const auto X_LS = plan_.site_pose(site, body);
    if (X_LS && body != plan_.world && plan_.chosen[body]) return Placed{body, *X_LS};
    return std::nullopt;
  }

  void add_at(const std::string& site, const std::vector<xml::Element>& elements) {
    const auto placed = place_of(site);
    if (!placed) return;
    std::vector<xml::Element> inertial, wrench, magnetic, orientation;
    for (const xml::Element element : elements) {
      const std::string_view tag = element.name();
      if (tag == "accelerometer" || tag == "gyro") inertial.push_back(element);
      if (tag == "framequat") orientation.push_back(element);
      if (tag == "force" || tag == "torque") wrench.push_back(element);
      if (tag == "magnetometer") magnetic.push_back(element);
    }
    if (!inertial.empty()) {
      inertial.insert(inertial.end(), orientation.begin(), orientation.end());
      take(inertial, "an imu");
      sensors_.of_body[placed->body].push_back(
          sensor(name_in(placed->body, site), "imu", placed->X_LS));
    }
    if (!magnetic.empty()) {
      take(magnetic, "a magnetometer");
      sensors_.of_body[placed->body].push_back(
          sensor(name_in(placed->body, site), "magnetometer", placed->X_LS));
    }
    if (wrench.empty() || !plan_.is_carried(placed->body)) return;
    take(wrench, "a force_torque sensor");
    const std::uint32_t carrier = plan_.robot.bodies[placed->body].carrier;
    const Pose X_LJ = plan_.root()[plan_.joint_ids[carrier]].pose.pose.value;
    sensors_.of_joint[carrier].push_back(
        sensor(site, "force_torque", compose(inverse(X_LJ), placed->X_LS), [](XmlWriter& out) {
          out.open("force_torque");
          out.text("frame", "sensor");
          out.text("measure_direction", "parent_to_child");
          out.close();
        }));
  }

  void take(const std::vector<xml::Element>& elements, const std::string& instead) {
    for (const xml::Element element : elements) {
      ledger_.take_all(element, Outcome::kSubstituted);
      ledger_.note({.kind = NoteKind::kFromMjcfSensor,
                    .outcome = Outcome::kSubstituted,
                    .where = element.name_span(),
                    .subject = std::string(element.name()) + " " + mjcf_word(element, "name"),
                    .written = std::string(element.name()),
                    .instead = instead});
      for (const char* setting : {"noise", "cutoff"}) tell_setting(element, setting);
    }
  }

  /// Noise that is added by who reads the sensor, and the largest value.
  void tell_setting(xml::Element element, const char* setting) {
    const auto text = read::attribute_text(element, setting);
    const auto number = text ? read::mjcf_numbers(text->text) : std::nullopt;
    if (!number || number->size() != 1 || number->front() == 0) return;
    ledger_.take_value(text->span, Outcome::kLost);
    ledger_.note({.kind = NoteKind::kFromMjcfSensor,
                  .where = text->span,
                  .subject = std::string(element.name()) + " " + mjcf_word(element, "name"),
                  .written = std::string(setting) + " " + std::string(text->text) + " of the " +
                             std::string(element.name())});
  }

  template <class Content>
  static std::string sensor(const std::string& name, const std::string& type, const Pose& X,
                            const Content& content) {
    XmlWriter out;
    out.open("sensor", {{"name", name}, {"type", type}});
    if (X != Pose{}) out.text("pose", pose_words(X));
    content(out);
    out.close();
    return std::move(out).take();
  }
  static std::string sensor(const std::string& name, const std::string& type, const Pose& X) {
    return sensor(name, type, X, [](XmlWriter& out) { out.text("always_on", "true"); });
  }

  /// Of the body itself, not of frames and copies in it.
  void add_cameras(std::uint32_t body) {
    const xml::Element element = plan_.source.source.documents.element(plan_.link(body).site);
    for (const xml::Element child : plan_.scope.tree.children(element)) {
      if (child.name() != "camera") continue;
      const auto id = plan_.scope.defaults.find(mjcf_word(child, "class"));
      const read::MjcfValues values =
          plan_.scope.defaults.values(child, "camera", id.value_or(read::MjcfDefaults::kMain));
      const std::string mode = values.string("mode", "fixed").value;
      const double fovy = values.number("fovy", kFieldOfView).value * std::numbers::pi / 180;
      if (mode != "fixed" || !(fovy > 0) || !(fovy < std::numbers::pi)) continue;
      const Pose X = compose(read::mjcf_pose(values, plan_.scope.settings),
                             inverse(Pose{{}, kFromCameraOfSdf}));
      int width = kImageWidth, height = kImageHeight;
      constexpr double kMostPixels = 32768;
      const std::vector<double> n = values.numbers("resolution");
      // MuJoCo's own 1 × 1 is no image.
      const bool sized =
          n.size() == 2 && n[0] > 1 && n[1] > 1 && n[0] <= kMostPixels && n[1] <= kMostPixels;
      if (sized) {
        width = static_cast<int>(n[0]);
        height = static_cast<int>(n[1]);
      }
      const double across = 2 * std::atan(std::tan(fovy / 2) * width / height);
      std::string name = mjcf_word(child, "name");
      name = name_in(body, name.empty() ? "camera" : name);
      take({child}, "a camera of " + std::to_string(width) + " x " + std::to_string(height));
      sensors_.of_body[body].push_back(sensor(name, "camera", X, [&](XmlWriter& out) {
        out.open("camera");
        out.text("horizontal_fov", to_text({across, {}}));
        out.open("image");
        out.text("width", std::to_string(width));
        out.text("height", std::to_string(height));
        out.close();
        out.close();
      }));
    }
  }

  const MjcfPlan& plan_;
  Ledger& ledger_;
  MjcfSensors sensors_;
  std::map<std::uint32_t, model::UniqueNames> taken_;
};

}  // namespace

MjcfSensors mjcf_to_sdf_sensors(const MjcfPlan& plan, Ledger& ledger) {
  return MjcfSensorReader(plan, ledger).read();
}

}  // namespace rigor::convert
