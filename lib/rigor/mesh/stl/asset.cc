// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

#include <rigor/mesh/asset/readers.h>
#include <rigor/mesh/line_counter.h>
#include <rigor/mesh/stl/stl.h>
#include <rigor/mesh/text_cursor.h>

namespace rigor::mesh {
namespace {

constexpr std::size_t kHeaderTextBytes = 80;
constexpr std::size_t kAttributeOffset = 48;
constexpr std::size_t kFacetsAtOnce = 4096;

// A facet lower than this part of its longest edge has no normal that floats could tell: its corners
// have 24 bits, and a normal that was computed in another order may point anywhere.
constexpr double kNoNormal = 1e-4;

float float_at(const char* bytes) {
  std::uint32_t bits = 0;
  for (int i = 3; i >= 0; --i) bits = bits << 8U | static_cast<unsigned char>(bytes[i]);
  return std::bit_cast<float>(bits);
}

/// What the header says up to its zeros.
std::string header_text(std::string_view header) {
  return std::string(header.substr(0, header.find('\0')));
}

bool is_contrary(const Vector3& normal, const Facet& f) {
  const Vector3 up = area_vector(f);
  const double longest = std::max({dot(f[1] - f[0], f[1] - f[0]), dot(f[2] - f[0], f[2] - f[0]),
                                   dot(f[2] - f[1], f[2] - f[1])});
  return length(up) > kNoNormal * longest && dot(normal, up) < 0;
}

void judge_normal(StlFacts& facts, const Vector3& normal, const Facet& corners,
                  std::uint64_t place) {
  const double size = dot(normal, normal);
  if (!std::isfinite(size)) {
    facts.odd_normals.add(place);
  } else if (size == 0) {
    facts.zero_normals.add(place);
  } else if (is_contrary(normal, corners)) {
    facts.contrary_normals.add(place);
  }
}

void judge_facet(StlFacts& facts, const char* bytes, std::uint64_t place) {
  const Vector3 normal{float_at(bytes), float_at(bytes + 4), float_at(bytes + 8)};
  judge_normal(facts, normal, stl_facet(bytes), place);
  if (bytes[kAttributeOffset] != 0 || bytes[kAttributeOffset + 1] != 0) {
    facts.attributes.add(place);
  }
}

/// The text form, read as loosely as can be: a normal, then its three corners.
class AsciiReader {
 public:
  explicit AsciiReader(std::string_view bytes) : cursor_(bytes), lines_(bytes) {}

  StlFacts run() {
    if (cursor_.accept("solid")) facts_.header = cursor_.rest_of_line();
    for (cursor_.skip_space(); !cursor_.at_end(); cursor_.skip_space()) {
      if (cursor_.accept("facet")) {
        facet();
      } else if (cursor_.accept("solid") || cursor_.accept("endsolid")) {
        cursor_.skip_line();  // a name that may be any word
      } else {
        pass_word();
      }
    }
    return std::move(facts_);
  }

 private:
  void facet() {
    ++facts_.facets;
    const std::size_t at = cursor_.offset();
    const std::optional<Vector3> normal = cursor_.accept("normal") ? vector() : std::nullopt;
    Facet corners;
    while (!cursor_.at_end() && !cursor_.sees("vertex") && !cursor_.sees("endfacet")) pass_word();
    for (Vector3& corner : corners) {
      const std::optional<Vector3> read = cursor_.accept("vertex") ? vector() : std::nullopt;
      if (!read) return;
      corner = *read;
    }
    const std::uint64_t line = lines_.at(at);
    if (normal) {
      judge_normal(facts_, *normal, corners, line);
    } else {
      facts_.odd_normals.add(line);
    }
  }

  /// A stray backslash, which the cursor takes for no word, ends the line.
  void pass_word() {
    if (cursor_.word().empty()) cursor_.skip_line();
  }

  std::optional<Vector3> vector() {
    Vector3 v;
    for (double* part : {&v.x, &v.y, &v.z}) {
      const std::optional<double> number = cursor_.number();
      if (!number) return std::nullopt;
      *part = *number;
    }
    return v;
  }

  TextCursor cursor_;
  StlFacts facts_;
  LineCounter lines_;
};

}  // namespace

StlFacts binary_stl_facts(const OpenFile& file) {
  std::string header(kStlHeaderBytes, '\0');
  header.resize(file.read(0, header.data(), header.size()));
  StlFacts facts{.header = header_text(std::string_view(header).substr(0, kHeaderTextBytes)),
                 .binary = true,
                 .solid_header = header.starts_with("solid"),
                 .color_header = header.find("COLOR=") != std::string::npos};
  facts.facets = stl_triangles(header, file.size());
  std::string piece;
  for (std::uint64_t first = 0; first < facts.facets; first += kFacetsAtOnce) {
    const std::uint64_t wanted = std::min<std::uint64_t>(kFacetsAtOnce, facts.facets - first);
    piece.resize(static_cast<std::size_t>(wanted) * kStlFacetBytes);
    const std::uint64_t at = kStlHeaderBytes + first * kStlFacetBytes;
    const std::size_t held = file.read(at, piece.data(), piece.size()) / kStlFacetBytes;
    for (std::size_t i = 0; i < held; ++i) {
      judge_facet(facts, piece.data() + i * kStlFacetBytes, first + i + 1);
    }
    if (held < wanted) break;
  }
  return facts;
}

StlFacts ascii_stl_facts(std::string_view bytes) { return AsciiReader(bytes).run(); }

}  // namespace rigor::mesh
