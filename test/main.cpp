// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The main function of the tests, for version 2 of Catch2; version 3 has it in a library.

#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
