// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A result of a check made by hand, for the tests of its reports.

#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/report/validation.h>
#include <rigor/rules/registry.h>
#include <rigor/rules/validate.h>

namespace rigor::report {

/// Files with findings, as `validate` returns them.
class Found {
 public:
  /// The findings that are added next are this file's.
  Found& file(const std::string& path, const std::string& bytes) {
    source_ = sources.add(path, bytes);
    const std::size_t count = result.diagnostics.list().size();
    rules::FileSummary summary;
    summary.path = path;
    summary.format = model::Format::kSdf;
    summary.version = "1.9";
    summary.index = result.files.size();
    summary.first_finding = summary.end_finding = count;
    result.files.push_back(summary);
    result.all_files = result.files.size();
    return *this;
  }

  /// A finding at the first place where `text` stands in the file.
  Found& at(const std::string& text, Diagnostic diagnostic) {
    diagnostic.where = span_of(text);
    return add(std::move(diagnostic));
  }

  Found& add(Diagnostic diagnostic) {
    if (diagnostic.rule.empty()) diagnostic.rule = "axis-zero";
    if (diagnostic.category.empty()) diagnostic.category = "kinematics";
    result.diagnostics.add(std::move(diagnostic));
    result.files.back().end_finding = result.diagnostics.list().size();
    return *this;
  }

  Span span_of(const std::string& text) const {
    const auto begin = static_cast<std::uint32_t>(sources.bytes(source_).find(text));
    return {source_, begin, begin + static_cast<std::uint32_t>(text.size())};
  }

  Validation validation() const { return {result, sources, registry, folders, exit_code, fail_on}; }

  rules::ValidateResult result;
  Sources sources;
  rules::Registry registry;
  ProjectFolders folders;
  int exit_code = 0;
  std::function<Severity(const std::string& path)> fail_on;

 private:
  SourceId source_ = kNoSource;
};

}  // namespace rigor::report
