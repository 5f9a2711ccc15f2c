// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Up to 1.5 an IMU has one noise for its three rates and one for its three accelerations; since 1.6 each
// axis has its own.

#include <string>

#include <rigor/author/upgrade/step.h>
#include <rigor/read/values.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

/// `<noise type="gaussian">` with the numbers of `from`, on each axis.
std::string noise_of_axes(std::string_view quantity, xml::Element noise, std::string_view from) {
  const auto type = noise.child("type");
  const std::string kind = type ? std::string(read::trimmed(type->text())) : "gaussian";
  std::string numbers;
  if (const auto given = noise.child(from)) {
    for (const std::string_view name : {"mean", "stddev", "bias_mean", "bias_stddev"}) {
      const auto number = given->child(name);
      if (!number) continue;
      const std::string tag(name);
      numbers +=
          "      <" + tag + '>' + xml::escaped(read::trimmed(number->text())) + "</" + tag + ">\n";
    }
  }
  std::string xml = '<' + std::string(quantity) + ">\n";
  for (const char axis : {'x', 'y', 'z'}) {
    xml += std::string("  <") + axis + ">\n    <noise type=\"" + xml::escaped(kind) + '"';
    xml += numbers.empty() ? "/>\n" : ">\n" + numbers + "    </noise>\n";
    xml += std::string("  </") + axis + ">\n";
  }
  return xml + "</" + std::string(quantity) + '>';
}

}  // namespace

void upgrade_imu_noise(UpgradeStep& step) {
  step.for_each("sensor", "imu", [&](xml::Element imu) {
    const auto found = imu.child("noise");
    if (!found || imu.child("angular_velocity") || imu.child("linear_acceleration")) return;
    const xml::Element noise = *found;
    step.edit(xml::replace_element(step.document(), noise,
                                   noise_of_axes("angular_velocity", noise, "rate") + '\n' +
                                       noise_of_axes("linear_acceleration", noise, "accel")));
    const Span span = noise.span();
    const std::string_view bytes = step.document().bytes().substr(span.begin, span.size());
    if (bytes.find("<!--") == std::string_view::npos) return;
    step.note(UpgradeNoteKind::kCommentLost, Severity::kWarning, span,
              "a comment in the noise, which is written for each axis now, is left out");
  });
}

}  // namespace rigor::author
