# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Doxygen's input filter for pages: what is written for git hosts becomes what doxygen shows instead.
#
#     awk -f page_text.awk PAGE > what doxygen reads
#
# A line that is a link to an example and one of its parts, `[name.cpp: part](path/name.cpp)`, becomes that code. The line that
# says how to build the manual is left out. Lines keep their numbers.

/^\[[a-z0-9_]+\.cpp: [^]]+\]\([^)]+\)$/ {
  sub(/^\[/, "\\snippet ")
  sub(/\.cpp: /, ".cpp ")
  sub(/\]\(.*$/, "")
}
/^> On a git host / { $0 = "" }
{ print }
