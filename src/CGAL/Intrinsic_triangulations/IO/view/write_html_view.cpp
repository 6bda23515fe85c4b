// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_output.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/IO/view/Page_output.h>
#include <CGAL/Intrinsic_triangulations/IO/view/drawn_geometry.h>
#include <CGAL/Intrinsic_triangulations/IO/view/page_curves.h>
#include <CGAL/Intrinsic_triangulations/IO/view/page_fields.h>
#include <CGAL/Intrinsic_triangulations/IO/view/page_surface.h>
#include <CGAL/Intrinsic_triangulations/IO/view/page_template.h>
#include <CGAL/Intrinsic_triangulations/IO/view/page_texture.h>
#include <CGAL/Intrinsic_triangulations/IO/view/page_vectors.h>
#include <CGAL/Intrinsic_triangulations/IO/view/upright.h>
#include <CGAL/Intrinsic_triangulations/IO/view/write_html_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
namespace {

// Writes the parts of a page.
class Html_view_writer {
  using Point = std::array<double, 3>;

public:
  Html_view_writer(std::ostream& out, const Common_subdivision& s, std::span<const Point> points,
                   const Html_view& view)
      : out_(out), s_(s), points_(points), view_(view), scaling_(points) {
    for (const Point& p : points) scaled_.push_back(scaling_(p));
    if (view_.fields.size() > most_fields) view_.fields = view_.fields.first(most_fields);
    choose();
    report(view.fields.size());
    if (has_face_fields(view_.fields)) surface_.separate_triangles();
  }

  // the page, its places filled
  Html_view_report write() {
    for (std::string_view rest = html_view_page; !rest.empty();) {
      out_.text(next_part(rest));
      const std::string_view place = next_part(rest);
      if (place == "title") out_.escaped(view_.title);
      if (place == "description") {
        out_.escaped(view_.description);
        if (!report_.is_complete()) out_.text("\n\n", report_.description());
      }
      if (place != "scripts") continue;
      out_.script(view_.three);
      out_.script(view_.trackball_controls);
      write_data();
    }
    if (!out_.flush()) throw std::runtime_error("the page cannot be written");
    return report_;
  }

private:
  // as the manual states; so many marks take 320 kilobytes
  static constexpr std::size_t most_fields = 64, most_marks = 20000, most_vectors = 100000;

  // What the page shows: all if there is room for it. Else curves leave most of it to the surface.
  void choose() {
    constexpr std::size_t least = 100000; // however little is allowed
    const std::size_t text = html_view_page.size() + view_.three.size() +
                             view_.trackball_controls.size() + 2 * view_.description.size() + 10000;
    const std::size_t room =
        std::max(view_.maximum_size > text ? (view_.maximum_size - text) / 4 * 3 : 0, least);
    std::size_t per_vertex = 4 * view_.fields.size() + (view_.texture.empty() ? 0 : 8);
    if (has_face_fields(view_.fields))
      per_vertex += 6 * (21 + per_vertex); // corners of about two triangles
    surface_ = whole_surface(s_, scaled_);
    curves_ = thinned_curves(view_.curves, scaling_, 0, 1);
    initial_curves_ = thinned_curves(view_.initial_curves, scaling_, 0, 1);
    mark_step_ = (number_of_marks() + most_marks - 1) / most_marks;
    const std::size_t marks = 16 * std::min(number_of_marks(), most_marks);
    const std::size_t beside = room / 5 * 2; // the surface
    vectors_ = page_vectors(view_.vectors, scaling_, mean_length(surface_.intrinsic, scaled_),
                            std::min(most_vectors, (beside - std::min(marks, beside)) / 2 / 24));
    const std::size_t fixed = marks + vectors_.bytes();
    const std::size_t lines = curves_.bytes() + initial_curves_.bytes() + fixed;
    if (surface_.bytes(per_vertex) + lines <= room) return;
    surface_ = surface_within(std::move(surface_), scaled_, per_vertex,
                              std::max(lines < room ? room - lines : 0, room / 5 * 3));
    const std::size_t taken = surface_.bytes(per_vertex) + fixed;
    const std::size_t left = room - std::min(room, taken);
    initial_curves_ = curves_within(view_.initial_curves, scaling_,
                                    std::max(left / 4, left - std::min(left, curves_.bytes())));
    curves_ = curves_within(view_.curves, scaling_, left - std::min(left, initial_curves_.bytes()));
  }

  std::size_t number_of_marks() const {
    std::size_t n = 0;
    for (const Polyline& mark : view_.marks) n += mark.points.size();
    return n;
  }

  void report(std::size_t fields) {
    for (std::size_t f = 0; f < s_.number_of_faces(); ++f)
      report_.pieces += std::max<std::size_t>(s_.face(f).size(), 2) - 2;
    for (const auto& curves : {view_.curves, view_.initial_curves})
      for (const Polyline& curve : curves)
        if (curve.number_of_segments() > 0) ++report_.curves;
    report_.shown_pieces = surface_.triangles.size();
    report_.shown_curves = curves_.sizes.size() + initial_curves_.sizes.size();
    report_.curve_tolerance =
        std::max(curves_.tolerance, initial_curves_.tolerance) * scaling_.radius();
    report_.cell = surface_.cell * scaling_.radius();
    report_.fields = fields;
    report_.shown_fields = view_.fields.size();
    report_.marks = number_of_marks();
    report_.vectors = vectors_.given;
    report_.shown_vectors = vectors_.places.size();
    report_.shown_marks = mark_step_ == 0 ? 0 : (report_.marks + mark_step_ - 1) / mark_step_;
  }

  void write_data() {
    write_points();
    write_triangles();
    write_vertices();
    write_edges("input-edges", surface_.input);
    write_edges("intrinsic-edges", surface_.intrinsic);
    write_settings();
    for (std::size_t i = 0; i < view_.fields.size(); ++i)
      write_field("field-" + std::to_string(i), view_.fields[i]);
    write_texture();
    write_curves("curves", curves_);
    write_curves("initial-curves", initial_curves_);
    write_marks();
    out_.tuples("glyph-places", vectors_.places);
    out_.tuples("glyph-vectors", vectors_.vectors);
  }

  void write_triangles() {
    const std::vector<std::uint32_t>& polygon = surface_.polygon;
    out_.tuples("triangles", surface_.triangles);
    write_colors();
    out_.data("sheets", [&](Output_buffer& out) {
      if (!s_.sheet.empty())
        for (const std::uint32_t f : polygon) out.base64(s_.sheet[f]);
    });
    out_.data("sources", [&](Output_buffer& out) {
      for (const std::uint32_t f : polygon)
        for (const std::uint32_t source : {s_.intrinsic_face[f], s_.input_face[f]})
          out.base64(source);
    });
  }

  // The colour of each triangle.
  void write_colors() {
    const std::vector<Rgb_color> colors = intrinsic_face_colors(s_);
    out_.data("colors", [&](Output_buffer& out) {
      for (const std::uint32_t f : surface_.polygon)
        for (const std::uint8_t c : colors[s_.intrinsic_face[f]]) out.base64(c);
    });
  }

  void write_edges(const std::string& id, const Drawn_edges& edges) {
    out_.numbers(id, edges.ends);
    out_.numbers(id + "-room", edges.room);
    out_.numbers(id + "-sheets", edges.sheets);
  }

  // The data of a vertex: its kind, its intrinsic element, and its input element.
  void write_vertices() {
    out_.data("kinds", [&](Output_buffer& out) {
      for (const std::uint32_t v : surface_.vertices)
        out.base64(static_cast<std::uint8_t>(s_.kind(v)));
    });
    out_.data("labels", [&](Output_buffer& out) {
      for (const std::uint32_t i : surface_.vertices)
        for (const std::uint32_t label : labels_of(i)) out.base64(label);
    });
  }
  std::array<std::uint32_t, 2> labels_of(std::uint32_t i) const {
    if (i >= s_.vertices.size()) {
      const Common_subdivision::Crossing& x = s_.crossings[i - s_.vertices.size()];
      return {x.on_intrinsic.edge, x.on_input.edge};
    }
    const Common_subdivision::Vertex& v = s_.vertices[i];
    const bool is_input = v.kind == Subdivision_vertex_kind::input;
    return {v.intrinsic, is_input ? v.on_input.vertices[0] : v.input_face};
  }

  void write_settings() {
    out_.open_data("settings");
    out_.text(" data-fields=\"", view_.fields.size(), "\" data-shown=\"");
    if (view_.shown_field < view_.fields.size())
      out_.text(view_.shown_field);
    else
      out_.text(view_.has_face_colors ? "faces" : "none");
    out_.text("\" data-isolines=\"", view_.isolines, "\" data-edges=\"",
              view_.has_edges ? "shown" : "hidden", "\" data-disk=\"", view_.is_disk ? 1 : 0,
              "\" data-curve-width=\"", view_.curve_width, "\" data-marks=\"");
    out_.escaped(view_.marks_name);
    out_.text("\" data-glyphs=\"", view_.are_arrows ? "arrows" : "directions",
              "\" data-glyph-length=\"", vectors_.longest);
    write_reach();
    out_.text("\"></script>\n");
  }

  // Where a logarithm begins, and where it ends.
  void write_reach() {
    if (!view_.is_logarithm) return;
    const Texture_scaling scaling(view_.texture, view_.is_disk);
    out_.text("\" data-reach=\"", scaling({0, 0}, 0), ",", scaling({0, 0}, 1), ",",
              scaling.scaled(radius_of_logarithm(s_, points_, view_.texture)));
  }

  void write_field(std::string_view id, const Subdivision_field& field) {
    const Page_field shown = page_field(field, surface_);
    out_.open_data(id);
    out_.text(" data-name=\"");
    out_.escaped(field.name);
    out_.text("\" data-least=\"", shown.least, "\" data-greatest=\"", shown.greatest,
              "\" data-classes=\"", field.has_classes ? 1 : 0, "\">");
    out_.close_data([&](Output_buffer& out) {
      for (const float x : shown.values) out.base64(x);
    });
  }

  void write_texture() {
    const Texture_scaling scaling(view_.texture, view_.is_disk);
    out_.data("texture", [&](Output_buffer& out) {
      for (const std::uint32_t v : surface_.vertices)
        for (std::size_t c = 0; c < 2 && !view_.texture.empty(); ++c)
          out.base64(scaling(view_.texture[v], c));
    });
  }

  void write_curves(const std::string& id, const Page_curves& curves) {
    out_.tuples(id, curves.points);
    out_.numbers(id + "-sizes", curves.sizes);
    out_.numbers(id + "-labels", curves.labels);
  }

  void write_marks() {
    std::vector<std::array<float, 3>> places;
    std::vector<std::int32_t> labels;
    std::size_t i = 0;
    for (const Polyline& mark : view_.marks)
      for (const Point& p : mark.points)
        if (i++ % mark_step_ == 0) {
          places.push_back(scaling_(p));
          labels.push_back(mark.label);
        }
    out_.tuples("marks", places);
    out_.numbers("marks-labels", labels);
  }

  void write_points() {
    out_.data("points", [&](Output_buffer& out) {
      for (const std::uint32_t v : surface_.vertices)
        for (const float x : scaled_[v]) out.base64(x);
    });
    write_axes();
  }

  // Up, the sides of the bounding box, and the height along up.
  void write_axes() {
    std::vector<std::array<float, 3>> shown;
    for (const std::uint32_t v : surface_.vertices) shown.push_back(scaled_[v]);
    const Point extent = scaling_.scaled_extent();
    const Standing standing = Standing_finder(shown, surface_.triangles).find(extent);
    std::array<float, 7> axes{};
    for (std::size_t c = 0; c < 3; ++c) {
      axes[c] = static_cast<float>(standing.up[c]);
      axes[3 + c] = static_cast<float>(extent[c]);
    }
    axes[6] = static_cast<float>(standing.height);
    out_.numbers("view-axes", axes);
  }

  Page_output out_;
  const Common_subdivision& s_;
  std::span<const Point> points_;
  Html_view view_;
  Unit_ball_scaling scaling_;
  std::vector<std::array<float, 3>> scaled_;
  Page_surface surface_;
  Page_curves curves_, initial_curves_;
  Page_vectors vectors_;
  std::size_t mark_step_ = 1; // one of so many is shown
  Html_view_report report_;
};

} // namespace
} // namespace internal

Html_view_report write_html_view(std::ostream& out, const Common_subdivision& s,
                                 std::span<const std::array<double, 3>> points,
                                 const Html_view& view) {
  internal::check_output({s, points, view.fields});
  for (const Subdivision_field& field : view.fields)
    if (field.components != 1 || field.place == Subdivision_field::Place::corners)
      throw Invalid_input(Element_kind::none, 0,
                          "the field \"" + field.name +
                              "\" cannot be shown as colours; give a number per vertex or face");
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
  return internal::Html_view_writer(out, s, points, complete).write();
}

} // namespace CGAL::Intrinsic_triangulations
