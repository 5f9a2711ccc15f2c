// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/page/model_page.h>

#include <utility>

#include <rigor/report/page/embedded_page.h>
#include <rigor/report/page/json_page.h>
#include <rigor/report/tool.h>
#include <rigor/text/path.h>

namespace rigor::report {
namespace {

/// Where a template takes the data.
constexpr std::string_view kDataMark = "<!--DATA-->";

/// Of the page's title: a world, a lone model, or the file.
std::string page_name(const ModelPage& page) {
  const model::Root& root = page.root;
  if (!root.worlds.empty()) return root.worlds.front().name.value;
  for (const model::Model& model : root.models) {
    if (!model.parent && !model.name.value.empty()) return model.name.value;
  }
  return std::string(file_name(page.path));
}

/// No text of a file can end the element that the data stand in.
std::string without_tags(const std::string& json) {
  std::string out;
  out.reserve(json.size() + json.size() / 16);
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

void PageFiles::place(Json& json, Span where) {
  json["line"] = where.nowhere() ? Json(nullptr) : Json(places_.begin(where).line);
  json["file"] = where.nowhere() ? -1 : index_of(places_.path(where), places_.bytes(where.source));
}

void PageFiles::add(SourceId source) {
  if (source != kNoSource) index_of(places_.path({source, 0, 0}), places_.bytes(source));
}

int PageFiles::index_of(const Diagnostic& diagnostic) {
  const Span where = diagnostic.where;
  return index_of(places_.path(diagnostic),
                  where.nowhere() ? std::string_view() : places_.bytes(where.source));
}

int PageFiles::index_of(std::string_view path, std::string_view text) {
  const auto known = known_.find(path);
  if (known != known_.end()) return known->second;
  const int index = static_cast<int>(files_.size());
  if (text.size() > kMaxPageText - text_) text = {};
  text_ += text.size();
  files_.push_back({{"path", path}, {"text", text}});
  known_.emplace(path, index);
  return index;
}

PageData page_data(const ModelPage& page) {
  PageFiles files(page.sources);
  files.add(page.root.source);  // the first, whatever stands where
  PageBytes bytes;
  Json data = {{"format", 1},
               {"rigor", tool_version()},
               {"name", page_name(page)},
               {"path", page.path},
               {"live", page.use == PageUse::kServed}};
  add_entities(data, page, files);
  add_scene(data, page, files, bytes);
  add_findings(data, page, files);
  data["files"] = files.json();
  return {without_tags(data.dump(-1, ' ', false, Json::error_handler_t::replace)), bytes.text()};
}

std::string model_page(const PageData& data, std::string_view page_template) {
  const std::size_t mark = page_template.find(kDataMark);
  if (mark == std::string_view::npos) return {};
  std::string html;
  html.reserve(page_template.size() + data.json.size() + data.bytes.size() + 200);
  html += page_template.substr(0, mark);
  html += "<script id=\"data\" type=\"application/json\">";
  html += data.json;
  html += "</script>\n<script id=\"bytes\" type=\"text/plain\">";
  html += data.bytes;
  html += "</script>";
  html += page_template.substr(mark + kDataMark.size());
  return html;
}

std::string_view page_template(PageUse use) {
  return use == PageUse::kServed ? embedded_live_page() : embedded_page();
}

}  // namespace rigor::report
