// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A model as bodies to draw: triangles, where they are, and how they look. What a picture is traced
// from, and what the page of `rigor view` holds.
//
//   const Drawing drawing = draw(root, frames, sources, files, {.layers = {Layer::kVisual}});
//   for (const Body& body : drawing.bodies) place(*body.mesh, body.pose, body.scale);

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/mesh/triangle_mesh.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>
#include <rigor/view/image/picture.h>

namespace rigor::view {

/// What can be shown of a model.
enum class Layer : std::uint8_t {
  kVisual,
  kCollision,
  kInertia,   ///< of each link, the solid box that has its mass and principal moments
  kCom,       ///< a ball at each link's center of mass
  kFrames,    ///< of each link: x red, y green, z blue
  kAxes,      ///< of each joint, an arrow along it
  kContacts,  ///< a ball where a collision touches the ground or one of another link
  kGround,  ///< the plane z = 0 with a grid: lines a meter apart, finer or coarser by the model's size
};

/// "visual", "collision", "inertia", "com", "frames", "axes", "contacts", "ground"
std::string_view to_string(Layer layer);
std::optional<Layer> layer_named(std::string_view name);
std::vector<std::string_view> layer_names();

/// Red, green, blue, opacity: 0 to 1, as written in models (sRGB).
struct Color {
  float r = 0.7F, g = 0.7F, b = 0.7F, a = 1;

  bool operator==(const Color&) const = default;
};

/// How a part of a mesh looks.
struct Surface {
  Color color;
  std::shared_ptr<const Picture> texture = nullptr;  ///< multiplies the color; null without one
  std::string texture_path = {};  ///< its file; empty when the mesh's own file holds it
  bool texture_opacity = true;    ///< where the texture lets light through, the surface does
};

/// One mesh in one place. Meshes are shared: all boxes have one, of side one, which `scale` brings to size.
/// `mesh->corners.normals`, where there are any, are those before the scale (divide by it, then make the length
/// one); `corners.texture` is where a texture can be shown; `corners.colors` multiply the surface's color. A
/// scale whose product is negative turns the mesh inside out.
struct Body {
  Layer layer = Layer::kVisual;
  std::string name;                 ///< "arm::hand/link palm/visual shell"
  model::Id<model::Link> link;      ///< that it moves with; none for what stands still
  model::Id<model::Joint> joint{};  ///< of an axis
  std::shared_ptr<const mesh::TriangleMesh> mesh;
  model::Pose pose;               ///< in the frame of the model's file, as `Frames` gives poses
  model::Vector3 scale{1, 1, 1};  ///< of the mesh, before it is placed
  std::vector<Surface> surfaces;  ///< one for each part of the mesh, or one for all: never none
  Span where = {};                ///< the element that it is drawn of
};

/// A shape that cannot be drawn, and why: "meshes/arm.dae is not found".
struct NotDrawn {
  std::string name;
  std::string reason;
  Span where;
};

struct Drawing {
  std::vector<Body> bodies;  ///< in the order of the file, layer by layer
  std::vector<NotDrawn> not_drawn;
  /// Of all bodies but the ground, and but `<plane>`s where there is anything else, in meters; `min` above `max`
  /// when empty.
  mesh::Bounds bounds;
};

/// More is not drawn. The largest real world has 3,004 visuals, of four million triangles. A mesh that bodies
/// share takes its memory once.
inline constexpr std::size_t kMaxBodies = 50'000;
inline constexpr std::size_t kMaxDrawnTriangles = 10'000'000;
/// Those of each body counted: 1.4 s to find how far they reach.
inline constexpr std::size_t kMaxPlacedTriangles = 100'000'000;
/// What lies or reaches farther from the origin is not drawn, m: 32-bit numbers, with which pictures are
/// made, are a meter apart there.
inline constexpr double kFarthest = 1e7;

/// What a file that a shape or a surface names holds; null when there is none. Any of them may be empty.
/// `files_of` (files.h) looks on a disk.
struct Files {
  /// A mesh's triangles by its shape (URI, submesh and centering applied; scale not).
  std::function<std::shared_ptr<const mesh::TriangleMesh>(const model::Mesh&, std::string& why)>
      mesh;
  /// The path of a texture that the mesh file of a shape names; empty when there is none.
  std::function<std::string(const model::Mesh&, const std::string& written)> texture;
  /// A picture by the path of its file.
  std::function<std::shared_ptr<const Picture>(const std::string& path)> picture;
  /// A picture by its bytes, which a mesh file holds.
  std::function<std::shared_ptr<const Picture>(const std::shared_ptr<const std::string>& bytes)>
      embedded_picture;
  /// The path of the file that a URI (a texture of a model) leads to; empty when there is none.
  std::function<std::string(const std::string& uri, Span where)> resolve;
  /// The text of the material scripts that a URI (of one, or of a folder of them) leads to.
  std::function<std::string(const std::string& uri, Span where)> scripts;
};

struct DrawingOptions {
  std::set<Layer> layers{Layer::kVisual, Layer::kGround};
};

/// The same with all visuals gray, as opaque as they are: its shapes alone.
Drawing in_gray(Drawing drawing);

/// Everything of the file at the poses of `frames`. Of static models neither inertia nor center of mass is shown.
/// The root and its sources are as `read::load` made them.
Drawing draw(const model::Root& root, const model::Frames& frames, const Sources& sources,
             const Files& files, const DrawingOptions& options);

}  // namespace rigor::view
