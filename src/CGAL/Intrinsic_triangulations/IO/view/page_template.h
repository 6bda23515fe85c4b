// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_TEMPLATE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_TEMPLATE_H

#include <string_view>

namespace CGAL::Intrinsic_triangulations::internal {

// The page with the program that draws and answers to the pointer; text between two @ is a place to
// be filled. Each file is a part of it between the marks of a raw string.
#ifndef DOXYGEN_RUNNING // which does not look for files here
inline constexpr std::string_view html_view_page =
// The order is that of the page.
// clang-format off
#include <CGAL/Intrinsic_triangulations/IO/view/html_view_page.html>
#include <CGAL/Intrinsic_triangulations/IO/view/view_colors.js>
#include <CGAL/Intrinsic_triangulations/IO/view/view_surface.js>
#include <CGAL/Intrinsic_triangulations/IO/view/view_lines.js>
#include <CGAL/Intrinsic_triangulations/IO/view/view_camera.js>
#include <CGAL/Intrinsic_triangulations/IO/view/view_pointer.js>
#include <CGAL/Intrinsic_triangulations/IO/view/view_panel.js>
    // clang-format on
    ;
#endif

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_TEMPLATE_H
