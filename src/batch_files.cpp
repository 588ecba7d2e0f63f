// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch_files.h"

#include "any_model.h"
#include "batch_manifest.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <istream>
#include <system_error>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> patches_in(const std::string& directory) {
  std::vector<std::string> names;
  std::error_code error, ignored;
  for (fs::directory_iterator entry(directory, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
    if (is_patch_file(entry->path().string()) && entry->is_regular_file(ignored))
      names.push_back(entry->path().string());
  if (error)
    throw MP::Input_error(directory + ": cannot be read: " + error.message());
  if (names.empty())
    throw MP::Input_error(directory + ": no .cgb, .gbp or .patch.json files are in this directory");
  std::sort(names.begin(), names.end());
  return names;
}

std::string trimmed(const std::string& line) {
  const char* blanks = " \t\r";
  const std::size_t begin = line.find_first_not_of(blanks);
  if (begin == std::string::npos)
    return "";
  return line.substr(begin, line.find_last_not_of(blanks) + 1 - begin);
}

// Collects the names of inputs; `where` begins messages on one of them.
class Inputs {
public:
  explicit Inputs(bool may_be_missing) : may_be_missing_(may_be_missing) {}

  void add(const std::string& name, const std::string& where = "") {
    std::error_code ignored;
    if (fs::is_directory(name, ignored)) {
      const auto found = patches_in(name);
      names_.insert(names_.end(), found.begin(), found.end());
      return;
    }
    if (!may_be_missing_ && !fs::exists(name, ignored))
      throw MP::Input_error(where + name + ": cannot be opened for reading: there is no such file");
    names_.push_back(name);
  }

  void add_list(std::istream& in, const std::string& list) {
    std::string line;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
      line = trimmed(line);
      if (!line.empty() && line.front() != '#')
        add(line, list + ':' + std::to_string(number) + ": ");
    }
  }

  std::vector<std::string> take() { return std::move(names_); }

private:
  bool may_be_missing_;
  std::vector<std::string> names_;
};

std::vector<std::string> all_inputs(const Mesh_options& options) {
  const std::string& list = options.batch.list;
  Inputs inputs(options.batch.keep_going);
  for (const std::string& input : options.inputs)
    inputs.add(input);
  if (list == "-") {
    inputs.add_list(std::cin, "standard input");
  } else if (!list.empty()) {
    std::ifstream in = MP::internal::open_for_reading(list);
    inputs.add_list(in, list);
  }
  std::vector<std::string> names = inputs.take();
  if (names.empty())
    throw MP::Input_error((list == "-" ? "standard input" : list) + ": no files are listed there");
  return names;
}

// The name that all names of a file have in common; that of a missing one need not be right.
std::string canonical(const std::string& name) {
  std::error_code error;
  const fs::path path = fs::weakly_canonical(fs::absolute(name, error), error);
  return error ? name : path.string();
}

void check_outputs(const std::vector<Batch_file>& files, const Mesh_options& options) {
  const std::string& report = options.report;
  const std::string manifest =
      canonical((fs::path(options.batch.directory) / Batch_manifest::file_name).string());
  std::unordered_map<std::string, const Batch_file*> by_output;
  std::unordered_set<std::string> inputs;
  for (const Batch_file& file : files) {
    const std::string input = canonical(file.input);
    if (input == manifest)
      throw MP::Input_error(file.input + ": is no patch: it is the manifest of the batch");
    inputs.insert(input);
    const auto [place, is_new] = by_output.emplace(file.output, &file);
    if (!is_new)
      throw MP::Input_error(file.output + ": would be the mesh of both " + place->second->input +
                            " and " + file.input);
  }
  for (const Batch_file& file : files)
    if (inputs.count(canonical(file.output)) > 0)
      throw MP::Input_error(file.output + ": cannot be written: it is one of the inputs");
  if (report.empty())
    return;
  const std::string report_path = canonical(report);
  if (inputs.count(report_path) > 0)
    throw MP::Input_error(report + ": cannot be written: it is one of the inputs");
  if (report_path == manifest)
    throw MP::Input_error(report + ": cannot be written: it is the manifest of the batch");
  for (const Batch_file& file : files)
    if (canonical(file.output) == report_path)
      throw MP::Input_error(report + ": cannot be written: it is the mesh of " + file.input);
}

} // namespace

std::string batch_output(const std::string& input, const Batch_options& options) {
  std::string stem = fs::path(input).stem().string();
  const std::string rest = ".patch"; // of .patch.json
  if (is_patch_file(input) && MP::internal::file_extension(input) == ".json")
    stem.erase(stem.size() - rest.size());
  return (fs::path(options.directory) / (stem + '.' + options.format)).string();
}

std::vector<Batch_file> batch_files(const Mesh_options& options) {
  std::vector<Batch_file> files;
  for (std::string& input : all_inputs(options)) {
    std::string output = batch_output(input, options.batch);
    files.push_back({std::move(input), std::move(output)});
  }
  check_outputs(files, options);
  return files;
}

} // namespace multipatch
