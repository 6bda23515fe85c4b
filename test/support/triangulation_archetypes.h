// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_TRIANGULATION_ARCHETYPES_H
#define TEST_INTRINSIC_TRIANGULATIONS_TRIANGULATION_ARCHETYPES_H

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <CGAL/enum.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>

// Triangulations, complexes and coordinates that offer only the requirements of a concept. They
// hide the rest of one that has everything.

namespace archetypes {

namespace IT = CGAL::Intrinsic_triangulations;

using Wrapped = IT::Corresponding_triangulation;

/// A model of `NumberedComplex`: hides the rest of an `Input`.
class Complex {
public:
  explicit Complex(const IT::Input& input) : input_(input) {}
  Complex(const Complex&) = delete;
  Complex& operator=(const Complex&) = delete;

  std::uint32_t next(std::uint32_t h) const { return input_.next(h); }
  bool is_border(std::uint32_t h) const { return input_.is_border(h); }
  std::uint32_t face(std::uint32_t h) const { return input_.face(h); }
  std::uint32_t source(std::uint32_t h) const { return input_.source(h); }
  std::uint32_t target(std::uint32_t h) const { return input_.target(h); }
  std::uint32_t outgoing_halfedge(std::uint32_t v) const { return input_.outgoing_halfedge(v); }
  double squared_length(std::uint32_t e) const { return input_.squared_length(e); }
  double quadruple_area(std::uint32_t f) const { return input_.quadruple_area(f); }
  int scale_exponent() const { return input_.scale_exponent(); }

private:
  const IT::Input& input_;
};

/// A model of `CurveCoordinates`: hides the rest of `Integer_coordinates`.
class Curves {
public:
  explicit Curves(const IT::Integer_coordinates& c) : c_(c) {}
  Curves(const Curves&) = delete;
  Curves& operator=(const Curves&) = delete;

  const IT::Input& input() const { return c_.input(); }
  const IT::Vertex_fans& fans() const { return c_.fans(); }
  std::uint32_t number_of_edges() const { return c_.number_of_edges(); }
  IT::Normal_coordinate normal_coordinate(std::uint32_t e) const { return c_.normal_coordinate(e); }
  std::uint32_t roundabout(std::uint32_t h) const { return c_.roundabout(h); }
  bool is_inserted(std::uint32_t v) const { return c_.is_inserted(v); }
  const IT::Surface_point& location(std::uint32_t v) const { return c_.location(v); }

private:
  const IT::Integer_coordinates& c_;
};

/// A model of `SignpostDirections`: hides the rest of `Signposts`.
class Directions {
public:
  explicit Directions(const IT::Signposts& s) : s_(s) {}
  Directions(const Directions&) = delete;
  Directions& operator=(const Directions&) = delete;

  const IT::Input& input() const { return s_.input(); }
  std::shared_ptr<const IT::Input> shared_input() const { return s_.shared_input(); }
  bool is_inserted(std::uint32_t v) const { return s_.is_inserted(v); }
  const IT::Surface_point& location(std::uint32_t v) const { return s_.location(v); }
  IT::Geodesic_target target(std::uint32_t v) const { return s_.target(v); }
  IT::internal::Geodesic_walk<IT::Input> walk(std::uint32_t h, double turn = 0) const {
    return s_.walk(h, turn);
  }

private:
  const IT::Signposts& s_;
};

/// The common part: a mesh, and numbers for its edges.
class Has_mesh {
public:
  using Mesh = Wrapped::Mesh;
  using vertex_descriptor = Wrapped::vertex_descriptor;
  using halfedge_descriptor = Wrapped::halfedge_descriptor;
  using edge_descriptor = Wrapped::edge_descriptor;
  using face_descriptor = Wrapped::face_descriptor;

  Has_mesh(const Has_mesh&) = delete;
  Has_mesh& operator=(const Has_mesh&) = delete;

  const Mesh& mesh() const { return t_.mesh(); }
  std::uint32_t index(edge_descriptor e) const { return t_.index(e); }

protected:
  explicit Has_mesh(Wrapped& t) : t_(t) {}

  Wrapped& t_;
};

/// Values by number.
class Values {
public:
  explicit Values(const Wrapped& t) : m_(t.metric()) {}
  Values(const Values&) = delete;
  Values& operator=(const Values&) = delete;

  double approximate_squared_length(std::uint32_t e) const {
    return m_.approximate_squared_length(e);
  }
  double approximate_quadruple_area(std::uint32_t f) const {
    return m_.approximate_quadruple_area(f);
  }
  int scale_exponent() const { return m_.scale_exponent(); }

protected:
  const Wrapped::Metric& m_;
};

/// How many numbers there are.
class Capacities {
public:
  explicit Capacities(const Wrapped& t) : t_(t) {}
  std::uint32_t edge_capacity(const Wrapped::Mesh& m) const {
    return t_.numbers().edge_capacity(m);
  }
  std::uint32_t face_capacity(const Wrapped::Mesh& m) const {
    return t_.numbers().face_capacity(m);
  }

protected:
  const Wrapped& t_;
};

/// A model of `MeasuredTriangulation`.
class Measured_triangulation : public Has_mesh {
public:
  class Metric : public Values {
  public:
    using Values::Values;
    bool is_degenerate(std::uint32_t f) const { return m_.is_degenerate(f); }
  };
  class Const_session {
  public:
    explicit Const_session(const Measured_triangulation& t) : session_(t.t_) {}
    double cotangent_weight(edge_descriptor e, double tolerance = 0x1p-40) const {
      return session_.cotangent_weight(e, tolerance);
    }

  private:
    Wrapped::Const_session session_;
  };

  explicit Measured_triangulation(Wrapped& t) : Has_mesh(t), metric_(t) {}

  using Has_mesh::index;
  std::uint32_t index(vertex_descriptor v) const { return t_.index(v); }
  std::uint32_t index(face_descriptor f) const { return t_.index(f); }
  const Metric& metric() const { return metric_; }
  double squared_length(edge_descriptor e) const { return t_.squared_length(e); }
  double area(face_descriptor f) const { return t_.area(f); }
  std::uint32_t input_vertex(vertex_descriptor v) const { return t_.input_vertex(v); }
  std::uint32_t number_of_vertices() const { return t_.number_of_vertices(); }
  const IT::Input& input() const { return t_.input(); }
  Capacities numbers() const { return Capacities(t_); }

private:
  Metric metric_;
};

/// Numbers of elements, and elements with given numbers.
class Numbers : public Capacities {
public:
  using Capacities::Capacities;
  std::uint32_t vertex_capacity(const Wrapped::Mesh& m) const {
    return t_.numbers().vertex_capacity(m);
  }
  std::uint32_t vertex(Wrapped::vertex_descriptor v) const { return t_.numbers().vertex(v); }
  std::uint32_t halfedge(Wrapped::halfedge_descriptor h) const { return t_.numbers().halfedge(h); }
  std::uint32_t face(Wrapped::face_descriptor f) const { return t_.numbers().face(f); }
  Wrapped::vertex_descriptor vertex_at(std::uint32_t i) const { return t_.numbers().vertex_at(i); }
  Wrapped::halfedge_descriptor halfedge_at(std::uint32_t i) const {
    return t_.numbers().halfedge_at(i);
  }
  Wrapped::face_descriptor face_at(std::uint32_t i) const { return t_.numbers().face_at(i); }
};

/// A model of `IndexedTriangulation`.
class Indexed_triangulation : public Has_mesh {
public:
  explicit Indexed_triangulation(Wrapped& t) : Has_mesh(t) {}

  using Has_mesh::index;
  std::uint32_t index(vertex_descriptor v) const { return t_.index(v); }
  std::uint32_t index(face_descriptor f) const { return t_.index(f); }
  bool is_inserted(vertex_descriptor v) const { return t_.is_inserted(v); }
  std::uint32_t input_vertex(vertex_descriptor v) const { return t_.input_vertex(v); }
  std::uint32_t number_of_vertices() const { return t_.number_of_vertices(); }
  const IT::Input& input() const { return t_.input(); }
  Numbers numbers() const { return Numbers(t_); }
};

/// A model of `NumberedTriangulation` with a metric that may be more than that.
template <class Metric_>
class Numbered : public Indexed_triangulation {
public:
  using Metric = Metric_;

  explicit Numbered(Wrapped& t) : Indexed_triangulation(t), metric_(t) {}

  double area(face_descriptor f) const { return t_.area(f); }
  const Metric& metric() const { return metric_; }

private:
  Metric metric_;
};
using Numbered_triangulation = Numbered<Values>;

/// A model of `MeasuredTriangulation` and `NumberedTriangulation`, and no more.
class Measured_and_numbered_triangulation : public Numbered<Measured_triangulation::Metric> {
public:
  class Const_session {
  public:
    explicit Const_session(const Measured_and_numbered_triangulation& t) : session_(t.t_) {}
    double cotangent_weight(edge_descriptor e, double tolerance = 0x1p-40) const {
      return session_.cotangent_weight(e, tolerance);
    }

  private:
    Wrapped::Const_session session_;
  };

  using Numbered::Numbered;
  double squared_length(edge_descriptor e) const { return t_.squared_length(e); }
};

class Metric_of_corresponding : public Values {
public:
  using Scope = Wrapped::Metric::Scope;
  static constexpr bool is_exact = Wrapped::Metric::is_exact;
  using Values::Values;
};

/// A model of `CorrespondingTriangulation`.
class Corresponding_triangulation : public Numbered<Metric_of_corresponding> {
public:
  explicit Corresponding_triangulation(Wrapped& t) : Numbered(t), curves_(t.correspondence()) {}
  const Curves& correspondence() const { return curves_; }
  template <class Expression>
  CGAL::Sign sign(std::span<const IT::Indexed_face> faces, const Expression& e) const {
    return t_.sign(faces, e);
  }
  void sharpen(std::span<const IT::Indexed_face> faces) const { t_.sharpen(faces); }

private:
  Curves curves_;
};

class Metric_of_refinable : public Values {
public:
  static constexpr bool is_exact = Wrapped::Metric::is_exact;
  using Values::Values;
  bool is_degenerate(std::uint32_t f) const { return m_.is_degenerate(f); }
};

/// A model of `RefinableTriangulation`.
class Refinable_triangulation : public Numbered<Metric_of_refinable> {
public:
  class Const_session {
  public:
    explicit Const_session(const Refinable_triangulation& t) : session_(t.t_) {}
    bool is_locally_delaunay(halfedge_descriptor h) const {
      return session_.is_locally_delaunay(h);
    }
    CGAL::Sign delaunay_sign(halfedge_descriptor h) const { return session_.delaunay_sign(h); }
    double cotangent_weight(edge_descriptor e, double tolerance = 0x1p-40) const {
      return session_.cotangent_weight(e, tolerance);
    }
    template <class Function>
    auto suspended(Function f) const {
      return session_.suspended(f);
    }

  private:
    Wrapped::Const_session session_;
  };
  class Session : public Const_session {
  public:
    struct Insertion {
      IT::Move_status status;
      vertex_descriptor vertex;
    };

    explicit Session(Refinable_triangulation& t) : Const_session(t), session_(t.t_) {}
    IT::Move_status flip_non_delaunay_edge(halfedge_descriptor h) {
      return session_.flip_non_delaunay_edge(h);
    }
    Insertion insert_vertex(halfedge_descriptor h, const std::array<double, 3>& weights) {
      return only(session_.insert_vertex(h, weights));
    }
    Insertion split_edge(halfedge_descriptor h, double parameter) {
      return only(session_.split_edge(h, parameter));
    }
    IT::Move_status remove_vertex(vertex_descriptor v) { return session_.remove_vertex(v); }
    Insertion reposition_vertex(vertex_descriptor v, halfedge_descriptor h,
                                const std::array<double, 3>& weights) {
      return only(session_.reposition_vertex(v, h, weights));
    }

  private:
    static Insertion only(const Wrapped::Insertion& n) { return {n.status, n.vertex}; }

    Wrapped::Session session_;
  };

  using Numbered::Numbered;
  template <class Expression>
  CGAL::Sign sign(std::span<const IT::Indexed_face> faces, const Expression& e) const {
    return t_.sign(faces, e);
  }
  double squared_length(edge_descriptor e) const { return t_.squared_length(e); }
};

class Metric_of_geodesic : public Values {
public:
  static constexpr bool is_exact = Wrapped::Metric::is_exact;
  using Values::Values;
};

/// A model of `GeodesicTriangulation`.
class Geodesic_triangulation : public Numbered<Metric_of_geodesic> {
public:
  class Const_session {
  public:
    explicit Const_session(const Geodesic_triangulation& t) : session_(t.t_) {}
    bool is_locally_delaunay(halfedge_descriptor h) const {
      return session_.is_locally_delaunay(h);
    }
    CGAL::Sign delaunay_sign(halfedge_descriptor h) const { return session_.delaunay_sign(h); }
    CGAL::Comparison_result compare_angle_to_pi(halfedge_descriptor h,
                                                halfedge_descriptor g) const {
      return session_.compare_angle_to_pi(h, g);
    }
    template <class Function>
    auto suspended(Function f) const {
      return session_.suspended(f);
    }

  private:
    Wrapped::Const_session session_;
  };
  class Session : public Const_session {
  public:
    using Before_flip = Wrapped::Session::Before_flip;

    explicit Session(Geodesic_triangulation& t) : Const_session(t), session_(t.t_) {}
    IT::Move_status flip_non_delaunay_edge(halfedge_descriptor h) {
      return session_.flip_non_delaunay_edge(h);
    }
    IT::Move_status flip_status(halfedge_descriptor h) const { return session_.flip_status(h); }
    IT::Move_status flip_convex_edge(halfedge_descriptor h) { return session_.flip_convex_edge(h); }
    Before_flip before_flip(halfedge_descriptor h) const { return session_.before_flip(h); }
    void undo_flip(halfedge_descriptor h, const Before_flip& before) {
      session_.undo_flip(h, before);
    }

  private:
    Wrapped::Session session_;
  };

  using Numbered::Numbered;
  double length(edge_descriptor e) const { return t_.length(e); }
};

} // namespace archetypes

#endif // TEST_INTRINSIC_TRIANGULATIONS_TRIANGULATION_ARCHETYPES_H
