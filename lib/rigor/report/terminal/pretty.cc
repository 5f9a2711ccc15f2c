// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/terminal/pretty.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <rigor/report/places.h>
#include <rigor/report/terminal/excerpt.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/validation.h>

namespace rigor::report {
namespace {

/// Characters of a message shown at most: a value quoted in it may be as long as the file. The
/// other formats give all of it.
constexpr std::size_t kMaxMessage = 1000;

/// Marks of one source.
using Group = std::vector<Mark>;

void add_mark(std::vector<Group>& groups, Mark mark) {
  const auto same_source = [&mark](const Group& group) {
    return group.front().where.source == mark.where.source;
  };
  const auto group = std::find_if(groups.begin(), groups.end(), same_source);
  if (group == groups.end()) {
    groups.push_back({std::move(mark)});
  } else {
    group->push_back(std::move(mark));
  }
}

/// The finding's own source first, then those of its labels.
std::vector<Group> groups_of(const Diagnostic& diagnostic) {
  std::vector<Group> groups;
  if (!diagnostic.where.nowhere()) add_mark(groups, {diagnostic.where, '^', {}});
  for (const Label& label : diagnostic.related) {
    if (!label.where.nowhere()) add_mark(groups, {label.where, '-', label.message});
  }
  return groups;
}

std::string fix_line(const Fix& fix) {
  switch (fix.applicability) {
    case Applicability::kSafe: return "safe fix: " + fix.title;
    case Applicability::kUnsafe: return "unsafe fix: " + fix.title;
    case Applicability::kManual: break;
  }
  return "possible fix, for you to decide: " + fix.title;
}

/// Whether what the rule's page says is shown where the finding says nothing of its own.
enum class Page : std::uint8_t { kHidden, kShown };

class Block {
 public:
  Block(const Diagnostic& diagnostic, Places& places, Color color, Page page)
      : diagnostic_(diagnostic),
        places_(places),
        color_(color),
        page_(page),
        groups_(groups_of(diagnostic)) {
    for (const Group& group : groups_) gutter_ = std::max(gutter_, gutter_width(group, places));
  }

  std::string text() {
    headline();
    draw();
    for (const std::string& note : notes()) {
      out_ += std::string(gutter_ + 1, ' ') + framed("=") + ' ' + note + '\n';
    }
    return std::move(out_) + '\n';
  }

  FindingDetails details() {
    draw();
    return {std::move(out_), notes()};
  }

 private:
  std::string framed(std::string_view text) const { return paint(text, Paint::kFrame, color_); }

  void headline() {
    const std::string kind =
        fmt::format("{}[{}]", to_string(diagnostic_.severity), diagnostic_.rule);
    out_ += paint(kind, paint_of(diagnostic_.severity), color_) +
            paint(": " + printable(diagnostic_.message, kMaxMessage), Paint::kStrong, color_) +
            '\n';
  }

  void place(std::string_view arrow, std::string_view path, std::string_view position) {
    out_ += std::string(gutter_, ' ') + framed(arrow) + ' ' + printable(path);
    out_ += position;
    out_ += '\n';
  }

  void draw() {
    if (diagnostic_.where.nowhere()) place("-->", places_.path(diagnostic_), {});
    for (const Group& group : groups_) draw(group);
  }

  void draw(const Group& group) {
    const Span first = group.front().where;
    const Position begin = places_.begin(first);
    const bool own = first.source == diagnostic_.where.source;
    place(own ? "-->" : ":::", places_.path(first),
          fmt::format(":{}:{}", begin.line, begin.column));
    const Paint role = own ? paint_of(diagnostic_.severity) : Paint::kFrame;
    out_ += excerpt(group, places_, {gutter_, color_, role});
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    const auto note = [&notes](std::string_view text) {
      notes.push_back(printable(text, kMaxMessage));
    };
    if (!diagnostic_.subject.empty()) note("in: " + diagnostic_.subject);
    for (const std::string& line : origin_lines(diagnostic_, places_)) note(line);
    if (const std::string others = other_places(diagnostic_, places_); !others.empty()) {
      note("and " + others);
    }
    for (const Label& label : diagnostic_.related) {
      if (label.where.nowhere()) note("note: " + label.message);
    }
    const bool page = page_ == Page::kShown;
    const std::string_view why = page ? why_of(diagnostic_) : diagnostic_.why;
    if (!why.empty()) note("why: " + std::string(why));
    const bool page_help = page && diagnostic_.fixes.empty();
    const std::string_view help = page_help ? help_of(diagnostic_) : diagnostic_.help;
    if (!help.empty()) note("help: " + std::string(help));
    if (!diagnostic_.fixes.empty()) note(fix_line(diagnostic_.fixes.front()));
    return notes;
  }

  const Diagnostic& diagnostic_;
  Places& places_;
  Color color_;
  Page page_;
  std::vector<Group> groups_;
  std::size_t gutter_ = 1;
  std::string out_;
};

}  // namespace

std::string pretty(const Diagnostics& diagnostics, const Sources& sources, Color color) {
  Places places(sources);
  std::string out;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    out += Block(diagnostic, places, color, Page::kHidden).text();
  }
  return out;
}

std::string pretty_with_reasons(const Diagnostics& diagnostics, const Sources& sources,
                                Color color) {
  Places places(sources);
  std::set<std::string_view> reported;
  std::string out;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    const bool first = reported.insert(diagnostic.rule).second;
    out += Block(diagnostic, places, color, first ? Page::kShown : Page::kHidden).text();
  }
  return out;
}

FindingDetails finding_details(const Diagnostic& diagnostic, Places& places) {
  return Block(diagnostic, places, Color::kPlain, Page::kHidden).details();
}

}  // namespace rigor::report
