// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch_record.h"

#include <cinttypes>
#include <cstdio>
#include <stdexcept>

namespace multipatch {

namespace {

using Json = nlohmann::ordered_json;

// JSON numbers of this size are not read back exactly by all programs.
std::string hexadecimal(std::uint64_t number) {
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, number);
  return text;
}

std::uint64_t parse_hexadecimal(const std::string& text) {
  return std::stoull(text, nullptr, 16);
}

Batch_status parse_status(const std::string& text) {
  using S = Batch_status;
  for (const S status : {S::not_done, S::started, S::meshed, S::up_to_date, S::failed})
    if (text == to_string(status))
      return status;
  throw std::invalid_argument("no status");
}

} // namespace

const char* to_string(Batch_status status) {
  switch (status) {
  case Batch_status::not_done:
    return "not-done";
  case Batch_status::started:
    return "started";
  case Batch_status::meshed:
    return "meshed";
  case Batch_status::up_to_date:
    return "up-to-date";
  case Batch_status::failed:
    return "failed";
  }
  return "";
}

std::uint64_t hash(const std::string& text) {
  std::uint64_t value = 14695981039346656037u;
  for (const unsigned char c : text)
    value = (value ^ c) * 1099511628211u;
  return value;
}

Json record_json(const Batch_file& file, const Batch_record& record) {
  Json json{{"input", file.input},
            {"output", file.output},
            {"status", to_string(record.status)},
            {"options", hexadecimal(record.options)}};
  if (record.status == Batch_status::failed)
    json["error"] = record.error;
  if (record.status == Batch_status::meshed || record.status == Batch_status::up_to_date) {
    json["input_hash"] = hexadecimal(record.input);
    json["bytes"] = record.bytes;
    json["vertices"] = record.vertices;
    json["triangles"] = record.triangles;
    json["smallest_angle_degrees"] = record.smallest_angle;
    json["domain"] = record.domain;
    json["seconds"] = record.seconds;
  }
  return json;
}

Batch_record parse_record(const Json& json) {
  Batch_record record;
  record.status = parse_status(json.at("status").get<std::string>());
  record.options = parse_hexadecimal(json.at("options").get<std::string>());
  if (record.status == Batch_status::failed)
    record.error = json.at("error").get<std::string>();
  if (record.status == Batch_status::meshed) {
    record.input = parse_hexadecimal(json.at("input_hash").get<std::string>());
    json.at("bytes").get_to(record.bytes);
    json.at("vertices").get_to(record.vertices);
    json.at("triangles").get_to(record.triangles);
    json.at("smallest_angle_degrees").get_to(record.smallest_angle);
    json.at("domain").get_to(record.domain);
    json.at("seconds").get_to(record.seconds);
  }
  return record;
}

} // namespace multipatch
