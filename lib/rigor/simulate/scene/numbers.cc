// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Every number that a simulation takes from a file is examined where it stands, since what the readers
// cannot read they replace by a default: a pose of "nan 0 0 0 0 0" must not become the origin.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <variant>

#include <rigor/schema/value.h>
#include <rigor/simulate/scene/draft.h>

namespace rigor::simulate {
namespace {

enum class NumberMeans : std::uint8_t {
  kFinite,
  kLength,     ///< m: at most kFarthest
  kUnbounded,  ///< may be infinite
};

struct NumberRow {
  std::string_view name;  ///< of an SDF element or a URDF attribute
  std::size_t count;      ///< of numbers; 0: any
  NumberMeans means = NumberMeans::kFinite;
};

constexpr std::array kSdfNumbers{
    NumberRow{"pose", 0, NumberMeans::kLength},  // six, or seven with a quaternion
    NumberRow{"mass", 1},
    NumberRow{"ixx", 1},
    NumberRow{"ixy", 1},
    NumberRow{"ixz", 1},
    NumberRow{"iyy", 1},
    NumberRow{"iyz", 1},
    NumberRow{"izz", 1},
    NumberRow{"density", 1},
    NumberRow{"size", 0, NumberMeans::kLength},  // two of a plane, three of a box
    NumberRow{"radius", 1, NumberMeans::kLength},
    NumberRow{"length", 1, NumberMeans::kLength},
    NumberRow{"height", 1, NumberMeans::kLength},
    NumberRow{"radii", 3, NumberMeans::kLength},
    NumberRow{"normal", 3},
    NumberRow{"scale", 3},
    NumberRow{"point", 2, NumberMeans::kLength},
    NumberRow{"xyz", 3},
    NumberRow{"lower", 1, NumberMeans::kUnbounded},
    NumberRow{"upper", 1, NumberMeans::kUnbounded},
    NumberRow{"effort", 1, NumberMeans::kUnbounded},
    NumberRow{"velocity", 1, NumberMeans::kUnbounded},
    NumberRow{"damping", 1},
    NumberRow{"friction", 1},
    NumberRow{"spring_reference", 1},
    NumberRow{"spring_stiffness", 1},
    NumberRow{"multiplier", 1},
    NumberRow{"offset", 1},
    NumberRow{"reference", 1},
    NumberRow{"thread_pitch", 1},
    NumberRow{"screw_thread_pitch", 1},
    NumberRow{"gearbox_ratio", 1},
};

constexpr std::array kUrdfNumbers{
    NumberRow{"xyz", 3, NumberMeans::kLength},
    NumberRow{"rpy", 3},
    NumberRow{"value", 1},
    NumberRow{"ixx", 1},
    NumberRow{"ixy", 1},
    NumberRow{"ixz", 1},
    NumberRow{"iyy", 1},
    NumberRow{"iyz", 1},
    NumberRow{"izz", 1},
    NumberRow{"size", 3, NumberMeans::kLength},
    NumberRow{"radius", 1, NumberMeans::kLength},
    NumberRow{"length", 1, NumberMeans::kLength},
    NumberRow{"scale", 3},
    NumberRow{"lower", 1, NumberMeans::kUnbounded},
    NumberRow{"upper", 1, NumberMeans::kUnbounded},
    NumberRow{"effort", 1, NumberMeans::kUnbounded},
    NumberRow{"velocity", 1, NumberMeans::kUnbounded},
    NumberRow{"damping", 1},
    NumberRow{"friction", 1},
    NumberRow{"multiplier", 1},
    NumberRow{"offset", 1},
};

/// What no body moves by: looks, sensors, other engines' settings. The numbers of surfaces are examined
/// where surfaces are.
constexpr std::array<std::string_view, 14> kNumbersElsewhere{
    "visual",  "sensor", "light",   "plugin",  "projector", "audio_sink", "audio_source",
    "surface", "bullet", "simbody", "battery", "physics",   "heightmap",  "particle_emitter"};

/// One word of a text that is a list of numbers, and where.
struct NumberWord {
  std::size_t begin;
  std::size_t end;
};

std::vector<NumberWord> number_words(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  std::vector<NumberWord> words;
  std::size_t at = text.find_first_not_of(kBlank);
  while (at != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(kBlank, at), text.size());
    words.push_back({at, end});
    at = text.find_first_not_of(kBlank, end);
  }
  return words;
}

/// libsdformat reads a single number up to what is no part of it: "0.5kg" is 0.5, and value-trailing-text
/// says so.
std::string_view up_to_trailing(std::string_view text) {
  const auto parsed = schema::parse_double(text);
  const auto* fault = std::get_if<schema::ValueFault>(&parsed);
  const bool cut = fault != nullptr && fault->kind == schema::ValueFault::Kind::kTrailingText;
  return cut ? text.substr(0, fault->begin) : text;
}

class NumberCheck {
 public:
  explicit NumberCheck(SceneDraft& draft) : draft_(draft) {}

  template <class Entity>
  void walk(const Entity& entity, bool urdf) {
    std::vector<xml::Element> open{draft_.element(entity.site)};
    while (!open.empty()) {
      const xml::Element element = open.back();
      open.pop_back();
      if (urdf) {
        for (const xml::Attribute attribute : element.attributes()) {
          look(kUrdfNumbers, {attribute.value(), attribute.value_span()}, attribute.name(),
               attribute.verbatim(), entity);
        }
      } else if (element.children().empty()) {
        look(kSdfNumbers, {element.text(), element.text_span()}, element.name(),
             element.text_verbatim(), entity);
      }
      push_children(element, open);
    }
  }

  template <class Entity>
  void look_at_pose(xml::Element holder, const Entity& entity) {
    if (const auto pose = holder.child("pose")) {
      look(kSdfNumbers, {pose->text(), pose->text_span()}, "pose", pose->text_verbatim(), entity);
    }
  }

 private:
  static void push_children(xml::Element element, std::vector<xml::Element>& open) {
    const std::size_t first = open.size();
    for (const xml::Element child : element.children()) {
      const auto* end = kNumbersElsewhere.end();
      if (std::find(kNumbersElsewhere.begin(), end, child.name()) == end) open.push_back(child);
    }
    std::reverse(open.begin() + static_cast<std::ptrdiff_t>(first), open.end());
  }

  template <class Rows, class Entity>
  void look(const Rows& rows, const read::Text& text, std::string_view name, bool verbatim,
            const Entity& entity) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [name](const NumberRow& r) { return r.name == name; });
    if (row == rows.end()) return;
    const bool one_of_sdf = std::data(rows) == kSdfNumbers.data() && row->count == 1;
    const std::vector<NumberWord> words =
        number_words(one_of_sdf ? up_to_trailing(text.text) : std::string_view(text.text));
    for (const NumberWord& word : words) {
      Span where = text.span;
      if (verbatim) {
        where.end = where.begin + static_cast<std::uint32_t>(word.end);
        where.begin += static_cast<std::uint32_t>(word.begin);
      }
      judge_word(*row, text.text.substr(word.begin, word.end - word.begin), where, entity);
    }
    const bool any = row->count == 0 || words.empty();
    if (!any && words.size() != row->count)
      draft_.say(FactKind::kNotFinite, text.span, entity, std::string(name));
  }

  template <class Entity>
  void judge_word(const NumberRow& row, std::string_view word, Span where, const Entity& entity) {
    const auto parsed = schema::parse_double(word);
    const double* value = std::get_if<double>(&parsed);
    const bool whole = value != nullptr && !std::isnan(*value) &&
                       (std::isfinite(*value) || row.means == NumberMeans::kUnbounded);
    if (!whole) {
      draft_.say(FactKind::kNotFinite, where, entity, std::string(row.name));
    } else if (row.means == NumberMeans::kLength && std::abs(*value) > kFarthest) {
      draft_.say(FactKind::kTooLarge, where, entity, std::string(row.name), *value, kFarthest);
    }
  }

  SceneDraft& draft_;
};

}  // namespace

void check_numbers(SceneDraft& draft) {
  const model::Root& root = draft.root;
  NumberCheck check(draft);
  for (std::uint32_t i = 0; i < root.models.size(); ++i) {
    const model::Model& model = root.models[i];
    if (draft.takes({i}) && model.format == model::Format::kSdf) {
      check.look_at_pose(draft.element(model.site), model);
    }
  }
  for (const model::Include& include : root.includes) {
    if (draft.takes(include.loaded)) {
      check.look_at_pose(draft.element(include.site), root[include.loaded]);
    }
  }
  const auto in_urdf = [&root](model::Id<model::Model> id) {
    return id && root[id].format == model::Format::kUrdf;
  };
  for (const model::Link& link : root.links) {
    if (draft.takes(link.model)) check.walk(link, in_urdf(link.model));
  }
  const auto is_taken = [&draft](const auto& entity) {
    return entity.model ? draft.takes(entity.model) : entity.world && entity.world.value == 0;
  };
  for (const model::Joint& joint : root.joints) {
    if (is_taken(joint)) check.walk(joint, in_urdf(joint.model));
  }
  for (const model::Frame& frame : root.frames) {
    if (is_taken(frame)) check.walk(frame, in_urdf(frame.model));
  }
}

}  // namespace rigor::simulate
