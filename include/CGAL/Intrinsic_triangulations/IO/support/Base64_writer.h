// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_BASE64_WRITER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_BASE64_WRITER_H

#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace CGAL::Intrinsic_triangulations::internal {

// Writes numbers, least significant byte first, in base64 (RFC 4648): three bytes as four characters.
class Base64_writer {
public:
  explicit Base64_writer(Output_buffer& out) : out_(out) {}

  template <Arithmetic T>
  void put(T value) {
    if (used_ + sizeof(T) > sizeof(bytes_)) encode_triples();
    std::memcpy(bytes_ + used_, &value, sizeof(T));
    if constexpr (std::endian::native == std::endian::big)
      std::reverse(bytes_ + used_, bytes_ + used_ + sizeof(T));
    used_ += sizeof(T);
  }

  // Ends a block, padding it with `=` to a multiple of four characters.
  void finish() {
    encode_triples();
    if (used_ == 0) return;
    std::fill(bytes_ + used_, bytes_ + 3, static_cast<unsigned char>(0));
    char code[4];
    encode(bytes_, code);
    std::fill(code + used_ + 1, code + 4, '=');
    out_.text(std::string_view(code, 4));
    used_ = 0;
  }

private:
  static void encode(const unsigned char* b, char* code) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned x = (unsigned{b[0]} << 16) | (unsigned{b[1]} << 8) | unsigned{b[2]};
    code[0] = digits[x >> 18];
    code[1] = digits[(x >> 12) & 63];
    code[2] = digits[(x >> 6) & 63];
    code[3] = digits[x & 63];
  }

  void encode_triples() {
    const std::size_t whole = used_ / 3 * 3;
    char code[sizeof(bytes_) / 3 * 4];
    for (std::size_t i = 0; i < whole; i += 3) encode(bytes_ + i, code + i / 3 * 4);
    out_.text(std::string_view(code, whole / 3 * 4));
    std::copy(bytes_ + whole, bytes_ + used_, bytes_);
    used_ -= whole;
  }

  Output_buffer& out_;
  std::size_t used_ = 0;
  unsigned char bytes_[3072];
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_BASE64_WRITER_H
