/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

/* Rooms by simple methods beside ours and the thesis's: a table with a row for each.
 *
 *   bench_room_baselines scan.pcd ... [-truth_field F] [-thesis]
 *
 * k-means: columns of 20 cm by their places, weighted by their points; k is the true
 * number of rooms. DBSCAN: the thesis's way with DBSCAN* at its best distance. Ceiling:
 * connected pieces of the ceiling, which walls part; each point has the piece nearest
 * to its column. Each runs in a process of its own. Storeys are not told apart. */

#include "command_line/options.h"
#include "comparison/measured_segmentation.h"
#include "files/cloud_file.h"
#include "rooms/map/ceiling_slab.h"
#include "rooms/space/occupancy_grid.h"

#include <pcl/segmentation/segmentation_metrics.h>
#include <pcl/segmentation/thesis.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <random>
#include <set>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

using Points = std::vector<Eigen::Vector3f>;
constexpr double dbscan_distance = 0.25; // best on ten floor plans
constexpr double column_size = 0.2;      // metres
constexpr double ceiling_voxel = 0.1;    // metres
constexpr double smallest_piece = 1.0;   // of the ceiling, m^2

struct Scan {
  std::string path;
  Points points;
  SegmentLabels truth;
};

Scan
loadScan(const std::string& path, const std::string& field)
{
  const auto file = loadCloud(path);
  Scan scan{path, {}, {}};
  const auto labels = readLabels(file, field);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (std::isfinite((*file.points)[i].x)) {
      scan.points.push_back((*file.points)[i].getVector3fMap());
      scan.truth.push_back(labels[i]);
    }
  return scan;
}

SegmentLabels
byThesis(const Scan& scan, const thesis::RoomOptions& options)
{
  return thesis::segmentBuilding(scan.points, options).point_labels;
}

std::size_t
nearest(const std::vector<Eigen::Vector2d>& centres, const Eigen::Vector2d& place)
{
  std::size_t best = 0;
  for (std::size_t k = 1; k < centres.size(); ++k)
    if ((centres[k] - place).squaredNorm() < (centres[best] - place).squaredNorm())
      best = k;
  return best;
}

SegmentLabels
byMeans(const Scan& scan)
{
  std::set<std::uint32_t> rooms(scan.truth.begin(), scan.truth.end());
  rooms.erase(0);
  std::map<std::pair<int, int>, double> columns; // points in each
  const auto columnOf = [](const Eigen::Vector3f& point) {
    return std::make_pair(static_cast<int>(std::floor(point.x() / column_size)),
                          static_cast<int>(std::floor(point.y() / column_size)));
  };
  const auto placeOf = [](const std::pair<int, int>& column) {
    return Eigen::Vector2d(column.first, column.second);
  };
  for (const auto& point : scan.points)
    ++columns[columnOf(point)];
  std::mt19937 random(1);
  std::vector<Eigen::Vector2d> centres; // k-means++
  std::vector<double> weights(columns.size());
  while (centres.size() < rooms.size()) {
    std::size_t i = 0;
    for (const auto& [column, count] : columns) {
      const auto place = placeOf(column);
      weights[i++] =
          centres.empty()
              ? count
              : count * (centres[nearest(centres, place)] - place).squaredNorm();
    }
    std::discrete_distribution<std::size_t> draw(weights.begin(), weights.end());
    centres.push_back(placeOf(
        std::next(columns.begin(), static_cast<std::ptrdiff_t>(draw(random)))->first));
  }
  for (int round = 0; round < 50; ++round) {
    std::vector<Eigen::Vector2d> sums(centres.size(), Eigen::Vector2d::Zero());
    std::vector<double> counts(centres.size(), 0);
    for (const auto& [column, count] : columns) {
      const auto k = nearest(centres, placeOf(column));
      sums[k] += count * placeOf(column);
      counts[k] += count;
    }
    for (std::size_t k = 0; k < centres.size(); ++k)
      if (counts[k] > 0)
        centres[k] = sums[k] / counts[k];
  }
  SegmentLabels labels;
  for (const auto& point : scan.points)
    labels.push_back(
        static_cast<std::uint32_t>(nearest(centres, placeOf(columnOf(point))) + 1));
  return labels;
}

/** Number the connected pieces of the ceiling that are large enough, from 1. */
PixelMap<int>
piecesOfCeiling(const PixelMap<int>& ceiling)
{
  PixelMap<int> pieces{ceiling.nx, ceiling.ny, std::vector<int>(ceiling.size(), 0)};
  std::vector<std::size_t> members;
  int count = 0;
  for (std::size_t seed = 0; seed < ceiling.size(); ++seed) {
    if (ceiling.values[seed] < 0 || pieces.values[seed] != 0)
      continue;
    members.assign(1, seed);
    pieces.values[seed] = ++count;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const int x = static_cast<int>(members[k]) / ceiling.ny,
                y = static_cast<int>(members[k]) % ceiling.ny;
      for (const auto& [u, v] : {std::make_pair(x - 1, y),
                                 std::make_pair(x + 1, y),
                                 std::make_pair(x, y - 1),
                                 std::make_pair(x, y + 1)}) {
        if (u < 0 || v < 0 || u >= ceiling.nx || v >= ceiling.ny)
          continue;
        const auto other = ceiling.index(u, v);
        if (pieces.values[other] == 0 && ceiling.values[other] >= 0 &&
            std::abs(ceiling.values[other] - ceiling.values[members[k]]) <= 1) {
          pieces.values[other] = count;
          members.push_back(other);
        }
      }
    }
    if (static_cast<double>(members.size()) * ceiling_voxel * ceiling_voxel <
        smallest_piece) {
      for (const auto member : members)
        pieces.values[member] = -1;
      --count;
    }
  }
  return pieces;
}

/** Give each pixel without a piece the piece that is fewest steps away. */
void
spread(PixelMap<int>& pieces)
{
  std::queue<std::size_t> open;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (pieces.values[i] > 0)
      open.push(i);
  for (; !open.empty(); open.pop()) {
    const int x = static_cast<int>(open.front()) / pieces.ny,
              y = static_cast<int>(open.front()) % pieces.ny;
    for (const auto& [u, v] : {std::make_pair(x - 1, y),
                               std::make_pair(x + 1, y),
                               std::make_pair(x, y - 1),
                               std::make_pair(x, y + 1)})
      if (u >= 0 && v >= 0 && u < pieces.nx && v < pieces.ny && pieces.at(u, v) <= 0) {
        pieces.at(u, v) = pieces.values[open.front()];
        open.push(pieces.index(u, v));
      }
  }
}

SegmentLabels
byCeiling(const Scan& scan)
{
  OccupancyGridOptions options;
  options.voxel_size = ceiling_voxel;
  const auto building = occupancyGrid(scan.points, options);
  const auto& grid = building.grid;
  auto ceiling = ceilingLayers(grid, {0, grid.shape.nz}, {});
  for (int x = 0; x < ceiling.nx; ++x)
    for (int y = 0; y < ceiling.ny; ++y) {
      const int z = ceiling.at(x, y);
      // a wall goes on below the ceiling; where nothing was seen there is no ceiling
      if (z < 2 || z >= grid.shape.nz || !grid.at(x, y, z) || grid.at(x, y, z - 2))
        ceiling.at(x, y) = -1;
    }
  auto pieces = piecesOfCeiling(ceiling);
  spread(pieces);
  SegmentLabels labels;
  for (const auto cell : building.cells)
    labels.push_back(cell < 0 ? 0
                              : static_cast<std::uint32_t>(
                                    std::max(pieces.values[cell / grid.shape.nz], 0)));
  return labels;
}

struct Method {
  std::string name;
  std::function<SegmentLabels(const Scan&)> segment;
};

std::vector<Method>
methods(bool with_thesis)
{
  thesis::RoomOptions dbscan;
  dbscan.shared.voxel_size = dbscan.shared.interior.voxel_size = 0.2;
  dbscan.field.dbscan_distance = dbscan_distance;
  std::vector<Method> all{
      {"k-means, true k", byMeans},
      {"DBSCAN on the field map",
       [dbscan](const Scan& scan) { return byThesis(scan, dbscan); }},
      {"ceiling's pieces", byCeiling},
      {"ours",
       [](const Scan& scan) { return segmentBuilding(scan.points).point_labels; }}};
  if (with_thesis)
    all.push_back({"thesis", [](const Scan& scan) {
                     return byThesis(scan, thesisRoomOptions());
                   }});
  return all;
}

void
compare(const std::vector<std::string>& paths,
        const std::string& field,
        bool with_thesis)
{
  std::vector<Scan> scans;
  for (const auto& path : paths)
    scans.push_back(loadScan(path, field));
  std::printf(
      "| method | rooms | right | recall | precision | PQ | mean IoU | ARI | s | "
      "MB |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: "
      "|\n");
  for (const auto& method : methods(with_thesis)) {
    ObjectScore objects;
    double right = 0, rooms = 0, iou = 0, index = 0, seconds = 0, megabytes = 0;
    for (const auto& scan : scans) {
      const auto found = segmentMeasured([&] { return method.segment(scan); });
      if (!found.problem.empty())
        throw ToolError(scan.path + ": " + found.problem);
      const auto overlaps = countOverlaps(scan.truth, found.labels);
      const auto score = scoreDetections(overlaps);
      objects += scoreObjects(scan.truth, found.labels, 1);
      rooms += static_cast<double>(score.true_count);
      right += static_cast<double>(score.right_count);
      iou += score.mean_iou * static_cast<double>(score.true_count);
      index += adjustedRandIndex(overlaps) / static_cast<double>(scans.size());
      seconds += found.seconds / static_cast<double>(scans.size());
      megabytes = std::max(megabytes, found.megabytes);
    }
    std::printf(
        "| %s | %.0f | %.0f (%.1f %%) | %.3f | %.3f | %.3f | %.3f | %.3f | %.1f | "
        "%.0f |\n",
        method.name.c_str(),
        rooms,
        right,
        100 * right / rooms,
        objects.recall(),
        objects.precision(),
        objects.panopticQuality(),
        iou / rooms,
        index,
        seconds,
        megabytes);
    std::fflush(stdout);
  }
}

} // namespace

int
main(int argc, char** argv)
{
  std::vector<std::string> scans;
  std::string field = "label";
  bool with_thesis = false;
  OptionParser parser("bench_room_baselines",
                      "Segment scans into rooms by simple methods, by ours and by the "
                      "thesis's, and compare them.");
  parser.positionals("scan.pcd", scans, "scans of one storey, metres, z up")
      .text("-truth_field", field, "room of a point, 0 = not judged")
      .flag("-thesis", with_thesis, "also the thesis's method, which takes minutes");
  return parser.run(argc, argv, [&](Progress&) { compare(scans, field, with_thesis); });
}
