/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/map/region_borders.h"

#include "rooms/dimensions.h"
#include "rooms/space/nearest_sites.h"

#include <pcl/indoor/disjoint_sets.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl::indoor {
namespace {

/** What is looked at between two rooms. */
enum class Between {
  Walls,  ///< walls alone, up to the higher ceiling of the two
  Passage ///< whatever is in the way, up to the lower ceiling
};

/** The way from one pixel to another, in layers. */
struct Section {
  int height = 0; ///< from floor to ceiling
  int open = 0;
  double rise = 0.0; ///< mean of the open ones over the middle
};

/** Looks across the border between two pixels. */
class BorderSection {
public:
  BorderSection(const BorderMap& map, Between between)
  : map_(map)
  , between_(between)
  , closed_(map.occupancy.shape.nz)
  {}

  /** Measure which layers are open on the straight way between two pixels. */
  Section
  measure(int x0, int y0, int x1, int y1)
  {
    const auto [lower, higher] =
        std::minmax(map_.ceiling.at(x0, y0), map_.ceiling.at(x1, y1));
    const int top = between_ == Between::Passage ? lower : higher;
    bool is_blocked = false;
    std::fill(closed_.begin(), closed_.end(), 0);
    const int steps = std::max({std::abs(x1 - x0), std::abs(y1 - y0), 1});
    for (int k = 0; k <= steps; ++k) {
      const int x = x0 + static_cast<int>(std::lround((x1 - x0) * k / double(steps)));
      const int y = y0 + static_cast<int>(std::lround((y1 - y0) * k / double(steps)));
      is_blocked |= map_.blocked.at(x, y) != 0;
      const auto column = map_.occupancy.column(x, y);
      for (int z = map_.storey.begin; z < top; ++z)
        closed_[z] |= column[z];
    }
    const int bottom = map_.storey.begin + 1; // above the floor
    if (top <= bottom)
      return {};
    if (between_ == Between::Walls && !is_blocked && !isLowWall(bottom, top))
      std::fill(closed_.begin(), closed_.end(), 0);
    Section section;
    section.height = top - bottom;
    double sum = 0.0;
    for (int z = bottom; z < top; ++z)
      if (!closed_[z]) {
        ++section.open;
        sum += z + 0.5;
      }
    if (section.open > 0)
      section.rise = sum / section.open - 0.5 * (bottom + top);
    return section;
  }

private:
  /** A wall whose upper part was not seen closes most of what is below the heads. */
  bool
  isLowWall(int bottom, int top) const
  {
    constexpr double least_closed = 0.7; // share; trails of people close half of it
    const int heads = voxelsIn(passage_height, map_.occupancy.voxel_size, 1);
    const int end = std::min(bottom + heads, top);
    const auto closed =
        std::count(closed_.begin() + bottom, closed_.begin() + end, std::uint8_t{1});
    return static_cast<double>(closed) >= least_closed * (end - bottom);
  }

  const BorderMap& map_;
  Between between_;
  std::vector<std::uint8_t> closed_;
};

/** Call piece(p, q, section) for each side between a pixel p and the next one, q, along
 * x or y if they are of different regions. */
template <typename Piece>
void
walkBorders(const BorderMap& map, Between between, const Piece& piece)
{
  const PixelMap<std::int32_t>& labels = map.labels;
  const NearestSites nearest = nearestLabelled(map.free_labels);
  BorderSection section(map, between);
  const auto look = [&](std::size_t p, std::size_t q) {
    const std::int32_t a = labels.values[p], b = labels.values[q];
    if (a == b || a == 0 || b == 0)
      return;
    const std::int32_t from = nearest.site.values[p], to = nearest.site.values[q];
    if (from < 0 || to < 0)
      return; // nothing is free anywhere
    const int ny = labels.ny;
    piece(p, q, section.measure(from / ny, from % ny, to / ny, to % ny));
  };
  for (int x = 0; x < labels.nx; ++x)
    for (int y = 0; y < labels.ny; ++y) {
      if (x + 1 < labels.nx)
        look(labels.index(x, y), labels.index(x + 1, y));
      if (y + 1 < labels.ny)
        look(labels.index(x, y), labels.index(x, y + 1));
    }
}

/** A piece of border that a person can pass: one side of a pixel. */
struct OpenPiece {
  double x = 0.0, y = 0.0; ///< its middle, pixels
  bool across_x = false;   ///< one passes it along x
  int open = 0;            ///< open layers
  double rise = 0.0;       ///< of these, layers
};

/** The pieces of one opening as one. */
RegionOpening
joinPieces(const std::vector<OpenPiece>& pieces, double size)
{
  RegionOpening opening;
  double across_x = 0.0, open = 0.0;
  for (const OpenPiece& piece : pieces) {
    opening.x += piece.x;
    opening.y += piece.y;
    across_x += piece.across_x;
    open += piece.open;
    opening.rise += size * piece.rise;
  }
  const double count = static_cast<double>(pieces.size());
  opening.x /= count;
  opening.y /= count;
  opening.rise /= count;
  // a border that is no line of the grid goes in stairs; this is the way past them
  opening.width = size * std::hypot(across_x, count - across_x);
  opening.area = opening.width * size * open / count;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const OpenPiece& piece : pieces) {
    const Eigen::Vector2d from(piece.x - opening.x, piece.y - opening.y);
    spread += from * from.transpose();
    const int axis = piece.across_x ? 1 : 0; // the piece itself
    spread(axis, axis) += 1.0 / 12.0;
  }
  opening.along = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>()
                      .computeDirect(spread)
                      .eigenvectors()
                      .col(1);
  return opening;
}

/** Put pieces together whose middles are at most two pixels apart: a lone point in a
 * doorway does not divide it. */
std::vector<std::vector<OpenPiece>>
connectedPieces(const std::vector<OpenPiece>& pieces)
{
  const auto place = [](double x, double y) { // half pixels
    return std::make_pair(std::lround(2 * x), std::lround(2 * y));
  };
  std::map<std::pair<long, long>, int> piece_at;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    piece_at[place(pieces[i].x, pieces[i].y)] = static_cast<int>(i);
  DisjointSets sets(static_cast<int>(pieces.size()));
  for (const auto& [here, piece] : piece_at)
    for (long dx = -4; dx <= 4; ++dx)
      for (long dy = -4; dy <= 4; ++dy) {
        const auto other = piece_at.find({here.first + dx, here.second + dy});
        if (other == piece_at.end() || dx * dx + dy * dy > 16)
          continue;
        sets.merge(sets.find(piece), sets.find(other->second));
      }
  const auto group_of = sets.labels();
  std::vector<std::vector<OpenPiece>> groups;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (group_of[i] == groups.size())
      groups.emplace_back();
    groups[group_of[i]].push_back(pieces[i]);
  }
  return groups;
}

/** \brief The borders of spaces that grow by joins, and which of them is open most. */
class OpenBorders {
public:
  OpenBorders(const std::vector<RegionBorder>& borders,
              std::vector<double> section,
              const MergeOptions& options,
              double door_width)
  : options_(options)
  , door_width_(door_width)
  , section_(std::move(section))
  , neighbours_(section_.size())
  {
    for (const auto& border : borders)
      add(border);
    for (auto& [pair, entry] : entries_)
      rank(pair, entry);
  }

  /** \brief Two spaces to join; the first of those whose border is open most. */
  std::optional<RegionPair>
  widest() const
  {
    return ranks_.empty() ? std::nullopt : std::optional(ranks_.begin()->second);
  }

  /** \brief Until one of them grows, two spaces do not join. */
  void
  keepApart(const RegionPair& pair)
  {
    Entry& entry = entries_.at(pair);
    ranks_.erase({-entry.share, pair});
    entry.share = 0.0;
  }

  /** \brief The borders of joined spaces add up, so their shares are looked at anew. */
  void
  join(std::int32_t kept, std::int32_t gone)
  {
    section_[kept] = std::max(section_[kept], section_[gone]);
    for (const std::int32_t other : std::exchange(neighbours_[gone], {})) {
      const auto entry = entries_.find(std::minmax(gone, other));
      RegionBorder border = entry->second.border;
      ranks_.erase({-entry->second.share, entry->first});
      entries_.erase(entry);
      neighbours_[other].erase(gone);
      if (other == kept)
        continue;
      std::tie(border.a, border.b) = std::minmax(kept, other);
      add(border);
    }
    for (const std::int32_t other : neighbours_[kept]) {
      const auto entry = entries_.find(std::minmax(kept, other));
      rank(entry->first, entry->second);
    }
  }

private:
  struct Entry {
    RegionBorder border;
    double share = 0.0; ///< 0: not ranked
  };

  void
  add(const RegionBorder& border)
  {
    RegionBorder& sum = entries_[{border.a, border.b}].border;
    sum.a = border.a;
    sum.b = border.b;
    sum.border_area += border.border_area;
    sum.opening_area += border.opening_area;
    sum.opening_run += border.opening_run;
    sum.open_area += border.open_area;
    neighbours_[border.a].insert(border.b);
    neighbours_[border.b].insert(border.a);
  }

  double
  shareOf(const RegionBorder& border) const
  {
    const bool below_lintel =
        border.open_area < options_.open_height * border.opening_area;
    const bool is_door = border.opening_run.norm() < door_width_;
    const double part =
        border.open_area /
        std::max(border.border_area, std::min(section_[border.a], section_[border.b]));
    return below_lintel || (is_door && part <= options_.door_share) ? 0.0 : part;
  }

  void
  rank(const RegionPair& pair, Entry& entry)
  {
    ranks_.erase({-entry.share, pair});
    const double share = shareOf(entry.border);
    entry.share = share > options_.open_share ? share : 0.0;
    if (entry.share > 0.0)
      ranks_.insert({-entry.share, pair});
  }

  const MergeOptions& options_;
  double door_width_;
  std::vector<double> section_;
  std::vector<std::set<std::int32_t>> neighbours_;
  std::map<RegionPair, Entry> entries_;
  std::set<std::pair<double, RegionPair>> ranks_; // the greatest share first
};

} // namespace

std::vector<RegionBorder>
regionBorders(const BorderMap& map)
{
  const auto& labels = map.labels;
  const double size = map.occupancy.voxel_size;
  const auto ny = static_cast<std::size_t>(labels.ny);
  std::map<RegionPair, RegionBorder> borders;
  const auto add = [&](std::size_t p, std::size_t q, const Section& section) {
    RegionBorder& border = borders[std::minmax(labels.values[p], labels.values[q])];
    border.border_area += size * size * section.height;
    border.open_area += size * size * section.open;
    if (section.open * size >= passage_height) {
      border.opening_area += size * size * section.height;
      border.opening_run[p / ny == q / ny] += size;
    }
  };
  walkBorders(map, Between::Walls, add);

  std::vector<RegionBorder> result;
  for (auto& [pair, border] : borders) {
    std::tie(border.a, border.b) = pair;
    result.push_back(border);
  }
  return result;
}

std::vector<RegionOpening>
regionOpenings(const BorderMap& map)
{
  constexpr double min_width = 0.3; // metres; nobody passes a narrower gap
  const auto& labels = map.labels;
  const double size = map.occupancy.voxel_size;
  const auto ny = static_cast<std::size_t>(labels.ny);
  std::map<RegionPair, std::vector<OpenPiece>> pieces;
  const auto add = [&](std::size_t p, std::size_t q, const Section& section) {
    if (section.open * size < passage_height)
      return;
    OpenPiece piece;
    piece.x = 0.5 * static_cast<double>(p / ny + q / ny) + 0.5;
    piece.y = 0.5 * static_cast<double>(p % ny + q % ny) + 0.5;
    piece.across_x = p / ny != q / ny;
    piece.open = section.open;
    piece.rise = section.rise;
    pieces[std::minmax(labels.values[p], labels.values[q])].push_back(piece);
  };
  walkBorders(map, Between::Passage, add);

  std::vector<RegionOpening> openings;
  for (const auto& [pair, of_pair] : pieces)
    for (const auto& group : connectedPieces(of_pair)) {
      RegionOpening opening = joinPieces(group, size);
      std::tie(opening.a, opening.b) = pair;
      if (opening.width > min_width - 1e-9)
        openings.push_back(opening);
    }
  return openings;
}

std::vector<std::int32_t>
mergeOpenRegions(const std::vector<RegionBorder>& borders,
                 const std::vector<double>& section,
                 const MergeOptions& options,
                 double door_width,
                 const StayApart& stay_apart)
{
  OpenBorders open(borders, section, options, door_width);
  std::vector<std::vector<std::int32_t>> regions_of(section.size()); // of each space
  for (std::size_t i = 0; i < section.size(); ++i)
    regions_of[i] = {static_cast<std::int32_t>(i)};
  while (const auto widest = open.widest()) {
    const auto [kept, gone] = *widest;
    auto &regions = regions_of[kept], &others = regions_of[gone];
    if (stay_apart && stay_apart(regions, others)) {
      open.keepApart(*widest);
      continue;
    }
    open.join(kept, gone);
    const auto count = static_cast<std::ptrdiff_t>(regions.size());
    regions.insert(regions.end(), others.begin(), others.end());
    std::inplace_merge(regions.begin(), regions.begin() + count, regions.end());
    others.clear();
  }
  std::vector<std::int32_t> label(section.size());
  for (std::size_t space = 0; space < regions_of.size(); ++space)
    for (const auto region : regions_of[space])
      label[region] = static_cast<std::int32_t>(space);
  return label;
}

std::vector<std::int32_t>
mergeNiches(const std::vector<RegionOpening>& openings,
            std::vector<double> area,
            std::vector<double> volume)
{
  constexpr double all_width = 0.85; // of the side of a square as large
  constexpr double least_rise = 0.1; // of the ceiling, metres
  std::vector<std::int32_t> room_of(area.size());
  std::iota(room_of.begin(), room_of.end(), 0);
  const auto height = [&](std::int32_t region) {
    return volume[region] / area[region];
  };
  for (bool has_joined = true; has_joined;) {
    has_joined = false;
    for (const RegionOpening& opening : openings) {
      auto niche = room_of[opening.a], room = room_of[opening.b];
      if (niche == room)
        continue;
      if (height(niche) < height(room))
        std::swap(niche, room);
      if (area[niche] > least_room || height(niche) < height(room) + least_rise ||
          opening.width < all_width * std::sqrt(area[niche]))
        continue;
      area[room] += area[niche];
      volume[room] += volume[niche];
      std::replace(room_of.begin(), room_of.end(), niche, room);
      has_joined = true;
    }
  }
  return room_of;
}

} // namespace pcl::indoor
