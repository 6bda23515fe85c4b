// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_output.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/IO/view/drawn_geometry.h>
#include <CGAL/Intrinsic_triangulations/IO/view/write_html_view.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
namespace {

// The page with the program that draws and answers to the pointer; text between two @ is a place to
// be filled. The file is HTML between the marks of a raw string.
#ifndef DOXYGEN_RUNNING // which does not look for files here
constexpr std::string_view html_view_page =
#include <CGAL/Intrinsic_triangulations/IO/view/html_view_page.html>
    ;
#endif

// Writes the parts of a page.
class Html_view_writer {
  using Point = std::array<double, 3>;

public:
  Html_view_writer(std::ostream& out, const Common_subdivision& s, std::span<const Point> points,
                   const Html_view& view)
      : out_(out), s_(s), points_(points), view_(view), scaling_(points) {}

  // the page, its places filled
  void write() {
    for (std::string_view rest = html_view_page; !rest.empty();) {
      out_.text(next_part(rest));
      const std::string_view place = next_part(rest);
      if (place == "title") escaped(view_.title);
      if (place == "description") escaped(view_.description);
      if (place == "scripts") write_scripts();
    }
    if (!out_.flush()) throw std::runtime_error("the page cannot be written");
  }

private:
  // takes what comes before the next @, and that, off the front
  static std::string_view next_part(std::string_view& rest) {
    const std::string_view part = rest.substr(0, rest.find('@'));
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    return part;
  }

  void write_scripts() {
    script(view_.three);
    script(view_.trackball_controls);
    write_data();
  }

  void escaped(std::string_view text) {
    constexpr std::string_view special = "<>&\"";
    constexpr std::array<std::string_view, 4> names{"&lt;", "&gt;", "&amp;", "&quot;"};
    for (const char c : text)
      if (const std::size_t i = special.find(c); i != std::string_view::npos)
        out_.text(names[i]);
      else
        out_.text(c);
  }

  // An end tag inside a script would end it, in capitals too; in a string of JavaScript <\/ is </.
  void script(std::string_view text) {
    out_.text("<script>\n");
    for (std::size_t i = text.find("</"); i != std::string_view::npos; i = text.find("</")) {
      out_.text(text.substr(0, i),
                i + 2 < text.size() && (text[i + 2] | 32) == 's' ? "<\\/" : "</");
      text.remove_prefix(i + 2);
    }
    out_.text(text, "\n</script>\n");
  }

  template <class Write>
  void data(std::string_view id, Write write) {
    open_data(id);
    out_.text(">");
    close_data(write);
  }
  template <class Numbers>
  void numbers(std::string_view id, const Numbers& all) {
    data(id, [&](Output_buffer& out) {
      for (const auto x : all) out.base64(x);
    });
  }
  template <class Tuples>
  void tuples(std::string_view id, const Tuples& all) {
    data(id, [&](Output_buffer& out) {
      for (const auto& tuple : all)
        for (const auto x : tuple) out.base64(x);
    });
  }
  void open_data(std::string_view id) {
    out_.text("<script type=\"application/octet-stream;base64\" id=\"", id, "\"");
  }
  template <class Write>
  void close_data(Write write) {
    write(out_);
    out_.finish_base64();
    out_.text("</script>\n");
  }

  void write_data() {
    write_points();
    write_triangles();
    write_vertices();
    write_edges("input-edges", &Common_subdivision::Side::input_edge, s_.input_face);
    write_edges("intrinsic-edges", &Common_subdivision::Side::intrinsic_edge, s_.intrinsic_face);
    write_settings();
    for (std::size_t i = 0; i < view_.fields.size(); ++i)
      write_field("field-" + std::to_string(i), view_.fields[i]);
    write_texture();
    write_curves("curves", view_.curves);
    write_curves("initial-curves", view_.initial_curves);
    write_marks();
  }

  // A fan for each convex polygon.
  void write_triangles() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::size_t> polygon;
    for (std::size_t f = 0; f < s_.number_of_faces(); ++f)
      for (std::size_t k = 2; k < s_.face(f).size(); ++k) {
        triangles.push_back({s_.face(f)[0], s_.face(f)[k - 1], s_.face(f)[k]});
        polygon.push_back(f);
      }
    tuples("triangles", triangles);
    write_colors(polygon);
    data("sheets", [&](Output_buffer& out) {
      if (!s_.sheet.empty())
        for (const std::size_t f : polygon) out.base64(s_.sheet[f]);
    });
    data("sources", [&](Output_buffer& out) {
      for (const std::size_t f : polygon)
        for (const std::uint32_t source : {s_.intrinsic_face[f], s_.input_face[f]})
          out.base64(source);
    });
  }

  // The colour of each triangle, of a polygon each.
  void write_colors(const std::vector<std::size_t>& polygon) {
    const std::vector<Rgb_color> colors = intrinsic_face_colors(s_);
    data("colors", [&](Output_buffer& out) {
      for (const std::size_t f : polygon)
        for (const std::uint8_t c : colors[s_.intrinsic_face[f]]) out.base64(c);
    });
  }

  void write_edges(const std::string& id, std::uint32_t Common_subdivision::Side::*edge_of,
                   const std::vector<std::uint32_t>& face_of) {
    const Drawn_edges edges = drawn_edges(s_, scaled_, edge_of, face_of);
    numbers(id, edges.ends);
    numbers(id + "-room", edges.room);
    numbers(id + "-sheets", edges.sheets);
  }

  // The data of a vertex: its kind, its intrinsic element, and its input element.
  void write_vertices() {
    data("kinds", [&](Output_buffer& out) {
      for (std::size_t v = 0; v < s_.number_of_vertices(); ++v)
        out.base64(static_cast<std::uint8_t>(s_.kind(v)));
    });
    data("labels", [&](Output_buffer& out) {
      for (const Common_subdivision::Vertex& v : s_.vertices) {
        out.base64(v.intrinsic);
        out.base64(v.kind == Subdivision_vertex_kind::input ? v.on_input.vertices[0]
                                                            : v.input_face);
      }
      for (const Common_subdivision::Crossing& x : s_.crossings) {
        out.base64(x.on_intrinsic.edge);
        out.base64(x.on_input.edge);
      }
    });
  }

  void write_settings() {
    open_data("settings");
    out_.text(" data-fields=\"", view_.fields.size(), "\" data-shown=\"");
    if (view_.shown_field < view_.fields.size())
      out_.text(view_.shown_field);
    else
      out_.text(view_.has_face_colors ? "faces" : "none");
    out_.text("\" data-isolines=\"", view_.isolines, "\" data-edges=\"",
              view_.has_edges ? "shown" : "hidden", "\" data-curve-width=\"", view_.curve_width,
              "\" data-marks=\"");
    escaped(view_.marks_name);
    out_.text("\"></script>\n");
  }

  // Values from 0 to 1 in single precision, and their range; halves, so that nothing overflows.
  void write_field(std::string_view id, const Subdivision_field& field) {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const double x : field.values)
      if (std::isfinite(x)) {
        least = std::min(least, x);
        greatest = std::max(greatest, x);
      }
    if (greatest < least) least = greatest = 0;
    const double range = greatest / 2 - least / 2;
    open_data(id);
    out_.text(" data-name=\"");
    escaped(field.name);
    out_.text("\" data-least=\"", least, "\" data-greatest=\"", greatest, "\">");
    close_data([&](Output_buffer& out) {
      for (const double x : field.values)
        out.base64(!std::isfinite(x) ? std::numeric_limits<float>::quiet_NaN()
                   : range > 0       ? static_cast<float>((x / 2 - least / 2) / range)
                                     : 0.f);
    });
  }

  // Places in the plane, of which the longer side of the bounding box becomes 1.
  void write_texture() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto is_place = [](const std::array<double, 2>& p) {
      return std::isfinite(p[0]) && std::isfinite(p[1]);
    };
    std::array<double, 2> least{infinity, infinity}, greatest{-infinity, -infinity};
    for (const std::array<double, 2>& p : view_.texture)
      for (std::size_t c = 0; c < 2 && is_place(p); ++c) {
        least[c] = std::min(least[c], p[c]);
        greatest[c] = std::max(greatest[c], p[c]);
      }
    const double size = std::max(greatest[0] - least[0], greatest[1] - least[1]);
    data("texture", [&](Output_buffer& out) {
      for (const std::array<double, 2>& p : view_.texture)
        for (std::size_t c = 0; c < 2; ++c)
          out.base64(!is_place(p) ? std::numeric_limits<float>::quiet_NaN()
                     : size > 0   ? static_cast<float>((p[c] - least[c]) / size)
                                  : 0.f);
    });
  }

  // Both ends of each line, and its label.
  void write_curves(const std::string& id, std::span<const Polyline> curves) {
    std::vector<std::array<float, 3>> ends;
    std::vector<std::int32_t> labels;
    for (const Polyline& curve : curves)
      for (std::size_t i = 0; i < curve.number_of_segments(); ++i) {
        for (const std::size_t k : {i, (i + 1) % curve.points.size()})
          ends.push_back(scaling_(curve.points[k]));
        labels.push_back(curve.label);
      }
    tuples(id, ends);
    numbers(id + "-labels", labels);
  }

  void write_marks() {
    std::vector<std::array<float, 3>> places;
    std::vector<std::int32_t> labels;
    for (const Polyline& mark : view_.marks) {
      for (const Point& p : mark.points) places.push_back(scaling_(p));
      labels.insert(labels.end(), mark.points.size(), mark.label);
    }
    tuples("marks", places);
    numbers("marks-labels", labels);
  }

  void write_points() {
    for (const Point& p : points_) scaled_.push_back(scaling_(p));
    tuples("points", scaled_);
    write_axes(scaling_.extent());
  }

  // Look mostly along the shortest side of the bounding box; y is up unless that is along y.
  void write_axes(const Point& extent) {
    const auto shortest =
        static_cast<std::size_t>(std::min_element(extent.begin(), extent.end()) - extent.begin());
    const bool is_flat = extent[shortest] <= 1e-6 * std::max({extent[0], extent[1], extent[2]});
    Point eye{0.45, 0.4, 0.55};
    eye[shortest] = is_flat ? 2 : 0.8;
    if (is_flat) eye[(shortest + 1) % 3] = eye[(shortest + 2) % 3] = 0;
    const double length = std::hypot(eye[0], eye[1], eye[2]);
    std::array<float, 6> axes{}; // to the eye, up
    for (std::size_t c = 0; c < 3; ++c) axes[c] = static_cast<float>(eye[c] / length);
    axes[shortest == 1 ? 5 : 4] = 1;
    numbers("view-axes", axes);
  }

  Output_buffer out_;
  const Common_subdivision& s_;
  std::span<const Point> points_;
  const Html_view& view_;
  Unit_ball_scaling scaling_;
  std::vector<std::array<float, 3>> scaled_;
};

} // namespace
} // namespace internal

Three_js find_three_js(const std::filesystem::path& directory) {
  const auto text = [&](const std::filesystem::path& folder, const std::filesystem::path& name) {
    std::ifstream file(directory / name, std::ios::binary);
    if (!file) file = std::ifstream(directory / folder / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  return {text("build", "three.min.js"), text("examples/js/controls", "TrackballControls.js")};
}

void write_html_view(std::ostream& out, const Common_subdivision& s,
                     std::span<const std::array<double, 3>> points, const Html_view& view) {
  internal::check_output({s, points, view.fields});
  for (const Subdivision_field& field : view.fields)
    if (!field.is_function())
      throw Invalid_input(Element_kind::none, 0,
                          "the field \"" + field.name +
                              "\" cannot be shown as colours; give a number per vertex");
  if (!view.texture.empty() && view.texture.size() != s.number_of_vertices())
    throw Invalid_input(Element_kind::none, 0,
                        "the texture has " + std::to_string(view.texture.size()) +
                            " places; give one for each of the " +
                            std::to_string(s.number_of_vertices()) +
                            " vertices of the common subdivision");
  Html_view complete = view;
  const bool has_scripts = !view.three.empty() && !view.trackball_controls.empty();
  const Three_js found = has_scripts ? Three_js() : find_three_js();
  if (view.three.empty()) complete.three = found.three;
  if (view.trackball_controls.empty()) complete.trackball_controls = found.trackball_controls;
  if (complete.three.empty() || complete.trackball_controls.empty())
    throw Invalid_input(Element_kind::none, 0,
                        "the page needs three.js and its TrackballControls.js; install Debian's "
                        "package libjs-three, or give their texts, see find_three_js()");
  internal::Html_view_writer(out, s, points, complete).write();
}

} // namespace CGAL::Intrinsic_triangulations
