// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/dialects.h>
#include <rigor/rules/schema/place.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::consumer_name_misspelt {

using Names = std::vector<std::string_view>;

bool has(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The elements among the names, or the attributes without their @.
Names of_kind(const Names& names, bool attributes) {
  Names kind;
  for (const std::string_view name : names) {
    if (name.starts_with('@') != attributes) continue;
    kind.push_back(attributes ? name.substr(1) : name);
  }
  return kind;
}

void report(Span where, const std::string& what, std::string_view name, const Names& near,
            xml::Element element, std::optional<Fix> fix, Context& context) {
  const auto reader = schema::find_dialect(dialect_format(context), element.name(), near.front());
  const auto attribute = schema::find_dialect(dialect_format(context), element.name(),
                                              "@" + std::string(near.front()));
  const std::string consumer(reader.value_or(attribute.value_or("its consumer")));
  context.report({.where = where,
                  .message = consumer + " does not read " + what + "'" + std::string(name) +
                             "' in <" + std::string(element.name()) + ">",
                  .subject = subject_of(element),
                  .help = "did you mean '" + std::string(near.front()) + "'?",
                  .fix = near.size() == 1 ? std::move(fix) : std::nullopt});
}

void check_element(xml::Element element, const Names& names, Context& context) {
  const Names elements = of_kind(names, false);
  for (const xml::Element child : element.children()) {
    if (has(elements, child.name())) continue;
    const Names near = schema::near(child.name(), elements);
    if (near.empty()) continue;
    report(child.name_span(), "", child.name(), near, element,
           fix_of("write <" + std::string(near.front()) + ">", Applicability::kUnsafe,
                  xml::rename_element(context.document(), child, std::string(near.front()))),
           context);
  }
  const Names attributes = of_kind(names, true);
  for (const xml::Attribute attribute : element.attributes()) {
    if (has(attributes, attribute.name())) continue;
    const Names near = schema::near(attribute.name(), attributes);
    if (near.empty()) continue;
    const std::string meant(near.front());
    report(attribute.name_span(), "the attribute ", attribute.name(), near, element,
           Fix{"write '" + meant + "'", Applicability::kUnsafe, {{attribute.name_span(), meant}}},
           context);
  }
}

/// What has a consumer's prefix in an element of the format: <drake:proximity_propertes>.
void check_prefixed(xml::Element element, xml::Element parent, Context& context) {
  const std::string_view name = element.name();
  const std::size_t colon = name.find(':');
  if (colon == name.npos) return;
  Names same;
  for (const std::string_view known :
       of_kind(schema::dialect_names(dialect_format(context), parent.name()), false)) {
    if (known.starts_with(name.substr(0, colon + 1))) same.push_back(known);
  }
  if (has(same, name)) return;
  const Names near = schema::near(name, same);
  if (near.empty()) return;
  report(element.name_span(), "", name, near, parent,
         fix_of("write <" + std::string(near.front()) + ">", Applicability::kUnsafe,
                xml::rename_element(context.document(), element, std::string(near.front()))),
         context);
}

/// Tells most names from those of sections by their first letter and length.
class SectionNames {
 public:
  explicit SectionNames(Names sorted) : sorted_(std::move(sorted)) {
    for (const std::string_view name : sorted_) lengths_[first(name)] |= bit(name);
  }

  bool has(std::string_view name) const {
    return (lengths_[first(name)] & bit(name)) != 0 &&
           std::binary_search(sorted_.begin(), sorted_.end(), name);
  }

 private:
  static std::size_t first(std::string_view name) {
    return name.empty() ? 0 : static_cast<unsigned char>(name.front());
  }
  static std::uint64_t bit(std::string_view name) { return std::uint64_t{1} << name.size() % 64; }

  Names sorted_;
  std::array<std::uint64_t, 256> lengths_{};
};

/// Those of a format are the same for all files.
const SectionNames& sections_of(const Context& context) {
  static const SectionNames urdf(schema::dialect_sections("urdf"));
  static const SectionNames sdf(schema::dialect_sections("sdf"));
  return context.is_urdf() ? urdf : sdf;
}

void check(const model::Root& /*root*/, Context& context) {
  if (!context.is_urdf() && !context.is_sdf()) return;
  const std::string_view format = dialect_format(context);
  const SectionNames& sections = sections_of(context);
  const xml::Document& document = context.document();
  for (std::uint32_t i = 1; i < document.element_count(); ++i) {
    const xml::Element element = document.element(i);
    const std::string_view name = element.name();
    const bool prefixed = name.find(':') != std::string_view::npos;
    if (!prefixed && !sections.has(name)) continue;
    const auto parent = element.parent();
    if (!parent) continue;
    if (!schema::find_dialect(format, parent->name(), element.name())) {
      if (prefixed) check_prefixed(element, *parent, context);
      continue;
    }
    const Names names = schema::dialect_names(format, element.name());
    if (!names.empty() && !has(names, "any")) check_element(element, names, context);
  }
}

Rule rule() {
  return {
      .name = "consumer-name-misspelt",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a name that one consumer reads is misspelt",
      .why =
          "MuJoCo's <mujoco>, the drake: elements and Bullet's <contact> are outside the format, "
          "so that nothing else reads them, and their consumer ignores a name that it does not "
          "know or rejects the file (MuJoCo: \"unrecognized attribute\").",
      .what_to_do = "Write the name that the message suggests.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::consumer_name_misspelt
