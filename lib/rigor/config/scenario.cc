// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/scenario.h>

#include <utility>

#include <rigor/config/toml_table.h>

namespace rigor::config {
namespace {

class ScenarioReader {
 public:
  explicit ScenarioReader(ScenarioFile& file) : file_(file) {}

  void read(const toml::table& root) {
    TomlTable top(root, "", file_.problems);
    unsigned schema = 1;
    top.take("schema", schema);
    if (schema != 1) top.say(top.line(), "schema must be 1");
    top.take("model", file_.model);
    section(top, "world", [this](TomlTable& table) { world(table); });
    section(top, "run", [this](TomlTable& table) { settings(table); });
    section(top, "spawn", [this](TomlTable& table) { table.take("on-ground", file_.on_ground); });
    if (const toml::node* joints = top.find("joints")) aliases(*joints, top);
    top.each_table("step", [this](const toml::table& table) { step(table); });
    top.each_table("assert", [this](const toml::table& table) { demand(table); });
    top.done();
    if (file_.steps.empty()) top.say(1, "a scenario needs at least one [[step]]");
  }

 private:
  template <class Use>
  void section(TomlTable& top, const char* name, const Use& use) {
    const toml::node* node = top.find(name);
    if (node == nullptr) return;
    const toml::table* table = node->as_table();
    if (table == nullptr) {
      return top.say(node->source().begin.line, std::string(name) + " must be a table");
    }
    TomlTable reader(*table, name, file_.problems);
    use(reader);
    reader.done();
  }

  void world(TomlTable& table) {
    table.take("gravity", file_.gravity);
    const toml::node* ground = table.find("ground");
    if (ground == nullptr) return;
    if (const toml::table* with = ground->as_table()) {
      TomlTable reader(*with, "world.ground", file_.problems);
      reader.take("mu", file_.ground_mu);
      reader.done();
      if (file_.ground_mu && *file_.ground_mu < 0) reader.say(reader.line(), "mu is negative");
    } else if (ground->is_boolean()) {
      file_.ground = ground->value_or(true);
    } else {
      table.say(ground->source().begin.line, "ground must be true, false or {mu = …}");
    }
  }

  void settings(TomlTable& table) {
    table.take("time-step", file_.time_step);
    table.take("solver", file_.solver);
    table.take("seeds", file_.seeds);
    if (file_.time_step && *file_.time_step <= 0)
      table.say(table.line(), "time-step must be above 0 s");
    if (file_.solver && *file_.solver != "quick" && *file_.solver != "dantzig") {
      table.say(table.line(), "solver must be quick or dantzig");
    }
    if (file_.seeds && *file_.seeds == 0) table.say(table.line(), "seeds must be at least 1");
  }

  void aliases(const toml::node& node, TomlTable& top) {
    const toml::table* table = node.as_table();
    if (table == nullptr) return top.say(node.source().begin.line, "joints must be a table");
    for (const auto& [alias, joint] : *table) {
      if (const auto name = joint.value_exact<std::string>()) {
        aliases_.emplace(alias.str(), *name);
      } else {
        top.say(joint.source().begin.line, "a joint's name must be a text");
      }
    }
  }

  std::string joint_named(const std::string& name) const {
    const auto known = aliases_.find(name);
    return known == aliases_.end() ? name : known->second;
  }

  void step(const toml::table& toml) {
    TomlTable table(toml, "step", file_.problems);
    ScenarioStep made;
    const double before = file_.steps.empty() ? 0 : file_.steps.back().until;
    table.take("name", made.name);
    if (made.name.empty()) made.name = "step " + std::to_string(file_.steps.size() + 1);
    if (table.take("until", made.until, Need::kRequired) && !(made.until > before)) {
      table.say(table.line(), "until must be later than the step before");
    }
    table.each_table("commands", [&](const toml::table& one) { command(one, made); });
    table.each_table("pushes", [&](const toml::table& one) { push(one, made, before); });
    table.each_table("tilt", [&](const toml::table& one) {
      TomlTable reader(one, "step.tilt", file_.problems);
      made.tilt.emplace();
      reader.take("angle", made.tilt->angle, Need::kRequired);
      reader.take("axis", made.tilt->axis);
      reader.done();
    });
    table.done();
    file_.steps.push_back(std::move(made));
  }

  void command(const toml::table& toml, ScenarioStep& step) {
    TomlTable table(toml, "step.commands", file_.problems);
    ScenarioCommand made;
    table.take("joint", made.joints, Need::kRequired);
    for (std::string& joint : made.joints) joint = joint_named(joint);
    int kinds = 0;
    const std::pair<const char*, CommandKind> words[] = {{"effort", CommandKind::kEffort},
                                                         {"velocity", CommandKind::kVelocity},
                                                         {"position", CommandKind::kPosition}};
    for (const auto& [word, kind] : words) {
      if (!table.take(word, made.value)) continue;
      made.kind = kind;
      ++kinds;
    }
    if (kinds != 1) {
      table.say(table.line(), "a command has one of effort, velocity and position");
    }
    table.take("ramp", made.ramp);
    table.take("axis", made.axis);
    table.take("gains", made.gains);
    table.take("max-effort", made.effort);
    table.done();
    if (made.ramp < 0) table.say(table.line(), "ramp must not be negative");
    if (made.effort && *made.effort < 0) table.say(table.line(), "max-effort must not be negative");
    if (made.gains && made.kind != CommandKind::kPosition) {
      table.say(table.line(), "gains are those of a position");
    }
    step.commands.push_back(std::move(made));
  }

  void push(const toml::table& toml, ScenarioStep& step, double begin) {
    TomlTable table(toml, "step.pushes", file_.problems);
    ScenarioPush made{.at = begin};
    table.take("link", made.link, Need::kRequired);
    table.take("impulse", made.impulse, Need::kRequired);
    table.take("point", made.point);
    table.take("at", made.at);
    table.done();
    if (made.at < begin || (step.until > begin && made.at > step.until)) {
      table.say(table.line(), "at must be within its step");
    }
    step.pushes.push_back(std::move(made));
  }

  void demand(const toml::table& toml) {
    using Of = ScenarioAssert::Of;
    TomlTable table(toml, "assert", file_.problems);
    ScenarioAssert made;
    made.line = table.line();
    table.take("name", made.name);
    int kinds = 0;
    const std::pair<const char*, Of> words[] = {{"metric", Of::kMetric},
                                                {"position", Of::kPosition},
                                                {"orientation", Of::kOrientation},
                                                {"joint", Of::kJointPosition},
                                                {"joint-velocity", Of::kJointVelocity}};
    for (const auto& [word, of] : words) {
      if (!table.take(word, made.name_of)) continue;
      made.of = of;
      ++kinds;
    }
    if (kinds != 1) {
      table.say(made.line,
                "an assertion is of one metric, position, orientation, joint or joint-velocity");
    }
    if (made.of == Of::kJointPosition || made.of == Of::kJointVelocity) {
      made.name_of = joint_named(made.name_of);
    }
    axis_of(table, made);
    table.take("at", made.at);
    table.take("min", made.min);
    table.take("max", made.max);
    table.done();
    if (!made.min && !made.max) table.say(made.line, "an assertion needs min or max");
    if (made.min && made.max && *made.min > *made.max) table.say(made.line, "min is above max");
    if (made.at && made.of == Of::kMetric)
      table.say(made.line, "a metric is of the whole run: no at");
    if (made.name.empty()) made.name = made.name_of;
    file_.asserts.push_back(std::move(made));
  }

  static void axis_of(TomlTable& table, ScenarioAssert& made) {
    using Of = ScenarioAssert::Of;
    std::string axis;
    if (!table.take("axis", axis)) {
      if (made.of == Of::kPosition || made.of == Of::kOrientation) {
        table.say(made.line, "axis is missing");
      }
      return;
    }
    constexpr std::array<std::string_view, 6> kAxes{"x", "y", "z", "roll", "pitch", "yaw"};
    const auto found = std::find(kAxes.begin(), kAxes.end(), axis);
    const auto index = static_cast<unsigned>(found - kAxes.begin());
    const bool fits = (made.of == Of::kPosition && index < 3) ||
                      (made.of == Of::kOrientation && index >= 3 && index < 6);
    if (!fits) {
      return table.say(made.line, made.of == Of::kPosition ? "axis must be x, y or z"
                                                           : "axis must be roll, pitch or yaw");
    }
    made.axis = index % 3;
  }

  ScenarioFile& file_;
  std::map<std::string, std::string> aliases_;
};

}  // namespace

ScenarioFile read_scenario(const std::string& path, std::string_view bytes) {
  ScenarioFile file;
  file.path = path;
  if (const auto table = parse_toml(bytes, file.problems)) ScenarioReader(file).read(*table);
  return file;
}

}  // namespace rigor::config
