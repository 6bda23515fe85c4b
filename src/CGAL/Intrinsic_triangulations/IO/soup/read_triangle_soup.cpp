// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/scan_OFF.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/scan_PLY.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/scan_STL.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>

#include <CGAL/IO/GOCAD.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Scans the vertices and faces of a Wavefront OBJ file; everything else is skipped, as programs write statements of their own.
class OBJ_scanner {
public:
  OBJ_scanner(std::istream& in, Soup_builder& out) : in_(in), out_(out) {
    out_.first_reference = 1;
    out_.forward_references = true;
  }

  void run() {
    std::string_view line;
    while (in_.next_content_line(line, '#')) {
      out_.line = in_.line_number();
      // a backslash continues the line
      if (const auto last = line.find_last_not_of(" \t\r");
          last != std::string_view::npos && line[last] == '\\') {
        joined_ += line.substr(0, last);
        joined_ += ' ';
        continue;
      }
      if (joined_.empty()) {
        scan(line);
      } else {
        joined_ += line;
        scan(joined_);
        joined_.clear();
      }
    }
    if (!joined_.empty()) scan(joined_);
    const bool is_empty = out_.needs_faces || out_.number_of_vertices() == 0;
    if (is_empty && out_.number_of_faces() == 0 && unknown_line_ != 0) {
      out_.line = unknown_line_;
      out_.fail(std::string("the line is not a statement of an OBJ file, and the file has no ") +
                (out_.needs_faces ? "faces" : "points") +
                "; give it the "
                "extension of its format");
    }
  }

private:
  void scan(std::string_view line) {
    const std::string_view word = next_word(line);
    if (word == "v")
      scan_vertex(line);
    else if (word == "f")
      scan_face(line);
    else if (unknown_line_ == 0 && !is_known(word))
      unknown_line_ = out_.line;
  }

  void scan_vertex(std::string_view line) {
    double p[3];
    for (double& x : p)
      if (!parse_number(next_word(line), x))
        out_.fail_vertex(
            " does not have three coordinates that are numbers; correct the line, or get "
            "a complete copy if the file is truncated");
    out_.add_vertex(p[0], p[1], p[2]);
  }

  // f v/vt/vn ...: negative references count back from the latest vertex.
  void scan_face(std::string_view line) {
    face_.clear();
    const auto count = std::int64_t(out_.number_of_vertices());
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      const std::string_view reference = word.substr(0, word.find('/'));
      std::int64_t v = 0;
      if (!parse_number(reference, v) || v == 0)
        out_.fail_face(" refers to vertex \"" + shown(reference) +
                       "\"; references are whole numbers other than 0: correct the line");
      if (v < 0 && -v > count)
        out_.fail_face(" refers to vertex " + std::to_string(v) + ", but only " +
                       std::to_string(count) +
                       " vertices come before it; correct the index or remove the face");
      face_.push_back(v > 0 ? v - 1 : count + v);
    }
    out_.add_face(face_);
  }

  static bool is_known(std::string_view word) {
    static constexpr std::array<std::string_view, 50> statements{
        "vt",       "vn",      "vp",         "p",      "l",         "g",      "s",      "o",
        "mg",       "bevel",   "c_interp",   "ctech",  "d_interp",  "lod",    "usemap", "usemtl",
        "mtllib",   "maplib",  "shadow_obj", "stech",  "trace_obj", "cstype", "deg",    "step",
        "bmat",     "con",     "curv",       "curv2",  "surf",      "parm",   "trim",   "hole",
        "scrv",     "sp",      "end",        "bsp",    "bzp",       "cdc",    "cdp",    "res",
        "call",     "csh",     "surf_1",     "surf_2", "q0_1",      "q1_1",   "q0_2",   "q1_2",
        "curv2d_1", "curv2d_2"};
    return std::ranges::find(statements, word) != statements.end();
  }

  Buffered_input in_;
  Soup_builder& out_;
  std::string joined_;
  std::size_t unknown_line_ = 0; // the first
  std::vector<std::int64_t> face_;
};

// Scans a list of points: three coordinates at the start of each line. What follows is skipped, as programs write normals and
// colors there.
class XYZ_scanner {
public:
  XYZ_scanner(std::istream& in, Soup_builder& out) : in_(in), out_(out) {}

  void run() {
    std::string_view line;
    while (in_.next_content_line(line, '#')) {
      out_.line = in_.line_number();
      if (out_.number_of_vertices() == 0 && !has_count_ && scan_count(line)) continue;
      scan_point(line);
    }
    if (out_.number_of_vertices() < count_)
      out_.fail(Element_kind::vertex, out_.number_of_vertices(),
                "the file ends before point " + std::to_string(out_.number_of_vertices()) +
                    " of the " + std::to_string(count_) +
                    " that its first line announces; it is truncated: get a complete copy");
    out_.line = 0;
  }

private:
  // The first line may hold the number of points, alone.
  bool scan_count(std::string_view line) {
    const std::string_view word = next_word(line);
    has_count_ = next_word(line).empty() && parse_number(word, count_);
    return has_count_;
  }

  void scan_point(std::string_view line) {
    double p[3];
    for (double& x : p) {
      const std::string_view word = next_word(line);
      if (!parse_number(word, x))
        fail(word.empty() ? " has fewer than three coordinates"
                          : " has \"" + shown(word) + "\" in place of a coordinate");
      if (!std::isfinite(x)) fail(" has a coordinate that is not a finite number");
    }
    out_.add_vertex(p[0], p[1], p[2]);
  }

  [[noreturn]] void fail(const std::string& what) const {
    const std::size_t v = out_.number_of_vertices();
    out_.fail(Element_kind::vertex, v,
              "point " + std::to_string(v) + what +
                  "; start the line with three numbers that are separated by spaces, or remove it");
  }

  Buffered_input in_;
  Soup_builder& out_;
  std::size_t count_ = 0;
  bool has_count_ = false;
};

// Scans a triangulated surface of GOCAD by CGAL's reader, which has no bound on lines: they are looked at before.
void scan_GOCAD(std::istream& in, Soup_builder& out) {
  Buffered_input lines(in);
  for (std::string_view line; lines.next_line(line);) continue;
  in.clear();
  in.seekg(0);
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::array<std::int32_t, 3>> triangles;
  const bool good = CGAL::IO::read_GOCAD(in, points, triangles);
  out.reserve(points.size(), triangles.size());
  for (const auto& p : points) out.add_vertex(p.x(), p.y(), p.z());
  std::vector<std::int64_t> face;
  for (const auto& t : triangles) {
    face.assign(t.begin(), t.end());
    out.add_face(face);
  }
  if (!good)
    out.fail("the file cannot be read as a GOCAD surface beyond vertex " +
             std::to_string(points.size()) + " and face " + std::to_string(triangles.size()) +
             "; get a complete copy if it is truncated, or correct what follows them");
}

void scan_mesh_file(const std::string& filename, std::uintmax_t size, Soup_builder& out) {
  std::ifstream in(filename, std::ios::binary);
  if (!in) out.fail("the file cannot be opened; check its permissions");
  const std::string extension =
      plain_extension(std::filesystem::path(filename).extension().string());
  if (extension == "off")
    OFF_scanner(in, size, out).run();
  else if (extension == "obj")
    OBJ_scanner(in, out).run();
  else if (extension == "ply")
    PLY_scanner(in, size, out).run();
  else if (extension == "stl")
    STL_scanner(in, size, out).run();
  else if (extension == "ts")
    scan_GOCAD(in, out);
  else if (extension == "xyz" || extension == "pwn")
    XYZ_scanner(in, out).run();
  else
    out.fail("the extension \"" + shown(extension) +
             "\" is not supported; convert the mesh to .off, .obj, .ply, .stl or .ts, or points to "
             ".xyz");
}

} // namespace internal

Triangle_soup read_triangle_soup(const std::string& filename, Nonplanar_polygons polygons,
                                 File_faces faces) {
  internal::Soup_builder out(filename, polygons);
  out.needs_faces = faces == File_faces::needed;
  out.takes_faces = faces != File_faces::ignored;
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(filename, error);
  if (!std::filesystem::exists(status)) out.fail("the file does not exist; check the name");
  if (std::filesystem::is_directory(status))
    out.fail("this is a directory; name a mesh file in it");
  const bool regular = std::filesystem::is_regular_file(status);
  const std::uintmax_t size = regular ? std::filesystem::file_size(filename, error) : 0;
  if (error)
    out.fail("the file cannot be examined (" + error.message() + "); check its permissions");
  if (regular && size == 0) out.fail("the file is empty; get a complete copy");
  try {
    internal::scan_mesh_file(filename, size, out);
    return out.finish();
  } catch (const internal::Buffered_input::Line_too_long& found) {
    out.line = found.line;
    out.fail(found.message);
  } catch (const std::bad_alloc&) {
    out.line = 0;
    out.fail(
        "there is not enough memory to read the mesh; use a machine with more, or a smaller mesh");
  }
}

} // namespace CGAL::Intrinsic_triangulations
