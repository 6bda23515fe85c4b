// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_ARCHETYPES_H
#define TEST_INTRINSIC_TRIANGULATIONS_ARCHETYPES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/enum.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

// Models that offer only the requirements of a concept. Algorithms that compile with them use no
// more than the concept promises. They say that everything is Delaunay already.

namespace archetypes {

namespace IT = CGAL::Intrinsic_triangulations;

/// Can be copied only if the concept requires it.
struct Flips {
  using FT = double;
  struct Scope {};
  static constexpr bool is_exact = false;

  Flips() = default;
  Flips(Flips&&) = default;
  Flips& operator=(Flips&&) = default;
  Flips(const Flips&) = delete;
  Flips& operator=(const Flips&) = delete;
  Flips(const IT::Gluing_map&, const IT::Input_metric&) {}

  bool is_locally_delaunay(const IT::Diamond&) const { return true; }
  struct Flipped {};
  std::optional<Flipped> compute_flip(const IT::Diamond&) const { return Flipped(); }
  void store_flip(const IT::Diamond&, const Flipped&) noexcept {}
  int scale_exponent() const { return 0; }
};

/// A model of `IntrinsicMetric`, and no more.
struct Flipping_metric : Flips {
  using Flips::Flips;
  CGAL::Sign delaunay_sign(const IT::Diamond&) const { return CGAL::POSITIVE; }
  bool is_flippable(const IT::Diamond&) const { return true; }
};

/// A model of `EuclideanMetric`, and no more.
struct Metric : Flips {
  using Flips::Flips;
  template <class Expression>
  CGAL::Sign sign(const IT::Diamond&, const Expression&) const {
    return CGAL::POSITIVE;
  }
  std::optional<Flipped> compute_flip_to_zero_area(const IT::Diamond&) const { return Flipped(); }
  double cotangent_weight(const IT::Diamond&) const { return 0; }
  double cotangent_weight(std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t) const {
    return 0;
  }
  bool is_degenerate(std::uint32_t) const { return false; }
  bool is_zero_length(std::uint32_t) const { return false; }
  double squared_length(std::uint32_t) const { return 1; }
  double quadruple_area(std::uint32_t) const { return 1; }
  double approximate_squared_length(std::uint32_t) const { return 1; }
  double approximate_quadruple_area(std::uint32_t) const { return 1; }
};

struct Flipping_traits {
  using FT = double;
  using Metric = archetypes::Flipping_metric;
};
struct Traits {
  using FT = double;
  using Metric = archetypes::Metric;
};

template <class Move>
concept Documented_move = std::same_as<Move, IT::Flip> ||
    std::same_as<Move, IT::Insertion_in_face> || std::same_as<Move, IT::Insertion_on_border> ||
    std::same_as<Move, IT::Removal_from_face> || std::same_as<Move, IT::Removal_from_border>;

/// Counts all moves.
struct Correspondence {
  Correspondence() = default;
  Correspondence(Correspondence&&) = default;
  Correspondence& operator=(Correspondence&&) = default;
  Correspondence(const Correspondence&) = delete;
  Correspondence& operator=(const Correspondence&) = delete;

  template <class Triangulation>
  void start(const Triangulation&) {}
  template <class Triangulation, Documented_move Move>
  bool before(const Triangulation&, const Move&) const {
    ++announced;
    return true;
  }
  template <class Triangulation, Documented_move Move>
  void make_room(const Triangulation&, const Move&) {}
  template <class Triangulation, Documented_move Move>
  void after(const Triangulation&, const Move&) noexcept {
    ++done;
  }
  mutable int announced = 0;
  int done = 0;
};

/// Has no metric: it is Delaunay after one flip of every edge.
class Triangulation {
public:
  using Mesh = IT::Gluing_map;
  struct Metric {
    static constexpr bool is_exact = true;
  };
  using halfedge_descriptor = Mesh::Halfedge;
  using edge_descriptor = Mesh::Edge;

  class Const_session {
  public:
    explicit Const_session(const Triangulation& t) : t_(t) {}
    Const_session(const Const_session&) = delete;
    Const_session& operator=(const Const_session&) = delete;
    bool is_locally_delaunay(halfedge_descriptor h) const { return t_.flipped_[h.index / 2] != 0; }
    CGAL::Sign delaunay_sign(halfedge_descriptor h) const {
      return is_locally_delaunay(h) ? CGAL::ZERO : CGAL::NEGATIVE;
    }
    template <class Function>
    auto suspended(Function f) const {
      return f();
    }

  private:
    const Triangulation& t_;
  };

  class Session : public Const_session {
  public:
    explicit Session(Triangulation& t) : Const_session(t), t_(t) {}
    IT::Move_status flip_non_delaunay_edge(halfedge_descriptor h) {
      t_.flipped_[h.index / 2] = 1;
      return IT::Move_status::done;
    }

  private:
    Triangulation& t_;
  };

  explicit Triangulation(Mesh mesh)
      : mesh_(std::move(mesh)), flipped_(mesh_.number_of_edges(), 0) {}
  Triangulation(const Triangulation&) = delete;
  Triangulation& operator=(const Triangulation&) = delete;

  const Mesh& mesh() const { return mesh_; }
  std::uint32_t index(edge_descriptor e) const { return e.index; }

private:
  Mesh mesh_;
  std::vector<char> flipped_;
};

} // namespace archetypes

#endif // TEST_INTRINSIC_TRIANGULATIONS_ARCHETYPES_H
