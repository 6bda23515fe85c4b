// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_IMPL_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_PLY.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_VTP.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_mesh.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>
#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>

#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace CGAL::Intrinsic_triangulations::internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void write_subdivision(std::ostream& out,
                                                            std::string_view extension,
                                                            const Subdivision_output& o,
                                                            const Subdivision_format& format) {
  const std::string name = plain_extension(extension);
  check_output(o);
  Output_buffer buffer(out);
  if (name == "ply" && format.is_binary.value_or(true))
    PLY_subdivision_writer<true>(buffer, o).run();
  else if (name == "ply")
    PLY_subdivision_writer<false>(buffer, o).run();
  else if (name == "obj")
    write_OBJ(buffer, o, format.has_lines.value_or(false));
  else if (name == "off")
    write_OFF(buffer, o);
  else if (name == "stl")
    write_STL(buffer, o);
  else if (name == "vtp")
    VTP_subdivision_writer(buffer, o, format.has_lines.value_or(true)).run();
  else
    throw Invalid_input(Element_kind::none, 0,
                        "the extension \"" + name +
                            "\" is not supported; write the common subdivision to .ply, .obj, "
                            ".off, .stl or .vtp");
  if (!buffer.flush())
    throw std::runtime_error("the common subdivision cannot be written completely");
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void write_subdivision(const std::filesystem::path& path,
                                                            const Subdivision_output& o,
                                                            const Subdivision_format& format) {
  Replacing_file file(path);
  try {
    write_subdivision(file.stream(), path.extension().string(), o, format);
  } catch (const Invalid_input& e) {
    throw Invalid_input(e.kind(), e.index(), path.string() + ": " + e.what());
  } catch (const std::runtime_error&) {
    throw std::runtime_error(path.string() +
                             ": the file cannot be written completely; is the disk full?");
  }
  file.commit();
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_IMPL_H
