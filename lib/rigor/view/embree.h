// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Embree, which finds what a ray meets, opened when a picture is traced. It is
// linked to nothing, so only its headers are needed to build, and no other
// command pays for loading it.
//
//   const Embree embree = open_embree();
//   if (!embree.problem.empty()) return embree.problem;
//   const RTCDevice device = embree.new_device("threads=1");

#pragma once

#include <embree3/rtcore.h>

#include <string>

namespace rigor::view {

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
  decltype(&rtcIntersect1) intersect = nullptr;
  decltype(&rtcOccluded1) occluded = nullptr;
  std::string problem;  ///< why there is none
};

/// The library stays open until the program ends: its threads do not like to be
/// unloaded.
Embree open_embree();

}  // namespace rigor::view
