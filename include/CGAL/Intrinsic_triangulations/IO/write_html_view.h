// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_WRITE_HTML_VIEW_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_WRITE_HTML_VIEW_H

#include <CGAL/Intrinsic_triangulations/IO/Base64_writer.h>
#include <CGAL/Intrinsic_triangulations/IO/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/IO/html_view_page.h>
#include <CGAL/Intrinsic_triangulations/IO/write_common_subdivision_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/for_each_subdivision_edge.h>
#include <CGAL/Intrinsic_triangulations/correspondence/intrinsic_face_colors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells what a page shows besides an intrinsic triangulation, and the scripts that it needs.
*/
struct Html_view {
  /// Title of the page.
  std::string_view title;
  /// Text under the title.
  std::string_view description;
  /// Text of three.js, revision 111 or near: it is copied into the page, with its licence notice.
  std::string_view three;
  /// Text of the classic script `TrackballControls.js` of the same distribution.
  std::string_view trackball_controls;
  /// A field to be shown as colours; without values the intrinsic faces have their own.
  Vertex_field field{};
};

namespace internal {

/// Writes the parts of a page.
class Html_view_writer {
  using Point = std::array<double, 3>;

public:
  Html_view_writer(std::ostream& out, const Common_subdivision& s, std::span<const Point> points,
                   const Html_view& view)
      : out_(out), s_(s), points_(points), view_(view) {}

  void write() {
    out_.text("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>");
    escaped(view_.title);
    out_.text("</title>\n", html_view_style, "<div id=\"panel\"><h1>");
    escaped(view_.title);
    out_.text("</h1><p>");
    escaped(view_.description);
    out_.text("</p>\n", html_view_controls);
    script(view_.three);
    script(view_.trackball_controls);
    write_data();
    out_.text("<script>document.getElementById(\"scalar-name\").textContent = "
              "document.getElementById(\"scalar-title\").textContent;</script>\n");
    out_.text(html_view_program);
    if (!out_.flush()) throw std::runtime_error("the page cannot be written");
  }

private:
  void escaped(std::string_view text) {
    for (const char c : text) switch (c) {
      case '<':
        out_.text("&lt;");
        break;
      case '>':
        out_.text("&gt;");
        break;
      case '&':
        out_.text("&amp;");
        break;
      case '"':
        out_.text("&quot;");
        break;
      default:
        out_.text(c);
      }
  }

  // an end tag inside a script would end it
  void script(std::string_view text) {
    out_.text("<script>\n");
    constexpr std::string_view end = "</script";
    for (std::size_t i = text.find(end); i != std::string_view::npos; i = text.find(end)) {
      out_.text(text.substr(0, i), "<\\/script");
      text.remove_prefix(i + end.size());
    }
    out_.text(text, "\n</script>\n");
  }

  template <class Write>
  void data(std::string_view id, Write write) {
    out_.text("<script type=\"application/octet-stream;base64\" id=\"", id, "\">");
    Base64_writer base64(out_);
    write(base64);
    base64.finish();
    out_.text("</script>\n");
  }

  // A fan for each convex polygon; the visitor takes the polygon and three vertices.
  template <class Visit>
  void for_each_triangle(Visit visit) const {
    for (std::size_t f = 0; f < s_.number_of_faces(); ++f) {
      const std::span<const std::uint32_t> v = s_.face(f);
      for (std::size_t k = 2; k < v.size(); ++k) visit(f, std::array{v[0], v[k - 1], v[k]});
    }
  }

  void write_data() {
    write_points();
    data("triangles", [&](Base64_writer& out) {
      for_each_triangle([&](std::size_t, const std::array<std::uint32_t, 3>& t) {
        for (const std::uint32_t v : t) out.put(v);
      });
    });
    const std::vector<Rgb_color> colors = intrinsic_face_colors(s_);
    data("colors", [&](Base64_writer& out) {
      for_each_triangle([&](std::size_t f, const auto&) {
        for (const std::uint8_t c : colors[s_.intrinsic_face[f]]) out.put(c);
      });
    });
    data("sources", [&](Base64_writer& out) {
      for_each_triangle([&](std::size_t f, const auto&) {
        out.put(s_.intrinsic_face[f]);
        out.put(s_.input_face[f]);
      });
    });
    write_edges("input-edges", [](const Common_subdivision::Side& side) {
      return side.input_edge != Common_subdivision::none;
    });
    write_edges("intrinsic-edges", [](const Common_subdivision::Side& side) {
      return side.intrinsic_edge != Common_subdivision::none;
    });
    out_.text("<script type=\"text/plain\" id=\"scalar-title\">");
    escaped(view_.field.name);
    out_.text("</script>\n");
    data("scalars", [&](Base64_writer& out) {
      for (const double x : view_.field.values) out.put(static_cast<float>(x));
    });
  }

  template <class Predicate>
  void write_edges(std::string_view id, Predicate is_shown) {
    data(id, [&](Base64_writer& out) {
      for_each_subdivision_edge(
          s_, [&](std::uint32_t a, std::uint32_t b, const Common_subdivision::Side& side) {
            if (!is_shown(side)) return;
            out.put(a);
            out.put(b);
          });
    });
  }

  // Centred and scaled to the unit ball before they are rounded to single precision; half of each
  // coordinate is taken first, so that no difference overflows.
  void write_points() {
    Point low = halved(points_.front()), high = low;
    for (const Point& p : points_)
      for (std::size_t c = 0; c < 3; ++c) {
        low[c] = std::min(low[c], p[c] / 2);
        high[c] = std::max(high[c], p[c] / 2);
      }
    const Point extent{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
    const double greatest = std::max({extent[0], extent[1], extent[2]});
    const double unit = greatest > 0 ? greatest : 1;
    const double radius = std::hypot(extent[0] / unit, extent[1] / unit, extent[2] / unit) / 2;
    data("points", [&](Base64_writer& out) {
      for (const Point& p : points_)
        for (std::size_t c = 0; c < 3; ++c) {
          const double x = ((p[c] / 2 - low[c]) - extent[c] / 2) / unit;
          out.put(static_cast<float>(radius > 0 ? x / radius : x));
        }
    });
    write_axes(extent);
  }

  static Point halved(const Point& p) { return {p[0] / 2, p[1] / 2, p[2] / 2}; }

  // Look mostly along the shortest side of the bounding box; y is up unless that is along y.
  void write_axes(const Point& extent) {
    const auto shortest =
        static_cast<std::size_t>(std::min_element(extent.begin(), extent.end()) - extent.begin());
    const bool is_flat = extent[shortest] <= 1e-6 * std::max({extent[0], extent[1], extent[2]});
    Point eye{0.45, 0.4, 0.55};
    eye[shortest] = is_flat ? 2 : 0.8;
    if (is_flat) eye[(shortest + 1) % 3] = eye[(shortest + 2) % 3] = 0;
    const double length = std::hypot(eye[0], eye[1], eye[2]);
    data("view-axes", [&](Base64_writer& out) {
      for (const double x : eye) out.put(static_cast<float>(x / length));
      for (std::size_t c = 0; c < 3; ++c)
        out.put(static_cast<float>(c == (shortest == 1 ? 2 : 1) ? 1 : 0));
    });
  }

  Output_buffer out_;
  const Common_subdivision& s_;
  std::span<const Point> points_;
  const Html_view& view_;
};

} // namespace internal

/*!
\brief writes a page that shows an intrinsic triangulation on the surface: one file that needs no
network.

Intrinsic faces have colours that differ between neighbours, intrinsic edges are dark, input edges
light; a field replaces the colours. The pointer shows the numbers of the faces under it.
\param out the stream
\param s the common subdivision
\param points the position of each vertex, see `positions()`
\param view title, scripts, field
\throws Invalid_input if `points` or the field do not have one value for each vertex, or scripts are
  missing
\throws std::runtime_error if the stream fails
\complexity linear
*/
inline void write_html_view(std::ostream& out, const Common_subdivision& s,
                            std::span<const std::array<double, 3>> points, const Html_view& view) {
  if (view.field.values.empty())
    internal::check_output(s, points, {});
  else
    internal::check_output(s, points, std::span(&view.field, 1));
  if (view.three.empty() || view.trackball_controls.empty())
    throw Invalid_input(Element_kind::none, 0,
                        "the page needs three.js and its TrackballControls.js; Debian's package "
                        "libjs-three has them");
  internal::Html_view_writer(out, s, points, view).write();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_WRITE_HTML_VIEW_H
