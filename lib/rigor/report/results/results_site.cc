// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/results/results_site.h>

#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/report/html/markup.h>
#include <rigor/report/html/page.h>
#include <rigor/report/results/results_model.h>
#include <rigor/report/results/results_search.h>
#include <rigor/report/team/script.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>

namespace rigor::report {
namespace {

using results::ModelRow;
using results::Reader;
using results::RuleTotal;
using results::Worst;

constexpr std::size_t kLongestRuleName = 100;

/// Rules with pages of their own; nobody has more, but a file that somebody else made may.
constexpr std::size_t kMaxRulePages = 2000;

std::string begin_results_page(std::string_view title) {
  return begin_page({.title = title, .style = team_report_style()});
}

std::string count_words(std::uint64_t count) {
  std::string text = counted(count, "x", "x");
  text.resize(text.size() - 2);
  return text;
}

std::string rule_name(const RuleTotal& rule) {
  return escaped(printable(rule.rule, kLongestRuleName));
}

std::string tile_of(std::uint64_t value, std::string_view what, std::string_view kind) {
  return fmt::format("<li class=\"{}\"><b>{}</b> {}</li>\n", value == 0 ? "none" : kind,
                     count_words(value), what);
}

std::string tiles(const results::Totals& totals) {
  const auto of = [&](Worst worst) { return totals.by_worst[static_cast<std::size_t>(worst)]; };
  std::string out = "<ul class=\"tiles\">\n" + tile_of(totals.models, "models", "") +
                    tile_of(of(Worst::kError), "with errors or failed", "error") +
                    tile_of(of(Worst::kWarning), "with warnings at worst", "warning") +
                    tile_of(of(Worst::kInfo), "with infos at worst", "") +
                    tile_of(of(Worst::kClean), "clean", "pass") +
                    tile_of(totals.skipped, "things skipped", "warning") + "</ul>\n";
  if (totals.simulated > 0) {
    out += "<ul class=\"tiles\" aria-label=\"Simulation\">\n" +
           tile_of(totals.simulated, "cases simulated", "");
    for (const auto& [verdict, count] : totals.by_verdict) {
      const std::string word = escaped(printable(verdict, kLongestRuleName));
      out += tile_of(count, "models: " + word, word);
    }
    out += "</ul>\n";
  }
  if (totals.checked > 0) {
    out += fmt::format("<p class=\"soft\">{} checked; {} of different bytes, used {} times.</p>\n",
                       counted(totals.checked, "file"), counted(totals.meshes, "mesh", "meshes"),
                       count_words(totals.mesh_uses));
  }
  return out;
}

class ResultsSite {
 public:
  ResultsSite(const Reader& reader, const std::function<void(const SiteFile&)>& save)
      : reader_(reader), save_(save), rules_(reader.rules()), search_(save) {
    if (rules_.size() > kMaxRulePages) rules_.resize(kMaxRulePages);
    for (std::size_t i = 0; i < rules_.size(); ++i)
      rule_pages_[{rules_[i].rule, rules_[i].severity}] = i + 1;
  }

  void write() {
    reader_.each_model([this](const ModelRow& model) { add(model); });
    if (chunk_.models > 0) flush("");
    const std::size_t searches = search_.finish();
    for (std::size_t i = 0; i < rules_.size(); ++i) write_rule(i);
    write_index(searches);
  }

 private:
  /// Models that are on one page, for the index.
  struct Chunk {
    ModelRow first;  ///< the worst of them
    std::size_t models = 0;
  };

  std::size_t page() const { return chunks_.size() + 1; }

  void add(const ModelRow& model) {
    if (chunk_.models >= kModelsPerPage || sections_.size() >= kBytesPerPage)
      flush(fmt::format("<a href=\"{}.html\">next</a>", page() + 1));
    if (chunk_.models == 0) chunk_.first = model;
    ++chunk_.models;
    sections_ += results_model(model, reader_.details(model.id, {}), rule_pages_);
    page_of_[model.id] = page();
    search_.add(model, page());
  }

  /// `next` leads to the page after this one.
  void flush(const std::string& next) {
    std::string html = begin_results_page(fmt::format("Models, page {}", page())) +
                       fmt::format(
                           "<h1><a href=\"../index.html\">Results</a>: models, page {}</h1>\n"
                           "<p>",
                           page());
    if (page() > 1) html += fmt::format("<a href=\"{}.html\">previous</a> ", page() - 1);
    html += next + "</p>\n";
    save_({fmt::format("models/{}.html", page()), html + sections_ + end_page()});
    chunks_.push_back(std::exchange(chunk_, {}));
    sections_.clear();
  }

  void write_rule(std::size_t index) const {
    const RuleTotal& rule = rules_[index];
    const std::string name = rule_name(rule);
    std::string html =
        begin_results_page(printable(rule.rule, kLongestRuleName)) +
        fmt::format(
            "<h1><a href=\"../index.html\">Results</a>: {}</h1>\n<p>{}, {}: {} in {}. "
            "<code>rigor explain {}</code> says why and what to do.</p>\n<ul>\n",
            name, escaped(rule.severity), escaped(rule.category), counted(rule.findings, "finding"),
            counted(rule.models, "model"), name);
    reader_.models_of(rule, kModelsPerRule, [&](const ModelRow& model, std::uint64_t findings) {
      const auto page = page_of_.find(model.id);
      if (page == page_of_.end()) return;
      html += fmt::format("<li><a href=\"../models/{}.html#m{}\">{}</a>{}</li>\n", page->second,
                          model.id, results_path(model.path),
                          findings > 1 ? " (" + counted(findings, "finding") + ")" : "");
    });
    html += "</ul>\n";
    if (rule.models > kModelsPerRule) {
      html += fmt::format(
          "<p class=\"soft\">and {} more: <code>SELECT DISTINCT models.path FROM findings JOIN "
          "models ON models.id = model_id WHERE rule = '{}'</code></p>\n",
          count_words(rule.models - kModelsPerRule), name);
    }
    save_({fmt::format("rules/{}.html", index + 1), html + end_page()});
  }

  void write_index(std::size_t searches) const {
    std::string html =
        begin_results_page("Results") + "<h1>Results</h1>\n" + tiles(reader_.totals()) + "<p>";
    for (std::size_t page = 1; page <= searches; ++page) {
      html += fmt::format("<a href=\"search/{}.html\">Search models by name{}</a> ", page,
                          searches > 1 ? ", part " + std::to_string(page) : "");
    }
    html += "</p>\n" + rules_table() + chunks_table();
    save_({"index.html", html + end_page()});
  }

  std::string rules_table() const {
    if (rules_.empty()) return "<p>No findings.</p>\n";
    std::string out =
        "<h2>Rules</h2>\n<table><thead><tr><th>Rule</th><th>Category</th><th>Severity</th>"
        "<th class=\"n\">Findings</th><th class=\"n\">Models</th></tr></thead><tbody>\n";
    for (std::size_t i = 0; i < rules_.size(); ++i) {
      out += fmt::format(
          "<tr><td><a href=\"rules/{}.html\">{}</a></td><td>{}</td><td class=\"{}\">{}</td>"
          "<td class=\"n\">{}</td><td class=\"n\">{}</td></tr>\n",
          i + 1, rule_name(rules_[i]), escaped(rules_[i].category), escaped(rules_[i].severity),
          escaped(rules_[i].severity), count_words(rules_[i].findings),
          count_words(rules_[i].models));
    }
    return out + "</tbody></table>\n";
  }

  std::string chunks_table() const {
    if (chunks_.empty()) return {};
    std::string out =
        "<h2>Models, the worst first</h2>\n<table><thead><tr><th>Page</th><th>Worst</th>"
        "<th class=\"n\">Errors, at most</th><th class=\"n\">Models</th><th>First</th></tr></thead>"
        "<tbody>\n";
    for (std::size_t i = 0; i < chunks_.size(); ++i) {
      const Chunk& chunk = chunks_[i];
      out += fmt::format(
          "<tr><td><a href=\"models/{0}.html\">{0}</a></td><td class=\"{1}\">{1}</td>"
          "<td class=\"n\">{2}</td><td class=\"n\">{3}</td><td>{4}</td></tr>\n",
          i + 1, results_worst(chunk.first.worst), count_words(chunk.first.errors), chunk.models,
          results_path(chunk.first.path));
    }
    return out + "</tbody></table>\n";
  }

  const Reader& reader_;
  const std::function<void(const SiteFile&)>& save_;
  std::vector<RuleTotal> rules_;
  RulePages rule_pages_;
  ResultsSearch search_;
  std::unordered_map<std::int64_t, std::size_t> page_of_;  // by a model's number
  std::vector<Chunk> chunks_;
  Chunk chunk_;
  std::string sections_;
};

}  // namespace

void write_results_site(const Reader& reader, const std::function<void(const SiteFile&)>& save) {
  ResultsSite(reader, save).write();
}

}  // namespace rigor::report
