// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_DART_MATCHING_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_DART_MATCHING_H

#include <CGAL/Intrinsic_simplification/isometry/tessellation/Dart_complex.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Joined_numbers;

// A dart, read in the orientation of the surface or against it.
struct Directed_dart {
  std::uint32_t dart = 0;
  bool is_mirrored = false;
};

/*
Finds which components of two complexes with labels are the same, and their
symmetries.

Darts of the second complex are numbered after those of the first one. If there
is only one complex, it is matched with itself.
*/
class Dart_matching {
public:
  using Labels = std::vector<std::uint32_t>;

  // Components that are the same. An isomorphism of components is given by the
  // image of one dart.
  struct Group {
    std::uint32_t first_dart; // of the component that represents the group
    std::vector<Directed_dart> firsts,
        seconds;                           // its image in each component of either complex
    std::vector<Directed_dart> symmetries; // its images in its own component
  };

  // \param second null to match the first complex with itself
  Dart_matching(const Dart_complex& first, const Labels& first_labels, const Dart_complex* second,
                const Labels* second_labels);

  const std::vector<Group>& groups() const { return groups_; }
  // whether there is an isomorphism
  bool are_isomorphic() const;
  // whether the search was given up, since too many walks fail late
  bool is_given_up() const { return steps_ > most_steps; }
  std::size_t number_of_walks() const { return number_of_walks_; }

  std::size_t number_of_darts() const { return next_.size(); }

  // Maps the component of a dart so that the dart goes to another one; where
  // `image` is set, to other values than `none`, it must be this map. \return
  // whether that is an isomorphism
  bool walk(std::uint32_t from, Directed_dart to, std::vector<std::uint32_t>& image,
            std::vector<std::uint32_t>& visited) const;

private:
  void append(const Dart_complex& c, const Labels& labels);
  void refine();
  void sort_states();
  void group_component(std::uint32_t component);
  bool joins(Group& group, std::uint32_t component);
  void find_symmetries(Group& group, Joined_numbers& orbits, std::vector<char>& fails);
  std::uint32_t rarest_dart(std::uint32_t component) const;
  // states of a class in a component: twice the dart, and one if mirrored
  std::pair<std::size_t, std::size_t> candidates(std::uint32_t component,
                                                 std::uint32_t its_class) const;
  bool try_walk(std::uint32_t from, Directed_dart to);
  void forget_walk();

  static constexpr std::size_t most_steps = std::size_t(1) << 31;

  std::uint32_t number_of_first_components_ = 0, number_of_components_ = 0;
  std::vector<std::uint32_t> next_, previous_, opposite_, component_, sides_, degree_, label_;
  std::vector<std::uint32_t> class_;     // of each state
  std::vector<std::uint32_t> states_;    // by component and class
  std::vector<std::size_t> first_state_; // of each component, and the end
  std::vector<Group> groups_;
  std::vector<std::uint32_t> image_, visited_; // of the last walk
  std::size_t number_of_walks_ = 0;
  mutable std::size_t steps_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_DART_MATCHING_H
