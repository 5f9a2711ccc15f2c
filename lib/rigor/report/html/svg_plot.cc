// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/html/svg_plot.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include <rigor/report/html/markup.h>
#include <rigor/report/number.h>

namespace rigor::report {
namespace {

constexpr double kWidth = 360;
constexpr double kHeight = 200;
constexpr double kLeft = 52;  // room for the numbers
constexpr double kRight = 10;
constexpr double kTop = 24;
constexpr double kBottom = 24;

/// What a plot shows is in m, rad, s: below this nothing of a robot is worth a look.
constexpr double kMinSize = 1e-3;
/// m, rad, m/s or s, and a share of the largest value: rounding and a solver's last digits are smaller.
constexpr double kNoise = 1e-5;
constexpr double kNoiseShare = 1e-4;

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void hold(double value) {
    if (!std::isfinite(value)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  double span() const { return most - least; }

  /// Never empty, nor so narrow that noise fills it: a constant is a level line in the middle.
  void widen() {
    if (!(least <= most)) least = most = 0;
    const double size = std::max({std::abs(least), std::abs(most), kMinSize});
    if (span() > std::max(kNoise, kNoiseShare * size)) return;
    const double middle = (least + most) / 2;
    least = middle - 0.5 * size;
    most = middle + 0.5 * size;
  }
};

/// 1, 2 or 5 times a power of ten, so that there are some four of them in the span.
double tick_of(double span) {
  const double rough = span / 4;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (rough <= factor * power) return factor * power;
  }
  return 10 * power;
}

/// From values to places in the picture.
struct Scale {
  Range x;
  Range y;

  double px(double value) const {
    return kLeft + (value - x.least) / x.span() * (kWidth - kLeft - kRight);
  }
  double py(double value) const {
    return kHeight - kBottom - (value - y.least) / y.span() * (kHeight - kTop - kBottom);
  }
};

std::string begin_svg(const PlotTitle& title, const std::string& more) {
  return fmt::format(
      "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\"><text x=\"{}\" y=\"14\" "
      "class=\"title\">{} [{}]{}</text>",
      kWidth, kHeight, escaped(title.what), kLeft, escaped(title.what), escaped(title.unit), more);
}

std::string grid(const Scale& scale) {
  std::string out;
  const double bottom = kHeight - kBottom;
  const double right = kWidth - kRight;
  const double dx = tick_of(scale.x.span());
  for (double k = std::ceil(scale.x.least / dx); k * dx <= scale.x.most; ++k) {
    const double at = scale.px(k * dx);
    out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\"/>", at, bottom, kTop);
    out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"axis mid\">{}</text>", at,
                       kHeight - 8, number(k * dx, 4));
  }
  const double dy = tick_of(scale.y.span());
  for (double k = std::ceil(scale.y.least / dy); k * dy <= scale.y.most; ++k) {
    const double at = scale.py(k * dy);
    out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", kLeft, at, right);
    out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"axis end\">{}</text>", kLeft - 4,
                       at + 3, number(k * dy, 4));
  }
  return out;
}

/// Whether `b` lies on the level stretch from `a` to `c` as printed: the line is the same without it.
bool is_passed_over(const Scale& scale, const std::vector<double>& xs,
                    const std::vector<double>& ys, std::size_t a, std::size_t b, std::size_t c) {
  const auto finite = [&](std::size_t i) { return std::isfinite(xs[i]) && std::isfinite(ys[i]); };
  if (!finite(a) || !finite(b) || !finite(c)) return false;
  const auto tenths = [&](std::size_t i) { return std::round(10 * scale.py(ys[i])); };
  const bool between = (xs[a] <= xs[b]) == (xs[b] <= xs[c]);
  return between && tenths(a) == tenths(b) && tenths(b) == tenths(c);
}

std::string line_of(const Scale& scale, const std::vector<double>& xs,
                    const std::vector<double>& ys) {
  const std::size_t count = std::min(xs.size(), ys.size());
  const std::size_t stride = std::max<std::size_t>(1, count / kPlotPoints);
  std::string d;
  bool pen_up = true;
  for (std::size_t i = 0; i < count; i += stride) {
    if (!std::isfinite(xs[i]) || !std::isfinite(ys[i])) {
      pen_up = true;
      continue;
    }
    const bool inside = !pen_up && i + stride < count;
    if (inside && is_passed_over(scale, xs, ys, i - stride, i, i + stride)) continue;
    d += fmt::format("{}{:.1f} {:.1f}", pen_up ? 'M' : 'L', scale.px(xs[i]), scale.py(ys[i]));
    pen_up = false;
  }
  return d;
}

}  // namespace

std::string svg_plot(const PlotTitle& title, const std::vector<double>& times,
                     const std::vector<Series>& series) {
  const std::size_t drawn = std::min(series.size(), kPlotSeries);
  Scale scale;
  for (const double time : times) scale.x.hold(time);
  for (std::size_t s = 0; s < drawn; ++s) {
    for (const double value : series[s].values) scale.y.hold(value);
  }
  scale.x.widen();
  scale.y.widen();
  const std::string more =
      series.size() > drawn ? fmt::format(", {} of {}", drawn, series.size()) : std::string();
  std::string out = begin_svg(title, more) + grid(scale);
  for (std::size_t s = 0; s < drawn; ++s) {
    out += fmt::format("<path class=\"s{}\" d=\"{}\"><title>{}</title></path>", s,
                       line_of(scale, times, series[s].values), escaped(series[s].name));
  }
  return out + "</svg>";
}

std::string svg_path(const PlotTitle& title, const std::vector<double>& xs,
                     const std::vector<double>& ys) {
  Scale scale;
  for (const double x : xs) scale.x.hold(x);
  for (const double y : ys) scale.y.hold(y);
  scale.x.widen();
  scale.y.widen();
  // The tighter axis decides for both.
  const double per_x = scale.x.span() / (kWidth - kLeft - kRight);
  const double per_y = scale.y.span() / (kHeight - kTop - kBottom);
  const double unit = 1.1 * std::max(per_x, per_y);
  const auto center = [](Range& range, double span) {
    const double middle = (range.least + range.most) / 2;
    range = {middle - span / 2, middle + span / 2};
  };
  center(scale.x, unit * (kWidth - kLeft - kRight));
  center(scale.y, unit * (kHeight - kTop - kBottom));
  std::string out = begin_svg(title, {}) + grid(scale);
  out += fmt::format("<path class=\"s0\" d=\"{}\"/>", line_of(scale, xs, ys));
  if (!xs.empty() && !ys.empty() && std::isfinite(xs.back()) && std::isfinite(ys.back())) {
    out += fmt::format("<circle class=\"dot\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>",
                       scale.px(xs.back()), scale.py(ys.back()));
  }
  return out + "</svg>";
}

}  // namespace rigor::report
