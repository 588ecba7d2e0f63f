// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch_job.h"

#include "batch_interruption.h"
#include "make_patches.h"
#include "mesh_job.h"
#include "mesh_statistics.h"
#include "report_json.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/IO/surface_mesh.h>
#include <CGAL/Multisided_patches/meshing/tessellate.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <new>
#include <system_error>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

struct Stop_on_signal {
  bool go_further(MP::Tessellation_stage, std::size_t, std::size_t) {
    return Batch_interruption::received() == 0;
  }
};

// Options that are not given are null, as what the file says may change.
std::string text_of(const Mesh_options& options, const MP::Mesh_density& density) {
  const Patch_options& patch = options.patch;
  Json json{{"version", MULTIPATCH_VERSION},
            {"format", options.batch.format},
            {"density", density_json(density)},
            {"elevate", patch.elevate}};
  json["domain"] = patch.domain ? Json(to_string(*patch.domain)) : Json();
  json["clearance"] = patch.clearance ? Json(*patch.clearance) : Json();
  json["coordinates"] = patch.coordinates ? Json(to_string(*patch.coordinates)) : Json();
  json["central_weight"] = patch.central_weight ? Json(to_string(*patch.central_weight)) : Json();
  return json.dump();
}

std::uint64_t hash_of_file(const std::string& name) {
  std::error_code ignored;
  if (std::filesystem::is_other(name, ignored))
    throw MP::Input_error(name + ": expected a regular file, as it is read twice; found a pipe, a "
                                 "device or a socket");
  std::ifstream in = MP::internal::open_for_reading(name);
  return hash({std::istreambuf_iterator<char>(in), {}});
}

void make_mesh(const Batch_file& file, const Batch_settings& settings, Batch_record& record) {
  // Before the file is read: if it changes in between, the next run takes notice.
  record.input = hash_of_file(file.input);
  Patch_options options = settings.options.patch;
  options.input = file.input;
  const Any_patch patch = make_patch(read_model(options));
  Stop_on_signal visitor;
  Mesh mesh;
  const auto domain_mesh = MP::mesh_domain(patch, settings.density, visitor);
  MP::tessellate(patch, domain_mesh, mesh, MP::Default_maps(), visitor);
  const Mesh_statistics statistics = measure(mesh);
  require_sound(statistics.is_disk(), file.output);
  MP::IO::write_mesh(file.output, mesh);

  record.bytes = std::filesystem::file_size(file.output);
  record.vertices = statistics.vertices;
  record.triangles = statistics.triangles;
  record.smallest_angle = statistics.smallest_angle;
  record.domain = domain_name(patch.origin().domain);
  record.status = Batch_status::meshed;
}

// Messages of many lines would be lost among those on other files.
Batch_record failed(Batch_record record, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  record.status = Batch_status::failed;
  record.error = std::move(message);
  return record;
}

Batch_record try_to_mesh(const Batch_file& file, const Batch_settings& settings) {
  Batch_record record;
  record.options = settings.hash;
  try {
    Stage_clock clock(true);
    clock.run("meshing", [&] { make_mesh(file, settings, record); });
    record.seconds = clock.total_seconds();
  } catch (const MP::Cancelled&) {
  } catch (const std::bad_alloc&) {
    return failed(record, "not enough memory");
  } catch (const std::exception& error) {
    return failed(record, error.what());
  }
  return record;
}

} // namespace

Batch_settings::Batch_settings(const Mesh_options& all)
    : options(all), density(wanted_density(all)), hash(multipatch::hash(text_of(all, density))) {}

bool is_up_to_date(const Batch_file& file, const Batch_record& record,
                   const Batch_settings& settings) {
  if (record.status != Batch_status::meshed || record.options != settings.hash)
    return false;
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file.output, error);
  if (error || bytes != record.bytes)
    return false;
  try {
    return hash_of_file(file.input) == record.input;
  } catch (const MP::Error&) {
    return false; // and is tried, which tells why
  }
}

Batch_record mesh_file(const Batch_file& file, const Batch_settings& settings) {
#ifdef CGAL_LINKED_WITH_TBB
  // Else this thread would, while it waits for its own tasks, take up those of other files.
  tbb::task_arena one_thread(1);
  return one_thread.execute([&] { return try_to_mesh(file, settings); });
#else
  return try_to_mesh(file, settings);
#endif
}

} // namespace multipatch
