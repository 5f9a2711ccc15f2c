// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/obj/obj.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <rigor/mesh/normals.h>
#include <rigor/mesh/obj/materials.h>
#include <rigor/mesh/text_cursor.h>
#include <rigor/text/path.h>

namespace rigor::mesh {
namespace {

// More parts are refused: each repeats its names, so a file that switches often between long ones
// would take more memory than any mesh.
constexpr std::size_t kMaxParts = 1'000'000;

// As many as 32 bits can tell apart.
constexpr std::uint64_t kAnyNumber = std::uint64_t{1} << 32U;

// So many lines with names of libraries are examined, and so many names in each. Among 60 real
// files that name any, none names two.
constexpr std::size_t kMaxLibraries = 4;

constexpr std::uint32_t kNothing = 0xffffffffU;

/// As the file has it: from 1 on, or from the last one back; 0 for none.
using ObjNumber = std::int64_t;

/// The part of a corner before the next slash, which is passed over.
ObjNumber take_number(std::string_view& corner) {
  ObjNumber number = 0;
  const auto [end, error] = std::from_chars(corner.data(), corner.data() + corner.size(), number);
  const std::size_t slash = corner.find('/');
  corner.remove_prefix(slash == std::string_view::npos ? corner.size() : slash + 1);
  return error == std::errc() ? number : 0;
}

/// What a file lists, and which of it each triangle's corners name. Takes no memory for what a file
/// does not have.
template <class Value>
class Listed {
 public:
  std::size_t size() const { return values_.size(); }
  void add(const Value& value) { values_.push_back(value); }

  std::uint32_t index_of(ObjNumber number) const {
    const auto size = static_cast<ObjNumber>(values_.size());
    const ObjNumber index = number < 0 ? size + number : number - 1;
    return index >= 0 && index < ObjNumber{kNothing} ? static_cast<std::uint32_t>(index) : kNothing;
  }

  void name(std::size_t triangle, const Triangle& corners) {
    if (corners == Triangle{kNothing, kNothing, kNothing}) return;
    of_triangle_.resize(triangle, Triangle{kNothing, kNothing, kNothing});
    of_triangle_.push_back(corners);
  }

  /// Empty when no corner names any that there is.
  std::vector<std::array<Value, 3>> of_corners(std::size_t triangles) const {
    std::vector<std::array<Value, 3>> all;
    if (!any_exists()) return all;
    all.resize(triangles);
    for (std::size_t i = 0; i < of_triangle_.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t index = of_triangle_[i][c];
        if (index < values_.size()) all[i][c] = values_[index];
      }
    }
    return all;
  }

 private:
  bool any_exists() const {
    return std::any_of(of_triangle_.begin(), of_triangle_.end(), [this](const Triangle& t) {
      return std::min({t[0], t[1], t[2]}) < values_.size();
    });
  }

  std::vector<Value> values_;
  std::vector<Triangle> of_triangle_;  ///< up to the last that names any
};

class ObjReader {
 public:
  /// `vertices` is how many the file has: faces may name some that come later.
  ObjReader(std::string_view bytes, std::uint64_t vertices)
      : bytes_(bytes), cursor_(bytes), vertices_(vertices) {}

  /// What `mtllib` names, a file or several.
  const std::vector<std::string>& libraries() const { return libraries_; }

  LoadedMesh run() {
    for (; loaded_.faults.empty() && !cursor_.at_end(); cursor_.skip_line()) statement();
    if (loaded_.faults.empty()) {
      // Now their number is known: once more, to count and find the faces that were wrong.
      if (used_ > mesh_.positions.size()) return ObjReader(bytes_, mesh_.positions.size()).run();
      judge();
    }
    if (loaded_.usable()) {
      dress_corners();
      loaded_.mesh = std::move(mesh_);
    } else if (loaded_.faults.size() == 1 && loaded_.faults[0].kind == FaultKind::kEmpty) {
      loaded_.mesh.positions = std::move(mesh_.positions);  // of which a reader may make the hull
    }
    return std::move(loaded_);
  }

 private:
  struct Corner {
    std::uint32_t position;
    std::uint32_t texture;
    std::uint32_t normal;
  };

  void statement() {
    cursor_.skip_blanks();
    const std::string_view word = cursor_.word();
    if (word == "v") {
      vertex();
    } else if (word == "vt") {
      texture_point();
    } else if (word == "vn") {
      normal();
    } else if (word == "f") {
      face();
    } else if (word == "o" || word == "g") {
      name_ = cursor_.rest_of_line().substr(0, kMaxObjNameBytes);
      part_named_ = true;
    } else if (word == "usemtl") {
      material_ = cursor_.rest_of_line().substr(0, kMaxObjNameBytes);
      part_named_ = true;
    } else if (word == "mtllib") {
      if (libraries_.size() < kMaxLibraries) libraries_.emplace_back(cursor_.rest_of_line());
    } else if (word == "l" || word == "p" || word == "curv" || word == "curv2" || word == "surf") {
      not_triangles_.add(cursor_.offset());
    }
  }

  void vertex() {
    if (mesh_.positions.size() == kMaxTriangles) {
      return stop(FaultKind::kTooLarge, "over 50 million vertices");
    }
    Vector3 p;
    for (double* coordinate : {&p.x, &p.y, &p.z}) {
      const std::optional<double> number = cursor_.number();
      if (!number) return stop(FaultKind::kMalformed, "a vertex has no three numbers");
      *coordinate = *number;
      if (!std::isfinite(*number)) not_finite_.add(cursor_.offset());
    }
    mesh_.positions.push_back(p);
    cursor_.skip_blanks();
    if (!cursor_.at_line_end()) color();
  }

  /// Three numbers behind a vertex; one is a weight, which does not matter to polygons.
  void color() {
    Corners::Color color = kWhite;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::optional<double> number = cursor_.number();
      if (!number || !std::isfinite(*number)) return;
      color[i] = static_cast<float>(*number);
    }
    colors_.resize(mesh_.positions.size() - 1, kWhite);
    colors_.push_back(color);
  }

  /// The third number, of a texture in space, is left out; missing ones are 0.
  void texture_point() {
    if (texture_.size() == kMaxTriangles) {
      return stop(FaultKind::kTooLarge, "over 50 million texture points");
    }
    const double u = finite_number();
    const double v = finite_number();
    texture_.add({static_cast<float>(u), static_cast<float>(v)});
  }

  void normal() {
    if (normals_.size() == kMaxTriangles) {
      return stop(FaultKind::kTooLarge, "over 50 million normals");
    }
    const double x = finite_number();
    const double y = finite_number();
    const double z = finite_number();
    normals_.add(normal_along({x, y, z}));
  }

  /// 0 for what is none, and for what no float can hold.
  double finite_number() {
    const double number = cursor_.number().value_or(0);
    return std::abs(number) <= double{std::numeric_limits<float>::max()} ? number : 0;
  }

  void face() {
    std::array<Corner, 3> triangle{};
    std::size_t corners = 0;
    for (cursor_.skip_blanks(); !cursor_.at_line_end(); cursor_.skip_blanks()) {
      const std::optional<Corner> read = corner();
      if (!read) return stop(FaultKind::kMalformed, "a face has a corner that is no index");
      triangle[std::min<std::size_t>(corners, 2)] = *read;
      if (++corners < 3) continue;
      if (!append(triangle)) return;
      triangle[1] = triangle[2];
    }
    if (corners < 3) not_triangles_.add(cursor_.offset());
  }

  /// `7`, `7/1`, `7/1/2` or `7//2`; -1 is the last one so far.
  std::optional<Corner> corner() {
    const std::optional<std::int64_t> written = cursor_.whole_number();
    std::string_view rest = cursor_.word();
    if (!written || !(rest.empty() || rest.front() == '/')) return std::nullopt;
    // What would be before the first vertex wraps to above all.
    const std::uint64_t before = *written < 0 ? mesh_.positions.size() : std::uint64_t{0} - 1;
    const std::uint64_t index = before + static_cast<std::uint64_t>(*written);
    if (index >= vertices_) out_of_range_.add(cursor_.offset());
    if (index < vertices_) used_ = std::max(used_, index + 1);
    Corner corner{static_cast<std::uint32_t>(index), kNothing, kNothing};
    if (rest.empty()) return corner;
    rest.remove_prefix(1);
    corner.texture = texture_.index_of(take_number(rest));
    corner.normal = normals_.index_of(take_number(rest));
    return corner;
  }

  bool append(const std::array<Corner, 3>& t) {
    std::vector<Part>& parts = mesh_.parts;
    if (parts.empty() ||
        (part_named_ && (parts.back().name != name_ || parts.back().material != material_))) {
      parts.push_back({name_, material_, mesh_.triangles.size()});
    }
    part_named_ = false;
    texture_.name(mesh_.triangles.size(), {t[0].texture, t[1].texture, t[2].texture});
    normals_.name(mesh_.triangles.size(), {t[0].normal, t[1].normal, t[2].normal});
    mesh_.triangles.push_back({t[0].position, t[1].position, t[2].position});
    ++parts.back().count;
    if (mesh_.triangles.size() > kMaxTriangles) {
      stop(FaultKind::kTooLarge, "over 50 million triangles");
    } else if (parts.size() > kMaxParts) {
      stop(FaultKind::kTooLarge, "over a million parts");
    }
    return loaded_.faults.empty();
  }

  void stop(FaultKind kind, const char* detail) {
    loaded_.faults.push_back({kind, detail, 0, line_at(bytes_, cursor_.offset())});
  }

  /// At the end, as faces may come before what they name.
  void dress_corners() {
    Corners& corners = mesh_.corners;
    corners.texture = texture_.of_corners(mesh_.triangles.size());
    corners.normals = normals_.of_corners(mesh_.triangles.size());
    if (colors_.empty()) return;
    colors_.resize(mesh_.positions.size(), kWhite);
    corners.colors.reserve(mesh_.triangles.size());
    for (const Triangle& t : mesh_.triangles) {
      corners.colors.push_back({colors_[t[0]], colors_[t[1]], colors_[t[2]]});
    }
  }

  void judge() {
    const auto add = [this](FaultKind kind, const Tally& tally) {
      if (tally.count > 0) loaded_.faults.push_back(fault_at(tally, kind, bytes_));
    };
    add(FaultKind::kIndexOutOfRange, out_of_range_);
    add(FaultKind::kNotFinite, not_finite_);
    if (mesh_.triangles.empty()) loaded_.faults.push_back({FaultKind::kEmpty});
    add(FaultKind::kNotTriangles, not_triangles_);
    add(FaultKind::kDecimalComma, cursor_.decimal_commas());
  }

  std::string_view bytes_;
  TextCursor cursor_;
  std::uint64_t vertices_;
  std::uint64_t used_ = 0;  ///< the highest number of a vertex that a face names
  LoadedMesh loaded_{.format = Format::kObj};
  TriangleMesh mesh_;
  Listed<Corners::Texture> texture_;
  Listed<Corners::Normal> normals_;
  std::vector<Corners::Color> colors_;  ///< of vertices, up to the last that has one
  std::vector<std::string> libraries_;
  std::string name_;
  std::string material_;
  bool part_named_ = false;  ///< since the last face
  Tally out_of_range_;
  Tally not_finite_;
  Tally not_triangles_;
};

/// Nothing outside the folder: a mesh from elsewhere must not name the user's files.
std::optional<std::string> read_beside(const Disk& disk, const std::string& folder,
                                       const std::string& name) {
  const std::string path = join_path(folder, name);
  const bool inside = folder == "."   ? !is_absolute(path) && !path.starts_with("..")
                      : folder == "/" ? true
                                      : path.starts_with(folder + '/');
  return inside ? disk.read(path, kMaxObjMaterialBytes).bytes : std::nullopt;
}

/// Of the files that a line names: one, whose name may have blanks, or several between blanks.
std::vector<std::string> read_libraries(const Disk& disk, const std::string& folder,
                                        const std::string& names) {
  if (std::optional<std::string> bytes = read_beside(disk, folder, names)) return {*bytes};
  std::vector<std::string> all;
  TextCursor cursor(names);
  for (std::size_t i = 0; i < kMaxLibraries; ++i) {
    cursor.skip_space();
    const std::string name(cursor.word());
    if (name.empty()) break;
    if (std::optional<std::string> bytes = read_beside(disk, folder, name)) all.push_back(*bytes);
  }
  return all;
}

/// Those that parts name and libraries tell of, in the order of the parts.
std::vector<Material> used_materials(const std::vector<Part>& parts,
                                     std::map<std::string, Material> known) {
  std::vector<Material> used;
  for (const Part& part : parts) {
    if (auto found = known.extract(part.material)) used.push_back(std::move(found.mapped()));
  }
  return used;
}

}  // namespace

LoadedMesh read_obj(std::string_view bytes) { return ObjReader(bytes, kAnyNumber).run(); }

LoadedMesh read_obj(std::string_view bytes, const Disk& disk, const std::string& path) {
  ObjReader reader(bytes, kAnyNumber);
  LoadedMesh loaded = reader.run();
  if (!loaded.usable()) return loaded;
  const std::string folder = normalize_path(parent_path(path));
  std::map<std::string, Material> known;
  for (const std::string& names : reader.libraries()) {
    for (const std::string& library : read_libraries(disk, folder, names)) {
      for (Material& material : read_obj_materials(library)) {
        known.try_emplace(material.name, material);
      }
    }
  }
  loaded.mesh.materials = used_materials(loaded.mesh.parts, std::move(known));
  return loaded;
}

}  // namespace rigor::mesh
