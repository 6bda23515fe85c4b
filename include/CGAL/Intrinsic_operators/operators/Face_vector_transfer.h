// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_FACE_VECTOR_TRANSFER_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_FACE_VECTOR_TRANSFER_H

#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/NumberedTriangulation.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief takes tangent vector fields that are constant on faces between an intrinsic triangulation and its
input, to the nearest ones in the L2 norm (§4.11.2 of the course).

A vector is a complex number in the frame of its face, whose real axis runs along the first halfedge of
the face, `halfedge_of_face()`. Faces have the numbers of the subdivision: those of the input for
the user, intrinsic ones for the triangulation. A face of the subdivision lies in one face of each; its corners
in both frames give the rotation r between them, and the nearest field is the average

    v_g = sum over cells c in g of |c| r_c v_f(c) / |g|

Fields are interpreted face by face, and no vector is carried through a vertex: the rotation is
well-defined though the surface is curved.
*/
class Face_vector_transfer {
public:
  /*!
  \brief finds the rotations.
  \tparam Triangulation a model of `NumberedTriangulation`
  \param t the triangulation
  \param s its common subdivision with the input
  \complexity linear
  */
  template <NumberedTriangulation Triangulation>
  Face_vector_transfer(const Triangulation& t, const Common_subdivision& s)
      : input_face_(s.input_face), intrinsic_face_(s.intrinsic_face),
        area_(subdivision_areas(t, s)) {
    const Input& input = t.input();
    const Intrinsic_view<Triangulation> view(t);
    const Element_names& names = t.input().names().faces;
    for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
      const std::uint32_t base = view.halfedge_of_face(intrinsic_face_[f]),
                          there = input.halfedge_of_face(names.here(input_face_[f]));
      const Geodesic_face from(view, base), to(input, there);
      rotation_.push_back(
          internal::fitting_rotation(s.face_begin[f], s.face_begin[f + 1], [&](std::size_t c) {
            const auto p = from.position(internal::corner_in_face(view, s, base, c)),
                       q = to.position(internal::corner_in_input_face(input, s, there, c));
            return std::array{Complex(p[0], p[1]), Complex(q[0], q[1])};
          }));
    }
    input_faces_ = input.mesh().number_of_faces();
    intrinsic_faces_ = bound(intrinsic_face_);
  }

  /// takes a field from the faces of the intrinsic triangulation to those of the input.
  /// \complexity linear
  std::vector<std::complex<double>> to_input(const std::vector<std::complex<double>>& field) const {
    return average(field, intrinsic_face_, input_face_, input_faces_, false);
  }
  /// takes a field from the faces of the input to those of the intrinsic triangulation.
  /// \complexity linear
  std::vector<std::complex<double>>
  to_intrinsic(const std::vector<std::complex<double>>& field) const {
    return average(field, input_face_, intrinsic_face_, intrinsic_faces_, true);
  }

  /// returns the rotation that takes vectors from the intrinsic face of subdivision face `f` to its
  /// face of the input.
  std::complex<double> rotation(std::size_t f) const { return rotation_[f]; }

private:
  using Complex = std::complex<double>;

  static std::size_t bound(const std::vector<std::uint32_t>& numbers) {
    return numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end()) + std::size_t{1};
  }

  std::vector<Complex> average(const std::vector<Complex>& field,
                               const std::vector<std::uint32_t>& from,
                               const std::vector<std::uint32_t>& to, std::size_t size,
                               bool back) const {
    std::vector<Complex> result(size, 0), copy(size, 0);
    std::vector<double> area(size, 0);
    for (std::size_t f = 0; f < from.size(); ++f) {
      const Complex v = (back ? std::conj(rotation_[f]) : rotation_[f]) * field[from[f]];
      result[to[f]] += area_[f] * v;
      copy[to[f]] = v;
      area[to[f]] += area_[f];
    }
    for (std::size_t g = 0; g < size; ++g) result[g] = area[g] > 0 ? result[g] / area[g] : copy[g];
    return result;
  }

  std::vector<std::uint32_t> input_face_;
  std::vector<std::uint32_t> intrinsic_face_;
  std::vector<double> area_;
  std::vector<Complex> rotation_;
  std::size_t input_faces_ = 0, intrinsic_faces_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_FACE_VECTOR_TRANSFER_H
