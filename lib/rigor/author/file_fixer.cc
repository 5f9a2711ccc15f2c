// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/file_fixer.h>

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>

#include <rigor/rules/rule.h>

namespace rigor::author {
namespace {

/// Whether each edit says what stands there already.
bool changes_nothing(const std::vector<Edit>& edits, std::string_view bytes) {
  return std::all_of(edits.begin(), edits.end(), [bytes](const Edit& edit) {
    return bytes.substr(edit.span.begin, edit.span.size()) == edit.text;
  });
}

HeldBackFix held_back_fix(const Diagnostic& finding, HeldBack why) {
  return {finding.rule, finding.subject, finding.fixes.front().title, why};
}

}  // namespace

FileFixer::FileFixer(const Environment& environment, const rules::ValidateOptions& options,
                     File file, Applicability most)
    : environment_(environment),
      options_(options),
      max_(most),
      robots_(std::move(file.robots)),
      patched_(std::move(file.bytes)) {
  fixed_.path = std::move(file.path);
  state_ = checked(patched_.original());
}

FixedFile FileFixer::run(SourceId source) {
  for (int pass = 0; pass < kMaxFixPasses; ++pass) {
    const Candidates candidates = find_candidates();
    if (candidates.empty() || !advance(candidates)) return finished(source);
  }
  fixed_.settled = find_candidates().empty();
  return finished(source);
}

std::unique_ptr<CheckedText> FileFixer::checked(std::string bytes) const {
  return std::make_unique<CheckedText>(environment_, options_, fixed_.path, std::move(bytes),
                                       robots_);
}

/// In the order of their findings; those that are the same are one.
FileFixer::Candidates FileFixer::find_candidates() const {
  using Key = std::vector<std::tuple<std::uint32_t, std::uint32_t, std::string_view>>;
  Candidates candidates;
  std::map<Key, std::size_t> known;
  for (std::size_t i = 0; i < state_->findings().size(); ++i) {
    const Diagnostic& finding = state_->findings()[i];
    if (!may_fix(*state_, finding)) continue;
    const std::vector<Edit>& edits = finding.fixes.front().edits;
    Key key;
    for (const Edit& edit : edits) key.emplace_back(edit.span.begin, edit.span.end, edit.text);
    const auto [entry, is_new] = known.try_emplace(std::move(key), candidates.size());
    if (is_new) candidates.push_back({edits, {}});
    candidates[entry->second].findings.push_back(i);
  }
  return candidates;
}

bool FileFixer::may_fix(const CheckedText& text, const Diagnostic& finding) const {
  if (!has_fix(finding, max_)) return false;
  const std::vector<Edit>& edits = finding.fixes.front().edits;
  const auto inside = [&text](const Edit& edit) {
    return text.own(edit.span) && edit.span.begin <= edit.span.end &&
           edit.span.end <= text.bytes().size();
  };
  if (!std::all_of(edits.begin(), edits.end(), inside)) return false;
  if (changes_nothing(edits, text.bytes())) return false;
  const auto& cut = text.cut();
  return !cut || (finding.category == to_string(rules::Category::kXml) &&
                  finding.where.begin == cut->begin && finding.where.end == cut->end);
}

/// Does what helps of the candidates, as many as can be done together: all at
/// once, or what is left when those that do harm are found by halving. False
/// when nothing was done.
bool FileFixer::advance(const Candidates& candidates) {
  fixed_.held_back.clear();
  Indices accepted;
  std::optional<Trial> best;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, candidates.size()}};
  while (!open.empty()) {
    const auto [begin, end] = open.back();
    open.pop_back();
    Indices tried = accepted;
    const EditSet edits = joined(candidates, tried, begin, end);
    if (tried.size() == accepted.size()) continue;  // they wait for the next pass
    Trial trial = attempt(candidates, tried, edits);
    if (!trial.refused) {
      accepted = std::move(tried);
      best = std::move(trial);
    } else if (end - begin == 1 || trial.refused == HeldBack::kNotTried) {
      for (std::size_t i = begin; i < end; ++i) hold_back(candidates[i], trial);
    } else {
      const std::size_t middle = begin + (end - begin) / 2;
      open.emplace_back(middle, end);
      open.emplace_back(begin, middle);
    }
  }
  if (!best) return false;
  keep(candidates, accepted, std::move(*best));
  return true;
}

/// The edits of those in `tried`, and of those of the range that can be done
/// with them, which are added.
EditSet FileFixer::joined(const Candidates& candidates, Indices& tried, std::size_t begin,
                          std::size_t end) {
  EditSet edits;
  for (const std::size_t i : tried) edits.take(candidates[i].edits);
  for (std::size_t i = begin; i < end; ++i) {
    if (edits.take(candidates[i].edits)) tried.push_back(i);
  }
  return edits;
}

FileFixer::Trial FileFixer::attempt(const Candidates& candidates, const Indices& tried,
                                    const EditSet& edits) {
  Trial trial{PatchedText(state_->bytes()), nullptr};
  trial.refused = HeldBack::kDoesNotHelp;
  if (!trial.patched.apply(edits.list())) return trial;
  for (int step = 0; step < kMaxFixPasses; ++step) {
    if (trials_ == kMaxFixTrials) {
      fixed_.settled = false;
      trial.refused = HeldBack::kNotTried;
      return trial;
    }
    ++trials_;
    trial.after = checked(trial.patched.text());
    trial.change = compare(*state_, *trial.after, trial.patched.edits(kNoSource));
    trial.refused = state_->cut() ? refused_of_cut(trial) : refused(candidates, tried, trial);
    if (!trial.refused || state_->cut() || !fix_uncovered(trial)) break;
  }
  return trial;
}

/// When all that is found and was not before has fixes, does them: a renamed
/// element may hold others that have to be renamed, and that nobody examined.
/// False when nothing was done.
bool FileFixer::fix_uncovered(Trial& trial) const {
  EditSet edits;
  for (const std::size_t fresh : trial.change.fresh) {
    const Diagnostic& finding = trial.after->findings()[fresh];
    if (!may_fix(*trial.after, finding)) return false;
    if (edits.take(finding.fixes.front().edits)) ++trial.uncovered[finding.rule];
  }
  return !trial.change.fresh.empty() && trial.patched.apply(edits.list());
}

std::optional<HeldBack> FileFixer::refused(const Candidates& candidates, const Indices& tried,
                                           const Trial& trial) const {
  const CheckedText& after = *trial.after;
  if (after.cut() || after.xml_faults() > state_->xml_faults()) return HeldBack::kNotXml;
  const auto helps = [&](std::size_t i) {
    const Indices& findings = candidates[i].findings;
    return std::any_of(findings.begin(), findings.end(), [&](std::size_t finding) {
      // Behind an error nobody looked for what is less than one.
      const bool worth = !trial.change.brings ||
                         state_->findings()[finding].severity < trial.change.brings->severity;
      return trial.change.gone[finding] && worth;
    });
  };
  const bool all_help = std::all_of(tried.begin(), tried.end(), helps);
  if (!all_help && trial.change.brings) return HeldBack::kBringsFinding;
  if (!all_help || after.count() >= state_->count()) return HeldBack::kDoesNotHelp;
  return std::nullopt;
}

/// Of a file that ends to be XML: what is behind that place was never looked
/// at.
std::optional<HeldBack> FileFixer::refused_of_cut(const Trial& trial) const {
  const auto& cut = trial.after->cut();
  if (!cut) return std::nullopt;
  const PlacesBefore places(trial.patched.edits(kNoSource));
  const bool later = places.of(*cut).begin > state_->cut()->begin;
  return later ? std::nullopt : std::optional(HeldBack::kDoesNotHelp);
}

void FileFixer::keep(const Candidates& candidates, const Indices& accepted, Trial trial) {
  for (const std::size_t i : accepted) {
    for (const std::size_t finding : candidates[i].findings) {
      // Where a file is cut now, it may say the same as where it was.
      if (!trial.change.gone[finding] && !state_->cut()) continue;
      const Diagnostic& done = state_->findings()[finding];
      ++fixed_.applied[done.rule];
      if (state_->cut()) of_cut_ = held_back_fix(done, HeldBack::kNotXml);
    }
  }
  for (const auto& [rule, count] : trial.uncovered) fixed_.applied[rule] += count;
  patched_.apply(trial.patched.edits(kNoSource));
  state_ = std::move(trial.after);
}

void FileFixer::hold_back(const Candidate& candidate, const Trial& trial) {
  const Diagnostic& finding = state_->findings()[candidate.findings.front()];
  fixed_.held_back.push_back(held_back_fix(finding, *trial.refused));
  if (trial.refused == HeldBack::kBringsFinding) {
    fixed_.held_back.back().brings = trial.change.brings->rule;
  }
}

FixedFile FileFixer::finished(SourceId source) {
  fixed_.before = patched_.original();
  if (state_->cut()) {  // still, so nothing that was done made it XML
    fixed_.after = patched_.original();
    fixed_.applied.clear();
    if (of_cut_) fixed_.held_back.push_back(std::move(*of_cut_));
  } else {
    fixed_.after = patched_.text();
    fixed_.edits = patched_.edits(source);
  }
  return std::move(fixed_);
}

}  // namespace rigor::author
