// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/write/write_inertial.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/read/values.h>
#include <rigor/schema/value.h>
#include <rigor/schema/version.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/edit.h>
#include <rigor/xml/style.h>

namespace rigor::write {
namespace {

using mass::MassProperties;
using xml::Attribute;
using xml::Element;

/// A number to write, and how exact it is known: a text that reads as either of them is left alone.
struct Number {
  double rounded = 0;
  double exact = 0;

  std::string text() const { return schema::to_shortest(rounded); }
  bool reads_so(std::string_view other) const {
    const auto value = number_in(other);
    return value && (*value == exact || *value == rounded);
  }
};

using Numbers = std::vector<Number>;

std::string joined_numbers(const Numbers& numbers) {
  std::string text;
  for (const Number& number : numbers) text += (text.empty() ? "" : " ") + number.text();
  return text;
}

std::string element_text(std::string_view name, const std::string& text) {
  return '<' + std::string(name) + '>' + text + "</" + std::string(name) + '>';
}

/// A child that stands in its parent, or the text of one that has to be added; neither when it can
/// be left out.
struct Part {
  std::optional<Element> element;
  std::string missing;
};

enum class Form { kSdf, kOldSdf, kUrdf };

Form form_of(const xml::Document& document, BlockFormat format) {
  if (format == BlockFormat::kUrdf) return Form::kUrdf;
  const auto version = document.root()->attribute("version");
  const auto parsed = version ? schema::parse_version(version->value()) : std::nullopt;
  return parsed && parsed->minor == 0 ? Form::kOldSdf : Form::kSdf;
}

class Writer {
 public:
  Writer(const xml::Document& document, const MassProperties& body, BlockFormat format)
      : document_(document), form_(form_of(document, format)), body_(body) {
    const MassProperties written = rounded(body);
    const auto& [x, y, z] = written.com;
    com_is_zero_ = x == 0 && y == 0 && z == 0;
    com_ = {{x, body.com.x}, {y, body.com.y}, {z, body.com.z}};
    mass_ = {written.mass, body.mass};
    const auto entries = [](const mass::Inertia& i) {
      return std::array<double, kEntries.size()>{i.ixx, i.ixy, i.ixz, i.iyy, i.iyz, i.izz};
    };
    const auto few_digits = entries(written.about_com);
    const auto exact = entries(body.about_com);
    for (std::size_t k = 0; k < kEntries.size(); ++k) inertia_[k] = {few_digits[k], exact[k]};
  }

  std::vector<Edit> write(Element link) {
    const auto inertial = link.child("inertial");
    if (!inertial) {
      add(xml::insert_child(document_, link, leading_pose(link), block()));
    } else if (form_ == Form::kOldSdf && xml::is_empty_tag(document_, *inertial) &&
               !inertial->attribute("mass")) {
      // The new attribute and the new end would be two edits in one place.
      add(xml::replace_element(document_, *inertial, block()));
    } else {
      update(*inertial);
    }
    return std::move(edits_);
  }

 private:
  void add(std::vector<Edit> edits) {
    edits_.insert(edits_.end(), std::move_iterator(edits.begin()), std::move_iterator(edits.end()));
  }

  std::optional<Element> leading_pose(Element link) const {
    if (form_ == Form::kUrdf || link.children().empty()) return std::nullopt;
    const Element first = *link.children().begin();
    if (first.name() == (form_ == Form::kSdf ? "pose" : "origin")) return first;
    return std::nullopt;
  }

  std::string block() const {
    if (form_ != Form::kOldSdf) {
      return inertial_text(body_, form_ == Form::kSdf ? BlockFormat::kSdf : BlockFormat::kUrdf);
    }
    std::string text = "<inertial mass=\"" + mass_.text() + "\">\n";
    if (!com_is_zero_) text += "  " + pose_text() + '\n';
    return text + "  " + tensor_text() + "\n</inertial>";
  }

  std::string pose_text() const {
    const std::string com = joined_numbers(com_);
    switch (form_) {
      case Form::kSdf: return element_text("pose", com + " 0 0 0");
      case Form::kOldSdf: return "<origin pose=\"" + com + " 0 0 0\"/>";
      case Form::kUrdf: break;
    }
    return "<origin xyz=\"" + com + "\" rpy=\"0 0 0\"/>";
  }

  std::string tensor_text() const {
    std::string text = "<inertia";
    if (form_ == Form::kSdf) {
      text += '>';
      for (std::size_t i = 0; i < kEntries.size(); ++i) {
        text += "\n  " + element_text(kEntries[i], inertia_[i].text());
      }
      return text + "\n</inertia>";
    }
    for (std::size_t i = 0; i < kEntries.size(); ++i) {
      text += ' ' + std::string(kEntries[i]) + "=\"" + inertia_[i].text() + '"';
    }
    return text + "/>";
  }

  void update(Element inertial) {
    const std::vector<Part> parts{pose(inertial), mass(inertial), tensor(inertial)};
    const auto automatic = inertial.attribute("auto");
    const auto density = inertial.child("density");
    if (!automatic || schema::parse_bool(automatic->value()) != schema::Parsed<bool>(true)) {
      return insert(inertial, parts);
    }
    add(xml::remove_attribute(document_, *automatic));
    if (!density) return insert(inertial, parts);
    std::string missing;
    for (const Part& part : parts) append_line(missing, part.missing);
    add(missing.empty() ? xml::remove_element(document_, *density)
                        : xml::replace_element(document_, *density, missing));
  }

  Part pose(Element inertial) {
    const auto pose = inertial.child(form_ == Form::kSdf ? "pose" : "origin");
    if (!pose) return {std::nullopt, com_is_zero_ ? "" : pose_text()};
    const Numbers no_turn(3);
    const Numbers no_turn_quaternion{{}, {}, {}, {1, 1}};
    if (form_ == Form::kUrdf) {
      if (!com_is_zero_ || pose->attribute("xyz")) set_attribute(*pose, "xyz", com_);
      if (pose->attribute("rpy")) set_attribute(*pose, "rpy", no_turn);
      if (pose->attribute("quat_xyzw")) set_attribute(*pose, "quat_xyzw", no_turn_quaternion);
      return {pose, {}};
    }
    const auto format = pose->attribute("rotation_format");
    Numbers numbers = com_;
    for (const Number& number :
         format&& read::trimmed(format->value()) == "quat_xyzw" ? no_turn_quaternion : no_turn) {
      numbers.push_back(number);
    }
    if (form_ == Form::kOldSdf) {
      if (!com_is_zero_ || pose->attribute("pose")) set_attribute(*pose, "pose", numbers);
    } else if (!com_is_zero_ || !read::trimmed(pose->text()).empty()) {
      set_text(*pose, numbers);
    }
    for (const std::string_view name : {"relative_to", "frame"}) {
      const auto attribute = pose->attribute(name);
      if (attribute && !attribute->value().empty())
        add(xml::remove_attribute(document_, *attribute));
    }
    return {pose, {}};
  }

  Part mass(Element inertial) {
    const auto mass = inertial.child("mass");
    if (form_ == Form::kUrdf) {
      if (!mass) return {std::nullopt, "<mass value=\"" + mass_.text() + "\"/>"};
      set_attribute(*mass, "value", {mass_});
    } else if (mass) {
      set_text(*mass, {mass_});
    } else if (form_ == Form::kOldSdf) {
      set_attribute(inertial, "mass", {mass_});
    } else {
      return {std::nullopt, element_text("mass", mass_.text())};
    }
    return {mass, {}};
  }

  Part tensor(Element inertial) {
    const auto tensor = inertial.child("inertia");
    if (!tensor) return {std::nullopt, tensor_text()};
    // A mixture of exact and rounded entries may be no body's.
    if (reads_exactly(*tensor)) return {tensor, {}};
    std::vector<Part> parts;
    std::vector<xml::NamedValue> attributes;
    for (std::size_t i = 0; i < kEntries.size(); ++i) {
      const Number number{inertia_[i].rounded, inertia_[i].rounded};
      const auto child = tensor->child(kEntries[i]);
      parts.push_back({child, {}});
      if (child) {
        set_text(*child, {number});
      } else if (form_ == Form::kSdf) {
        if (!may_miss(i)) parts.back().missing = element_text(kEntries[i], number.text());
      } else if (const auto attribute = tensor->attribute(kEntries[i])) {
        set_attribute(*tensor, kEntries[i], {number});
      } else {
        attributes.push_back({kEntries[i], number.text()});
      }
    }
    add(xml::set_attributes(document_, *tensor, attributes));
    insert(*tensor, parts);
    return {tensor, {}};
  }

  /// Whether an entry is what SDF has where nothing is written: products are zero.
  bool may_miss(std::size_t i) const {
    const bool product = kEntries[i][1] != kEntries[i][2];
    return form_ == Form::kSdf && product && inertia_[i].rounded == 0;
  }

  bool reads_exactly(Element tensor) const {
    for (std::size_t i = 0; i < kEntries.size(); ++i) {
      const auto child = tensor.child(kEntries[i]);
      const auto attribute = tensor.attribute(kEntries[i]);
      if (!child && !attribute) {
        if (may_miss(i)) continue;
        return false;
      }
      const auto value = number_in(child ? child->text() : attribute->value());
      const bool noise = value == 0.0 && inertia_[i].rounded == 0;
      if (value != inertia_[i].exact && !noise) return false;
    }
    return true;
  }

  static void append_line(std::string& lines, const std::string& line) {
    if (!lines.empty() && !line.empty()) lines += '\n';
    lines += line;
  }

  /// What is missing, each part behind the one that precedes it.
  void insert(Element parent, const std::vector<Part>& parts) {
    std::optional<Element> after;
    std::string lines;
    const auto flush = [&] {
      if (!lines.empty()) add(xml::insert_child(document_, parent, after, lines));
      lines.clear();
    };
    for (const Part& part : parts) {
      append_line(lines, part.missing);
      if (!part.element) continue;
      flush();
      after = part.element;
    }
    flush();
  }

  void set_text(Element element, const Numbers& numbers) {
    if (set_in_place(element.text_span(), numbers)) return;
    add(xml::set_text(document_, element, joined_numbers(numbers)));
  }

  void set_attribute(Element element, std::string_view name, const Numbers& numbers) {
    const auto attribute = element.attribute(name);
    if (attribute && set_in_place(attribute->value_span(), numbers)) return;
    add(xml::set_attribute(document_, element, name, joined_numbers(numbers)));
  }

  /// Replaces those numbers of a text that read otherwise; false when it is not that many.
  bool set_in_place(Span span, const Numbers& numbers) {
    const std::string_view bytes = document_.bytes().substr(0, span.end);
    const std::size_t before = edits_.size();
    std::size_t count = 0;
    std::size_t at = bytes.find_first_not_of(kSpace, span.begin);
    for (; at < bytes.size(); ++count) {
      const std::size_t end = std::min(bytes.find_first_of(kSpace, at), bytes.size());
      if (count == numbers.size()) break;
      if (!numbers[count].reads_so(bytes.substr(at, end - at))) {
        edits_.push_back(
            {{document_.source(), static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)},
             numbers[count].text()});
      }
      at = bytes.find_first_not_of(kSpace, end);
    }
    if (count == numbers.size() && at >= bytes.size()) return true;
    edits_.resize(before);
    return false;
  }

  const xml::Document& document_;
  Form form_;
  MassProperties body_;
  bool com_is_zero_ = false;
  Numbers com_;
  Number mass_;
  std::array<Number, kEntries.size()> inertia_;
  std::vector<Edit> edits_;
};

}  // namespace

std::vector<Edit> write_inertial(const xml::Document& document, Element link,
                                 const MassProperties& body, BlockFormat format) {
  if (format == BlockFormat::kMjcf || !document.complete() || link.cut()) return {};
  return Writer(document, body, format).write(link);
}

}  // namespace rigor::write
