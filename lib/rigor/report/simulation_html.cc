// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <fmt/core.h>

#include <rigor/report/concise.h>
#include <rigor/report/markup.h>
#include <rigor/report/number.h>
#include <rigor/report/simulation.h>
#include <rigor/report/svg_plot.h>
#include <rigor/report/tool.h>

namespace rigor::report {
namespace {

using author::SimulatedModel;

constexpr std::string_view kStyle = R"(
:root{color-scheme:light dark;--ink:#1c2430;--back:#fff;--soft:#6b7683;--line:#d9dfe6;--pass:#18794e;
--warn:#ad5700;--fail:#ce2c31;--c0:#0b68cb;--c1:#c2410c;--c2:#18794e;--c3:#8e4ec6;--c4:#ad5700;--c5:#0e7490}
@media(prefers-color-scheme:dark){:root{--ink:#e6e9ee;--back:#12161c;--soft:#98a2ae;--line:#2b333d;
--pass:#3dd68c;--warn:#ffb224;--fail:#ff6369;--c0:#52a9ff;--c1:#ff8b3e;--c2:#3dd68c;--c3:#bf7af0;
--c4:#ffb224;--c5:#4ccce6}}
body{font:15px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--back);margin:2rem auto;
max-width:76rem;padding:0 1rem}h1{font-size:1.4rem}h2{font-size:1.15rem;margin-top:2.5rem}
table{border-collapse:collapse;margin:.5rem 0}td,th{padding:.15rem .7rem .15rem 0;text-align:left;
border-bottom:1px solid var(--line)}td.n{text-align:right;font-variant-numeric:tabular-nums}
pre{white-space:pre-wrap;background:color-mix(in srgb,var(--line) 40%,transparent);padding:.7rem}
.pass{color:var(--pass)}.warn,.solver{color:var(--warn)}.fail,.invalid{color:var(--fail)}
.plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(22rem,1fr));gap:.5rem}
svg{width:100%}svg path{fill:none;stroke-width:1.4}svg text{font:10px system-ui,sans-serif;
fill:var(--soft)}svg .title{font-size:12px;fill:var(--ink)}svg .mid{text-anchor:middle}
svg .end{text-anchor:end}svg .grid{stroke:var(--line);stroke-width:.7}.dot{fill:var(--c0)}
.s0{stroke:var(--c0)}.s1{stroke:var(--c1)}.s2{stroke:var(--c2)}.s3{stroke:var(--c3)}
.s4{stroke:var(--c4)}.s5{stroke:var(--c5)}
)";

std::string word(simulate::Verdict verdict) {
  return fmt::format("<span class=\"{0}\">{0}</span>", to_string(verdict));
}

std::string limit_cell(const std::optional<double>& limit) {
  return fmt::format("<td class=\"n\">{}</td>", limit ? number(*limit, 4) : "");
}

std::string metric_table(const simulate::Run& run) {
  std::string out =
      "<table><tr><th>metric</th><th>value</th><th>unit</th><th>warn</th><th>fail</th><th></th></"
      "tr>";
  for (const simulate::Metric& metric : run.metrics) {
    out += fmt::format("<tr><td>{}</td><td class=\"n\">{}</td><td>{}</td>{}{}<td>{}</td></tr>\n",
                       escaped(metric.id), number(metric.value, 5), escaped(metric.unit),
                       limit_cell(metric.warn), limit_cell(metric.fail), word(metric.verdict));
  }
  return out + "</table>\n";
}

/// What is plotted of a run: of the first model's base, and of all axes.
struct Curves {
  std::vector<double> x, y, z, speed, tilt;
  std::vector<Series> positions, velocities;
};

/// The link that stands for the model: the first one of its base, or the first that moves.
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

std::string run_section(const simulate::Scene& scene, const simulate::Run& run) {
  std::string out =
      fmt::format("<h3>{} – {}</h3>\n<p>{} s in {} steps, seed {}", escaped(run.test),
                  word(run.verdict), number(run.record.end_time), run.record.steps, run.seed);
  for (const simulate::Confirmation& each : run.confirmations) {
    out += fmt::format("; with {}: {}", escaped(each.what), word(each.verdict));
  }
  if (!run.record.message.empty()) out += "; " + escaped(run.record.message);
  return out + "</p>\n" + plots(scene, run) + "<details><summary>" +
         std::to_string(run.metrics.size()) + " metrics</summary>" + metric_table(run) +
         "</details>\n";
}

std::string model_section(const SimulatedModel& model, const Sources& sources) {
  std::string out = fmt::format("<h2>{} – {}</h2>\n", escaped(model.path), word(model.verdict()));
  const std::string findings = concise(model.diagnostics, sources);
  if (!findings.empty()) out += "<pre>" + escaped(findings) + "</pre>\n";
  for (const simulate::Run& run : model.simulation.runs) out += run_section(model.scene, run);
  for (const std::string& why : model.left_out) out += "<p>left out: " + escaped(why) + "</p>\n";
  return out;
}

}  // namespace

std::string simulation_html(const SimulationReport& report) {
  std::string out = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "style-src 'unsafe-inline'\">\n<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<title>rigor simulate</title>\n<style>{}</style></head><body>\n<h1>{}</h1>\n<p>{} {}</p>\n",
      kStyle, escaped(simulation_summary(report)), kToolName, tool_version());
  for (const SimulatedModel& model : report.models) out += model_section(model, report.sources);
  return out + "</body></html>\n";
}

}  // namespace rigor::report
