// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/project/part_check.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <rigor/read/template/template_expander.h>

namespace rigor::lsp {
namespace {

/// Of several changes all that is between them counts as replaced, and what was found there is not known any more.
constexpr std::uint32_t kMaxReplacedBytes = 2048;

/// Of a check, its own document: what is read first.
constexpr SourceId kOwn{0};

bool is_own(Span span) { return span.source == kOwn; }

/// Rules of these categories mostly look at an element and what is in it.
bool looks_at_a_part(const Diagnostic& finding) {
  static constexpr std::array<std::string_view, 7> kCategories{
      "xml", "schema", "inertia", "geometry", "physics", "sensor", "plugin"};
  return std::find(kCategories.begin(), kCategories.end(), finding.category) != kCategories.end();
}

/// What is found in a text that is not well-formed: nothing is said of what it may lack.
bool is_found_in_broken(const Diagnostic& finding) {
  return finding.category == "xml" || finding.category == "schema";
}

/// What is found in a template without the model that it makes.
bool is_of_expansion(const Diagnostic& finding) {
  return finding.category == "xml" || finding.category == "xacro";
}

/// Gives every place of a finding to `move`, which returns where it is now, or nothing: then the finding is of no
/// use when it is its own, and goes without it when it is another. False when it is of no use.
template <class Move>
bool move_places(Diagnostic& finding, const Move& move) {
  const auto kept = [&move](Span& span) {
    if (span.nowhere()) return true;
    const std::optional<Span> moved = move(span);
    if (moved) span = *moved;
    return moved.has_value();
  };
  if (!kept(finding.where)) return false;
  std::erase_if(finding.related, [&](Label& label) { return !kept(label.where); });
  std::erase_if(finding.origin, [&](MacroCall& call) { return !kept(call.where); });
  std::erase_if(finding.fixes, [&](Fix& fix) {
    return !std::all_of(fix.edits.begin(), fix.edits.end(),
                        [&](Edit& edit) { return kept(edit.span); });
  });
  std::erase_if(finding.others, [&](Diagnostic& other) { return !move_places(other, move); });
  return true;
}

/// Files of one check as those of another.
class OtherSources {
 public:
  OtherSources(const Sources& from, Sources& to) : from_(from), to_(to) {}

  Span moved(Span span) {
    const auto known = ids_.find(span.source);
    const SourceId id =
        known != ids_.end()
            ? known->second
            : ids_.emplace(span.source, to_.add(std::string(from_.path(span.source)),
                                                std::string(from_.bytes(span.source))))
                  .first->second;
    return {id, span.begin, span.end};
  }

 private:
  const Sources& from_;
  Sources& to_;
  std::map<SourceId, SourceId> ids_;
};

/// A span of the text before a change; nothing when an end of it is within the change.
std::optional<Span> after(const TextChange& change, Span span) {
  const std::uint32_t removed = change.end - change.begin;
  for (std::uint32_t* offset : {&span.begin, &span.end}) {
    if (*offset >= change.end) {
      *offset = *offset - removed + change.size;
    } else if (*offset > change.begin) {
      return std::nullopt;
    }
  }
  return span;
}

bool touches(const TextChange& change, Span span) {
  return span.begin <= change.end && change.begin <= span.end;
}

using Place = std::tuple<std::string_view, std::uint32_t, std::uint32_t, std::string_view>;

Place place_of(const Diagnostic& finding) {
  return {finding.rule, finding.where.begin, finding.where.end, finding.message};
}

/// Findings in a part that was checked alone, with their places in the document.
std::vector<Diagnostic> in_document(const Excerpt& excerpt, const CheckedDocument& alone,
                                    Sources& sources) {
  OtherSources others(*alone.sources, sources);
  const auto move = [&](Span span) -> std::optional<Span> {
    if (!is_own(span)) return others.moved(span);
    const std::uint32_t begin = excerpt.begin_in_document(span.begin);
    return Span{kOwn, begin, std::max(begin, excerpt.end_in_document(span.end))};
  };
  std::vector<Diagnostic> found;
  for (Diagnostic finding : alone.result.diagnostics.list()) {
    if (!is_own(finding.where) || !move_places(finding, move)) continue;
    if (finding.category == "xml" || excerpt.core_has(finding.where.begin, finding.where.end))
      found.push_back(std::move(finding));
  }
  return found;
}

}  // namespace

PartCheck::PartCheck(std::string path, std::string text)
    : path_(std::move(path)),
      text_(std::make_unique<const std::string>(std::move(text))),
      document_(xml::parse_own(*text_, kOwn)) {}

bool PartCheck::is_worth_it(const std::string& path, const std::string& text,
                            const CheckedDocument& checked, std::size_t large) {
  const bool counts_all = read::is_template(path) && checked.sources;
  return (counts_all ? checked.sources->total_bytes() : text.size()) >= large;
}

std::optional<PartCheck> PartCheck::of(const std::string& path, const std::string& text) {
  PartCheck parts(path, text);
  if (!parts.document_.complete()) return std::nullopt;
  return parts;
}

/// A rule that finds more in the part alone than in the whole, or less, needs the whole.
const PartCheck::Before& PartCheck::before(const Excerpt& excerpt, const EditorDisk& disk,
                                           const Project& project) {
  if (before_ && before_->excerpt == excerpt) return *before_;
  const CheckedDocument alone =
      check_text(disk, project, path_, excerpt.text(*text_), rules::MeshPolicy::kLeaveOut);
  Sources sources;
  const std::vector<Diagnostic> found = in_document(excerpt, alone, sources);
  std::set<Place> in_part;
  for (const Diagnostic& finding : found) in_part.insert(place_of(finding));
  std::set<Place> in_whole;
  for (const Diagnostic& finding : whole_.result.diagnostics.list()) {
    if (is_own(finding.where) && excerpt.core_has(finding.where.begin, finding.where.end))
      in_whole.insert(place_of(finding));
  }
  before_.emplace(Before{excerpt, {}});
  const auto differs = [this](const Place& place) { before_->partial.insert(std::get<0>(place)); };
  for (const Place& place : in_part) {
    if (!in_whole.contains(place)) differs(place);
  }
  for (const Place& place : in_whole) {
    if (!in_part.contains(place)) differs(place);
  }
  return *before_;
}

/// A template that cannot be expanded makes no model.
std::optional<CheckedDocument> PartCheck::check_expansion(const EditorDisk& disk,
                                                          const Project& project,
                                                          const std::string& text,
                                                          const TextChange& change) {
  CheckedDocument checked = lsp::check(disk, project, path_, rules::MeshPolicy::kLeaveOut,
                                       rules::TemplateDepth::kExpansion);
  const auto& found = checked.result.diagnostics.list();
  const bool fails = std::any_of(found.begin(), found.end(), [](const Diagnostic& finding) {
    return is_of_expansion(finding) && finding.severity == Severity::kError;
  });
  if (fails) return checked;
  if (checked.result.files.empty() || checked.sources->bytes(kOwn) != text) return std::nullopt;
  OtherSources others(*whole_.sources, *checked.sources);
  const auto move = [&](Span span) -> std::optional<Span> {
    return is_own(span) ? after(change, span) : others.moved(span);
  };
  for (const Diagnostic& finding : whole_.result.diagnostics.list()) {
    if (is_of_expansion(finding) || (is_own(finding.where) && touches(change, finding.where)))
      continue;
    Diagnostic kept = finding;
    if (move_places(kept, move)) checked.result.diagnostics.add(std::move(kept));
  }
  checked.result.diagnostics.sort();
  checked.result.files = whole_.result.files;
  checked.asked_files.insert(whole_.asked_files.begin(), whole_.asked_files.end());
  return checked;
}

std::optional<CheckedDocument> PartCheck::check(const EditorDisk& disk, const Project& project,
                                                const std::string& text) {
  if (whole_.result.files.size() != 1 || whole_.sources->bytes(kOwn) != *text_) return std::nullopt;
  const TextChange change = difference(*text_, text);
  if (change.end - change.begin > kMaxReplacedBytes) return std::nullopt;
  const bool is_same = change.begin == change.end && change.size == 0;
  if (!is_same && read::is_template(path_)) return check_expansion(disk, project, text, change);
  const std::optional<Excerpt> excerpt =
      is_same ? std::nullopt : Excerpt::around(document_, change);
  if (!is_same && !excerpt) return std::nullopt;
  CheckedDocument checked;
  checked.sources = std::make_unique<Sources>();
  checked.sources->add(std::string(whole_.sources->path(kOwn)), text);
  checked.asked_files = whole_.asked_files;
  checked.result.files = whole_.result.files;
  checked.result.all_files = whole_.result.all_files;
  checked.result.not_looked_at = whole_.result.not_looked_at;
  OtherSources others(*whole_.sources, *checked.sources);
  const auto move = [&](Span span) -> std::optional<Span> {
    return is_own(span) ? after(change, span) : others.moved(span);
  };
  if (is_same) {
    for (Diagnostic finding : whole_.result.diagnostics.list()) {
      move_places(finding, move);
      checked.result.diagnostics.add(std::move(finding));
    }
    return checked;
  }
  const Before& before = this->before(*excerpt, disk, project);
  const Excerpt changed = excerpt->after(change);
  const std::string part = changed.text(text);
  CheckedDocument alone = check_text(disk, project, path_, part, rules::MeshPolicy::kLeaveOut);
  checked.asked_files.merge(alone.asked_files);
  const bool is_whole = xml::parse_own(part, kOwn).complete();
  const auto is_new = [&before](const Diagnostic& finding) {
    return looks_at_a_part(finding) && !before.partial.contains(finding.rule);
  };
  for (const Diagnostic& finding : whole_.result.diagnostics.list()) {
    if (!is_whole && !is_found_in_broken(finding)) continue;
    if (is_own(finding.where)) {
      const bool in_core = excerpt->core_has(finding.where.begin, finding.where.end);
      if (in_core && (is_new(finding) || touches(change, finding.where))) continue;
      if (!is_whole && finding.where.begin > change.begin) continue;
    }
    Diagnostic kept = finding;
    if (move_places(kept, move)) checked.result.diagnostics.add(std::move(kept));
  }
  std::set<Place> around;  // what is wrong with the tags around the part was known
  for (const Diagnostic& finding : checked.result.diagnostics.list()) {
    if (finding.category == "xml") around.insert(place_of(finding));
  }
  std::vector<Diagnostic> found = in_document(changed, alone, *checked.sources);
  std::erase_if(found, [&](const Diagnostic& finding) {
    return !is_new(finding) || around.contains(place_of(finding));
  });
  for (Diagnostic& finding : found) checked.result.diagnostics.add(std::move(finding));
  checked.result.diagnostics.sort();
  return checked;
}

}  // namespace rigor::lsp
