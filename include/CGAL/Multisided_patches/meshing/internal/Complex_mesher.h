// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_COMPLEX_MESHER_H
#define CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_COMPLEX_MESHER_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/for_each_index.h>
#include <CGAL/Multisided_patches/internal/run_both.h>
#include <CGAL/Multisided_patches/internal/vector_utils.h>
#include <CGAL/Multisided_patches/meshing/Mesh_density.h>
#include <CGAL/Multisided_patches/meshing/Patch_complex.h>
#include <CGAL/Multisided_patches/meshing/internal/Mesh_connectivity.h>
#include <CGAL/Multisided_patches/meshing/internal/Patch_mesh.h>
#include <CGAL/Multisided_patches/meshing/internal/Surface_mesher.h>
#include <CGAL/Multisided_patches/meshing/internal/split_chords.h>
#include <CGAL/Multisided_patches/meshing/mesh_domain.h>

#include <boost/pending/disjoint_sets.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// Hands what several threads report to one visitor, one at a time. If the visitor has tasks of its
// own, its thread runs none of ours while it waits for these: they might report, too.
template <typename Visitor>
class Shared_visitor {
public:
  explicit Shared_visitor(Visitor& visitor) : visitor_(visitor) {}
  bool go_further(Tessellation_stage stage, std::size_t done, std::size_t total) {
    const std::lock_guard<std::mutex> lock(mutex_);
    // Once it does not want to go on, or throws, it is not asked again.
    if (is_cancelled_)
      return false;
    is_cancelled_ = true;
    isolate([&] { is_cancelled_ = !visitor_.go_further(stage, done, total); });
    return !is_cancelled_;
  }

private:
  template <typename Function>
  static void isolate(const Function& f) {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::this_task_arena::isolate(f);
#else
    f();
#endif
  }

  Visitor& visitor_;
  std::mutex mutex_;
  bool is_cancelled_ = false;
};

// Puts a name before the message of what f throws.
template <typename Function>
auto with_name(const std::string& name, const Function& f) {
  try {
    return f();
  } catch (const Accuracy_error& error) {
    throw Accuracy_error(name + ": " + error.what(), error.reached());
  } catch (const Numerical_error& error) {
    throw Numerical_error(name + ": " + error.what());
  } catch (const Input_error& error) {
    throw Input_error(name + ": " + error.what());
  }
}

// Meshes the patches of a complex, each on its own, but with common samples on the sides that they
// share, and puts them together.
template <typename Patch, typename ConcurrencyTag, typename Visitor>
class Complex_mesher {
public:
  using Traits = typename Patch::Geom_traits;
  using Complex = Patch_complex<Patch>;

  Complex_mesher(const Complex& complex, Visitor& visitor)
      : complex_(complex), visitor_(visitor), meshers_(size()), domain_meshes_(size()),
        meshes_(size()) {
    for_each_patch([&](std::size_t k) {
      meshers_[k] = std::make_unique<Mesher>(complex_.patches()[k], visitor_);
    });
  }

  void run(const Mesh_density& density) {
    if (size() == 0)
      return make_connectivity();
    if (density.max_chordal_deviation() || density.max_normal_deviation())
      mesh_with_share_of_turn(
          density, [&](double share) { return sample_all(density, share); },
          [&](const std::vector<Side_parameters>& sides, Sides finality) {
            mesh_domains(sides, finality, density);
          });
    else
      mesh_domains_with_edge_length(density);
    meshers_.clear();
    group_vertices();
    split_chords(domain_meshes_, groups_);
    const std::optional<std::size_t> torn = find_torn_patch(domain_meshes_, groups_);
    if (torn)
      throw Input_error(complex_.names()[*torn] +
                        ": the triangles are too large for the sides that this patch shares with "
                        "others, or with itself; ask for shorter edges");
    run_both<ConcurrencyTag>([&] { evaluate(); }, [&] { make_connectivity(); });
    average_normals();
  }

  std::size_t number_of_vertices() const {
    std::size_t count = 0;
    for (const auto& mesh : domain_meshes_)
      count += mesh.points.size();
    return count;
  }

  const std::vector<Patch_mesh<Patch>>& meshes() const { return meshes_; }

  // pre: run() has ended
  const Mesh_connectivity& connectivity() const { return *connectivity_; }

private:
  using Mesher = Surface_mesher<Patch, ConcurrencyTag, Shared_visitor<Visitor>>;

  std::size_t size() const { return complex_.patches().size(); }

  // Calls f(k) for every patch, in parallel. Of several errors that of the first patch is thrown,
  // whichever happens first.
  template <typename Function>
  void for_each_patch(const Function& f) const {
    std::vector<std::exception_ptr> errors(size());
    for_each_index<ConcurrencyTag>(
        size(),
        [&](std::size_t k) {
          try {
            with_name(complex_.names()[k], [&] { f(k); });
          } catch (...) {
            errors[k] = std::current_exception();
          }
        },
        1);
    for (const std::exception_ptr& error : errors)
      if (error)
        std::rethrow_exception(error);
  }

  void mesh_domains(const std::vector<Side_parameters>& sides, Sides finality,
                    const Mesh_density& density) {
    std::vector<char> are_coarse(size(), false); // which is no error, unlike what others may have
    for_each_patch([&](std::size_t k) {
      try {
        domain_meshes_[k] = meshers_[k]->with_deviations(sides[k], finality, density);
      } catch (const Coarse_sides_error&) {
        are_coarse[k] = true;
      }
    });
    if (std::find(are_coarse.begin(), are_coarse.end(), true) != are_coarse.end())
      throw Coarse_sides_error();
  }

  void mesh_domains_with_edge_length(const Mesh_density& density) {
    if (density.target_triangles()) {
      double area = 0, boundary_length = 0; // sides that patches share have edges of both
      for (const auto& mesher : meshers_) {
        area += mesher->area();
        boundary_length += mesher->boundary_length();
      }
      find_edge_length(*density.target_triangles(), area, boundary_length, size(),
                       [&](double length) { return start(length); });
    } else {
      start(*density.target_edge_length());
    }
    const auto keep = density.target_triangles() ? Keep::number_of_triangles : Keep::edge_length;
    for_each_patch([&](std::size_t k) { domain_meshes_[k] = meshers_[k]->finish(keep); });
  }

  // Returns about how many triangles there will be.
  std::size_t start(double edge_length) {
    const std::vector<Side_parameters> sides =
        sample_all(Mesh_density::edge_length(edge_length), 1);
    std::vector<std::size_t> counts(size());
    for_each_patch([&](std::size_t k) { counts[k] = meshers_[k]->start(sides[k], edge_length); });
    return std::accumulate(counts.begin(), counts.end(), std::size_t(0));
  }

  void evaluate() {
    for_each_patch([&](std::size_t k) {
      meshes_[k] =
          evaluate_vertices<ConcurrencyTag>(complex_.patches()[k], domain_meshes_[k], visitor_);
      fill_missing_normals(meshes_[k]);
    });
  }

  // A shared side has the samples of the first patch.
  std::vector<Side_parameters> sample_all(const Mesh_density& density, double share_of_turn) const {
    std::vector<Side_parameters> sides(size());
    for_each_patch([&](std::size_t k) {
      sides[k] = sample_sides(complex_.patches()[k], density, share_of_turn);
    });
    for (const Shared_side& s : complex_.shared_sides()) {
      const std::vector<double>& from = sides[s.patch_a][s.side_a];
      std::vector<double>& to = sides[s.patch_b][s.side_b];
      to.clear();
      for (auto it = from.rbegin(); it != from.rend(); ++it)
        to.push_back(1 - *it);
    }
    return sides;
  }

  // Finds out which vertices on the boundaries of the patches are the same: groups_[k][v] is the
  // number of the common vertex for vertex v of patch k.
  void group_vertices() {
    std::vector<std::size_t> first(size() + 1, 0); // of the boundary vertices of each patch
    for (std::size_t k = 0; k < size(); ++k)
      first[k + 1] = first[k] + domain_meshes_[k].number_of_boundary_points;
    std::vector<std::size_t> rank(first.back()), parent(first.back());
    boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
    for (std::size_t v = 0; v < first.back(); ++v)
      sets.make_set(v);
    for (const Shared_side& s : complex_.shared_sides()) {
      const auto a = side_vertices(s.patch_a, s.side_a), b = side_vertices(s.patch_b, s.side_b);
      for (std::size_t j = 0; j < a.size(); ++j)
        sets.union_set(first[s.patch_a] + a[j], first[s.patch_b] + b[a.size() - 1 - j]);
    }
    groups_.assign(size(), {});
    number_of_groups_ = first.back();
    for (std::size_t k = 0; k < size(); ++k)
      for (std::size_t v = first[k]; v < first[k + 1]; ++v)
        groups_[k].push_back(sets.find_set(v));
  }

  // From one end to the other.
  std::vector<std::size_t> side_vertices(std::size_t patch, std::size_t side) const {
    const auto& mesh = domain_meshes_[patch];
    const std::size_t end = complex_.patches()[patch].domain().next(side);
    std::vector<std::size_t> vertices;
    std::size_t last = 0;
    for (std::size_t v = 0; v < mesh.number_of_boundary_points; ++v) {
      if (mesh.locations[v].index == side)
        vertices.push_back(v);
      if (mesh.locations[v].index == end && last == 0)
        last = v + 1;
    }
    vertices.push_back(last - 1);
    return vertices;
  }

  // For each patch the numbers of its vertices, of which those that patches have in common are the
  // same. A patch has numbers of the patches before it or the next ones.
  std::vector<std::vector<std::size_t>> vertex_numbers() const {
    constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
    std::vector<std::size_t> numbers_of_groups(number_of_groups_, none);
    std::vector<std::vector<std::size_t>> numbers(size());
    std::size_t next = 0;
    for (std::size_t k = 0; k < size(); ++k) {
      for (const std::size_t group : groups_[k]) {
        std::size_t& number = numbers_of_groups[group];
        if (number == none)
          number = next++;
        numbers[k].push_back(number);
      }
      while (numbers[k].size() < domain_meshes_[k].points.size())
        numbers[k].push_back(next++);
    }
    return numbers;
  }

  void make_connectivity() {
    std::vector<const Domain_mesh_2<Traits>*> meshes;
    for (const auto& mesh : domain_meshes_)
      meshes.push_back(&mesh);
    connectivity_.emplace(meshes, vertex_numbers(), ConcurrencyTag());
  }

  // A common vertex has the mean of the normals.
  void average_normals() {
    using FT = typename Traits::FT;
    std::vector<Vec3> sums(number_of_groups_, Vec3{0, 0, 0});
    for_each_common_vertex([&](auto& vertex, std::size_t group) {
      sums[group] = sum(sums[group], to_vec3(vertex.normal));
    });
    for_each_common_vertex([&](auto& vertex, std::size_t group) {
      const Vec3 n = normalized(sums[group]);
      vertex.normal = typename Traits::Vector_3(FT(n[0]), FT(n[1]), FT(n[2]));
    });
  }

  template <typename Function>
  void for_each_common_vertex(const Function& f) {
    for (std::size_t k = 0; k < size(); ++k)
      for (std::size_t v = 0; v < groups_[k].size(); ++v)
        f(meshes_[k].vertices[v], groups_[k][v]);
  }

  const Complex& complex_;
  Shared_visitor<Visitor> visitor_;
  std::vector<std::unique_ptr<Mesher>> meshers_;
  std::vector<Domain_mesh_2<Traits>> domain_meshes_;
  std::vector<Patch_mesh<Patch>> meshes_;
  std::vector<std::vector<std::size_t>> groups_;
  std::size_t number_of_groups_ = 0;
  std::optional<Mesh_connectivity> connectivity_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MESHING_INTERNAL_COMPLEX_MESHER_H
