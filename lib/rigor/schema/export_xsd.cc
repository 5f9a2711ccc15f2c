// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
#include <rigor/schema/export.h>

#include <cstddef>
#include <map>
#include <vector>

#include <rigor/schema/value.h>

namespace rigor::schema {
namespace {

// The forms of values. xs:token collapses white space first, so one space represents any.
constexpr std::string_view kNumber =
    "[+\\-]?(([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+\\-]?[0-9]+)?"
    "|0[xX]([0-9a-fA-F]+\\.?[0-9a-fA-F]*|\\.[0-9a-fA-F]+)([pP][+\\-]?[0-9]+)?"
    "|[iI][nN][fF]([iI][nN][iI][tT][yY])?|[nN][aA][nN])";
constexpr std::string_view kInteger = "[+\\-]?([0-9]+|0[xX][0-9a-fA-F]+)";
constexpr std::string_view kNatural = "\\+?([0-9]+|0[xX][0-9a-fA-F]+)";

std::string repeated(std::string_view pattern, std::size_t least, std::size_t most) {
  const std::string one = "(" + std::string(pattern) + ")";
  return one + "( " + one + "){" + std::to_string(least - 1) + "," + std::to_string(most - 1) + "}";
}

// The pattern of a type; empty when any text will do.
std::string pattern_of(Type type) {
  switch (type) {
    case Type::kNone:
    case Type::kString: return "";
    case Type::kChar: return ".+";
    case Type::kBool: return "[tT][rR][uU][eE]|[fF][aA][lL][sS][eE]|0|1";
    case Type::kInt: return std::string(kInteger);
    case Type::kUint:
    case Type::kUint64: return std::string(kNatural);
    case Type::kDouble:
    case Type::kFloat:
    case Type::kAngle: return std::string(kNumber);
    case Type::kVector2: return repeated(kNumber, 2, 2);
    case Type::kVector2i: return repeated(kInteger, 2, 2);
    case Type::kVector3:
    case Type::kQuaternion: return repeated(kNumber, 3, 3);
    case Type::kPose:  // with a quaternion seven; empty is the identity
      return "(" + repeated(kNumber, 6, 7) + ")?";
    case Type::kColor: return repeated(kNumber, 3, 4);
    case Type::kTime: return repeated(kInteger, 2, 2);
  }
  return "";
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

std::string type_name(Type type) {
  return "value_" + std::string(type == Type::kNone ? "string" : to_string(type));
}

class XsdWriter {
 public:
  std::string run(const Node& root) {
    out_ =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\">\n";
    write_element(root, "  ");
    // elements met on the way wait here for their types, which are written once each
    for (std::size_t i = 0; i < waiting_.size(); ++i) write_type(waiting_[i]);
    for (int i = 1; i <= static_cast<int>(Type::kChar); ++i) write_value(static_cast<Type>(i));
    return out_ + "</xs:schema>\n";
  }

 private:
  void line(std::string_view indent, std::string_view text) {
    out_ += indent;
    out_ += text;
    out_ += '\n';
  }

  // The documentation with what XML Schema cannot say itself.
  void write_doc(const Node& node, const std::string& indent) {
    std::string text(node.doc());
    const auto add = [&text](std::string_view label, std::string_view value) {
      if (value.empty()) return;
      text += text.empty() ? "" : " ";
      text += std::string(label) + std::string(value) + ".";
    };
    add("Unit: ", node.unit());
    add("Default: ", node.default_value().value_or(""));
    add("At least ", node.minimum().value_or(""));
    add("At most ", node.maximum().value_or(""));
    if (node.deprecated_since()) add("Deprecated since ", to_string(*node.deprecated_since()));
    add("Use instead: ", node.instead());
    if (text.empty()) return;
    line(indent, "<xs:annotation><xs:documentation>" + escaped(text) +
                     "</xs:documentation></xs:annotation>");
  }

  void write_element(const Node& node, const std::string& indent) {
    line(indent,
         "<xs:element name=\"" + escaped(node.name()) + "\" type=\"" + name_of(node) + "\">");
    write_doc(node, indent + "  ");
    line(indent, "</xs:element>");
  }

  std::string name_of(const Node& node) {
    const auto [at, is_new] = names_.emplace(
        node.declaration(), std::string(node.name()) + "_" + std::to_string(names_.size() + 1));
    if (is_new) waiting_.push_back(node);
    return at->second;
  }

  void write_type(const Node node) {
    const bool has_children = !node.children().empty();
    const bool has_value = node.type() != Type::kNone;
    const bool mixed = node.open() || (has_children && has_value);
    line("  ",
         "<xs:complexType name=\"" + name_of(node) + "\"" + (mixed ? " mixed=\"true\">" : ">"));
    if (node.open()) {
      line("    ", "<xs:sequence>");
      line("      ",
           "<xs:any namespace=\"##any\" processContents=\"skip\" minOccurs=\"0\" "
           "maxOccurs=\"unbounded\"/>");
      line("    ", "</xs:sequence>");
      write_attributes(node, "    ");
    } else if (has_value && !has_children) {
      line("    ", "<xs:simpleContent>");
      line("      ", "<xs:extension base=\"" + value_name(node) + "\">");
      write_attributes(node, "        ");
      line("      ", "</xs:extension>");
      line("    ", "</xs:simpleContent>");
    } else {
      line("    ", "<xs:choice minOccurs=\"0\" maxOccurs=\"unbounded\">");
      for (const Node child : node.children()) write_element(child, "      ");
      line("      ", "<xs:any namespace=\"##other\" processContents=\"lax\"/>");
      line("    ", "</xs:choice>");
      write_attributes(node, "    ");
    }
    line("  ", "</xs:complexType>");
    if (has_value && !has_children && !node.enumeration().empty()) {
      line("  ", "<xs:simpleType name=\"" + value_name(node) + "\">");
      write_words(node, "    ");
      line("  ", "</xs:simpleType>");
    }
  }

  // The simple type of an element's text: that of its Type, or one of its own for an enumeration.
  std::string value_name(const Node& node) {
    return node.enumeration().empty() ? type_name(node.type()) : name_of(node) + "_value";
  }

  void write_words(const Node& node, const std::string& indent) {
    line(indent, "<xs:restriction base=\"xs:token\">");
    for (const std::string_view word : node.enumeration()) {
      line(indent + "  ", "<xs:enumeration value=\"" + escaped(word) + "\"/>");
    }
    line(indent, "</xs:restriction>");
  }

  void write_attributes(const Node& node, const std::string& indent) {
    for (const Node attribute : node.attributes()) write_attribute(attribute, indent);
    line(indent, node.open() ? "<xs:anyAttribute namespace=\"##any\" processContents=\"skip\"/>"
                             : "<xs:anyAttribute namespace=\"##other\" processContents=\"lax\"/>");
  }

  void write_attribute(const Node& attribute, const std::string& indent) {
    std::string head = "<xs:attribute name=\"" + escaped(attribute.name()) + "\"";
    const bool enumerated = !attribute.enumeration().empty();
    if (!enumerated) head += " type=\"" + type_name(attribute.type()) + "\"";
    const bool required = attribute.cardinality() == Cardinality::kOne ||
                          attribute.cardinality() == Cardinality::kOneOrMore;
    const std::optional<std::string_view> value = attribute.default_value();
    if (required) {
      head += " use=\"required\"";
    } else if (value && !value->empty() && !check(attribute.type(), *value)) {
      head += " default=\"" + escaped(*value) + "\"";
    }
    line(indent, head + ">");
    write_doc(attribute, indent + "  ");
    if (enumerated) {
      line(indent + "  ", "<xs:simpleType>");
      write_words(attribute, indent + "    ");
      line(indent + "  ", "</xs:simpleType>");
    }
    line(indent, "</xs:attribute>");
  }

  void write_value(Type type) {
    const std::string pattern = pattern_of(type);
    line("  ", "<xs:simpleType name=\"" + type_name(type) + "\">");
    if (pattern.empty()) {
      line("    ", "<xs:restriction base=\"xs:string\"/>");
    } else {
      line("    ", "<xs:restriction base=\"xs:token\">");
      line("      ", "<xs:pattern value=\"" + escaped(pattern) + "\"/>");
      line("    ", "</xs:restriction>");
    }
    line("  ", "</xs:simpleType>");
  }

  std::string out_;
  std::map<std::uint32_t, std::string> names_;  // of the types, by declaration
  std::vector<Node> waiting_;
};

}  // namespace

std::optional<std::string> to_xsd(const Schema& schema, Version version, std::string_view root) {
  const std::optional<Node> node = schema.root(root, version);
  if (!node) return std::nullopt;
  return XsdWriter().run(*node);
}

}  // namespace rigor::schema
