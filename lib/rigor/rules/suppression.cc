// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/suppression.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include <rigor/rules/registry.h>
#include <rigor/rules/runner.h>
#include <rigor/rules/suppression/suppression_comment.h>
#include <rigor/schema/suggest.h>
#include <rigor/text/byte_order_mark.h>
#include <rigor/xml/style.h>

namespace rigor::rules {
namespace {

constexpr std::size_t kNoCover = static_cast<std::size_t>(-1);

/// Unknown names of a file that come with others that may be meant: each is compared with all rules, and
/// more of them need no help with their spelling.
constexpr std::size_t kMaxSuppressionsSuggested = 100;

bool ends_line(char c) { return c == '\n' || c == '\r'; }
bool is_blank(char c) { return xml::kBlanks.find(c) != std::string_view::npos; }

bool covers_place(Span outer, Span inner) {
  return outer.source == inner.source && outer.begin <= inner.begin && inner.begin <= outer.end;
}

Edit removal_of(Span span) { return {span, ""}; }

/// Whether a run of `validate` finds all there is to find of a rule, so that what is not found is not
/// there. Of what becomes of a model in a conversion or a simulation it knows nothing, and a mesh that is
/// only drawn is examined more closely by `mesh-check`.
enum class Seen : std::uint8_t { kAll, kUnlessMeshesAreInDoubt, kNotAll };

Seen seen_by_validate(const Rule& rule, MeshPolicy meshes) {
  if (rule.category == Category::kConvert || rule.category == Category::kSimulate) {
    return Seen::kNotAll;
  }
  const bool of_files = std::any_of(rule.checks.begin(), rule.checks.end(), [](const Check& check) {
    return std::holds_alternative<CheckOf<MeshFile>>(check);
  });
  if (of_files) return Seen::kNotAll;
  // These ask what meshes enclose, which cannot be reported of one that is not opened or cannot be read.
  if (!needs_meshes(rule)) return Seen::kAll;
  return meshes == MeshPolicy::kOpen ? Seen::kUnlessMeshesAreInDoubt : Seen::kNotAll;
}

}  // namespace

/// Walks the tokens once, and gives each comment to the element that follows it.
class Suppressions::Reader {
 public:
  Reader(const xml::Document& document, Suppressions& into) : document_(document), into_(into) {}

  void read() {
    const std::vector<xml::Token>& tokens = document_.tokens();
    for (const xml::Token& token : tokens) {
      switch (token.kind) {
        case xml::TokenKind::kStartTag:
        case xml::TokenKind::kEmptyTag: begin_element(token); break;
        case xml::TokenKind::kEndTag: end_element(); break;
        case xml::TokenKind::kComment: take(token); break;
        case xml::TokenKind::kCData: in_text_ = true; break;
        case xml::TokenKind::kText: in_text_ = in_text_ || !is_white(token); break;
        default: break;
      }
    }
    if (document_.complete()) leave_without_element();
  }

 private:
  struct Waiting {
    SuppressionForm form;
    std::size_t comment;
    Span where;
  };

  bool is_white(const xml::Token& token) const {
    const std::string_view text = document_.bytes().substr(token.begin, token.end - token.begin);
    return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
  }

  void take(const xml::Token& token) {
    std::optional<SuppressionComment> read = read_suppression(document_, token);
    if (!read) return;
    SuppressionFacts& faults = into_.faults_;
    faults.insert(faults.end(), read->faults.begin(), read->faults.end());
    if (read->names.empty()) return;
    const bool late = read->form == SuppressionForm::kFileIgnore && elements_ > 0;
    if (late) {
      faults.push_back({SuppressionFactKind::kMisplaced, read->word, "file-ignore", {}});
      return;
    }
    Comment comment{into_.names_.size(), 0, whole(token)};
    for (const Span name : read->names) {
      into_.names_.push_back(
          {std::string(current_name(document_.bytes().substr(name.begin, name.size()))), name});
    }
    comment.end_name = into_.names_.size();
    const std::size_t index = into_.comments_.size();
    into_.comments_.push_back(comment);
    if (read->form == SuppressionForm::kFileIgnore) {
      for (std::size_t i = comment.first_name; i < comment.end_name; ++i) {
        into_.for_file_.emplace(into_.names_[i].name, i);
      }
    } else {
      const Span where{document_.source(), token.begin, token.end};
      waiting_.push_back({read->form, index, where});
    }
  }

  /// The comment, with its lines when nothing else stands on them. Never out of the middle of a text,
  /// which would be joined to another.
  Span whole(const xml::Token& token) {
    const std::string_view bytes = document_.bytes();
    const std::size_t next = bytes.find_first_not_of(" \t\r\n", token.end);
    const bool before_text = next != std::string_view::npos && bytes[next] != '<';
    if (in_text_ || before_text || !document_.complete()) return {};
    const auto start =
        static_cast<std::uint32_t>(bytes.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
    std::uint32_t begin = token.begin;
    std::uint32_t end = token.end;
    while (begin > start && is_blank(bytes[begin - 1])) --begin;
    while (end < bytes.size() && is_blank(bytes[end])) ++end;
    const bool first = begin == start || ends_line(bytes[begin - 1]);
    const bool last = end == bytes.size() || ends_line(bytes[end]);
    if (first && last) {
      if (end < bytes.size()) end += bytes.substr(end).starts_with("\r\n") ? 2 : 1;
    } else if (first) {
      begin = token.begin;  // what follows keeps the indentation
    } else if (!last) {
      begin = token.begin;
      end = token.end;
    }
    begin = std::max(begin, removed_);  // of two on one line
    removed_ = end;
    return {document_.source(), begin, end};
  }

  void begin_element(const xml::Token& token) {
    in_text_ = false;
    const xml::Element element = document_.element(elements_++);
    for (std::size_t i = first_waiting(); i < waiting_.size(); ++i) {
      const bool tag = waiting_[i].form == SuppressionForm::kIgnoreNext;
      cover(into_.comments_[waiting_[i].comment], tag ? element.tag_span() : element.span());
    }
    waiting_.resize(first_waiting());
    if (token.kind == xml::TokenKind::kStartTag) open_.push_back(waiting_.size());
  }

  void cover(const Comment& comment, Span span) {
    for (std::size_t i = comment.first_name; i < comment.end_name; ++i) {
      Covers& covers = into_.covers_[into_.names_[i].name];
      std::size_t outer = covers.empty() ? kNoCover : covers.size() - 1;
      while (outer != kNoCover && covers[outer].end <= span.begin) outer = covers[outer].outer;
      // Said twice of one element: the second is in vain, even when its span is the smaller one.
      if (outer != kNoCover && covers[outer].begin == span.begin) {
        if (covers[outer].end >= span.end) continue;
        covers[outer].end = span.end;
        covers[outer].name = i;
        continue;
      }
      covers.push_back({span.begin, span.end, outer, i});
    }
  }

  void end_element() {
    in_text_ = false;
    leave_without_element();
    if (!open_.empty()) open_.pop_back();
  }

  void leave_without_element() {
    for (std::size_t i = first_waiting(); i < waiting_.size(); ++i) {
      const Comment& comment = into_.comments_[waiting_[i].comment];
      SuppressionFact fact{SuppressionFactKind::kNoElement, waiting_[i].where, "", {}};
      if (!comment.whole.nowhere()) fact.edits.push_back(removal_of(comment.whole));
      into_.faults_.push_back(std::move(fact));
      into_.comments_[waiting_[i].comment].end_name = comment.first_name;  // no more to say of it
    }
    waiting_.resize(first_waiting());
  }

  std::size_t first_waiting() const { return open_.empty() ? 0 : open_.back(); }

  const xml::Document& document_;
  Suppressions& into_;
  std::vector<Waiting> waiting_;   // for an element, those of the innermost level last
  std::vector<std::size_t> open_;  // of each open element, the first that waits in it
  std::uint32_t elements_ = 0;
  std::uint32_t removed_ = 0;  // where the last comment ends, with its line
  bool in_text_ = false;       // characters stand since the last tag
};

Suppressions::Suppressions(const xml::Document& document)
    : source_(document.source()), complete_(document.complete()) {
  if (const auto root = document.root()) root_ = root->span();
  if (!complete_) {
    for (const xml::Fault& fault : document.faults()) {
      // The one that is not fatal and lets tinyxml2 refuse the file.
      const bool refused = fault.kind == xml::FaultKind::kDeclarationNotFirst;
      if (refused || xml::is_fatal(fault.kind)) fatal_.push_back(fault.where);
    }
  }
  // Most files have no such comment; walking all their tokens took a twentieth of all checks.
  const auto has_mark = [&document](const xml::Token& token) {
    if (token.kind != xml::TokenKind::kComment) return false;
    const std::string_view text = document.bytes().substr(token.begin, token.end - token.begin);
    return text.find(kSuppressionMark) != std::string_view::npos;
  };
  const std::vector<xml::Token>& tokens = document.tokens();
  if (std::any_of(tokens.begin(), tokens.end(), has_mark)) Reader(document, *this).read();
}

Diagnostics Suppressions::uncovered(Diagnostics found) {
  for (const Diagnostic& diagnostic : found.list()) {
    meshes_in_doubt_ = meshes_in_doubt_ || diagnostic.category == to_string(Category::kMesh);
  }
  if (names_.empty()) return found;
  Diagnostics left;
  for (const Diagnostic& diagnostic : found.list()) {
    if (!covers(diagnostic)) left.add(diagnostic);
  }
  return left;
}

void Suppressions::use(std::string_view name) {
  for (Named& each : names_) each.used = each.used || each.name == name;
}

void Suppressions::take_uses(const Suppressions& other) {
  for (std::size_t i = 0; i < std::min(names_.size(), other.names_.size()); ++i)
    names_[i].used = names_[i].used || other.names_[i].used;
  meshes_in_doubt_ = meshes_in_doubt_ || other.meshes_in_doubt_;
}

bool Suppressions::covers(const Diagnostic& diagnostic) {
  if (ended_reading(diagnostic)) return false;
  const bool by_rule = covers(diagnostic.rule, diagnostic);
  const bool by_category = covers(diagnostic.category, diagnostic);
  return by_rule || by_category;
}

bool Suppressions::ended_reading(const Diagnostic& diagnostic) const {
  return diagnostic.category == to_string(Category::kXml) &&
         std::any_of(fatal_.begin(), fatal_.end(),
                     [&](Span fault) { return covers_place(fault, diagnostic.where); });
}

/// Marks all that cover it: each of them would hide it alone.
bool Suppressions::covers(std::string_view name, const Diagnostic& diagnostic) {
  const std::string key(name);
  bool covered = false;
  if (const auto file = for_file_.find(key); file != for_file_.end()) {
    names_[file->second].used = covered = true;
  }
  const auto known = covers_.find(key);
  if (known == covers_.end() || diagnostic.where.source != source_) return covered;
  const Covers& all = known->second;
  // A value that is not there stands behind the tag that it belongs to.
  const bool empty = diagnostic.where.size() == 0 && diagnostic.where.begin > 0;
  const std::uint32_t place = diagnostic.where.begin - (empty ? 1 : 0);
  const auto behind = std::upper_bound(
      all.begin(), all.end(), place,
      [](std::uint32_t wanted, const Cover& cover) { return wanted < cover.begin; });
  std::size_t at = static_cast<std::size_t>(behind - all.begin()) - 1;  // of the first: kNoCover
  for (; at != kNoCover; at = all[at].outer) {
    ++comparisons_;
    if (all[at].end <= place) continue;
    const bool everywhere = all[at].begin <= root_.begin && root_.end <= all[at].end;
    if (diagnostic.count > 1 && !everywhere) continue;
    names_[all[at].name].used = covered = true;
  }
  return covered;
}

SuppressionFacts Suppressions::facts(const Registry& registry, const Runner& runner,
                                     MeshPolicy meshes) const {
  if (comments_.empty()) return faults_;
  // Whether it can be reported of a rule or of a category that it was suppressed in vain.
  std::map<std::string_view, bool> tells;
  for (const Rule& rule : registry.rules()) {
    const Seen seen = seen_by_validate(rule, meshes);
    const bool all =
        seen == Seen::kAll || (seen == Seen::kUnlessMeshesAreInDoubt && !meshes_in_doubt_);
    const bool tell = complete_ && all && runner.runs(rule.name);
    tells.emplace(rule.name, tell);
    // No author covers a whole category for the sake of a consumer that is not asked for.
    if (!rule.targets.empty() && !runner.runs(rule.name)) continue;
    const auto [category, is_new] = tells.emplace(to_string(rule.category), tell);
    category->second = category->second && tell;
  }
  std::vector<std::string_view> all_names;
  for (const auto& [name, tell] : tells) all_names.push_back(name);
  SuppressionFacts facts = faults_;
  std::size_t unknown = 0;
  std::vector<bool> unused(names_.size());
  for (const Comment& comment : comments_) {
    for (std::size_t i = comment.first_name; i < comment.end_name; ++i) {
      const auto known = tells.find(names_[i].name);
      if (known == tells.end()) {
        facts.push_back({SuppressionFactKind::kUnknownRule, names_[i].where, names_[i].name, {}});
        if (++unknown > kMaxSuppressionsSuggested) continue;
        for (const std::string_view near : schema::near(names_[i].name, all_names)) {
          facts.back().near.emplace_back(near);
        }
      } else {
        unused[i] = known->second && !names_[i].used;
      }
    }
    tell_unused(comment, unused, facts);
  }
  return facts;
}

/// A name goes with the comma before it or behind it, so that any choice of them can be removed together;
/// the last goes with the comment.
void Suppressions::tell_unused(const Comment& comment, const std::vector<bool>& unused,
                               SuppressionFacts& facts) const {
  std::size_t last_kept = comment.end_name;
  while (last_kept > comment.first_name && unused[last_kept - 1]) --last_kept;
  for (std::size_t i = comment.first_name; i < comment.end_name; ++i) {
    if (!unused[i]) continue;
    SuppressionFact fact{SuppressionFactKind::kUnused, names_[i].where, names_[i].name, {}};
    Span span = names_[i].where;
    if (last_kept == comment.first_name) {
      span = comment.whole;
    } else if (i < last_kept) {
      span.end = names_[i + 1].where.begin;
    } else {
      span.begin = names_[i - 1].where.end;
    }
    if (complete_ && !span.nowhere()) fact.edits.push_back(removal_of(span));
    facts.push_back(std::move(fact));
  }
}

}  // namespace rigor::rules
