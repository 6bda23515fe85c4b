// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/matrix_market.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>

#include <gtest/gtest.h>
#include <unsupported/Eigen/SparseExtra>

#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
namespace fs = std::filesystem;
using Matrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

// an empty directory of its own for each test
class Matrix_market : public ::testing::Test {
protected:
  void SetUp() override {
    directory = fs::path(::testing::TempDir()) /
                ("matrix_market_" + std::to_string(std::random_device()()));
    fs::create_directories(directory);
  }
  void TearDown() override { fs::remove_all(directory); }

  static std::string content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(directory), fs::directory_iterator());
  }

  fs::path directory;
};

Matrix matrix(int rows, int columns, const Triplets& triplets) {
  Matrix m(rows, columns);
  m.setFromTriplets(triplets.begin(), triplets.end());
  return m;
}

std::string text(const Matrix& m, const std::string& comment = {}) {
  std::ostringstream out;
  IT::write_matrix_market(out, m, comment);
  return out.str();
}

TEST_F(Matrix_market, is_symmetric_where_the_transposed_matrix_is_the_same) {
  std::mt19937 random(5);
  for (int i = 0; i < 3000; ++i) {
    Triplets triplets;
    const int size = 1 + i % 3;
    for (int r = 0; r < size; ++r)
      for (int c = 0; c < size; ++c)
        if (const auto x = random() % 3; x > 0) triplets.emplace_back(r, c, double(x));
    const Matrix m = matrix(size, size, triplets);
    const bool is_symmetric = Eigen::MatrixXd(m) == Eigen::MatrixXd(m).transpose();
    EXPECT_EQ(text(m).find("symmetric") != std::string::npos, is_symmetric) << m;
  }
}

TEST_F(Matrix_market, of_a_symmetric_matrix_holds_the_lower_triangle_counted_from_one) {
  const Matrix m = matrix(3, 3, {{0, 0, 2}, {0, 1, -0.5}, {1, 0, -0.5}, {1, 1, 1e100}, {2, 2, 0}});
  EXPECT_EQ(text(m), "%%MatrixMarket matrix coordinate real symmetric\n"
                     "3 3 4\n"
                     "1 1 2\n"
                     "2 1 -0.5\n"
                     "2 2 1e+100\n"
                     "3 3 0\n");
}

TEST_F(Matrix_market, of_other_matrices_and_of_expressions) {
  const Matrix m = matrix(1, 2, {{0, 1, 0.5}});
  const std::string expected = "%%MatrixMarket matrix coordinate real general\n1 2 1\n1 2 ";
  std::ostringstream rows, product, complex;
  IT::write_matrix_market(rows, Eigen::SparseMatrix<double, Eigen::RowMajor>(m));
  EXPECT_EQ(rows.str(), expected + "0.5\n");
  IT::write_matrix_market(product, 3 * m);
  EXPECT_EQ(product.str(), expected + "1.5\n");
  IT::write_matrix_market(
      complex, Eigen::SparseMatrix<std::complex<double>>(m * std::complex<double>(2, -1)));
  EXPECT_EQ(complex.str(), "%%MatrixMarket matrix coordinate complex general\n1 2 1\n1 2 1 -0.5\n");
}

TEST_F(Matrix_market, of_a_matrix_that_is_not_symmetric_holds_all) {
  EXPECT_EQ(text(matrix(2, 2, {{0, 1, 1}, {1, 0, std::nextafter(1, 2)}})),
            "%%MatrixMarket matrix coordinate real general\n"
            "2 2 2\n"
            "2 1 1.0000000000000002\n"
            "1 2 1\n");
  EXPECT_EQ(text(matrix(1, 3, {{0, 2, 7}})),
            "%%MatrixMarket matrix coordinate real general\n1 3 1\n1 3 7\n");
}

TEST_F(Matrix_market, takes_a_matrix_that_is_not_compressed_and_one_without_entries) {
  Matrix m(2, 2);
  m.reserve(Eigen::VectorXi::Constant(2, 5));
  m.insert(1, 1) = 3;
  EXPECT_EQ(text(m), "%%MatrixMarket matrix coordinate real symmetric\n2 2 1\n2 2 3\n");
  EXPECT_EQ(text(Matrix(0, 0)), "%%MatrixMarket matrix coordinate real symmetric\n0 0 0\n");
}

TEST_F(Matrix_market, carries_a_comment_of_several_lines) {
  EXPECT_EQ(text(Matrix(1, 1), "cotangent Laplacian\n\nof a mesh"),
            "%%MatrixMarket matrix coordinate real symmetric\n"
            "% cotangent Laplacian\n% \n% of a mesh\n1 1 0\n");
}

TEST_F(Matrix_market, is_read_back_without_loss) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<int> exponent(-1000, 1000), place(0, 199);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  Triplets lower;
  for (int k = 0; k < 2000; ++k) {
    const int i = place(random), j = place(random);
    lower.emplace_back(std::max(i, j), std::min(i, j),
                       std::ldexp(mantissa(random), exponent(random)));
  }
  lower.emplace_back(0, 0, std::numeric_limits<double>::denorm_min());
  lower.emplace_back(199, 199, -std::numeric_limits<double>::max());
  Matrix half(200, 200);
  half.setFromTriplets(lower.begin(), lower.end(), [](double, double last) { return last; });
  const Matrix m = half.selfadjointView<Eigen::Lower>();
  const fs::path file = directory / "m.mtx";
  IT::write_matrix_market(file, m, "a comment");
  Matrix back;
  ASSERT_TRUE(Eigen::loadMarket(back, file.string()));
  EXPECT_EQ(back.nonZeros(), half.nonZeros());
  EXPECT_EQ(Eigen::MatrixXd(back), Eigen::MatrixXd(half));
}

TEST_F(Matrix_market, does_not_follow_the_locale_of_the_stream) {
  struct Commas : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  std::ostringstream out;
  out.imbue(std::locale(std::locale::classic(), new Commas));
  IT::write_matrix_market(out, matrix(5000, 5000, {{4999, 4999, 0.5}}));
  EXPECT_EQ(out.str(),
            "%%MatrixMarket matrix coordinate real symmetric\n5000 5000 1\n5000 5000 0.5\n");
}

TEST_F(Matrix_market, replaces_a_file_and_leaves_nothing_else) {
  const fs::path file = directory / "m.mtx";
  std::ofstream(file) << "old";
  const Matrix m = matrix(1, 1, {{0, 0, 1}});
  IT::write_matrix_market(file, m);
  EXPECT_EQ(content(file), text(m));
  EXPECT_EQ(files(), 1);
}

TEST_F(Matrix_market, writes_through_a_symbolic_link) {
  const fs::path file = directory / "m.mtx", link = directory / "link.mtx";
  std::ofstream(file) << "old";
  fs::create_symlink(file, link);
  IT::write_matrix_market(link, Matrix(1, 1));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(content(file), text(Matrix(1, 1)));
  EXPECT_EQ(files(), 2);
}

TEST_F(Matrix_market, names_the_file_that_cannot_be_written_and_leaves_nothing) {
  for (const fs::path& file : {directory / "missing" / "m.mtx", directory}) {
    try {
      IT::write_matrix_market(file, Matrix(1, 1));
      ADD_FAILURE() << "wrote " << file;
    } catch (const IT::File_error& e) {
      EXPECT_NE(std::string(e.what()).find(file.string()), std::string::npos) << e.what();
      EXPECT_EQ(e.path(), file);
      EXPECT_EQ(e.code(), file == directory ? std::errc::is_a_directory
                                            : std::errc::no_such_file_or_directory);
    }
  }
  EXPECT_EQ(files(), 0);
}

TEST_F(Matrix_market, reports_a_full_disk) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "the system has no device that is always full";
  EXPECT_THROW(IT::write_matrix_market("/dev/full", Matrix(1, 1)), std::runtime_error);
}

TEST_F(Matrix_market, reports_a_stream_that_fails) {
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  EXPECT_THROW(IT::write_matrix_market(out, Matrix(1, 1)), std::runtime_error);
}

TEST_F(Matrix_market, leaves_the_file_as_it_was_when_writing_fails) {
  const fs::path file = directory / "m.mtx";
  std::ofstream(file) << "old";
  {
    IT::Replacing_file replacing(file);
    replacing.stream() << "half";
  } // no commit
  EXPECT_EQ(content(file), "old");
  EXPECT_EQ(files(), 1);
}

} // namespace
