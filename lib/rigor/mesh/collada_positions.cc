// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collada_positions.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include <rigor/mesh/text_cursor.h>

namespace rigor::mesh {
namespace {

using xml::Element;

std::optional<Element> accessor_of(const ColladaIndex& index, std::string_view vertices) {
  const std::optional<Element> element = index.find(vertices, "vertices");
  if (!element) return std::nullopt;
  for (const Element input : element->children()) {
    if (value(input, "semantic") != "POSITION") continue;
    const std::optional<Element> source = index.find(value(input, "source"), "source");
    return source ? descend(*source, {"technique_common", "accessor"}) : std::nullopt;
  }
  return std::nullopt;
}

/// The first three numbers of each stride.
ColladaPositions points(Element array, Element accessor) {
  const std::uint64_t stride = count_of(accessor, "stride").value_or(1);
  const std::uint64_t offset = count_of(accessor, "offset").value_or(0);
  const std::uint64_t count = count_of(accessor, "count").value_or(0);
  const std::uint64_t size = array.text().size();
  if (stride < 3) return {{}, size, "a position has fewer than three numbers"};
  std::vector<Vector3> points;
  std::array<double, 3> p{};
  TextCursor cursor(array.text());
  cursor.skip_space();
  for (std::uint64_t i = 0; !cursor.at_end() && points.size() < count; ++i) {
    const std::optional<double> number = cursor.number();
    if (!number || cursor.decimal_commas().count > 0)
      return {{}, size, "a coordinate is no number"};
    cursor.skip_space();
    if (i < offset) continue;
    const std::uint64_t axis = (i - offset) % stride;
    if (axis < 3) p[axis] = *number;
    if (axis == 2) points.push_back({p[0], p[1], p[2]});
  }
  if (array.lost_text().size() > 0) return {{}, size, "the coordinates are interrupted"};
  return {std::move(points), size};
}

}  // namespace

ColladaPositions read_collada_positions(const ColladaIndex& index, std::string_view vertices) {
  const std::optional<Element> accessor = accessor_of(index, vertices);
  const auto array =
      accessor ? index.find(value(*accessor, "source"), "float_array") : std::nullopt;
  if (!array) return {{}, 0, "the vertices have no positions"};
  return points(*array, *accessor);
}

}  // namespace rigor::mesh
