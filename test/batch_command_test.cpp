// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs the program over many files, as a user does. POSIX only.

#include "catch.h"
#include "program_fixtures.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

using namespace program_fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

const std::string manifest = "multipatch-manifest.jsonl";

// Coarse meshes are quick to make. The directories are `in` and `out`.
const std::string batch = "mesh in --output-directory out --triangles 100 ";

// A patch that needs no coordinates, and is made at once.
std::string triangle(double height) {
  std::ostringstream text;
  text << R"({"format": "multisided-patch", "version": 1, "type": "bezier-triangle", "degree": 1,)"
       << R"( "control_points": [[0, 0, 0], [1, 0, 0], [0, 1, )" << height << "]]}";
  return text.str();
}

// The program, for the shell.
const std::string program = std::string("'") + PROGRAM + "' ";

class Batch_scratch : public Scratch {
public:
  explicit Batch_scratch(const std::string& name) : Scratch(name) {
    fs::create_directory(*this / "in");
    for (const char* model : {"triangle_corner", "l_bracket"})
      fs::copy(MODELS_DIR + std::string("/") + model + ".cgb", *this / "in");
    write("in/flat.patch.json", triangle(1));
    write("in/steep.patch.json", triangle(9));
    write("in/README.txt", "not a patch");
  }

  // Runs commands of the shell. The version, which comes first, is not seen.
  Result run_shell(const std::string& commands) const {
    return run("--version >/dev/null; (" + commands + ')');
  }

  // The names of the meshes, and the manifest if there is one.
  std::set<std::string> names(const std::string& directory = "out") const {
    std::set<std::string> result;
    for (const auto& entry : fs::directory_iterator(*this / directory))
      result.insert(entry.path().filename().string());
    return result;
  }
  // All bytes of all meshes.
  std::map<std::string, std::string> meshes(const std::string& directory = "out") const {
    std::map<std::string, std::string> result;
    for (const std::string& name : names(directory))
      if (name != manifest)
        result[name] = contents(*this / (directory + '/' + name));
    return result;
  }
  std::vector<std::string> lines() const {
    std::vector<std::string> result;
    std::istringstream text(contents(*this / ("out/" + manifest)));
    for (std::string line; std::getline(text, line);)
      result.push_back(line);
    return result;
  }
  // An hour.
  void make_old(const std::string& name) const {
    fs::last_write_time(*this / name, fs::file_time_type::clock::now() - std::chrono::hours(1));
  }
  // Expects success with these counts.
  void expect(const std::string& arguments, const std::string& counts) const {
    INFO(arguments);
    CHECK_THAT(run_well(arguments), StartsWith("out: " + counts + "; "));
  }
};

const std::set<std::string> all_names{"flat.ply", "l_bracket.ply", "steep.ply",
                                      "triangle_corner.ply", manifest};
const std::string all_made = "4 meshed, 0 up to date, 0 failed";
const std::string all_there = "0 meshed, 4 up to date, 0 failed";

} // namespace

TEST_CASE("Each patch in a directory gets the mesh that it gets alone") {
  const Batch_scratch work("batch");
  work.expect(batch + "--report report.json", all_made);
  CHECK(work.names() == all_names);
  for (const std::string file :
       {"triangle_corner.cgb", "l_bracket.cgb", "flat.patch.json", "steep.patch.json"}) {
    const std::string stem = file.substr(0, file.find('.'));
    work.run_well("mesh -q in/" + file + " -o alone.ply --triangles 100");
    CHECK((contents(work / "alone.ply") == contents(work / ("out/" + stem + ".ply"))));
  }
  const std::string report = contents(work / "report.json");
  CHECK_THAT(report, Contains("\"meshed\": 4,") && Contains("\"failed\": 0,") &&
                         Contains("\"input\": \"in/flat.patch.json\"") &&
                         Contains("\"output\": \"out/steep.ply\"") &&
                         Contains("\"target_triangles\": 100"));
  CHECK(report.find("in/flat") < report.find("in/l_bracket"));
  CHECK(work.lines().size() == 4);
}

TEST_CASE("Meshes of many files are the same bytes for any number of threads, in all formats") {
  const Batch_scratch work("batch_threads");
  for (const std::string format : {"ply", "obj", "off", "stl"}) {
    const std::string mesh = "mesh -q in --triangles 300 --format " + format;
    CHECK(work.run_well(mesh + " --output-directory one --threads 1").empty());
    CHECK(work.run_well(mesh + " --output-directory five --threads 5").empty());
  }
  CHECK(work.meshes("one").size() == 16);
  CHECK((work.meshes("one") == work.meshes("five")));
}

TEST_CASE("A list names inputs, with blank lines and comments, in a file or on standard input") {
  const Batch_scratch work("batch_list");
  work.write("list.txt",
             "# two\n in/flat.patch.json\t\n\n  \t\n  # indented\nin/steep.patch.json \r\n");
  const std::string mesh = "mesh --output-directory out --triangles 100 ";
  work.expect(mesh + "--list list.txt", "2 meshed, 0 up to date, 0 failed");
  CHECK(work.names() == std::set<std::string>{"flat.ply", "steep.ply", manifest});
  const Result result =
      work.run_shell("cat list.txt | " + program + mesh + "in/l_bracket.cgb --list -");
  CHECK(result.status == 0);
  CHECK_THAT(result.out, StartsWith("out: 3 meshed, "));

  work.write("list.txt", "in/flat.patch.json\nin/gone.cgb\n");
  const Result missing = work.run("mesh --output-directory new --list list.txt");
  CHECK(missing.status == 1);
  CHECK_THAT(missing.err, StartsWith("multipatch: list.txt:2: in/gone.cgb: cannot be opened"));
  CHECK(!fs::exists(work / "new"));
}

TEST_CASE("A bad file ends the run, or is reported and passed over, and leaves nothing") {
  const Batch_scratch work("batch_bad_file");
  work.write("in/a.cgb", "1\n1\n");
  const Result ended = work.run(batch + "--threads 1 --report report.json");
  CHECK(ended.status == 1);
  CHECK(ended.out.empty());
  CHECK_THAT(ended.err,
             StartsWith("multipatch: in/a.cgb:") &&
                 EndsWith("; not done: 4 of 5 files, with which --keep-going goes on\n"));
  CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
  CHECK(work.names() == std::set<std::string>{manifest});
  CHECK_THAT(contents(work / "report.json"), Contains("\"not_done\": 4,"));

  // Wachspress coordinates need a convex domain; triangles have no choice of coordinates.
  for (const auto& [options, files, failed] :
       std::vector<std::tuple<std::string, std::string, std::size_t>>{
           {"", "in/gone.cgb", 2}, {"--coordinates wachspress --threads 3", "", 4}}) {
    const Result result =
        work.run(batch + "--keep-going --report report.json " + options + ' ' + files);
    INFO(options);
    CHECK(result.status == 1);
    CHECK_THAT(result.err, Contains("error: in/a.cgb:") &&
                               EndsWith(std::to_string(failed) + " of " +
                                        (files.empty() ? "5" : "6") + " files failed\n"));
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') ==
          static_cast<std::ptrdiff_t>(failed + 1));
    CHECK_THAT(result.out, Contains(", " + std::to_string(failed) + " failed; "));
    CHECK_THAT(contents(work / "report.json"), Contains("\"failed\": " + std::to_string(failed)) &&
                                                   Contains("\"not_done\": 0,") &&
                                                   Contains("\"error\": \"in/a.cgb:"));
    CHECK(work.names() == all_names);
  }
}

TEST_CASE("A run that is resumed passes over what is up to date, and nothing else") {
  const Batch_scratch work("batch_resume");
  const std::string resume = batch + "--resume ";
  work.expect(resume, all_made);
  const auto meshes = work.meshes();
  work.expect(resume, all_there);
  work.expect(resume + "--threads 1 --report report.json", all_there);
  CHECK_THAT(contents(work / "report.json"),
             Contains("\"up_to_date\": 4,") && Contains("\"domain\": "));
  CHECK(work.lines().size() == 4);
  work.expect(batch, all_made); // without being asked, nothing is passed over

  SECTION("Changed inputs are meshed again, touched ones are not") {
    work.write("in/flat.patch.json", triangle(2));
    work.write("in/steep.patch.json", triangle(9));
    work.expect(resume, "1 meshed, 3 up to date, 0 failed");
    CHECK(work.meshes().at("flat.ply") != meshes.at("flat.ply"));
    work.expect(resume, all_there);
  }
  SECTION("Missing and changed outputs are made again") {
    fs::remove(work / "out/flat.ply");
    work.write("out/steep.ply", "short");
    work.expect(resume, "2 meshed, 2 up to date, 0 failed");
    CHECK((work.meshes() == meshes));
  }
  SECTION("Added inputs are meshed") {
    fs::copy(work / "in/flat.patch.json", work / "in/new.patch.json");
    work.expect(resume, "1 meshed, 4 up to date, 0 failed");
  }
  SECTION("The directory may be moved") {
    fs::rename(work / "out", work / "moved");
    CHECK_THAT(work.run_well("mesh in --output-directory moved/ --triangles 100 --resume"),
               StartsWith("moved/: " + all_there));
  }
  SECTION("Without its manifest, all are made again") {
    fs::remove(work / ("out/" + manifest));
    work.expect(resume, all_made);
    CHECK((work.meshes() == meshes));
  }
  SECTION("Files that failed are tried again") {
    const std::string good = contents(work / "in/l_bracket.cgb");
    work.write("in/l_bracket.cgb", "");
    CHECK(work.run(resume + "--keep-going").status == 1);
    work.write("in/l_bracket.cgb", good);
    work.expect(resume, "1 meshed, 3 up to date, 0 failed");
    CHECK((work.meshes() == meshes));
  }
}

TEST_CASE("Changed options make all meshes again, and so do the old ones after that") {
  const Batch_scratch work("batch_options");
  const std::string mesh = "mesh in/l_bracket.cgb --output-directory out --resume ";
  const std::string made = "1 meshed, 0 up to date, 0 failed";
  const std::string there = "0 meshed, 1 up to date, 0 failed";
  const std::string plain = "--triangles 100";
  work.expect(mesh + plain, made);
  const auto meshes = work.meshes();
  for (const std::string options :
       {"--triangles 120", "--edge-length 1", "--triangles 100 --domain projected",
        "--triangles 100 --clearance 0.3", "--triangles 100 --coordinates mean-value",
        "--triangles 100 --central-weight full-product", "--triangles 100 --elevate"}) {
    work.expect(mesh + options, made);
    work.expect(mesh + options + " --threads 2 --keep-going", there);
  }
  work.expect(mesh + plain, made);
  CHECK((work.meshes() == meshes));
}

TEST_CASE("A manifest that a crash has cut off anywhere loses its last line only") {
  const Batch_scratch work("batch_manifest");
  work.expect(batch, all_made);
  const auto meshes = work.meshes();
  const std::string text = contents(work / ("out/" + manifest));
  const std::size_t last = text.rfind('\n', text.size() - 2) + 1;
  for (const std::size_t size : {last, last + 1, (last + text.size()) / 2, text.size() - 1}) {
    CAPTURE(size);
    work.write("out/" + manifest, text.substr(0, size));
    work.write("out/flat.ply.part123", "what a run was writing when it was killed");
    work.make_old("out/flat.ply.part123");
    work.expect(batch + "--resume", "1 meshed, 3 up to date, 0 failed");
    CHECK(work.lines().size() == 4);
    CHECK((work.meshes() == meshes));
    work.expect(batch + "--resume", all_there);
  }
  SECTION("Lines that make no sense do not count") {
    for (const std::string line : {"nonsense", "{}", "[1]", "null", R"({"output": "out/flat.ply"})",
                                   R"({"output": 1, "status": "meshed", "options": "0"})"}) {
      work.write("out/" + manifest, line + '\n' + text);
      work.expect(batch + "--resume", all_there);
    }
  }
  SECTION("A mesh that was being replaced is not trusted") {
    const std::string first = text.substr(0, text.find('\n'));
    std::string started = first;
    started.replace(started.find("\"meshed\""), 8, "\"started\"");
    work.write("out/" + manifest, text + started + '\n');
    work.expect(batch + "--resume", "1 meshed, 3 up to date, 0 failed");
  }
}

TEST_CASE("What another run may be writing stays, and so does what no run has begun") {
  const Batch_scratch work("batch_leftovers");
  fs::create_directory(work / "out");
  std::set<std::string> names = all_names;
  for (const std::string name : {"flat.ply.part", "flat.ply.part1x", "flat.txt.part1",
                                 "flat.ply.part12", "flat.ply.part123"}) {
    work.write("out/" + name, "text");
    if (name != "flat.ply.part12")
      work.make_old("out/" + name);
    if (name != "flat.ply.part123")
      names.insert(name);
  }
  work.expect(batch, all_made);
  CHECK(work.names() == names);
}

TEST_CASE("The report may be in the new directory") {
  const Batch_scratch work("batch_report");
  CHECK_THAT(work.run_well("mesh in --output-directory a/b --triangles 100 --report a/b/r.json"),
             StartsWith("a/b: " + all_made));
  CHECK_THAT(contents(work / "a/b/r.json"), Contains("\"meshed\": 4,"));
  const Result refused = work.run("mesh in --output-directory c/d --report c/e/r.json");
  CHECK(refused.status == 1);
  CHECK_THAT(refused.err, Contains("c/e/r.json: cannot be opened for writing"));
  CHECK(!fs::exists(work / "c"));
  if (!fs::exists("/dev/full"))
    return;
  CHECK(work.run(batch + "--report /dev/full").status == 1);
  work.write("in/a.cgb", "1\n1\n");
  CHECK_THAT(work.run(batch + "--threads 1 --report /dev/full").err,
             Contains("warning: /dev/full: cannot be written") &&
                 Contains("multipatch: in/a.cgb:"));
}

TEST_CASE("A pipe, which cannot be read twice, is refused as an input") {
  const Batch_scratch work("batch_pipe");
  const Result result =
      work.run_shell("cat in/l_bracket.cgb | " + program + batch + "--keep-going /dev/stdin");
  CHECK(result.status == 1);
  CHECK_THAT(result.err, Contains("error: /dev/stdin: expected a regular file"));
  CHECK_THAT(result.out, StartsWith("out: 4 meshed, 0 up to date, 1 failed"));
}

TEST_CASE("A run that is interrupted leaves whole meshes, and the next one does the others") {
  const Batch_scratch work("batch_interrupted");
  for (int k = 0; k < 16; ++k)
    fs::copy(MODELS_DIR "/l_bracket.cgb", work / ("in/" + std::to_string(k) + ".cgb"));
  const std::string mesh = "mesh in --output-directory out --triangles 1000 --threads 2 --resume ";
  const Result result =
      work.run_shell(program + mesh +
                     "& p=$!; while [ $(ls out 2>/dev/null | wc -l) -lt 5 ]; do sleep 0.01; "
                     "done; kill -TERM $p; wait $p");
  CHECK(result.status == 128 + 15);
  CHECK_THAT(result.err, StartsWith("multipatch: interrupted; ") && Contains(" of 20 files") &&
                             Contains("--resume"));
  const std::size_t made = work.meshes().size();
  CHECK((made >= 4 && made < 20));
  for (const auto& [name, text] : work.meshes()) {
    CHECK_THAT(name, EndsWith(".ply"));
    if (name != "flat.ply" && name != "steep.ply" && name != "triangle_corner.ply")
      CHECK(text == work.meshes().begin()->second);
  }
  const std::string counts =
      std::to_string(20 - made) + " meshed, " + std::to_string(made) + " up to date, 0 failed";
  work.expect(mesh, counts);
}

TEST_CASE("What cannot be a batch is refused before the work, and leaves nothing") {
  const Batch_scratch work("batch_errors");
  fs::create_directory(work / "empty");
  work.write("empty.txt", "\n# nothing\n");
  work.write("file", "");
  fs::create_directory(work / "twice");
  fs::copy(work / "in/flat.patch.json", work / "twice/flat.patch.json");
  work.write("twice/x.ply", triangle(1));
  const std::set<std::string> before = work.files();
  struct Row {
    std::string arguments;
    int status;
    std::string message;
  };
  const Row rows[] = {
      {"mesh empty --output-directory out", 1, "empty: no .cgb, .gbp or .patch.json files are in"},
      {"mesh --list empty.txt --output-directory out", 1, "empty.txt: no files are listed"},
      {"mesh --list gone.txt --output-directory out", 1, "gone.txt: cannot be opened"},
      {"mesh --list - --output-directory out", 1, "standard input: no files are listed"},
      {"mesh in gone.cgb --output-directory out", 1, "gone.cgb: cannot be opened for reading"},
      {"mesh in twice/flat.patch.json --output-directory out", 1,
       "flat.ply: would be the mesh of both in/flat.patch.json and twice/flat.patch.json"},
      {"mesh in in --output-directory out", 1, "would be the mesh of both"},
      {"mesh twice/x.ply --output-directory twice", 1, "twice/x.ply: cannot be written: it is one"},
      {"mesh in --output-directory file", 1, "file: cannot be made"},
      {"mesh in --output-directory out --report in/flat.patch.json", 1, "it is one of the inputs"},
      {"mesh in --output-directory out --report out/flat.ply", 1, "it is the mesh of in/flat"},
      {"mesh in --output-directory out --report ./out/" + manifest, 1, "it is the manifest"},
      {"mesh in out/" + manifest + " --output-directory out --keep-going", 1, "it is the manifest"},
      {"mesh in --output-directory out --report no/report.json", 1, "no/report.json: cannot be"},
      {"mesh in --output-directory out --edge-length 0", 2, "not 0"},
      {"mesh in --output-directory out -o a.ply", 2, "excludes"},
      {"mesh in --output-directory out --format pdf", 2, "pdf"},
      {"mesh in --output-directory out --threads 0", 2, "0"},
      {"mesh --output-directory out", 2, "INPUT is required"},
      {"mesh in/flat.patch.json -o a.ply --resume", 2, "--output-directory"},
      {"mesh in/flat.patch.json -o a.ply --threads 2", 2, "--output-directory"},
      {"mesh in --output-directory out --mpi --threads 2", 2, "excludes"},
      {"mesh in --output-directory out --rank-timeout 5", 2, "--mpi"},
#ifndef MPI_RUN
      {"mesh in --output-directory out --mpi", 1, "built without MPI"},
#endif
  };
  for (const Row& row : rows) {
    const Result result = work.run(row.arguments);
    INFO(row.arguments);
    CHECK(result.status == row.status);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, Contains(row.message));
    CHECK(work.files() == before);
    CHECK(work.names("twice") == std::set<std::string>{"flat.patch.json", "x.ply"});
  }
}

TEST_CASE("The help on each command has an example of that command") {
  const Batch_scratch work("batch_help");
  for (const std::string command :
       {"mesh", "info", "domain", "check", "exact", "coordinates", "convert", "elevate", "merge"})
    CHECK_THAT(work.run_well(command + " --help"),
               Contains("\nExample:  multipatch " + command + ' '));
}

#ifdef MPI_RUN // what starts several ranks; the program takes part in MPI then

namespace {

// Runs the program on a number of ranks.
Result run_ranks(const Batch_scratch& work, int ranks, const std::string& arguments) {
  return work.run_shell(std::string(MPI_RUN) + " -n " + std::to_string(ranks) + ' ' + program +
                        arguments);
}

} // namespace

TEST_CASE("Several ranks make the same meshes as one process") {
  const Batch_scratch work("batch_ranks");
  work.run_well("mesh -q in --output-directory serial --triangles 300 --threads 1");
  for (const int ranks : {1, 3}) {
    const std::string out = "ranks" + std::to_string(ranks);
    const Result result =
        run_ranks(work, ranks, "mesh in --mpi --triangles 300 --output-directory " + out);
    INFO(result.err);
    CHECK(result.status == 0);
    CHECK_THAT(result.out, StartsWith(out + ": " + all_made));
    CHECK((work.meshes(out) == work.meshes("serial")));
  }
  const Result again =
      run_ranks(work, 2, "mesh in --mpi --triangles 300 --resume --output-directory serial");
  CHECK_THAT(again.out, StartsWith("serial: " + all_there));
}

TEST_CASE("Ranks report bad files as one process does") {
  const Batch_scratch work("batch_ranks_bad_file");
  work.write("in/a.cgb", "1\n1\n");
  const Result ended = run_ranks(work, 2, batch + "--mpi");
  CHECK(ended.status == 1);
  CHECK_THAT(ended.err, Contains("multipatch: in/a.cgb:"));
  const Result result = run_ranks(work, 3, batch + "--mpi --keep-going");
  CHECK(result.status == 1);
  CHECK_THAT(result.err, Contains("error: in/a.cgb:") && Contains("1 of 5 files failed"));
  CHECK_THAT(result.out, StartsWith("out: 4 meshed, 0 up to date, 1 failed"));
  CHECK(work.names() == all_names);
}

#endif
