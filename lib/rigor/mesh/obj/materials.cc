// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/obj/materials.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <rigor/mesh/text_cursor.h>
#include <rigor/mesh/write/parts.h>

namespace rigor::mesh {
namespace {

// As long as paths are on Linux.
constexpr std::size_t kMaxTextureBytes = 4096;

// Options before a picture's name that have words behind them, one and two. Those of `-o`, `-s` and
// `-t` are one to three numbers.
constexpr std::array<std::string_view, 9> kOneWord{
    "-blendu", "-blendv", "-boost", "-texres", "-clamp", "-imfchan", "-bm", "-type", "-cc"};
constexpr std::string_view kTwoWords = "-mm";
constexpr std::array<std::string_view, 3> kNumbers{"-o", "-s", "-t"};

template <class List>
bool lists(const List& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

class ObjMaterialReader {
 public:
  explicit ObjMaterialReader(std::string_view bytes) : cursor_(bytes) {}

  std::vector<Material> run() {
    for (; !cursor_.at_end(); cursor_.skip_line()) statement();
    finish();
    return std::move(materials_);
  }

 private:
  void statement() {
    cursor_.skip_blanks();
    const std::string_view word = cursor_.word();
    if (word == "newmtl") {
      finish();
      now_ =
          Known{.look = {.name = std::string(cursor_.rest_of_line().substr(0, kMaxObjNameBytes))}};
    } else if (!now_) {
      return;
    } else if (word == "Kd") {
      color();
    } else if (word == "d") {
      now_->opacity = fraction();
      if (!now_->opacity) now_->opacity = halo();
    } else if (word == "Tr") {
      now_->transparency = fraction();
    } else if (word == "map_Kd") {
      picture();
    } else if (word == "map_d") {
      now_->look.picture_opacity = true;
    }
  }

  /// From 0 to 1.
  std::optional<float> fraction() {
    const std::optional<double> number = cursor_.number();
    if (!number || std::isnan(*number)) return std::nullopt;
    return static_cast<float>(std::clamp(*number, 0.0, 1.0));
  }

  /// `d -halo 0.5`: less opaque where it is seen face to face.
  std::optional<float> halo() { return cursor_.word() == "-halo" ? fraction() : std::nullopt; }

  /// Three numbers, or one for all.
  void color() {
    const std::optional<float> red = fraction();
    if (!red) return;
    const float green = fraction().value_or(*red);
    const float blue = fraction().value_or(*red);
    now_->look.diffuse = {*red, green, blue, 1};
    now_->colored = true;
  }

  void picture() {
    for (cursor_.skip_blanks(); skip_option(); cursor_.skip_blanks()) {
    }
    now_->look.texture = cursor_.rest_of_line().substr(0, kMaxTextureBytes);
  }

  bool skip_option() {
    TextCursor ahead = cursor_;
    const std::string_view option = ahead.word();
    const bool numbers = lists(kNumbers, option);
    std::size_t words = lists(kOneWord, option) ? 1 : option == kTwoWords ? 2 : 0;
    if (!numbers && words == 0) return false;
    cursor_ = ahead;
    for (; words > 0; --words) {
      cursor_.skip_blanks();
      cursor_.word();
    }
    for (int i = 0; numbers && i < 3 && cursor_.number(); ++i) {
    }
    return true;
  }

  /// Takes in the material so far. A picture without a color is seen as it is.
  void finish() {
    if (!now_) return;
    Material& look = now_->look;
    if (!now_->colored && !look.texture.empty()) look.diffuse = {1, 1, 1, 1};
    if (now_->transparency) look.diffuse.back() = 1 - *now_->transparency;
    if (now_->opacity) look.diffuse.back() = *now_->opacity;
    if (names_.insert(look.name).second) materials_.push_back(std::move(look));
    now_.reset();
  }

  /// What has been said of a material. Files with both `d` and `Tr` mean the first: some writers
  /// put `Tr 1` for what is not transparent.
  struct Known {
    Material look;
    std::optional<float> opacity = {};
    std::optional<float> transparency = {};
    bool colored = false;
  };

  TextCursor cursor_;
  std::optional<Known> now_;
  std::vector<Material> materials_;
  std::set<std::string> names_;
};

void append_fraction(std::string& text, float value) {
  text += ' ';
  append_number(text, double{value});
}

}  // namespace

std::vector<Material> read_obj_materials(std::string_view bytes) {
  return ObjMaterialReader(bytes).run();
}

std::string rest_of_obj_line(const std::string& name) {
  std::string line = name.empty() ? "" : ' ' + clean(name);
  if (line.ends_with('\\')) line.back() = '_';
  return line + '\n';
}

std::string write_obj_materials(const TriangleMesh& mesh) {
  std::string text;
  for (const Look& look : looks_of(mesh, parts_with_triangles(mesh)).looks) {
    if (!look.material || look.name.empty()) continue;
    const auto& [red, green, blue, opacity] = look.material->diffuse;
    text += "newmtl" + rest_of_obj_line(look.name) + "Kd";
    for (const float part : {red, green, blue}) append_fraction(text, part);
    text += '\n';
    if (opacity != 1) {
      text += 'd';
      append_fraction(text, opacity);
      text += '\n';
    }
    if (!look.material->texture.empty())
      text += "map_Kd" + rest_of_obj_line(look.material->texture);
  }
  return text;
}

}  // namespace rigor::mesh
