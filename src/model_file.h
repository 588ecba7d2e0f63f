// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MODEL_FILE_H
#define MULTIPATCH_MODEL_FILE_H

#include "any_model.h"

#include <string>
#include <vector>

namespace multipatch {

// The formats of patches, which the names of files tell.
enum class Model_format { cgb, gbp, json };

// Throws Input_error if the name is that of no format of patches.
Model_format model_format(const std::string& file_name);

// Reads a file of any of the formats, which its name tells. Throws Input_error that names the file.
Any_model read_model_file(const std::string& file_name);

// What a format cannot hold of a model, a phrase each; it can hold all others.
std::vector<std::string> losses(const Any_model& model, Model_format format);

// The model as the format can hold it: a generalized Bezier patch becomes the ribbons of its net in
// a .cgb file. Throws Input_error, which names the file, if the format is not for this type.
Any_model fitted(const Any_model& model, const std::string& file_name);

// Writes a model that fits the format, whole or not at all. A .cgb file gets the central weight
// that `automatic` stands for; throws Error if the patch that would tell cannot be made.
void write_model_file(const std::string& file_name, const Any_model& model);

} // namespace multipatch

#endif // MULTIPATCH_MODEL_FILE_H
