/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "command_line/cloud_options.h"
#include "command_line/options.h"
#include "files/cloud_file.h"
#include "files/point_coordinates.h"
#include "text/pcl_errors.h"

#include <pcl/features/hough_normals.h>
#include <pcl/features/station_orientation.h>

#include <algorithm>
#include <cmath>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

using Estimation = pcl::HoughNormalEstimation<pcl::PointXYZ>;

struct Settings {
  std::string input, output;
  double radius = 0;
  int neighbors = 0;
  std::string orientation = "viewpoint", sampling = "cubes";
  HoughNormalOptions options;
  PointCoordinates coordinates;
  TableColumns columns;
  StationChoice stations;
  bool no_refinement = false;
  unsigned threads = 0;
};

void
addOptions(OptionParser& parser, Settings& settings)
{
  parser.positional("input", settings.input, "PCD, PLY or LAS file or table, metres")
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

void
appendNormals(const pcl::PointCloud<pcl::Normal>& normals, pcl::PCLPointCloud2& cloud)
{
  const auto append = [&](const std::string& name, const auto& value) {
    std::vector<float> values;
    for (const auto& normal : normals)
      values.push_back(value(normal));
    appendRealField(cloud, name, values);
  };
  append("normal_x", [](const auto& normal) { return normal.normal_x; });
  append("normal_y", [](const auto& normal) { return normal.normal_y; });
  append("normal_z", [](const auto& normal) { return normal.normal_z; });
  append("curvature", [](const auto& normal) { return normal.curvature; });
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  OptionParser parser("pcl_hough_normals",
                      "Estimate surface normals that stay sharp at edges with "
                      "pcl::HoughNormalEstimation; adds them as fields.");
  addOptions(parser, settings);
  return parser.run(argc, argv, [&](Progress& progress) {
    if (settings.radius > 0 && settings.neighbors > 0)
      throw ToolError("-radius and -k: give one of them only");
    requireWritableCloud(settings.output);
    progress.start("Loading " + settings.input);
    CloudFile file = loadCloud(settings.input, settings.columns);
    choose(settings.stations, file);
    printNotes(file);
    progress.done(std::to_string(file.points->size()) + " points");

    progress.start("Estimating normals");
    settings.options.refine = !settings.no_refinement;
    settings.options.sampling =
        settings.sampling == "cubes" ? HoughSampling::Cubes : HoughSampling::Points;
    Estimation estimation(settings.threads);
    estimation.setOptions(settings.options);
    estimation.setOrientation(settings.orientation == "graph" ? NormalOrientation::Graph
                              : settings.orientation == "viewpoint"
                                  ? NormalOrientation::Viewpoint
                                  : NormalOrientation::FreeSpace);
    estimation.setInputCloud(file.points);
    estimation.setRadiusSearch(settings.radius);
    estimation.setKSearch(settings.neighbors);
    pcl::PointCloud<pcl::Normal> normals;
    const auto problem = problemOf([&] { estimation.compute(normals); });
    if (normals.empty())
      throw ToolError(file.path + ": " + problem);
    if (const auto stations = stationsOfPoints(file);
        settings.orientation == "viewpoint" && !stations.empty())
      orientTowardsStations(*file.points, stationPositions(file), stations, normals);
    const auto found =
        std::count_if(normals.begin(), normals.end(), [](const auto& normal) {
          return std::isfinite(normal.normal_x);
        });
    progress.done(std::to_string(found) + " normals");

    appendNormals(normals, file.cloud);
    settings.coordinates.apply(file, settings.output);
    progress.start("Saving " + settings.output);
    saveCloud(settings.output, file.cloud, file.frame);
    Progress::conclude([&] {
      progress.done();
      progress.summary(settings.output + ": " + std::to_string(found) + " normals");
    });
  });
}
