# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Doxygen's input filter for pages: what is written for git hosts becomes what doxygen shows instead.
#
#     awk -v folder=FOLDER_OF_PAGES -f page_text.awk PAGE > what doxygen reads
#
# - A heading and a line `<a id="label"></a>` below it become a heading with that label.
# - Links to labels, `[text](page.md#label)`, and to the pages that doxygen makes of other files become references.
# - Links to examples, [name.cpp](path/name.cpp) or [name.cpp: part](path/name.cpp), become references to their pages.
# - Links to headers, [`name()`](path/header.h), and to concepts, [Name](Concepts/Name.h), become references to what they name.
# - Links to sources, [source.cpp](path/source.cpp), become their text.
# - Links to headers by the name of the file, [header.h](path/header.h), become that name.
# - Chapters of user_manual.md become links to their own pages, see chapter_pages.cmake. Links of these to pages, not to
#   sections, and those of command_line.md to commands, make them parts of it, which the tree at the side shows below it.
# - Formulas, $`x`$ and blocks of `math`, become those of doxygen; a comment becomes the table of contents.
#
# Lines keep their numbers.

# whether a link, file.md#label, is to a part of this page: its label is on the second line there
function is_part(target,    file, label, line) {
  if (!(FILENAME ~ /\/chapter_[a-z_]+\.md$/ && target ~ /^[a-z_]+\.md#/) &&
      !(FILENAME ~ /\/command_line\.md$/ && target ~ /^command_[a-z]+\.md#/)) return 0
  file = folder "/" target
  label = file
  sub(/#.*$/, "", file)
  sub(/^.*#/, "", label)
  getline line < file
  getline line < file
  close(file)
  return line == "<a id=\"" label "\"></a>"
}

# the reference that a link becomes, or nothing
function reference(text, target,    label, name) {
  if (target ~ /^\.\.\/\.\.\/include\// && text ~ /\.(h|html)$/) return text # a file, to which doxygen links if it has a page
  if (target ~ /^\.\.\/\.\.\/(src|python|examples\/python)\//) return text # a source, which has no page
  if (target ~ /^\.\.\/\.\.\/include\/.*\.h$/) {
    name = text
    gsub(/`/, "", name)
    if (sub(/\(\)$/, "", name)) return "\\itf{" name "}"
    return "\\itc{" name "}"
  }
  if (target ~ /^\.\.\/\.\.\/examples\/.*\.cpp$/) {
    name = target
    sub(/^.*\//, "", name)
    return "\\ref " name " \"" text "\""
  }
  label = ""
  if (target ~ /^Concepts\/[A-Za-z]+\.h$/) {
    label = target
    sub(/^Concepts\//, "::", label)
    sub(/\.h$/, "", label)
  } else if (target ~ /^([a-z_]+\.md|\.\.\/members\.md)?#[a-z0-9_]+$/) {
    label = target
    sub(/^.*#/, "", label)
  } else if (target ~ /^\.\.\/\.\.\/include\/CGAL\/Intrinsic_[a-z]+\/README\.md$/) {
    label = target
    sub(/^.*\/Intrinsic_/, "page_rooms_of_", label)
    sub(/\/README\.md$/, "", label)
  }
  else if (target == "../../examples/README.md")
    label = "page_examples"
  else if (target == "../members.md")
    label = "page_reference"
  else if (target == "Concepts")
    label = "ref_concepts"
  if (label == "") return ""
  gsub(/`/, "", text)
  return (is_part(target) ? "\\subpage " : "\\ref ") label " \"" text "\""
}

# a line whose formulas are those of doxygen
function with_formulas(line,    before) {
  before = ""
  while (match(line, /\$`[^`]+`\$/)) {
    before = before substr(line, 1, RSTART - 1) "\\f$" substr(line, RSTART + 2, RLENGTH - 4) "\\f$"
    line = substr(line, RSTART + RLENGTH)
  }
  return before line
}

# a line whose links are references
function with_references(line,    before, link, text, target, found) {
  before = ""
  line = with_formulas(line)
  while (match(line, /\[[^][]+\]\([^() ]+\)/)) {
    link = substr(line, RSTART, RLENGTH)
    text = link
    sub(/^\[/, "", text)
    sub(/\]\([^() ]+\)$/, "", text)
    target = link
    sub(/^\[[^][]+\]\(/, "", target)
    sub(/\)$/, "", target)
    found = reference(text, target)
    before = before substr(line, 1, RSTART - 1) (found == "" ? link : found)
    line = substr(line, RSTART + RLENGTH)
  }
  return before line
}

function flush() {
  if (is_held) print held
  is_held = 0
}

/^```math$/ {
  flush()
  print "\\f["
  is_math = 1
  next
}
is_math && /^```$/ {
  print "\\f]"
  is_math = 0
  next
}
/^```/ { is_code = !is_code }
is_code || is_math || /^    / {
  flush()
  print
  next
}
/^## / { is_chapter = 0 }
is_held && /^<a id="manual_[a-z_]+"><\/a>$/ && FILENAME ~ /\/user_manual\.md$/ {
  label = $0
  gsub(/^<a id="|"><\/a>$/, "", label)
  sub(/^## /, "", held)
  print "- \\subpage " label " \"" held "\""
  is_held = 0
  is_chapter = 1
}
is_chapter {
  print ""
  next
}
is_held && /^<a id="[a-z0-9_]+"><\/a>$/ {
  label = $0
  gsub(/^<a id="|"><\/a>$/, "", label)
  print held " {#" label "}"
  print ""
  is_held = 0
  next
}
/^#+ / {
  flush()
  held = with_references($0)
  gsub(/`/, "", held) # doxygen would show a tag
  is_held = 1
  next
}
$0 == "<!-- [TOC] -->" { $0 = "[TOC]" }
{
  flush()
  print with_references($0)
}
END { flush() }
