// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SVG_PLOT_H
#define INTRINSIC_SVG_PLOT_H

#include <ostream>
#include <string>
#include <vector>

namespace program {

/// The shape of a point in a plot.
enum class Marker { circle, square, triangle, diamond, cross };

/// How a series is told from others: by more than its color, for those who do not see it.
struct Series_style {
  std::string color = "#000000";  ///< in hexadecimal
  Marker marker = Marker::circle; ///< of points
  std::string dash;               ///< of lines, as `stroke-dasharray`; empty is solid
};

/// A point of a series.
struct Plot_point {
  double x = 0, y = 0;
  std::string label;      ///< shown when the mouse rests on the point
  bool is_hollow = false; ///< such as bounds, in contrast to measurements
};

/// What is drawn of a series.
enum class Series_kind { points, line_with_points, steps };

/// A series of points in one style.
struct Series {
  std::string name;
  Series_style style;
  Series_kind kind = Series_kind::points;
  std::vector<Plot_point> points;
};

/// An axis. Logarithmic axes have a place for zero if there are points with a zero.
struct Plot_axis {
  std::string label;
  bool is_logarithmic = true;
};

/// A plot with a legend. Linear axes go from 0 to 1.
struct Plot {
  std::string title;
  Plot_axis x, y;
  std::vector<Series> series;
};

/// Bars over categories, side by side for each series, logarithmic.
struct Bar_chart {
  /// The heights of the bars of one color, one per category.
  struct Bars {
    std::string name;
    Series_style style;
    std::vector<double> heights;
  };
  std::string title, x_label, y_label;
  std::vector<std::string> categories;
  std::vector<Bars> bars;
};

/// returns `text` with the characters replaced that mean something in HTML and XML.
std::string escaped(const std::string& text);

/// writes a plot as an `svg` element. Points that are not finite, or negative, are left out.
void write_svg(std::ostream& out, const Plot& plot);
/// writes a bar chart as an `svg` element; heights below 1 have no bar.
void write_svg(std::ostream& out, const Bar_chart& chart);

} // namespace program

#endif // INTRINSIC_SVG_PLOT_H
