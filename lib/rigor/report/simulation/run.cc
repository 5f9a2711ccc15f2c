// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/simulation/run.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <fmt/core.h>

#include <rigor/report/html/markup.h>
#include <rigor/report/html/svg_plot.h>
#include <rigor/report/number.h>

namespace rigor::report {
namespace {

std::string limit_cell(const std::optional<double>& limit) {
  return fmt::format("<td class=\"n\">{}</td>", limit ? number(*limit, 4) : "");
}

std::string metric_table(const simulate::Run& run) {
  std::string out =
      "<table><tr><th>metric</th><th>value</th><th>unit</th><th>warn</th><th>fail</th><th></th></"
      "tr>";
  for (const simulate::Metric& metric : run.metrics) {
    out +=
        fmt::format("<tr><td>{}</td><td class=\"n\">{}</td><td>{}</td>{}{}<td>{}</td></tr>\n",
                    escaped(metric.id), number(metric.value, 5), escaped(metric.unit),
                    limit_cell(metric.warn), limit_cell(metric.fail), verdict_html(metric.verdict));
  }
  return out + "</table>\n";
}

/// What is plotted of a run: of the first model's base, and of all axes.
struct Curves {
  std::vector<double> x, y, z, speed, tilt;
  std::vector<Series> positions, velocities;
};

/// The link that represents the model: the first one of its base, or the first that moves.
std::size_t base_link(const simulate::Scene& scene) {
  for (const simulate::SceneModel& model : scene.models) {
    if (model.base == simulate::kWorld) continue;
    return scene.bodies[model.base].links.front();
  }
  for (std::size_t i = 0; i < scene.links.size(); ++i) {
    if (scene.links[i].body != simulate::kWorld) return i;
  }
  return 0;
}

/// Between the z axis then and now, rad.
double tilt_between(const model::Quaternion& before, const model::Quaternion& now) {
  const double cosine = dot(rotate(before, {0, 0, 1}), rotate(now, {0, 0, 1}));
  return std::acos(std::fmin(1, std::fmax(-1, cosine)));
}

Curves curves_of(const simulate::Scene& scene, const simulate::Record& record) {
  Curves curves;
  const std::size_t links = scene.links.size();
  const std::size_t count = record.times.size();
  const std::size_t base = base_link(scene);
  for (const simulate::SceneJoint& joint : scene.joints) {
    for (std::size_t axis = 0; axis < joint.axes.size(); ++axis) {
      curves.positions.push_back({joint.name, {}});
      curves.velocities.push_back({joint.name, {}});
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const model::Pose& X_WL = record.link_poses[i * links + base];
    curves.x.push_back(X_WL.translation.x);
    curves.y.push_back(X_WL.translation.y);
    curves.z.push_back(X_WL.translation.z);
    curves.tilt.push_back(tilt_between(record.link_poses[base].rotation, X_WL.rotation));
    if (i > 0) {
      const model::Pose& before = record.link_poses[(i - 1) * links + base];
      const double step = record.times[i] - record.times[i - 1];
      curves.speed.push_back(length(X_WL.translation - before.translation) / step);
    } else {
      curves.speed.push_back(0);
    }
    for (std::size_t a = 0; a < curves.positions.size(); ++a) {
      const double* values = &record.axis_values[(i * curves.positions.size() + a) * 2];
      curves.positions[a].values.push_back(values[0]);
      curves.velocities[a].values.push_back(values[1]);
    }
  }
  return curves;
}

std::string plots(const simulate::Scene& scene, const simulate::Run& run) {
  const simulate::Record& record = run.record;
  if (record.times.empty() || scene.links.empty()) return {};
  const Curves curves = curves_of(scene, record);
  std::string out = "<div class=\"plots\">\n";
  const auto over_time = [&](const char* what, const char* unit,
                             const std::vector<double>& values) {
    out += svg_plot({what, unit}, record.times, {{what, values}}) + '\n';
  };
  over_time("Height of the base", "m", curves.z);
  over_time("Speed of the base", "m/s", curves.speed);
  over_time("Tilt of the base", "rad", curves.tilt);
  out += svg_path({"Path from above: y over x", "m"}, curves.x, curves.y) + '\n';
  out += svg_path({"Path from the side: z over x", "m"}, curves.x, curves.z) + '\n';
  if (!curves.positions.empty()) {
    out += svg_plot({"Joint positions", "rad, m"}, record.times, curves.positions) + '\n';
    out += svg_plot({"Joint velocities", "rad/s, m/s"}, record.times, curves.velocities) + '\n';
  }
  return out + "</div>\n";
}

}  // namespace

std::string run_name(const simulate::Run& run) {
  if (run.engine == simulate::EngineKind::kOde) return run.test;
  return run.test + " (" + std::string(name_of(run.engine)) + ')';
}

std::string verdict_html(simulate::Verdict verdict) {
  return fmt::format("<span class=\"{0}\">{0}</span>", to_string(verdict));
}

std::string run_html(const simulate::Scene& scene, const simulate::Run& run) {
  std::string out = fmt::format(
      "<details class=\"run\"><summary>{} – {}: {} s in {} steps, seed {}", escaped(run_name(run)),
      verdict_html(run.verdict), number(run.record.end_time), run.record.steps, run.seed);
  for (const simulate::Confirmation& each : run.confirmations) {
    out += fmt::format("; with {}: {}", escaped(each.what), verdict_html(each.verdict));
  }
  if (!run.record.message.empty()) out += "; " + escaped(run.record.message);
  return out + "</summary>\n" + plots(scene, run) + "<h4>" + std::to_string(run.metrics.size()) +
         " metrics</h4>" + metric_table(run) + "</details>\n";
}

}  // namespace rigor::report
