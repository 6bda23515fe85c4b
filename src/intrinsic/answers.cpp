// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "answers.h"

#include <map>
#include <string>
#include <vector>

namespace program {

namespace {

using Lines = std::vector<Answer_line>;

// ---- Conditions --------------------------------------------------------------------------------

bool is_one_sided(const Figures& f) { return f.has("/input") && f.at("/input/genus").is_null(); }
bool has_border(const Figures& f) { return f.has("/input/boundary_loops"); }
bool is_closed(const Figures& f) { return !has_border(f); }
bool is_cover(const Figures& f) { return f.word("/domain/kind") != "manifold"; }
bool is_certified(const Figures& f) { return f.word("/certificate") == "exact"; }
bool is_probable(const Figures& f) { return f.word("/certificate") == "interval"; }
bool is_uncertified(const Figures& f) {
  return f.word("/certificate") == "none" && !f.has("/delaunay/non_delaunay_edges");
}
bool is_not_delaunay(const Figures& f) { return f.has("/delaunay/non_delaunay_edges"); }
bool is_mollified(const Figures& f) { return f.word("/mollification/kind") != "none"; }

template <const char* place>
bool has(const Figures& f) {
  return f.has(place);
}

// ---- The surface -------------------------------------------------------------------------------

constexpr char blocked[] = "/simplify/blocked_by_border", unflattened[] = "/simplify/not_flattened",
               bounded[] = "/simplify/kept_by_bound";
constexpr char isolated[] = "/input/isolated_vertices", degenerate[] = "/input/degenerate_faces",
               triangulated[] = "/input/triangulated_polygons",
               repeated[] = "/input/faces_with_repeated_vertices",
               reversed[] = "/input/reversed_faces", nonmanifold[] = "/input/nonmanifold_vertices",
               duplicated[] = "/domain/duplicated_points",
               alone[] = "/domain/points_without_triangles", border[] = "/domain/border_points",
               unsatisfied[] = "/refine/unsatisfied_faces";

const Lines surface_lines{
    {"file", "{/input/file}"},
    {"elements", "{/input/vertices vertex vertices}, {/input/edges edge}, {/input/faces face}"},
    {"topology", "{/input/components component}, genus {/input/genus}, closed", is_closed},
    {"topology",
     "{/input/components component}, genus {/input/genus}, {/input/boundary_loops boundary "
     "boundaries} of {/input/boundary_edges edge}",
     has_border},
    {"topology", "{/input/components component}, not orientable", is_one_sided},
    {"surface", "{/domain/kind}, of {/domain/vertices vertex vertices}: {/domain/reason}",
     is_cover},
    {"", "{/domain/duplicated_points point} at the place of another", has<duplicated>},
    {"", "{/domain/points_without_triangles point} without triangles", has<alone>},
    {"", "{/domain/border_points point} on the border", has<border>},
    {"polygons",
     "{/polygons/planar} planar, {/polygons/flattened} made planar, {/polygons/kept} kept"},
    {"", "{/input/triangulated_polygons polygon} cut into triangles", has<triangulated>},
    {"", "{/input/faces_with_repeated_vertices face} listed a vertex twice: lines were left out",
     has<repeated>},
    {"", "{/input/reversed_faces face} turned around", has<reversed>},
    {"", "{/input/degenerate_faces face} without area", has<degenerate>},
    {"", "{/input/isolated_vertices vertex vertices} without a face", has<isolated>},
    {"", "{/input/nonmanifold_vertices vertex vertices} where the surface is not a manifold",
     has<nonmanifold>},
    {"mollification", "{/mollification/kind}, delta {/mollification/delta}", is_mollified}};

const Lines delaunay_lines{
    {"Delaunay", "yes, certified in exact arithmetic", is_certified},
    {"Delaunay", "yes, but for probable ties", is_probable},
    {"Delaunay", "yes, in double arithmetic, without a certificate", is_uncertified},
    {"Delaunay", "no: {/delaunay/non_delaunay_edges edge} would flip", is_not_delaunay},
    {"ties", "{/delaunay/cocircular_edges edge}"},
    {"kept edges", "{/constraints/input_edges}"}};

const Lines flip_lines{{"flips", "{/delaunay/flips}"}};

const Lines refinement_lines{
    {"inserted", "{/refine/insertions vertex vertices}; status {/refine/status}"},
    {"criteria", "not met by {/refine/unsatisfied_faces face}", has<unsatisfied>},
    {"criteria", "met by all faces",
     [](const Figures& f) { return f.has("/refine") && !f.has(unsatisfied); }},
    {"adapted", "to {/adaptive/rounds/last/vertices vertex vertices}, estimated error "
                "{/adaptive/rounds/last/estimated_error}; status {/adaptive/status}"},
    {"moved",
     "{/odt/moves vertex vertices}, after {/odt/splits split}; energy from {/odt/energy_before} to "
     "{/odt/energy_after}; status {/odt/status}"}};

const Lines quality_lines{
    {"angles", "{/quality/min_angle_deg} to {/quality/max_angle_deg} degrees"},
    {"cotan weights",
     "from {/quality/min_cotan_weight}; trace of the Laplacian {/laplacian/trace}"},
    {"area", "{/area/intrinsic}"},
    {"subdivision", "{/subdivision/vertices vertex vertices}, {/subdivision/faces face}"}};

Lines joined(std::initializer_list<Lines> parts) {
  Lines all;
  for (const Lines& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

// ---- Curves ------------------------------------------------------------------------------------

constexpr char cut_curves[] = "/geodesic/curves";

const Lines geodesic_lines{
    {"status", "{/geodesic/status}, certified",
     [](const Figures& f) { return f.has("/geodesic/certified"); }},
    {"status", "{/geodesic/status}, not certified",
     [](const Figures& f) { return !f.has("/geodesic/certified"); }},
    {"obstacle", "{/geodesic/obstacle}"},
    {"length", "{/geodesic/length}; before it was shortened {/geodesic/initial_length}"},
    {"lengths", "{/geodesic/curves/*/length}",
     [](const Figures& f) { return f.at(cut_curves).size() > 1; }},
    {"flips", "{/geodesic/flips}; {/geodesic/joints joint}"}};

const Lines cut_lines{
    {"pieces", "{/cut/components/#}, with the areas {/cut/components/*/area}"},
    {"surface",
     "{/cut/border_loops boundary boundaries}, Euler characteristic {/cut/euler_characteristic}"},
    {"cut along", "{/cut/edges edge}; {/cut/divided_faces face} of the mesh divided"},
    {"isolines", "{/isolines/lines}, at {/isolines/levels}"},
    {"curves", "{/geodesic/status}, length {/geodesic/length}", has<cut_curves>}};

// ---- Problems ----------------------------------------------------------------------------------

const Lines distance_lines{
    {"to targets", "{/distance/targets}"},
    {"of pairs", "{/distance/distances}"},
    {"distances", "{/distance/min} to {/distance/max}, by the method {/distance/method}"},
    {"searched", "up to the distance {/distance/reached}"},
    {"sets", "{/distance/sets} of sources"},
    {"cells", "{/distance/cells/areas/#}, with the areas {/distance/cells/areas}"},
    {"isolines", "{/distance/isolines} at {/distance/levels}"}};

const Lines map_lines{
    {"map", "{/parametrize/method}"},
    {"injective", "yes, certified",
     [](const Figures& f) { return f.has("/parametrize/injective"); }},
    {"injective",
     "no: {/parametrize/flipped_faces face} turned over, {/parametrize/degenerate_faces face} "
     "without area",
     [](const Figures& f) {
       return f.has("/parametrize/flipped_faces") || f.has("/parametrize/degenerate_faces");
     }},
    {"injective", "no: the border crosses itself",
     [](const Figures& f) {
       return f.at("/parametrize/border_is_simple").is_boolean() &&
              !f.has("/parametrize/border_is_simple");
     }},
    {"residual", "{/parametrize/residual} radians; proven: {/parametrize/proven_residual}"},
    {"distortion", "of angles {/parametrize/mean_quasi_conformal} on average, at most "
                   "{/parametrize/max_quasi_conformal}; 1 is none"},
    {"inserted", "{/parametrize/inserted_vertices vertex vertices}",
     [](const Figures& f) { return f.has("/parametrize/inserted_vertices"); }},
    {"cut open", "along {/cut/edges edge} of length {/cut/length}"}};

const Lines uniform_lines{
    {"target", "{/conformal/target}; status {/conformal/status}"},
    {"scaled", "the lengths of the {/conformal/start} triangles"},
    {"angles", "right up to {/conformal/residual} radians; proven: {/conformal/proven_residual}"},
    {"angles", "right up to {/conformal/residual} radians, not proven",
     [](const Figures& f) { return f.at("/conformal/proven_residual").is_null(); }},
    {"scale", "u from {/conformal/least_u} to {/conformal/largest_u}, a ratio of "
              "{/conformal/max_scale_ratio}"},
    {"cones", "{/conformal/cones}", [](const Figures& f) { return f.has("/conformal/cones"); }},
    {"period", "{/conformal/period}"},
    {"layout", "injective", [](const Figures& f) { return f.has("/conformal/injective"); }},
    {"layout", "not injective; {/conformal/flipped_faces piece} turned over",
     [](const Figures& f) { return !f.has("/conformal/injective"); }}};

const Lines field_lines{
    {"degree", "{/field/degree}"},
    {"index sum", "{/field/index_sum}, of {/field/singular_faces singularity singularities}"},
    {"border", "{/field/border_turns turn} of the field along it", has_border},
    {"vectors kept", "{/field/fixed}", [](const Figures& f) { return f.has("/field/fixed"); }},
    {"seam", "{/field/seam_edges edge}"}};

// ---- The table ---------------------------------------------------------------------------------

const std::map<std::string, Lines> answers{
    {"delaunay", joined({delaunay_lines, flip_lines, quality_lines})},
    {"refine", joined({refinement_lines, delaunay_lines, quality_lines})},
    {"laplacian", joined({delaunay_lines, flip_lines, quality_lines})},
    {"transfer",
     {{"functions", "{/transfer/functions}, from the {/transfer/from}, by {/transfer/method}"},
      {"integrals", "{/transfer/integral_on_input} on the input"},
      {"", "{/transfer/integral_on_intrinsic} on the triangulation"},
      {"L2 distance", "{/transfer/L2_distance}"}}},
    {"geodesic", joined({geodesic_lines, refinement_lines})},
    {"cut", cut_lines},
    {"distance", distance_lines},
    {"parametrize", map_lines},
    {"uniformize", uniform_lines},
    {"transport",
     {{"vectors", "from {/transport/sources source}; the longest has {/transport/longest}"}}},
    {"logmap",
     {{"method", "{/logmap/method}"},
      {"radius", "{/logmap/radius}"},
      {"injective", "up to the radius {/logmap/injectivity_radius}"},
      {"injective", "everywhere",
       [](const Figures& f) { return f.at("/logmap/injectivity_radius").is_null(); }},
      {"torn", "{/logmap/torn_edges edge}"}}},
    {"field", field_lines},
    {"eigen", {{"eigenvalues", "{/eigen/values}"}}},
    {"embed",
     {{"polyhedron", "{/embed/faces triangle}; status {/embed/status}"},
      {"shape", "{/embed/shape}, {/embed/flat_vertices vertex vertices} on faces or edges"},
      {"distances", "right up to {/embed/largest_error} of the size"},
      {"certified", "a polyhedron with these lengths is within {/embed/within}",
       [](const Figures& f) { return f.has("/embed/proven"); }}}},
    {"edit",
     {{"handles", "{/edit/handles}, energy {/edit/energy}"},
      {"moved", "by at most {/edit/max_displacement}"}}},
    {"simplify",
     {{"vertices", "{/simplify/vertices} on {/simplify/faces face}; {/simplify/removed} removed; "
                   "status {/simplify/status}"},
      {"lengths", "multiplied by {/simplify/stretch/lower} to {/simplify/stretch/upper}, proven, "
                  "rounded here; "
                  "on average by {/simplify/stretch/mean_lower} to {/simplify/stretch/mean_upper}"},
      {"lengths", "no bound is proven: faces are too thin for doubles",
       [](const Figures& f) {
         return f.at("/simplify/stretch/upper").is_null() || !f.has("/simplify/stretch/lower");
       }},
      {"stayed", "{/simplify/blocked_by_border vertex vertices} at borders and kept edges",
       has<blocked>},
      {"stayed", "{/simplify/not_flattened vertex vertices}, as rounding or loops hinder them",
       has<unflattened>},
      {"stayed", "{/simplify/kept_by_bound vertex vertices} within the bound", has<bounded>}}},
    {"isometry",
     {{"answer", "{/isometry/answer}"},
      {"isometries", "{/isometry/count}"},
      {"difference", "of lengths: {/isometry/largest_difference}, relatively",
       [](const Figures& f) { return f.at("/isometry/largest_difference").is_number(); }},
      {"note", "{/isometry/note}"}}},
    {"view", {}}, // its answer is the page that it has written
    {"info",
     joined(
         {surface_lines, {{"hash", "{/hash}"}}, delaunay_lines, refinement_lines, quality_lines})}};

} // namespace

const std::vector<Answer_line>& answer_of(const std::string& command) {
  return answers.at(command);
}

const std::vector<Answer_line>& lines_of_surface() { return answers.at("info"); }

} // namespace program
