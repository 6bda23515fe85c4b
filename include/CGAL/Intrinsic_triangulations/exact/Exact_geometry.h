// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_GEOMETRY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_GEOMETRY_H

#include <CGAL/Intrinsic_triangulations/exact/Exact_evaluation.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Face_versions.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Input_unfolder.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief knows all values of a triangulation exactly, by the input: decides signs that stored values leave open, and encloses
values.

The input under a diamond or a face is found by an `Input_unfolder`. Where there is none, or strips would be too long, the flips
are repeated, of which there is a history as long as no vertex is inserted.

All members but the constructors ask for rounding upwards.
*/
class Exact_geometry {
public:
  /// Number type of enclosures.
  using FT = Interval_nt<false>;

  /// knows nothing.
  Exact_geometry() = default;

  /// takes the input, before the first flip. \pre no face of the input has the edge of its halfedge twice
  explicit Exact_geometry(const std::shared_ptr<const Input>& input);

  /// returns the input, which defines all values.
  const Input_metric& input() const { return *input_; }
  /// returns the flips so far, and which of them made each face. \pre `!is_defined_by_places()`
  const Face_versions& versions() const { return versions_; }
  /// returns how signs were decided, which may be reset.
  Predicate_statistics& statistics() const { return statistics_; }

  /// records a flip.
  void flip(const Diamond& d) {
    if (!is_defined_by_places_) versions_.flip(d);
  }
  /// returns which versions the faces of a diamond are.
  std::array<Face_versions::Version, 2> versions_at(const Diamond& d) const {
    if (is_defined_by_places_) return {};
    return {versions_.version(d.f), versions_.version(d.g)};
  }
  /// takes the last flip out of the history. \param before what `versions_at()` returned before it
  void forget_flip(const Diamond& d, const std::array<Face_versions::Version, 2>& before) {
    if (is_defined_by_places_) return;
    versions_.forget_flip(d, before);
    evaluation_.forget_flip(versions_.history().number_of_flips());
  }
  /// takes who unfolds the input, which must outlive this object. Copies have none, until they are given one.
  void unfold_by(Input_unfolder& unfolder) { unfolder_.pointer = &unfolder; }
  /// defines values by the input that is unfolded from now on, not by the history of flips, which is forgotten.
  /// \pre someone unfolds the input, whatever is asked for
  void forget_flips();
  /// tells whether values are defined by places of vertices on the input.
  bool is_defined_by_places() const { return is_defined_by_places_; }

  /*!
  \brief returns the exact sign of an expression in the values of a diamond, of any degree.
  \param d the diamond
  \param expression the expression
  \param better set to intervals that contain the values, if any were computed
  */
  Sign sign(const Diamond& d, const Recorded_diamond_expression& expression,
            Diamond_values<FT>& better) const;

  /// returns the exact sign of an expression in the values of faces; see above.
  Sign sign(std::span<const Indexed_face> faces, const Recorded_face_expression& expression,
            std::vector<Face_values<FT>>& better) const;

  /// returns intervals that contain the values of faces, computed in so many bits; 53: doubles.
  std::vector<Face_values<FT>> enclosures(std::span<const Indexed_face> faces, unsigned bits) const;

  /// returns an interval that contains the squared length of the first side of a face; see above.
  FT first_squared_length(const Indexed_face& face, unsigned bits) const;

  /*!
  \brief returns the double nearest to the cotangent weight of a diamond by repeating flips, if they are not
  too many, and 256 bits tell which one that is: nothing of a tie.
  */
  std::optional<double> weight_by_flips(const Diamond& d) const;

  /*!
  \brief returns the double nearest to the cotangent weight of a diamond.
  \pre the weight is not zero
  \complexity that of the precision that it takes
  \note Flat diamonds are unfolded too: which ones are known to be flat depends on what was asked before.
  */
  double nonzero_weight(const Diamond& d) const;

private:
  // not copied: each triangulation has its own
  struct Unfolder {
    Input_unfolder* pointer = nullptr;

    Unfolder() = default;
    Unfolder(const Unfolder&) {}
    Unfolder& operator=(const Unfolder&) {
      pointer = nullptr;
      return *this;
    }
  };

  Input_unfolder* unfolder() const;

  // the input under a diamond, if that is known
  const Unfolded_diamond* unfolded(const Diamond& d) const;

  // the input under faces, if that is known of all
  std::optional<std::vector<Unfolded_diamond>> unfolded(std::span<const Indexed_face> faces) const;

  // by repeating flips, if these are some of them only: to unfold, all have to be followed first. It does not ask
  // whether they have been: intervals must not depend on who unfolds.
  std::optional<Sign> sign_by_flips(const Diamond& d, const Recorded_diamond_expression& expression,
                                    Diamond_values<FT>& better) const;

  // in integers of fixed size, if two faces of the input are known to be there
  std::optional<Sign> sign_on_input(const Diamond& d,
                                    const Recorded_diamond_expression& expression) const;

  // by positions in space, if the diamond is known to lie in one plane
  std::optional<Sign> sign_in_plane(const Diamond& d, const Recorded_diamond_expression& expression,
                                    Diamond_values<FT>& better) const;

  Face_versions versions_;
  std::shared_ptr<const Input_metric> input_; // immutable, shared by copies
  Unfolder unfolder_;                         // of the triangulation
  bool is_defined_by_places_ = false;
  mutable Exact_evaluation evaluation_;     // remembers
  mutable Predicate_statistics statistics_; // counts
};

} // namespace CGAL::Intrinsic_triangulations

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/exact/Exact_geometry_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_GEOMETRY_H
