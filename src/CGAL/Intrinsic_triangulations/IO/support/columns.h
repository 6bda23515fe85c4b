// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_COLUMNS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_COLUMNS_H

#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/*!
\file
Files of polygons and lines contain tables: PLY and VTK's XML format write the same columns.
*/

namespace CGAL::Intrinsic_triangulations::internal {

// A type of numbers, as formats name it.
struct Number_type {
  std::string_view in_PLY, in_VTK;
  std::size_t bytes;
};
template <class T>
inline constexpr Number_type number_type{"uchar", "UInt8", 1};
template <>
inline constexpr Number_type number_type<double>{"double", "Float64", 8};
template <>
inline constexpr Number_type number_type<std::int64_t>{"", "Int64", 8};
template <>
inline constexpr Number_type number_type<std::int32_t>{"int", "Int32", 4};

// One number or tuple in each row of a table.
struct Column {
  std::string name;                    // in VTK
  std::vector<std::string> components; // in PLY
  Number_type type;
  std::size_t size;
  std::function<void(Output_buffer&, std::size_t, std::size_t)> write; // rows from one to another
};

// A column of tuples: the i-th is `tuple(i)`, an array.
template <class Tuple>
Column tuples(std::string name, std::vector<std::string> components, std::size_t size,
              Tuple tuple) {
  using T = typename std::remove_cvref_t<decltype(tuple(0))>::value_type;
  return {std::move(name), std::move(components), number_type<T>, size,
          [tuple = std::move(tuple)](Output_buffer& out, std::size_t i, std::size_t end) {
            for (; i < end; ++i)
              for (const T x : tuple(i)) out.number(x);
          }};
}
// A column of numbers: the i-th is `value(i)`.
template <class Value>
Column numbers(const std::string& name, std::size_t size, Value value) {
  return tuples(name, {name}, size,
                [value = std::move(value)](std::size_t i) { return std::array{value(i)}; });
}

struct Table {
  std::string name;
  std::vector<Column> columns;

  std::size_t size() const { return columns.back().size; }
};

// Writes PLY, as text or binary, little endian: a table for each kind of element.
inline void write_PLY(Output_buffer& out, bool is_binary, std::string_view comments,
                      std::span<const Table> elements) {
  out.text("ply\nformat ", is_binary ? "binary_little_endian" : "ascii", " 1.0\n", comments);
  for (const Table& table : elements) {
    out.text("element ", table.name, ' ', table.size(), '\n');
    for (const Column& column : table.columns)
      for (const std::string& component : column.components)
        out.text("property ", column.type.in_PLY, ' ', component, '\n');
  }
  out.text("end_header\n");
  out.format = is_binary ? Number_format::binary : Number_format::text;
  for (const Table& table : elements)
    for (std::size_t i = 0; i < table.size(); ++i) {
      for (const Column& column : table.columns) column.write(out, i, i + 1);
      if (!is_binary) out.line();
    }
}

// A table of VTK's cells: their points one after another, and where each cell ends.
template <class Point, class End>
Table VTK_cells(std::string name, std::size_t points, Point point, std::size_t cells, End end) {
  const auto whole = [](auto value) {
    return [value](std::size_t i) { return static_cast<std::int64_t>(value(i)); };
  };
  return {std::move(name),
          {numbers("connectivity", points, whole(point)), numbers("offsets", cells, whole(end))}};
}

// Writes VTK's XML format for polygon data. Arrays are inline in base64: the number of their bytes,
// as UInt64, and then their numbers, encoded in one go.
// \param tables PointData, CellData, Points, Verts, Lines, Polys, of which some may be missing
inline void write_VTP(Output_buffer& out, std::string_view comment, std::span<const Table> tables) {
  out.text("<?xml version=\"1.0\"?>\n", comment,
           "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n<PolyData>\n<Piece");
  for (const std::string_view name : {"Points", "Verts", "Lines", "Strips", "Polys"}) {
    const auto table = std::ranges::find(tables, name, &Table::name);
    out.text(" NumberOf", name, "=\"", table == tables.end() ? 0 : table->size(), '"');
  }
  out.text(">\n");
  out.format = Number_format::base64;
  for (const Table& table : tables) {
    out.text('<', table.name, ">\n");
    for (const Column& column : table.columns) {
      out.text("<DataArray type=\"", column.type.in_VTK, "\" Name=\"", column.name,
               "\" NumberOfComponents=\"", column.components.size(), "\" format=\"binary\">\n");
      out.base64(std::uint64_t{column.size * column.components.size() * column.type.bytes});
      column.write(out, 0, column.size);
      out.finish_base64();
      out.text("\n</DataArray>\n");
    }
    out.text("</", std::string_view(table.name).substr(0, table.name.find(' ')), ">\n");
  }
  out.text("</Piece>\n</PolyData>\n</VTKFile>\n");
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_COLUMNS_H
