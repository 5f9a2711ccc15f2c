// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev fuzz SECONDS xacro`: templates made from a grammar by the bytes, or the bytes themselves as a
// template (`<`) or as YAML that one loads (`#`), through the expander and the printer.

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

#include <rigor/text/disk.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/expand.h>
#include <rigor/xacro/print.h>

namespace {

/// What the grammar's words become: `E` an expression, `A` an atom, `C` content, `N` a name, `T` a text.
constexpr std::string_view kExpressions[] = {"A",
                                             "A",
                                             "(E)",
                                             "E+E",
                                             "E-E",
                                             "E*E",
                                             "E/E",
                                             "E//E",
                                             "E%E",
                                             "E**E",
                                             "-E",
                                             "not E",
                                             "E and E",
                                             "E or E",
                                             "E&lt;E&lt;=E",
                                             "E==E",
                                             "E in E",
                                             "E is not E",
                                             "E if E else E",
                                             "[E,E]",
                                             "(E,E)",
                                             "E[E]",
                                             "E[E:E:E]",
                                             "E.N",
                                             "E.split(E)",
                                             "E.join(E)",
                                             "E.append(E)",
                                             "E.pop()",
                                             "E.get(E,E)",
                                             "E.format(E,E)",
                                             "'%5.2f %s' % E",
                                             "[E for N in E]",
                                             "[E for N,N in E if E]",
                                             "dict(N=E)",
                                             "list(E)",
                                             "str(E)",
                                             "int(E)",
                                             "float(E)",
                                             "round(E,E)",
                                             "len(E)",
                                             "min(E,E)",
                                             "max(E)",
                                             "sin(E)",
                                             "math.log(E)",
                                             "factorial(E)",
                                             "python.range(E)",
                                             "python.sorted(E)",
                                             "python.set(E)",
                                             "python.sum(E)",
                                             "python.zip(E,E)",
                                             "list(map(str,E))",
                                             "xacro.tokenize(E)",
                                             "xacro.load_yaml('y')",
                                             "E &lt;&lt; E",
                                             "E | E",
                                             "~E",
                                             "E.replace(E,E)",
                                             "E.strip()",
                                             "E.center(E)"};
constexpr std::string_view kAtoms[] = {"1",    "0",     "-1", "2.5", "1e308", "99999999999",
                                       "'a'",  "'a,b'", "''", "N",   "N",     "True",
                                       "None", "[]",    "pi", "inf", "0x1f",  "7"};
constexpr std::string_view kContents[] = {
    "<xacro:property name=\"N\" value=\"T\"/>",
    "<xacro:property name=\"N\" value=\"T\" scope=\"parent\"/>",
    "<xacro:property name=\"N\">C</xacro:property>",
    "<xacro:property name=\"N\" default=\"T\"/>",
    "<xacro:property name=\"N\" remove=\"1\"/>",
    "<xacro:macro name=\"N\" params=\"N N:=T *N **N N:=^|T\">CC</xacro:macro>",
    "<xacro:macro name=\"N\">CC</xacro:macro>",
    "<xacro:N N=\"T\">C</xacro:N>",
    "<xacro:N/>",
    "<xacro:call macro=\"T\"/>",
    "<xacro:if value=\"T\">CC</xacro:if>",
    "<xacro:unless value=\"${E}\">C</xacro:unless>",
    "<xacro:insert_block name=\"N\"/>",
    "<xacro:include filename=\"part\" ns=\"N\"/>",
    "<xacro:include filename=\"p*\"/>",
    "<xacro:element xacro:name=\"T\">C</xacro:element>",
    "<xacro:attribute name=\"T\" value=\"T\"/>",
    "<xacro:arg name=\"N\" default=\"T\"/>",
    "<link a=\"T\" b=\"T\">C</link>",
    "<!-- T --><!-- xacro:eval-comments -->",
    "T",
    "CC"};
constexpr std::string_view kTexts[] = {
    "${E}",  "${E}", "T ${E}", "$(arg N)", "$(eval E)", "$(find N)", "$(optenv N a)",
    "$${E}", "N",    "12",     "1e3",      "'5'",       "true",      "${N.N}"};
constexpr std::string_view kFuzzNames[] = {"a", "b", "c", "leg"};

/// Each byte chooses what the next word becomes; without bytes, the shortest.
class Grammar {
 public:
  Grammar(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  std::string text;

  void grow(char word, int depth) {
    if (text.size() > 20'000) return;
    switch (word) {
      case 'E': return depth > 12 ? grow('A', depth) : expand(kExpressions, depth);
      case 'A': return expand(kAtoms, depth);
      case 'C': return depth > 20 ? void() : expand(kContents, depth);
      case 'T': return depth > 20 ? void(text += '1') : expand(kTexts, depth);
      case 'N': text += kFuzzNames[next() % std::size(kFuzzNames)]; return;
      default: text += word;
    }
  }

 private:
  std::uint8_t next() { return at_ < size_ ? data_[at_++] : 0; }

  template <std::size_t N>
  void expand(const std::string_view (&rules)[N], int depth) {
    const std::string_view rule = rules[next() % N];
    // Capital letters of Python's words are no words of the grammar.
    if (rule == "True" || rule == "None") {
      text += rule;
      return;
    }
    for (const char c : rule) grow(c, depth + 1);
  }

  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text;
  std::string yaml = "a: {b: [1, 2.5, x, !degrees 90], c: &k {a: 1}, d: *k}";
  if (size % 2 == 1) yaml = "a:\n  b: 1.5  # plain\n  c:\n    a: !degrees 90\nd: \"x\"\n";
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  if (bytes.starts_with('<')) {
    text = yaml = bytes;
  } else if (bytes.starts_with('#')) {
    text =
        "<robot "
        "xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><a>${xacro.load_yaml('y')}</a></robot>";
    yaml = bytes;
  } else {
    Grammar grammar(data, size);
    for (int i = 0; i < 12; ++i) grammar.grow('C', 0);
    text = "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">" + grammar.text + "</robot>";
  }
  const rigor::MemoryDisk disk(
      {{"robot", text},
       {"part", "<p xmlns:xacro=\"x\"><xacro:property name=\"a\" value=\"7\"/><i>${a}</i></p>"},
       {"y", yaml}});
  rigor::xacro::World world{disk};
  rigor::xacro::Options options;
  // Smaller than what users get: a fuzzer is in more of a hurry.
  options.bounds.steps = 50'000;
  options.bounds.memory = 32U << 20U;
  options.bounds.text_bytes = 1U << 20U;
  options.bounds.items = 20'000;
  options.bounds.nodes = 20'000;
  rigor::Sources sources;
  const rigor::xacro::Expansion expansion = rigor::xacro::expand("robot", world, options, sources);
  for (const rigor::xacro::Fact& fact : expansion.facts) rigor::xacro::describe(fact);
  if (expansion.document != nullptr) rigor::xacro::print(*expansion.document, "robot");
  return 0;
}
