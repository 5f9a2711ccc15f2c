// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/include_parameters.h>

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/read/values.h>
#include <rigor/text/edit.h>
#include <rigor/xml/edit.h>

namespace rigor::read {
namespace {

std::string_view value_of_attribute(xml::Element element, std::string_view name) {
  const auto attribute = element.attribute(name);
  return attribute ? attribute->value() : std::string_view();
}

/// The element as it is written, without the attributes that are only for the include.
std::string as_written(const xml::Document& source, xml::Element element) {
  const Span span = element.span();
  std::string text(source.bytes().substr(span.begin, span.size()));
  // From the back, so that what comes before keeps its place.
  std::vector<Span> gone;
  for (const xml::Attribute attribute : element.attributes()) {
    if (attribute.name() == "element_id" || attribute.name() == "action") {
      gone.push_back(attribute.span());
    }
  }
  for (auto one = gone.rbegin(); one != gone.rend(); ++one) {
    text.erase(one->begin - span.begin, one->size());
  }
  return text;
}

/// A change of one file.
class IncludeParameter {
 public:
  IncludeParameter(const xml::Document& target, const xml::Document& source)
      : target_(target), source_(source) {}

  void apply(xml::Element model, xml::Element parameter) {
    const std::string_view action = value_of_attribute(parameter, "action");
    const auto id = parameter.attribute("element_id");
    const std::string_view name = action == "add" ? std::string_view() : parameter.name();
    const auto element = id ? find(model, id->value(), name) : std::nullopt;
    if (!element) {
      ignored_.push_back(parameter);
    } else if (action == "add") {
      add(*element, parameter);
    } else if (action.empty()) {
      for (const xml::Element child : parameter.children()) {
        act_on_child(*element, child, value_of_attribute(child, "action"));
      }
    } else {
      act(*element, parameter, action);
    }
  }

  const std::vector<Edit>& edits() const { return edits_; }
  const std::vector<xml::Element>& ignored() const { return ignored_; }

 private:
  /// Below the model, along the names; the last has that element name, unless it is empty.
  static std::optional<xml::Element> find(xml::Element at, std::string_view path,
                                          std::string_view element) {
    while (!path.empty()) {
      const std::size_t end = path.find("::");
      const std::string_view name = path.substr(0, end);
      path.remove_prefix(end == std::string_view::npos ? path.size() : end + 2);
      std::optional<xml::Element> found;
      for (const xml::Element child : at.children()) {
        if (value_of_attribute(child, "name") != name) continue;
        if (path.empty() && !element.empty() && child.name() != element) continue;
        found = child;
        break;
      }
      if (!found) return std::nullopt;
      at = *found;
    }
    return at;
  }

  static std::optional<xml::Element> same_child(xml::Element parent, xml::Element like) {
    const std::string_view name = value_of_attribute(like, "name");
    for (const xml::Element child : parent.children()) {
      if (child.name() != like.name()) continue;
      if (name.empty() || value_of_attribute(child, "name") == name) return child;
    }
    return std::nullopt;
  }

  void add(xml::Element parent, xml::Element parameter) {
    std::optional<xml::Element> last;
    for (const xml::Element child : parent.children()) last = child;
    append(edits_, xml::insert_child(target_, parent, last, as_written(source_, parameter)));
  }

  void act_on_child(xml::Element parent, xml::Element parameter, std::string_view action) {
    if (action == "add") return add(parent, parameter);
    if (const auto child = same_child(parent, parameter)) return act(*child, parameter, action);
    ignored_.push_back(parameter);
  }

  void act(xml::Element element, xml::Element parameter, std::string_view action) {
    if (action == "remove" && parameter.children().empty()) {
      append(edits_, xml::remove_element(target_, element));
    } else if (action == "remove") {
      for (const xml::Element child : parameter.children()) {
        act_on_child(element, child, action);
      }
    } else if (action == "replace") {
      append(edits_, xml::replace_element(target_, element, as_written(source_, parameter)));
    } else if (action == "modify") {
      modify(element, parameter);
    } else {
      ignored_.push_back(parameter);
    }
  }

  /// Elements are as deep as the file, at most xml::kMaxDepth.
  void modify(xml::Element element, xml::Element parameter) {
    std::vector<xml::NamedValue> values;
    for (const xml::Attribute attribute : parameter.attributes()) {
      if (attribute.name() == "element_id" || attribute.name() == "action") continue;
      values.push_back({attribute.name(), std::string(attribute.value())});
    }
    if (!values.empty()) append(edits_, xml::set_attributes(target_, element, values));
    const std::string_view text = trimmed(parameter.text());
    if (parameter.children().empty() && !text.empty()) {
      append(edits_, xml::set_text(target_, element, text));
    }
    for (const xml::Element child : parameter.children()) {
      if (const auto same = same_child(element, child)) {
        modify(*same, child);
      } else {
        add(element, child);
      }
    }
  }

  const xml::Document& target_;
  const xml::Document& source_;
  std::vector<Edit> edits_;
  std::vector<xml::Element> ignored_;
};

}  // namespace

IncludeChanges with_include_parameters(const xml::Document& included, const xml::Document& source,
                                       xml::Element include) {
  IncludeChanges result;
  const auto parameters = include.child("experimental:params");
  if (!parameters) return result;
  std::size_t count = 0;
  for (const xml::Element parameter : parameters->children()) {
    if (++count > kMaxIncludeParameters) break;
    const xml::Document target = xml::parse(
        result.bytes ? std::string_view(*result.bytes) : included.bytes(), included.source());
    const auto root = target.root();
    const auto model = root ? root->child("model") : std::nullopt;
    if (!model) return result;
    IncludeParameter change(target, source);
    change.apply(*model, parameter);
    result.ignored.insert(result.ignored.end(), change.ignored().begin(), change.ignored().end());
    auto text = apply_edits(target.bytes(), change.edits());
    if (text && *text != target.bytes()) result.bytes = *std::move(text);
  }
  return result;
}

}  // namespace rigor::read
