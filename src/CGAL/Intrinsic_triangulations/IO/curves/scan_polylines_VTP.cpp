// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/curves/scan_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// What lies between two texts, the first of which is at or after a place; empty if they are not
// there.
std::string_view text_between(std::string_view text, std::string_view open,
                              std::string_view close) {
  const std::size_t begin = text.find(open);
  const std::size_t end = text.find(close, begin == text.npos ? begin : begin + open.size());
  return end == text.npos ? std::string_view()
                          : text.substr(begin + open.size(), end - begin - open.size());
}

[[noreturn]] void fail_VTP() {
  fail_polylines("arrays of the file are not as .vtp has them here, inline and in base64 without "
                 "compression; write the curves to .obj");
}

// The bytes of a text in base64, up to what is none.
std::string decoded_base64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::uint32_t digit = c >= 'A' && c <= 'Z'   ? static_cast<std::uint32_t>(c - 'A')
                                : c >= 'a' && c <= 'z' ? static_cast<std::uint32_t>(c - 'a') + 26
                                : c >= '0' && c <= '9' ? static_cast<std::uint32_t>(c - '0') + 52
                                : c == '+'             ? 62
                                : c == '/'             ? 63
                                                       : 64;
    if (digit == 64) continue; // an end of a line, or padding
    bits = (bits << 6 | digit) & 0xffffffU;
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255U);
  }
  return bytes;
}

// The numbers of an array, whose first bytes tell how many bytes follow.
template <class T>
std::vector<T> VTP_array(std::string_view section, const std::string& attribute,
                         std::string_view type) {
  std::string_view rest = section;
  while (true) {
    const std::string_view array = text_between(rest, "<DataArray", "</DataArray>");
    if (array.empty()) return {};
    const std::string_view head = array.substr(0, array.find('>'));
    rest = rest.substr(static_cast<std::size_t>(array.data() + array.size() - rest.data()));
    if (head.find(attribute) == head.npos) continue;
    if (head.find("type=\"" + std::string(type) + '"') == head.npos ||
        head.find("format=\"binary\"") == head.npos)
      fail_VTP();
    const std::string bytes = decoded_base64(array.substr(head.size() + 1));
    std::uint64_t size = 0;
    if (bytes.size() < sizeof size) fail_VTP();
    std::memcpy(&size, bytes.data(), sizeof size);
    if (size != bytes.size() - sizeof size || size % sizeof(T) != 0) fail_VTP();
    std::vector<T> values(size / sizeof(T));
    if (size > 0) std::memcpy(values.data(), bytes.data() + sizeof size, size);
    return values;
  }
}

class VTP_polyline_scanner {
public:
  explicit VTP_polyline_scanner(std::string_view text) {
    if (text_between(text, "<VTKFile", "byte_order=\"LittleEndian\" header_type=\"UInt64\">")
            .empty() ||
        text.find("compressor=") != text.npos)
      fail_VTP();
    points_ = VTP_array<double>(text_between(text, "<Points>", "</Points>"), "", "Float64");
    labels_ = VTP_array<std::int32_t>(text_between(text, "<CellData", "</CellData>"), "", "Int32");
    scan_cells(text_between(text, "<Verts>", "</Verts>"));
    scan_cells(text_between(text, "<Lines>", "</Lines>"));
  }

  std::vector<Polyline> polylines;

private:
  void scan_cells(std::string_view section) {
    const auto corners = VTP_array<std::int64_t>(section, "Name=\"connectivity\"", "Int64");
    const auto ends = VTP_array<std::int64_t>(section, "Name=\"offsets\"", "Int64");
    std::size_t k = 0;
    for (const std::int64_t end : ends) {
      if (end < 0 || static_cast<std::size_t>(end) > corners.size()) fail_VTP();
      Polyline& line = polylines.emplace_back();
      line.label = polylines.size() <= labels_.size()
                       ? labels_[polylines.size() - 1]
                       : static_cast<std::int32_t>(polylines.size() - 1);
      for (; k < static_cast<std::size_t>(end); ++k) line.points.push_back(point(corners[k]));
      close_polyline(line);
    }
  }

  std::array<double, 3> point(std::int64_t i) const {
    if (i < 0 || 3 * (static_cast<std::size_t>(i) + 1) > points_.size())
      fail_polylines("a line refers to point " + std::to_string(i) +
                     ", which is not there; write the file again");
    const double* const p = points_.data() + 3 * i;
    return {p[0], p[1], p[2]};
  }

  std::vector<double> points_;
  std::vector<std::int32_t> labels_;
};

} // namespace

std::vector<Polyline> scan_polylines_VTP(std::istream& in) {
  const std::string text(std::istreambuf_iterator<char>(in), {});
  if (text.find("<Lines>") == text.npos && text.find("<Polys>") != text.npos)
    fail_polylines("the file has a surface and no lines; give curves, or a file of values");
  return VTP_polyline_scanner(text).polylines;
}

} // namespace CGAL::Intrinsic_triangulations::internal
