// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/include_parameters.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/read/parameter/described_element.h>
#include <rigor/read/parameter/find_target.h>
#include <rigor/read/values.h>
#include <rigor/text/edit.h>
#include <rigor/xml/edit.h>

namespace rigor::read {
namespace {

/// That of libsdformat 12, by which the parameters are read whatever version the files have.
constexpr schema::Version kVersionOfParameters{9};

std::string_view value_of_attribute(xml::Element element, std::string_view name) {
  const auto attribute = element.attribute(name);
  return attribute ? attribute->value() : std::string_view();
}

bool is_only_for_the_include(std::string_view attribute) {
  return attribute == "element_id" || attribute == "action";
}

bool is_known_action(std::string_view action) {
  return action == "add" || action == "modify" || action == "remove" || action == "replace";
}

/// The element as it is written, without the attributes that are only for the include.
std::string as_written(const xml::Document& source, xml::Element element) {
  const Span span = element.span();
  std::string text(source.bytes().substr(span.begin, span.size()));
  // From the back, so that what comes before keeps its place.
  std::vector<Span> gone;
  for (const xml::Attribute attribute : element.attributes()) {
    if (is_only_for_the_include(attribute.name())) gone.push_back(attribute.span());
  }
  for (auto one = gone.rbegin(); one != gone.rend(); ++one) {
    std::size_t begin = one->begin - span.begin;
    const std::size_t end = begin + one->size();
    while (std::string_view(" \t\r\n").find(text[begin - 1]) != std::string_view::npos) --begin;
    text.erase(begin, end - begin);
  }
  return text;
}

/// A change of one file by a parameter, or by one child of a parameter that has no action itself.
class IncludeParameter {
 public:
  IncludeParameter(const xml::Document& target, const xml::Document& source,
                   const schema::Node& sdf)
      : target_(target), source_(source), sdf_(sdf) {}

  /// Where `only` is given, that child of the parameter is done.
  void apply(xml::Element model, xml::Element parameter, std::optional<xml::Element> only) {
    const std::string_view action = value_of_attribute(parameter, "action");
    const auto id = parameter.attribute("element_id");
    if (!id) return skip(parameter, ParameterFault::kNoElementId);
    if (id->value().ends_with("::")) {
      return skip(parameter, ParameterFault::kNoLastName, id->value());
    }
    if (parameter.attribute("action") && !action.empty() && !is_known_action(action)) {
      return skip(parameter, ParameterFault::kUnknownAction, action);
    }
    const auto element = action == "add" ? parent_to_add_to(model, parameter, id->value())
                                         : target_of(model, parameter, id->value());
    if (!element) return;
    if (only) return act_on_child(*element, parameter, *only);
    if (action.empty()) return;  // and no child: nothing to do
    act(*element, parameter, action);
  }

  std::vector<Edit> edits() const {
    std::vector<Edit> all;
    for (const auto& [index, edits] : edits_) all.insert(all.end(), edits.begin(), edits.end());
    return all;
  }
  const std::vector<SkippedParameter>& skipped() const { return skipped_; }

 private:
  void skip(xml::Element element, ParameterFault fault, std::string_view detail = {}) {
    skipped_.push_back({element, fault, std::string(detail)});
  }

  /// The last edits of an element are those that stay, as libsdformat's last change does.
  void change(xml::Element element, std::vector<Edit> edits) {
    edits_[element.index()] = std::move(edits);
  }

  void skip_not_found(xml::Element model, xml::Element parameter, std::string_view id) {
    const bool one_letter = begins_with_one_letter_name(model, id);
    const bool inside = !one_letter && may_lead_into_include(model, id);
    skip(parameter,
         one_letter ? ParameterFault::kOneLetterName
         : inside   ? ParameterFault::kInInclude
                    : ParameterFault::kNotFound,
         id);
  }

  std::optional<xml::Element> target_of(xml::Element model, xml::Element parameter,
                                        std::string_view id) {
    auto found = find_target(model, parameter.name(), id);
    if (!found) skip_not_found(model, parameter, id);
    return found;
  }

  std::optional<xml::Element> parent_to_add_to(xml::Element model, xml::Element parameter,
                                               std::string_view id) {
    const std::string_view name = value_of_attribute(parameter, "name");
    if (name.empty()) {
      skip(parameter, ParameterFault::kNoName);
      return std::nullopt;
    }
    if (parameter.name() != "plugin" && exists(model, parameter, id)) {
      skip(parameter, ParameterFault::kExists, name);
      return std::nullopt;
    }
    if (id.empty()) return model;
    auto found = find_parent_to_add_to(model, id);
    if (!found) skip_not_found(model, parameter, id);
    return found;
  }

  static bool exists(xml::Element model, xml::Element parameter, std::string_view id) {
    const std::string_view name = value_of_attribute(parameter, "name");
    if (!id.empty()) {
      return find_target(model, parameter.name(), std::string(id) + "::" + std::string(name))
          .has_value();
    }
    return has_the_same(model, parameter);
  }

  /// libsdformat adds a second child of that name, and then refuses the model for it; of plugins there may be
  /// several.
  static bool has_the_same(xml::Element parent, xml::Element added) {
    const std::string_view name = value_of_attribute(added, "name");
    if (name.empty() || added.name() == "plugin") return false;
    for (const xml::Element child : parent.children()) {
      if (child.name() == added.name() && value_of_attribute(child, "name") == name) return true;
    }
    return false;
  }

  /// The child that a modifier is about: of its name, or the first where it has none.
  std::optional<xml::Element> same_child(xml::Element parent, xml::Element like) const {
    const std::string_view name = value_of_attribute(like, "name");
    for (const xml::Element child : parent.children()) {
      if (child.name() != like.name() || removed_.contains(child.index())) continue;
      if (name.empty() || value_of_attribute(child, "name") == name) return child;
    }
    return std::nullopt;
  }

  /// A name that no child has is a new one for the first.
  std::optional<xml::Element> child_to_modify(xml::Element parent, xml::Element like) const {
    const auto same = same_child(parent, like);
    return same ? same : parent.child(like.name());
  }

  void add(xml::Element parent, xml::Element parameter) {
    std::optional<xml::Element> last;
    for (const xml::Element child : parent.children()) last = child;
    change(parent, xml::insert_child(target_, parent, last, as_written(source_, parameter)));
  }

  void act_on_child(xml::Element parent, xml::Element parameter, xml::Element child) {
    const auto of_parent = description_of(sdf_, parameter.name());
    const auto action = child.attribute("action");
    if (!of_parent) return skip(parameter, ParameterFault::kNotSdf);
    if (!action) return skip(child, ParameterFault::kNoAction);
    if (!is_known_action(action->value())) {
      return skip(child, ParameterFault::kUnknownAction, action->value());
    }
    if (action->value() == "add" || action->value() == "replace") {
      const auto node = of_parent->child(child.name());
      if (!node) return skip(child, ParameterFault::kNotAChild, parameter.name());
      if (!can_read(child, *node)) return;
    }
    if (action->value() == "add") {
      if (has_the_same(parent, child))
        return skip(child, ParameterFault::kExists, value_of_attribute(child, "name"));
      return add(parent, child);
    }
    const bool modifies = action->value() == "modify";
    const auto same = modifies ? child_to_modify(parent, child) : same_child(parent, child);
    if (!same) return skip(child, ParameterFault::kNotInElement, parent.name());
    if (action->value() == "replace") return replace(*same, child);
    if (modifies) return modify(*same, child);
    remove(*same, child, ParameterFault::kNotInElement);
  }

  void act(xml::Element element, xml::Element parameter, std::string_view action) {
    if (action == "remove") return remove(element, parameter, ParameterFault::kRemovesNothing);
    if (action == "modify") return modify(element, parameter);
    const auto node = description_of(sdf_, parameter.name());
    if (!node) return skip(parameter, ParameterFault::kNotSdf);
    if (!can_read(parameter, *node)) return;
    if (action == "add") return add(element, parameter);
    replace(element, parameter);
  }

  bool can_read(xml::Element element, const schema::Node& node) {
    const auto why = unreadable_content(element, node);
    if (why) skip(element, ParameterFault::kBadContent, *why);
    return !why;
  }

  void replace(xml::Element element, xml::Element parameter) {
    change(element, xml::replace_element(target_, element, as_written(source_, parameter)));
  }

  /// The element, or those children of it that the parameter names.
  void remove(xml::Element element, xml::Element parameter, ParameterFault missing) {
    if (parameter.children().empty()) return remove_whole(element);
    for (const xml::Element child : parameter.children()) {
      const auto same = same_child(element, child);
      if (!same) {
        skip(child, missing, element.name());
        // libsdformat has ended here.
        if (missing == ParameterFault::kRemovesNothing) return;
        continue;
      }
      remove_whole(*same);
    }
  }

  void remove_whole(xml::Element element) {
    removed_.insert(element.index());
    change(element, xml::remove_element(target_, element));
  }

  /// Elements are as deep as the file, at most xml::kMaxDepth.
  void modify(xml::Element element, xml::Element parameter) {
    const auto node = description_of(sdf_, element);
    std::vector<Edit> edits = modified_attributes(element, parameter, node);
    const std::string_view text = trimmed(parameter.text());
    if (!text.empty()) {
      append(edits, modified_text(element, parameter, node, text));
    } else if (parameter.children().empty() && parameter.attribute("element_id") == std::nullopt &&
               node && node->default_value()) {
      append(edits, xml::set_text(target_, element, *node->default_value()));
    }
    if (!edits.empty()) change(element, std::move(edits));
    if (!text.empty()) return;
    for (const xml::Element child : parameter.children()) {
      if (const auto same = child_to_modify(element, child)) {
        modify(*same, child);
      } else {
        skip(child, ParameterFault::kNotInElement, element.name());
      }
    }
  }

  std::vector<Edit> modified_attributes(xml::Element element, xml::Element parameter,
                                        const std::optional<schema::Node>& node) {
    std::vector<xml::NamedValue> values;
    for (const xml::Attribute attribute : parameter.attributes()) {
      const std::string_view name = attribute.name();
      if (is_only_for_the_include(name)) continue;
      const bool known = element.attribute(name) || name.find(':') != std::string_view::npos ||
                         (node && node->attribute(name));
      if (!known) {
        skip(parameter, ParameterFault::kNoSuchAttribute, name);
      } else {
        values.push_back({name, std::string(attribute.value())});
      }
    }
    return values.empty() ? std::vector<Edit>() : xml::set_attributes(target_, element, values);
  }

  std::vector<Edit> modified_text(xml::Element element, xml::Element parameter,
                                  const std::optional<schema::Node>& node, std::string_view text) {
    if (node && node->type() == schema::Type::kNone) return {};  // it has no value
    if (node && !takes_value(*node, text)) {
      skip(parameter, ParameterFault::kBadValue, text);
      return {};
    }
    return xml::set_text(target_, element, text);
  }

  const xml::Document& target_;
  const xml::Document& source_;
  schema::Node sdf_;
  std::map<std::uint32_t, std::vector<Edit>> edits_;  ///< by the index of the element that changes
  std::set<std::uint32_t> removed_;
  std::vector<SkippedParameter> skipped_;
};

/// One reading of the included file.
struct ParameterStep {
  xml::Element parameter;
  std::optional<xml::Element> child;  ///< whose action it is
};

std::vector<ParameterStep> steps_of(xml::Element parameters) {
  std::vector<ParameterStep> steps;
  for (const xml::Element parameter : parameters.children()) {
    const bool of_children = value_of_attribute(parameter, "action").empty();
    if (!of_children || parameter.children().empty()) {
      steps.push_back({parameter, std::nullopt});
      continue;
    }
    for (const xml::Element child : parameter.children()) steps.push_back({parameter, child});
  }
  if (steps.size() > kMaxIncludeParameters) {
    steps.erase(steps.begin() + kMaxIncludeParameters, steps.end());
  }
  return steps;
}

/// What is wrong with a parameter itself is found for each of its children again.
void take_new(std::vector<SkippedParameter>& all, const std::vector<SkippedParameter>& some) {
  for (const SkippedParameter& skipped : some) {
    if (!all.empty() && all.back().element == skipped.element &&
        all.back().fault == skipped.fault && all.back().detail == skipped.detail) {
      continue;
    }
    all.push_back(skipped);
  }
}

}  // namespace

IncludeChanges with_include_parameters(const xml::Document& included, const xml::Document& source,
                                       xml::Element include, const schema::Schema& sdf) {
  IncludeChanges result;
  const auto parameters = include.child("experimental:params");
  const auto description = sdf.root("sdf", sdf.nearest(kVersionOfParameters));
  if (!parameters || !description) return result;
  for (const auto& [parameter, child] : steps_of(*parameters)) {
    const xml::Document target = xml::parse(
        result.bytes ? std::string_view(*result.bytes) : included.bytes(), included.source());
    const auto root = target.root();
    const auto model = root ? root->child("model") : std::nullopt;
    if (!model) return result;
    IncludeParameter change(target, source, *description);
    change.apply(*model, parameter, child);
    take_new(result.skipped, change.skipped());
    auto text = apply_edits(target.bytes(), change.edits());
    if (text && *text != target.bytes()) result.bytes = *std::move(text);
  }
  return result;
}

}  // namespace rigor::read
