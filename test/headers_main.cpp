// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Linked with one generated file for each header: that they compile and link is the test.

int main() {
  return 0;
}
