// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <rigor/read/values.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/gazebo_content.h>
#include <rigor/rules/schema/refused_value.h>
#include <rigor/rules/schema/value_text.h>
#include <rigor/rules/sdformat_robot.h>
#include <rigor/text/letter_case.h>

namespace rigor::rules::gazebo_value_malformed {

using FaultKind = schema::ValueFault::Kind;

/// Whether a comment stands before the text: libsdformat then sees no text of a key.
bool follows_comment(xml::Element element, const Context& context) {
  const Span tag = element.tag_span();
  const Span text = element.text_span();
  return tag.end < text.begin &&
         context.bytes({tag.source, tag.end, text.begin}).find("<!--") != std::string_view::npos;
}

/// Where something can be pointed at.
Span shown(Span value, xml::Element element) {
  return value.size() > 0 ? value : element.name_span();
}

std::string quoted(std::string_view value) { return "'" + std::string(read::trimmed(value)) + "'"; }

/// What is wrong with the value of a key.
struct KeyFault {
  std::string_view wanted;
  std::string_view outcome;  ///< what libsdformat does with it
  bool refused;
};

constexpr std::string_view kAborts = "libsdformat aborts";
constexpr std::string_view kBeginning = "libsdformat reads its beginning only";

/// By stod: an exception that is not caught ends the process.
std::optional<KeyFault> fault_of_number(std::string_view text) {
  const std::string_view wanted = expected(schema::Type::kDouble);
  const auto parsed = schema::parse_double(text);
  if (const auto* fault = std::get_if<schema::ValueFault>(&parsed)) {
    const bool begins = fault->kind == FaultKind::kTrailingText ||
                        fault->kind == FaultKind::kTooMany ||
                        (fault->kind == FaultKind::kDecimalComma && text[fault->begin] != ',');
    return begins ? KeyFault{wanted, kBeginning, false} : KeyFault{wanted, kAborts, true};
  }
  const schema::NumberForm form = schema::classify(text);
  if (form.subnormal) return KeyFault{wanted, kAborts, true};
  if (form.nan) return KeyFault{wanted, "the simulation gets no number", false};
  return std::nullopt;
}

/// By stoi, which stops before a point: 10.0 is 10 all the same.
std::optional<KeyFault> fault_of_whole(std::string_view text) {
  const std::string_view wanted = expected(schema::Type::kInt);
  const std::string_view value = read::trimmed(text);
  const std::size_t sign = value.starts_with('-') || value.starts_with('+') ? 1 : 0;
  const std::size_t end = std::min(value.find_first_not_of("0123456789", sign), value.size());
  const auto begun = schema::parse_int(value.substr(0, end));
  if (std::holds_alternative<schema::ValueFault>(begun)) return KeyFault{wanted, kAborts, true};
  const std::string_view rest = value.substr(end);
  const bool zeros = rest.starts_with('.') && rest.find_first_not_of('0', 1) == rest.npos;
  if (rest.empty() || zeros) return std::nullopt;
  return KeyFault{wanted, kBeginning, false};
}

std::optional<KeyFault> fault_of_truth(std::string_view text, std::string_view key) {
  const std::string_view value = read::trimmed(text);
  for (const std::string_view word : {"true", "yes", "1", "false", "no", "0"}) {
    if (equal_but_for_case(value, word)) return std::nullopt;
  }
  return KeyFault{expected(schema::Type::kBool),
                  key == "turnGravityOff" ? "it counts as true" : "it counts as false", false};
}

/// An empty one counts as not written, and a fourth number is passed over.
std::optional<KeyFault> fault_of_vector(std::string_view text) {
  const auto fault = schema::check(schema::Type::kVector3, text);
  if (!fault || fault->kind == FaultKind::kEmpty || fault->kind == FaultKind::kTooMany) {
    return std::nullopt;
  }
  const std::string_view wanted = expected(schema::Type::kVector3);
  return sdformat_refuses(*fault, schema::Type::kVector3, text)
             ? KeyFault{wanted, "libsdformat rejects it", true}
             : KeyFault{wanted, kBeginning, false};
}

std::optional<KeyFault> fault_of_key(const GazeboKey& key, std::string_view text) {
  switch (key.value) {
    case GazeboValue::kAny: return std::nullopt;
    case GazeboValue::kTruth: return fault_of_truth(text, key.name);
    case GazeboValue::kVector: return fault_of_vector(text);
    case GazeboValue::kNumber: return fault_of_number(text);
    case GazeboValue::kWhole: return fault_of_whole(text);
  }
  return std::nullopt;
}

/// Whether libsdformat's model has what the block refers to: a link without mass it drops, with what
/// hangs on it, and a joint with a link that it lumps into another.
bool comes_into_sdf(const model::GazeboBlock& block, Context& context) {
  const std::string& name = block.reference.value;
  if (name.empty()) return true;
  const SdformatRobot& robot = context.sdformat_robot();
  const model::Model& model = context.root()[model::Id<model::Model>{0}];
  for (std::size_t i = 0; i < robot.parts.size(); ++i) {
    const SdformatRobot::Part& part = robot.parts[i];
    if (robot.parts[part.head].fate != SdformatRobot::Fate::kLink) continue;
    if (context.root()[model.links[i]].name.value == name) return true;
    const bool has_joint = part.head == i && part.joint;
    if (has_joint && context.root()[part.joint].name.value == name) return true;
  }
  return false;
}

/// Whether the link has shapes that take what the block says of them.
bool has_shapes(const model::GazeboBlock& block, std::string_view kind, const Context& context) {
  const auto id = context.frames().names().find_link({0}, block.reference.value);
  if (!id) return false;
  const model::Link& link = context.root()[id];
  return kind == "visual" ? !link.visuals.empty() : !link.collisions.empty();
}

void check_keys(const model::GazeboBlock& block, Context& context) {
  for (const xml::Element child : context.element(block.site).children()) {
    const auto key = gazebo_key(child.name());
    if (!key || has_xacro(child.text()) || has_xacro_child(child)) continue;
    read::Text given{child.text(), child.text_span()};
    const auto attribute = read::attribute_text(child, "value");  // goes before the text
    if (attribute) given = *attribute;
    if (has_xacro(given.text)) continue;
    const bool unseen = !attribute && follows_comment(child, context);
    const auto fault = fault_of_key(*key, unseen ? std::string_view() : given.text);
    if (!fault) continue;
    const std::string wanted(fault->wanted);
    std::string message = "<" + std::string(key->name) + "> ";
    if (unseen) {
      message += "has a comment before its value";
    } else if (read::trimmed(given.text).empty()) {
      message += "has no value and takes " + wanted;
    } else {
      message += "takes " + wanted + ", not " + quoted(given.text);
    }
    message += ": " + std::string(fault->outcome);
    const bool copied = key->value == GazeboValue::kVector;
    context.report(
        {.where = shown(given.span, child),
         .message = std::move(message),
         .refused = fault->refused && (!copied || (comes_into_sdf(block, context) &&
                                                   has_shapes(block, "collision", context)))});
  }
}

/// Whether the value is read as it is meant, or by its default, and so is no error.
bool is_harmless(const read::SchemaFact& fact) {
  if (has_kind(fact, FaultKind::kEmpty)) {
    return fact.node->cardinality() != schema::Cardinality::kOne;
  }
  const schema::Type type = fact.node->type();
  const bool counted = type == schema::Type::kPose || type == schema::Type::kColor;
  if (has_kind(fact, FaultKind::kTooMany)) return !counted;
  return has_kind(fact, FaultKind::kNegative);
}

/// "1.0" is the count that its author meant, and is read so.
bool is_whole_with_zeros(const read::SchemaFact& fact) {
  if (!has_kind(fact, FaultKind::kTrailingText)) return false;
  const std::string_view rest = read::trimmed(fact.text.substr(fact.value_fault->begin));
  return rest.starts_with('.') && rest.find_first_not_of('0', 1) == rest.npos;
}

std::string why_of(const read::SchemaFact& fact, bool refused) {
  const std::string copied = "libsdformat copies the element into the SDF that it makes";
  if (refused) return copied + ", and rejects that for the value.";
  if (!has_kind(fact, FaultKind::kTrailingText)) return copied + ", and takes the default there.";
  const std::string_view read = read::trimmed(fact.text.substr(0, fact.value_fault->begin));
  return copied + ", and reads '" + std::string(read) + "' there.";
}

void check_sdf(const model::GazeboBlock& block, Context& context) {
  check_copied(block, context, [&](const read::SchemaFact& fact) {
    if (fact.kind != read::SchemaFactKind::kBadValue) return;
    if (left_for_xacro(fact) || has_xacro_child(fact.element) || is_harmless(fact)) return;
    const Span value = fact.attribute ? fact.attribute->value_span() : fact.element.text_span();
    const std::string wanted(expected(fact.node->type()));
    const bool empty = has_kind(fact, FaultKind::kEmpty);
    xml::Element part = fact.element;  // the child of the block that it stands in
    while (part.parent()->name() != "gazebo") part = *part.parent();
    const bool of_shape = part.name() == "collision" || part.name() == "visual";
    const bool refused = sdformat_refuses(fact) && comes_into_sdf(block, context) &&
                         (!of_shape || has_shapes(block, part.name(), context));
    context.report(
        {.where = shown(value, fact.element),
         .message = owner_of(fact) + (empty ? " has no value and takes " + wanted
                                            : " takes " + wanted + ", not " + quoted(fact.text)),
         .refused = refused,
         .why = why_of(fact, refused),
         .severity = is_whole_with_zeros(fact) ? std::optional(Severity::kInfo) : std::nullopt});
  });
}

void check(const model::GazeboBlock& block, Context& context) {
  check_keys(block, context);
  check_sdf(block, context);
}

Rule rule() {
  return {
      .name = "gazebo-value-malformed",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kSays},
      .formats = Formats::kUrdf,
      .summary = "a value in a <gazebo> block is not what its place takes",
      .why = "libsdformat reads the numbers of mu1, kp and their like up to what is no part of "
             "them: <mu1>0,8</mu1> is no friction at all. Where there is no number, its process "
             "aborts, and Gazebo with it. A truth that it does not know counts as false, of "
             "turnGravityOff as true. What it copies into the SDF, a sensor, it reads as SDF: it "
             "rejects the file for a word instead of a number, and shortens 0,1 to 0.",
      .what_to_do = "Write a value of the kind that the message names, with a decimal point in "
                    "numbers, and no comment before it.",
      .checks = {on<model::GazeboBlock>(check)},
  };
}

}  // namespace rigor::rules::gazebo_value_malformed
