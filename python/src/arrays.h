// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_ARRAYS_H
#define INTRINSIC_PYTHON_ARRAYS_H

#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/*!
\file
Arrays of numpy as Eigen's matrices and vectors, and back. Arguments may have any numeric type and
any strides: numpy copies them where that is needed. Results keep the memory that was computed, so
that nothing is copied.
*/

namespace python {

namespace py = pybind11;
namespace IT = CGAL::Intrinsic_triangulations;

/// Coordinates of a point.
using Point = std::array<double, 3>;

/// An argument: numbers, row after row.
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
/// An argument: whole numbers, row after row.
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

/// throws `Invalid_input`, which Python sees as a `ValueError`.
[[noreturn]] inline void refuse(const std::string& message) {
  throw IT::Invalid_input(IT::Element_kind::none, 0, message);
}

/// checks that an array has a number of columns.
inline void expect_columns(const py::array& a, py::ssize_t columns, const char* name) {
  if (a.ndim() != 2 || a.shape(1) != columns)
    refuse(std::string(name) + " needs " + std::to_string(columns) +
           " numbers in each row; give an array of shape (n, " + std::to_string(columns) + ")");
}

/// checks that an array has one number for each of `size` elements.
inline void expect_size(const py::array& a, std::size_t size, const char* name) {
  if (a.ndim() != 1 || static_cast<std::size_t>(a.size()) != size)
    refuse(std::string(name) + " needs one number for each of " + std::to_string(size) +
           " elements; give an array of shape (" + std::to_string(size) + ",)");
}

/// returns the rows of an array as points.
inline std::vector<Point> points_of(const Doubles& a) {
  expect_columns(a, 3, "an array of points");
  const auto rows = a.unchecked<2>();
  std::vector<Point> points(static_cast<std::size_t>(a.shape(0)));
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      points[i][k] = rows(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k));
  return points;
}

/// returns an array as a vector, without a copy: it refers to the array.
inline Eigen::Map<const Eigen::VectorXd> vector_of(const Doubles& a) {
  return {a.data(), static_cast<Eigen::Index>(a.size())};
}

/// A matrix with the order of numpy.
using Row_matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// returns an array of two dimensions, or a column, as a matrix that refers to it.
inline Eigen::Map<const Row_matrix> matrix_of(const Doubles& a) {
  const py::ssize_t columns = a.ndim() == 1 ? 1 : a.shape(1);
  return {a.data(), static_cast<Eigen::Index>(a.shape(0)), static_cast<Eigen::Index>(columns)};
}

/// returns whole numbers of a type, each below `bound`.
/// \param name of an element, for messages: "vertex"
template <std::integral Number = std::uint32_t>
std::vector<Number> numbers_of(const Integers& a, std::size_t bound, const char* name) {
  std::vector<Number> numbers(static_cast<std::size_t>(a.size()));
  const std::int64_t* const data = a.data();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (data[i] < 0 || static_cast<std::uint64_t>(data[i]) >= bound)
      refuse("there is no " + std::string(name) + " " + std::to_string(data[i]) +
             "; numbers are from 0 to " + std::to_string(bound) + " exclusively");
    numbers[i] = static_cast<Number>(data[i]);
  }
  return numbers;
}

/// returns an array with the memory of an object that the array owns from now on.
/// \param data the first number in it
template <class Number, class Owner>
py::array_t<Number> owned_array(std::unique_ptr<Owner> owner, const Number* data,
                                std::vector<py::ssize_t> shape) {
  const py::capsule memory(owner.release(), [](void* p) { delete static_cast<Owner*>(p); });
  return py::array_t<Number>(std::move(shape), data, memory);
}

/// returns a vector of numbers as an array, without a copy.
/// \param shape of the array; empty: one dimension
template <class Number>
py::array_t<Number> array_of(std::vector<Number>&& numbers, std::vector<py::ssize_t> shape = {}) {
  if (shape.empty()) shape = {static_cast<py::ssize_t>(numbers.size())};
  auto owner = std::make_unique<std::vector<Number>>(std::move(numbers));
  const Number* const data = owner->data();
  return owned_array(std::move(owner), data, std::move(shape));
}

/// returns whole numbers of any type as Python has them.
template <class Number>
py::array_t<std::int64_t> whole(const std::vector<Number>& numbers) {
  return array_of(std::vector<std::int64_t>(numbers.begin(), numbers.end()));
}

/// returns a vector of rows of `n` numbers as an array of two dimensions, without a copy.
template <class Number, std::size_t n>
py::array_t<Number> array_of(std::vector<std::array<Number, n>>&& rows) {
  static_assert(sizeof(std::array<Number, n>) == n * sizeof(Number));
  auto owner = std::make_unique<std::vector<std::array<Number, n>>>(std::move(rows));
  const auto size = static_cast<py::ssize_t>(owner->size());
  const Number* const data = owner->empty() ? nullptr : owner->front().data();
  return owned_array(std::move(owner), data, {size, static_cast<py::ssize_t>(n)});
}

/// returns a vector or a matrix of Eigen as an array, without a copy; that of a matrix has
/// Fortran's order unless the matrix has rows.
template <class Scalar, int rows, int columns, int options>
py::array_t<Scalar> array_of(Eigen::Matrix<Scalar, rows, columns, options>&& m) {
  using Matrix = Eigen::Matrix<Scalar, rows, columns, options>;
  auto owner = std::make_unique<Matrix>(std::move(m));
  const Matrix& kept = *owner;
  std::vector<py::ssize_t> shape, strides;
  constexpr py::ssize_t size = sizeof(Scalar);
  shape.push_back(kept.rows());
  strides.push_back(size * (columns == 1 ? 1 : Matrix::IsRowMajor ? kept.cols() : 1));
  if constexpr (columns != 1) {
    shape.push_back(kept.cols());
    strides.push_back(size * (Matrix::IsRowMajor ? 1 : kept.rows()));
  }
  const py::capsule memory(owner.release(), [](void* p) { delete static_cast<Matrix*>(p); });
  return py::array_t<Scalar>(std::move(shape), std::move(strides), kept.data(), memory);
}

/*!
\brief returns a compressed matrix as arrays without a copy: numbers, their indices, where the rows
(or columns) begin, the shape, and whether it is stored by rows. `_arrays.sparse()` makes a matrix
of scipy of them.
*/
template <class Scalar, int options>
py::tuple array_of(Eigen::SparseMatrix<Scalar, options>&& m) {
  using Matrix = Eigen::SparseMatrix<Scalar, options>;
  m.makeCompressed();
  const auto owner = std::make_shared<Matrix>(std::move(m));
  const auto part = [&](const auto* data, Eigen::Index size) {
    return owned_array(std::make_unique<std::shared_ptr<Matrix>>(owner), data,
                       {static_cast<py::ssize_t>(size)});
  };
  return py::make_tuple(part(owner->valuePtr(), owner->nonZeros()),
                        part(owner->innerIndexPtr(), owner->nonZeros()),
                        part(owner->outerIndexPtr(), owner->outerSize() + 1),
                        py::make_tuple(owner->rows(), owner->cols()), bool(Matrix::IsRowMajor));
}

} // namespace python

#endif // INTRINSIC_PYTHON_ARRAYS_H
