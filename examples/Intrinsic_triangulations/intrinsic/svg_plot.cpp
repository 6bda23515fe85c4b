// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "svg_plot.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>

namespace program {

namespace {

// The frame of the data, in pixels; the legend is right of it.
constexpr double left = 78, right = 690, top = 40, bottom = 430, width = 900, height = 490;
constexpr double zero_slot = 36; // between where zero is drawn and the lowest decade

std::string pixel(double x) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f", x);
  return text;
}

std::string attribute(const char* name, double x) {
  return std::string(" ") + name + "=\"" + pixel(x) + '"';
}

std::string power_of_ten(int exponent) {
  static const char* const digit[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                      "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  if (exponent == 0) return "1";
  if (exponent == 1) return "10";
  std::string text = exponent < 0 ? "10\u207b" : "10";
  for (const char c : std::to_string(std::abs(exponent))) text += digit[c - '0'];
  return text;
}

// Takes values to pixels, along x or upwards along y.
class Scale {
public:
  struct Tick {
    double pixel;
    std::string label;
  };

  Scale(bool is_logarithmic, const std::vector<double>& values, double from, double to)
      : is_logarithmic_(is_logarithmic), from_(from), to_(to) {
    if (!is_logarithmic) return;
    double least = HUGE_VAL, most = 0;
    for (const double x : values) {
      has_zero_ = has_zero_ || x == 0;
      if (x > 0) least = std::min(least, x), most = std::max(most, x);
    }
    if (most == 0) least = most = 1;
    low_ = static_cast<int>(std::floor(std::log10(least) + 1e-9));
    high_ = std::max(low_ + 1, static_cast<int>(std::ceil(std::log10(most) - 1e-9)));
    if (has_zero_)
      start_ = from_ + std::copysign(zero_slot, to_ - from_);
    else
      start_ = from_;
  }

  double operator()(double x) const {
    if (!is_logarithmic_) return from_ + x * (to_ - from_);
    if (x == 0) return from_;
    return start_ + (std::log10(x) - low_) / (high_ - low_) * (to_ - start_);
  }

  std::vector<Tick> ticks() const {
    std::vector<Tick> result;
    if (!is_logarithmic_) {
      for (const char* const label : {"0", "0.2", "0.4", "0.6", "0.8", "1"})
        result.push_back({(*this)(std::stod(label)), label});
      return result;
    }
    if (has_zero_) result.push_back({from_, "0"});
    const int step = 1 + (high_ - low_) / 10;
    for (int k = low_; k <= high_; k += step)
      result.push_back({(*this)(std::pow(10, k)), power_of_ten(k)});
    return result;
  }

private:
  bool is_logarithmic_;
  double from_, to_, start_ = 0;
  int low_ = 0, high_ = 1;
  bool has_zero_ = false;
};

void write_text(std::ostream& out, double x, double y, const char* anchor, const std::string& text,
                const std::string& more = "") {
  out << "<text" << attribute("x", x) << attribute("y", y) << " text-anchor=\"" << anchor << '"'
      << more << '>' << escaped(text) << "</text>\n";
}

void write_line(std::ostream& out, double x1, double y1, double x2, double y2, const char* color) {
  out << "<line" << attribute("x1", x1) << attribute("y1", y1) << attribute("x2", x2)
      << attribute("y2", y2) << " stroke=\"" << color << "\"/>\n";
}

void open_svg(std::ostream& out, const std::string& title) {
  out << "<svg viewBox=\"0 0 " << width << ' ' << height << "\" role=\"img\" aria-label=\""
      << escaped(title) << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  write_text(out, (left + right) / 2, 22, "middle", title, " style=\"font-weight:bold\"");
}

void write_frame(std::ostream& out, const std::string& x_label, const std::string& y_label) {
  write_line(out, left, bottom, right, bottom, "#444");
  write_line(out, left, top, left, bottom, "#444");
  write_text(out, (left + right) / 2, height - 14, "middle", x_label);
  const std::string middle = pixel((top + bottom) / 2);
  write_text(out, 22, (top + bottom) / 2, "middle", y_label,
             " transform=\"rotate(-90 22 " + middle + ")\"");
}

void write_y_ticks(std::ostream& out, const Scale& y) {
  for (const Scale::Tick& t : y.ticks()) {
    write_line(out, left, t.pixel, right, t.pixel, "#e2e2e2");
    write_text(out, left - 8, t.pixel + 5, "end", t.label);
  }
}

// The outline of a marker as a path around the origin.
const char* path_of(Marker marker) {
  switch (marker) {
  case Marker::circle:
    return "M-3.5 0a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0z";
  case Marker::square:
    return "M-3.2-3.2h6.4v6.4h-6.4z";
  case Marker::triangle:
    return "M0-4.4l4.2 7.4h-8.4z";
  case Marker::diamond:
    return "M0-4.6l4.6 4.6l-4.6 4.6l-4.6-4.6z";
  case Marker::cross:
    return "M-4-2.6l1.4-1.4l2.6 2.6l2.6-2.6l1.4 1.4l-2.6 2.6l2.6 2.6l-1.4 1.4"
           "l-2.6-2.6l-2.6 2.6l-1.4-1.4l2.6-2.6z";
  }
  return "";
}

void write_marker(std::ostream& out, double x, double y, const Series_style& style, bool is_hollow,
                  const std::string& label) {
  out << "<path d=\"" << path_of(style.marker) << "\" transform=\"translate(" << pixel(x) << ' '
      << pixel(y) << ")\" stroke=\"" << style.color << "\" fill=\""
      << (is_hollow ? "white" : style.color) << '"';
  if (label.empty()) {
    out << "/>\n";
  } else {
    out << "><title>" << escaped(label) << "</title></path>\n";
  }
}

void write_polyline(std::ostream& out, const std::string& points, const Series_style& style) {
  out << "<polyline points=\"" << points << "\" fill=\"none\" stroke-width=\"1.8\" stroke=\""
      << style.color << '"';
  if (!style.dash.empty()) out << " stroke-dasharray=\"" << style.dash << '"';
  out << "/>\n";
}

void write_legend_entry(std::ostream& out, std::size_t row, const Series& series) {
  const double x = right + 24, y = top + 10 + 20 * static_cast<double>(row);
  if (series.kind != Series_kind::points)
    write_polyline(out, pixel(x - 14) + ',' + pixel(y) + ' ' + pixel(x + 14) + ',' + pixel(y),
                   series.style);
  if (series.kind != Series_kind::steps) write_marker(out, x, y, series.style, false, "");
  write_text(out, x + 22, y + 5, "start", series.name);
}

bool is_drawn(const Plot_point& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && p.x >= 0 && p.y >= 0;
}

void write_series(std::ostream& out, const Series& series, const Scale& x, const Scale& y) {
  std::string corners;
  double last = y(0);
  for (const Plot_point& p : series.points) {
    if (!is_drawn(p)) continue;
    if (series.kind == Series_kind::steps) corners += pixel(x(p.x)) + ',' + pixel(last) + ' ';
    last = y(p.y);
    corners += pixel(x(p.x)) + ',' + pixel(last) + ' ';
  }
  if (series.kind != Series_kind::points && !corners.empty())
    write_polyline(out, corners, series.style);
  if (series.kind == Series_kind::steps) return;
  for (const Plot_point& p : series.points)
    if (is_drawn(p)) write_marker(out, x(p.x), y(p.y), series.style, p.is_hollow, p.label);
}

} // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  }
  return result;
}

void write_svg(std::ostream& out, const Plot& plot) {
  std::vector<double> xs, ys;
  for (const Series& s : plot.series)
    for (const Plot_point& p : s.points) {
      if (!is_drawn(p)) continue;
      xs.push_back(p.x);
      ys.push_back(p.y);
    }
  const Scale x(plot.x.is_logarithmic, xs, left, right);
  const Scale y(plot.y.is_logarithmic, ys, bottom, top);
  open_svg(out, plot.title);
  for (const Scale::Tick& t : x.ticks()) {
    write_line(out, t.pixel, top, t.pixel, bottom, "#e2e2e2");
    write_text(out, t.pixel, bottom + 20, "middle", t.label);
  }
  write_y_ticks(out, y);
  write_frame(out, plot.x.label, plot.y.label);
  for (const Series& s : plot.series) write_series(out, s, x, y);
  for (std::size_t i = 0; i < plot.series.size(); ++i) write_legend_entry(out, i, plot.series[i]);
  out << "</svg>\n";
}

void write_svg(std::ostream& out, const Bar_chart& chart) {
  std::vector<double> heights = {1};
  for (const Bar_chart::Bars& b : chart.bars)
    heights.insert(heights.end(), b.heights.begin(), b.heights.end());
  std::erase_if(heights, [](double h) { return !(h >= 1); });
  const Scale y(true, heights, bottom, top);
  open_svg(out, chart.title);
  write_y_ticks(out, y);
  write_frame(out, chart.x_label, chart.y_label);
  const double slot = (right - left) / static_cast<double>(chart.categories.size());
  const double bar = 0.8 * slot / static_cast<double>(chart.bars.size());
  for (std::size_t c = 0; c < chart.categories.size(); ++c) {
    const double start = left + slot * static_cast<double>(c);
    write_text(out, start + slot / 2, bottom + 20, "middle", chart.categories[c]);
    for (std::size_t i = 0; i < chart.bars.size(); ++i) {
      const double h = chart.bars[i].heights[c];
      if (!(h >= 1)) continue;
      const double x = start + 0.1 * slot + bar * static_cast<double>(i);
      // a bar of height 1 is there, if only just
      const double end = std::min(y(h), bottom - 2);
      out << "<rect" << attribute("x", x) << attribute("y", end) << attribute("width", bar)
          << attribute("height", bottom - end) << " fill=\"" << chart.bars[i].style.color
          << "\"/>\n";
      char count[32];
      std::snprintf(count, sizeof(count), "%.0f", h);
      write_text(out, x + bar / 2, end - 4, "middle", count, " style=\"font-size:11px\"");
    }
  }
  for (std::size_t i = 0; i < chart.bars.size(); ++i)
    write_legend_entry(out, i, {chart.bars[i].name, chart.bars[i].style, Series_kind::points, {}});
  out << "</svg>\n";
}

} // namespace program
