// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the expander found, once for all instances of a macro that show it, with the stack of the first.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <rigor/xacro/expander.h>

namespace rigor::xacro {
namespace {

bool makes_link_or_joint(const Node& body) {
  for (const Node* child = body.first_element(); child != nullptr; child = child->next_element()) {
    if (child->name == "link" || child->name == "joint" || child->name.starts_with(kTagPrefix))
      return true;
  }
  return false;
}

}  // namespace

Expansion::Expansion() = default;
Expansion::Expansion(Expansion&&) noexcept = default;
Expansion& Expansion::operator=(Expansion&&) noexcept = default;
Expansion::~Expansion() = default;

void PartOrigins::add(std::string_view text, std::span<const PartOrigin> parts) {
  if (text.empty()) return;
  rows_.push_back({text.data(), static_cast<std::uint32_t>(parts_.size()),
                   static_cast<std::uint32_t>(parts.size())});
  parts_.insert(parts_.end(), parts.begin(), parts.end());
}

void PartOrigins::sort() {
  std::sort(rows_.begin(), rows_.end(),
            [](const Row& a, const Row& b) { return std::less<const char*>()(a.text, b.text); });
}

std::span<const PartOrigin> PartOrigins::of(std::string_view text) const {
  const auto row = std::lower_bound(
      rows_.begin(), rows_.end(), text.data(),
      [](const Row& a, const char* wanted) { return std::less<const char*>()(a.text, wanted); });
  if (row == rows_.end() || row->text != text.data()) return {};
  return std::span(parts_).subspan(row->begin, row->count);
}

std::string shown_value(std::string_view value) {
  constexpr std::size_t kShownBytes = 60;
  return std::string(value.substr(0, kShownBytes)) + (value.size() > kShownBytes ? "…" : "");
}

bool Expansion::ok() const {
  return root != nullptr &&
         std::none_of(facts.begin(), facts.end(), [](const Fact& f) { return is_error(f.kind); });
}

bool Expansion::is_known() const {
  return root != nullptr && std::none_of(facts.begin(), facts.end(), [](const Fact& f) {
           return is_error(f.kind) && f.kind != FactKind::kPackageUnresolved;
         });
}

std::vector<FactFrame> Expansion::stack_of(std::uint32_t frame) const {
  std::vector<FactFrame> stack;
  for (; frame != 0 && stack.size() < kMaxShownFrames; frame = frames[frame].outer) {
    const Frame& at = frames[frame];
    FactFrame shown{at.kind, at.where, std::string(at.name)};
    for (std::uint32_t i = 0; i < at.parameter_count; ++i) {
      const auto& [name, value] = frame_parameters[at.parameters + i];
      shown.parameters.push_back({std::string(name), shown_value(value)});
    }
    stack.push_back(std::move(shown));
  }
  return stack;
}

std::uint32_t Expander::push_frame(Frame frame) {
  if (++nodes_made_ > options_.bounds.nodes && !stopped_) {
    report(FactKind::kBoundReached, {frame.where, true}, {}, "the size of an expansion");
    stopped_ = true;
  }
  result_.frames.push_back(std::move(frame));
  return static_cast<std::uint32_t>(result_.frames.size() - 1);
}

void Expander::report(FactKind kind, Place place, std::string name, std::string detail,
                      Span related) {
  const Span where = place.span.nowhere() && !result_.files.empty()
                         ? Span{result_.files.front().source, 0, 0}
                         : place.span;
  auto key = std::pair{
      kind,
      std::pair{(std::uint64_t{static_cast<std::uint32_t>(where.source)} << 32U) | where.begin,
                where.end}};
  // So is a value that several conditions take.
  if (kind == FactKind::kNotBoolean && !related.nowhere()) {
    key.second = {
        (std::uint64_t{static_cast<std::uint32_t>(related.source)} << 32U) | related.begin,
        related.end};
  }
  // A name that a file lacks is one fault, however often it is used there.
  if (kind == FactKind::kUndefinedName && !where.nowhere()) {
    key.second = {(std::uint64_t{static_cast<std::uint32_t>(where.source)} << 32U) | 0xffffffffU,
                  symbols_.of(heap_.keep(name))};
  }
  // A package that is missing is one fault of an expansion, whoever names it.
  const bool is_package = kind == FactKind::kPackageUnresolved;
  if (is_package) key.second = {0, symbols_.of(name)};
  const auto [known, added] = fact_by_place_.emplace(key, result_.facts.size());
  if (!added && known->second < result_.facts.size() && result_.facts[known->second].name == name) {
    Fact& first = result_.facts[known->second];
    if (!is_package) ++first.count;
    // What is like it may be defined behind the first use.
    if (kind == FactKind::kUndefinedName && first.near.empty()) first.near = std::move(detail);
    return;
  }
  if (result_.facts.size() >= options_.bounds.facts) {
    ++result_.facts_left_out;
    return;
  }
  known->second = result_.facts.size();
  Fact fact{kind, where, std::move(name), std::move(detail), {}, related, result_.stack_of(frame_)};
  const bool names_near = kind == FactKind::kUndefinedName || kind == FactKind::kUndefinedMacro ||
                          kind == FactKind::kUndefinedArgument;
  if (names_near) fact.near = std::exchange(fact.detail, {});
  result_.facts.push_back(std::move(fact));
}

bool Expander::needs_missing_package(std::string_view path) {
  for (const std::string& package : unresolved_) {
    const std::string folder = std::string(kPackageScheme) + package;
    const std::size_t at = path.find(folder);
    const std::size_t behind = at + folder.size();
    if (at == std::string_view::npos || (behind < path.size() && path[behind] != '/')) continue;
    for (Fact& fact : result_.facts) {
      if (fact.kind == FactKind::kPackageUnresolved && fact.name == package)
        fact.kind = FactKind::kPackageNotFound;
    }
    incomplete_ = true;
    lacks_files_ = true;
    return true;
  }
  return false;
}

void Expander::relate_definitions() {
  for (Fact& fact : result_.facts) {
    if (fact.kind != FactKind::kUndefinedName || !fact.related.nowhere()) continue;
    for (const Definition& definition : definitions_) {
      if (definition.name == fact.name) fact.related = definition.where;
    }
  }
}

void Expander::report_faults(const File& file) {
  if (file.tree.faults.empty()) return;
  const NotWellFormed& fault =
      *std::min_element(file.tree.faults.begin(), file.tree.faults.end(),
                        [](const auto& a, const auto& b) { return a.where.begin < b.where.begin; });
  report(FactKind::kNotWellFormed, {fault.where, true}, file.path, fault.detail);
}

void Expander::report_failure(const Failure& failure, Place place) {
  // One value of a wrong type shows in many attributes of an element.
  const bool is_type = failure.kind == FactKind::kWrongType;
  if (!is_type || element_ == nullptr || element_ != element_at_fault_) {
    // A lazy property's text fails where it is written; where it is used matters, too.
    report(failure.kind, place, failure.name, failure.detail, is_type ? text_in_use_ : Span{});
  }
  if (is_type) element_at_fault_ = element_;
  text_in_use_ = {};
  if (failure.kind == FactKind::kBoundReached && (heap_.full() || !evaluator_.work(0))) {
    evaluator_.take_failure();
    stopped_ = true;
  }
}

namespace {

/// A whole number that a property holds, as it is or as a text that is not yet evaluated.
std::optional<std::int64_t> whole_number(const Value& value) {
  if (value.is(Type::kInteger)) return value.integer_;
  if (value.is(Type::kReal)) {
    constexpr double kMostDegrees = 1e6;
    const bool whole =
        std::abs(value.real_) < kMostDegrees && std::floor(value.real_) == value.real_;
    return whole ? std::optional(static_cast<std::int64_t>(value.real_)) : std::nullopt;
  }
  if (!value.is_text()) return std::nullopt;
  const std::string_view text = value.as_text();
  std::int64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool all = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return all ? std::optional(number) : std::nullopt;
}

}  // namespace

void Expander::report_degrees(const Expression& expression, Scope& scope, Place place) {
  const ExpressionNode& call = expression.nodes[expression.degrees];
  const ExpressionNode& argument = expression.nodes[expression.lists[call.b + 1]];
  std::string detail;
  if (argument.op == Op::kName) {
    const Binding* binding = scope.find(argument.symbol);
    const auto number = binding != nullptr ? whole_number(binding->value) : std::nullopt;
    if (!number || std::abs(*number) <= kMostRadians) return;
    detail = std::string(symbols_.name(argument.symbol)) + " = " + std::to_string(*number);
  } else {
    detail = std::to_string(argument.constant.integer_);
  }
  report(FactKind::kDegrees, place.part(call.begin, std::max(call.end, call.begin + 1)),
         std::string(symbols_.name(expression.nodes[call.a].symbol)), std::move(detail));
}

/// Elements of URDF have the names of macros all the time: only one in the robot itself that gives what
/// the macro asks for, and nothing else, is meant as a call. One that gives nothing is where the macro makes
/// parts of a robot.
void Expander::report_missing_prefix(const Node& node, MacroScope& macros) {
  constexpr std::string_view kElements[] = {"link",   "joint",    "material",    "gazebo",
                                            "sensor", "inertial", "transmission"};
  const auto is_name = [&node](std::string_view known) {
    return known.size() == node.name.size() && known[0] == node.name[0] && known == node.name;
  };
  if (std::any_of(std::begin(kElements), std::end(kElements), is_name)) return;
  const MacroEntry* entry = macros.find(symbols_.of(node.name));
  if (entry == nullptr || entry->macro == nullptr) return;
  const auto& parameters = entry->macro->parameters;
  const bool gives_all = std::all_of(parameters.begin(), parameters.end(), [&](const auto& one) {
    return one.has_default || one.forwards || one.name.starts_with('*') ||
           node.attribute(one.name) != nullptr;
  });
  const bool gives_only =
      std::all_of(node.attributes.begin(), node.attributes.end(), [&](const auto& attribute) {
        return std::any_of(parameters.begin(), parameters.end(),
                           [&](const auto& one) { return one.name == attribute.name; });
      });
  if (!gives_all || !gives_only) return;
  const bool is_bare = node.attributes.empty();
  if (is_bare && (node.first_element() != nullptr || !makes_link_or_joint(*entry->macro->body)))
    return;
  report(FactKind::kMissingPrefix, node.where.part(1, 1 + node.name.size()), std::string(node.name),
         {}, entry->macro->body->where.span);
}

const NodeAttribute* Expander::required(const Node& node, std::string_view name) {
  const NodeAttribute* attribute = node.attribute(name);
  if (attribute == nullptr)
    report(FactKind::kMissingAttribute, node.where, std::string(name), std::string(node.name));
  if (attribute == nullptr) lacks_attribute_ = &node;
  return attribute;
}

void Expander::check_known(const Node& node, std::initializer_list<std::string_view> known) {
  // An attribute that is missing and one that is unknown are one misspelling.
  if (lacks_attribute_ == &node) return;
  for (const NodeAttribute& attribute : node.attributes) {
    if (attribute.name.starts_with("xmlns:") || attribute.name.starts_with("xacro:")) continue;
    if (std::find(known.begin(), known.end(), attribute.name) != known.end()) continue;
    report(FactKind::kUnknownAttribute, attribute.where, std::string(attribute.name),
           std::string(node.name));
  }
}

}  // namespace rigor::xacro
