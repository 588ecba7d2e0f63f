// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_BENCHMARK_KERNELS_H
#define MULTISIDED_PATCHES_BENCHMARK_KERNELS_H

#include "meshing_fixtures.h"

#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <memory>

// The kernels that nearly all time goes to, each with a fixed amount of work: the benchmark
// takes their time, and `count_kernels.cpp` lets callgrind count their instructions.
namespace bench {

class Kernel_run {
public:
  virtual ~Kernel_run() = default;
  virtual void run() = 0; // the same work every time, on one thread
  //! how many points or triangles that is
  virtual std::size_t items() const = 0;
};

// Harmonic coordinates with gradients at points inside a U with 8 sides.
class Harmonic_batch_kernel : public Kernel_run {
public:
  void run() override {
    benchmark::DoNotOptimize(
        coordinates_.evaluate_batch<1, CGAL::Sequential_tag>(points_, locations_));
  }
  std::size_t items() const override { return points_.size(); }

private:
  const Domain domain_ = Domain(fixtures::unit_u_shape());
  const MP::Harmonic_coordinates_2<Kernel> coordinates_ =
      MP::Harmonic_coordinates_2<Kernel>(domain_);
  const Points points_ = fixtures::random_points_inside(domain_, 10000);
  const std::vector<Domain::Location> locations_ =
      std::vector<Domain::Location>(points_.size(), Domain::Location::interior());
};

// From coordinates with gradients to points of the surface with first derivatives, for a model with
// 8 sides of degree 3 with 2 layers.
class Basis_combination_kernel : public Kernel_run {
public:
  Basis_combination_kernel() {
    const std::size_t n = patch_.domain().size();
    lambda_.resize(n * items());
    const Points points = fixtures::random_points_inside(patch_.domain(), items());
    for (std::size_t j = 0; j < items(); ++j)
      patch_.coordinates().evaluate<1>(points[j], Domain::Location::interior(), &lambda_[n * j]);
  }
  void run() override {
    for (std::size_t j = 0; j < lambda_.size(); j += patch_.domain().size())
      benchmark::DoNotOptimize(patch_.combine(&lambda_[j]));
  }
  std::size_t items() const override { return 10000; }

private:
  const MP::Concave_bezier_patch_3<Kernel> patch_ =
      MP::Concave_bezier_patch_3<Kernel>(read_model("u_vent"));
  std::vector<MP::Jet_2<double, 1>> lambda_;
};

// Both together as meshes need them: points with normals, at once.
class Patch_batch_kernel : public Kernel_run {
public:
  void run() override {
    patch_.points_and_normals<CGAL::Sequential_tag>(points_, locations_, results_.begin());
    benchmark::DoNotOptimize(results_.data());
  }
  std::size_t items() const override { return points_.size(); }

private:
  const MP::Concave_bezier_patch_3<Kernel> patch_ =
      MP::Concave_bezier_patch_3<Kernel>(read_model("u_vent"));
  const Points points_ = fixtures::random_points_inside(patch_.domain(), 10000);
  const std::vector<Domain::Location> locations_ =
      std::vector<Domain::Location>(points_.size(), Domain::Location::interior());
  std::vector<std::pair<Point_3, Kernel::Vector_3>> results_ =
      std::vector<std::pair<Point_3, Kernel::Vector_3>>(points_.size());
};

// An even mesh of a U.
class Domain_meshing_kernel : public Kernel_run {
public:
  void run() override {
    benchmark::DoNotOptimize(MP::triangulate_domain(domain_, spacing_.segments, spacing_.length));
  }
  std::size_t items() const override {
    return MP::triangulate_domain(domain_, spacing_.segments, spacing_.length).triangles.size();
  }

private:
  const Domain domain_ = Domain(fixtures::unit_u_shape());
  const Even_spacing spacing_ = Even_spacing(domain_, 20000);
};

constexpr const char* kernel_names[] = {"harmonic_batch", "basis_combination", "patch_batch",
                                        "domain_meshing"};

inline std::unique_ptr<Kernel_run> make_kernel(std::size_t index) {
  if (index == 0)
    return std::make_unique<Harmonic_batch_kernel>();
  if (index == 1)
    return std::make_unique<Basis_combination_kernel>();
  if (index == 2)
    return std::make_unique<Patch_batch_kernel>();
  return std::make_unique<Domain_meshing_kernel>();
}

} // namespace bench

#endif // MULTISIDED_PATCHES_BENCHMARK_KERNELS_H
