// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the keys of a TOML table one by one, and says which are missing, of the wrong type, or known to
// nobody.
//
//   TomlTable step(table, "step", problems);
//   step.take("until", scenario_step.until, Need::kRequired);
//   step.done();                        // what was not taken is a problem

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/config/config.h>
#include <rigor/config/toml_text.h>

namespace rigor::config {

enum class Need : std::uint8_t { kOptional, kRequired };

class TomlTable {
 public:
  TomlTable(const toml::table& table, std::string name, std::vector<Problem>& problems)
      : table_(table), name_(std::move(name)), problems_(problems) {}

  /// The node under a key, which is known from then on; null when there is none.
  const toml::node* find(std::string_view key) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
    return table_.get(key);
  }

  /// False when there is no such key, or no such value under it.
  template <class T>
  bool take(std::string_view key, T& value, Need need = Need::kOptional) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      if (need == Need::kRequired) say(line(), std::string(key) + " is missing");
      return false;
    }
    if (read(*node, value)) return true;
    say(node->source().begin.line, std::string(key) + " must be " + wanted(value));
    return false;
  }

  template <class T>
  void take(std::string_view key, std::optional<T>& value) {
    T read{};
    if (take(key, read)) value = read;
  }

  /// A table under a key, or each table of a list of them.
  template <class Use>
  void each_table(std::string_view key, const Use& use) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const toml::array* list = node->as_array();
    if (const toml::table* one = node->as_table()) return use(*one);
    const bool tables = list != nullptr && std::all_of(list->begin(), list->end(),
                                                       [](const auto& e) { return e.is_table(); });
    if (!tables)
      return say(node->source().begin.line, std::string(key) + " must be a list of tables");
    for (const toml::node& one : *list) use(*one.as_table());
  }

  void say(unsigned line, const std::string& what) {
    problems_.push_back({line, name_.empty() ? what : '[' + name_ + "] " + what});
  }

  unsigned line() const { return table_.source().begin.line; }

  /// Tells of each key that nobody asked for.
  void done() {
    for (const auto& [key, node] : table_) {
      const std::string_view name = key.str();
      if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
      std::string list;
      for (const std::string& each : known_) list += (list.empty() ? "" : ", ") + each;
      say(key.source().begin.line, "unknown key " + std::string(name) + " (known: " + list + ")");
      problems_.back().name = name;
      problems_.back().known = known_;
    }
  }

 private:
  static bool read(const toml::node& node, std::string& value) {
    const auto text = node.value_exact<std::string>();
    if (text) value = *text;
    return text.has_value();
  }
  static bool read(const toml::node& node, bool& value) {
    const auto flag = node.value_exact<bool>();
    if (flag) value = *flag;
    return flag.has_value();
  }
  static bool read(const toml::node& node, double& value) {
    if (!node.is_number()) return false;
    value = node.value_or(0.0);
    return std::isfinite(value);
  }
  static bool read(const toml::node& node, unsigned& value) {
    const auto number = node.value_exact<std::int64_t>();
    if (!number || *number < 0 || *number > UINT32_MAX) return false;
    value = static_cast<unsigned>(*number);
    return true;
  }
  static bool read(const toml::node& node, std::array<double, 3>& value) {
    const toml::array* list = node.as_array();
    if (list == nullptr || list->size() != value.size()) return false;
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (!read(*list->get(i), value[i])) return false;
    }
    return true;
  }
  static bool read(const toml::node& node, std::vector<std::string>& value) {
    value.resize(1);
    if (read(node, value.front())) return true;
    const toml::array* list = node.as_array();
    if (list == nullptr || list->empty()) return false;
    value.resize(list->size());
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (!read(*list->get(i), value[i])) return false;
    }
    return true;
  }

  static const char* wanted(const std::string&) { return "a text"; }
  static const char* wanted(bool) { return "true or false"; }
  static const char* wanted(double) { return "a finite number"; }
  static const char* wanted(unsigned) { return "a whole number, not negative"; }
  static const char* wanted(const std::array<double, 3>&) { return "three finite numbers"; }
  static const char* wanted(const std::vector<std::string>&) { return "a text or a list of texts"; }

  const toml::table& table_;
  std::string name_;
  std::vector<Problem>& problems_;
  std::vector<std::string> known_;
};

}  // namespace rigor::config
