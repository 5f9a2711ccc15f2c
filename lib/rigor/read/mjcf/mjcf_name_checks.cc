// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <rigor/read/mjcf/mjcf_checks.h>
#include <rigor/text/path.h>

namespace rigor::read {
namespace {

/// What an empty reference is to MuJoCo. That to a mesh, material, texture or height field is none at all.
enum class EmptyName : std::uint8_t { kRejected, kNone };

/// A reference: where it is, and what kind of name it holds. An empty section is any.
struct MjcfReference {
  std::string_view section, tag, attribute, kind;
  EmptyName empty = EmptyName::kRejected;
};

constexpr std::array kMjcfReferences{
    MjcfReference{"actuator", "", "joint", "joint"},
    MjcfReference{"actuator", "", "jointinparent", "joint"},
    MjcfReference{"actuator", "", "tendon", "tendon"},
    MjcfReference{"actuator", "", "site", "site"},
    MjcfReference{"actuator", "", "refsite", "site", EmptyName::kNone},
    MjcfReference{"actuator", "", "slidersite", "site"},
    MjcfReference{"actuator", "", "cranksite", "site"},
    MjcfReference{"actuator", "", "body", "body"},
    MjcfReference{"equality", "", "body1", "body"},
    MjcfReference{"equality", "", "body2", "body", EmptyName::kNone},
    MjcfReference{"equality", "", "site1", "site"},
    MjcfReference{"equality", "", "site2", "site"},
    MjcfReference{"equality", "joint", "joint1", "joint"},
    MjcfReference{"equality", "joint", "joint2", "joint", EmptyName::kNone},
    MjcfReference{"equality", "tendon", "tendon1", "tendon"},
    MjcfReference{"equality", "tendon", "tendon2", "tendon", EmptyName::kNone},
    MjcfReference{"contact", "", "geom1", "geom"},
    MjcfReference{"contact", "", "geom2", "geom"},
    MjcfReference{"contact", "", "body1", "body"},
    MjcfReference{"contact", "", "body2", "body"},
    MjcfReference{"tendon", "site", "site", "site"},
    MjcfReference{"tendon", "geom", "geom", "geom"},
    MjcfReference{"tendon", "geom", "sidesite", "site", EmptyName::kNone},
    MjcfReference{"tendon", "joint", "joint", "joint"},
    MjcfReference{"tendon", "", "material", "material"},
    MjcfReference{"sensor", "", "joint", "joint"},
    MjcfReference{"sensor", "", "actuator", "actuator"},
    MjcfReference{"sensor", "", "tendon", "tendon"},
    MjcfReference{"sensor", "", "site", "site"},
    MjcfReference{"sensor", "", "body", "body"},
    MjcfReference{"sensor", "", "camera", "camera"},
    MjcfReference{"sensor", "", "geom1", "geom"},
    MjcfReference{"sensor", "", "geom2", "geom"},
    MjcfReference{"sensor", "", "body1", "body"},
    MjcfReference{"sensor", "", "body2", "body"},
    MjcfReference{"worldbody", "geom", "mesh", "mesh"},
    MjcfReference{"worldbody", "geom", "hfield", "hfield"},
    MjcfReference{"worldbody", "geom", "material", "material"},
    MjcfReference{"worldbody", "site", "material", "material"},
    MjcfReference{"worldbody", "site", "mesh", "mesh"},
    MjcfReference{"worldbody", "camera", "target", "body", EmptyName::kNone},
    MjcfReference{"worldbody", "light", "target", "body", EmptyName::kNone},
    MjcfReference{"worldbody", "attach", "model", "model"},
    MjcfReference{"asset", "material", "texture", "texture"},
    MjcfReference{"asset", "bone", "body", "body"},
    MjcfReference{"asset", "skin", "material", "material"},
    MjcfReference{"deformable", "bone", "body", "body"},
    MjcfReference{"deformable", "skin", "material", "material"},
};

/// What kind of name an element of a section declares; empty for none.
std::string_view declared_kind(std::string_view section, std::string_view tag) {
  if (section == "worldbody") {
    if (tag == "freejoint") return "joint";
    for (const std::string_view kind :
         {"body", "joint", "geom", "site", "camera", "light", "frame"}) {
      if (tag == kind) return kind;
    }
    return {};
  }
  if (section == "custom" || section == "contact") return tag;
  if (section == "asset")
    return tag == "model" ? std::string_view() : tag;  // two may be called alike
  if (section == "actuator" || section == "sensor" || section == "equality") return section;
  if (section == "tendon" && (tag == "spatial" || tag == "fixed")) return section;
  if (section == "keyframe") return "key";
  return {};
}

/// All elements below the root with the section that they are in, bounded by the depth of XML.
void walk_elements(const MjcfTree& tree, xml::Element parent, std::string_view section,
                   const std::function<void(std::string_view, xml::Element)>& use) {
  for (const xml::Element child : tree.children(parent)) {
    use(section, child);
    walk_elements(tree, child, section, use);
  }
}

std::vector<std::string> names_of_kind(const MjcfNames& names, std::string_view kind) {
  const auto found = names.find(kind);
  if (found == names.end()) return {};
  return {found->second.begin(), found->second.end()};
}

std::string default_name(xml::Element element) {
  const std::string file = mjcf_name(element, "file").value;
  const std::size_t slash = file.find_last_of("/\\");
  const std::string last = slash == file.npos ? file : file.substr(slash + 1);
  return last.substr(0, last.rfind('.'));
}

/// The innermost `<replicate>` around an element, whose copies have names of their own.
std::optional<xml::Element> replicate_around(xml::Element element) {
  auto above = element.parent();
  while (above && above->name() != "replicate") above = above->parent();
  return above;
}

/// Names that attached files, recipes and copies may make.
class MadeNames {
 public:
  explicit MadeNames(const MjcfScope& scope) {
    for_each_in_bodies(scope, [&](xml::Element element, std::size_t) {
      const std::string_view tag = element.name();
      const bool made = tag == "attach" || tag == "composite" || tag == "flexcomp";
      if (made) prefixes_.push_back(text_of(element, tag == "flexcomp" ? "name" : "prefix"));
      // A copy's name is that of the original, and more.
      if (!replicate_around(element)) return;
      const std::string name = text_of(element, "name");
      if (!name.empty()) prefixes_.push_back(name);
    });
  }

  bool may_hold(std::string_view name) const {
    return std::any_of(prefixes_.begin(), prefixes_.end(),
                       [&](const std::string& prefix) { return name.starts_with(prefix); });
  }

 private:
  static std::string text_of(xml::Element element, std::string_view attribute) {
    return mjcf_name(element, attribute).value;
  }

  std::vector<std::string> prefixes_;
};

/// Names that there are, for the first so many that are missing: a list for each would fill the memory.
class MjcfCandidates {
 public:
  template <class Names>
  std::vector<std::string> next(const Names& names) {
    constexpr std::size_t kMaxWithCandidates = 50;
    return ++asked_ <= kMaxWithCandidates ? names() : std::vector<std::string>();
  }

 private:
  std::size_t asked_ = 0;
};

void check_class(const MjcfScope& scope, xml::Element element, const char* attribute,
                 MjcfCandidates& candidates, MjcfFacts& facts) {
  const auto name = mjcf_name(element, attribute);
  if (!name.written || scope.defaults.find(name.value)) return;
  facts.push_back({.kind = MjcfFactKind::kClassMissing,
                   .where = name.span,
                   .name = name.value,
                   .candidates = candidates.next([&] { return scope.defaults.names(); })});
}

bool is_asset_kind(std::string_view kind) {
  return kind == "mesh" || kind == "material" || kind == "texture" || kind == "hfield";
}

}  // namespace

void for_each_mjcf_element(const MjcfTree& tree,
                           const std::function<void(std::string_view, xml::Element)>& use) {
  for (const xml::Element section : tree.children(tree.root())) {
    // MuJoCo ignores a body that is no part of the world.
    if (section.name() != "body") walk_elements(tree, section, section.name(), use);
  }
}

std::size_t mjcf_class_of(const MjcfScope& scope, xml::Element element, std::size_t around) {
  const auto name = mjcf_name(element, "class");
  if (!name.written) return around;
  return scope.defaults.find(name.value).value_or(around);
}

namespace {

bool has_world(const MjcfTree& tree) { return !tree.in_sections("worldbody").empty(); }

/// Of a part of a model that is to be included: the first name that it takes from elsewhere.
void check_part(const MjcfFact& missing, MjcfFacts& facts) {
  const bool known = std::any_of(facts.begin(), facts.end(), [](const MjcfFact& fact) {
    return fact.kind == MjcfFactKind::kPartAlone;
  });
  if (known) return;
  facts.push_back(missing);
  facts.back().kind = MjcfFactKind::kPartAlone;
}

}  // namespace

bool makes_names(const MjcfScope& scope) {
  bool makes = false;
  for_each_mjcf_element(scope.tree, [&](std::string_view section, xml::Element element) {
    const std::string_view tag = element.name();
    makes = makes || (section == "worldbody" && (tag == "attach" || tag == "composite" ||
                                                 tag == "flexcomp" || tag == "replicate"));
    makes = makes || (section == "asset" && tag == "model");
  });
  // Sensors or actuators without a world are a part of a model, to be included.
  return makes || !has_world(scope.tree);
}

MjcfNames check_mjcf_names(const MjcfScope& scope, MjcfFacts& facts) {
  MjcfNames names;
  std::map<std::tuple<std::string, SourceId, std::uint32_t, std::string>, Span> first;
  names["body"].insert("world");
  first.try_emplace({"body", kNoSource, 0, "world"}, Span());
  for (const auto& [name, element] : scope.assets.models) names["model"].insert(name);
  for_each_mjcf_element(scope.tree, [&](std::string_view section, xml::Element element) {
    const std::string_view kind = declared_kind(section, element.name());
    if (kind.empty()) return;
    auto name = mjcf_name(element, "name");
    const bool nested = section != "worldbody" && element.parent()->name() != section &&
                        element.parent()->name() != "mujocoinclude" &&
                        element.parent()->name() != "mujoco";
    if (nested) return;
    if (name.value.empty() && section == "asset") {
      name.value = default_name(element);
      name.span = element.tag_span();
    }
    if (name.value.empty()) return;
    const auto copied = replicate_around(element);
    if (!copied) names[std::string(kind)].insert(name.value);
    // Names of copies are apart from those of others.
    const Span group = copied ? copied->tag_span() : Span();
    const auto [known, is_new] =
        first.try_emplace({std::string(kind), group.source, group.begin, name.value}, name.span);
    if (is_new) return;
    facts.push_back({.kind = MjcfFactKind::kNameRepeated,
                     .where = name.span,
                     .name = name.value,
                     .detail = std::string(kind),
                     .related = known->second});
  });
  return names;
}

void check_mjcf_references(const MjcfScope& scope, const MjcfNames& names, MjcfFacts& facts) {
  const MadeNames made(scope);
  const bool part = !has_world(scope.tree);
  MjcfCandidates candidates;
  const auto check = [&](const model::Field<std::string>& name, std::string_view kind,
                         EmptyName empty = EmptyName::kRejected) {
    const bool asset = is_asset_kind(kind);
    if (!name.written || (name.value.empty() && (asset || empty == EmptyName::kNone))) return;
    const auto known = names.find(kind);
    if (known != names.end() && known->second.contains(name.value)) return;
    const auto missing = [&] {
      return MjcfFact{.kind = MjcfFactKind::kReferenceMissing,
                      .where = name.span,
                      .name = name.value,
                      .detail = std::string(kind),
                      .candidates = candidates.next([&] { return names_of_kind(names, kind); })};
    };
    if (part && !asset && kind != "model") {
      check_part(missing(), facts);
    } else if (asset || kind == "model" || !made.may_hold(name.value)) {
      facts.push_back(missing());
    }
  };
  for_each_mjcf_element(scope.tree, [&](std::string_view section, xml::Element element) {
    if (section != "default" || element.name() != "default") {
      check_class(scope, element, "class", candidates, facts);
    }
    check_class(scope, element, "childclass", candidates, facts);
    for (const MjcfReference& one : kMjcfReferences) {
      if (one.section != section) continue;
      if (!one.tag.empty() && one.tag != element.name()) continue;
      check(mjcf_name(element, one.attribute), one.kind, one.empty);
    }
    if (section != "sensor" && section != "custom") return;
    for (const auto& [type_name, name] :
         {std::pair{"objtype", "objname"}, {"reftype", "refname"}}) {
      const std::string type = mjcf_name(element, type_name).value;
      if (!type.empty()) check(mjcf_name(element, name), type == "xbody" ? "body" : type);
    }
  });
  // What a class names is missing where an element takes it.
  std::set<std::pair<SourceId, std::uint32_t>> reported;
  const auto check_default = [&](const MjcfValues& values, const char* attribute) {
    if (values.own(attribute)) return;
    const auto name = values.string(attribute);
    if (name.written && reported.insert({name.span.source, name.span.begin}).second) {
      check(name, attribute);
    }
  };
  for_each_in_bodies(scope, [&](xml::Element element, std::size_t class_id) {
    const std::string_view tag = element.name();
    if (tag != "geom" && tag != "site") return;
    const MjcfValues values = scope.defaults.values(element, tag, class_id);
    check_default(values, "material");
    check_default(values, "mesh");
  });
  for (const xml::Element element : scope.tree.in_sections("tendon")) {
    const std::size_t id = mjcf_class_of(scope, element, MjcfDefaults::kMain);
    check_default(scope.defaults.values(element, "tendon", id), "material");
  }
}

void check_mjcf_assets(const MjcfScope& scope, const Disk& disk, MjcfFacts& facts) {
  const auto path_of = [&](xml::Element element, std::string_view folder,
                           const model::Field<std::string>& file) {
    return join_path(parent_path(scope.tree.path_of(element)),
                     mjcf_asset_path(scope.tree, scope.settings, element, folder, file.value));
  };
  for (const xml::Element element : scope.tree.in_sections("asset")) {
    const std::string_view tag = element.name();
    const std::string& folder =
        tag == "texture" ? scope.settings.texture_folder : scope.settings.mesh_folder;
    for (const char* attribute :
         {"file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback"}) {
      const auto file = mjcf_name(element, attribute);
      if (!file.written || file.value.empty()) continue;
      std::string path = path_of(element, tag == "model" ? "" : folder, file);
      if (disk.kind(path) == PathKind::kFile) continue;
      facts.push_back({.kind = MjcfFactKind::kAssetMissing,
                       .where = file.span,
                       .name = file.value,
                       .detail = std::string(tag),
                       .path = std::move(path)});
    }
    if (tag != "mesh") continue;
    const bool has_shape = element.attribute("file") || element.attribute("vertex") ||
                           element.attribute("builtin") || element.child("plugin");
    if (!has_shape) {
      facts.push_back({.kind = MjcfFactKind::kMeshEmpty,
                       .where = element.tag_span(),
                       .name = mjcf_name(element, "name").value});
    }
  }
  for (const auto& [name, mesh] : scope.assets.meshes) {
    if (mesh.sheared) {
      facts.push_back({.kind = MjcfFactKind::kMeshSheared, .where = mesh.site.tag, .name = name});
    }
    const model::Vector3& s = mesh.mesh.scale.value;
    if (s.x != 0 && s.y != 0 && s.z != 0) continue;
    facts.push_back(
        {.kind = MjcfFactKind::kMeshScaleZero, .where = mesh.mesh.scale.span, .name = name});
  }
}

}  // namespace rigor::read
