// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/mjcf/gmsh.h>

#include <charconv>
#include <optional>

#include <rigor/read/values.h>

namespace rigor::read {
namespace {

/// Far more than a file that is read can hold, and far from where adding to it overflows.
constexpr long long kMaxGmshTag = 1LL << 40U;

/// The numbers of a section, one after another.
class GmshNumbers {
 public:
  explicit GmshNumbers(std::string_view text) : text_(text) {}

  template <class Number>
  std::optional<Number> next() {
    while (!text_.empty() && is_space(text_.front())) text_.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), number);
    if (error != std::errc()) return std::nullopt;
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return number;
  }
  std::optional<long long> whole() { return next<long long>(); }
  bool skip(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (!next<double>()) return false;
    }
    return true;
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

  std::string_view text_;
};

/// What is between `$NAME` and `$EndNAME`.
std::optional<std::string_view> section_of(std::string_view bytes, const std::string& name) {
  const std::size_t begin = bytes.find("$" + name);
  if (begin == bytes.npos) return std::nullopt;
  const std::size_t end = bytes.find("$End" + name, begin);
  if (end == bytes.npos) return std::nullopt;
  const std::size_t after = begin + name.size() + 1;
  return bytes.substr(after, end - after);
}

std::string_view first_line(std::string_view section) {
  const std::size_t begin = section.find_first_not_of("\r\n");
  if (begin == section.npos) return {};
  const std::string_view rest = section.substr(begin);
  return trimmed(rest.substr(0, rest.find('\n')));
}

bool is_count(std::string_view line) {
  return !line.empty() && line.find_first_not_of("0123456789") == line.npos;
}

std::string problem_22(std::string_view nodes, std::string_view elements) {
  if (!is_count(first_line(nodes))) return "$Nodes does not begin with the number of nodes";
  GmshNumbers points(nodes);
  const long long count = points.whole().value_or(-1);
  if (count < 0) return "$Nodes has no number of nodes that is read";
  for (long long i = 0; i < count; ++i) {
    if (!points.skip(4))
      return "$Nodes has fewer nodes than the " + std::to_string(count) + " that it announces";
  }
  if (!is_count(first_line(elements)))
    return "$Elements does not begin with the number of elements";
  GmshNumbers parts(elements);
  const long long part_count = parts.whole().value_or(-1);
  if (part_count < 0) return "$Elements has no number of elements that is read";
  long long corners = 0;
  for (long long i = 0; i < part_count; ++i) {
    const auto tag = parts.whole();
    const auto type = parts.whole();
    const auto tags = parts.whole();
    const std::string fewer = "$Elements has fewer elements than the " +
                              std::to_string(part_count) + " that it announces";
    if (!tag || !type || !tags) return fewer;
    // The type of the first element counts for all.
    if (i == 0) corners = *type == 2 ? 3 : *type == 4 ? 4 : 0;
    if (corners == 0) return "its elements are neither triangles nor tetrahedra";
    if (*tags > 0 && !parts.skip(2)) return fewer;
    for (long long k = 0; k < corners; ++k) {
      const auto node = parts.whole();
      if (!node) return fewer;
      if (*node < 1 || *node > count)
        return "element " + std::to_string(*tag) + " has the node " + std::to_string(*node) +
               ", which does not exist";
    }
  }
  return {};
}

/// The first line of a section of version 4.1, and that of its only block.
struct GmshBlock {
  long long blocks = 0, count = 0, least_tag = 0, last_tag = 0, dimension = 0, type = 0,
            in_block = 0;
};

std::optional<GmshBlock> read_block(GmshNumbers& numbers) {
  GmshBlock block;
  long long entity = 0;
  for (long long* field : {&block.blocks, &block.count, &block.least_tag, &block.last_tag,
                           &block.dimension, &entity, &block.type, &block.in_block}) {
    const auto number = numbers.whole();
    if (!number) return std::nullopt;
    *field = *number;
  }
  return block;
}

std::string problem_41(std::string_view nodes, std::string_view elements) {
  GmshNumbers points(nodes);
  const auto node = read_block(points);
  if (!node) return "the header of $Nodes is not eight numbers";
  if (node->blocks != 1 || node->count != node->in_block) return "$Nodes is not a single block";
  if (node->last_tag != node->in_block)
    return "the last node has the tag " + std::to_string(node->last_tag) +
           ", where the block has " + std::to_string(node->in_block) + " nodes";
  if (node->dimension < 1 || node->dimension > 3)
    return "its nodes are of no entity of 1, 2 or 3 dimensions";
  if (node->least_tag < 0 || node->least_tag > kMaxGmshTag) {
    return "the tag of its first node is out of range";
  }
  for (long long i = 0; i < node->count; ++i) {
    if (points.whole() != i + node->least_tag)
      return "the tags of its nodes are not one after another";
  }
  for (long long i = 0; i < node->count; ++i) {
    if (!points.skip(3))
      return "$Nodes has fewer nodes than the " + std::to_string(node->count) +
             " that it announces";
  }
  GmshNumbers parts(elements);
  const auto part = read_block(parts);
  if (!part) return "the header of $Elements is not eight numbers";
  if (part->blocks != 1 || part->count != part->in_block) return "$Elements is not a single block";
  if (part->dimension != node->dimension) return "its nodes and elements differ in dimension";
  const long long type = part->dimension == 3 ? 4 : part->dimension;
  if (part->type != type) return "the type of its elements is not that of their dimension";
  for (long long i = 0; i < part->count; ++i) {
    if (!parts.whole())
      return "$Elements has fewer elements than the " + std::to_string(part->count) +
             " that it announces";
    for (long long k = 0; k <= part->dimension; ++k) {
      const auto corner = parts.whole();
      if (!corner)
        return "$Elements has fewer elements than the " + std::to_string(part->count) +
               " that it announces";
      if (*corner < node->least_tag || *corner - node->least_tag >= node->count)
        return "an element has the node " + std::to_string(*corner) + ", which does not exist";
    }
  }
  return {};
}

}  // namespace

std::string gmsh_problem(std::string_view bytes) {
  const auto format = section_of(bytes, "MeshFormat");
  if (!format) return "it has no section $MeshFormat";
  GmshNumbers numbers(*format);
  const auto version = numbers.next<double>();
  const auto binary = numbers.whole();
  if (!version || (*version != 4.1 && *version != 2.2)) return "its version is neither 4.1 nor 2.2";
  const auto nodes = section_of(bytes, "Nodes");
  if (!nodes) return "it has no section $Nodes";
  const auto elements = section_of(bytes, "Elements");
  if (!elements) return "it has no section $Elements";
  if (binary != 0) return {};
  return *version == 4.1 ? problem_41(*nodes, *elements) : problem_22(*nodes, *elements);
}

}  // namespace rigor::read
