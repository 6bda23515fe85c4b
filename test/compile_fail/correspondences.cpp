// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Correspondences and traits that cannot do what is required: messages say which ones can.

#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>

#include <CGAL/Simple_cartesian.h>

#include <istream>

namespace IT = CGAL::Intrinsic_triangulations;

namespace case_No_correspondence {
// Queries say what to do where there is no correspondence.
// error at once: a triangulation without correspondence does not store where edges run on the input; use Integer_coordinates
bool misuse(const IT::Intrinsic_triangulation<>& t) {
  return IT::locate_on_input(t, IT::Surface_point()) ? true : false;
}
} // namespace case_No_correspondence

namespace case_subdivision_without_correspondence {
// What uses the result of a query that is refused says so after what to do.
// error at once: a triangulation without correspondence does not store where edges run on the input; use Integer_coordinates
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;
int misuse(const Triangulation& t) {
  const auto subdivision = IT::common_subdivision(t);
  for (const auto e : edges(t.mesh()))
    if (IT::trace_edge(t, e).points.empty()) return 1;
  return static_cast<int>(subdivision.number_of_faces());
}
} // namespace case_subdivision_without_correspondence

namespace case_read_signposts {
// Files say what to do where a correspondence cannot be restored.
// error at once: files hold integer coordinates, from which signposts are not made; read with Integer_coordinates
void misuse(std::istream& file) {
  using Triangulation =
      IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, IT::Signposts>;
  IT::read_intrinsic_triangulation<Triangulation>(file, "file.idt");
}
} // namespace case_read_signposts

namespace case_correspondence_without_moves {
// An observer is told of all moves.
// error: the third argument of Intrinsic_triangulation is a correspondence, such as Integer_coordinates
struct Hears_of_flips {
  template <class Triangulation>
  void start(const Triangulation&) {}
  template <class Triangulation>
  bool before(const Triangulation&, const IT::Flip&) const {
    return true;
  }
  template <class Triangulation>
  void after(const Triangulation&, const IT::Flip&) {}
};
void misuse(const IT::Intrinsic_input& input) {
  IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Hears_of_flips> t(input);
}
} // namespace case_correspondence_without_moves

namespace case_number_is_no_correspondence {
// error: the third argument of Intrinsic_triangulation is a correspondence, such as Integer_coordinates
void misuse(const IT::Intrinsic_input& input) {
  IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, double> t(input);
}
} // namespace case_number_is_no_correspondence

namespace case_kernel_is_no_traits {
// error at once: for a kernel or a number type FT write Euclidean_traits<FT>
void misuse(IT::Intrinsic_triangulation<IT::Gluing_map, CGAL::Simple_cartesian<double>>*);
} // namespace case_kernel_is_no_traits

namespace case_correspondence_is_no_traits {
// error at once: a correspondence is the third argument
void misuse(IT::Intrinsic_triangulation<IT::Gluing_map, IT::Integer_coordinates>*);
} // namespace case_correspondence_is_no_traits

namespace case_vector_in_scaled_units {
// Faces are laid out in scaled units, tangent vectors are in those of the input.
// error: could not convert .*Plane_vector<double>.*Tangent_vector
IT::Tangent_vector misuse(const IT::Input& input) {
  return {IT::Surface_point(), IT::Geodesic_face(input, 0).edge[0]};
}
} // namespace case_vector_in_scaled_units
