// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <rigor/config/toml_table.h>
#include <rigor/text/path.h>

namespace rigor::config {
namespace {

unsigned line_of(const toml::node& node) { return node.source().begin.line; }

std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

struct LevelWord {
  std::string_view word;
  Level level;
};

using LevelWords = std::array<LevelWord, 4>;
constexpr LevelWords kSeverityWords{{{"error", Severity::kError},
                                     {"warning", Severity::kWarning},
                                     {"info", Severity::kInfo},
                                     {"off", std::nullopt}}};
constexpr LevelWords kFailOnWords{{{"error", Severity::kError},
                                   {"warning", Severity::kWarning},
                                   {"info", Severity::kInfo},
                                   {"never", std::nullopt}}};

class ConfigReader {
 public:
  ConfigReader(const std::string& path, Config& config)
      : path_(path), folder_(parent_path(path)), config_(config) {}

  void read(const toml::table& root) {
    TomlTable top(root, "", config_.problems);
    config_.extend = text(top, "extend");
    if (const toml::node* node = top.find("root")) {
      if (const auto flag = node->value_exact<bool>()) {
        config_.root = {*flag, at(*node)};
      } else {
        top.say(line_of(*node), "root must be true or false");
      }
    }
    rules(top, config_.rules);
    if (const toml::node* node = top.find("fail-on")) {
      config_.fail_on = level(*node, "fail-on", kFailOnWords, top);
    }
    config_.targets = names(top, "target");
    if (auto patterns = path_patterns(top, "exclude")) {
      config_.exclude.push_back(std::move(*patterns));
    }
    config_.baseline = path(top, "baseline");
    top.each_table("per-file", [this](const toml::table& table) { per_file(table); });
    top.each_table("xacro", [this](const toml::table& table) { template_arguments(table); });
    table(top, "resolve", [this](const toml::table& table) { resolve(table); });
    table(top, "format", [this](const toml::table& table) { layout(table); });
    table(top, "materials", [&](const toml::table& table) { materials(table, top); });
    top.done();
  }

 private:
  Place at(const toml::node& node) const { return {path_, line_of(node)}; }

  template <class Use>
  static void table(TomlTable& above, const char* key, const Use& use) {
    const toml::node* node = above.find(key);
    if (node == nullptr) return;
    if (const toml::table* table = node->as_table()) return use(*table);
    above.say(line_of(*node), '[' + std::string(key) + "] must be a table");
  }

  /// Nothing, and a problem, when it is none or empty.
  std::optional<Name> text(const toml::node& node, std::string_view what, TomlTable& table) const {
    const auto value = node.value_exact<std::string>();
    if (value && !value->empty()) return Name{*value, at(node)};
    table.say(line_of(node),
              std::string(what) + (value ? " must not be empty" : " must be a text"));
    return std::nullopt;
  }

  std::optional<Name> text(TomlTable& table, std::string_view key) const {
    const toml::node* node = table.find(key);
    if (node == nullptr) return std::nullopt;
    return text(*node, key, table);
  }

  /// As seen from the file's folder.
  std::optional<Name> path(TomlTable& table, std::string_view key) const {
    std::optional<Name> name = text(table, key);
    if (name) name->value = join_path(folder_, name->value);
    return name;
  }

  /// A text, or a list of texts, which may be empty.
  std::optional<std::vector<Name>> names(TomlTable& table, std::string_view key) const {
    const toml::node* node = table.find(key);
    if (node == nullptr) return std::nullopt;
    std::vector<Name> list;
    const toml::array* array = node->as_array();
    if (array == nullptr && !node->is_string()) {
      table.say(line_of(*node), std::string(key) + " must be a text or a list of texts");
      return std::nullopt;
    }
    const auto add = [&](const toml::node& each) {
      if (auto name = text(each, "each of " + std::string(key), table)) {
        list.push_back(std::move(*name));
      }
    };
    if (array == nullptr) {
      add(*node);
    } else {
      for (const toml::node& each : *array) add(each);
    }
    return list;
  }

  std::optional<PathPatterns> path_patterns(TomlTable& table, std::string_view key) const {
    const auto list = names(table, key);
    if (!list) return std::nullopt;
    std::vector<Name> usable;
    for (const Name& pattern : *list) {
      const std::string why = unusable_pattern(pattern.value);
      if (why.empty()) {
        usable.push_back(pattern);
      } else {
        table.say(pattern.place.line, "the pattern " + quoted(pattern.value) + ' ' + why);
      }
    }
    return PathPatterns(folder_, std::move(usable));
  }

  std::optional<Setting<Level>> level(const toml::node& node, const std::string& what,
                                      const LevelWords& words, TomlTable& table) const {
    const auto value = node.value_exact<std::string>();
    std::string known;
    std::vector<std::string> candidates;
    for (const LevelWord& each : words) {
      if (value && *value == each.word) return Setting<Level>{each.level, at(node)};
      known += (known.empty() ? "" : ", ") + std::string(each.word);
      candidates.emplace_back(each.word);
    }
    table.say(line_of(node),
              what + " must be one of " + known + (value ? ", not " + quoted(*value) : ""));
    if (value) {
      config_.problems.back().name = *value;
      config_.problems.back().known = std::move(candidates);
    }
    return std::nullopt;
  }

  void rules(TomlTable& from, RuleChoice& choice) const {
    const toml::node* select = from.find("select");
    if (select != nullptr && select->is_array() && select->as_array()->empty()) {
      from.say(line_of(*select), "select names no rule: leave it out to run all of them");
    }
    choice.select = names(from, "select");
    if (choice.select && choice.select->empty()) choice.select.reset();
    choice.ignore = names(from, "ignore").value_or(std::vector<Name>{});
    table(from, "severity", [&](const toml::table& levels) {
      for (const auto& [rule, node] : levels) {
        const std::string name(rule.str());
        if (auto set = level(node, "the severity of " + name, kSeverityWords, from)) {
          choice.severity.emplace(name, std::move(*set));
        }
      }
    });
  }

  void per_file(const toml::table& toml) const {
    TomlTable table(toml, "per-file", config_.problems);
    PerFile made;
    if (toml.get("files") == nullptr) table.say(table.line(), "files is missing");
    if (auto files = path_patterns(table, "files")) made.files = std::move(*files);
    rules(table, made.rules);
    table.done();
    config_.per_file.push_back(std::move(made));
  }

  void template_arguments(const toml::table& toml) const {
    TomlTable from(toml, "xacro", config_.problems);
    TemplateArguments made;
    if (toml.get("file") == nullptr) from.say(from.line(), "file is missing");
    if (auto file = path(from, "file")) made.file = std::move(*file);
    const toml::node* sets = from.find("arguments");
    const toml::array* array = sets != nullptr ? sets->as_array() : nullptr;
    if (array == nullptr) {
      from.say(from.line(), "arguments must be a list of tables: [{ side = \"left\" }]");
    } else {
      for (const toml::node& each : *array) {
        const toml::table* set = each.as_table();
        if (set == nullptr) {
          from.say(line_of(each), "each of arguments must be a table: { side = \"left\" }");
        } else {
          made.sets.push_back(argument_set(*set, from));
        }
      }
    }
    from.done();
    config_.templates.push_back(std::move(made));
  }

  static std::vector<std::pair<std::string, std::string>> argument_set(const toml::table& set,
                                                                       TomlTable& from) {
    std::vector<std::pair<std::string, std::string>> arguments;
    for (const auto& [name, node] : set) {
      std::string value;
      if (const auto text = node.value_exact<std::string>()) {
        value = *text;
      } else if (const auto flag = node.value_exact<bool>()) {
        value = *flag ? "true" : "false";
      } else if (const auto number = node.value_exact<std::int64_t>()) {
        value = std::to_string(*number);
      } else {
        from.say(line_of(node), "an argument must be a text, a whole number, true or false");
        continue;
      }
      arguments.emplace_back(std::string(name.str()), std::move(value));
    }
    return arguments;
  }

  void resolve(const toml::table& toml) const {
    TomlTable from(toml, "resolve", config_.problems);
    for (Name& folder : names(from, "paths").value_or(std::vector<Name>{})) {
      folder.value = join_path(folder_, folder.value);
      config_.resolve_paths.push_back(std::move(folder));
    }
    table(from, "packages", [&](const toml::table& packages) {
      for (const auto& [package, node] : packages) {
        const std::string name(package.str());
        if (auto folder = text(node, "the folder of " + name, from)) {
          folder->value = join_path(folder_, folder->value);
          config_.resolve_packages.emplace(name, std::move(*folder));
        }
      }
    });
    from.done();
  }

  void layout(const toml::table& toml) const {
    TomlTable from(toml, "format", config_.problems);
    if (const toml::node* node = from.find("indent")) {
      const auto spaces = node->value_exact<std::int64_t>();
      if (node->value_exact<std::string>() == "tab") {
        config_.layout.indent = {"\t", at(*node)};
      } else if (spaces && *spaces >= 1 && *spaces <= 8) {
        config_.layout.indent = {std::string(static_cast<std::size_t>(*spaces), ' '), at(*node)};
      } else {
        from.say(line_of(*node), "indent must be 1 to 8 spaces, or \"tab\"");
      }
    }
    unsigned width = 0;
    if (from.take("width", width)) config_.layout.width = {width, at(*from.find("width"))};
    if (auto quotes = text(from, "quotes")) {
      if (std::find(kQuotes.begin(), kQuotes.end(), quotes->value) != kQuotes.end()) {
        config_.layout.quotes = std::move(quotes);
      } else {
        from.say(quotes->place.line, "quotes must be one of double, single, keep");
      }
    }
    if (auto order = text(from, "order")) {
      if (std::find(kOrders.begin(), kOrders.end(), order->value) != kOrders.end()) {
        config_.layout.order = std::move(order);
      } else {
        from.say(order->place.line, "order must be one of keep, canonical");
      }
    }
    from.done();
  }

  void materials(const toml::table& toml, TomlTable& top) const {
    for (const auto& [name, node] : toml) {
      const auto density = node.value<double>();
      if (node.is_number() && density && *density > 0 && std::isfinite(*density)) {
        config_.materials.emplace(name.str(), Setting<double>{*density, at(node)});
      } else {
        top.say(line_of(node),
                "the density of '" + std::string(name.str()) + "' must be a number above 0 kg/m³");
      }
    }
  }

  const std::string& path_;
  std::string folder_;
  Config& config_;
};

}  // namespace

Config read_config(const std::string& path, std::string_view bytes) {
  Config config;
  config.files.push_back(path);
  if (const auto table = parse_toml(bytes, config.problems)) {
    ConfigReader(path, config).read(*table);
  }
  for (Problem& problem : config.problems) problem.path = path;
  std::stable_sort(config.problems.begin(), config.problems.end(),
                   [](const Problem& a, const Problem& b) { return a.line < b.line; });
  return config;
}

}  // namespace rigor::config
