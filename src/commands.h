// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_COMMANDS_H
#define MULTIPATCH_COMMANDS_H

#include <CGAL/Multisided_patches/IO/Coordinates_choice.h>
#include <CGAL/Multisided_patches/bases/Central_weight.h>
#include <CGAL/Multisided_patches/domains/make_domain.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/meshing/Domain_mesh_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh/Surface_mesh.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace multipatch {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Multisided_patches::Polygonal_domain_2<Kernel>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Domain_mesh = CGAL::Multisided_patches::Domain_mesh_2<Kernel>;

using CGAL::Multisided_patches::IO::Coordinates_choice;

// What a user may say about a patch beyond what its file says.
struct Patch_options {
  std::string input;
  std::optional<CGAL::Multisided_patches::Domain_generator> domain;
  std::optional<double> clearance;
  std::optional<CGAL::Multisided_patches::Central_weight> central_weight;
  std::optional<Coordinates_choice> coordinates;
  bool elevate = false; // degrees, as far as the layers of the ribbons need it
};

// How to mesh many files, each on its own.
struct Batch_options {
  std::string directory; // for the meshes; empty if all inputs become one mesh
  std::string format = "ply";
  std::string list;                   // a file with the names of more inputs, "-" is standard input
  std::optional<std::size_t> threads; // if not given, as many as there are processors
  bool keep_going = false;            // after a file that fails
  bool resume = false;                // pass over files whose meshes are up to date
  bool mpi = false;                   // share the work among the ranks of mpirun
  double rank_timeout = 60;           // seconds without a sign of life until a rank counts as lost
};

struct Mesh_options {
  Patch_options patch; // without its input
  std::vector<std::string> inputs;
  std::string output; // empty if there is a directory
  Batch_options batch;
  std::optional<double> edge_length, chordal_deviation; // model units
  std::optional<double> normal_deviation;               // degrees
  std::optional<std::size_t> triangles;
  std::string report;
  bool quiet = false;
};

struct Domain_picture_options {
  Patch_options patch;
  std::string output;
  std::size_t side = 0;
  std::size_t coordinate = 0;
};

struct Coordinates_options {
  Patch_options patch; // its input may be a polygon file, too
  std::string output;
  std::string at; // a file of points
  std::optional<std::size_t> samples;
  std::optional<int> derivatives;
  std::optional<std::size_t> vertex;
  std::optional<double> target_error, acceptable_error;
  bool quiet = false;
};

struct Check_options {
  Patch_options patch;             // without its input
  std::vector<std::string> inputs; // patches, or meshes
  std::size_t samples = 32;
  double position_tolerance = 1e-6; // relative to the diagonal of the bounding box
  double plane_tolerance = 1e-3;    // degrees
  double curvature_tolerance = 1e-3;
  std::optional<std::size_t> mesh_triangles;
  std::string json; // "-" is standard output
  bool quiet = false;
};

struct Exact_options {
  Patch_options patch;
  std::size_t samples = 20;
  std::string json; // "-" is standard output
  bool quiet = false;
};

struct Convert_options {
  std::string input, output;
  bool lossy = false; // leave out what the format of the output cannot hold
  bool quiet = false;
};

struct Elevate_options {
  std::string input, output;
  std::optional<std::size_t> degree, layers;
  bool quiet = false;
};

struct Merge_options {
  std::string input_a, input_b, output;
  bool quiet = false;
};

// Thrown if the command line alone is wrong, whatever the files contain.
class Usage_error : public CGAL::Multisided_patches::Input_error {
public:
  using Input_error::Input_error;
};

// Thrown after a signal has ended the work in good order.
struct Interrupted {
  int signal;
};

// Says on standard error what is worth knowing, although the command goes on.
void warn(const std::string& text);

// Throws Usage_error if a file would overwrite one of the others.
void check_different(const std::string& output, const std::vector<std::string>& others);

double degrees(double radians);

// Throws if an index that was given with an option is not one of n sides.
void check_index(std::size_t index, std::size_t n, const std::string& option);

// The generator that made a domain, or "given" if none did.
const char* domain_name(const CGAL::Multisided_patches::Domain_report& report);

// "clearance 0.05"; a domain without two sides that share no corner, such as a triangle, has no
// limit.
std::string clearance_text(const CGAL::Multisided_patches::Domain_report& report);

// The remarks of a report, a sentence each.
std::vector<std::string> remarks(const CGAL::Multisided_patches::Domain_report& report);

// Warns of them; the prefix begins each.
void warn_of_remarks(const CGAL::Multisided_patches::Domain_report& report,
                     const std::string& prefix = "");

// The commands. They throw CGAL::Multisided_patches::Error on bad input, and Usage_error if it is
// the command line.
void mesh_command(const Mesh_options& options);
// The command mesh with a directory to write to. Throws an error, too, if a file failed, and
// Interrupted if a signal has come.
void batch_command(const Mesh_options& options);
void info_command(const std::string& input);
void domain_command(const Domain_picture_options& options);
void coordinates_command(const Coordinates_options& options);
// Throws an error, too, if a tolerance is exceeded or a mesh has defects.
void check_command(const Check_options& options);
// The same for files of meshes, each on its own; there are no tolerances.
void check_meshes_command(const Check_options& options);
void exact_command(const Exact_options& options);
// Nothing is written if they fail.
void convert_command(const Convert_options& options);
void elevate_command(const Elevate_options& options);
void merge_command(const Merge_options& options);

} // namespace multipatch

#endif // MULTIPATCH_COMMANDS_H
