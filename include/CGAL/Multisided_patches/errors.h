// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_ERRORS_H
#define CGAL_MULTISIDED_PATCHES_ERRORS_H

#include <stdexcept>

namespace CGAL {
namespace Multisided_patches {

/*!
 * The base of all exceptions that the package throws. The message says where the trouble is (file
 * and line, side, control point) and what was expected.
 */
class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

//! Data that cannot be used: a malformed file, a loop that does not close, a domain that crosses
//! itself, a coordinate that is not a number.
class Input_error : public Error {
public:
  using Error::Error;
};

//! A query point outside the domain on which a function is defined.
class Outside_domain_error : public Input_error {
public:
  using Input_error::Input_error;
};

//! A computation on valid data that could not reach its goal, such as a requested accuracy.
class Numerical_error : public Error {
public:
  using Error::Error;
};

//! An accuracy that was asked for and could not be reached.
class Accuracy_error : public Numerical_error {
public:
  Accuracy_error(const std::string& message, double reached)
      : Numerical_error(message), reached_(reached) {}

  //! the error that was reached, in the unit of the one that was asked for; of a mesh, the factor
  //! by which edges were too long; infinity, if there was no result
  double reached() const { return reached_; }

private:
  double reached_;
};

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_ERRORS_H
