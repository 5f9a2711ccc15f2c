// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Embree, which finds what a ray meets, opened when a picture is traced. It is
// linked to nothing, so only its headers are needed to build, and no other
// command pays for loading it. Version 4 is taken where its headers are installed,
// else 3; what differs between them is here.
//
//   const Embree embree = open_embree();
//   if (!embree.problem.empty()) return embree.problem;
//   const RTCDevice device = embree.new_device("threads=1");

#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <string>

namespace rigor::view {

/// Of a scene whose rays have a filter.
#if RTC_VERSION_MAJOR >= 4
inline constexpr RTCSceneFlags kQueriesFilter = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;
#else
inline constexpr RTCSceneFlags kQueriesFilter = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;
#endif

/// How a ray is traced, beside others that go nearly its way. A filter is handed its address as `met->context`,
/// so that a struct which begins with it can hold more.
class RayQuery {
 public:
  explicit RayQuery(RTCFilterFunctionN filter = nullptr);

 private:
  friend struct Embree;
#if RTC_VERSION_MAJOR >= 4
  RTCRayQueryContext context_;  // first
  RTCFilterFunctionN filter_;
#else
  RTCIntersectContext context_;
#endif
};

struct Embree {
  decltype(&rtcNewDevice) new_device = nullptr;
  decltype(&rtcReleaseDevice) release_device = nullptr;
  decltype(&rtcGetDeviceError) device_error = nullptr;
  decltype(&rtcSetDeviceErrorFunction) set_error_function = nullptr;
  decltype(&rtcGetDeviceProperty) device_property = nullptr;
  decltype(&rtcNewScene) new_scene = nullptr;
  decltype(&rtcReleaseScene) release_scene = nullptr;
  decltype(&rtcSetSceneFlags) set_scene_flags = nullptr;
  decltype(&rtcCommitScene) commit_scene = nullptr;
  decltype(&rtcNewGeometry) new_geometry = nullptr;
  decltype(&rtcReleaseGeometry) release_geometry = nullptr;
  decltype(&rtcCommitGeometry) commit_geometry = nullptr;
  decltype(&rtcAttachGeometryByID) attach_geometry = nullptr;
  decltype(&rtcSetNewGeometryBuffer) new_buffer = nullptr;
  decltype(&rtcSetGeometryInstancedScene) set_instanced_scene = nullptr;
  decltype(&rtcSetGeometryTransform) set_transform = nullptr;
  decltype(&rtcIntersect1) intersect1 = nullptr;
  decltype(&rtcOccluded1) occluded1 = nullptr;
  std::string problem;  ///< why there is none

  /// The first that the ray meets, into its hit.
  void intersect(RTCScene scene, RayQuery& query, RTCRayHit& ray) const;
  /// Whether it meets anything: then its `tfar` is negative.
  void occluded(RTCScene scene, RayQuery& query, RTCRay& ray) const;
};

/// The library stays open until the program ends: its threads do not like to be
/// unloaded.
Embree open_embree();

}  // namespace rigor::view
