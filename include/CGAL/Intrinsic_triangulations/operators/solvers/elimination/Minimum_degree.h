// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_MINIMUM_DEGREE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_MINIMUM_DEGREE_H

#include <CGAL/Intrinsic_triangulations/operators/solvers/elimination/row_number.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Orders the rows of a symmetric matrix so that few entries appear when they are eliminated: next is always one with few neighbours in what is left, of which a
// bound is kept (Amestoy, Davis and Duff 1996). A row that is eliminated becomes an *element*, which joins all its neighbours; elements that have these
// neighbours only are absorbed by it, and so are rows that have no other neighbour. Rows with the same neighbours become one. Rows with very many
// come last. Of a mesh, most rows of which have the same degree, at first rows are eliminated of which none is next to another, all at once.
class Minimum_degree {
public:
  // \pre the pattern of the matrix, which is compressed, is symmetric
  explicit Minimum_degree(const Eigen::SparseMatrix<double>& a)
      : nodes_(row_number(a.cols())), least_(static_cast<int>(a.cols())),
        bucket_(nodes_.size() + 1, -1) {
    same_.fill(-1);
    read(a);
    const bool is_mesh = lists_.size() >= 5 * nodes_.size();
    is_mesh ? eliminate_apart() : put_all();
    while (left_ > 0) eliminate(take_least());
  }

  // the rows; those of an element come right after those of the elements it has absorbed
  std::vector<int> order() const {
    std::vector<int> child(nodes_.size() + 1, -1), sibling(nodes_.size());
    for (const bool is_element : {false, true}) // these come first
      for (int i = static_cast<int>(nodes_.size()) - 1; i >= 0; --i)
        if (const Node& n = nodes_[row_number(i)]; n.is_element() == is_element) {
          int& first = n.parent < 0 ? child.back() : child[row_number(n.parent)];
          sibling[row_number(i)] = first;
          first = i;
        }
    std::vector<int> result, open;
    result.reserve(nodes_.size());
    const auto descend = [&](int i) {
      for (; i >= 0; i = child[row_number(i)]) open.push_back(i);
    };
    for (descend(child.back()); !open.empty();) {
      const int i = open.back();
      open.pop_back();
      result.push_back(i);
      descend(sibling[row_number(i)]);
    }
    return result;
  }

private:
  struct Node {
    bool is_element() const { return elements < 0; }

    std::int64_t mark = 1; // of an element 0 once absorbed; less than the stamp if it was not met
    int begin = 0,
        size = 0;     // of its list: of an element rows, of a row its elements and then other rows
    int elements = 0; // number of these, -1 of an element
    int weight =
        1; // number of rows it stands for; negative while it is in the current element, 0 in another row
    int degree = 0;          // of a row a bound on that, of an element the weight of its rows
    int hash = 0, next = -1; // of the neighbours of a row, and a row with the same hash
    int parent = -1;         // what it was absorbed by
  };
  struct Link {
    int row, next;
  };
  static constexpr std::size_t hashes = 1024;

  Node& at(int i) { return nodes_[row_number(i)]; }
  std::span<int> list(const Node& n) {
    return std::span(lists_).subspan(row_number(n.begin), row_number(n.size));
  }
  std::span<int> elements(const Node& n) { return list(n).first(row_number(n.elements)); }
  std::span<int> rows(const Node& n) { return list(n).subspan(row_number(n.elements)); }

  void read(const Eigen::SparseMatrix<double>& a) {
    const int *const begin = a.outerIndexPtr(), *const inner = a.innerIndexPtr();
    const double many = std::max(16.0, 10 * std::sqrt(static_cast<double>(a.cols())));
    for (int i = 0; i < a.cols(); ++i)
      if (begin[i + 1] - begin[i] > many)
        at(i).weight = 0;
      else
        ++left_;
    lists_.reserve(2 * row_number(a.nonZeros()));
    for (int i = 0; i < a.cols(); ++i) {
      Node& n = at(i);
      n.begin = static_cast<int>(lists_.size());
      if (n.weight == 0) continue;
      for (int e = begin[i]; e < begin[i + 1]; ++e)
        if (inner[e] != i && at(inner[e]).weight > 0) lists_.push_back(inner[e]);
      n.size = n.degree = static_cast<int>(lists_.size()) - n.begin;
    }
  }

  // Eliminates rows of at most the mean degree of a mesh, in their order, unless one next to them has been.
  void eliminate_apart() {
    constexpr int few = 6;
    std::vector<char> is_next(nodes_.size(), 0);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      Node& n = nodes_[i];
      if (is_next[i] != 0 || n.degree > few || n.weight == 0) continue;
      for (const int j : list(n)) is_next[row_number(j)] = 1;
      n.elements = -1;
      --left_;
    }
    std::vector<int> seen(nodes_.size(), -1); // last from which row
    for (int i = 0; i < static_cast<int>(nodes_.size()); ++i)
      if (!at(i).is_element()) find_elements(i, seen);
    put_all();
  }

  // Of the neighbours of a row, brings elements to the front, and leaves only those rows that none of these joins to it.
  void find_elements(int i, std::vector<int>& seen) {
    Node& n = at(i);
    n.degree = 0;
    const auto see = [&](int j) {
      int& from = seen[row_number(j)];
      if (from == i) return false;
      from = i;
      ++n.degree;
      return true;
    };
    seen[row_number(i)] = i;
    const std::span<int> neighbours = list(n);
    for (int& j : neighbours)
      if (at(j).is_element()) {
        for (const int row : list(at(j))) see(row);
        std::swap(j, neighbours[row_number(n.elements++)]);
      }
    n.size = n.elements;
    for (const int j : neighbours.subspan(row_number(n.elements)))
      if (see(j)) neighbours[row_number(n.size++)] = j;
  }

  // Rows are listed again when their degree changes, and not taken from where they were.
  void put(int i) {
    int& first = bucket_[row_number(at(i).degree)];
    links_.push_back({i, first});
    first = static_cast<int>(links_.size()) - 1;
    least_ = std::min(least_, at(i).degree);
  }
  void put_all() {
    for (int i = 0; i < static_cast<int>(nodes_.size()); ++i)
      if (!at(i).is_element() && at(i).weight > 0) put(i);
  }
  int take_least() {
    for (;; ++least_)
      for (int& first = bucket_[row_number(least_)]; first >= 0;) {
        const Link link = links_[row_number(first)];
        first = link.next;
        const Node& n = at(link.row);
        if (n.weight > 0 && !n.is_element() && n.degree == least_) return link.row;
      }
  }

  void eliminate(int k) {
    int weight = at(k).weight;
    make_element(k);
    find_differences(k);
    for (const int i : list(at(k))) weight += update(i, k);
    stamp_ += static_cast<std::int64_t>(nodes_.size());
    for (const int i : list(at(k)))
      if (at(i).weight != 0) join_same(i);
    left_ -= weight;
    finish(k, weight);
  }

  // Its rows are those of its elements, and its own.
  void make_element(int k) {
    const Node old = at(k);
    at(k).weight = -old.weight;
    const int begin = static_cast<int>(lists_.size());
    int weight = 0;
    const auto add = [&](int from, int size) {
      for (int p = from; p < from + size; ++p) {
        const int i = lists_[row_number(p)];
        Node& n = at(i);
        if (n.weight <= 0) continue;
        weight += n.weight;
        n.weight = -n.weight;
        lists_.push_back(i);
      }
    };
    for (int p = old.begin; p < old.begin + old.elements; ++p)
      if (Node& e = at(lists_[row_number(p)]); e.mark != 0) {
        add(e.begin, e.size);
        absorb(e, k);
      }
    add(old.begin + old.elements, old.size - old.elements);
    Node& n = at(k);
    n.begin = begin;
    n.size = static_cast<int>(lists_.size()) - begin;
    n.elements = -1;
    n.degree = weight;
  }
  static void absorb(Node& element, int k) {
    element.parent = k;
    element.mark = 0;
  }

  // Marks elements next to rows of element k with the weight of their rows that are not in it, plus the stamp.
  void find_differences(int k) {
    for (const int i : list(at(k))) {
      const Node& n = at(i);
      for (const int other : elements(n)) {
        Node& e = at(other);
        if (e.mark == 0) continue;
        if (e.mark < stamp_) e.mark = e.degree + stamp_;
        e.mark += n.weight;
      }
    }
  }

  // Removes from the list of a row of element k what that has absorbed or joins it to, and bounds its degree apart from that. \return its weight if nothing is left
  int update(int i, int k) {
    Node& n = at(i);
    const std::span<int> all = list(n);
    std::size_t hash = 0;
    int degree = 0;
    auto to = all.begin();
    const auto keep = [&](int j, int weight) {
      degree += weight;
      hash += row_number(j);
      *to++ = j;
    };
    for (const int other : elements(n)) {
      Node& e = at(other);
      if (e.mark > stamp_)
        keep(other, static_cast<int>(e.mark - stamp_));
      else if (e.mark != 0)
        absorb(e, k);
    }
    const auto first_row = to;
    for (const int j : rows(n))
      if (const int weight = at(j).weight; weight > 0) keep(j, weight);
    if (degree == 0) {
      const int weight = -n.weight;
      absorb_row(n, k);
      return weight;
    }
    *to++ = *first_row; // there is room, of what joined it to the element
    *first_row = all.front();
    all.front() = k;
    n.elements = static_cast<int>(first_row - all.begin()) + 1;
    n.size = static_cast<int>(to - all.begin());
    n.degree = std::min(n.degree, degree);
    n.hash = static_cast<int>(hash % hashes);
    int& first = same_[row_number(n.hash)];
    n.next = first;
    first = i;
    return 0;
  }
  static void absorb_row(Node& row, int by) {
    row.parent = by;
    row.weight = 0;
  }

  // Makes rows of the current element one where they have the same neighbours, among those with the hash of a row.
  void join_same(int i) {
    int& first = same_[row_number(at(i).hash)];
    i = first;
    first = -1;
    for (; i >= 0 && at(i).next >= 0; i = at(i).next) {
      Node& n = at(i);
      for (const int j : list(n)) at(j).mark = stamp_;
      for (int* next = &n.next; *next >= 0;) {
        Node& other = at(*next);
        if (other.size == n.size && other.elements == n.elements &&
            std::ranges::all_of(list(other), [this](int j) { return at(j).mark == stamp_; })) {
          n.weight += other.weight;
          absorb_row(other, i);
          *next = other.next;
        } else
          next = &other.next;
      }
      ++stamp_;
    }
  }

  // Leaves rows in element k that stand for themselves, and lists these by degree.
  void finish(int k, int weight) {
    Node& element = at(k);
    element.degree -= weight - std::abs(element.weight);
    element.weight = weight;
    int size = 0;
    for (const int i : list(element)) {
      Node& n = at(i);
      if (n.weight == 0) continue;
      n.weight = -n.weight;
      n.degree = std::min(n.degree + element.degree, left_) - n.weight;
      put(i);
      lists_[row_number(element.begin + size++)] = i;
    }
    element.size = size;
    lists_.resize(row_number(element.begin + size));
  }

  std::vector<Node> nodes_;
  int left_ = 0;            // number of rows that have not been eliminated
  int least_;               // of the degrees
  std::vector<int> bucket_; // of each degree, the first link
  std::vector<Link> links_;
  std::vector<int> lists_;
  std::array<int, hashes>
      same_; // the first row of the current element by the hash of its neighbours
  std::int64_t stamp_ = 2;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OPERATORS_SOLVERS_ELIMINATION_MINIMUM_DEGREE_H
