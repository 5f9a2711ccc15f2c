// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collada/materials.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace rigor::mesh {
namespace {

using xml::Element;

// What consumers make of a surface that says nothing of its color: assimp's gray, so that both
// readers of Collada agree.
constexpr float kGrey = 0.6F;

// From a texture to its image there are two parameters, the sampler and the surface; a circle ends
// here.
constexpr int kMaxParameters = 4;

std::optional<std::array<double, 4>> color_of(Element element) {
  for (const std::size_t count : {std::size_t{4}, std::size_t{3}}) {
    const auto read = numbers(element, count);
    if (!read ||
        !std::all_of(read->begin(), read->end(), [](double x) { return std::isfinite(x); })) {
      continue;
    }
    std::array<double, 4> color{0, 0, 0, 1};
    std::copy(read->begin(), read->end(), color.begin());
    return color;
  }
  return std::nullopt;
}

float fraction(double number) { return static_cast<float>(std::clamp(number, 0.0, 1.0)); }

/// With each %xx as the byte that it represents (RFC 3986, 2.1), without the scheme of files.
std::string path_of_uri(std::string_view uri) {
  constexpr std::string_view kFile = "file://";
  if (uri.starts_with(kFile)) uri.remove_prefix(kFile.size());
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = uri.data() + i + 1;
    const bool coded = uri[i] == '%' && i + 2 < uri.size() &&
                       std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    path += coded ? static_cast<char>(byte) : uri[i];
    if (coded) i += 2;
  }
  return path;
}

/// One <effect>. Of several profiles, techniques and shadings the first counts.
class ColladaEffect {
 public:
  ColladaEffect(const ColladaIndex& index, Element effect) : index_(index), scopes_{effect} {
    if (const auto profile = effect.child("profile_COMMON")) scopes_.push_back(*profile);
    const auto technique = scopes_.back().child("technique");
    if (!technique) return;
    scopes_.push_back(*technique);
    for (const Element child : technique->children()) {
      const std::string_view name = child.name();
      const bool shades =
          name == "lambert" || name == "phong" || name == "blinn" || name == "constant";
      if (shades && !shading_) shading_ = child;
    }
  }

  Material look() const {
    Material look{.diffuse = {kGrey, kGrey, kGrey, 1}};
    if (!shading_) return look;
    const auto color = descend(*shading_, {"diffuse", "color"});
    if (const auto rgba = color ? color_of(*color) : std::nullopt) {
      std::transform(rgba->begin(), rgba->end(), look.diffuse.begin(), fraction);
    }
    if (const auto texture = descend(*shading_, {"diffuse", "texture"})) {
      look.diffuse = {1, 1, 1, 1};
      look.texture = picture(value(*texture, "texture"));
      look.picture_opacity = descend(*shading_, {"transparent", "texture"}).has_value();
    }
    if (const auto written = opacity()) look.diffuse.back() = fraction(*written);
    return look;
  }

 private:
  /// Collada 1.4.1 and 1.5, "Determining Transparency": A_ONE, which is meant where nothing is
  /// said, and A_ZERO count the color's alpha, the others its luminance (ITU-R BT.709); the ones
  /// have 1 for opaque, the zeros 0. Nothing where neither element is.
  std::optional<double> opacity() const {
    const auto transparent = shading_->child("transparent");
    const auto written = descend(*shading_, {"transparency", "float"});
    if (!transparent && !written) return std::nullopt;
    const auto amount = written ? numbers(*written, 1) : std::vector<double>{1};
    if (!amount || !(amount->front() >= 0 && amount->front() <= 1)) return std::nullopt;
    const auto color = transparent ? transparent->child("color") : std::nullopt;
    const auto [red, green, blue, alpha] =
        (color ? color_of(*color) : std::nullopt).value_or(std::array<double, 4>{0, 0, 0, 1});
    const std::string_view mode = transparent ? value(*transparent, "opaque") : "";
    const double luminance = 0.212671 * red + 0.715160 * green + 0.072169 * blue;
    const double share = amount->front() * (mode.starts_with("RGB_") ? luminance : alpha);
    return mode.ends_with("_ZERO") ? 1 - share : share;
  }

  std::optional<Element> parameter(std::string_view sid) const {
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
      for (const Element child : scope->children()) {
        if (child.name() == "newparam" && value(child, "sid") == sid) return child;
      }
    }
    return std::nullopt;
  }

  /// Collada 1.4 has the picture of a sampler behind a surface, 1.5 has it there; some exporters
  /// name the image itself.
  std::string picture(std::string_view name) const {
    for (int i = 0; i < kMaxParameters; ++i) {
      const auto found = parameter(name);
      if (!found) break;
      const auto source = descend(*found, {"sampler2D", "source"});
      const auto surface = descend(*found, {"surface", "init_from"});
      const auto image = descend(*found, {"sampler2D", "instance_image"});
      if (source) name = trimmed_text(*source);
      if (surface) name = trimmed_text(*surface);
      if (image) name = value(*image, "url");
      if (name.starts_with('#')) name.remove_prefix(1);
    }
    const auto image = index_.find_id(name, "image");
    const auto from = image && !image->child("data") ? image->child("init_from") : std::nullopt;
    if (!from) return {};
    const auto ref = from->child("ref");
    const std::string_view uri = trimmed_text(ref ? *ref : *from);
    return uri.size() <= kMaxColladaPicture ? path_of_uri(uri) : std::string();
  }

  const ColladaIndex& index_;
  std::vector<Element> scopes_;  ///< from the outside in
  std::optional<Element> shading_;
};

}  // namespace

ColladaMaterials::ColladaMaterials(const ColladaIndex& index) : index_(index) {
  std::map<std::string, unsigned> last;  // number, by own name
  std::set<std::string> taken;
  for (std::uint32_t i = 0; i < index.document().element_count(); ++i) {
    const Element element = index.document().element(i);
    if (element.name() != "material") continue;
    std::string_view written = value(element, "name");
    if (written.empty()) written = value(element, "id");
    const std::string own(written.substr(0, kMaxColladaName));
    std::string name = own;
    unsigned& number = last[own];
    while (!taken.insert(name).second) name = own + ' ' + std::to_string(++number);
    names_.emplace(i, std::move(name));
  }
}

const std::string& ColladaMaterials::name(Element material) {
  const std::string& name = names_.at(material.index());
  const auto instance = material.child("instance_effect");
  const auto effect = instance ? index_.find(value(*instance, "url"), "effect") : std::nullopt;
  if (!effect || !listed_.insert(material.index()).second) return name;
  const auto [at, is_new] = effects_.try_emplace(effect->index());
  if (is_new) at->second = ColladaEffect(index_, *effect).look();
  materials_.push_back(at->second);
  materials_.back().name = name;
  return name;
}

}  // namespace rigor::mesh
