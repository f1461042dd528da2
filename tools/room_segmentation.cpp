/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "cloud_file.h"
#include "options.h"

#include <pcl/segmentation/room_segmentation.h>

using namespace pcl::indoor::tool;

int
main(int argc, char** argv)
{
  std::string input, output;
  pcl::RoomSegmentation<pcl::PointXYZ> segmentation;
  double voxel_size = segmentation.getVoxelSize();
  double min_area = segmentation.getMinRoomArea();
  double min_width = segmentation.getMinRoomWidth();
  double persistence = segmentation.getPersistence();
  double open_share = segmentation.getOpenShare();
  std::string method = "slab";
  int threads = segmentation.getNumberOfThreads();

  OptionParser parser("pcl_room_segmentation",
                      "Segment the scan of a building into rooms with "
                      "pcl::RoomSegmentation; adds the field room.");
  parser.positional("input", input, "PCD or PLY file, z up, metres")
      .positional("output.pcd", output, "the input with the field room, 0 = none")
      .number("-voxel_size", voxel_size, "side of a voxel", "m", Range::positive())
      .number("-min_area", min_area, "smallest room", "m^2", Range::atLeast(0))
      .number("-min_width", min_width, "narrowest room", "m", Range::atLeast(0))
      .number("-persistence",
              persistence,
              "widest passage between rooms, as share of the narrower one's width",
              "",
              Range::between(0, 1))
      .number("-open_share",
              open_share,
              "most open border between rooms, as share of its area",
              "",
              Range::between(0, 1))
      .text("-method",
            method,
            "slab: walls below the ceiling; field: potential field and HDBSCAN, as in "
            "the thesis",
            {"slab", "field"})
      .number("-threads", threads, "threads, 0 = automatic", "", Range::atLeast(0));
  return parser.run(argc, argv, [&](Progress& progress) {
    requireWritable(output);
    progress.start("Loading " + input);
    CloudFile file = loadCloud(input);
    progress.done(std::to_string(file.points->size()) + " points");

    progress.start("Segmenting rooms");
    segmentation.setVoxelSize(voxel_size);
    segmentation.setMinRoomArea(min_area);
    segmentation.setMinRoomWidth(min_width);
    segmentation.setPersistence(persistence);
    segmentation.setOpenShare(open_share);
    segmentation.setMethod(method == "slab" ? pcl::indoor::RoomMethod::CeilingSlab
                                            : pcl::indoor::RoomMethod::PotentialField);
    segmentation.setNumberOfThreads(threads);
    segmentation.setInputCloud(file.points);
    std::vector<std::uint32_t> rooms;
    segmentation.segment(rooms);
    if (rooms.empty())
      throw AlreadyReported();
    progress.done(std::to_string(segmentation.getRooms().size()) + " rooms");

    progress.start("Saving " + output);
    appendField(file.cloud, "room", rooms);
    saveCloud(output, file.cloud, file.origin, file.orientation);
    progress.done();
  });
}
