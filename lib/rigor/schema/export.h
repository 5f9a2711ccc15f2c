// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A schema in the words of other tools: an XML Schema, with which any XML editor completes and
// checks a file, and a reference page in Markdown. Both are of one version and one root element,
// and both end although blocks use each other in circles: what is inside a block is written once.
//
//   std::optional<std::string> xsd = to_xsd(schema, Version{10}, "sdf");
//   // xmllint --noout --schema sdf-1.10.xsd robot.sdf
//   std::optional<std::string> page = to_docs(schema, Version{10}, "sdf");
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <rigor/schema/schema.h>

namespace rigor::schema {

// XML Schema 1.0. It checks names, places, required attributes, the form of values and the words of
// enumerations, and lets pass what has a namespace (one that is declared: a bare `gz:` prefix is
// refused). It cannot say, with children in any order, how many there must be; nor are bounds of
// numbers checked, because infinity and hexadecimal numbers, which robot files may hold, are no
// xs:double. Open elements take anything. Nothing for a root or version the schema does not have.
std::optional<std::string> to_xsd(const Schema& schema, Version version, std::string_view root);

// Markdown: a section for each element with what is known of it, and a table of its attributes;
// where a block is met again, a reference to its first place.
std::optional<std::string> to_docs(const Schema& schema, Version version, std::string_view root);

}  // namespace rigor::schema
