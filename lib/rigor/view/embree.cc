// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/embree.h>

#include <dlfcn.h>

namespace rigor::view {
namespace {

#if RTC_VERSION_MAJOR >= 4
constexpr const char* kLibrary = "libembree4.so.4";
constexpr const char* kDebianPackage = "libembree4-4";

template <class Arguments>
Arguments with(Arguments arguments, RTCRayQueryContext& context, RTCFilterFunctionN filter) {
  unsigned flags = RTC_RAY_QUERY_FLAG_COHERENT;
  if (filter) flags |= RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
  arguments.flags = static_cast<RTCRayQueryFlags>(flags);
  arguments.context = &context;
  arguments.filter = filter;
  return arguments;
}
#else
constexpr const char* kLibrary = "libembree3.so.3";
constexpr const char* kDebianPackage = "libembree3-3";
#endif

}  // namespace

#if RTC_VERSION_MAJOR >= 4
RayQuery::RayQuery(RTCFilterFunctionN filter) : filter_(filter) {
  rtcInitRayQueryContext(&context_);
}

void Embree::intersect(RTCScene scene, RayQuery& query, RTCRayHit& ray) const {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments = with(arguments, query.context_, query.filter_);
  intersect1(scene, &ray, &arguments);
}

void Embree::occluded(RTCScene scene, RayQuery& query, RTCRay& ray) const {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments = with(arguments, query.context_, query.filter_);
  occluded1(scene, &ray, &arguments);
}
#else
RayQuery::RayQuery(RTCFilterFunctionN filter) {
  rtcInitIntersectContext(&context_);
  context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  context_.filter = filter;
}

void Embree::intersect(RTCScene scene, RayQuery& query, RTCRayHit& ray) const {
  intersect1(scene, &query.context_, &ray);
}

void Embree::occluded(RTCScene scene, RayQuery& query, RTCRay& ray) const {
  occluded1(scene, &query.context_, &ray);
}
#endif

Embree open_embree() {
  Embree embree;
  void* handle = ::dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (!handle) {
    embree.problem =
        std::string(kLibrary) + " is not installed (apt install " + kDebianPackage + ")";
    return embree;
  }
  const auto find = [&]<class Function>(const char* name, Function& function) {
    function = reinterpret_cast<Function>(::dlsym(handle, name));
    if (!function && embree.problem.empty()) {
      embree.problem = std::string(kLibrary) + " has no " + name;
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
  find("rtcIntersect1", embree.intersect1);
  find("rtcOccluded1", embree.occluded1);
  return embree;
}

}  // namespace rigor::view
