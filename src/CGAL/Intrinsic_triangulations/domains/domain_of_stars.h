// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DOMAIN_OF_STARS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DOMAIN_OF_STARS_H

#include <CGAL/Intrinsic_triangulations/domains/Domain.h>

namespace CGAL::Intrinsic_triangulations::internal {

// The cover of triangles whose first corner is the center of a star, see `cover_of_stars()`.
Domain domain_of_stars(Triangle_soup stars, Mollification mollification);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DOMAIN_OF_STARS_H
