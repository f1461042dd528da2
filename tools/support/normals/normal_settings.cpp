/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "normals/normal_settings.h"

#include "files/tool_error.h"
#include "text/pcl_errors.h"

#include <pcl/features/station_orientation.h>

namespace pcl::indoor::tool {
namespace {

void
addOptions(OptionParser& parser, NormalSettings& settings)
{
  parser.positional("input", settings.input, std::string(scan_files) + ", metres")
      .positional(
          "output.pcd|ply",
          settings.output,
          "the input with normal_x, normal_y, normal_z, curvature; NaN where no "
          "plane was found")
      .number("-radius",
              settings.radius,
              "of the neighbourhood; 0 = from the resolution of the cloud",
              "m",
              Range::atLeast(0))
      .number("-k",
              settings.neighbors,
              "neighbours instead of a radius; 0 = by radius",
              "points",
              Range::atLeast(0))
      .text("-orientation",
            settings.orientation,
            "which way normals are turned: to the station that measured the point, or "
            "the file's sensor origin where that is not known, as their "
            "neighbours, or to the free space between the surfaces",
            {"viewpoint", "graph", "free_space"})
      .text("-sampling",
            settings.sampling,
            "how triples of neighbours are picked; cubes: evenly where density varies",
            {"cubes", "points"})
      .number("-bin_angle",
              settings.options.bin_angle_degrees,
              "size of a bin of the accumulators",
              "degrees",
              Range::between(1, 45))
      .number("-triples",
              settings.options.triples,
              "largest number of triples per point; 0 = from the confidence bounds")
      .flag("-no_refinement",
            settings.no_refinement,
            "take the mean of the votes instead of fitting a plane")
      .number("-seed", settings.options.seed, "seed of the triples")
      .number("-threads", settings.threads, "threads, 0 = automatic")
      .expert({"-sampling", "-bin_angle", "-triples", "-no_refinement", "-seed"});
  addOption(parser, settings.coordinates);
  addOption(parser, settings.columns);
  addOptions(parser, settings.stations);
}

} // namespace

OptionParser
normalParser(NormalSettings& settings)
{
  OptionParser parser("pcl_hough_normals",
                      "Estimate surface normals that stay sharp at edges with "
                      "pcl::HoughNormalEstimation; adds them as fields.");
  addOptions(parser, settings);
  return parser;
}

void
requireFitting(const NormalSettings& settings)
{
  if (settings.radius > 0 && settings.neighbors > 0)
    throw ToolError("-radius and -k: give one of them only");
}

PointCloud<Normal>
estimatedNormals(const NormalSettings& settings, const CloudFile& file)
{
  auto options = settings.options;
  options.refine = !settings.no_refinement;
  options.sampling =
      settings.sampling == "cubes" ? HoughSampling::Cubes : HoughSampling::Points;
  HoughNormalEstimation<PointXYZ> estimation(settings.threads);
  estimation.setOptions(options);
  estimation.setOrientation(settings.orientation == "graph" ? NormalOrientation::Graph
                            : settings.orientation == "viewpoint"
                                ? NormalOrientation::Viewpoint
                                : NormalOrientation::FreeSpace);
  estimation.setInputCloud(file.points);
  estimation.setRadiusSearch(settings.radius);
  estimation.setKSearch(settings.neighbors);
  PointCloud<Normal> normals;
  const auto problem = problemOf([&] { estimation.compute(normals); });
  if (normals.empty())
    throw ToolError(file.path + ": " + problem);
  if (const auto stations = stationsOfPoints(file);
      settings.orientation == "viewpoint" && !stations.empty())
    orientTowardsStations(*file.points, stationPositions(file), stations, normals);
  return normals;
}

} // namespace pcl::indoor::tool
