// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/rules/list.h>

#include <algorithm>
#include <array>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <rigor/report/tool.h>

namespace rigor::report {
namespace {

using Row = std::array<std::string_view, 6>;

constexpr Row kHeadline = {"rule", "category", "severity", "fix", "since", "what is wrong"};

std::vector<Row> rows_of(const rules::Registry& registry) {
  std::vector<Row> rows;
  for (const rules::Rule& rule : registry.rules()) {
    rows.push_back({rule.name, to_string(rule.category), to_string(rule.severity),
                    fix_name(rule.fix), rule.since, rule.summary});
  }
  return rows;
}

}  // namespace

std::string_view fix_name(rules::FixGrade grade) {
  switch (grade) {
    case rules::FixGrade::kSafe: return "safe";
    case rules::FixGrade::kUnsafe: return "unsafe";
    case rules::FixGrade::kNone: break;
  }
  return "none";
}

std::string_view formats_name(rules::Formats formats) {
  switch (formats) {
    case rules::Formats::kSdf: return "sdf";
    case rules::Formats::kUrdf: return "urdf";
    case rules::Formats::kModelConfig: return "model-config";
    case rules::Formats::kMjcf: return "mjcf";
    case rules::Formats::kAny: break;
  }
  return "any";
}

std::string rules_text(const rules::Registry& registry) {
  std::vector<Row> rows = rows_of(registry);
  rows.insert(rows.begin(), kHeadline);
  std::array<std::size_t, std::tuple_size_v<Row>> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string out;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      out += fmt::format("{:<{}}  ", row[i], widths[i]);
    }
    out += row.back();
    out += '\n';
  }
  return out;
}

std::string rules_json(const rules::Registry& registry) {
  nlohmann::ordered_json json = {{"tool", {{"name", kToolName}, {"version", tool_version()}}},
                                 {"schema_version", kSchemaVersion},
                                 {"rules", nlohmann::ordered_json::array()}};
  for (const rules::Rule& rule : registry.rules()) {
    json["rules"].push_back({{"name", rule.name},
                             {"category", to_string(rule.category)},
                             {"severity", to_string(rule.severity)},
                             {"formats", formats_name(rule.formats)},
                             {"fix", fix_name(rule.fix)},
                             {"since", rule.since},
                             {"summary", rule.summary},
                             {"why", rule.why},
                             {"what_to_do", rule.what_to_do}});
  }
  return json.dump(2) + '\n';
}

}  // namespace rigor::report
