// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/material.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include <rigor/convert/number_text.h>
#include <rigor/convert/urdf/subtree.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>
#include <rigor/schema/script_material.h>
#include <rigor/schema/value.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/document.h>

namespace rigor::convert {
namespace {

using Rgba = std::array<Number, 4>;

/// What Gazebo's default scene shows of a material: its ambient light is 0.4 bright, its sun 0.8.
constexpr double kAmbientLight = 0.4;
constexpr double kSunLight = 0.8;

/// A color as a file gives it: three or four numbers, each brought to 0 to 1.
std::optional<Rgba> color_in(const std::optional<read::Text>& text) {
  if (!text) return std::nullopt;
  Rgba color;
  color[3] = {1, {}};
  std::size_t count = 0;
  std::string_view rest = text->text;
  while (!(rest = read::trimmed(rest)).empty()) {
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
    rest.remove_prefix(word.size());
    const auto parsed = schema::parse_double(word);
    const double* number = std::get_if<double>(&parsed);
    if (number == nullptr || std::isnan(*number) || count == color.size()) return std::nullopt;
    const double clamped = std::clamp(*number, 0.0, 1.0);
    color[count++] = {clamped, clamped == *number ? std::string(word) : std::string()};
  }
  return count >= 3 ? std::optional(color) : std::nullopt;
}

bool same_hue(const Rgba& a, const Rgba& b) {
  return std::equal(a.begin(), a.begin() + 3, b.begin(),
                    [](const Number& x, const Number& y) { return x.value == y.value; });
}

/// Rounded as computed numbers are written.
double rounded_part(double value) { return write::settled(std::clamp(value, 0.0, 1.0), 0, 1); }

Rgba look_of(const Rgba& ambient, const Rgba& diffuse) {
  if (same_hue(ambient, diffuse)) return diffuse;
  Rgba look = diffuse;
  for (std::size_t i = 0; i < 3; ++i) {
    look[i] = {rounded_part(kAmbientLight * ambient[i].value + kSunLight * diffuse[i].value), {}};
  }
  return look;
}

Rgba look_of(const schema::ScriptMaterial& script) {
  const auto& [r, g, b] = script.ambient;
  const auto& [dr, dg, db, alpha] = script.diffuse;
  return look_of({Number{r}, Number{g}, Number{b}, Number{1}},
                 {Number{dr}, Number{dg}, Number{db}, Number{alpha}});
}

/// The value of `<ambient>` or `<diffuse>`; in SDF 1.0 an attribute of it.
std::optional<read::Text> color_text(xml::Element material, std::string_view name) {
  const auto element = material.child(name);
  if (!element) return std::nullopt;
  const auto attribute = read::value_attribute(*element, "rgba");
  return attribute ? attribute : read::Text{element->text(), element->text_span()};
}

class MaterialConverter {
 public:
  MaterialConverter(UrdfDraft& draft, const model::Visual& visual, const std::string& in_block)
      : draft_(draft),
        visual_(visual),
        element_(draft.source.documents.element(visual.site)),
        subject_(subject(draft.source.root, visual)),
        in_block_(in_block) {}

  std::string convert() {
    std::optional<Rgba> color;
    if (visual_.material.written) {
      const xml::Element material = draft_.source.documents.element(visual_.material.site);
      color = written_color(material);
      tell_script(material, color);
      tell_losses(material);
    }
    if (!color) return {};
    make_transparent(*color);
    return named(*color);
  }

 private:
  std::optional<Rgba> written_color(xml::Element material) {
    const auto ambient_text = color_text(material, "ambient");
    const auto diffuse_text = color_text(material, "diffuse");
    const auto ambient = color_in(ambient_text);
    const auto diffuse = color_in(diffuse_text);
    if (!ambient && !diffuse) return std::nullopt;
    const bool one = !ambient || !diffuse || same_hue(*ambient, *diffuse);
    const Outcome outcome = one ? Outcome::kConverted : Outcome::kSubstituted;
    if (ambient) draft_.ledger.take_value(ambient_text->span, outcome);
    if (diffuse) draft_.ledger.take_value(diffuse_text->span, outcome);
    if (!ambient) return diffuse;
    if (!diffuse) return ambient;
    const Rgba look = look_of(*ambient, *diffuse);
    if (!one) {
      draft_.ledger.note(
          {.kind = NoteKind::kMaterialLook,
           .outcome = Outcome::kSubstituted,
           .where = visual_.material.site.name,
           .subject = subject_,
           .written = "ambient " + number_texts(*ambient) + ", diffuse " + number_texts(*diffuse),
           .instead = number_texts(look),
           .count = 2});
    }
    return look;
  }

  /// A color that is written beside a script is what Gazebo shows.
  void tell_script(xml::Element material, std::optional<Rgba>& color) {
    const std::string name = script_name(draft_.source, visual_);
    if (name.empty()) return;
    const bool by_name = !color;
    const auto known = schema::find_material(name);
    if (known && by_name) {
      color = look_of(*known);
      name_ = name;
    }
    Note note{.kind = NoteKind::kMaterialScript,
              .outcome = known && by_name ? Outcome::kSubstituted : Outcome::kLost,
              .where = visual_.material.site.name,
              .subject = subject_,
              .written = name,
              .instead = color ? number_texts(*color) : std::string()};
    if (!in_block_.empty()) note.outcome = Outcome::kCarried;
    const auto script = material.child("script");
    if (script) {
      note.where = script->name_span();
      note.count = draft_.ledger.take_all(*script, note.outcome);
    } else if (const auto attribute = read::value_attribute(material, "script")) {
      note.where = attribute->span;
      draft_.ledger.take_value(attribute->span, note.outcome);
    }
    draft_.ledger.note(std::move(note));
  }

  void tell_losses(xml::Element material) {
    LostChildren lost(draft_, visual_.material.site);
    for (const xml::Element child : material.children()) {
      const std::string_view name = child.name();
      if (name != "ambient" && name != "diffuse" && name != "script") lost.add(child);
    }
    lost.tell(NoteKind::kMaterialLook, subject_);
  }

  void make_transparent(Rgba& color) {
    const auto transparency = read::number_field(read::child_text(element_, "transparency"), 0);
    draft_.ledger.take(transparency);
    if (!(transparency.value > 0)) return;
    name_.clear();
    color[3] = {rounded_part(color[3].value * (1 - std::min(transparency.value, 1.0))), {}};
  }

  std::string named(const Rgba& color) {
    std::array<double, 4> key{};
    for (std::size_t i = 0; i < key.size(); ++i) key[i] = color[i].value;
    const auto [known, is_new] = draft_.material_names.try_emplace(key);
    if (is_new) {
      known->second = name_.empty() ? color_name() : name_;
      draft_.robot.materials.push_back({known->second, color, {}});
    }
    return known->second;
  }

  /// After the first link that has it, since numbers say nothing to who reads the file.
  std::string color_name() {
    const std::string base = draft_.link_names.at(visual_.link) + "_color";
    const int n = ++draft_.color_names[base];
    return n == 1 ? base : base + '_' + std::to_string(n);
  }

  UrdfDraft& draft_;
  const model::Visual& visual_;
  xml::Element element_;
  std::string subject_;
  const std::string& in_block_;
  std::string name_;  // of the color, where it is a script's
};

}  // namespace

std::string script_name(const Source& source, const model::Visual& visual) {
  if (!visual.material.name.value.empty() || !visual.material.written) {
    return visual.material.name.value;
  }
  const auto attribute =
      read::value_attribute(source.documents.element(visual.material.site), "script");
  return attribute ? std::string(read::trimmed(attribute->text)) : std::string();
}

std::string common_script(const Source& source, const model::Link& link) {
  if (link.visuals.empty()) return {};
  const std::string name = script_name(source, source.root[link.visuals.front()]);
  const bool all = std::all_of(
      link.visuals.begin(), link.visuals.end(),
      [&](model::Id<model::Visual> id) { return script_name(source, source.root[id]) == name; });
  return all && schema::find_material(name) ? name : std::string();
}

std::string urdf_material(UrdfDraft& draft, const model::Visual& visual,
                          const std::string& in_block) {
  return MaterialConverter(draft, visual, in_block).convert();
}

}  // namespace rigor::convert
