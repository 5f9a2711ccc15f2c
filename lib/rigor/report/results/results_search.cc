// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/results/results_search.h>

#include <utility>

#include <fmt/core.h>

#include <rigor/report/html/markup.h>
#include <rigor/report/html/page.h>
#include <rigor/report/results/results_model.h>
#include <rigor/report/team/script.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>

namespace rigor::report {
namespace {

constexpr std::size_t kLongestSearchedPath = 300;

constexpr std::string_view kSearchScript = R"('use strict';
(function () {
  const models = document.getElementById('names').textContent.split('\n').map(function (line) {
    const parts = line.split('\t');
    return {page: parts[0], id: parts[1], worst: parts[2], path: parts[3] || ''};
  });
  for (const model of models) model.lower = model.path.toLowerCase();
  const most = 200;
  const text = document.getElementById('word');
  const list = document.getElementById('hits');
  const shown = document.getElementById('shown');
  function item(model) {
    const link = document.createElement('a');
    link.href = '../models/' + model.page + '.html#m' + model.id;
    link.textContent = model.path;
    const entry = document.createElement('li');
    entry.className = model.worst;
    entry.append(link, ' ', model.worst);
    return entry;
  }
  function find() {
    const words = text.value.toLowerCase().split(' ').filter(Boolean);
    const hits = words.length === 0 ? [] : models.filter(function (model) {
      if (model.path === '') return false;
      return words.every(function (word) { return model.lower.includes(word); });
    });
    list.replaceChildren(...hits.slice(0, most).map(item));
    shown.textContent = words.length === 0 ? '' : hits.length > most ?
      'the first ' + most + ' of ' + hits.length : String(hits.length);
  }
  text.addEventListener('input', find);
  document.getElementById('tools').hidden = false;
  find();
})();
)";

}  // namespace

std::string_view results_search_script() { return kSearchScript; }

/// Of the bytes above: `sha256sum | xxd -r -p | base64`; a test holds them together.
std::string_view results_search_script_hash() {
  return "sha256-tNPILeakZnIrjF/Ll3Y6nbk5G1Uv1XuvrjUtUld7kzU=";
}

void ResultsSearch::add(const results::ModelRow& model, std::size_t page) {
  // Tabs and line breaks become spaces, so a line is one model.
  names_ += fmt::format("{}\t{}\t{}\t{}\n", page, model.id, results_worst(model.worst),
                        escaped(printable(model.path, kLongestSearchedPath)));
  ++models_;
  if (names_.size() >= kBytesPerSearch) flush();
}

void ResultsSearch::flush() {
  ++pages_;
  std::string page = begin_page({.title = "Search models",
                                 .style = team_report_style(),
                                 .script_hash = results_search_script_hash()});
  page += fmt::format(
      "<h1><a href=\"../index.html\">Results</a>: search</h1>\n<p class=\"soft\">{} by words of "
      "their paths. The search needs a script; without one, see the lists of the index.</p>\n"
      "<div id=\"tools\" hidden=\"hidden\"><label>Path <input id=\"word\" "
      "type=\"search\"/></label> "
      "<span id=\"shown\" role=\"status\"></span></div>\n<ul id=\"hits\"></ul>\n"
      "<pre id=\"names\" hidden=\"hidden\">{}</pre>\n<script>{}</script>\n",
      counted(models_, "model"), names_, kSearchScript);
  save_({fmt::format("search/{}.html", pages_), page + end_page()});
  names_.clear();
  models_ = 0;
}

std::size_t ResultsSearch::finish() {
  if (models_ > 0) flush();
  return pages_;
}

}  // namespace rigor::report
