// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/rules/rule.h>

namespace rigor::rules::xml_not_well_formed {

using Kind = xml::FaultKind;

/// The name in a tag's bytes: "link" of `<link name="a">`.
std::string name_in(std::string_view tag) {
  const std::size_t begin = std::min(tag.find_first_not_of("</"), tag.size());
  return std::string(tag.substr(begin, tag.find_first_of(" \t\r\n/>", begin) - begin));
}

/// What tinyxml2 refuses although every tag is in its place.
std::string refusal(const std::string& error) {
  const std::string who = "tinyxml2, which libsdformat and urdfdom read with, refuses ";
  if (error == "XML_ERROR_PARSING_TEXT") return who + "text behind the root element";
  if (error == "XML_ERROR_PARSING_DECLARATION") return who + "<?…?> anywhere but at the start";
  return who + "the file here (" + error + ")";
}

std::string message(const xml::Fault& fault, const Context& context) {
  const std::string here(context.bytes(fault.where));
  const std::string started = name_in(context.bytes(fault.related));
  switch (fault.kind) {
    case Kind::kBadTag: return "'<' begins no tag here: as a character it is written &lt;";
    case Kind::kBadAttribute: return "the attribute '" + here + "' has no value in quotes";
    case Kind::kUnclosedValue: return "the value that begins with this quote never ends";
    case Kind::kUnclosedTag: return "the tag '" + here + "' is not closed by '>'";
    case Kind::kUnclosedMarkup: return "what begins with '" + here + "' never ends";
    case Kind::kMismatchedEnd: return "</" + name_in(here) + "> where </" + started + "> is due";
    case Kind::kUnexpectedEnd: return "</" + name_in(here) + "> closes nothing: no element is open";
    case Kind::kUnclosedElement: return "the file ends inside <" + started + ">";
    default: return refusal(fault.detail);
  }
}

void check(const xml::Fault& fault, Context& context) {
  Finding finding{.where = fault.where, .message = message(fault, context)};
  if (!fault.related.nowhere()) finding.related.push_back({fault.related, "opened here"});
  context.report(std::move(finding));
}

Rule rule() {
  return {
      .name = "xml-not-well-formed",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .summary = "the file is not XML",
      .why = "Nobody reads such a file: libsdformat, Gazebo, urdfdom and every other XML reader "
             "stop at this place. What stands behind it is not checked.",
      .what_to_do =
          "Put the tag right that the message names; the place where it was opened is shown too.",
      .checks = {on_xml({Kind::kBadTag, Kind::kBadAttribute, Kind::kUnclosedValue,
                         Kind::kUnclosedTag, Kind::kUnclosedMarkup, Kind::kMismatchedEnd,
                         Kind::kUnexpectedEnd, Kind::kUnclosedElement, Kind::kRefused},
                        check)},
  };
}

}  // namespace rigor::rules::xml_not_well_formed
