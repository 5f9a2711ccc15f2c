// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/results/results_site.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <rigor/report/results/results_search.h>
#include <rigor/results/reader.h>
#include <rigor/results/writer.h>
#include <rigor/text/base64.h>

#include "results/result_lines.h"

namespace rigor::report {
namespace {

using SiteFiles = std::map<std::string, std::string>;

constexpr std::size_t kLargestPage = std::size_t{30} << 20U;

SiteFiles site_of(const std::string& database) {
  SiteFiles files;
  std::string last;
  const results::Reader reader(database);
  write_results_site(reader, [&](const SiteFile& file) {
    EXPECT_TRUE(files.emplace(file.path, file.bytes).second) << file.path;
    last = file.path;
  });
  EXPECT_EQ(last, "index.html");
  return files;
}

/// Texts that stand between `before` and the next `end`.
std::set<std::string> texts_after(const std::string& text, const std::string& before, char end) {
  std::set<std::string> found;
  for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at)) {
    at += before.size();
    found.insert(text.substr(at, text.find(end, at) - at));
  }
  return found;
}

/// Every page is XML and small, and every link leads to a page and a place in it.
void expect_sound(const SiteFiles& files) {
  std::map<std::string, std::set<std::string>> ids;
  for (const auto& [path, bytes] : files) {
    EXPECT_LT(bytes.size(), kLargestPage) << path;
    tinyxml2::XMLDocument document;
    EXPECT_EQ(document.Parse(bytes.data(), bytes.size()), tinyxml2::XML_SUCCESS)
        << path << ": " << document.ErrorStr();
    ids[path] = texts_after(bytes, "id=\"", '"');
  }
  for (const auto& [path, bytes] : files) {
    const std::string folder = path.substr(0, path.find('/') + 1);
    for (std::string link : texts_after(bytes, "<a href=\"", '"')) {
      const std::string full = link;
      link = link.starts_with("../") ? link.substr(3) : folder + link;
      const std::string target = link.substr(0, link.find('#'));
      ASSERT_TRUE(files.contains(target)) << path << " links to " << full;
      if (link.size() > target.size()) {
        EXPECT_TRUE(ids[target].contains(link.substr(target.size() + 1))) << full;
      }
    }
  }
}

TEST(ResultsSite, LinksLeadToEveryModelAndRule) {
  const results::ResultsFolder folder;
  const std::string path = folder.path("results.sqlite");
  results::write_database(results::lines_of_both(500), 4, path);
  const SiteFiles files = site_of(path);
  expect_sound(files);
  std::size_t sections = 0;
  for (std::size_t page = 1; page <= 3; ++page)
    sections += texts_after(files.at(fmt::format("models/{}.html", page)), "id=\"m", '"').size();
  EXPECT_EQ(sections, 500U);
  EXPECT_EQ(files.count("models/4.html"), 0U);
  EXPECT_EQ(texts_after(files.at("rules/1.html"), ".html#m", '"').size(), 167U)
      << "each third of 500";
  EXPECT_EQ(texts_after(files.at("search/1.html"), "\tmodels/", '/').size(), 500U);
  EXPECT_EQ(files, site_of(path)) << "the same bytes";
}

/// What a model's author may have written: markup, line breaks, texts of a hundred kilobytes, a thousand findings.
results::CheckedFile hostile_file(std::uint64_t index) {
  results::CheckedFile file;
  const std::string name =
      "</pre><script>alert(1)</script>\n\t\"'&\x01\xff" + std::to_string(index);
  file.one = {index, 20, name};
  file.path = name + std::string(100'000, '<');
  file.kind = file.version = name;
  file.skipped.assign(1000, name);
  for (std::size_t i = 0; i < 1000; ++i) {
    const results::Place place{name, 1, 1, 1, 2, name, std::string(2000, '&')};
    file.findings.push_back(
        {name + std::to_string(i % 3), name, i % 2 ? "error" : name, place, {}});
  }
  return file;
}

TEST(ResultsSite, HostileTextsStayTextAndPagesSmall) {
  const results::ResultsFolder folder;
  const std::string path = folder.path("results.sqlite");
  results::Writer writer(path);
  for (std::uint64_t i = 0; i < 20; ++i) writer.add(hostile_file(i));
  writer.finish();
  const SiteFiles files = site_of(path);
  expect_sound(files);
  for (const auto& [name, bytes] : files) {
    EXPECT_EQ(bytes.find("<script>alert"), std::string::npos) << name;
    EXPECT_TRUE(std::regex_match(name, std::regex("index\\.html|[a-z]+/\\d+\\.html"))) << name;
  }
}

TEST(ResultsSite, AnEmptyDatabaseIsAnIndex) {
  const results::ResultsFolder folder;
  const std::string path = folder.path("results.sqlite");
  results::Writer(path).finish();
  const SiteFiles files = site_of(path);
  EXPECT_EQ(files.size(), 1U);
  expect_sound(files);
}

TEST(ResultsSite, OnlyItsOwnScriptRuns) {
  const results::ResultsFolder folder;
  const std::string name = folder.path("script.js");
  std::ofstream(name) << results_search_script();
  std::FILE* pipe = ::popen(("sha256sum '" + name + "'").c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  char digits[65] = {};
  ASSERT_EQ(std::fread(digits, 1, 64, pipe), 64U);
  ::pclose(pipe);
  std::string digest;
  for (std::size_t i = 0; i < 64; i += 2)
    digest += static_cast<char>(std::stoi(std::string(digits + i, 2), nullptr, 16));
  EXPECT_EQ(results_search_script_hash(), "sha256-" + base64(digest));
}

}  // namespace
}  // namespace rigor::report
