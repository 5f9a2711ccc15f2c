// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// ODE's geoms. World geoms and those of bodies are of two categories, so that still things are not
// tried against each other. Cylinders and capsules have their length along z, as in SDF.
//
// A convex hull is a mesh to ODE too: its own convex shapes touch all but planes in one point, on which
// a box rocks without end.

#include <string>
#include <utility>
#include <variant>

#include <rigor/simulate/engine/ode/world.h>

namespace rigor::simulate {
namespace {

constexpr unsigned long kStill = 1;
constexpr unsigned long kMoving = 2;

dGeomID make_ode_plane(const SceneShape& shape, const HalfSpace& half, dSpaceID space) {
  if (shape.body != kWorld) throw EngineError("a plane cannot move: " + shape.name);
  const Vector3 n = model::rotate(shape.X_BS.rotation, half.normal);
  return dCreatePlane(space, n.x, n.y, n.z, dot(n, shape.X_BS.translation));
}

bool is_plane(const SceneShape& shape) { return std::holds_alternative<HalfSpace>(shape.kind); }

/// ODE's height fields have y up, x along the columns and z along the rows.
Quaternion axes_of_geom(const SceneShape& shape) {
  const Quaternion& R_BS = shape.X_BS.rotation;
  if (!std::holds_alternative<HeightGrid>(shape.kind)) return R_BS;
  return R_BS * model::from_rpy(1.5707963267948966, 0, 0);
}

void place_geom(dGeomID geom, const SceneShape& shape, const Vector3& p_BBcm, dBodyID body) {
  const Quaternion R = axes_of_geom(shape);
  const dQuaternion q{R.w, R.x, R.y, R.z};
  const Vector3& p = shape.X_BS.translation;
  if (body == nullptr) {
    dGeomSetPosition(geom, p.x, p.y, p.z);
    dGeomSetQuaternion(geom, q);
    return;
  }
  const Vector3 offset = p - p_BBcm;
  dGeomSetBody(geom, body);
  dGeomSetOffsetPosition(geom, offset.x, offset.y, offset.z);
  dGeomSetOffsetQuaternion(geom, q);
}

std::vector<dReal> coordinates_of(const mesh::TriangleMesh& mesh) {
  std::vector<dReal> points;
  points.reserve(3 * mesh.positions.size());
  for (const Vector3& p : mesh.positions) points.insert(points.end(), {p.x, p.y, p.z});
  return points;
}

/// m, of the solid under a height field's lowest point: what falls faster than this in a step would
/// come out below.
constexpr double kUnderground = 10;

}  // namespace

struct EngineShapes::Triangles {
  std::vector<dReal> points;
  std::vector<dTriIndex> indices;
  dTriMeshDataID data = nullptr;
};

EngineShapes::EngineShapes(const Scene& scene, const OdeWorld& ode) : EngineShapes() {
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const SceneShape& shape = scene.shapes[i];
    const dGeomID geom = make(scene, shape, ode.space());
    const bool moves = shape.body != kWorld;
    dGeomSetData(geom, reinterpret_cast<void*>(static_cast<std::uintptr_t>(i)));
    dGeomSetCategoryBits(geom, moves ? kMoving : kStill);
    dGeomSetCollideBits(geom, moves ? kMoving | kStill : kMoving);
    if (is_plane(shape)) continue;
    place_geom(geom, shape, moves ? scene.bodies[shape.body].mass.com : Vector3{},
               ode.body(shape.body));
  }
}

EngineShapes::~EngineShapes() {
  for (const auto& mesh : triangles_) dGeomTriMeshDataDestroy(mesh->data);
  for (dHeightfieldDataID data : heights_) dGeomHeightfieldDataDestroy(data);
}

dGeomID EngineShapes::make(const Scene& scene, const SceneShape& shape, dSpaceID space) {
  if (const auto* box = std::get_if<mesh::Box>(&shape.kind)) {
    return dCreateBox(space, box->size.x, box->size.y, box->size.z);
  }
  if (const auto* sphere = std::get_if<mesh::Sphere>(&shape.kind)) {
    return dCreateSphere(space, sphere->radius);
  }
  if (const auto* cylinder = std::get_if<mesh::Cylinder>(&shape.kind)) {
    return dCreateCylinder(space, cylinder->radius, cylinder->length);
  }
  if (const auto* capsule = std::get_if<mesh::Capsule>(&shape.kind)) {
    return dCreateCapsule(space, capsule->radius, capsule->length);
  }
  if (const auto* convex = std::get_if<ConvexHull>(&shape.kind)) {
    return triangles(scene.meshes[convex->mesh], space);
  }
  if (const auto* soup = std::get_if<TriangleSoup>(&shape.kind)) {
    return triangles(scene.meshes[soup->mesh], space);
  }
  if (const auto* grid = std::get_if<HeightGrid>(&shape.kind)) return heights(*grid, space);
  return make_ode_plane(shape, std::get<HalfSpace>(shape.kind), space);
}

dGeomID EngineShapes::triangles(const mesh::TriangleMesh& mesh, dSpaceID space) {
  auto made = std::make_unique<Triangles>();
  made->points = coordinates_of(mesh);
  made->indices.reserve(3 * mesh.triangles.size());
  for (const mesh::Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) made->indices.push_back(static_cast<dTriIndex>(corner));
  }
  made->data = dGeomTriMeshDataCreate();
  const dTriMeshDataID data = made->data;
  dGeomTriMeshDataBuildDouble(data, made->points.data(), 3 * sizeof(dReal),
                              static_cast<int>(mesh.positions.size()), made->indices.data(),
                              static_cast<int>(made->indices.size()), 3 * sizeof(dTriIndex));
  triangles_.push_back(std::move(made));
  return dCreateTriMesh(space, data, nullptr, nullptr, nullptr);
}

dGeomID EngineShapes::heights(const HeightGrid& grid, dSpaceID space) {
  const std::size_t columns = grid.columns;
  std::vector<double> turned;  // ODE's rows run against our y
  turned.reserve(grid.heights.size());
  for (std::size_t row = grid.rows; row-- > 0;) {
    const auto begin = grid.heights.begin() + static_cast<std::ptrdiff_t>(row * columns);
    turned.insert(turned.end(), begin, begin + static_cast<std::ptrdiff_t>(columns));
  }
  const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
  heights_.push_back(data);
  dGeomHeightfieldDataBuildDouble(data, turned.data(), 1, grid.width, grid.depth,
                                  static_cast<int>(grid.columns), static_cast<int>(grid.rows), 1, 0,
                                  kUnderground, 0);
  return dCreateHeightfield(space, data, 1);
}

}  // namespace rigor::simulate
