// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/xml_writer.h>

#include <algorithm>
#include <map>

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

std::string comment_line(std::string_view text, std::size_t depth) {
  const std::string indent(2 * depth, ' ');
  std::string result = indent + "<!--";
  bool first = true;
  each_xml_line(read::trimmed(with_spaced_dashes(text)), [&](std::string_view line) {
    line = read::trimmed(line);
    if (!first) result += '\n';
    if (!first && !line.empty()) (result += indent) += "    ";
    if (!line.empty()) (result += ' ') += line;
    first = false;
  });
  return result + " -->\n";
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
