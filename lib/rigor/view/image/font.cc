// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/image/font.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace rigor::view {
namespace {

// Strokes are apart by spaces. Two digits of base 16 are a point, x and y; the baseline is at 4, the height of small
// letters at b, of capitals at e. Of a stroke that begins with '~' the corners are rounded.
// clang-format off
constexpr std::string_view kStrokes[] = {
    "",                                              // space
    "1e17 14",                                       // !
    "0e0b 3e3b",                                     // "
    "3e24 6e54 1b8b 0777",                           // #
    "~7c5e1e0c0a397875541406 4f43",                  // $
    "~2e0e0b4b4e2e ~775754949777 7e24",              // %
    "~841b1e5e5b080464 6488",                        // &
    "0e0b",                                          // '
    "~3f0c0633",                                     // (
    "~0f3c3603",                                     // )
    "3e38 0c6a 0a6c",                                // *
    "4c44 0888",                                     // +
    "1402",                                          // ,
    "0858",                                          // -
    "04",                                            // .
    "6f02",                                          // /
    "~4e0e04848e4e",                                 // 0
    "0c3e34",                                        // 1
    "~0b0e7e7a04 0474",                              // 2
    "~0c1e6e7c6939 ~397986741406",                   // 3
    "5e0787 5e54",                                   // 4
    "7e1e09 ~092a8a841406",                          // 5
    "~6e2c0904848a1a07",                             // 6
    "0e7e24",                                        // 7
    "~4e1e19797e4e ~490904848949",                   // 8
    "~2466898e0e08788b",                             // 9
    "04 0a",                                         // :
    "1a 1402",                                       // ;
    "7c0874",                                        // <
    "0a8a 0686",                                     // =
    "0c7804",                                        // >
    "~0b0e7e7a3937 34",                              // ?
    "~4b2b26666b4b ~6b6696999e0e0373",               // @
    "044e84 1777",                                   // A
    "040e4e ~4e7e7949 0949 ~49898444 4404",          // B
    "~8c7e0e047486",                                 // C
    "040e3e ~3e8e8434 3404",                         // D
    "7e0e0474 0969",                                 // E
    "7e0e04 0969",                                   // F
    "~8c7e0e048489 8949",                            // G
    "0e04 8e84 0989",                                // H
    "0e04",                                          // I
    "5e57 ~57540407",                                // J
    "0e04 7e08 2a84",                                // K
    "0e0474",                                        // L
    "040e478e84",                                    // M
    "040e848e",                                      // N
    "~5e0e04a4ae5e",                                 // O
    "040e4e ~4e8e8848 4808",                         // P
    "~5e0e04a4ae5e 67a3",                            // Q
    "040e4e ~4e8e8848 4808 4884",                    // R
    "~7c5e1e0c0a397875541406",                       // S
    "0e8e 4e44",                                     // T
    "0e08 ~08048488 888e",                           // U
    "0e448e",                                        // V
    "0e345c74ae",                                    // W
    "0e84 8e04",                                     // X
    "0e498e 4944",                                   // Y
    "0e8e0484",                                      // Z
    "3f0f0333",                                      // [
    "0f62",                                          // backslash
    "0f3f3303",                                      // ]
    "0b3e6b",                                        // ^
    "0282",                                          // _
    "0f2d",                                          // `
    "7b74 ~796b0b046476",                            // a
    "0e04 ~091b7b741406",                            // b
    "~6a5b0b045465",                                 // c
    "7e74 ~796b0b046476",                            // d
    "0878 ~787b0b046475",                            // e
    "~4e1e1b 1b14 0b4b",                             // f
    "7b74 ~796b0b046476 ~74700001",                  // g
    "0e04 ~080b7b78 7874",                           // h
    "0b04 0e",                                       // i
    "2b24 ~242000 2e",                               // j
    "0e04 6b07 2864",                                // k
    "0e06 ~060434",                                 // l
    "0b04 ~080b5b58 5854 ~585baba8 a8a4",            // m
    "0b04 ~080b7b78 7874",                           // n
    "~4b0b04848b4b",                                 // o
    "0b00 ~091b7b741406",                            // p
    "7b70 ~796b0b046476",                            // q
    "0b04 ~080b4b5a",                                // r
    "~6a5b0b0867641405",                             // s
    "1e17 ~171444 0b4b",                             // t
    "0b07 ~07047477 7b74",                           // u
    "0b346b",                                        // v
    "0b244a648b",                                    // w
    "0b64 6b04",                                     // x
    "0b34 6b10",                                     // y
    "0b6b0464",                                      // z
    "~4f2f2909 ~09292343",                           // {
    "0f02",                                          // |
    "~0f2f2949 ~49292303",                           // }
    "~082b5679",                                     // ~
};
// clang-format on
constexpr char kFirstLetter = ' ';

constexpr double kBaseline = 4;
/// Between letters, and the width of a space.
constexpr double kLetterGap = 3.2;
constexpr double kSpace = 2;
/// Each doubles the points of a rounded stroke.
constexpr int kRoundings = 3;

using Point = std::array<double, 2>;

double digit(char c) { return c <= '9' ? c - '0' : c - 'a' + 10; }

std::vector<Point> points_of(std::string_view stroke) {
  std::vector<Point> points;
  for (std::size_t i = 0; i + 1 < stroke.size(); i += 2) {
    points.push_back({digit(stroke[i]), digit(stroke[i + 1]) - kBaseline});
  }
  return points;
}

/// Cuts corners so that a quadratic B-spline comes out (Chaikin, 1974); the ends stay.
std::vector<Point> rounded(const std::vector<Point>& points) {
  if (points.size() < 3) return points;
  const auto between = [](const Point& a, const Point& b, double share) {
    return Point{a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
  };
  std::vector<Point> result{points.front()};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (i > 0) result.push_back(between(points[i], points[i + 1], 0.25));
    if (i + 2 < points.size()) result.push_back(between(points[i], points[i + 1], 0.75));
  }
  result.push_back(points.back());
  return result;
}

std::string_view strokes_of(char c) {
  const auto index = static_cast<std::size_t>(static_cast<unsigned char>(c));
  constexpr auto kFirst = static_cast<std::size_t>(kFirstLetter);
  const bool known = index >= kFirst && index < kFirst + std::size(kStrokes);
  return kStrokes[known ? index - kFirst : static_cast<std::size_t>('?') - kFirst];
}

}  // namespace

Letter letter(char c) {
  Letter result;
  double width = c == ' ' ? kSpace : 0;
  std::string_view strokes = strokes_of(c);
  while (!strokes.empty()) {
    const std::size_t end = std::min(strokes.find(' '), strokes.size());
    std::string_view stroke = strokes.substr(0, end);
    strokes.remove_prefix(std::min(end + 1, strokes.size()));
    const bool round = stroke.starts_with('~');
    if (round) stroke.remove_prefix(1);
    std::vector<Point> points = points_of(stroke);
    for (int i = 0; round && i < kRoundings; ++i) points = rounded(points);
    if (points.size() == 1) points.push_back(points.front());  // a dot
    for (const Point& point : points) width = std::max(width, point[0]);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      result.segments.push_back({points[i][0], points[i][1], points[i + 1][0], points[i + 1][1]});
    }
  }
  result.advance = width + kLetterGap;
  return result;
}

double text_width(std::string_view text) {
  double width = 0;
  for (const char c : text) width += letter(c).advance;
  return width;
}

}  // namespace rigor::view
