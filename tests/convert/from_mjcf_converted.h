// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An MJCF in memory converted to URDF or SDF, and the elements of the result, for tests.
//
//   FromMjcf arm("<body name='base'>…</body>", ResultFormat::kUrdf);
//   EXPECT_EQ(arm.attribute("joint", "elbow", "type"), "revolute");

#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/conversion.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/text/disk.h>
#include <rigor/xml/document.h>

namespace rigor::test {

enum class ResultFormat : bool { kUrdf, kSdf };

class FromMjcf {
 public:
  /// What stands in the world, or a whole file.
  FromMjcf(const std::string& text, ResultFormat target, const convert::FromMjcfOptions& how = {},
           std::map<std::string, std::string> files = {},
           author::Losses losses = author::Losses::kAllowed)
      : disk_(with(std::move(files), whole(text))),
        environment_(disk_, {}),
        workspace_(environment_.resolver, sources_),
        loaded_(read::load({workspace_, environment_.resolver, environment_.sdf, environment_.urdf},
                           workspace_.open("in/robot.xml"))),
        result((target == ResultFormat::kUrdf
                    ? author::from_mjcf_to_urdf
                    : author::from_mjcf_to_sdf)(environment_, sources_, workspace_, loaded_, how,
                                                {.losses = losses, .out = "in/robot.out"})) {
    if (result.text) document_ = xml::parse(*result.text, {});
  }

  std::vector<xml::Element> all(std::string_view name) const {
    std::vector<xml::Element> found;
    for (std::uint32_t i = 0; i < document_.element_count(); ++i) {
      if (document_.element(i).name() == name) found.push_back(document_.element(i));
    }
    return found;
  }
  xml::Element named(std::string_view element, std::string_view name) const {
    for (const xml::Element each : all(element)) {
      if (each.attribute("name") && each.attribute("name")->value() == name) return each;
    }
    throw std::out_of_range("no " + std::string(element) + " " + std::string(name));
  }
  /// The value of an attribute of the element at "limit/@lower" in a named one, or an element's text.
  std::string at(std::string_view element, std::string_view name, std::string_view path) const {
    xml::Element here = named(element, name);
    while (!path.empty()) {
      const std::string_view step = path.substr(0, path.find('/'));
      path.remove_prefix(std::min(step.size() + 1, path.size()));
      if (step.starts_with('@')) {
        const auto found = here.attribute(step.substr(1));
        return found ? std::string(found->value()) : "(none)";
      }
      const auto child = here.child(step);
      if (!child) return "(none)";
      here = *child;
    }
    return std::string(here.text());
  }

  std::vector<std::string> of_rule(std::string_view rule) const {
    std::vector<std::string> found;
    for (const Diagnostic& each : result.diagnostics.list()) {
      if (each.rule == rule) found.push_back(each.message);
    }
    return found;
  }
  /// What the proof says against it.
  std::vector<std::string> against() const {
    std::vector<std::string> found;
    for (const char* rule :
         {"convert-not-the-same", "convert-rejected", "convert-rejected-by-libsdformat"}) {
      for (std::string& message : of_rule(rule)) found.push_back(std::move(message));
    }
    return found;
  }
  /// Elements and attributes of the files that were read.
  std::size_t nodes() const {
    std::size_t count = 0;
    for (const read::File* file : workspace_.files()) {
      if (!file->path.ends_with(".xml") || !file->document) continue;
      for (std::uint32_t i = 0; i < file->document->element_count(); ++i) {
        ++count;
        for ([[maybe_unused]] const xml::Attribute each : file->document->element(i).attributes())
          ++count;
      }
    }
    return count;
  }

 private:
  static std::map<std::string, std::string> with(std::map<std::string, std::string> files,
                                                 std::string text) {
    files["in/robot.xml"] = std::move(text);
    return files;
  }
  static std::string whole(const std::string& text) {
    if (text.starts_with("<mujoco")) return text;
    return "<mujoco model='m'><compiler angle='radian'/><worldbody>" + text +
           "</worldbody></mujoco>";
  }

  MemoryDisk disk_;
  Environment environment_;
  Sources sources_;
  read::Workspace workspace_;
  read::Loaded loaded_;
  xml::Document document_;

 public:
  author::Conversion result;
};

}  // namespace rigor::test
