// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>

#include <CGAL/Gmpq.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

template <class Signed>
Multiquadratic_number Multiquadratic_number::sum(const Multiquadratic_number& x,
                                                 const Multiquadratic_number& y,
                                                 const Signed& with_sign) {
  Multiquadratic_number result(common_basis(x, y), {});
  result.terms_.reserve(x.terms_.size() + y.terms_.size());
  auto s = x.terms_.begin();
  for (const Term& t : y.terms_) {
    for (; s != x.terms_.end() && s->radical <= t.radical; ++s) result.add(*s);
    result.add({t.radical, with_sign(t.coefficient)});
  }
  for (; s != x.terms_.end(); ++s) result.add(*s);
  return result.normal();
}

Gmpq Multiquadratic_number::coefficient(Mask radical) const {
  for (const Term& t : terms_)
    if (t.radical == radical) return t.coefficient;
  return Gmpq(0);
}

std::size_t Multiquadratic_number::number_of_words() const {
  std::size_t words = 0;
  for (const Term& t : terms_)
    words += mpz_size(mpq_numref(t.coefficient.mpq())) + mpz_size(mpq_denref(t.coefficient.mpq()));
  return words;
}

Multiquadratic_number Multiquadratic_number::inverse() const {
  CGAL_precondition(!is_zero());
  if (terms_.size() == 1) {
    const auto& [radical, q] = terms_.front();
    return {basis_, {{radical, Gmpq(1) / (radical == 0 ? q : q * basis_->product(radical))}}};
  }
  Mask g = terms_.back().radical; // its highest bit
  while ((g & (g - 1)) != 0) g &= g - 1;
  Multiquadratic_number conjugate = *this, norm;
  for (Term& t : conjugate.terms_)
    if ((t.radical & g) != 0) t.coefficient = -t.coefficient;
  norm = *this * conjugate;
  return conjugate * norm.inverse();
}

Multiquadratic_number operator+(const Multiquadratic_number& x, const Multiquadratic_number& y) {
  return Multiquadratic_number::sum(x, y, [](const Gmpq& q) { return q; });
}

Multiquadratic_number operator-(const Multiquadratic_number& x, const Multiquadratic_number& y) {
  return Multiquadratic_number::sum(x, y, [](const Gmpq& q) { return -q; });
}

Multiquadratic_number operator*(const Multiquadratic_number& x, const Multiquadratic_number& y) {
  using Term = Multiquadratic_number::Term;
  const Square_class_basis* basis = Multiquadratic_number::common_basis(x, y);
  if (basis != nullptr) basis->count_words(x.number_of_words() * y.number_of_words());
  std::vector<Term> all;
  all.reserve(x.terms_.size() * y.terms_.size());
  for (const Term& s : x.terms_)
    for (const Term& t : y.terms_) {
      const Multiquadratic_number::Mask common = s.radical & t.radical;
      const Gmpq q = s.coefficient * t.coefficient;
      all.push_back({s.radical ^ t.radical, common == 0 ? q : q * basis->product(common)});
    }
  std::sort(all.begin(), all.end(),
            [](const Term& s, const Term& t) { return s.radical < t.radical; });
  Multiquadratic_number result(basis, {});
  for (const Term& t : all) result.add(t);
  return result.normal();
}

bool operator==(const Multiquadratic_number& x, const Multiquadratic_number& y) {
  using Term = Multiquadratic_number::Term;
  return std::equal(x.terms_.begin(), x.terms_.end(), y.terms_.begin(), y.terms_.end(),
                    [](const Term& s, const Term& t) {
                      return s.radical == t.radical && s.coefficient == t.coefficient;
                    });
}

const Square_class_basis* Multiquadratic_number::common_basis(const Multiquadratic_number& x,
                                                              const Multiquadratic_number& y) {
  CGAL_precondition(x.basis_ == nullptr || y.basis_ == nullptr || x.basis_ == y.basis_);
  return x.basis_ != nullptr ? x.basis_ : y.basis_;
}

void Multiquadratic_number::add(const Term& t) {
  if (terms_.empty() || terms_.back().radical != t.radical) {
    if (t.coefficient.sign() != ZERO) terms_.push_back(t);
    return;
  }
  terms_.back().coefficient += t.coefficient;
  if (terms_.back().coefficient.sign() == ZERO) terms_.pop_back();
}

} // namespace CGAL::Intrinsic_triangulations
