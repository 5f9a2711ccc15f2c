// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// XML laid out as a hand would: two spaces a level, an element without content closed in its tag, a
// blank line between the parts of a file. Private to the room.
//
//   XmlWriter out;
//   out.open("link", {{"name", "base"}});
//   out.text("mass", "1.5");
//   out.close();
//   std::string file = std::move(out).take();

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/convert/remark.h>

namespace rigor::convert {

struct XmlAttribute {
  std::string_view name;
  std::string value;  ///< not escaped
};
using XmlAttributes = std::vector<XmlAttribute>;

class XmlWriter {
 public:
  void open(std::string_view name, const XmlAttributes& attributes = {});
  /// The innermost element that is open; without content it becomes an empty tag.
  void close();

  void empty(std::string_view name, const XmlAttributes& attributes = {});
  void text(std::string_view name, std::string_view text, const XmlAttributes& attributes = {});

  /// What stands between `<!--` and `-->`. Its lines are indented together, dashes that would end it
  /// spaced.
  void comment(std::string_view text);

  /// Comments on the element that is written between these two, each put where it belongs.
  void begin_remarked();
  void end_remarked(const Remarks& remarks);

  /// Elements as they are, their lines indented by the present level.
  void raw(std::string_view xml);

  /// Before whatever comes next, unless that is an end tag.
  void blank_line() { blank_ = true; }

  std::string take() && { return std::move(out_); }

 private:
  struct Place {
    std::string name;
    std::size_t at;     ///< where its line begins
    std::size_t depth;  ///< how many elements are around it
  };

  void tag(std::string_view name, const XmlAttributes& attributes);
  void settle();
  void indent() { out_.append(2 * open_.size(), ' '); }

  std::string out_;
  std::vector<std::string> open_;
  bool pending_ = false;  // a start tag without its '>'
  bool blank_ = false;
  bool remarked_ = false;
  std::vector<Place> places_;  // of the element that is remarked on, and of all in it
};

}  // namespace rigor::convert
