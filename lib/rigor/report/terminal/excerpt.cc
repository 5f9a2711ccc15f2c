// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/terminal/excerpt.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include <fmt/core.h>

#include <rigor/report/terminal/printable.h>

namespace rigor::report {
namespace {

/// Columns of source shown at most: fits beside a gutter on a screen of usual width.
constexpr std::size_t kMaxColumns = 120;
/// Columns kept before the mark when a line is cut.
constexpr std::size_t kColumnsBefore = 40;
/// Bytes examined on either side of a mark's begin; as many columns of four bytes each.
constexpr std::uint32_t kReach = 4 * kMaxColumns;
constexpr std::size_t kTabWidth = 4;

struct Cell {
  std::string shown;
  std::uint32_t offset;  // of the character in the source; all cells of a tab have the same
};

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// The bytes of a line as far as kReach around a position shows them.
struct Stretch {
  std::uint32_t begin;
  std::uint32_t end;
  bool cut_before;
  bool cut_after;
};

Stretch stretch_around(std::string_view bytes, std::uint32_t at) {
  const auto size = static_cast<std::uint32_t>(bytes.size());
  at = std::min(at, size);
  std::uint32_t begin = at;
  while (begin > 0 && at - begin < kReach && !is_line_end(bytes[begin - 1])) --begin;
  const bool cut_before = begin > 0 && !is_line_end(bytes[begin - 1]);
  while (cut_before && begin < at && (static_cast<unsigned char>(bytes[begin]) & 0xC0U) == 0x80U) {
    ++begin;  // not into the middle of a character
  }
  if (begin == 0 && bytes.starts_with("\xEF\xBB\xBF")) begin = 3;
  std::uint32_t end = std::max(at, begin);
  while (end < size && end - at < kReach && !is_line_end(bytes[end])) ++end;
  return {begin, end, cut_before, end < size && !is_line_end(bytes[end])};
}

std::vector<Cell> cells_of(std::string_view bytes, const Stretch& stretch) {
  std::vector<Cell> cells;
  for (std::uint32_t at = stretch.begin; at < stretch.end;) {
    if (bytes[at] == '\t') {
      do cells.push_back({" ", at});
      while (cells.size() % kTabWidth != 0);
      ++at;
      continue;
    }
    Glyph glyph = first_glyph(bytes.substr(at, stretch.end - at));
    cells.push_back({std::move(glyph.shown), at});
    at += glyph.size;
  }
  return cells;
}

std::size_t column_of(const std::vector<Cell>& cells, std::uint32_t offset) {
  const auto reaches = [offset](const Cell& cell) { return cell.offset >= offset; };
  return static_cast<std::size_t>(std::find_if(cells.begin(), cells.end(), reaches) -
                                  cells.begin());
}

/// What is shown of a line.
struct Window {
  std::vector<Cell> cells;  // of the stretch around the first mark
  std::size_t begin = 0;    // those that are shown, half-open
  std::size_t end = 0;
  bool cut_before = false;
  bool cut_after = false;
  std::uint32_t stretch_end = 0;
};

Window window_around(std::string_view bytes, std::uint32_t offset) {
  const Stretch stretch = stretch_around(bytes, offset);
  Window window{cells_of(bytes, stretch)};
  window.stretch_end = stretch.end;
  window.end = window.cells.size();
  window.cut_before = stretch.cut_before;
  window.cut_after = stretch.cut_after;
  if (window.cut_before || window.cut_after || window.end > kMaxColumns) {
    const std::size_t first = column_of(window.cells, offset);
    window.begin = first > kColumnsBefore ? first - kColumnsBefore : 0;
    window.end = std::min(window.cells.size(), window.begin + kMaxColumns);
    window.cut_before = window.cut_before || window.begin > 0;
    window.cut_after = window.cut_after || window.end < window.cells.size();
  }
  return window;
}

/// Whether a mark that begins here can be drawn under the window; it may reach beyond.
bool shows(const Window& window, std::uint32_t offset) {
  if (window.begin == window.end || offset < window.cells[window.begin].offset) return false;
  return !window.cut_after || offset <= window.cells[window.end - 1].offset;
}

std::string window_text(const Window& window) {
  std::string text = window.cut_before ? "…" : "";
  for (std::size_t i = window.begin; i < window.end; ++i) text += window.cells[i].shown;
  if (window.cut_after) text += "…";
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

/// The columns of a span, counted from the window's first; the last one exclusive.
struct Columns {
  std::size_t first;
  std::size_t last;
  bool goes_on;  // the span reaches beyond what is shown
};

Columns columns_of(const Window& window, Span span) {
  const std::size_t first = column_of(window.cells, span.begin);
  const std::size_t last = std::max(first + 1, column_of(window.cells, span.end));
  const std::size_t shown = std::max(first + 1, std::min(last, window.end));
  const std::size_t shift = window.cut_before ? 1 : 0;
  return {first - window.begin + shift, shown - window.begin + shift,
          span.end > window.stretch_end || last > std::max(window.end, first + 1)};
}

class Drawing {
 public:
  Drawing(Places& places, const ExcerptStyle& style) : places_(places), style_(style) { bar(); }

  void draw(const Mark& mark, Paint paint) {
    const std::uint32_t line = places_.begin(mark.where).line;
    if (line_ != line || !shows(window_, mark.where.begin)) {
      window_ = window_around(places_.bytes(mark.where.source), mark.where.begin);
      source_line(line, window_text(window_));
    }
    mark_line(mark, columns_of(window_, mark.where), paint);
  }

  std::string finish() {
    bar();
    return std::move(out_);
  }

 private:
  void gutter(std::string_view number) {
    out_ +=
        report::paint(fmt::format("{:>{}} |", number, style_.gutter), Paint::kFrame, style_.color);
  }

  void bar() {
    gutter("");
    out_ += '\n';
  }

  void source_line(std::uint32_t line, const std::string& text) {
    if (line_ && line > *line_ + 1) out_ += "...\n";
    gutter(fmt::format("{}", line));
    if (!text.empty()) out_ += ' ' + text;
    out_ += '\n';
    line_ = line;
  }

  void mark_line(const Mark& mark, const Columns& columns, Paint paint) {
    std::string signs(columns.last - columns.first, mark.sign);
    if (columns.goes_on) signs += "…";
    if (!mark.message.empty()) signs += ' ' + printable(mark.message, kMaxMessage);
    gutter("");
    out_ += std::string(columns.first + 1, ' ') + report::paint(signs, paint, style_.color) + '\n';
  }

  /// Characters of a label shown at most: a value quoted in it may be as long as the file.
  static constexpr std::size_t kMaxMessage = 300;

  Places& places_;
  ExcerptStyle style_;
  std::string out_;
  std::optional<std::uint32_t> line_;  // the source line drawn last
  Window window_;                      // and what of it
};

}  // namespace

std::size_t gutter_width(const std::vector<Mark>& marks, Places& places) {
  std::uint32_t largest = 1;
  for (const Mark& mark : marks) largest = std::max(largest, places.begin(mark.where).line);
  return fmt::formatted_size("{}", largest);
}

std::string excerpt(const std::vector<Mark>& marks, Places& places, const ExcerptStyle& style) {
  std::vector<const Mark*> in_order;
  for (const Mark& mark : marks) in_order.push_back(&mark);
  std::stable_sort(in_order.begin(), in_order.end(),
                   [](const Mark* a, const Mark* b) { return a->where.begin < b->where.begin; });
  Drawing drawing(places, style);
  for (const Mark* mark : in_order) {
    drawing.draw(*mark, mark == &marks.front() ? style.paint : Paint::kFrame);
  }
  return drawing.finish();
}

}  // namespace rigor::report
