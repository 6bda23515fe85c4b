// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_STRESS_FAMILIES_H
#define TEST_INTRINSIC_TRIANGULATIONS_STRESS_FAMILIES_H

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/*!
\file
Families of meshes that are hard on the arithmetic of Delaunay flips, by name and three parameters.

A spec is `stress:FAMILY[:size=N][:seed=N][:amount=X]`, in any order. `size` is about how many faces
the mesh has. `seed` draws what is random; in families without anything random (marked *), a seed
other than 0 renumbers vertices and faces at random. What `amount` is depends on the family:

| family | mesh | amount | default |
|---|---|---|---|
| `parabola` * | strip between two parabolas `y = +-(1 + c x^2)`; every way to Delaunay takes quadratically many flips | c | 0.25 |
| `grid-plane` * | squares with diagonals | shear: x += amount y; ties after flips if it is an integer | 0 |
| `grid-cube` * | a cube's faces in squares with centers: squares on their corners are folded over its edges | stretch of z: all squares are ties if it is 1 | 1 |
| `grid-folded` * | a lattice of squares on their corners, folded through a 3-4-5 angle along every other row | shear in lattice steps, an integer | 0 |
| `grid-cylinder` * | rectangles on the sides of a prism over a regular polygon | rows by which each side is wound up at first, an integer | 0 |
| `splits` | a sphere with edges split at random | margin: edges are split at a parameter in [amount, 1 - amount] | 0.1 |
| `needles` | a rough grid with right-angled triangles, one leg so long relative to the other | that length | 1e-3 |
| `caps` | a rough grid with triangles of so much height over their longest side, relative to it, and flat ones around them | that height | 1e-3 |
| `ulps` | squares in the plane with coordinates moved up, down or not at all | units in the last place, an integer | 1 |
| `offset` | a rough grid far away from the origin, rounded to what doubles there can hold | distance in each coordinate | 1e9 |
| `stretched` | a dented sphere, x times amount | factor | 100 |
| `wound-sphere` * | circles of latitude, the points of each joined to those further on in the next | points further on, an integer | 5 |
| `wound-torus` * | the same, on a torus | the same | 5 |
| `wound-cylinder` * | the same, on a cylinder | the same | 5 |

Meshes are oriented, edge-manifold, with finite coordinates, and the same on every platform whose
compiler rounds each operation (GCC: -ffp-contract=off where there are fused ones): random numbers
come from Mersenne twisters without the distributions of the standard library. `grid-cylinder` and the
wound ones use `std::sin` and `std::cos`, whose last bits depend on the C library.
*/

namespace stress {

/// A triangle mesh in space.
struct Mesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

/*!
\brief makes the mesh of a spec.
\throws std::invalid_argument that names what is wrong with the spec and what is known instead
*/
Mesh make(const std::string& spec);

/// returns the specs that studies run: exact flipping takes seconds for all together.
std::vector<std::string> standard_specs();

} // namespace stress

#endif // TEST_INTRINSIC_TRIANGULATIONS_STRESS_FAMILIES_H
