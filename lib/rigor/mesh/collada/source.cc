// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/collada/source.h>

#include <algorithm>
#include <optional>
#include <utility>

#include <rigor/mesh/text_cursor.h>

namespace rigor::mesh {
namespace {

using xml::Element;

// Of a color's numbers, those that it cannot do without.
constexpr std::size_t kOpaque = 3;

ColladaNumbers accessed_numbers(Element array, Element accessor, std::size_t width) {
  const std::uint64_t stride = count_of(accessor, "stride").value_or(1);
  const std::uint64_t offset = count_of(accessor, "offset").value_or(0);
  const std::uint64_t count = count_of(accessor, "count").value_or(0);
  const std::uint64_t size = array.text().size();
  if (stride < std::min(width, kOpaque)) {
    return {{}, size, "an item of a source has too few numbers"};
  }
  const std::uint64_t held = std::min<std::uint64_t>(stride, width);
  std::vector<double> numbers;
  std::uint64_t items = 0;
  TextCursor cursor(array.text());
  cursor.skip_space();
  for (std::uint64_t i = 0; !cursor.at_end() && items < count; ++i) {
    const std::optional<double> number = cursor.number();
    if (!number || cursor.decimal_commas().count > 0) {
      return {{}, size, "a number of a source is none"};
    }
    cursor.skip_space();
    if (i < offset) continue;
    const std::uint64_t place = (i - offset) % stride;
    if (place < held) numbers.push_back(*number);
    if (place + 1 != held) continue;
    numbers.resize(++items * width, 1);
  }
  numbers.resize(items * width);  // the last item may be cut
  if (array.lost_text().size() > 0) return {{}, size, "the numbers of a source are interrupted"};
  return {std::move(numbers), size};
}

}  // namespace

ColladaNumbers read_collada_source(const ColladaIndex& index, std::string_view url,
                                   std::size_t width) {
  const std::optional<Element> source = index.find(url, "source");
  const auto accessor = source ? descend(*source, {"technique_common", "accessor"}) : std::nullopt;
  const auto array =
      accessor ? index.find(value(*accessor, "source"), "float_array") : std::nullopt;
  if (!array) return {{}, 0, "an input leads to no numbers"};
  return accessed_numbers(*array, *accessor, width);
}

}  // namespace rigor::mesh
