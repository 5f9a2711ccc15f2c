// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The page of `rigor view`: a model, its findings and its files as one HTML file that loads nothing. The page
// itself, its style and its script come from view/page, which is built by node; here are the data that go in.
//
//   const PageData data = page_data(page);
//   const std::string html = model_page(data, page_template(PageUse::kFile));
//   if (html.empty()) say("this rigor was built without its page");

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/mass/find_mesh.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/report/page/ghosts.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>
#include <rigor/view/drawing/drawing.h>
#include <rigor/view/image/picture.h>

namespace rigor::report {

enum class PageUse : std::uint8_t {
  kFile,    ///< asks nobody for anything
  kServed,  ///< asks the server that it came from for a changed model
};

/// Shown where a browser cannot draw the scene.
struct PagePicture {
  std::string view;  ///< "perspective"
  view::Picture picture;
};

/// What a page is made of. What is referred to outlives the call only.
struct ModelPage {
  std::string path;  ///< of the model's file
  const model::Root& root;
  const model::Frames& frames;    ///< with all joints at zero
  const view::Drawing& drawing;   ///< of all layers
  const Diagnostics& findings;    ///< of the file
  const Sources& sources;         ///< of the root, the drawing and the findings
  mass::FindMesh find_mesh = {};  ///< for automatic inertials; without one they are unknown
  std::vector<PagePicture> pictures = {};
  std::vector<PageGhost> ghosts = {};
  PageUse use = PageUse::kFile;
};

/// The meshes of a page have at most so many triangles together; those that would be more are not drawn, and the
/// page says so. Two million are 20 MB, and what a browser without a graphics card still turns.
inline constexpr std::size_t kMaxPageTriangles = 2'000'000;
/// Textures have at most so many pixels along a side, and fewer where all of a page would be over the second
/// number: some 10 MB.
inline constexpr std::uint32_t kPageTextureSide = 1024;
inline constexpr std::uint64_t kMaxPageTexels = std::uint64_t{8} << 20U;
/// Of the texts of files; what comes after is named only.
inline constexpr std::size_t kMaxPageText = std::size_t{8} << 20U;

struct PageData {
  std::string json;   ///< no `<` in it, whatever names hold: it can stand in a script element
  std::string bytes;  ///< of the meshes, as `PageBytes` gives them
};

PageData page_data(const ModelPage& page);

/// The page with its data. Empty when the template is.
std::string model_page(const PageData& data, std::string_view page_template);

/// What the build put into the library; empty when it had no node.
std::string_view page_template(PageUse use);

}  // namespace rigor::report
