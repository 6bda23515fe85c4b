// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_OUTPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_OUTPUT_H

#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <string_view>

namespace CGAL::Intrinsic_triangulations::internal {

// Writes text, scripts and numbers as a page of HTML has them.
class Page_output : public Output_buffer {
public:
  using Output_buffer::Output_buffer;

  void escaped(std::string_view plain) {
    constexpr std::string_view special = "<>&\"";
    constexpr std::array<std::string_view, 4> names{"&lt;", "&gt;", "&amp;", "&quot;"};
    for (const char c : plain)
      if (const std::size_t i = special.find(c); i != std::string_view::npos)
        text(names[i]);
      else
        text(c);
  }

  // An end tag inside a script would end it, in capitals too; in a string of JavaScript <\/ is </.
  void script(std::string_view program) {
    text("<script>\n");
    for (std::size_t i = program.find("</"); i != std::string_view::npos; i = program.find("</")) {
      text(program.substr(0, i),
           i + 2 < program.size() && (program[i + 2] | 32) == 's' ? "<\\/" : "</");
      program.remove_prefix(i + 2);
    }
    text(program, "\n</script>\n");
  }

  template <class Write>
  void data(std::string_view id, Write write) {
    open_data(id);
    text(">");
    close_data(write);
  }
  template <class Numbers>
  void numbers(std::string_view id, const Numbers& all) {
    data(id, [&](Output_buffer& out) {
      for (const auto x : all) out.base64(x);
    });
  }
  template <class Tuples>
  void tuples(std::string_view id, const Tuples& all) {
    data(id, [&](Output_buffer& out) {
      for (const auto& tuple : all)
        for (const auto x : tuple) out.base64(x);
    });
  }
  // Data is text in base64, which the page finds by its id.
  void open_data(std::string_view id) {
    text("<script type=\"application/octet-stream;base64\" id=\"", id, "\"");
  }
  template <class Write>
  void close_data(Write write) {
    write(*this);
    finish_base64();
    text("</script>\n");
  }
};

// Takes what comes before the next @, and that, off the front
inline std::string_view next_part(std::string_view& rest) {
  const std::string_view part = rest.substr(0, rest.find('@'));
  rest.remove_prefix(std::min(part.size() + 1, rest.size()));
  return part;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_OUTPUT_H
