# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Doxygen's input filter for headers: puts what a header documents into the group of its topic.
#
#     awk -v groups=Intrinsic_triangulations/groups.h -f group_header.awk HEADER > what doxygen reads
#
# C++20 concepts that have a page in Intrinsic_triangulations/Concepts, as their comments say, are left out: one page is
# enough. Lines keep their numbers.

# The group of a header is that of the longest name in groups.h that its path starts with.
BEGIN {
  while ((getline text < groups) > 0) {
    if (sub(/^\/\/ Headers: /, "", text)) names = names " " text
    else if (split(text, word, " ") > 1 && word[1] == "\\defgroup") {
      for (i = split(names, name, " "); i > 0; --i) group[name[i]] = word[2]
      names = ""
    }
  }
}

function group_of(path,    prefix, best) {
  sub(/.*include\/CGAL\/(Intrinsic_triangulations\/)?/, "", path)
  best = ""
  for (prefix in group)
    if (index(path, prefix) == 1 && length(prefix) > length(best)) best = prefix
  return best == "" ? "ref_owner" : group[best]
}

# The number of the line in which the declaration ends that begins at a line.
function end_of_declaration(n,    depth) {
  for (depth = 0; n < NR; ++n) {
    depth += gsub(/{/, "{", line[n]) - gsub(/}/, "}", line[n])
    if (depth == 0 && line[n] ~ /;$/) break
  }
  return n
}

{ line[FNR] = $0 }
/^\/\*!$/ { comment = FNR }
/^Syntax of \\ref ::/ { first[++concepts] = comment }
/^concept / { if (concepts > closed) last[++closed] = FNR }

END {
  for (i = 1; i <= concepts; ++i) {
    line[first[i]] = "/*! \\cond */ " line[first[i]]
    n = end_of_declaration(last[i])
    line[n] = line[n] " /*! \\endcond */"
  }
  for (i = 1; i <= NR; ++i) {
    if (line[i] == "namespace CGAL::Intrinsic_triangulations {")
      line[i] = line[i] " /*! \\addtogroup " group_of(FILENAME) " */ /*! @{ */"
    if (line[i] == "} // namespace CGAL::Intrinsic_triangulations")
      line[i] = "/*! @} */ " line[i]
    print line[i]
  }
}
