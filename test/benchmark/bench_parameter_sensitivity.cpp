/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

/* Which edges of the supervoxel graph the removal of non-convex points takes away, by
 * curvature threshold and ratio threshold (Sec. 4.3.4, Fig. 4.14).
 *
 *   bench_parameter_sensitivity plot.png room.pcd ...
 *
 * Rooms have the part of each point in the field label, 0 = not judged. */

#include "pictures/line_plot.h"

#include <pcl/common/point_tests.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/object_segmentation.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>

using namespace pcl::indoor;

namespace {

const std::vector<float> curvature_thresholds{
    0.0025f, 0.005f, 0.01f, 0.015f, 0.02f, 0.025f, 0.03f, 0.04f, 0.05f, 0.07f, 0.1f};
const std::vector<float> ratio_thresholds{0.1f, 0.2f, 0.5f, 1.0f};

struct Room {
  ObjectSegmentationInput input;
  std::vector<std::uint32_t> labels; ///< one per point
};

bool
loadRoom(const std::string& path, Room& room)
{
  pcl::PointCloud<pcl::PointXYZL> cloud;
  if (pcl::io::loadPCDFile(path, cloud) < 0)
    return false;
  for (const auto& point : cloud)
    if (pcl::isFinite(point)) {
      room.input.points.push_back(point.getVector3fMap() - cloud[0].getVector3fMap());
      room.labels.push_back(point.label);
    }
  return true;
}

/** The most frequent label of each supervoxel's points, 0 left out. */
std::vector<std::uint32_t>
labelsOfSupervoxels(const ObjectSegmentation& result,
                    const std::vector<std::uint32_t>& labels)
{
  std::vector<std::map<std::uint32_t, std::size_t>> counts(result.supervoxels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto voxel = result.scene.voxels.cells.cell_of_point[i];
    const auto supervoxel = result.supervoxels.label_of_voxel[voxel];
    if (supervoxel != Supervoxels::none && labels[i] != 0)
      ++counts[supervoxel][labels[i]];
  }
  std::vector<std::uint32_t> majority;
  for (const auto& count : counts) {
    std::pair<std::size_t, std::uint32_t> best(0, 0);
    for (const auto& entry : count)
      best = std::max(best, {entry.second, entry.first});
    majority.push_back(best.second);
  }
  return majority;
}

/** Edges within an object, and between two. */
struct EdgeCount {
  std::size_t intra = 0, inter = 0;
};

/** Count the edges of the graph of all supervoxels that are left: those over which
 * voxels touch that were not removed. */
EdgeCount
countEdges(const ObjectSegmentation& graph,
           const std::vector<std::uint32_t>& labels,
           const std::vector<std::uint8_t>& removed)
{
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  const auto& neighbors = graph.scene.voxels.neighbors;
  for (std::uint32_t v = 0; v < graph.scene.voxels.size(); ++v)
    for (const auto other : neighbors.of(v)) {
      const auto a = graph.supervoxels.label_of_voxel[v];
      const auto b = graph.supervoxels.label_of_voxel[other];
      if (a < b && b != Supervoxels::none && !removed[v] && !removed[other])
        edges.emplace(a, b);
      else if (b < a && a != Supervoxels::none && !removed[v] && !removed[other])
        edges.emplace(b, a);
    }
  EdgeCount count;
  for (const auto& edge : edges)
    if (labels[edge.first] != 0 && labels[edge.second] != 0)
      ++(labels[edge.first] == labels[edge.second] ? count.intra : count.inter);
  return count;
}

/** Removed edges of all rooms, in percent. */
struct Shares {
  double intra = 0, inter = 0;
};

std::vector<std::vector<Shares>>
measure(const std::vector<Room>& rooms)
{
  std::vector<std::vector<EdgeCount>> left(
      ratio_thresholds.size(), std::vector<EdgeCount>(curvature_thresholds.size()));
  EdgeCount all;
  for (const auto& room : rooms) {
    ObjectSegmentationOptions options;
    options.curvature_threshold = 1.0f / 3; // nothing is removed
    const auto graph = segmentObjects(room.input, options);
    const auto labels = labelsOfSupervoxels(graph, room.labels);
    const auto before = countEdges(graph, labels, graph.removed);
    all.intra += before.intra;
    all.inter += before.inter;
    for (std::size_t r = 0; r < ratio_thresholds.size(); ++r)
      for (std::size_t c = 0; c < curvature_thresholds.size(); ++c) {
        options.curvature_threshold = curvature_thresholds[c];
        options.ratio_threshold = ratio_thresholds[r];
        const auto count =
            countEdges(graph, labels, segmentObjects(room.input, options).removed);
        left[r][c].intra += count.intra;
        left[r][c].inter += count.inter;
      }
  }
  std::printf(
      "%zu edges within objects, %zu between objects\n\n", all.intra, all.inter);
  const auto percent = [](std::size_t part, std::size_t whole) {
    return whole > 0
               ? 100 - 100 * static_cast<double>(part) / static_cast<double>(whole)
               : 0;
  };
  std::vector<std::vector<Shares>> shares;
  for (const auto& of_ratio : left) {
    shares.emplace_back();
    for (const auto& count : of_ratio)
      shares.back().push_back(
          {percent(count.intra, all.intra), percent(count.inter, all.inter)});
  }
  return shares;
}

void
printTable(const std::vector<std::vector<Shares>>& shares)
{
  std::printf("| theta_t |");
  for (const float ratio : ratio_thresholds)
    std::printf(" alpha_t %g: inter | intra |", ratio);
  std::printf("\n| --- |");
  for (std::size_t r = 0; r < ratio_thresholds.size(); ++r)
    std::printf(" ---: | ---: |");
  for (std::size_t c = 0; c < curvature_thresholds.size(); ++c) {
    std::printf("\n| %g |", curvature_thresholds[c]);
    for (const auto& of_ratio : shares)
      std::printf(" %.1f | %.1f |", of_ratio[c].inter, of_ratio[c].intra);
  }
  std::printf("\n");
}

void
savePlot(const std::string& path, const std::vector<std::vector<Shares>>& shares)
{
  const tool::Color colors[] = {
      {31, 119, 180}, {214, 39, 40}, {44, 160, 44}, {148, 103, 189}};
  std::vector<tool::Curve> curves;
  for (std::size_t r = 0; r < shares.size(); ++r) {
    char name[40];
    std::snprintf(name, sizeof(name), "between, alpha %g", ratio_thresholds[r]);
    tool::Curve inter{name, {}, colors[r]};
    std::snprintf(name, sizeof(name), "within, alpha %g", ratio_thresholds[r]);
    tool::Curve intra{name, {}, colors[r], true};
    for (std::size_t c = 0; c < curvature_thresholds.size(); ++c) {
      inter.points.emplace_back(curvature_thresholds[c], shares[r][c].inter);
      intra.points.emplace_back(curvature_thresholds[c], shares[r][c].intra);
    }
    curves.push_back(inter);
    curves.push_back(intra);
  }
  tool::LinePlot plot(0.1, 100);
  tool::savePng(path,
                plot.draw("Edges removed between and within objects",
                          "curvature threshold",
                          "%",
                          curves,
                          0.02,
                          20));
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 3) {
    std::fprintf(stderr, "Syntax is: %s plot.png room.pcd ...\n", argv[0]);
    return EXIT_FAILURE;
  }
  std::vector<Room> rooms(argc - 2);
  for (int i = 2; i < argc; ++i)
    if (!loadRoom(argv[i], rooms[i - 2])) {
      std::fprintf(stderr, "%s: cannot be read\n", argv[i]);
      return EXIT_FAILURE;
    }
  const auto shares = measure(rooms);
  printTable(shares);
  savePlot(argv[1], shares);
  return EXIT_SUCCESS;
}
