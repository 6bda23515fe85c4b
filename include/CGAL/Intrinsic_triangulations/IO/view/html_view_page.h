// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_HTML_VIEW_PAGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_HTML_VIEW_PAGE_H

#include <string_view>

/*!
\file
The fixed parts of the page that `write_html_view()` writes, but for the program that draws: style,
elements, and the licence of three.js.
*/

namespace CGAL::Intrinsic_triangulations::internal {

// After the title.
inline constexpr std::string_view html_view_style = R"page(<style>
html, body { margin: 0; height: 100%; overflow: hidden; background: #f4f5f7;
  font: 14px/1.4 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; color: #1c2430; }
canvas { display: block; }
#panel { position: absolute; top: 12px; left: 12px; max-width: 300px; padding: 10px 14px;
  background: rgba(255, 255, 255, 0.92); border: 1px solid #d5d9e0; border-radius: 8px; }
#panel h1 { font-size: 16px; margin: 0 0 4px; overflow-wrap: anywhere; }
#panel p { margin: 0 0 8px; color: #536072; font-size: 12px; white-space: pre-line; }
#panel label { display: block; cursor: pointer; }
#panel button { margin: 8px 6px 0 0; padding: 3px 10px; border: 1px solid #b9c0cb;
  border-radius: 5px; background: #fff; cursor: pointer; font: inherit; }
#legend { margin-top: 8px; display: none; font-size: 12px; }
#panel i { display: inline-block; width: 16px; vertical-align: middle; margin: 0 2px; }
#legend canvas { width: 100%; height: 12px; border-radius: 3px; }
#legend div { display: flex; justify-content: space-between; }
#hover { position: absolute; right: 12px; bottom: 12px; padding: 6px 12px; font-size: 13px;
  background: rgba(28, 36, 48, 0.88); color: #fff; border-radius: 6px; white-space: pre-line;
  display: none; font-variant-numeric: tabular-nums; }
#failure { position: absolute; top: 40%; width: 100%; text-align: center; font-size: 18px;
  display: none; }
</style>
</head>
<body>
<div id="failure"></div>
<noscript>This page needs JavaScript.</noscript>
)page";

// After the panel's title and description.
inline constexpr std::string_view html_view_controls =
    R"page(<label><input type="checkbox" id="faces" checked> intrinsic faces</label>
<label><input type="checkbox" id="intrinsic" checked> intrinsic edges
<i style="border-top: 3px solid #10151d"></i></label>
<label><input type="checkbox" id="input" checked> input edges
<i style="background: #9aa3b0; border: solid #9aa3b0; border-width: 2px 0"><i
style="display: block; margin: 0; border-top: 1px solid #fff"></i></i></label>
<label id="scalar-label" style="display: none"><input type="checkbox" id="scalar" checked>
<span id="scalar-name"></span></label>
<div id="legend"><canvas width="256" height="1"></canvas><div><span id="least"></span>
<span id="greatest"></span></div></div>
<button id="reset">Reset view</button><button id="shot">Screenshot</button>
</div>
<div id="hover"></div>
)page";

// Debian's three.min.js has no notice of its own; the licence asks that every copy carries this one.
inline constexpr std::string_view three_js_licence = R"page(<script>
/*! The next two scripts are three.js and its TrackballControls.js, under the MIT licence:

Copyright (c) 2010-2019 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and
associated documentation files (the "Software"), to deal in the Software without restriction,
including without limitation the rights to use, copy, modify, merge, publish, distribute, sublicense,
and/or sell copies of the Software, and to permit persons to whom the Software is furnished to do so,
subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial
portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT
LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN
NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY,
WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE
SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE. */
</script>
)page";

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_HTML_VIEW_PAGE_H
