// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/xml_writer.h>

#include <algorithm>
#include <map>
#include <vector>

#include <rigor/read/values.h>
#include <rigor/xml/edit.h>

namespace rigor::convert {
namespace {

/// XML has no two dashes in a comment, nor one at its end.
std::string with_spaced_dashes(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '-' && !result.empty() && result.back() == '-') result += ' ';
    result += c;
  }
  if (!result.empty() && result.back() == '-') result += ' ';
  return result;
}

/// Calls `f` with each line, its end left out.
template <class F>
void each_xml_line(std::string_view text, const F& f) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    f(text.substr(0, end));
    if (end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
  }
}

/// Spaces and tabs that all lines with content begin with.
std::size_t common_indent(const std::vector<std::string_view>& lines) {
  std::size_t least = std::string_view::npos;
  for (const std::string_view line : lines) {
    least = std::min(least, line.find_first_not_of(" \t\r"));
  }
  return least == std::string_view::npos ? 0 : least;
}

/// What was commented out keeps its shape: its lines move together.
std::string comment_line(std::string_view text, std::size_t depth) {
  const std::string indent(2 * depth, ' ');
  const std::string spaced = with_spaced_dashes(text);
  std::vector<std::string_view> lines;
  each_xml_line(spaced, [&](std::string_view line) { lines.push_back(line); });
  while (!lines.empty() && read::trimmed(lines.back()).empty()) lines.pop_back();
  const auto written = std::find_if(lines.begin(), lines.end(), [](std::string_view line) {
    return !read::trimmed(line).empty();
  });
  const bool on_own_lines = written != lines.begin() && lines.end() - written > 1;
  lines.erase(lines.begin(), written);
  std::string result = indent + "<!--";
  if (!on_own_lines && !lines.empty()) {
    (result += ' ') += read::trimmed(lines.front());
    lines.erase(lines.begin());
  }
  const std::size_t shared = common_indent(lines);
  for (const std::string_view line : lines) {
    result += '\n';
    if (read::trimmed(line).empty()) continue;
    result += indent;
    if (!on_own_lines) result += "     ";
    const std::string_view own = line.substr(shared);
    result += own.substr(0, own.find_last_not_of(" \t\r") + 1);
  }
  return result + (on_own_lines ? '\n' + indent + "-->\n" : " -->\n");
}

}  // namespace

void XmlWriter::settle() {
  if (pending_) out_ += ">\n";
  pending_ = false;
  if (blank_ && !out_.empty()) out_ += '\n';
  blank_ = false;
}

void XmlWriter::tag(std::string_view name, const XmlAttributes& attributes) {
  settle();
  if (remarked_) places_.push_back({std::string(name), out_.size(), open_.size()});
  indent();
  (out_ += '<') += name;
  for (const XmlAttribute& attribute : attributes) {
    ((out_ += ' ') += attribute.name) += "=\"";
    (out_ += xml::escaped(attribute.value)) += '"';
  }
}

void XmlWriter::open(std::string_view name, const XmlAttributes& attributes) {
  tag(name, attributes);
  pending_ = true;
  open_.emplace_back(name);
}

void XmlWriter::close() {
  const std::string name = std::move(open_.back());
  open_.pop_back();
  blank_ = false;
  if (pending_) {
    out_ += "/>\n";
    pending_ = false;
    return;
  }
  if (remarked_) places_.push_back({std::string(kAtEnd), out_.size(), open_.size()});
  indent();
  ((out_ += "</") += name) += ">\n";
}

void XmlWriter::empty(std::string_view name, const XmlAttributes& attributes) {
  tag(name, attributes);
  out_ += "/>\n";
}

void XmlWriter::text(std::string_view name, std::string_view text,
                     const XmlAttributes& attributes) {
  tag(name, attributes);
  (out_ += '>') += xml::escaped(text);
  ((out_ += "</") += name) += ">\n";
}

void XmlWriter::comment(std::string_view text) {
  settle();
  out_ += comment_line(text, open_.size());
}

void XmlWriter::begin_remarked() {
  settle();
  remarked_ = true;
  places_.clear();
}

void XmlWriter::end_remarked(const Remarks& remarks) {
  remarked_ = false;
  if (places_.empty()) return;
  const std::size_t depth = places_.front().depth;
  const auto place_of = [&](const Remark& remark) {
    for (const std::string& name : remark.places) {
      const auto found = std::find_if(places_.begin(), places_.end(), [&](const Place& place) {
        return place.name == name && (name != kAtEnd || place.depth == depth);
      });
      if (found != places_.end()) return *found;
    }
    return places_.front();
  };
  std::map<std::size_t, std::string> added;
  for (const Remark& remark : remarks) {
    const Place place = place_of(remark);
    added[place.at] += comment_line(remark.text, place.depth + (place.name == kAtEnd ? 1 : 0));
  }
  for (auto one = added.rbegin(); one != added.rend(); ++one) out_.insert(one->first, one->second);
}

void XmlWriter::raw(std::string_view xml) {
  if (xml.empty()) return;
  settle();
  // A line inside a text stays as it is: what is indented each time it is written grows.
  bool in_text = false;
  each_xml_line(xml, [&](std::string_view line) {
    const std::string_view content = read::trimmed(line);
    if (!in_text && !content.empty() && content.front() == '<') indent();
    (out_ += line) += '\n';
    in_text = content.empty() || content.back() != '>';
  });
}

}  // namespace rigor::convert
