// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/checked_text.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include <rigor/author/patched_text.h>
#include <rigor/text/path.h>
#include <rigor/xml/document.h>

namespace rigor::author {
namespace {

using rules::Category;

/// What a finding is known by; the more of it is left out, the more findings
/// are taken for the same.
struct Likeness {
  std::string_view rule;
  Severity severity;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::string_view subject = {};
  std::string_view message = {};

  bool operator<(const Likeness& other) const {
    const auto all = [](const Likeness& of) {
      return std::tie(of.rule, of.severity, of.begin, of.end, of.subject, of.message);
    };
    return all(*this) < all(other);
  }
};

enum class By : std::uint8_t { kPlaceAndMessage, kPlace, kMessage };

/// Pairs the findings before with those after, each once.
class Pairing {
 public:
  Pairing(const CheckedText& before, const CheckedText& after, const std::vector<Edit>& edits)
      : before_(before), after_(after), places_(edits) {
    change_.gone.assign(before.findings().size(), true);
    is_new_.assign(after.findings().size(), true);
  }

  FindingsChange run() {
    for (const By by : {By::kPlaceAndMessage, By::kPlace, By::kMessage}) pair(by);
    for (std::size_t i = 0; i < is_new_.size(); ++i) {
      const Diagnostic& finding = after_.findings()[i];
      if (!is_new_[i] || finding.severity == Severity::kInfo) continue;
      if (before_.all_listed(finding)) change_.fresh.push_back(i);
    }
    change_.brings = change_.fresh.empty() ? grown() : worst_fresh();
    return std::move(change_);
  }

 private:
  std::optional<Likeness> likeness(const CheckedText& of, const Diagnostic& finding, By by) const {
    Likeness like{finding.rule, finding.severity};
    if (by != By::kMessage) {
      if (!of.own(finding.where)) return std::nullopt;
      const Span where = &of == &after_ ? places_.of(finding.where) : finding.where;
      like.begin = where.begin;
      like.end = where.end;
    } else if (!before_.all_listed(finding)) {
      return std::nullopt;  // many say the same, and stand elsewhere
    } else {
      like.subject = finding.subject;
    }
    if (by != By::kPlace) like.message = finding.message;
    return like;
  }

  void pair(By by) {
    std::map<Likeness, std::vector<std::size_t>> open;  // the first is the last
    for (std::size_t i = change_.gone.size(); i-- > 0;) {
      if (!change_.gone[i]) continue;
      if (const auto like = likeness(before_, before_.findings()[i], by)) open[*like].push_back(i);
    }
    for (std::size_t i = 0; i < is_new_.size(); ++i) {
      if (!is_new_[i]) continue;
      const auto like = likeness(after_, after_.findings()[i], by);
      const auto found = like ? open.find(*like) : open.end();
      if (found == open.end() || found->second.empty()) continue;
      change_.gone[found->second.back()] = false;
      found->second.pop_back();
      is_new_[i] = false;
    }
  }

  BroughtFinding worst_fresh() const {
    BroughtFinding worst{after_.findings()[change_.fresh.front()].rule, Severity::kWarning};
    for (const std::size_t fresh : change_.fresh) {
      const Diagnostic& finding = after_.findings()[fresh];
      if (finding.severity < worst.severity) worst = {finding.rule, finding.severity};
    }
    return worst;
  }

  /// A rule that has more findings than before, if they are no mere infos.
  std::optional<BroughtFinding> grown() const {
    std::optional<BroughtFinding> worst;
    std::map<std::pair<std::string_view, Severity>, std::size_t> counts;
    for (const Diagnostic& finding : before_.findings()) {
      counts[{finding.rule, finding.severity}] += finding.count;
    }
    for (const Diagnostic& finding : after_.findings()) {
      if (finding.severity == Severity::kInfo) continue;
      std::size_t& left = counts[{finding.rule, finding.severity}];
      if (left < finding.count && (!worst || finding.severity < worst->severity)) {
        worst = {finding.rule, finding.severity};
      }
      left -= std::min(left, finding.count);
    }
    return worst;
  }

  const CheckedText& before_;
  const CheckedText& after_;
  PlacesBefore places_;
  FindingsChange change_;
  std::vector<bool> is_new_;
};

}  // namespace

CheckedText::CheckedText(const Environment& environment, const rules::ValidateOptions& options,
                         std::string path, std::string bytes, std::vector<std::string> robots)
    : path_(std::move(path)),
      working_folder_(environment.resolver.paths().templates.working_folder),
      bytes_(std::move(bytes)) {
  rules::ValidateOptions check = options;
  check.shard = {};
  if (robots.empty()) {
    check.buffer = {path_, bytes_};
  } else {
    check.included.push_back({path_, bytes_});
  }
  check.paths = std::move(robots);
  result_ = rules::validate(environment, check, sources_);
  for (const Diagnostic& finding : findings()) {
    count_ += finding.count;
    if (finding.severity == Severity::kError) errors_ += finding.count;
    if (finding.severity == Severity::kInfo) infos_ += finding.count;
    if (finding.count > 1) counted_.push_back(finding.rule);
  }
  const xml::Document document = xml::parse(bytes_, kNoSource);
  for (const xml::Fault& fault : document.faults()) {
    if (is_fatal(fault.kind)) cut_ = fault.where;
    xml_faults_ += fault.count;
    if (fault.count <= max_kept(fault.kind)) continue;
    count_ += fault.count - max_kept(fault.kind);
    counted_.push_back(to_string(Category::kXml));
  }
}

bool CheckedText::own(Span span) const {
  if (span.nowhere()) return false;
  const std::string_view path = sources_.path(span.source);
  return path == path_ || join_path(working_folder_, path) == join_path(working_folder_, path_);
}

bool CheckedText::all_listed(const Diagnostic& finding) const {
  return std::none_of(counted_.begin(), counted_.end(), [&finding](std::string_view name) {
    return name == finding.rule || name == finding.category;
  });
}

FindingsChange compare(const CheckedText& before, const CheckedText& after,
                       const std::vector<Edit>& edits) {
  return Pairing(before, after, edits).run();
}

}  // namespace rigor::author
