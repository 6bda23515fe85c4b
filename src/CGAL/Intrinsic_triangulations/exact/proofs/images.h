// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_IMAGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_IMAGES_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Proof_watch.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Residues.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/thresholds.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// by the images of the roots of the representatives
inline Residues image_of(const Square_root& x, const std::vector<Residues>& roots) {
  Residues result(x.factor);
  for (std::size_t g = 0; g < roots.size(); ++g)
    if ((x.radical >> g & 1U) != 0) result *= roots[g];
  return result;
}

/*
Decides whether an algebraic number v is zero from its images in finite fields.

Let K be the field of k independent square roots, and V = D v, D a positive integer, an algebraic
integer in K whose conjugates are all below 2^bits. Let p be a prime that divides neither 2 D nor a
representative. The ring homomorphisms of K (what is integral at p) to F_p(i) are the 2^k choices of
signs of the roots. They have the primes above p as kernels, and since p is unramified, its ideal is
the product of these: if v is zero in all images, p divides V. If this holds for primes whose
product exceeds 2^bits, V divided by that is an algebraic integer whose conjugates are all below 1.
Its norm is an integer below 1: V = 0. And one image that is not zero proves that v is not.

This takes 2^k bits / 61 evaluations in words, where coefficients in the basis of the 2^k products
of roots take 4^k products of long rationals.

`Value` evaluates v: `prepare(roots)` takes the roots of the representatives in new fields,
`negate(g)` changes the sign of root g, `at_roots()` returns the image, and `steps()` says how many
triangles it computes for that on average. `steps_left` bounds the cost of all long proofs together.
*/
template <class Value>
Answer decide_by_images(const Square_class_basis& basis, double bits, Value& value,
                        double& steps_left) {
  const std::size_t k = basis.dimension();
  // primes that are no good are passed over; there are few, since each divides some number
  const double fields =
      std::max(1.0, std::ceil((bits + 1) / (Residues::bits_of_prime * Residues::count)));
  const double cost = std::ldexp(fields, static_cast<int>(k)) * (value.steps() + 3);
  const bool is_proof = cost <= thresholds::few_image_steps ||
                        (cost <= thresholds::image_steps && cost <= steps_left);
  // Without a proof one image in four fields is enough: if v is not zero, it tells (`Residues`).
  const std::uint64_t signs = std::uint64_t(1) << (is_proof ? k : 0);
  double good = 0;
  for (std::size_t n = 0; good < (is_proof ? fields : 1.0); ++n) {
    if (static_cast<double>(n) > 2 * good + 16) return Answer::open;
    const Residue_fields scope(n);
    std::vector<Residues> roots;
    for (std::size_t g = 0; g < k; ++g) roots.push_back(Residues::sqrt_of(basis.representative(g)));
    value.prepare(roots);
    if (!Residue_fields::are_defined() ||
        std::any_of(roots.begin(), roots.end(), [](const Residues& r) { return r.has_zero(); }))
      continue;
    for (std::uint64_t s = 1;; ++s) { // in the order of a Gray code, the last roots most often
      if (!value.at_roots().is_zero()) return Answer::not_zero;
      if (s == signs) break;
      if ((s & 0x3ffU) == 0 && !Proof_watch::goes_on()) return Answer::open;
      value.negate(k - 1 - static_cast<std::size_t>(std::countr_zero(s)));
    }
    ++good;
  }
  if (!is_proof) return Answer::open;
  if (cost > thresholds::few_image_steps) steps_left -= cost;
  return Answer::zero;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_IMAGES_H
