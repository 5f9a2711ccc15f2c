// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Small line plots as SVG, for pages that load nothing. Colors are the page's: the classes `s0` to `s5`,
// `axis` and `grid`.
//
//   page += svg_plot({"Height", "m"}, times, {{"base", heights}});
//   page += svg_path({"From above", "m"}, xs, ys);

#pragma once

#include <string>
#include <vector>

namespace rigor::report {

struct PlotTitle {
  std::string what;
  std::string unit;
};

struct Series {
  std::string name;
  std::vector<double> values;  ///< as many as there are times
};

/// Series have so many colors; more are left out, and counted in the title.
inline constexpr std::size_t kPlotSeries = 6;

/// Of a longer series every n-th point is drawn, so that the page of a long run stays small.
inline constexpr std::size_t kPlotPoints = 400;

/// Values over time, s. What is not finite is a gap.
std::string svg_plot(const PlotTitle& title, const std::vector<double>& times,
                     const std::vector<Series>& series);

/// A path in a plane, both axes to one scale; a dot at its end.
std::string svg_path(const PlotTitle& title, const std::vector<double>& xs,
                     const std::vector<double>& ys);

}  // namespace rigor::report
