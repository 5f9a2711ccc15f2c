// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/results/parts.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string_view>
#include <tuple>
#include <utility>

#include <rigor/results/line.h>

namespace rigor::results {
namespace {

/// Read at once.
constexpr std::size_t kBlockBytes = std::size_t{1} << 20U;

/// Parts that are open at a time: below the 1,024 files that a process usually may open.
constexpr std::size_t kMaxOpenParts = 256;

std::string_view name_of(ResultKind kind) {
  return kind == ResultKind::kValidate ? "validate" : "simulate";
}

/// The lines of a file, one at a time.
class PartReader {
 public:
  explicit PartReader(const OpenFile& file) : file_(file) {}

  /// Without its end; nothing at the end of the file, and of a line over `kMaxLineBytes`.
  std::optional<std::string_view> next() {
    for (;;) {
      const std::size_t end = buffer_.find('\n', scanned_);
      if (end != std::string::npos) return take(end, end + 1);
      scanned_ = buffer_.size();
      if (buffer_.size() - begin_ > kMaxLineBytes) {
        too_long_ = true;
        return std::nullopt;
      }
      if (!fill()) break;
    }
    if (begin_ == buffer_.size()) return std::nullopt;
    return take(buffer_.size(), buffer_.size());
  }

  bool too_long() const { return too_long_; }
  std::uint64_t line_begin() const { return line_begin_; }

 private:
  std::string_view take(std::size_t end, std::size_t next) {
    const std::string_view line = std::string_view(buffer_).substr(begin_, end - begin_);
    line_begin_ = base_ + begin_;
    begin_ = scanned_ = next;
    return line;
  }

  bool fill() {
    buffer_.erase(0, begin_);
    base_ += begin_;
    scanned_ -= begin_;
    begin_ = 0;
    const std::size_t old = buffer_.size();
    buffer_.resize(old + kBlockBytes);
    buffer_.resize(old + file_.read(base_ + old, buffer_.data() + old, kBlockBytes));
    return buffer_.size() > old;
  }

  const OpenFile& file_;
  std::string buffer_;
  std::uint64_t base_ = 0;   // of the buffer in the file
  std::size_t begin_ = 0;    // of the next line in the buffer
  std::size_t scanned_ = 0;  // no line ends before it
  std::uint64_t line_begin_ = 0;
  bool too_long_ = false;
};

}  // namespace

std::string Parts::where(const Line& line) const {
  return files_[line.file] + ':' + std::to_string(line.number);
}

std::optional<std::string> Parts::add(const std::string& path) {
  const std::unique_ptr<OpenFile> file = disk_.open(path);
  if (!file) return path + ": cannot be read";
  const auto number = static_cast<std::uint32_t>(files_.size());
  files_.push_back(path);
  PartReader reader(*file);
  for (std::uint32_t line = 1; const auto text = reader.next(); ++line) {
    auto problem =
        add_line(*text, {0, reader.line_begin(), static_cast<std::uint32_t>(text->size()), number,
                         line, ResultKind::kValidate});
    if (problem) return problem;
  }
  if (reader.too_long()) return path + ": has a line of more than 256 MiB";
  return std::nullopt;
}

std::optional<std::string> Parts::add_line(std::string_view text, Line line) {
  const std::optional<LineHead> head = head_of(text);
  if (!head) return where(line) + ": is not a result of a run";
  std::uint64_t& total = totals_[static_cast<std::size_t>(head->kind)];
  if (total != 0 && head->one.of != total) {
    return where(line) + ": is of a run of " + std::to_string(head->one.of) + " cases, not " +
           std::to_string(total) + ", of " + std::string(name_of(head->kind));
  }
  total = head->one.of;
  line.index = head->one.index;
  line.kind = head->kind;
  lines_.push_back(line);
  return std::nullopt;
}

Completeness Parts::sort() {
  const auto key = [](const Line& line) {
    return std::tuple(line.kind, line.index, line.file, line.number);
  };
  std::sort(lines_.begin(), lines_.end(),
            [&](const Line& a, const Line& b) { return key(a) < key(b); });
  Completeness found;
  const auto gap = [&found](ResultKind kind, std::uint64_t begin, std::uint64_t end) {
    found.missing += end - begin;
    for (; begin < end && found.first_missing.size() < kMaxListedCases; ++begin)
      found.first_missing.push_back({kind, begin});
  };
  std::array<std::uint64_t, 2> next{};
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Line& line = lines_[i];
    std::uint64_t& expected = next[static_cast<std::size_t>(line.kind)];
    if (i > 0 && lines_[i - 1].kind == line.kind && lines_[i - 1].index == line.index) {
      ++found.doubled;
      if (found.first_doubled.size() < kMaxListedCases)
        found.first_doubled.push_back({line.kind, line.index, where(lines_[i - 1]), where(line)});
      continue;
    }
    gap(line.kind, expected, line.index);
    expected = line.index + 1;
  }
  for (const ResultKind kind : {ResultKind::kValidate, ResultKind::kSimulate})
    gap(kind, next[static_cast<std::size_t>(kind)], cases(kind));
  return found;
}

std::optional<std::string> Parts::each(const std::function<void(const Record&)>& record) const {
  std::map<std::uint32_t, std::unique_ptr<OpenFile>> open;
  std::string text;
  for (const Line& line : lines_) {
    if (open.size() >= kMaxOpenParts && !open.contains(line.file)) open.clear();
    std::unique_ptr<OpenFile>& file = open[line.file];
    if (!file) file = disk_.open(files_[line.file]);
    if (!file) return files_[line.file] + ": cannot be read";
    text.resize(line.size);
    text.resize(file->read(line.begin, text.data(), text.size()));
    const std::optional<Record> one = record_of(text);
    if (!one) return where(line) + ": is not a result of a run";
    record(*one);
  }
  return std::nullopt;
}

}  // namespace rigor::results
