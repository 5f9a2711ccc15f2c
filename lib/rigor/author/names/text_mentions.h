// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names in files that rigor does not understand: launch files, scripts, RViz, code. That one is meant is only suspected.
//
//   for (const Span where : text_mentions(path, bytes, source, "wheel")) suspected.push_back(where);

#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/disk.h>
#include <rigor/text/sources.h>
#include <rigor/text/span.h>

namespace rigor::author {

/// Whether a file of that name is such a text.
bool is_mentioning_text(std::string_view path);

/// Where the name is a word of the text; in code only within quotes.
std::vector<Span> text_mentions(std::string_view path, std::string_view bytes, SourceId source,
                                std::string_view name);

/// Of a file of parameters or such a text, the places that may be one of the names; of another file, none.
std::vector<Span> names_in_text(const Disk& disk, Sources& sources, const std::string& path,
                                const std::set<std::string>& names);

/// A line for each file of these places: "launch/arm.py:12: may be the name 'wheel' (3 places)". Of many files or names
/// the first, and how many more there are.
std::vector<std::string> mention_lines(const Sources& sources, const std::vector<Span>& places);

}  // namespace rigor::author
