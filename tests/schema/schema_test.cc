// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
#include <rigor/schema/embedded.h>
#include <rigor/schema/schema.h>
#include <rigor/schema/value.h>

#include <chrono>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::schema {
namespace {

using Names = std::vector<std::string>;

Schema parse_good(std::string_view text) {
  auto parsed = Schema::parse(text);
  if (const auto* fault = std::get_if<Schema::Fault>(&parsed)) {
    ADD_FAILURE() << "line " << fault->line << ": " << fault->message;
    return std::get<Schema>(Schema::parse("versions 1.0\ndefine root\n  element none card=1\n"));
  }
  return std::get<Schema>(std::move(parsed));
}

// "line: message", or empty when there is no fault.
std::string fault_of(std::string_view text) {
  const auto parsed = Schema::parse(text);
  const auto* const fault = std::get_if<Schema::Fault>(&parsed);
  return fault ? std::to_string(fault->line) + ": " + fault->message : "";
}

Names names_of(const NodeRange& nodes) {
  Names names;
  for (const Node node : nodes) names.emplace_back(node.name());
  return names;
}

// The node at a path such as "sdf/model/link"; the last part may be @attribute.
std::optional<Node> at(const Schema& schema, Version version, std::string_view path) {
  std::optional<Node> node;
  bool first = true;
  while (!path.empty()) {
    const std::size_t slash = std::min(path.find('/'), path.size());
    const std::string_view part = path.substr(0, slash);
    path.remove_prefix(std::min(slash + 1, path.size()));
    if (first) {
      node = schema.root(part, version);
    } else {
      node = part.starts_with('@') ? node->attribute(part.substr(1)) : node->child(part);
    }
    first = false;
    if (!node) return std::nullopt;
  }
  return node;
}

constexpr std::string_view kSmallSchema = R"(# a small format
versions 1.0 1.2 1.10

define root
  element doc card=1 | The document.
    attribute version type=string card=1
    use part card=+ | A part at the top.
    element old card=0 until=1.2 deprecated=1.2 instead=part | Before parts.
      element inner type=int card=1 | Inside the old.
    element size type=double card=0 card@1.2=1 default=1 default@1.2= default@1.10=" 2" max=9 unit=m

define part
  element part card=* | A part.
    attribute kind type=string card=1 enum=a|bb|a-b since=1.2
    attribute empty type=string card=0 default=""
    use part card=0 since=1.2
    element late card=0 since=1.10 | New.
      any
)";

TEST(Schema, ReadsItsLanguage) {
  const Schema schema = parse_good(kSmallSchema);
  EXPECT_EQ(schema.versions(), (std::vector<Version>{{0}, {2}, {10}}));
  EXPECT_EQ(schema.latest(), Version{10});
  const Node doc = *schema.root("doc", Version{10});
  EXPECT_EQ(doc.doc(), "The document.");
  EXPECT_EQ(names_of(doc.attributes()), Names{"version"});
  EXPECT_EQ(names_of(doc.children()), (Names{"part", "size"}));
  const Node part = *doc.child("part");
  EXPECT_EQ(part.doc(), "A part at the top.");
  EXPECT_EQ(part.cardinality(), Cardinality::kOneOrMore);
  const Node nested = *part.child("part");
  EXPECT_EQ(nested.doc(), "A part.");
  EXPECT_EQ(nested.cardinality(), Cardinality::kOptional);
  EXPECT_EQ(nested.declaration(), part.declaration());
  EXPECT_TRUE(part.child("late")->open());
  EXPECT_FALSE(part.open());
  EXPECT_TRUE(part.attribute("kind"));
}

TEST(Schema, FacetsFollowTheVersion) {
  const Schema schema = parse_good(kSmallSchema);
  const Node size0 = *at(schema, Version{0}, "doc/size");
  EXPECT_EQ(size0.type(), Type::kDouble);
  EXPECT_EQ(size0.cardinality(), Cardinality::kOptional);
  EXPECT_EQ(size0.default_value(), "1");
  EXPECT_EQ(size0.minimum(), std::nullopt);
  EXPECT_EQ(size0.maximum(), "9");
  EXPECT_EQ(size0.unit(), "m");
  const Node size2 = *at(schema, Version{2}, "doc/size");
  EXPECT_EQ(size2.cardinality(), Cardinality::kOne);
  EXPECT_EQ(size2.default_value(), std::nullopt);
  EXPECT_EQ(at(schema, Version{10}, "doc/size")->default_value(), " 2");
  EXPECT_EQ(at(schema, Version{10}, "doc/part/@empty")->default_value(), "");
  EXPECT_EQ(at(schema, Version{0}, "doc/old")->deprecated_since(), std::nullopt);
  EXPECT_EQ(at(schema, Version{2}, "doc/old")->deprecated_since(), Version{2});
  EXPECT_EQ(at(schema, Version{2}, "doc/old")->instead(), "part");
}

TEST(Schema, OnlyWhatExistsIsFound) {
  const Schema schema = parse_good(kSmallSchema);
  EXPECT_FALSE(at(schema, Version{10}, "doc/old"));
  EXPECT_TRUE(at(schema, Version{2}, "doc/old/inner"));
  EXPECT_FALSE(at(schema, Version{0}, "doc/part/part"));
  EXPECT_FALSE(at(schema, Version{0}, "doc/part/@kind"));
  EXPECT_FALSE(at(schema, Version{2}, "doc/sizes"));
  EXPECT_FALSE(at(schema, Version{2}, "doc/@size"));  // an element, not an attribute
  EXPECT_FALSE(at(schema, Version{2}, "part"));       // not a root
  EXPECT_FALSE(schema.root("doc", Version{1}));
  EXPECT_FALSE(schema.root("doc", Version{99}));
  EXPECT_TRUE(schema.roots(Version{-1}).empty());
}

TEST(Schema, FindsWhatExistsInAnotherVersion) {
  const Schema schema = parse_good(kSmallSchema);
  const Node doc0 = *schema.root("doc", Version{0});
  const Node part0 = *doc0.child("part");
  EXPECT_EQ(part0.child_in_other_version("late")->since(), Version{10});
  EXPECT_EQ(part0.child_in_other_version("part")->version(), Version{2});
  EXPECT_EQ(part0.attribute_in_other_version("kind")->since(), Version{2});
  EXPECT_FALSE(part0.child_in_other_version("never"));
  EXPECT_FALSE(doc0.child_in_other_version("old"));  // exists now
  const Node doc10 = *schema.root("doc", Version{10});
  const Node old = *doc10.child_in_other_version("old");
  EXPECT_EQ(old.version(), Version{2});
  EXPECT_EQ(old.until(), Version{2});
  EXPECT_EQ(old.since(), Version{0});
  EXPECT_EQ(doc10.until(), std::nullopt);
}

TEST(Schema, RequiredIsOneAndOneOrMore) {
  const Schema schema = parse_good(kSmallSchema);
  const Node doc0 = *schema.root("doc", Version{0});
  EXPECT_EQ(names_of(doc0.required_children()), Names{"part"});
  EXPECT_EQ(names_of(schema.root("doc", Version{2})->required_children()), (Names{"part", "size"}));
  EXPECT_EQ(names_of(doc0.required_attributes()), Names{"version"});
  EXPECT_TRUE(doc0.child("part")->required_attributes().empty());
}

TEST(Schema, EnumerationIteratesAndContains) {
  const Schema schema = parse_good(kSmallSchema);
  const Enumeration words = at(schema, Version{2}, "doc/part/@kind")->enumeration();
  EXPECT_EQ(std::vector<std::string>(words.begin(), words.end()), (Names{"a", "bb", "a-b"}));
  EXPECT_TRUE(words.contains("bb"));
  EXPECT_FALSE(words.contains("b"));
  EXPECT_FALSE(words.contains("A"));
  EXPECT_FALSE(words.contains(""));
  EXPECT_FALSE(words.contains("a|bb"));
  EXPECT_TRUE(at(schema, Version{2}, "doc/size")->enumeration().empty());
}

TEST(Schema, KnowsParents) {
  const Schema schema = parse_good(kSmallSchema);
  EXPECT_EQ(schema.parents_of("part", Version{0}), Names{"doc"});
  EXPECT_EQ(schema.parents_of("part", Version{2}), (Names{"doc", "part"}));
  EXPECT_EQ(schema.parents_of("inner", Version{2}), Names{"doc/old"});
  EXPECT_EQ(schema.parents_of("inner", Version{10}), Names{});
}

TEST(Schema, NearestVersionIsNotNewer) {
  const Schema schema = parse_good(kSmallSchema);
  EXPECT_EQ(schema.nearest(Version{1}), Version{0});
  EXPECT_EQ(schema.nearest(Version{9}), Version{2});
  EXPECT_EQ(schema.nearest(Version{99}), Version{10});
  EXPECT_EQ(schema.nearest(Version{-1}), Version{0});
}

TEST(Schema, NodesOutliveAMoveOfTheSchema) {
  Schema first = parse_good(kSmallSchema);
  const Node doc = *first.root("doc", Version{2});
  const Schema second = std::move(first);
  EXPECT_EQ(doc.child("size")->name(), "size");
}

TEST(Schema, FaultsNameTheLine) {
  const std::string head = "versions 1.0 1.2\ndefine root\n  element a card=1\n";
  EXPECT_EQ(fault_of(head), "");
  EXPECT_EQ(fault_of(""), "0: there is no line 'versions'");
  EXPECT_EQ(fault_of("versions 1.0\n"), "1: there is no block 'root'");
  EXPECT_EQ(fault_of("define root\n"), "1: 'versions' must come before the first 'define'");
  EXPECT_EQ(fault_of("versions 1.2 1.0\n"), "1: version 1.0 is out of order");
  EXPECT_EQ(fault_of("versions 2.0\n"), "1: '2.0' is not a version from 1.0 to 1.31");
  EXPECT_EQ(fault_of(head + "   element b\n"),
            "4: indented by 3 spaces, which does not fit the line above");
  EXPECT_EQ(fault_of(head + "      element b\n"),
            "4: indented by 6 spaces, which does not fit the line above");
  EXPECT_EQ(fault_of(head + "elements\n"),
            "4: 'elements' at the margin; 'define' or 'versions' would be right");
  EXPECT_EQ(fault_of(head + "    child b\n"), "4: 'child' cannot stand here");
  EXPECT_EQ(fault_of(head + "    element\n"), "4: 'element' without a name");
  EXPECT_EQ(fault_of(head + "    use b card=0\n"), "4: there is no block 'b' to use");
  EXPECT_EQ(fault_of(head + "    use root card=0\n"), "4: there is no block 'root' to use");
  EXPECT_EQ(fault_of(head + "    element b number=1\n"), "4: unknown key 'number'");
  EXPECT_EQ(fault_of(head + "    element b wide\n"), "4: 'wide' is not of the form key=value");
  EXPECT_EQ(fault_of(head + "    element b card=2\n"), "4: '2' is not a value for 'card'");
  for (const std::string count : {"0", "3..1", "..3", "x", "3*3", "1.5", "-1", "*"}) {
    EXPECT_EQ(fault_of(head + "    attribute b type=int count=" + count + "\n"),
              "4: '" + count + "' is not a value for 'count'");
  }
  EXPECT_EQ(fault_of(head + "    element b type=real\n"), "4: 'real' is not a value for 'type'");
  EXPECT_EQ(fault_of(head + "    element b card=1 card=0\n"),
            "4: key 'card' is repeated, or its versions out of order");
  EXPECT_EQ(fault_of(head + "    element b since=1.1\n"), "4: since=1.1 is not a known version");
  EXPECT_EQ(fault_of(head + "    element b card@1.1=0\n"),
            "4: 'card@1.1' does not name a known version");
  EXPECT_EQ(fault_of(head + "    element b since=1.2 until=1.0\n"),
            "4: 'b' exists in none of the versions of the line around it");
  EXPECT_EQ(fault_of(head + "    element b\n    element b since=1.2\n"),
            "5: 'b' stands here twice in one version");
  EXPECT_EQ(fault_of(head + "    element b until=1.0\n    element b since=1.2\n"), "");
  EXPECT_EQ(fault_of(head + "    attribute b\n    element b\n"), "");
  EXPECT_EQ(fault_of(head + "    attribute b\n      element c\n"),
            "5: an attribute or a use has nothing inside");
  EXPECT_EQ(fault_of(head + "define root\n"), "4: block 'root' is defined twice");
  EXPECT_EQ(fault_of(head + "define b\n"),
            "4: block 'b' has 0 elements at its top; one would be right");
  EXPECT_EQ(fault_of(head + "define b\n  element c\n  element d\n"),
            "4: block 'b' has 2 elements at its top; one would be right");
}

TEST(Schema, WindowsLineEndsAndAMissingLastOneAreRead) {
  const Schema schema = parse_good("versions 1.0\r\ndefine root\r\n  element a card=1 | Doc.");
  EXPECT_EQ(schema.root("a", Version{0})->doc(), "Doc.");
}

// Visits every node that a document of any version can contain, each declaration once in a version.
template <class Visit>
void visit_all(const Schema& schema, Visit visit) {
  for (const Version version : schema.versions()) {
    std::set<std::uint32_t> seen;
    std::vector<Node> open;
    for (const Node root : schema.roots(version)) open.push_back(root);
    while (!open.empty()) {
      const Node node = open.back();
      open.pop_back();
      visit(node);
      if (!seen.insert(node.declaration()).second) continue;
      for (const Node attribute : node.attributes()) visit(attribute);
      for (const Node child : node.children()) open.push_back(child);
    }
  }
}

TEST(SdfSchema, EveryLineIsDocumented) {
  const Schema schema = parse_good(sdf_schema_text());
  visit_all(schema, [](const Node& node) {
    EXPECT_FALSE(node.doc().empty()) << node.name();
    EXPECT_EQ(node.doc().find('<'), std::string_view::npos) << node.doc();
  });
}

TEST(UrdfSchema, EveryLineIsDocumented) {
  const Schema schema = parse_good(urdf_schema_text());
  visit_all(schema, [](const Node& node) { EXPECT_FALSE(node.doc().empty()) << node.name(); });
}

TEST(SdfSchema, KnownChangesBetweenVersions) {
  const Schema schema = parse_good(sdf_schema_text());
  EXPECT_EQ(schema.versions().size(), 12u);
  EXPECT_FALSE(schema.knows(Version{1}));
  const std::string effort = "/world/model/joint/axis/limit/effort";
  EXPECT_EQ(at(schema, Version{2}, "gazebo" + effort)->default_value(), "0");
  EXPECT_EQ(at(schema, Version{3}, "sdf" + effort)->default_value(), "-1");
  EXPECT_EQ(at(schema, Version{9}, "sdf" + effort)->default_value(), "-1");
  EXPECT_EQ(at(schema, Version{10}, "sdf" + effort)->default_value(), "inf");
  // an attribute in 1.0, an element since 1.2
  EXPECT_TRUE(at(schema, Version{0}, "gazebo/model/link/@gravity"));
  EXPECT_FALSE(at(schema, Version{0}, "gazebo/model/link/gravity"));
  EXPECT_TRUE(at(schema, Version{2}, "gazebo/model/link/gravity"));
  EXPECT_FALSE(schema.root("gazebo", Version{3}));
  EXPECT_FALSE(schema.root("sdf", Version{2}));

  const Node geometry7 = *at(schema, Version{7}, "sdf/model/link/collision/geometry");
  EXPECT_FALSE(geometry7.child("capsule"));
  EXPECT_EQ(geometry7.child_in_other_version("capsule")->since(), Version{8});
  EXPECT_EQ(geometry7.child_in_other_version("cone")->since(), Version{11});
  EXPECT_EQ(geometry7.child("box")->child("size")->type(), Type::kVector3);

  const Node pose6 = *at(schema, Version{6}, "sdf/model/pose");
  EXPECT_TRUE(pose6.attribute("frame"));
  EXPECT_EQ(pose6.attribute_in_other_version("relative_to")->since(), Version{7});
  const Node pose8 = *at(schema, Version{8}, "sdf/model/pose");
  EXPECT_EQ(pose8.attribute_in_other_version("frame")->until(), Version{6});
  EXPECT_EQ(pose8.attribute_in_other_version("degrees")->since(), Version{9});
}

TEST(SdfSchema, KnowsSinceWhenAValueIsListed) {
  // sdformat's sensor.sdf has air_speed from 1.10 on, and never had air_sped.
  const Schema schema = parse_good(sdf_schema_text());
  const auto type = [&schema](int minor) {
    return *at(schema, Version{minor}, "sdf/model/link/sensor/@type");
  };
  EXPECT_EQ(type(6).listed_since("air_speed"), Version{10});
  EXPECT_EQ(type(9).listed_since("air_speed"), Version{10});
  EXPECT_EQ(type(10).listed_since("air_speed"), std::nullopt);
  EXPECT_EQ(type(6).listed_since("air_sped"), std::nullopt);
  EXPECT_EQ(type(6).listed_since("camera"), std::nullopt);
}

TEST(SdfSchema, RecursionFacetsAndOpenContent) {
  const Schema schema = parse_good(sdf_schema_text());
  const Node model = *at(schema, Version{12}, "sdf/model");
  EXPECT_EQ(model.child("model")->declaration(), model.declaration());
  EXPECT_EQ(model.cardinality(), Cardinality::kOptional);
  EXPECT_EQ(model.child("model")->cardinality(), Cardinality::kMany);
  EXPECT_TRUE(model.child("plugin")->open());
  const Node pitch = *at(schema, Version{10}, "sdf/model/joint/thread_pitch");
  EXPECT_EQ(pitch.cardinality(), Cardinality::kDeprecated);
  EXPECT_EQ(pitch.deprecated_since(), Version{10});
  EXPECT_EQ(pitch.instead(), "screw_thread_pitch");
  const Node ixx = *at(schema, Version{6}, "sdf/model/link/inertial/inertia/ixx");
  EXPECT_EQ(ixx.unit(), "kg·m²");
  const Node inertia = *at(schema, Version{6}, "sdf/model/link/inertial/inertia");
  EXPECT_EQ(names_of(inertia.required_children()),
            (Names{"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}));
  const Enumeration types = at(schema, Version{6}, "sdf/model/joint/@type")->enumeration();
  EXPECT_TRUE(types.contains("fixed"));
  EXPECT_TRUE(types.contains("revolute2"));
  EXPECT_FALSE(types.contains("hinge"));
  EXPECT_EQ(schema.parents_of("inertia", Version{6}), Names{"inertial"});
  EXPECT_EQ(schema.parents_of("limit", Version{6}),
            (Names{"joint/axis", "joint/axis2", "joint/physics/ode"}));
}

TEST(SdfSchema, DeprecatedCardinalityHasItsVersion) {
  const Schema schema = parse_good(sdf_schema_text());
  visit_all(schema, [](const Node& node) {
    if (node.cardinality() == Cardinality::kDeprecated) {
      EXPECT_TRUE(node.deprecated_since()) << node.name();
    }
  });
}

// A default or bound that is no value of its type would be a slip in the schema file.
TEST(SdfSchema, DefaultsAndBoundsAreValuesOfTheirType) {
  const Schema schema = parse_good(sdf_schema_text());
  visit_all(schema, [](const Node& node) {
    for (const auto& value : {node.default_value(), node.minimum(), node.maximum()}) {
      if (!value || (value->empty() && node.type() == Type::kString)) continue;
      EXPECT_FALSE(check(node.type(), *value)) << node.name() << " " << *value;
    }
  });
}

TEST(SdfSchema, DefaultsAreValuesOfTheirEnumeration) {
  const Schema schema = parse_good(sdf_schema_text());
  visit_all(schema, [](const Node& node) {
    if (node.enumeration().empty() || !node.default_value()) return;
    if (node.default_value()->empty())
      return;  // the descriptions' way to say that nothing is chosen
    EXPECT_TRUE(node.enumeration().contains(*node.default_value())) << node.name();
  });
}

TEST(UrdfSchema, VersionsAndTolerance) {
  const Schema schema = parse_good(urdf_schema_text());
  const Node geometry = *at(schema, Version{0}, "robot/link/collision/geometry");
  EXPECT_FALSE(geometry.child("capsule"));
  EXPECT_EQ(geometry.child_in_other_version("capsule")->since(), Version{1});
  EXPECT_TRUE(at(schema, Version{1}, "robot/link/visual/origin/@quat_xyzw"));
  EXPECT_FALSE(at(schema, Version{1}, "robot/joint/limit/@jerk"));
  EXPECT_TRUE(at(schema, Version{2}, "robot/joint/limit/@jerk"));
  EXPECT_TRUE(at(schema, Version{0}, "robot/gazebo")->open());
  EXPECT_TRUE(at(schema, Version{0}, "robot/link/collision/verbose/@value"));
  EXPECT_TRUE(at(schema, Version{0}, "robot/joint/@type")->enumeration().contains("floating"));
  EXPECT_EQ(names_of(at(schema, Version{0}, "robot/joint")->required_children()),
            (Names{"parent", "child"}));
}

TEST(SdfSchema, ParsesFast) {
  // the budget is 1 ms in an optimized build on an idle machine; ten times that is a defect in any
  // build
  using Clock = std::chrono::steady_clock;
  auto best = Clock::duration::max();
  for (int i = 0; i < 10; ++i) {
    const Clock::time_point start = Clock::now();
    const auto parsed = Schema::parse(sdf_schema_text());
    best = std::min(best, Clock::now() - start);
    ASSERT_TRUE(std::holds_alternative<Schema>(parsed));
  }
  EXPECT_LT(best, std::chrono::milliseconds(10));
}

TEST(Version, ReadsAndWritesMinorNumbers) {
  EXPECT_EQ(parse_version("1.0"), Version{0});
  EXPECT_EQ(parse_version("1.12"), Version{12});
  EXPECT_EQ(parse_version("1.999"), Version{999});
  EXPECT_GT(*parse_version("1.10"), *parse_version("1.9"));
  for (const std::string_view text :
       {"", "1", "1.", "2.0", "1.06", "1.6.0", "1.x", " 1.6", "1.6 ", "1.-1", "1.1000"}) {
    EXPECT_EQ(parse_version(text), std::nullopt) << text;
  }
  EXPECT_EQ(to_string(Version{10}), "1.10");
}

TEST(Type, WordsAndTypesCorrespond) {
  for (int i = 1; i <= static_cast<int>(Type::kChar); ++i) {
    const Type type = static_cast<Type>(i);
    EXPECT_FALSE(to_string(type).empty());
    EXPECT_EQ(parse_type(to_string(type)), type);
  }
  EXPECT_EQ(to_string(Type::kNone), "");
  EXPECT_EQ(parse_type(""), std::nullopt);
  EXPECT_EQ(parse_type("quaternion"), Type::kQuaternion);
}

TEST(Schema, CountsSayWhatTheyAllow) {
  const Schema schema = parse_good(
      "versions 1.0\ndefine root\n  element a card=1\n    attribute none type=int\n"
      "    attribute three type=double count=3\n    attribute some type=double count=1..3\n"
      "    attribute any type=double count=2..\n    attribute triples type=double count=3*\n");
  const Node root = *schema.root("a", Version{0});
  EXPECT_FALSE(root.attribute("none")->count());
  const auto allowed = [&](std::string_view name) {
    std::string numbers;
    for (std::size_t n = 0; n <= 7; ++n) {
      if (root.attribute(name)->count()->allows(n)) numbers += std::to_string(n);
    }
    return numbers;
  };
  EXPECT_EQ(allowed("three"), "3");
  EXPECT_EQ(allowed("some"), "123");
  EXPECT_EQ(allowed("any"), "234567");
  EXPECT_EQ(allowed("triples"), "36");
  EXPECT_EQ(to_string(*root.attribute("three")->count()), "3 numbers");
  EXPECT_EQ(to_string(*root.attribute("some")->count()), "1 to 3 numbers");
  EXPECT_EQ(to_string(*root.attribute("any")->count()), "2 or more numbers");
  EXPECT_EQ(to_string(*root.attribute("triples")->count()), "a multiple of 3 numbers");
}

}  // namespace
}  // namespace rigor::schema
