// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/html/svg_plot.h>

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::report {
namespace {

/// Of the line, not of the grid.
std::string drawn(const std::string& svg) {
  const std::size_t begin = svg.find("class=\"s0\" d=\"") + 14;
  return svg.substr(begin, svg.find('"', begin) - begin);
}

/// Zero for a second, one for another: its four corners are all that the line needs.
TEST(SvgPlot, OfALevelStretchOnlyTheEndsAreDrawn) {
  std::vector<double> times;
  std::vector<double> values;
  for (int i = 0; i <= 200; ++i) {
    times.push_back(i / 100.0);
    values.push_back(i <= 100 ? 0 : 1);
  }
  const std::string line = drawn(svg_plot({"Step", "m"}, times, {{"step", values}}));
  EXPECT_EQ(std::count(line.begin(), line.end(), 'M'), 1) << line;
  EXPECT_EQ(std::count(line.begin(), line.end(), 'L'), 3) << line;
}

/// There and back again along a line: the turning point is its far end.
TEST(SvgPlot, APathKeepsWhereItTurns) {
  const std::string line = drawn(svg_path({"Path", "m"}, {0, 1, 2, 3, 2, 1}, {0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(std::count(line.begin(), line.end(), 'L'), 2) << line;
}

/// A robot that stands: the nanometers by which a solver moves it are a level line.
TEST(SvgPlot, DoesNotBlowUpNoise) {
  const std::vector<double> times{0, 1, 2, 3};
  const std::string noise =
      drawn(svg_plot({"Height", "m"}, times, {{"base", {0.1, 0.100000001, 0.0999999995, 0.1}}}));
  const std::string constant =
      drawn(svg_plot({"Height", "m"}, times, {{"base", {0.1, 0.1, 0.1, 0.1}}}));
  EXPECT_EQ(noise, constant);
}

}  // namespace
}  // namespace rigor::report
