// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_OPTIONS_H
#define INTRINSIC_OPTIONS_H

#include <CGAL/Intrinsic_operators/improvement/Improve_options.h>
#include <CGAL/Intrinsic_triangulations/support/defaults.h>
#include <CGAL/Intrinsic_triangulations/support/ranges.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace program {

namespace defaults = CGAL::Intrinsic_triangulations::defaults;
namespace ranges = CGAL::Intrinsic_triangulations::ranges;

/// Which curves are made geodesic, and how far.
struct Geodesic_options {
  std::vector<std::string> paths; ///< points of each, separated by commas
  std::vector<std::string> loops; ///< points of each, separated by commas
  std::string bezier;             ///< control points, separated by commas; empty: none
  std::string source;             ///< point from which geodesics lead to all vertices; empty: none
  std::string network;            ///< file that lists paths and loops; empty: none
  bool has_waypoints = false;     ///< whether curves stay at all points that are given
  /// `exact`, or `flips`: paths start from shortest ones along edges
  std::string method = defaults::curve_method;
  double relative_length = 0; ///< part of the length at which to stop
  double joint_angle = 180;   ///< angle of all joints at which to stop, in degrees
  bool writes_subdivision = false;
};

/// Where a surface is cut open besides along curves, and the file of its labels.
struct Cut_options {
  std::string levels;       ///< how many isolines, or which, separated by commas; empty: none
  bool makes_disks = false; ///< whether components become disks
  std::string labels;       ///< file of the labels of faces; empty: none
};

/// Problems to be solved on the triangulation, and where results are written.
struct Application_options {
  std::vector<std::string> sources; ///< points, separated by commas
  std::vector<std::string> curves;  ///< points of each, separated by commas
  bool is_signed = false;           ///< whether distances have the sign of the side of a curve
  std::string distance;             ///< method: `exact` or `heat`; empty: what sources allow
  std::vector<std::string> targets; ///< points, separated by commas, at which the search may end
  /// where the search ends, in units of the input
  std::optional<double> maximum_distance = std::nullopt;
  std::string pairs;       ///< file of two vertices on each line; empty: none
  std::string source_sets; ///< file of vertices that are sources together; empty: none
  std::string isolines;    ///< file of lines of equal distance; empty: none
  /// how many, or which, separated by commas
  std::string levels = std::to_string(defaults::levels);
  std::string voronoi; ///< file of the lines between cells of sources; empty: none
  /// of these lines, in the units of the file; none: a thousandth of the mean edge
  std::optional<double> cell_tolerance{};
  std::string on = "subdivision";             ///< `input`, `intrinsic` or `subdivision`
  double time_factor = defaults::time_factor; ///< of the time step that a method chooses
  std::size_t count = defaults::count;        ///< of eigenpairs
  unsigned degree = defaults::degree;         ///< of direction fields
  /// strength with which direction fields follow curvature; none: they do not
  std::optional<double> alignment = std::nullopt;
  std::string map = defaults::map_method; ///< `harmonic`, `spectral` or `lscm`
  std::string cut{};         ///< `auto`, or file of edges at which to cut open; empty: nowhere
  std::string logarithm{};   ///< `exact`, `affine` or `polar`; empty: what the surface has
  std::string vectors;       ///< file of vectors at vertices
  std::string singularities; ///< file of points with indices; empty: none
  std::string handles;       ///< file of vertices and their displacements; empty: none
  std::string energy = defaults::energy; ///< of a deformation
  std::string solver = "auto";           ///< of linear problems: `auto`, `direct` or `iterative`
};

/// Which angles a surface gets, and from which triangles.
struct Uniformize_options {
  std::string angles; ///< file of angles, one per vertex; empty: none
  std::string cones;  ///< number of cones, or file of them; empty: none
  std::string start;  ///< `delaunay` or `input`; empty: input if vertices were inserted
  std::string target; ///< `plane`, `sphere`, `torus` or `disk`; empty: what the surface allows
};

/// How coarse a surface becomes.
struct Simplify_command {
  std::string vertices;                      ///< number or percentage; empty: no bound
  std::optional<double> stretch{};           ///< largest factor of lengths, and its inverse
  std::optional<double> flat{};              ///< radians: only vertices as flat as this go
  std::string cost = defaults::removal_cost; ///< `stretch`, `curvature`, `area` or `balanced`
  std::string kept_vertices;                 ///< file of vertices that stay; empty: none
  std::string prolongation;                  ///< from the coarse vertices; empty: none
  std::string vector_prolongation;           ///< the same for tangent vectors
  std::string places;                        ///< file of places of the fine vertices; empty: none
};

/// Up to this least angle, in degrees, refinement always ends.
inline constexpr double greatest_safe_angle = 30;

/// The options on the command line.
struct Options {
  std::string command;             ///< name of the command
  std::vector<std::string> inputs; ///< all that were given
  std::string input;               ///< the one of this run
  bool is_standard_input = false;  ///< whether `input` has what came from there
  std::string input_format;        ///< extension of what comes from standard input; empty: guessed
  std::string arithmetic = defaults::arithmetic; ///< `exact` or `double`
  /// `none`, `integer`, `signposts` or `crossings`; empty: what the command takes by default
  std::string correspondence;
  /// `automatic`, `none`, `lengths` or `squared`
  std::string mollification = defaults::mollification;
  /// `auto`, `manifold`, `orientation-cover`, `tufted`, `closed` or `points`
  std::string domain = defaults::domain;
  std::optional<std::size_t> neighbors = std::nullopt; ///< of each point of a point cloud
  std::string polygons = defaults::polygons; ///< what is made of nonplanar ones: `fan` or `planar`
  std::string output;                        ///< empty: none
  bool is_plain = false;                     ///< whether meshes have only what all readers expect
  std::string view;                          ///< page that shows the triangulation; empty: none
  double view_limit = 30;                    ///< most megabytes of the page
  std::string mass;                          ///< empty: none
  std::string mass_kind = defaults::mass_kind; ///< `lumped`, `galerkin` or `voronoi`
  std::string stats;                           ///< empty: none; `-`: standard output
  std::string records;       ///< file of all records of long lists in `stats`; empty: none
  std::string laplacian;     ///< empty: none
  std::string interpolation; ///< from the intrinsic triangulation to the subdivision; empty: none
  std::string input_interpolation;   ///< from the input to the subdivision; empty: none
  std::optional<double> sharp_angle; ///< in degrees: edges folded by more are kept
  std::string constraints;           ///< file that lists edges to be kept; empty: none
  std::optional<double> time_limit;  ///< in seconds
  bool logs_progress = false;
  bool is_quiet = false;   ///< whether only errors are printed
  bool is_verbose = false; ///< whether more than the answer is printed
  bool no_flip = false;
  bool refines = false;
  CGAL::Intrinsic_triangulations::Refine_criteria refinement;
  bool is_adaptive = false; ///< whether faces are refined for a function in place of that
  CGAL::Intrinsic_triangulations::Adapt_criteria adaptive;
  Geodesic_options geodesic;
  Application_options application;
  std::string sizes;              ///< file of wanted lengths of edges, one per vertex; empty: none
  std::string metric;             ///< file of factors or tensors; empty: lengths are those in space
  std::string field;              ///< file of values at vertices that are transferred
  std::vector<std::string> shown; ///< files of values and curves that a page shows
  std::string other;              ///< file of a surface that is compared with the input
  bool hashes = false;            ///< whether `info` computes the hash of the surface
  std::string from = "input";     ///< triangulation that has the field: `input` or `intrinsic`
  std::string method = defaults::transfer_method; ///< `l2` or `pointwise`
  std::vector<std::string> study;                 ///< what follows the command `study`
  std::vector<std::string> arguments;             ///< all that follows the name of the program
  bool is_arithmetic_given = false;
  bool is_mollification_given = false;
  Cut_options cut;
  Uniformize_options uniformize;
  Simplify_command simplify;
  std::optional<double> flat_within{}; ///< radians: vertices that `embed` takes for flat
};

/// A file that is written.
struct Output {
  std::string path;
  std::string contents; ///< what is in it, for people
};

/// returns all files that options name for results, in the order of their help.
std::vector<Output> outputs(const Options& options);
/// tells whether a path is standard output: `-`, or that with an extension, such as `-.txt`.
bool is_standard_output(const std::string& path);
/// tells whether meshes are written without labels, edges and colours: if that is asked for, and
/// where results are on the mesh of the file, whose labels tell nothing.
bool writes_plain_meshes(const Options& options);
/// tells whether the output is the common subdivision, not the intrinsic triangulation.
bool is_mesh_output(const Options& options);
/// tells whether distances are asked for in batches: of pairs, or from many sets of sources.
inline bool has_batch(const Application_options& o) {
  return !o.pairs.empty() || !o.source_sets.empty();
}
/// tells whether edges of the input are kept.
bool has_constraints(const Options& options);
/// tells whether an output needs the common subdivision.
bool needs_subdivision(const Options& options);
/// tells whether an option needs to know where the intrinsic triangulation lies on the input.
bool needs_correspondence(const Options& options);

} // namespace program

#endif // INTRINSIC_OPTIONS_H
