// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "add_commands.h"

#include "batch_arguments.h"
#include "mesh_file.h"
#include "option_checks.h"

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/IO/polygon_file.h>
#include <CGAL/Multisided_patches/IO/surface_mesh.h>
#include <CGAL/Multisided_patches/meshing/Mesh_density.h>

#include <cstddef>
#include <map>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

constexpr const char* patch_help = "the patch, a .cgb, .gbp or .patch.json file";
constexpr const char* patches_help = "the patches, .cgb, .gbp or .patch.json files";

// A command, whose help ends with an example.
CLI::App& add_command(CLI::App& app, const std::string& name, const std::string& description,
                      const std::string& example) {
  CLI::App& command = *app.add_subcommand(name, description);
  command.footer("Example:  multipatch " + name + ' ' + example);
  return command;
}

void add_domain_options(CLI::App& command, Patch_options& options) {
  static const std::map<std::string, MP::Domain_generator> domains{
      {"automatic", MP::Domain_generator::automatic},
      {"projected", MP::Domain_generator::projected},
      {"similarity", MP::Domain_generator::similarity},
      {"similarity-outer", MP::Domain_generator::similarity_outer},
      {"circular", MP::Domain_generator::circular},
      {"regular", MP::Domain_generator::regular}};
  static const std::map<std::string, Coordinates_choice> coordinates{
      {"harmonic", Coordinates_choice::harmonic},
      {"mean-value", Coordinates_choice::mean_value},
      {"wachspress", Coordinates_choice::wachspress}};
  command
      .add_option("--domain", options.domain,
                  "how to make the planar domain (default: as the file says):\n"
                  "automatic, projected, similarity, similarity-outer, circular, regular")
      ->transform(CLI::Transformer(domains).description(""))
      ->transform(CLI::IsMember(domains).description(""))
      ->type_name("NAME");
  command
      .add_option("--clearance", options.clearance,
                  "wanted distance between sides that share no corner, as a fraction of\n"
                  "the domain's size (default: as the file says)")
      ->check(number_between(0, 1))
      ->type_name("X");
  command
      .add_option("--coordinates", options.coordinates,
                  "barycentric coordinates: harmonic (any domain, default but for .gbp files),\n"
                  "mean-value (any domain), wachspress (convex domains, default for .gbp\n"
                  "files)")
      ->transform(CLI::Transformer(coordinates).description(""))
      ->transform(CLI::IsMember(coordinates).description(""))
      ->type_name("NAME");
}

void add_patch_options(CLI::App& command, Patch_options& options) {
  static const std::map<std::string, MP::Central_weight> central_weights{
      {"weight-deficiency", MP::Central_weight::weight_deficiency},
      {"none", MP::Central_weight::none},
      {"adjacent-products", MP::Central_weight::adjacent_products},
      {"full-product", MP::Central_weight::full_product},
      {"automatic", MP::Central_weight::automatic}};

  add_domain_options(command, options);
  command
      .add_option("--central-weight", options.central_weight,
                  "weight of the central control point of a concave generalized Bezier patch\n"
                  "(default: as the file says):\n"
                  "weight-deficiency, none, adjacent-products, full-product, or automatic for\n"
                  "what suits the domain")
      ->transform(CLI::Transformer(central_weights).description(""))
      ->transform(CLI::IsMember(central_weights).description(""))
      ->type_name("NAME");
}

void add_input(CLI::App& command, Patch_options& options) {
  command.add_option("INPUT", options.input, patch_help)->required()->check(patch_name());
}

void add_density_options(CLI::App& command, Mesh_options& options) {
  auto* triangles =
      command
          .add_option("--triangles", options.triangles,
                      "target number of triangles, of all patches together (default: 10000)")
          ->check(whole_number(1, MP::Mesh_density::max_triangles))
          ->type_name("N");
  command
      .add_option("--edge-length", options.edge_length,
                  "target length of the edges, in the units of the model")
      ->check(positive_number())
      ->type_name("X")
      ->excludes(triangles);
  command
      .add_option("--chordal-deviation", options.chordal_deviation,
                  "largest distance of the surface from its triangles, in the units of the\n"
                  "model")
      ->check(positive_number())
      ->type_name("X")
      ->excludes(triangles);
  command
      .add_option("--normal-deviation", options.normal_deviation,
                  "largest angle between the normals of the surface and those of its\n"
                  "triangles, in degrees, at most 90; like the two before, it can be\n"
                  "combined with the others")
      ->check(positive_number_up_to(90))
      ->type_name("X")
      ->excludes(triangles);
}

void add_mesh_command(CLI::App& app, Mesh_options& options) {
  CLI::App& command =
      add_command(app, "mesh",
                  "make a triangle mesh of a patch, or one of several patches, without gaps\n"
                  "along the sides that they share; or many files at once, a mesh of each",
                  "bracket.cgb -o bracket.ply --triangles 20000\n"
                  "          multipatch mesh models/ --output-directory meshes --resume");
  command.add_option("INPUT", options.inputs, patches_help);
  add_patch_options(command, options.patch);
  auto* output = command
                     .add_option("-o,--output", options.output,
                                 "the mesh to write; the name ends in .ply, .obj, .off or .stl")
                     ->check(accepted_by(MP::IO::mesh_format))
                     ->type_name("FILE");
  add_batch_options(command, options.batch, *output);
  add_density_options(command, options);
  command.add_flag("--elevate", options.patch.elevate,
                   "raise the degrees of ribbons, whose shape stays the same, where that lets\n"
                   "the surface meet their neighbours as smoothly as these have layers for");
  command
      .add_option("--report", options.report,
                  "write counts, the quality of the mesh, which sides are shared, the\n"
                  "domains and how they came about, and timings to a JSON file")
      ->type_name("FILE");
  command.add_flag("-q,--quiet", options.quiet, "print nothing but errors");
  command.callback([&options] {
    require_mesh_arguments(options);
    mesh_command(options);
  });
}

void add_info_command(CLI::App& app, std::string& input) {
  CLI::App& command = add_command(
      app, "info", "print the sides and corners of a patch, and its domain", "bracket.cgb");
  command.add_option("INPUT", input, patch_help)->required()->check(patch_name());
  command.callback([&input] { info_command(input); });
}

void add_domain_command(CLI::App& app, Domain_picture_options& options) {
  CLI::App& command = add_command(
      app, "domain",
      "draw the domain of a patch, with isolines of its side parameters and coordinates",
      "bracket.cgb -o domain.svg --side 2 --coordinate 1");
  add_input(command, options.patch);
  add_patch_options(command, options.patch);
  command.add_option("-o,--output", options.output, "the picture to write, an .svg file")
      ->required()
      ->check(name_ending_in({".svg"}))
      ->type_name("FILE");
  const auto index_range = whole_number(0, MP::IO::CGB_limits::max_sides - 1);
  command.add_option("--side", options.side, "the side whose s and h are drawn (default: 0)")
      ->check(index_range)
      ->type_name("I");
  command
      .add_option("--coordinate", options.coordinate,
                  "the vertex whose coordinate is drawn (default: 0)")
      ->check(index_range)
      ->type_name("I");
  command.callback([&options] { domain_command(options); });
}

void add_coordinates_command(CLI::App& app, Coordinates_options& options) {
  constexpr std::size_t max_samples = 1'000'000;
  CLI::App& command = add_command(app, "coordinates",
                                  "draw or tabulate barycentric coordinates on the domain of "
                                  "a patch,\nor on any polygon",
                                  "polygon.txt -o coordinates.csv --derivatives 1");
  command
      .add_option("INPUT", options.patch.input,
                  "a patch, a .cgb, .gbp or .patch.json file; or a polygon: two\n"
                  "numbers a line, blank lines between the outer loop and the holes")
      ->required();
  add_domain_options(command, options.patch);
  command
      .add_option("-o,--output", options.output,
                  "the picture or the table to write; the name ends in .svg or .csv")
      ->required()
      ->check(name_ending_in({".svg", ".csv"}))
      ->type_name("FILE");
  command
      .add_option("--target-error", options.target_error,
                  "wanted error of harmonic coordinates (default: 1e-8)")
      ->check(positive_number_below(1))
      ->type_name("X");
  command
      .add_option("--acceptable-error", options.acceptable_error,
                  "the error that will do where the wanted one is out of reach (default:\n"
                  "none but the wanted one)")
      ->check(positive_number_below(1))
      ->type_name("X");
  command
      .add_option("--vertex", options.vertex,
                  "draw the coordinate of this vertex only (default: the first 12)")
      ->check(whole_number(0, MP::IO::Polygon_file_limits::max_vertices - 1))
      ->type_name("I");
  auto* samples =
      command
          .add_option("--samples", options.samples,
                      "about how many points the table has, the vertices and points on the\n"
                      "sides among them (default: 1000)")
          ->check(whole_number(1, max_samples))
          ->type_name("N");
  command
      .add_option("--at", options.at,
                  "tabulate at the points of this file, two numbers a line; those outside\n"
                  "the domain have nan for coordinates")
      ->type_name("FILE")
      ->excludes(samples);
  command
      .add_option("--derivatives", options.derivatives,
                  "tabulate derivatives up to this order, too: 0 (default), 1 or 2")
      ->check(whole_number(0, 2))
      ->type_name("N");
  command.add_flag("-q,--quiet", options.quiet, "print nothing but errors");
  command.callback([&options] { coordinates_command(options); });
}

// What Report_output goes by.
void add_report_options(CLI::App& command, std::string& json, bool& quiet) {
  command
      .add_option("--json", json,
                  "write the report to a JSON file, or with - instead of the table to\n"
                  "standard output")
      ->type_name("FILE");
  command.add_flag("-q,--quiet", quiet, "print nothing but errors");
}

void add_check_command(CLI::App& app, Check_options& options) {
  constexpr std::size_t max_samples = 100'000;
  CLI::App& command = add_command(
      app, "check",
      "measure how smoothly patches meet their ribbons, and each other where they\nhave "
      "sides in common, and mesh them; or look at meshes. Fails if tolerances are\nexceeded, "
      "or a mesh intersects itself or has degenerate or folded triangles",
      "left.cgb right.cgb --plane-tolerance 0.01 --json report.json\n"
      "          multipatch check bracket.ply");
  command
      .add_option("INPUT", options.inputs,
                  "the patches, .cgb, .gbp or .patch.json files; or meshes, .ply, .obj,\n"
                  ".off or .stl files, for which only --json and --quiet are options")
      ->required()
      ->check(checkable_name());
  add_patch_options(command, options.patch);
  command.add_flag("--elevate", options.patch.elevate, "raise degrees, as the command mesh does");
  command
      .add_option("--samples", options.samples,
                  "evenly spaced samples a side (default: 32); 12 more are close to its ends")
      ->check(whole_number(1, max_samples))
      ->type_name("N");
  command
      .add_option("--position-tolerance", options.position_tolerance,
                  "of distances, relative to the diagonal of the patch's bounding box\n"
                  "(default: 1e-6)")
      ->check(number_of_at_least(0))
      ->type_name("X");
  command
      .add_option("--plane-tolerance", options.plane_tolerance,
                  "of angles between tangent planes, in degrees (default: 1e-3)")
      ->check(number_of_at_least(0))
      ->type_name("X");
  command
      .add_option("--curvature-tolerance", options.curvature_tolerance,
                  "of relative differences of curvatures (default: 1e-3)")
      ->check(number_of_at_least(0))
      ->type_name("X");
  command
      .add_option("--mesh-triangles", options.mesh_triangles,
                  "target number of triangles of the mesh that is checked, of all patches\n"
                  "together (default: 2000 a patch)")
      ->check(whole_number(1, MP::Mesh_density::max_triangles))
      ->type_name("N");
  add_report_options(command, options.json, options.quiet);
  command.callback([&command, &options] {
    if (!are_mesh_files(options.inputs))
      return check_command(options);
    refuse_other_options(command, {"INPUT", "--json", "--quiet"}, "is for patches, not for meshes");
    check_meshes_command(options);
  });
}

void add_exact_command(CLI::App& app, Exact_options& options) {
  constexpr std::size_t max_samples = 100'000;
  CLI::App& command =
      add_command(app, "exact",
                  "measure the rounding errors of a patch in double precision: with Wachspress\n"
                  "coordinates against exact numbers where the domain is convex, elsewhere with\n"
                  "mean value coordinates against numbers of 100 digits",
                  "bracket.cgb --samples 100");
  add_input(command, options.patch);
  command
      .add_option("--samples", options.samples,
                  "random points inside the domain (default: 20); about 19 more for each side\n"
                  "lie on and close to it")
      ->check(whole_number(1, max_samples))
      ->type_name("N");
  add_report_options(command, options.json, options.quiet);
  command.callback([&options] { exact_command(options); });
}

void add_output(CLI::App& command, std::string& output) {
  command
      .add_option("-o,--output", output,
                  "the file to write; the name ends in .cgb, .gbp or .patch.json")
      ->required()
      ->check(patch_name())
      ->type_name("FILE");
}

void add_convert_command(CLI::App& app, Convert_options& options) {
  CLI::App& command =
      add_command(app, "convert",
                  "write a patch in another format; a .patch.json file holds patches of every\n"
                  "type with all their options",
                  "net.gbp net.patch.json");
  command.add_option("INPUT", options.input, patch_help)->required()->check(patch_name());
  command
      .add_option("OUTPUT", options.output,
                  "the file to write; the name ends in .cgb, .gbp or .patch.json. A .gbp\n"
                  "file becomes a .cgb file with the ribbons of its net")
      ->required()
      ->check(patch_name());
  command.add_flag("--lossy", options.lossy,
                   "leave out what the format cannot hold, instead of failing");
  command.add_flag("-q,--quiet", options.quiet, "print nothing but errors");
  command.callback([&options] { convert_command(options); });
}

void add_elevate_command(CLI::App& app, Elevate_options& options) {
  CLI::App& command =
      add_command(app, "elevate",
                  "raise degrees, and numbers of layers of ribbons; what the boundary determines\n"
                  "stays",
                  "bracket.cgb -o richer.cgb --degree 5 --layers 3");
  command.add_option("INPUT", options.input, patch_help)->required()->check(patch_name());
  add_output(command, options.output);
  command
      .add_option("--degree", options.degree,
                  "the degree, of ribbons with a lower one; for S-patches the depth")
      ->check(whole_number(1, MP::IO::CGB_limits::max_degree))
      ->type_name("N");
  command
      .add_option("--layers", options.layers, "the number of layers, of ribbons with fewer ones")
      ->check(whole_number(1, MP::IO::CGB_limits::max_layers))
      ->type_name("N");
  command.add_flag("-q,--quiet", options.quiet, "print nothing but errors");
  command.callback([&options] {
    if (!options.degree && !options.layers)
      throw CLI::RequiredError("--degree or --layers");
    elevate_command(options);
  });
}

void add_merge_command(CLI::App& app, Merge_options& options) {
  CLI::App& command = add_command(
      app, "merge", "make one patch of the ribbons around two that share boundary curves",
      "left.cgb right.cgb -o both.cgb");
  command.add_option("A", options.input_a, patch_help)->required()->check(patch_name());
  command.add_option("B", options.input_b, "another one")->required()->check(patch_name());
  command
      .add_option("-o,--output", options.output,
                  "the file to write; the name ends in .cgb or .patch.json")
      ->required()
      ->check(name_ending_in({".cgb", ".patch.json"}))
      ->type_name("FILE");
  command.add_flag("-q,--quiet", options.quiet, "print nothing but errors");
  command.callback([&options] { merge_command(options); });
}

} // namespace

void add_commands(CLI::App& app, Command_options& options) {
  add_mesh_command(app, options.mesh);
  add_info_command(app, options.info_input);
  add_domain_command(app, options.domain);
  add_coordinates_command(app, options.coordinates);
  add_check_command(app, options.check);
  add_exact_command(app, options.exact);
  add_convert_command(app, options.convert);
  add_elevate_command(app, options.elevate);
  add_merge_command(app, options.merge);
}

} // namespace multipatch
