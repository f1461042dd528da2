/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

/* Which edges of the supervoxel graph the removal of non-convex points takes away, by
 * curvature threshold and ratio threshold (Sec. 4.3.4, Fig. 4.14).
 *
 *   bench_parameter_sensitivity plot.png [-points|-labelled] room.pcd ...
 *
 * Rooms have the part of each point in the field label, 0 = not judged. On voxels with
 * the default options; with -points on points with those of the thesis, but no planes
 * are taken off; with -labelled the same on the labelled points alone, as the thesis's
 * scenes are. */

#include "pictures/line_plot.h"
#include "pictures/svg_raster.h"

#include "objects/object_steps.h"

#include <pcl/common/point_tests.h>
#include <pcl/filters/non_convex_points.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/thesis.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>
#include <string>

using namespace pcl::indoor;

namespace {

const std::vector<float> curvature_thresholds{
    0.0025f, 0.005f, 0.01f, 0.015f, 0.02f, 0.025f, 0.03f, 0.04f, 0.05f, 0.07f, 0.1f};
const std::vector<float> ratio_thresholds{0.1f, 0.2f, 0.5f, 1.0f};

struct LabelledRoom {
  ObjectSegmentationInput input;
  std::vector<std::uint32_t> labels; ///< one per point
};

bool
loadRoom(const std::string& path, bool labelled_alone, LabelledRoom& room)
{
  pcl::PointCloud<pcl::PointXYZL> cloud;
  if (pcl::io::loadPCDFile(path, cloud) < 0)
    return false;
  for (const auto& point : cloud)
    if (pcl::isFinite(point) && (point.label != 0 || !labelled_alone)) {
      room.input.points.push_back(point.getVector3fMap() - cloud[0].getVector3fMap());
      room.labels.push_back(point.label);
    }
  return true;
}

/** The most frequent label of each supervoxel's points, 0 left out. */
std::vector<std::uint32_t>
labelsOfSupervoxels(const ObjectSteps& result, const std::vector<std::uint32_t>& labels)
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

/** Supervoxels of what was not removed, and the cells of R_voxel that they are in. */
struct TouchingCells {
  std::vector<std::uint32_t> cell_of_voxel; ///< of each voxel, or point, of the scene
  Adjacency neighbors;                      ///< of cells
};

TouchingCells
touchingCells(const ObjectScene& scene, bool on_points)
{
  if (on_points) {
    const auto cells = surfaceVoxels(scene.points, {}, scene.voxel_size);
    return {cells.cells.cell_of_point, cells.neighbors};
  }
  std::vector<std::uint32_t> own(scene.voxels.size());
  std::iota(own.begin(), own.end(), 0u);
  return {own, scene.voxels.neighbors};
}

/** Count the edges of the graph of all supervoxels that are left: those that have
 * voxels, or points, that were not removed, in one cell or in two that touch. */
EdgeCount
countEdges(const ObjectSteps& graph,
           const TouchingCells& cells,
           const std::vector<std::uint32_t>& labels,
           const std::vector<std::uint8_t>& removed)
{
  std::vector<std::set<std::uint32_t>> in_cell(cells.neighbors.offsets.size() - 1);
  for (std::size_t v = 0; v < removed.size(); ++v)
    if (!removed[v] && graph.supervoxels.label_of_voxel[v] != Supervoxels::none)
      in_cell[cells.cell_of_voxel[v]].insert(graph.supervoxels.label_of_voxel[v]);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  const auto connect = [&](std::uint32_t one, std::uint32_t other) {
    for (const auto a : in_cell[one])
      for (const auto b : in_cell[other])
        if (a != b)
          edges.emplace(std::min(a, b), std::max(a, b));
  };
  for (std::uint32_t cell = 0; cell < in_cell.size(); ++cell) {
    connect(cell, cell);
    for (const auto other : cells.neighbors.of(cell))
      connect(cell, other);
  }
  EdgeCount count;
  for (const auto& edge : edges)
    if (labels[edge.first] != 0 && labels[edge.second] != 0)
      ++(labels[edge.first] == labels[edge.second] ? count.intra : count.inter);
  return count;
}

/** The thesis's options without RANSAC, or ours in their place. */
thesis::ObjectOptions
optionsFor(bool on_points)
{
  auto options = on_points ? thesisOptions() : thesis::ObjectOptions();
  if (on_points)
    options.on_points->ransac_share = 0;
  return options;
}

/** Ours, or the thesis's way on points. */
ObjectSegmentation
segmented(const LabelledRoom& room, const thesis::ObjectOptions& options)
{
  return options.on_points ? thesis::segmentObjects(room.input, options)
                           : segmentObjects(room.input, options.shared);
}

/** What is removed with the thresholds of the options: Eq. (4.2) on the points of a
 * graph, or the voxels' own way. */
std::vector<std::uint8_t>
removedWith(const thesis::ObjectOptions& options,
            const ObjectSteps& graph,
            const LabelledRoom& room)
{
  if (!options.on_points)
    return stepsOf(segmented(room, options)).removed;
  const auto& surface = graph.scene.voxels;
  NonConvexityOptions removal;
  removal.radius = options.on_points->removal_radius;
  removal.curvature_threshold = options.shared.curvature_threshold;
  removal.ratio_threshold = options.shared.ratio_threshold;
  return nonConvexPoints(
      surface.centroids, surface.normals, surface.curvatures, removal);
}

double
percentLess(std::size_t after, std::size_t before)
{
  return before > 0
             ? 100 - 100 * static_cast<double>(after) / static_cast<double>(before)
             : 0;
}

/** Removed edges of all rooms, in percent. */
struct Shares {
  double intra = 0, inter = 0;
};

std::vector<std::vector<Shares>>
measure(const std::vector<LabelledRoom>& rooms, bool on_points)
{
  std::vector<std::vector<EdgeCount>> left(
      ratio_thresholds.size(), std::vector<EdgeCount>(curvature_thresholds.size()));
  EdgeCount all;
  for (const auto& room : rooms) {
    auto options = optionsFor(on_points);
    options.shared.curvature_threshold = 1.0f / 3; // nothing is removed
    const auto segmentation = segmented(room, options);
    const auto& graph = stepsOf(segmentation);
    const auto labels = labelsOfSupervoxels(graph, room.labels);
    const auto cells = touchingCells(graph.scene, on_points);
    const auto before = countEdges(graph, cells, labels, graph.removed);
    all.intra += before.intra;
    all.inter += before.inter;
    for (std::size_t r = 0; r < ratio_thresholds.size(); ++r)
      for (std::size_t c = 0; c < curvature_thresholds.size(); ++c) {
        options.shared.curvature_threshold = curvature_thresholds[c];
        options.shared.ratio_threshold = ratio_thresholds[r];
        const auto count =
            countEdges(graph, cells, labels, removedWith(options, graph, room));
        left[r][c].intra += count.intra;
        left[r][c].inter += count.inter;
      }
  }
  std::printf(
      "%zu edges within objects, %zu between objects\n\n", all.intra, all.inter);
  std::vector<std::vector<Shares>> shares;
  for (const auto& of_ratio : left) {
    shares.emplace_back();
    for (const auto& count : of_ratio)
      shares.back().push_back(
          {percentLess(count.intra, all.intra), percentLess(count.inter, all.inter)});
  }
  return shares;
}

/** The same by numbers: how many edges fewer the graph has that is made anew of what
 * was not removed. Its supervoxels are others. */
void
printGraphsAnew(const std::vector<LabelledRoom>& rooms, float ratio_threshold)
{
  const auto count = [&](float curvature_threshold) {
    EdgeCount all;
    for (const auto& room : rooms) {
      auto options = optionsFor(true);
      options.shared.curvature_threshold = curvature_threshold;
      options.shared.ratio_threshold = ratio_threshold;
      const auto segmentation = segmented(room, options);
      const auto& graph = stepsOf(segmentation);
      const auto labels = labelsOfSupervoxels(graph, room.labels);
      for (const auto& edge : graph.edges)
        if (labels[edge.source] != 0 && labels[edge.target] != 0)
          ++(labels[edge.source] == labels[edge.target] ? all.intra : all.inter);
    }
    return all;
  };
  const auto before = count(1.0f / 3);
  std::printf("\nGraphs made anew, alpha_t %g: %zu edges within, %zu between\n",
              ratio_threshold,
              before.intra,
              before.inter);
  for (const float threshold : {0.01f, 0.02f, 0.025f, 0.03f, 0.05f}) {
    const auto after = count(threshold);
    std::printf("theta_t %g: inter %.1f %%, intra %.1f %% fewer\n",
                threshold,
                percentLess(after.inter, before.inter),
                percentLess(after.intra, before.intra));
  }
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
  std::vector<tool::Curve> curves;
  for (std::size_t r = 0; r < shares.size(); ++r) {
    char name[40];
    std::snprintf(name, sizeof(name), "Between, alpha %g", ratio_thresholds[r]);
    tool::Curve inter{name, {}, tool::lineColor(r)};
    std::snprintf(name, sizeof(name), "Within, alpha %g", ratio_thresholds[r]);
    tool::Curve intra{name, {}, tool::lineColor(r), true};
    for (std::size_t c = 0; c < curvature_thresholds.size(); ++c) {
      inter.points.emplace_back(curvature_thresholds[c], shares[r][c].inter);
      intra.points.emplace_back(curvature_thresholds[c], shares[r][c].intra);
    }
    curves.push_back(inter);
    curves.push_back(intra);
  }
  const tool::PlotAxes axes{"Edges removed between and within objects",
                            "Curvature threshold",
                            "Edges removed, %",
                            0.1,
                            100.0,
                            0.02,
                            20.0};
  tool::savePictures({{path, tool::linePlot(axes, curves).str()}});
}

} // namespace

int
main(int argc, char** argv)
{
  const std::string mode = argc > 2 ? argv[2] : "";
  const bool labelled_alone = mode == "-labelled";
  const bool on_points = labelled_alone || mode == "-points";
  const int first = on_points ? 3 : 2;
  if (argc <= first) {
    std::fprintf(
        stderr, "Syntax is: %s plot.png [-points|-labelled] room.pcd ...\n", argv[0]);
    return EXIT_FAILURE;
  }
  std::vector<LabelledRoom> rooms(static_cast<std::size_t>(argc - first));
  for (int i = first; i < argc; ++i)
    if (!loadRoom(
            argv[i], labelled_alone, rooms[static_cast<std::size_t>(i - first)])) {
      std::fprintf(stderr, "%s: cannot be read\n", argv[i]);
      return EXIT_FAILURE;
    }
  const auto shares = measure(rooms, on_points);
  printTable(shares);
  savePlot(argv[1], shares);
  if (on_points)
    printGraphsAnew(rooms, 0.2f);
  return EXIT_SUCCESS;
}
