// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "command/command.h"
#include "option/mesh_operation_options.h"
#include "option/numbers.h"

namespace rigor::tool {
namespace {

using author::MeshOperations;
using author::MeshProduct;

constexpr std::pair<std::string_view, double> kUnits[] = {
    {"m", 1},         {"mm", 0.001},    {"cm", 0.01},    {"dm", 0.1},
    {"km", 1000},     {"inch", 0.0254}, {"in", 0.0254},  {"ft", 0.3048},
    {"foot", 0.3048}, {"um", 1e-6},     {"mil", 2.54e-5}};

constexpr std::string_view kUpAxes[] = {"y", "z"};
constexpr std::string_view kCenterNames[] = {"none", "com", "bounds", "bottom"};
constexpr std::string_view kFitNames[] = {"box", "sphere", "cylinder", "capsule", "best"};
constexpr std::string_view kSplitNames[] = {"component", "material"};

std::vector<std::string_view> unit_names() {
  std::vector<std::string_view> names;
  for (const auto& [name, meters] : kUnits) names.push_back(name);
  return names;
}

double meters_of(const std::string& unit) {
  return kUnits[choice("--unit", unit, unit_names())].second;
}

std::uint64_t count_of(const std::string& option, const std::string& text) {
  const double value = positive_number(option, text, "");
  if (value != std::floor(value) || value > 1e9) {
    throw UsageError(option + " " + text + ": must be a whole number");
  }
  return static_cast<std::uint64_t>(value);
}

/// A share of the triangles below 1, a number of them from 1 on.
void reduce_to(const std::string& text, MeshOperations& operations) {
  const double value = positive_number("--reduce", text, "");
  if (value < 1) {
    operations.share = value;
  } else {
    operations.triangles = count_of("--reduce", text);
  }
}

}  // namespace

void MeshOperationOptions::declare(CLI::App& app) {
  const std::string group = "What is done, in this order";
  const auto word = [&](const char* name, std::string& value, const char* what, const char* type) {
    return app.add_option(name, value, what)->type_name(type)->group(group);
  };
  app.add_flag("--weld", weld_, "Merge vertices with equal coordinates")->group(group);
  app.add_flag("--repair", repair_,
               "Drop degenerate and duplicate faces, wind consistently and outward, fill small "
               "holes, drop specks")
      ->group(group);
  offer(word("--unit", unit_, "What a unit of the file is: mm, cm, m, inch, ft…", "UNIT"),
        unit_names());
  app.add_option("--scale", scale_, "Factor: one, or one per axis")
      ->type_name("S | X Y Z")
      ->expected(1, 3)
      ->group(group);
  offer(word("--up", up_, "The file's axis that points up: y or z", "AXIS"), kUpAxes);
  offer(word("--center", center_, "Move to the origin: com, bounds, bottom, or none", "WHAT"),
        kCenterNames);
  word("--normals", normals_, "Recompute normals, smooth across edges of fewer degrees; 0 is flat",
       "DEGREES");
  word("--reduce", reduce_, "Target number of triangles, or fraction of them", "N|RATIO");
  word("--max-error", max_error_, "Stop reducing there, m", "E");
  app.add_flag("--keep-seams", keep_seams_,
               "Reduce no further than seams of texture and color allow")
      ->group(group);
  app.add_flag("--convex-hull", convex_hull_, "The convex hull")->group(group);
  word("--convex-pieces", convex_pieces_, "Maximum number of convex pieces", "N");
  offer(word("--fit", fit_, "The box, sphere, cylinder or capsule around it, or the best", "SHAPE"),
        kFitNames);
  offer(word("--split", split_, "One file for each component or material", "BY"), kSplitNames);
}

std::string MeshOperationOptions::given() const {
  const std::pair<bool, const char*> all[] = {{weld_, "--weld"},
                                              {repair_, "--repair"},
                                              {!unit_.empty(), "--unit"},
                                              {!scale_.empty(), "--scale"},
                                              {!up_.empty(), "--up"},
                                              {!center_.empty(), "--center"},
                                              {!normals_.empty(), "--normals"},
                                              {!reduce_.empty(), "--reduce"},
                                              {!max_error_.empty(), "--max-error"},
                                              {keep_seams_, "--keep-seams"},
                                              {convex_hull_, "--convex-hull"},
                                              {!convex_pieces_.empty(), "--convex-pieces"},
                                              {!fit_.empty(), "--fit"},
                                              {!split_.empty(), "--split"}};
  for (const auto& [given, option] : all) {
    if (given) return option;
  }
  return {};
}

MeshOperations MeshOperationOptions::operations() const {
  MeshOperations operations;
  operations.weld = weld_;
  operations.repair = repair_;
  if (!unit_.empty()) operations.unit = meters_of(unit_);
  if (!scale_.empty()) operations.scale = scale_factors(scale_);
  if (!up_.empty() && choice("--up axis", up_, kUpAxes) == 0) operations.up = mesh::UpAxis::kY;
  if (!center_.empty()) {
    using author::MeshCenter;
    constexpr MeshCenter kCenters[] = {MeshCenter::kNone, MeshCenter::kCom, MeshCenter::kBounds,
                                       MeshCenter::kBottom};
    operations.center = kCenters[choice("--center value", center_, kCenterNames)];
  }
  if (!normals_.empty()) {
    const double degrees = finite_number("--normals", normals_);
    if (degrees < 0 || degrees > 180) throw UsageError("--normals takes 0 to 180 degrees");
    operations.crease = degrees * std::numbers::pi / 180;
  }
  if (!reduce_.empty()) reduce_to(reduce_, operations);
  if (!max_error_.empty()) {
    if (reduce_.empty()) throw UsageError("--max-error belongs to --reduce");
    operations.max_error = positive_number("--max-error", max_error_, "m");
  }
  if (keep_seams_ && reduce_.empty()) throw UsageError("--keep-seams belongs to --reduce");
  operations.keep_seams = keep_seams_;
  set_product(operations);
  return operations;
}

void MeshOperationOptions::set_product(MeshOperations& operations) const {
  const int products =
      int{convex_hull_} + !convex_pieces_.empty() + !fit_.empty() + !split_.empty();
  if (products > 1) {
    throw UsageError("--convex-hull, --convex-pieces, --fit and --split: give one of them");
  }
  if (convex_hull_) operations.product = MeshProduct::kConvexHull;
  if (!convex_pieces_.empty()) {
    operations.product = MeshProduct::kConvexPieces;
    operations.pieces = count_of("--convex-pieces", convex_pieces_);
  }
  if (!fit_.empty()) {
    using mesh::FitKind;
    constexpr FitKind kKinds[] = {FitKind::kBox, FitKind::kSphere, FitKind::kCylinder,
                                  FitKind::kCapsule, FitKind::kBest};
    operations.product = MeshProduct::kPrimitive;
    operations.primitive = kKinds[choice("--fit shape", fit_, kFitNames)];
  }
  if (!split_.empty()) {
    const bool by_material = choice("--split value", split_, kSplitNames) == 1;
    operations.product = by_material ? MeshProduct::kMaterials : MeshProduct::kComponents;
  }
}

}  // namespace rigor::tool
