// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_VTK_ARRAY_WRITER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_VTK_ARRAY_WRITER_H

#include <CGAL/Intrinsic_triangulations/IO/support/Base64_writer.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

template <class T>
inline constexpr std::string_view VTK_type = std::is_same_v<T, double>         ? "Float64"
                                             : std::is_same_v<T, std::int64_t> ? "Int64"
                                             : std::is_same_v<T, std::int32_t> ? "Int32"
                                                                               : "UInt8";

// Writes arrays of VTK's XML formats, inline in base64: the number of their bytes, as UInt64, and then their numbers,
// encoded in one go.
class VTK_array_writer {
public:
  explicit VTK_array_writer(Output_buffer& out) : out_(out) {}

  // Writes `count` arrays of components, the i-th of which is `tuple(i)`.
  template <class Tuple>
  void arrays(std::string_view name, std::size_t count, Tuple tuple) {
    using Components = std::remove_cvref_t<decltype(tuple(0))>;
    using T = typename Components::value_type;
    out_.text("<DataArray type=\"", VTK_type<T>, "\" Name=\"", name, "\" NumberOfComponents=\"",
              std::tuple_size_v<Components>, "\" format=\"binary\">\n");
    Base64_writer base64(out_);
    base64.put(std::uint64_t{count * sizeof(Components)});
    for (std::size_t i = 0; i < count; ++i)
      for (const T x : tuple(i)) base64.put(x);
    base64.finish();
    out_.text("\n</DataArray>\n");
  }
  // Writes `count` numbers, the i-th of which is `value(i)`.
  template <class Value>
  void scalars(std::string_view name, std::size_t count, Value value) {
    arrays(name, count, [&](std::size_t i) { return std::array{value(i)}; });
  }

private:
  Output_buffer& out_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_VTK_ARRAY_WRITER_H
