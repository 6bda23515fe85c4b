// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/soup/scan.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Scans the vertices and faces of a PLY file, text or binary of either byte order.
class PLY_scanner {
public:
  PLY_scanner(std::istream& in, std::uintmax_t file_size, Soup_builder& out)
      : in_(in), file_size_(file_size), out_(out) {}

  void run() {
    scan_header();
    for (const Element& e : elements_) {
      if (e.name == "vertex" || e.name == "vertices")
        scan_vertices(e);
      else if (e.name == "face" || e.name == "faces")
        scan_faces(e);
      else if (!e.properties.empty())
        for (std::uint64_t i = 0; i < e.count; ++i)
          for (const Property& p : e.properties) read_values(e, i, p);
    }
  }

private:
  struct Type {
    std::string_view name, other_name;
    bool is_integer;
    bool (PLY_scanner::*read)(double&);
  };

  struct Property {
    std::string name;
    const Type* type = nullptr;
    const Type* size_type = nullptr; // of a list
  };

  struct Element {
    std::string name;
    std::uint64_t count;
    std::vector<Property> properties;
  };

  void scan_header() {
    std::string_view line;
    const bool is_ply = in_.next_line(line) && next_word(line) == "ply";
    out_.line = in_.line_number();
    if (!is_ply)
      out_.fail(
          "the file does not start with the line ply; check that it is a PLY file, or give it the "
          "extension of its format");
    bool has_format = false;
    while (in_.next_line(line)) {
      out_.line = in_.line_number();
      const std::string_view keyword = next_word(line);
      if (keyword == "end_header") {
        if (!has_format)
          out_.fail("the header has no format line; add one, such as format ascii 1.0");
        return;
      }
      if (keyword == "format") {
        scan_format(next_word(line));
        has_format = true;
      }
      if (keyword == "element") scan_element(line);
      if (keyword == "property") scan_property(line);
    }
    out_.fail("the file ends within its header; it is truncated: get a complete copy");
  }

  void scan_format(std::string_view format) {
    text_ = format == "ascii";
    order_ = format == "binary_big_endian" ? std::endian::big : std::endian::little;
    if (!text_ && order_ == std::endian::little && format != "binary_little_endian")
      out_.fail(
          "the format \"" + shown(format) +
          "\" is not one of ascii, binary_little_endian, binary_big_endian; correct the header");
  }

  void scan_element(std::string_view line) {
    Element e{std::string(next_word(line)), 0, {}};
    if (!parse_number(next_word(line), e.count))
      out_.fail("element " + shown(e.name) + " has no valid count; correct the header");
    elements_.push_back(std::move(e));
  }

  void scan_property(std::string_view line) {
    Property p;
    std::string_view type = next_word(line);
    if (type == "list") {
      p.size_type = &type_of(next_word(line));
      type = next_word(line);
    }
    p.type = &type_of(type);
    p.name = next_word(line);
    if (elements_.empty() || p.name.empty() || (p.size_type != nullptr && !p.size_type->is_integer))
      out_.fail(
          "the property is not one of an element, with a name and an integer size; correct the "
          "header");
    elements_.back().properties.push_back(std::move(p));
  }

  const Type& type_of(std::string_view name) {
    static constexpr std::array<Type, 8> types{
        {{"char", "int8", true, &PLY_scanner::read_as<std::int8_t>},
         {"uchar", "uint8", true, &PLY_scanner::read_as<std::uint8_t>},
         {"short", "int16", true, &PLY_scanner::read_as<std::int16_t>},
         {"ushort", "uint16", true, &PLY_scanner::read_as<std::uint16_t>},
         {"int", "int32", true, &PLY_scanner::read_as<std::int32_t>},
         {"uint", "uint32", true, &PLY_scanner::read_as<std::uint32_t>},
         {"float", "float32", false, &PLY_scanner::read_as<float>},
         {"double", "float64", false, &PLY_scanner::read_as<double>}}};
    for (const Type& type : types)
      if (name == type.name || name == type.other_name) return type;
    out_.fail("\"" + shown(name) + "\" is not a type of PLY; correct the header");
  }

  // Every value of the format is exact as a double; false at the end of the file or for a word that
  // is not a number. A text value of a float property is rounded to float, as CGAL rounds it.
  template <class Number>
  bool read_as(double& value) {
    Number number{};
    if (!text_) {
      if (!read_binary(in_, number, order_)) return false;
      value = static_cast<double>(number);
      return true;
    }
    const std::string_view word = in_.next_word_of_file(line_);
    if (!std::is_same_v<Number, float>) return parse_number(word, value);
    float rounded = 0;
    const bool good = parse_number(word, rounded);
    value = static_cast<double>(rounded);
    return good;
  }

  [[noreturn]] void fail_item(const Element& e, std::uint64_t i) {
    set_line();
    const Element_kind kind = e.name.substr(0, 4) == "face"   ? Element_kind::face
                              : e.name.substr(0, 4) == "vert" ? Element_kind::vertex
                                                              : Element_kind::none;
    out_.fail(kind, static_cast<std::size_t>(i),
              shown(e.name) + " " + std::to_string(i) + " of the " + std::to_string(e.count) +
                  " that the header announces is missing or malformed; get a complete copy if the "
                  "file is truncated, or correct it");
  }

  // Reads the values of one property; a scalar is a list of one. Lists grow as they are read: a
  // wrong size must not claim memory.
  void read_values(const Element& e, std::uint64_t i, const Property& p) {
    values_.clear();
    double size = 1, value = 0;
    if (p.size_type != nullptr && (!(this->*p.size_type->read)(size) || size < 0)) fail_item(e, i);
    for (double k = 0; k < size; ++k) {
      if (!(this->*p.type->read)(value)) fail_item(e, i);
      values_.push_back(value);
    }
  }

  void set_line() { out_.line = text_ ? in_.line_number() : 0; }

  // No more items than the file has room for.
  std::size_t room(const Element& e, unsigned bytes) const {
    return static_cast<std::size_t>(std::min<std::uint64_t>(e.count, file_size_ / bytes));
  }

  template <class Condition>
  static std::size_t find_property(const Element& e, Condition condition) {
    return static_cast<std::size_t>(std::ranges::find_if(e.properties, condition) -
                                    e.properties.begin());
  }

  void scan_vertices(const Element& e) {
    std::array<std::size_t, 3> where{};
    for (unsigned k = 0; k < 3; ++k) {
      const char name = static_cast<char>('x' + k);
      where[k] = find_property(e, [&](const Property& p) {
        return p.size_type == nullptr && p.name == std::string_view(&name, 1);
      });
      if (where[k] == e.properties.size())
        out_.fail(std::string("vertices have no property ") + name + "; add their coordinates");
    }
    out_.reserve(room(e, 6), 0);
    for (std::uint64_t i = 0; i < e.count; ++i) {
      double xyz[3] = {0, 0, 0};
      for (std::size_t j = 0; j < e.properties.size(); ++j) {
        read_values(e, i, e.properties[j]);
        for (unsigned k = 0; k < 3; ++k)
          if (where[k] == j) xyz[k] = values_[0];
      }
      set_line();
      out_.add_vertex(xyz[0], xyz[1], xyz[2]);
    }
  }

  void scan_faces(const Element& e) {
    const std::size_t where = find_property(e, [](const Property& p) {
      return p.size_type != nullptr && (p.name == "vertex_indices" || p.name == "vertex_index");
    });
    if (where == e.properties.size())
      out_.fail("faces have no list property vertex_indices or vertex_index; add their vertices");
    out_.forward_references = out_.number_of_vertices() == 0;
    out_.reserve(0, room(e, 7));
    std::vector<std::int64_t> face;
    for (std::uint64_t i = 0; i < e.count; ++i) {
      for (std::size_t j = 0; j < e.properties.size(); ++j) {
        read_values(e, i, e.properties[j]);
        if (j != where) continue;
        face.clear();
        for (const double v : values_) {
          if (!(std::abs(v) < 0x1p53) || std::trunc(v) != v) fail_item(e, i);
          face.push_back(static_cast<std::int64_t>(v));
        }
      }
      set_line();
      out_.add_face(face);
    }
  }

  Buffered_input in_;
  std::uintmax_t file_size_;
  Soup_builder& out_;
  std::string_view line_;
  std::vector<Element> elements_;
  std::vector<double> values_;
  bool text_ = true;
  std::endian order_ = std::endian::little;
};

} // namespace

void scan_PLY(std::istream& in, std::uintmax_t file_size, Soup_builder& out) {
  PLY_scanner(in, file_size, out).run();
}

} // namespace CGAL::Intrinsic_triangulations::internal
