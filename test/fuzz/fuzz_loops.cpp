// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes random loops and domains. Every case must end with a valid mesh, or with an exception of
// the package that says why there is none, in 5 seconds.
//
//   fuzz_loops [--count N] [--seed S] [--first K] [--threads T] [--limit SECONDS] [--verbose]
//
// The cases are a matter of the seed and of their index, so that `--first K --count 1` repeats one.
// They run in child processes: one that crashes or does not end is a finding like others.

#include "random_loops.h"

#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/meshing/is_valid_domain_mesh.h>
#include <CGAL/Multisided_patches/meshing/mesh_domain.h>
#include <CGAL/Multisided_patches/meshing/triangulate_domain.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <poll.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iostream>
#include <map>
#include <set>

using namespace fuzz;

namespace {

struct Options {
  std::uint64_t count = 1000, seed = 1, first = 0, threads = 1;
  double limit = 5; // seconds of processor time
  bool verbose = false;
};

// Larger meshes than a case is to have, because the surface is larger than its loop suggests, are
// given up. That is no finding.
constexpr std::size_t max_points = 4000;

struct Size_limit {
  bool go_further(MP::Tessellation_stage stage, std::size_t done, std::size_t total) {
    return stage != MP::Tessellation_stage::meshing ||
           (done < max_points && total < 2 * max_points);
  }
};

// What is wrong with the library.
struct Finding {
  std::string text;
};

// What came of a case that ended well.
struct Outcome {
  std::size_t triangles = 0;
  // The number of triangles, relative to that asked for; 0 if there was none, or a small one.
  double share_of_target = 0;
};

// ----------------------------------------------------------------------------------------- cases

// A case in the making: what it is, known before it runs, and what is to be done.
struct Case {
  std::string text, group;
  std::function<Outcome()> run;
};

Outcome checked(const Domain& domain, const MP::Domain_mesh_2<Kernel>& mesh) {
  const std::string defect = MP::domain_mesh_defect(domain, mesh);
  if (!defect.empty())
    throw Finding{"invalid mesh: " + defect};
  return {mesh.triangles.size(), 0};
}

template <typename Patch>
Outcome mesh_patch(const Patch& patch, const MP::Mesh_density& density, bool parallel) {
  const auto mesh =
      parallel ? MP::mesh_domain<CGAL::Parallel_if_available_tag>(patch, density, Size_limit())
               : MP::mesh_domain<CGAL::Sequential_tag>(patch, density, Size_limit());
  Outcome outcome = checked(patch.domain(), mesh);
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    const Point_3 p = patch.point(mesh.points[k], mesh.locations[k]);
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
      throw Finding{"not finite: point " + std::to_string(k)};
  }
  const auto target = density.target_triangles().value_or(0);
  if (target >= 1000)
    outcome.share_of_target = double(mesh.triangles.size()) / double(target);
  return outcome;
}

enum class Coordinate_type { mean_value, harmonic, wachspress };

Outcome mesh_loop(const Raw_loop& raw, const MP::Domain_options& domain, Coordinate_type type,
                  MP::Central_weight central_weight,
                  const std::function<MP::Mesh_density(double)>& density, bool parallel) {
  const Loop loop = raw.loop();
  if (raw.is_broken)
    throw Finding{"accepted: a loop that cannot be one"};
  MP::Concave_bezier_model_3<Kernel> model(loop);
  model.domain = domain;
  model.central_weight = central_weight;
  const MP::Mesh_density d = density(loop.diagonal());
  switch (type) {
  case Coordinate_type::mean_value:
    return mesh_patch(
        MP::Concave_bezier_patch_3<Kernel, MP::Mean_value_coordinates_2<Kernel>>(model), d,
        parallel);
  case Coordinate_type::wachspress:
    return mesh_patch(
        MP::Concave_bezier_patch_3<Kernel, MP::Wachspress_coordinates_2<Kernel>>(model), d,
        parallel);
  default:
    return mesh_patch(MP::Concave_bezier_patch_3<Kernel>(model), d, parallel);
  }
}

// A density for loops of any diagonal, and its description.
std::pair<std::function<MP::Mesh_density(double)>, std::string> random_density(Random& random) {
  using MP::Mesh_density;
  const double u = random.in(0, 1);
  // Most of what can go wrong does so in small meshes, of which there is time for many more.
  const bool is_large = chance(random, 0.03);
  const double edge = power_of_ten(random, std::log10(is_large ? 0.02 : 0.1), std::log10(3));
  const double chordal = power_of_ten(random, is_large ? -3 : -2, -1),
               normal = power_of_ten(random, 0.7, 1.78);
  const auto count = static_cast<std::size_t>(power_of_ten(random, 0, is_large ? 3.5 : 2.5));
  const auto text = [](const char* name, double x) {
    return std::string(name) + ' ' + MP::internal::to_short_text(x);
  };
  if (u < 0.4)
    return {[=](double) { return Mesh_density::triangles(count); },
            "triangles " + std::to_string(count)};
  if (u < 0.78)
    return {[=](double size) { return Mesh_density::edge_length(edge * size); },
            text("edge length", edge)};
  if (u < 0.92)
    return {[=](double size) { return Mesh_density::chordal_deviation(chordal * size); },
            text("chordal deviation", chordal)};
  if (u < 0.98)
    return {[=](double) { return Mesh_density::normal_deviation(normal); },
            text("normal deviation", normal)};
  return {[=](double size) {
            return Mesh_density::edge_length(edge * size) &
                   Mesh_density::chordal_deviation(chordal * size) &
                   Mesh_density::normal_deviation(normal);
          },
          text("combined, edge length", edge) + text(", chordal deviation", chordal) +
              text(", normal deviation", normal)};
}

Case loop_case(Random& random) {
  using G = MP::Domain_generator;
  const Raw_loop raw = random_raw_loop(random);
  MP::Domain_options domain;
  domain.generator = pick(random, std::vector<G>{G::automatic, G::projected, G::similarity,
                                                 G::similarity_outer, G::circular, G::regular});
  if (chance(random, 0.2))
    domain.clearance = power_of_ten(random, -6, 0);
  // Mean value coordinates are harmless on convex domains only.
  const double harmonic = !raw.is_harmless ? 0.08 : raw.is_convex ? 0.2 : 1, u = random.in(0, 1);
  const Coordinate_type type = u < harmonic                       ? Coordinate_type::harmonic
                               : u > (raw.is_convex ? 0.9 : 0.98) ? Coordinate_type::wachspress
                                                                  : Coordinate_type::mean_value;
  const MP::Central_weight weight =
      pick(random,
           std::vector<MP::Central_weight>{MP::Central_weight::none, MP::Central_weight::none,
                                           static_cast<MP::Central_weight>(random.integer(0, 3))});
  const bool parallel = chance(random, 0.02);
  const auto [density, density_text] = random_density(random);
  constexpr const char* types[] = {"mean value", "harmonic", "Wachspress"};
  const std::string kind = density_text.substr(0, density_text.find_first_of(" ,"));
  return {raw.text + "; " + to_string(domain.generator) + " domain, " +
              types[static_cast<int>(type)] + "; " + density_text,
          (raw.is_harmless ? "harmless loops, "
           : raw.is_broken ? "broken loops, "
                           : "other loops, ") +
              kind,
          [=] { return mesh_loop(raw, domain, type, weight, density, parallel); }};
}

// Points of a plan, with a random size and place.
Points placed(Random& random, Points points) {
  const double size = chance(random, 0.3) ? power_of_ten(random, -100, 100) : 1;
  const double distance = chance(random, 0.2) ? power_of_ten(random, 0, 12) : 0;
  for (Point_2& p : points)
    p = Point_2(size * (p.x() + distance), size * (p.y() - distance));
  return points;
}

Case domain_case(Random& random) {
  const bool has_holes = chance(random, 0.5);
  const Plan plan = random_plan(random);
  const std::uint64_t engine = random.integer(0, 1u << 30);
  const int smoothing = chance(random, 0.3) ? static_cast<int>(random.integer(1, 3)) : 0;
  const double fineness = power_of_ten(
      random, 0, chance(random, 0.03) ? 3.5 : 2.5); // triangles that a square would have
  const double most_segments = power_of_ten(random, 0, 2);
  const std::string text =
      has_holes ? "domain with holes" : std::to_string(plan.points.size()) + " sides, " + plan.name;
  const auto run = [=] {
    Random local(static_cast<unsigned>(engine));
    const Domain domain = has_holes
                              ? random_domain(local, local.integer(3, 20), local.integer(1, 5))
                              : Domain(placed(local, plan.points));
    std::vector<std::size_t> segments;
    for (std::size_t i = 0; i < domain.size(); ++i)
      segments.push_back(
          static_cast<std::size_t>(power_of_ten(local, 0, std::log10(most_segments))));
    const double spacing = domain.diameter() / std::sqrt(fineness);
    return checked(domain, MP::triangulate_domain(domain, segments, spacing, smoothing));
  };
  return {text + "; up to " + MP::internal::to_short_text(most_segments) + " segments a side, " +
              MP::internal::to_short_text(fineness) + " triangles for a square, " +
              std::to_string(smoothing) + " sweeps",
          "domains", run};
}

Case make_case(const Options& options, std::uint64_t index) {
  Random random = random_of_case(options.seed, index);
  return chance(random, 0.12) ? domain_case(random) : loop_case(random);
}

// --------------------------------------------------------------------------------------- workers

double processor_time() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// A worker tells its parent about its cases line by line, each in one piece:
//   S <index> <group>\t<text>           the case starts
//   E <index> <seconds> <triangles> <share of target> <verdict>\t<message>
// with the verdict `mesh`, `refused` (an Error of the package) or `finding`.
void tell(int pipe, std::string line) {
  for (char& c : line)
    if (c == '\n')
      c = ' ';
  line += '\n';
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t written = write(pipe, line.data() + done, line.size() - done);
    if (written <= 0)
      _exit(1);
    done += static_cast<std::size_t>(written);
  }
}

constexpr int out_of_time = 124; // exit status of a worker

void limit_time(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec = static_cast<suseconds_t>(1e6 * (seconds - std::floor(seconds)));
  setitimer(ITIMER_PROF, &timer, nullptr);
}

// Runs a case; tells how it ended, in the words of the lines above.
std::string result_of(const Case& fuzz_case) {
  try {
    const Outcome outcome = fuzz_case.run();
    std::ostringstream line;
    line << outcome.triangles << ' ' << outcome.share_of_target << " mesh\t";
    return line.str();
  } catch (const Finding& finding) {
    return "0 0 finding\t" + finding.text;
  } catch (const MP::Error& error) {
    return *error.what() == '\0' ? "0 0 finding\tan error without a message"
                                 : std::string("0 0 refused\t") + error.what();
  } catch (const std::exception& error) {
    return std::string("0 0 finding\tforeign exception: ") + error.what();
  } catch (...) {
    return "0 0 finding\tforeign exception that is no std::exception";
  }
}

[[noreturn]] void work(const Options& options, std::uint64_t first, int pipe) {
  std::signal(SIGPROF, [](int) { _exit(out_of_time); });
  for (std::uint64_t k = first; k < options.first + options.count; k += options.threads) {
    const Case fuzz_case = make_case(options, k);
    tell(pipe, "S " + std::to_string(k) + ' ' + fuzz_case.group + '\t' + fuzz_case.text);
    limit_time(options.limit);
    const double start = processor_time();
    const std::string result = result_of(fuzz_case);
    const double seconds = processor_time() - start;
    limit_time(0);
    std::ostringstream line;
    line << "E " << k << ' ' << seconds << ' ' << result;
    tell(pipe, line.str());
  }
  _exit(0);
}

// ---------------------------------------------------------------------------------------- report

// The first words of a message, without numbers, by which messages are counted.
std::string kind_of(const std::string& message) {
  std::istringstream in(message);
  std::string word, kind;
  for (int words = 0; words < 9 && in >> word; ++words) {
    const bool is_number = word.find_first_of("0123456789") != std::string::npos;
    kind += (kind.empty() ? "" : " ") + (is_number ? "#" : word);
  }
  return kind;
}

class Report {
public:
  explicit Report(const Options& options) : options_(options) {}

  void start(const std::string& group) { ++groups_[group].cases; }

  void end(std::uint64_t index, const std::string& group, const std::string& text,
           const std::string& verdict, const std::string& message, double seconds,
           std::size_t triangles, double share_of_target) {
    if (options_.verbose)
      std::cout << index << ": " << verdict << ' ' << message << ", " << seconds << " s, "
                << triangles << " triangles: " << text << '\n';
    Group& g = groups_[group];
    g.seconds += seconds;
    slowest_.insert({seconds, index, text});
    if (slowest_.size() > 5)
      slowest_.erase(slowest_.begin());
    if (verdict == "finding") {
      found(index, text, message);
    } else if (verdict == "mesh") {
      ++g.meshes;
      g.triangles += triangles;
      targets_ += share_of_target > 0;
      hits_ += share_of_target > 0.9 && share_of_target < 1.1;
    } else {
      Refusal& refusal = refusals_[kind_of(message)];
      ++refusal.count;
      refusal.harmless += group.find("harmless") == 0;
      refusal.example = index;
    }
  }

  void found(std::uint64_t index, const std::string& text, const std::string& what) {
    ++findings_[kind_of(what)];
    std::cout << "FINDING: " << what << "\n  in the case " << text << "\n  repeat with --seed "
              << options_.seed << " --first " << index << " --count 1" << std::endl;
  }

  // Returns whether there was no finding.
  bool print() const {
    std::cout << "seed " << options_.seed << ", cases " << options_.first << " to "
              << options_.first + options_.count - 1 << '\n';
    for (const auto& [name, g] : groups_)
      std::printf("%-32s %7zu cases %6.2f %% meshed, %6.1f ms, %7.0f triangles\n", name.c_str(),
                  g.cases, 100 * double(g.meshes) / double(g.cases),
                  1000 * g.seconds / double(g.cases),
                  double(g.triangles) / double((std::max)(g.meshes, std::size_t(1))));
    std::fflush(stdout);
    std::cout << "1000 triangles or more that were asked for: met within 10 % by " << hits_
              << " of " << targets_
              << " meshes\nrefused, by message (of these, harmless loops; the last one):\n";
    for (const auto& [kind, r] : refusals_)
      std::cout << "  " << r.count << " (" << r.harmless << ", " << r.example << "): " << kind
                << '\n';
    std::cout << "slowest:\n";
    for (auto s = slowest_.rbegin(); s != slowest_.rend(); ++s)
      std::cout << "  " << s->seconds << " s: " << s->index << ", " << s->text << '\n';
    std::cout << "findings, by kind:" << (findings_.empty() ? " none" : "") << '\n';
    for (const auto& [kind, count] : findings_)
      std::cout << "  " << count << ": " << kind << '\n';
    std::cout.flush();
    return findings_.empty();
  }

private:
  struct Group {
    std::size_t cases = 0, meshes = 0, triangles = 0;
    double seconds = 0;
  };
  struct Refusal {
    std::size_t count = 0, harmless = 0;
    std::uint64_t example = 0;
  };
  struct Slow {
    double seconds;
    std::uint64_t index;
    std::string text;
    bool operator<(const Slow& other) const {
      return std::make_pair(seconds, index) < std::make_pair(other.seconds, other.index);
    }
  };

  const Options& options_;
  std::map<std::string, Group> groups_;
  std::map<std::string, Refusal> refusals_;
  std::map<std::string, std::size_t> findings_;
  std::set<Slow> slowest_;
  std::size_t targets_ = 0, hits_ = 0;
};

// A child process, and the case it is at.
class Worker {
public:
  Worker(const Options& options, std::uint64_t first, Report& report)
      : options_(options), report_(report) {
    launch(first);
  }
  int pipe() const { return pipe_; }
  bool is_done() const { return pipe_ < 0; }

  // Takes what the child has written; a new one takes over if it has ended before its time.
  void read() {
    char buffer[4096];
    const ssize_t size = ::read(pipe_, buffer, sizeof buffer);
    if (size <= 0) {
      bury();
      return;
    }
    text_.append(buffer, static_cast<std::size_t>(size));
    std::size_t end;
    while ((end = text_.find('\n')) != std::string::npos) {
      understand(text_.substr(0, end));
      text_.erase(0, end + 1);
    }
  }

private:
  void launch(std::uint64_t first) {
    int ends[2];
    std::cout.flush();
    if (::pipe(ends) != 0 || (child_ = fork()) < 0) {
      std::perror("fuzz_loops");
      std::exit(2);
    }
    if (child_ == 0) {
      close(ends[0]);
      work(options_, first, ends[1]);
    }
    close(ends[1]);
    pipe_ = ends[0];
    is_busy_ = false;
  }

  void understand(const std::string& line) {
    std::istringstream in(line);
    char type;
    in >> type >> index_;
    if (type == 'S') {
      std::getline(in >> std::ws, group_, '\t');
      std::getline(in, case_);
      report_.start(group_);
      is_busy_ = true;
      return;
    }
    double seconds = 0, share = 0;
    std::size_t triangles = 0;
    std::string verdict, message;
    in >> seconds >> triangles >> share;
    std::getline(in >> std::ws, verdict, '\t');
    std::getline(in, message);
    report_.end(index_, group_, case_, verdict, message, seconds, triangles, share);
    is_busy_ = false;
  }

  void bury() {
    close(pipe_);
    pipe_ = -1;
    int status = 0;
    waitpid(child_, &status, 0);
    if (!is_busy_)
      return;
    const bool is_late = WIFEXITED(status) && WEXITSTATUS(status) == out_of_time;
    const std::string what = is_late ? "out of time" : "crash, status " + std::to_string(status);
    report_.end(index_, group_, case_, "finding", what, is_late ? options_.limit : 0, 0, 0);
    const std::uint64_t next = index_ + options_.threads;
    if (next < options_.first + options_.count)
      launch(next);
  }

  const Options& options_;
  Report& report_;
  pid_t child_ = 0;
  int pipe_ = -1;
  std::string text_, group_, case_;
  std::uint64_t index_ = 0;
  bool is_busy_ = false;
};

bool run(const Options& options) {
  Report report(options);
  std::vector<Worker> workers;
  for (std::uint64_t k = 0; k < (std::min)(options.threads, options.count); ++k)
    workers.emplace_back(options, options.first + k, report);
  for (;;) {
    std::vector<pollfd> waiting;
    std::vector<Worker*> asked;
    for (Worker& w : workers)
      if (!w.is_done()) {
        waiting.push_back({w.pipe(), POLLIN, 0});
        asked.push_back(&w);
      }
    if (waiting.empty())
      return report.print();
    poll(waiting.data(), waiting.size(), -1);
    for (std::size_t k = 0; k < waiting.size(); ++k)
      if (waiting[k].revents != 0)
        asked[k]->read();
  }
}

[[noreturn]] void refuse(const std::string& what) {
  std::cerr << what
            << "\nusage: fuzz_loops [--count N] [--seed S] [--first K] [--threads T] "
               "[--limit SECONDS] [--verbose]\n";
  std::exit(2);
}

Options parsed(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--verbose") {
      options.verbose = true;
      continue;
    }
    if (i + 1 == argc)
      refuse(name + " needs a value");
    char* end = nullptr;
    const char* value = argv[++i];
    if (name == "--limit") {
      options.limit = std::strtod(value, &end);
    } else {
      std::uint64_t* const number = name == "--count"     ? &options.count
                                    : name == "--seed"    ? &options.seed
                                    : name == "--first"   ? &options.first
                                    : name == "--threads" ? &options.threads
                                                          : nullptr;
      if (number == nullptr)
        refuse("unknown option " + name);
      *number = std::strtoull(value, &end, 10);
    }
    if (end == value || *end != '\0')
      refuse(name + " needs a number, not " + value);
  }
  if (options.count < 1 || options.threads < 1 || !(options.limit > 0))
    refuse("--count, --threads and --limit must be positive");
  return options;
}

} // namespace

int main(int argc, char** argv) {
  const Options options = parsed(argc, argv);
  std::cout << "seed " << options.seed << std::endl;
  return run(options) ? 0 : 1;
}
