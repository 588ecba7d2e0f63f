// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_CURVE_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_CURVE_FIXTURES_H

#include "Rational_random.h"

#include <CGAL/Multisided_patches/errors.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

// What the tests of curves share: they compare in exact arithmetic, or in double bit for bit.
namespace curve_fixtures {

namespace MP = CGAL::Multisided_patches;
using Rational = CGAL::Gmpq;
using Kernel = CGAL::Simple_cartesian<Rational>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Double_kernel = CGAL::Simple_cartesian<double>;
using Double_point = Double_kernel::Point_3;
using Random = fixtures::Rational_random<Kernel>;

} // namespace curve_fixtures

#endif // MULTISIDED_PATCHES_TEST_CURVE_FIXTURES_H
