/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

/* Cut the rooms out of labelled buildings, segment each by several methods and compare
 * the errors, as means over the rooms.
 *
 *   bench_object_accuracy building.pcd ... -room_field F -object_field F [-part_field
 * F]
 *
 * Points whose object is 0 (walls, floor) are segmented, but not scored. Rooms with
 * fewer than three objects of at least 100 points are left out. */

#include "cloud_file.h"
#include "options.h"
#include "upstream_lccp.h"

#include <pcl/segmentation/noise_resilient_lccp.h>
#include <pcl/segmentation/segmentation_metrics.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <map>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

struct Settings {
  std::vector<std::string> buildings;
  std::string room_field = "room", object_field = "object", part_field;
  bool each_room = false;
  unsigned threads = 2;
};

struct Room {
  std::string name;
  Cloud::Ptr points = pcl::make_shared<Cloud>();
  SegmentLabels objects, parts;
};

std::vector<Room>
cutRooms(const std::string& path, const Settings& settings)
{
  const auto file = loadCloud(path);
  const auto room_of = readLabels(file, settings.room_field);
  const auto object_of = readLabels(file, settings.object_field);
  const auto part_of =
      settings.part_field.empty() ? object_of : readLabels(file, settings.part_field);
  std::map<std::uint32_t, Room> rooms;
  for (std::size_t i = 0; i < room_of.size(); ++i) {
    if (room_of[i] == 0)
      continue;
    auto& room = rooms[room_of[i]];
    room.points->push_back((*file.points)[i]);
    room.objects.push_back(object_of[i]);
    room.parts.push_back(part_of[i]);
  }
  std::vector<Room> furnished;
  for (auto& [number, room] : rooms) {
    std::map<std::uint32_t, std::size_t> sizes;
    for (const auto object : room.objects)
      ++sizes[object];
    sizes.erase(0);
    std::size_t large = 0;
    for (const auto& entry : sizes)
      large += entry.second >= 100;
    room.name = path + " " + settings.room_field + " " + std::to_string(number);
    if (large >= 3)
      furnished.push_back(std::move(room));
  }
  return furnished;
}

SegmentLabels
segmentOurs(const Cloud::Ptr& points,
            ObjectSegmentationOptions options,
            unsigned threads)
{
  options.threads = threads;
  pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
  segmentation.setOptions(options);
  segmentation.setInputCloud(points);
  SegmentLabels labels;
  segmentation.segment(labels);
  return labels;
}

struct Method {
  std::string name;
  std::function<SegmentLabels(const Cloud::Ptr&)> segment;
};

std::vector<Method>
makeMethods(unsigned threads)
{
  UpstreamOptions plain, tuned;
  tuned.use_sanity_check = tuned.use_smoothness_check = true;
  tuned.min_segment_size = 3;
  plain.threads = tuned.threads = threads;
  const auto upstream = [](const UpstreamOptions& options) {
    return [options](const Cloud::Ptr& points) {
      return segmentUpstream(*points, options);
    };
  };
  const auto own = [threads](const ObjectSegmentationOptions& options) {
    return [options, threads](const Cloud::Ptr& points) {
      return segmentOurs(points, options, threads);
    };
  };
  ObjectSegmentationOptions lccp, no_unions;
  lccp.partition = Partition::Lccp;
  no_unions.max_union_air = 0;
  return {{"LCCP, example's defaults", upstream(plain)},
          {"LCCP, tuned", upstream(tuned)},
          {"the thesis's setting", own(thesisOptions())},
          {"ours + LCCP", own(lccp)},
          {"ours, no convex unions", own(no_unions)},
          {"ours", own(ObjectSegmentationOptions())}};
}

struct Score {
  double over = 0, under = 0, object_over = 0, object_under = 0, overlap = 0,
         segments = 0, seconds = 0;
};

Score
evaluate(const Room& room, const Method& method)
{
  const auto begin = std::chrono::steady_clock::now();
  const auto labels = method.segment(room.points);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  const auto errors = multiScaleErrors(room.parts, room.objects, labels);
  const auto overlaps = countOverlaps(room.objects, labels);
  const auto object_errors = richtsfeldErrors(overlaps);
  std::map<std::uint32_t, bool> segments;
  for (const auto label : labels)
    segments[label] = true;
  segments.erase(0);
  return {errors.over,
          errors.under,
          object_errors.over,
          object_errors.under,
          weightedOverlap(overlaps),
          static_cast<double>(segments.size()),
          time.count()};
}

void
printRow(const std::string& name, const Score& sum, double count)
{
  std::printf("| %s | %.2f | %.2f | %.2f | %.2f | %.1f | %.0f | %.2f |\n",
              name.c_str(),
              100 * sum.over / count,
              100 * sum.under / count,
              100 * sum.object_over / count,
              100 * sum.object_under / count,
              100 * sum.overlap / count,
              sum.segments / count,
              sum.seconds / count);
}

void
compare(const Settings& settings)
{
  std::vector<Room> rooms;
  for (const auto& building : settings.buildings)
    for (auto& room : cutRooms(building, settings))
      rooms.push_back(std::move(room));
  if (rooms.empty())
    throw ToolError("no room has three objects of 100 points");
  std::printf("%zu rooms\n\n", rooms.size());
  std::printf(
      "| method | OS %% | US %% | whole objects OS %% | US %% | WO %% | segments "
      "| s |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  for (const auto& method : makeMethods(settings.threads)) {
    Score sum;
    for (const auto& room : rooms) {
      const auto score = evaluate(room, method);
      if (settings.each_room)
        printRow(method.name + ", " + room.name, score, 1);
      sum.over += score.over;
      sum.under += score.under;
      sum.object_over += score.object_over;
      sum.object_under += score.object_under;
      sum.overlap += score.overlap;
      sum.segments += score.segments;
      sum.seconds += score.seconds;
    }
    printRow(method.name, sum, static_cast<double>(rooms.size()));
    std::fflush(stdout);
  }
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  OptionParser parser("bench_object_accuracy",
                      "Segment the rooms of labelled buildings into objects by several "
                      "methods and compare their errors.");
  parser.positionals("building.pcd", settings.buildings, "labelled scans, metres")
      .text("-room_field", settings.room_field, "room of a point; 0 = in none")
      .text("-object_field", settings.object_field, "object of a point; 0 = none")
      .text("-part_field", settings.part_field, "its part, for the multi-scale errors")
      .flag("-each_room", settings.each_room, "print a line for each room, too")
      .number("-threads", settings.threads, "threads of all methods, 0 = automatic");
  return parser.run(argc, argv, [&](Progress&) { compare(settings); });
}
