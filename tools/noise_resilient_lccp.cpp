/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "cloud_file.h"
#include "options.h"

#include <pcl/segmentation/noise_resilient_lccp.h>

#include <algorithm>

using namespace pcl::indoor::tool;
using pcl::indoor::Partition;

int
main(int argc, char** argv)
{
  std::string input, output, partition = "graph", camera = "auto";
  bool ignore_normals = false;
  pcl::indoor::ObjectSegmentationOptions options;

  OptionParser parser("pcl_noise_resilient_lccp",
                      "Segment the scan of a room into objects with "
                      "pcl::NoiseResilientLCCP; adds the field object.");
  parser.positional("input", input, "PCD or PLY file, metres")
      .positional(
          "output.pcd", output, "the input with the field object, 0 = not finite")
      .number("-voxel_resolution",
              options.voxel_size,
              "edge of a voxel",
              "m",
              Range::positive())
      .number("-seed_resolution",
              options.seed_size,
              "distance of supervoxels, at least -voxel_resolution",
              "m",
              Range::positive())
      .text("-partition", partition, "how supervoxels are joined", {"graph", "lccp"})
      .number("-curvature_threshold",
              options.curvature_threshold,
              "curvature above which points are taken out if not convex",
              "",
              Range::between(0, 1.0 / 3))
      .number("-ratio_threshold",
              options.ratio_threshold,
              "ratio of points in front of and behind the surface that is not convex",
              "",
              Range::between(0, 1))
      .number("-graph_scale",
              options.graph.scale,
              "higher gives larger segments",
              "",
              Range::atLeast(0))
      .number("-min_segment",
              options.graph.min_segment_size,
              "smallest segment",
              "supervoxels",
              Range::atLeast(1))
      .number("-concavity_tolerance",
              options.concavity_tolerance_degrees,
              "bend up to which concave edges count as convex",
              "degrees",
              Range::between(0, 180))
      .text("-camera",
            camera,
            "voxels grow with the distance from one camera; auto: if the input is "
            "organised",
            {"auto", "single", "none"})
      .flag(
          "-ignore_normals", ignore_normals, "estimate normals although there are some")
      .number("-threads", options.threads, "threads, 0 = automatic");
  return parser.run(argc, argv, [&](Progress& progress) {
    if (!(options.seed_size >= options.voxel_size))
      throw ToolError("-seed_resolution must be at least -voxel_resolution, not " +
                      std::to_string(options.seed_size));
    requireWritable(output);
    progress.start("Loading " + input);
    CloudFile file = loadCloud(input);
    progress.done(std::to_string(file.points->size()) + " points");

    progress.start("Segmenting objects");
    options.partition = partition == "lccp" ? Partition::Lccp : Partition::Graph;
    pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
    segmentation.setOptions(options);
    if (camera != "auto")
      segmentation.setUseSingleCameraTransform(camera == "single");
    file.points->sensor_origin_.head<3>() =
        (file.origin.head<3>().cast<double>() - file.offset).cast<float>();
    segmentation.setInputCloud(file.points);
    if (file.has_normals && !ignore_normals)
      segmentation.setInputNormals(readNormals(file));
    std::vector<std::uint32_t> objects;
    segmentation.segment(objects);
    if (objects.empty())
      throw AlreadyReported();
    const auto count = *std::max_element(objects.begin(), objects.end());
    progress.done(std::to_string(count) + " objects");

    progress.start("Saving " + output);
    appendField(file.cloud, "object", objects);
    saveCloud(output, file.cloud, file.origin, file.orientation);
    progress.done();
  });
}
