// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_LOOP_MERGER_H
#define CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_LOOP_MERGER_H

#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>
#include <CGAL/Multisided_patches/ribbons/internal/bezier_pieces.h>
#include <CGAL/Multisided_patches/ribbons/internal/curve_overlap.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The work of `merge_loops()`. `Result` is its result, `Merged_loop_3`.
template <typename Result>
class Loop_merger {
  using Loop = decltype(Result::loop);
  using Traits = typename Loop::Geom_traits;
  using FT = typename Traits::FT;
  using Point_3 = typename Traits::Point_3;
  using Ribbon = Bezier_ribbon_3<Traits>;
  using Source = typename Result::Source;

  struct Piece {
    Source source;
    bool shared;
  };
  struct Side {
    Ribbon ribbon;
    std::vector<Source> sources;
  };

public:
  // `tolerance` is a distance. The two loops have to live on.
  Loop_merger(const Loop& first, const Loop& second, double tolerance, bool join_sides)
      : loops_{&first, &second}, tolerance_(tolerance), join_sides_(join_sides) {}

  Result operator()() const {
    const std::array<std::vector<std::vector<Piece>>, 2> shared = shared_pieces();
    std::vector<Side> sides = outer_sides(0, shared[0]);
    const std::vector<Side> others = outer_sides(1, shared[1]);
    const std::size_t seam = sides.size();
    sides.insert(sides.end(), others.begin(), others.end());
    check_that_they_touch_nowhere_else(sides, seam);
    close_seam(sides, seam - 1, seam);
    close_seam(sides, sides.size() - 1, 0);

    std::vector<Ribbon> ribbons;
    std::vector<std::vector<Source>> sources;
    for (Side& side : sides) {
      ribbons.push_back(std::move(side.ribbon));
      sources.push_back(std::move(side.sources));
    }
    return {Loop(std::move(ribbons)), std::move(sources)};
  }

private:
  // For each loop and each of its sides the parts on sides of the other loop, from its start on.
  std::array<std::vector<std::vector<Piece>>, 2> shared_pieces() const {
    std::array<std::vector<std::vector<Piece>>, 2> shared{
        std::vector<std::vector<Piece>>(loops_[0]->size()),
        std::vector<std::vector<Piece>>(loops_[1]->size())};
    bool any = false;
    for (std::size_t i = 0; i < loops_[0]->size(); ++i)
      for (std::size_t j = 0; j < loops_[1]->size(); ++j) {
        const std::vector<Point_3> b = boundary(1, j);
        const auto overlap =
            find_overlap(boundary(0, i), std::vector<Point_3>(b.rbegin(), b.rend()), tolerance_);
        if (!overlap)
          continue;
        any = true;
        shared[0][i].push_back({{0, i, overlap->begin, overlap->end}, true});
        shared[1][j].push_back(
            {{1, j, FT(FT(1) - overlap->other_end), FT(FT(1) - overlap->other_begin)}, true});
      }
    if (!any)
      throw Input_error(
          "the loops cannot be merged: no part of a boundary curve of one is the same as one of "
          "the other, run the other way, within " +
          to_short_text(tolerance_) + hint());
    for (auto& sides : shared)
      for (std::vector<Piece>& pieces : sides)
        std::sort(pieces.begin(), pieces.end(),
                  [](const Piece& p, const Piece& q) { return p.source.begin < q.source.begin; });
    return shared;
  }

  std::vector<Point_3> boundary(std::size_t loop, std::size_t side) const {
    return row_of((*loops_[loop])[side], 0);
  }

  // What is likely to be wrong with two loops that share nothing.
  std::string hint() const {
    for (std::size_t i = 0; i < loops_[0]->size(); ++i)
      for (std::size_t j = 0; j < loops_[1]->size(); ++j)
        if (find_overlap(boundary(0, i), boundary(1, j), tolerance_))
          return "; side " + std::to_string(i) + " of the first and side " + std::to_string(j) +
                 " of the second are the same in the same direction, so one of the loops seems to "
                 "run the wrong way round";
    return {};
  }

  // Whether two ends of parts of a side, or of the side itself, are the same point, found twice.
  static bool is_same_parameter(const FT& s, const FT& t) {
    return std::abs(CGAL::to_double(FT(s - t))) < 1e-9;
  }

  // All pieces of a loop in order, shared or not.
  std::vector<Piece> all_pieces(std::size_t loop,
                                const std::vector<std::vector<Piece>>& shared) const {
    std::vector<Piece> pieces;
    for (std::size_t side = 0; side < shared.size(); ++side) {
      FT end(0);
      for (Piece piece : shared[side]) {
        if (is_same_parameter(piece.source.begin, end))
          piece.source.begin = end;
        else if (piece.source.begin < end)
          throw Input_error("the loops cannot be merged: two sides of one share the same part of "
                            "side " +
                            std::to_string(side) + " of the other");
        else
          pieces.push_back({{loop, side, end, piece.source.begin}, false});
        if (is_same_parameter(piece.source.end, FT(1)))
          piece.source.end = FT(1);
        pieces.push_back(piece);
        end = piece.source.end;
      }
      if (end < FT(1))
        pieces.push_back({{loop, side, end, FT(1)}, false});
    }
    return pieces;
  }

  // The ribbons of a loop that are not shared, from the end of the shared chain to its start.
  std::vector<Side> outer_sides(std::size_t loop,
                                const std::vector<std::vector<Piece>>& shared) const {
    std::vector<Piece> pieces = all_pieces(loop, shared);
    std::size_t chains = 0, start = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (!pieces[i].shared && pieces[i == 0 ? pieces.size() - 1 : i - 1].shared) {
        ++chains;
        start = i;
      }
    if (chains == 0)
      throw Input_error("the loops cannot be merged: all sides of the " + name(loop) +
                        " loop are shared, so that nothing of it would be left");
    if (chains > 1)
      throw Input_error("the loops cannot be merged: they share " + std::to_string(chains) +
                        " separate chains of boundary curves, so that the merged surface would "
                        "have a hole and more than one loop around it");
    std::rotate(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(start), pieces.end());
    std::vector<Side> sides;
    for (const Piece& piece : pieces)
      if (!piece.shared) {
        const Source& s = piece.source;
        sides.push_back({ribbon_piece((*loops_[loop])[s.side], s.begin, s.end), {s}});
      }
    return sides;
  }

  static std::string name(std::size_t loop) { return loop == 0 ? "first" : "second"; }

  // A corner of one loop may be a corner of the other one, or inside one of its sides. The first
  // sides of both, 0 and `seam`, start at the ends of the shared chain.
  void check_that_they_touch_nowhere_else(const std::vector<Side>& sides, std::size_t seam) const {
    for (std::size_t i = 1; i < seam; ++i)
      for (std::size_t j = seam + 1; j < sides.size(); ++j)
        if (is_close(start_of(sides[i]), start_of(sides[j]), tolerance_))
          throw_touching("the start of " + name(sides[i]) + " is that of " + name(sides[j]));
    for (std::size_t i = 0; i < seam; ++i)
      for (std::size_t j = seam; j < sides.size(); ++j) {
        if (i != 0)
          check_that_start_is_off(sides[i], sides[j]);
        if (j != seam)
          check_that_start_is_off(sides[j], sides[i]);
      }
  }

  void check_that_start_is_off(const Side& side, const Side& other) const {
    if (!parameters_of(row_of(other.ribbon, 0), start_of(side), tolerance_).empty())
      throw_touching("the start of " + name(side) + " is inside " + name(other));
  }

  [[noreturn]] static void throw_touching(const std::string& where) {
    throw Input_error("the loops cannot be merged: they meet apart from the chain that they share, "
                      "as " +
                      where + ", so that the merged loop would touch itself");
  }

  static const Point_3& start_of(const Side& side) { return side.ribbon.control_point(0, 0); }
  static std::string name(const Side& side) {
    const Source& source = side.sources.front();
    return "side " + std::to_string(source.side) + " of the " + name(source.loop);
  }

  // Makes `after` start exactly where `before` ends, if it does so within the tolerance. An end of
  // a whole side stays, so that the next side still starts there.
  void meet(Side& before, Side& after) const {
    Ribbon &in = before.ribbon, &out = after.ribbon;
    const Point_3 end = in.control_point(in.degree(), 0), start = out.control_point(0, 0);
    if (end == start || !is_close(end, start, 4 * tolerance_))
      return;
    std::vector<Point_3> points;
    if (before.sources.back().end == FT(1) && after.sources.front().begin != FT(0)) {
      points = out.control_points();
      points.front() = end;
      out = Ribbon(out.degree(), out.layers(), std::move(points));
    } else {
      points = in.control_points();
      points[in.degree()] = start;
      in = Ribbon(in.degree(), in.layers(), std::move(points));
    }
  }

  // Makes one side of two that follow each other, or has them meet.
  void close_seam(std::vector<Side>& sides, std::size_t before, std::size_t after) const {
    if (!join_sides_ || sides.size() <= 3)
      return meet(sides[before], sides[after]);
    const auto joined = join_ribbons(sides[before].ribbon, sides[after].ribbon, tolerance_);
    if (!joined)
      return meet(sides[before], sides[after]);
    std::vector<Source> sources = sides[before].sources;
    sources.insert(sources.end(), sides[after].sources.begin(), sides[after].sources.end());
    sides[after] = {*joined, std::move(sources)};
    sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(before));
  }

  std::array<const Loop*, 2> loops_;
  double tolerance_;
  bool join_sides_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_RIBBONS_INTERNAL_LOOP_MERGER_H
