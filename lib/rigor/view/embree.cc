// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/embree.h>

#include <dlfcn.h>

namespace rigor::view {

Embree open_embree() {
  Embree embree;
  void* handle = ::dlopen("libembree3.so.3", RTLD_NOW | RTLD_LOCAL);
  if (!handle) {
    embree.problem = "libembree3.so.3 is not installed (apt install libembree3-3)";
    return embree;
  }
  const auto find = [&]<class Function>(const char* name, Function& function) {
    function = reinterpret_cast<Function>(::dlsym(handle, name));
    if (!function && embree.problem.empty()) {
      embree.problem = "libembree3.so.3 has no " + std::string(name);
    }
  };
  find("rtcNewDevice", embree.new_device);
  find("rtcReleaseDevice", embree.release_device);
  find("rtcGetDeviceError", embree.device_error);
  find("rtcSetDeviceErrorFunction", embree.set_error_function);
  find("rtcGetDeviceProperty", embree.device_property);
  find("rtcNewScene", embree.new_scene);
  find("rtcReleaseScene", embree.release_scene);
  find("rtcSetSceneFlags", embree.set_scene_flags);
  find("rtcCommitScene", embree.commit_scene);
  find("rtcNewGeometry", embree.new_geometry);
  find("rtcReleaseGeometry", embree.release_geometry);
  find("rtcCommitGeometry", embree.commit_geometry);
  find("rtcAttachGeometryByID", embree.attach_geometry);
  find("rtcSetNewGeometryBuffer", embree.new_buffer);
  find("rtcSetGeometryInstancedScene", embree.set_instanced_scene);
  find("rtcSetGeometryTransform", embree.set_transform);
  find("rtcIntersect1", embree.intersect);
  find("rtcOccluded1", embree.occluded);
  return embree;
}

}  // namespace rigor::view
