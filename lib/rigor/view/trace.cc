// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/trace.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <thread>

#include <rigor/text/in_threads.h>
#include <rigor/view/embree.h>
#include <rigor/view/shading.h>
#include <rigor/view/stage.h>

namespace rigor::view {
namespace {

/// Sheets of glass that one ray looks through: what lies behind so many is not
/// seen.
constexpr int kMaxSheets = 24;
/// Of a mark's opacity, when it lies inside something solid.
constexpr float kSeenThrough = 0.5F;
/// Below this nothing of what lies behind is seen.
constexpr float kNothingLeft = 0.01F;
/// Of the distance: what is drawn on a surface (a collision on the visual of
/// the same shape) is in front.
constexpr double kOnSurface = 1e-4;
/// Neighbors that differ by more, of 255, are an edge, which is examined with
/// all samples.
constexpr int kEdge = 6;
constexpr unsigned kMaxSamples = 16;
constexpr unsigned kMaxThreads = 256;

/// Light times opacity, and opacity.
struct Coverage {
  Light light;
  float opacity = 0;
};

Coverage over(const Coverage& front, const Coverage& back) {
  const float left = 1 - front.opacity;
  return {front.light + left * back.light, front.opacity + left * back.opacity};
}

Coverage covering(const Light& light, float opacity) { return {opacity * light, opacity}; }

class Tracer {
 public:
  Tracer(const Stage& stage, const Camera& camera, const TraceOptions& options,
         const Encoding& encoding)
      : stage_(stage), camera_(camera), options_(options), encoding_(encoding) {
    half_height_ =
        camera.field_of_view > 0 ? std::tan(camera.field_of_view / 2) : camera.height / 2;
    half_width_ = half_height_ * options.width / options.height;
    back_ = covering(Encoding::to_linear(options.background),
                     std::clamp(options.background.a, 0.0F, 1.0F));
  }

  /// One row by a sample of each pixel. Neighbors look at different thirds of theirs, so that a line
  /// thinner than a pixel does not pass between all of them.
  void draft_row(std::uint32_t y, Picture& draft) const {
    const bool alone = options_.samples < 2;
    for (std::uint32_t x = 0; x < options_.width; ++x) {
      const double right = alone ? 0.5 : ((x + y) % 3 + 0.5) / 3;
      const double down = alone ? 0.5 : ((x + 2 * y) % 3 + 0.5) / 3;
      draft.at(x, y) = encoded(seen(ray_at(x + right, y + down)));
    }
  }

  /// The same with all samples, where the draft has an edge.
  void fair_row(std::uint32_t y, const Picture& draft, Picture& fair) const {
    for (std::uint32_t x = 0; x < options_.width; ++x) {
      fair.at(x, y) = on_edge(draft, x, y) ? all_samples(x, y) : draft.at(x, y);
    }
  }

 private:
  Ray ray_at(double x, double y) const {
    const double right = (2 * x / options_.width - 1) * half_width_;
    const double up = (1 - 2 * y / options_.height) * half_height_;
    const model::Vector3 across = right * camera_.right + up * camera_.up;
    const model::Vector3 eye = camera_.eye - stage_.middle();
    if (camera_.field_of_view <= 0) return {eye + across, camera_.forward};
    const model::Vector3 direction = camera_.forward + across;
    return {eye, (1 / std::sqrt(dot(direction, direction))) * direction};
  }

  static bool differ(const Pixel& a, const Pixel& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (std::abs(int{a[i]} - int{b[i]}) > kEdge) return true;
    }
    return false;
  }

  bool on_edge(const Picture& draft, std::uint32_t x, std::uint32_t y) const {
    if (options_.samples < 2) return false;
    const Pixel& own = draft.at(x, y);
    for (std::uint32_t j = y == 0 ? 0 : y - 1; j <= std::min(y + 1, draft.height - 1); ++j) {
      for (std::uint32_t i = x == 0 ? 0 : x - 1; i <= std::min(x + 1, draft.width - 1); ++i) {
        if (differ(own, draft.at(i, j))) return true;
      }
    }
    return false;
  }

  Pixel all_samples(std::uint32_t x, std::uint32_t y) const {
    const unsigned n = std::min(options_.samples, kMaxSamples);
    Coverage sum;
    for (unsigned j = 0; j < n; ++j) {
      for (unsigned i = 0; i < n; ++i) {
        const Coverage one = seen(ray_at(x + (i + 0.5) / n, y + (j + 0.5) / n));
        sum = {sum.light + one.light, sum.opacity + one.opacity};
      }
    }
    const float share = 1 / static_cast<float>(n * n);
    return encoded({share * sum.light, share * sum.opacity});
  }

  Pixel encoded(const Coverage& coverage) const {
    if (coverage.opacity <= 0) return {0, 0, 0, 0};
    const Light light = (1 / coverage.opacity) * coverage.light;
    return {encoding_.to_srgb(light.r), encoding_.to_srgb(light.g), encoding_.to_srgb(light.b),
            static_cast<std::uint8_t>(std::min(1.0F, coverage.opacity) * 255 + 0.5F)};
  }

  Coverage seen(const Ray& ray) const {
    const std::optional<Hit> solid = stage_.first_solid(ray);
    Coverage back = back_;
    if (solid) back = over(solid_seen(ray, *solid), back);
    if (!stage_.has_glass()) return back;
    return through_glass(ray, solid ? solid->t : INFINITY, back);
  }

  Coverage solid_seen(const Ray& ray, const Hit& hit) const {
    const Touched touched = stage_.touched(hit, ray);
    const model::Vector3 point = ray.origin + hit.t * ray.direction;
    const double left = stage_.is_ground(hit) ? stage_.ground_left(point) : 1;
    if (left <= 0) return {};
    const bool turned_to_lamp = dot(touched.facet, kTowardsLamp) > 0;
    const float lamp = turned_to_lamp && stage_.reaches_lamp(point) ? 1 : 0;
    return covering(lit(touched.paint.light, touched.normal, -1.0 * ray.direction, lamp),
                    static_cast<float>(left));
  }

  /// What glass and marks lie before `back`, which begins at `wall`; marks
  /// behind it shine through.
  Coverage through_glass(const Ray& ray, double wall, const Coverage& back) const {
    const double on_wall = wall * (1 + kOnSurface);
    const double farthest = stage_.has_marks() ? INFINITY : on_wall;
    Coverage front;
    Coverage inside;
    double from = 0;
    for (int sheet = 0; sheet < kMaxSheets && front.opacity < 1 - kNothingLeft; ++sheet) {
      const std::optional<Hit> hit = stage_.first_glass(ray, from, farthest);
      if (!hit) break;
      // Sheets in one place are one: which of them comes first is chance.
      from = hit->t + std::max(2 * kInOnePlace * hit->t, 1e-7 * stage_.size());
      const bool hidden = hit->t > on_wall;
      if (hidden && !stage_.is_mark(*hit)) continue;
      const Touched touched = stage_.touched(*hit, ray);
      float opacity = touched.paint.opacity;
      float lamp = 1;
      if (stage_.is_ground(*hit)) {
        const model::Vector3 point = ray.origin + hit->t * ray.direction;
        opacity *= static_cast<float>(stage_.ground_left(point));
        if (opacity > 0 && !stage_.reaches_lamp(point)) lamp = 0;
      }
      const Light light = lit(touched.paint.light, touched.normal, -1.0 * ray.direction, lamp);
      if (hidden) {
        inside = over(inside, covering(light, opacity));
        if (inside.opacity > 1 - kNothingLeft) break;
      } else {
        front = over(front, covering(light, opacity));
      }
      if (stage_.ground_is_all_glass()) break;
    }
    inside = {kSeenThrough * inside.light, kSeenThrough * inside.opacity};
    return over(front, over(inside, back));
  }

  const Stage& stage_;
  const Camera& camera_;
  const TraceOptions& options_;
  const Encoding& encoding_;
  double half_width_ = 1;
  double half_height_ = 1;
  Coverage back_;
};

/// Each row once, by whichever thread is free: rows know nothing of each other.
template <class Work>
void for_each_row(std::uint32_t rows, unsigned threads, const Work& work) {
  std::atomic<std::uint32_t> next{0};
  in_threads(threads, [&](std::size_t) {
    for (std::uint32_t y = next++; y < rows; y = next++) work(y);
  });
}

unsigned threads_for(const TraceOptions& options) {
  const unsigned wanted =
      options.threads == 0 ? std::max(1U, std::thread::hardware_concurrency()) : options.threads;
  return std::min({wanted, kMaxThreads, options.height});
}

}  // namespace

Traced trace(const Drawing& drawing, const Camera& camera, const TraceOptions& options) {
  if (options.width == 0 || options.height == 0 || options.width > kMaxPixels / options.height) {
    return {std::nullopt, "no image has this size"};
  }
  const Embree embree = open_embree();
  const Encoding encoding;
  const Stage stage(embree, drawing, encoding);
  if (!stage.problem().empty()) return {std::nullopt, stage.problem()};

  const Tracer tracer(stage, camera, options, encoding);
  Picture draft{options.width, options.height, {}};
  draft.pixels.resize(std::size_t{options.width} * options.height);
  Picture fair = draft;
  const unsigned threads = threads_for(options);
  for_each_row(options.height, threads, [&](std::uint32_t y) { tracer.draft_row(y, draft); });
  for_each_row(options.height, threads, [&](std::uint32_t y) { tracer.fair_row(y, draft, fair); });
  return {std::move(fair), {}};
}

std::string tracer() {
  const Embree embree = open_embree();
  if (!embree.problem.empty()) return {};
  const RTCDevice device = embree.new_device("threads=1,start_threads=0");
  if (!device) return {};
  const auto number = [&](RTCDeviceProperty property) {
    return std::to_string(embree.device_property(device, property));
  };
  std::string name = "Embree " + number(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + '.' +
                     number(RTC_DEVICE_PROPERTY_VERSION_MINOR) + '.' +
                     number(RTC_DEVICE_PROPERTY_VERSION_PATCH);
  embree.release_device(device);
  return name;
}

}  // namespace rigor::view
