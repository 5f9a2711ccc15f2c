// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/json/diagnostic.h>
#include <rigor/report/json/values.h>
#include <rigor/report/number.h>
#include <rigor/report/simulation/simulation.h>
#include <rigor/report/tool.h>

namespace rigor::report {
namespace {

using author::SimulatedModel;

Json limit_of(const std::optional<double>& limit) { return limit ? finite(*limit) : Json(nullptr); }

Json metric_of(const simulate::Metric& metric) {
  return {{"id", metric.id},
          {"value", finite(metric.value)},
          {"unit", metric.unit},
          {"warn", limit_of(metric.warn)},
          {"fail", limit_of(metric.fail)},
          {"verdict", to_string(metric.verdict)}};
}

std::string_view kind_name(simulate::CommandKind kind) {
  switch (kind) {
    case simulate::CommandKind::kEffort: return "effort";
    case simulate::CommandKind::kVelocity: return "velocity";
    case simulate::CommandKind::kPosition: return "position";
  }
  return {};
}

std::string_view base_name(simulate::Base base) {
  switch (base) {
    case simulate::Base::kFree: return "free";
    case simulate::Base::kFixed: return "fixed";
    case simulate::Base::kHang: return "hang";
  }
  return {};
}

Json command_of(const simulate::Command& command, const simulate::Scene& scene) {
  Json json = {{"joint", scene.joints[command.joint].name},
               {"axis", command.axis},
               {"kind", kind_name(command.kind)},
               {"value", finite(command.value)},
               {"begin", finite(command.begin)},
               {"end", finite(command.end)},
               {"ramp", finite(command.ramp)}};
  if (command.gains) {
    json["gains"] = {{"p", finite(command.gains->p)},
                     {"i", finite(command.gains->i)},
                     {"d", finite(command.gains->d)}};
  }
  return json;
}

Json final_poses(const simulate::Record& record, const simulate::Scene& scene) {
  Json poses = Json::object();
  const std::size_t links = scene.links.size();
  if (record.link_poses.size() < links) return poses;
  const model::Pose* last = record.link_poses.data() + record.link_poses.size() - links;
  for (std::size_t i = 0; i < links; ++i) {
    const model::Vector3& p = last[i].translation;
    const model::Quaternion q = positive_w(last[i].rotation);
    poses[scene.links[i].name] = Json::array({finite(p.x), finite(p.y), finite(p.z), finite(q.w),
                                              finite(q.x), finite(q.y), finite(q.z)});
  }
  return poses;
}

Json run_of(const simulate::Run& run, const simulate::Scene& scene) {
  Json metrics = Json::array();
  for (const simulate::Metric& metric : run.metrics) metrics.push_back(metric_of(metric));
  Json commands = Json::array();
  for (const simulate::Command& command : run.scenario.commands) {
    commands.push_back(command_of(command, scene));
  }
  Json confirmations = Json::array();
  for (const simulate::Confirmation& each : run.confirmations) {
    confirmations.push_back({{"what", each.what},
                             {"verdict", to_string(each.verdict)},
                             {"agrees", each.agrees},
                             {"in_time", each.in_time},
                             {"lacking", each.lacking}});
  }
  return {{"test", run.test},
          {"seed", run.seed},
          {"engine", name_of(run.engine)},
          {"base", base_name(run.scenario.base)},
          {"verdict", to_string(run.verdict)},
          {"duration", finite(run.record.end_time)},
          {"steps", run.record.steps},
          {"metrics", std::move(metrics)},
          {"commands", std::move(commands)},
          {"confirmations", std::move(confirmations)},
          {"final", {{"pose", final_poses(run.record, scene)}}},
          {"state_hash", run.record.state_hash}};
}

Json comparison_of(const simulate::EngineComparison& comparison) {
  Json metrics = Json::array();
  for (const simulate::MetricPair& pair : comparison.metrics) {
    metrics.push_back({{"id", pair.id},
                       {"unit", pair.unit},
                       {"ode", finite(pair.ode)},
                       {"mujoco", finite(pair.mujoco)},
                       {"ode_verdict", to_string(pair.ode_verdict)},
                       {"mujoco_verdict", to_string(pair.mujoco_verdict)}});
  }
  return {{"test", comparison.test},
          {"ode", to_string(comparison.ode)},
          {"mujoco", to_string(comparison.mujoco)},
          {"apart", finite(comparison.apart)},
          {"differences", comparison.differences},
          {"explanation", comparison.explanation},
          {"metrics", std::move(metrics)}};
}

Json model_of(const SimulatedModel& model, const Sources& sources) {
  Json runs = Json::array();
  for (const simulate::Run& run : model.simulation.runs) runs.push_back(run_of(run, model.scene));
  Json json = {
      {"model", model.path},     {"verdict", to_string(model.verdict())},
      {"runs", std::move(runs)}, {"left_out", model.left_out},
      {"notes", model.notes},    {"diagnostics", diagnostics_of(model.diagnostics, sources)}};
  if (model.simulation.comparisons.empty()) return json;
  json["comparisons"] = Json::array();
  for (const simulate::EngineComparison& each : model.simulation.comparisons) {
    json["comparisons"].push_back(comparison_of(each));
  }
  return json;
}

Json case_of(const SimulatedModel& model) {
  return {{"case", {{"index", model.one.index}, {"of", model.cases}, {"id", model.one.id}}}};
}

Json head() {
  return {{"tool", {{"name", kToolName}, {"version", tool_version()}}},
          {"schema_version", kSchemaVersion}};
}

bool of_one_model(const SimulationReport& report) {
  return !report.models.empty() &&
         std::all_of(report.models.begin(), report.models.end(), [&](const SimulatedModel& model) {
           return model.path == report.models.front().path;
         });
}

/// The cases of one model: all runs, each with the name of its case, and the worst verdict.
Json joined(const SimulationReport& report) {
  Json all = model_of(report.models.front(), report.sources);
  simulate::Verdict verdict = simulate::Verdict::kPass;
  all["runs"] = Json::array();
  all["diagnostics"] = Json::array();
  for (const SimulatedModel& model : report.models) {
    verdict = simulate::worse(verdict, model.verdict());
    Json one = model_of(model, report.sources);
    for (Json& run : one["runs"]) {
      run["case"] = model.one.id;
      all["runs"].push_back(std::move(run));
    }
    for (Json& found : one["diagnostics"]) all["diagnostics"].push_back(std::move(found));
  }
  all["verdict"] = to_string(verdict);
  return all;
}

}  // namespace

std::string simulation_json(const SimulationReport& report) {
  Json json = head();
  if (report.models.size() == 1) {
    json.update(model_of(report.models.front(), report.sources));
  } else if (of_one_model(report)) {
    json.update(joined(report));
  } else {
    json["models"] = Json::array();
    for (const SimulatedModel& model : report.models) {
      json["models"].push_back(case_of(model));
      json["models"].back().update(model_of(model, report.sources));
    }
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string simulation_line(const SimulatedModel& model, const Sources& sources) {
  Json line = case_of(model);
  line.update(model_of(model, sources));
  return line.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rigor::report
