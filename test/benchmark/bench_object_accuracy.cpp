/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

/* Segment the rooms of a source of labelled scans by several methods and compare the
 * errors: a table with a row for each method.
 *
 *   bench_object_accuracy scan.pcd ... -room_field F -object_field F [-part_field F]
 *
 * Points whose object is 0 (walls, floor) are segmented, but not scored. Rooms with
 * fewer than three objects of at least 100 points are left out. Flat objects on walls
 * (pictures, closed doors, windows: at most 0.15 m thick in a level direction, half of
 * their points within 0.15 m of points of no object) are scored apart. "In tree" is the
 * share of the others that any cut of the tree of joins finds. A source of one
 * room is also turned about the vertical with -turns. object_accuracy.py runs all
 * sources. */

#include "command_line/options.h"
#include "comparison/upstream_lccp.h"
#include "labelled_rooms.h"
#include "scene/single_view.h"

#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/noise_resilient_lccp.h>
#include <pcl/segmentation/segmentation_metrics.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <type_traits>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

struct Settings {
  RoomSource source;
  std::string methods = "all";
  bool each_room = false, failures = false;
  unsigned threads = 2;
  double level = -1;
  double upstream_voxel = 0; // metres, 0 = as ours
  std::string label_folder;
};

/** What a method finds; one that joins pieces tells in which order. */
struct Found {
  SegmentLabels labels;
  SegmentLabels pieces; ///< from 1
  std::vector<PieceJoin> joins;
};

/** \param[in] options ours or the thesis's */
template <typename Options>
Found
segmentOurs(const Cloud::Ptr& points, const Options& options, unsigned threads)
{
  pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
  if constexpr (std::is_same_v<Options, thesis::ObjectOptions>)
    segmentation.setThesisOptions(options);
  else
    segmentation.setOptions(options);
  segmentation.setNumberOfThreads(threads);
  segmentation.setInputCloud(points);
  Found found;
  segmentation.segment(found.labels);
  if (segmentation.getPartition() == Partition::Pieces) {
    found.pieces = segmentation.getSegmentsAtLevel(1.1f); // no join is that probable
    found.joins = segmentation.getHierarchy();
  }
  return found;
}

/** The share of objects that one of all unions on the way, or a piece, has an
 * intersection over union of at least 0.5 with: what any cut of the tree can find. */
double
bestCut(const LabelledRoom& room,
        const Found& found,
        const std::vector<std::uint32_t>& objects)
{
  std::map<std::uint32_t, double> size_of_object, size_of_union;
  std::map<std::uint32_t, std::map<std::uint32_t, double>> counts; // of each union
  for (std::size_t i = 0; i < room.objects.size(); ++i) {
    if (room.objects[i] == 0 || found.pieces[i] == 0)
      continue;
    ++size_of_object[room.objects[i]];
    ++size_of_union[found.pieces[i] - 1];
    ++counts[found.pieces[i] - 1][room.objects[i]];
  }
  std::set<std::uint32_t> right;
  const auto judge = [&](std::uint32_t number) {
    for (const auto& [object, count] : counts[number])
      if (2 * count >= size_of_object[object] + size_of_union[number] - count)
        right.insert(object);
  };
  for (const auto& entry : size_of_union)
    judge(entry.first);
  for (const auto& join : found.joins) {
    for (const auto& [object, count] : counts[join.gone])
      counts[join.kept][object] += count;
    size_of_union[join.kept] += size_of_union[join.gone];
    judge(join.kept);
  }
  return static_cast<double>(std::count_if(
      objects.begin(), objects.end(), [&](auto o) { return right.count(o) > 0; }));
}

struct Method {
  std::string name;
  std::function<Found(const Cloud::Ptr&)> segment;
};

ObjectSegmentationOptions
ourOptions(bool single_view, const Settings& settings)
{
  auto options = single_view ? singleViewOptions() : ObjectSegmentationOptions();
  if (settings.level >= 0)
    options.pieces.joining_level = static_cast<float>(settings.level);
  return options;
}

/** \param[in] single_view the scans are of one camera and of tables */
std::vector<Method>
makeMethods(bool single_view, const Settings& settings)
{
  const auto ours = ourOptions(single_view, settings);
  const auto sizes = withSizes(ours);
  const auto threads = settings.threads;
  const auto plain = exampleUpstreamOptions(single_view, threads);
  const double voxel =
      settings.upstream_voxel > 0 ? settings.upstream_voxel : sizes.voxel_size;
  const double seed = settings.upstream_voxel > 0 ? 4 * voxel : sizes.seed_size;
  const auto tuned = tunedUpstreamOptions(single_view, threads, voxel, seed);
  const auto upstream = [](const UpstreamOptions& options) {
    return [options](const Cloud::Ptr& points) {
      return Found{segmentUpstream(*points, options), {}, {}};
    };
  };
  const auto own = [threads](const auto& options) {
    return [options, threads](const Cloud::Ptr& points) {
      return segmentOurs(points, options, threads);
    };
  };
  const Method best{"ours", [settings, threads](const Cloud::Ptr& points) {
                      const auto options = ourOptions(isSingleView(points), settings);
                      return segmentOurs(points, options, threads);
                    }};
  if (settings.methods == "ours")
    return {best};
  if (settings.methods == "upstream")
    return {{"LCCP, example's defaults", upstream(plain)},
            {"LCCP, tuned", upstream(tuned)}};
  auto proposed = single_view ? thesisKinectOptions() : thesisOptions();
  thesis::ObjectOptions lccp{ours, {}, {}};
  lccp.edges.partition = thesis::EdgePartition::Lccp;
  if (single_view) {
    proposed.shared.voxel_size = sizes.voxel_size;
    proposed.shared.seed_size = sizes.seed_size;
  }
  std::vector<Method> methods{{"LCCP, example's defaults", upstream(plain)},
                              {"LCCP, tuned", upstream(tuned)},
                              {"the thesis's method", own(proposed)},
                              {"ours + LCCP", own(lccp)},
                              best};
  auto pieces = ours;
  pieces.pieces.joining_level = 1;
  methods.insert(methods.end() - 1, {"ours, pieces alone", own(pieces)});
  if (!single_view) {
    auto parts = partsOptions();
    if (settings.level >= 0)
      parts.pieces.joining_level = ours.pieces.joining_level;
    methods.insert(methods.end() - 1, {"ours, parts", own(parts)});
  }
  return methods;
}

/** Sums over rooms. */
struct Score {
  double over = 0, under = 0, object_over = 0, object_under = 0, overlap = 0;
  double segments = 0, specks = 0, seconds = 0, quality = 0, in_tree = 0;
  ObjectScore objects, flat, parts;
  AveragePrecision precision; ///< of the objects, ranked by size

  Score&
  operator+=(const Score& other)
  {
    over += other.over;
    under += other.under;
    object_over += other.object_over;
    object_under += other.object_under;
    overlap += other.overlap;
    segments += other.segments;
    specks += other.specks;
    seconds += other.seconds;
    quality += other.quality;
    in_tree += other.in_tree;
    objects += other.objects;
    precision += other.precision;
    flat += other.flat;
    parts += other.parts;
    return *this;
  }
};

/** Print the large objects that were not found whole: what the segment that holds most
 * of each covers, and how much of that segment is its own. */
void
printFailures(const LabelledRoom& room, const SegmentLabels& labels)
{
  std::map<std::uint32_t, std::size_t> size_of_object, size_of_segment;
  for (const auto object : room.objects)
    ++size_of_object[object];
  for (const auto label : labels)
    ++size_of_segment[label];
  std::map<std::uint32_t, Overlap> best;
  for (const auto& overlap : countOverlaps(room.objects, labels))
    if (overlap.count > best[overlap.truth].count)
      best[overlap.truth] = overlap;
  for (const auto& [object, overlap] : best) {
    const auto size = static_cast<double>(size_of_object[object]),
               count = static_cast<double>(overlap.count);
    const double covered = count / size,
                 pure = count / static_cast<double>(size_of_segment[overlap.predicted]);
    if (size >= large && (covered < 0.8 || pure < 0.7))
      std::printf("%s, object %u of %.0f points: covered %.2f, pure %.2f%s\n",
                  room.name.c_str(),
                  object,
                  size,
                  covered,
                  pure,
                  std::count(room.flat.begin(), room.flat.end(), object) > 0
                      ? ", flat on a wall"
                      : "");
  }
}

/** Write the labels of a room, field label, as FOLDER/SCAN.METHOD.pcd. */
void
writeLabels(const std::string& folder,
            const LabelledRoom& room,
            const std::string& method,
            const SegmentLabels& labels)
{
  pcl::PointCloud<pcl::PointXYZL> cloud;
  pcl::copyPointCloud(*room.points, cloud);
  for (std::size_t i = 0; i < labels.size(); ++i)
    cloud[i].label = labels[i];
  const auto scan = std::filesystem::path(room.name).stem().string();
  const auto file = std::filesystem::path(folder) / (scan + "." + method + ".pcd");
  if (pcl::io::savePCDFileBinary(file.string(), cloud) != 0)
    throw ToolError(file.string() + ": cannot be written");
}

Score
evaluate(const LabelledRoom& room, const Method& method, const Settings& settings)
{
  const auto begin = std::chrono::steady_clock::now();
  const auto found = method.segment(room.points);
  const auto& labels = found.labels;
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  if (settings.failures)
    printFailures(room, labels);
  if (!settings.label_folder.empty())
    writeLabels(settings.label_folder, room, method.name, labels);
  Score score;
  const auto errors = multiScaleErrors(room.parts, room.objects, labels);
  const auto overlaps = countOverlaps(room.objects, labels);
  const auto object_errors = richtsfeldErrors(overlaps);
  std::map<std::uint32_t, std::size_t> sizes;
  for (const auto label : labels)
    ++sizes[label];
  sizes.erase(0);
  for (const auto& entry : sizes)
    score.specks += entry.second < large;
  score.over = errors.over;
  score.under = errors.under;
  score.object_over = object_errors.over;
  score.object_under = object_errors.under;
  score.overlap = weightedOverlap(overlaps);
  score.segments = static_cast<double>(sizes.size());
  score.seconds = time.count();
  if (!room.others.empty()) {
    score.objects = scoreObjects(room.objects, labels, large, room.others);
    score.precision.add(room.objects, labels, large, room.others);
  }
  if (!room.flat.empty())
    score.flat = scoreObjects(room.objects, labels, large, room.flat);
  if (!found.pieces.empty())
    score.in_tree = bestCut(room, found, room.others);
  score.parts = scoreObjects(room.parts, labels, large);
  score.quality = scoreObjects(room.objects, labels, large).panopticQuality();
  return score;
}

void
printHead()
{
  std::printf(
      "| method | OS %% | US %% | objects OS %% | US %% | WO %% | PQ | AP50 "
      "| PQ of rooms | parts PQ | whole %% | on walls PQ | whole %% | in tree %% | "
      "segments | specks %% | s |\n| --- |");
  for (int column = 0; column < 16; ++column)
    std::printf(" ---: |");
  std::printf("\n");
}

void
printRow(const std::string& name, const Score& sum, double count)
{
  std::printf("| %s | %.1f | %.1f | %.1f | %.1f | %.1f | %.3f | %.3f | %.3f | %.3f | "
              "%.1f of %zu | %.3f | %.1f of %zu | %.1f | %.0f | %.0f | %.2f |\n",
              name.c_str(),
              100 * sum.over / count,
              100 * sum.under / count,
              100 * sum.object_over / count,
              100 * sum.object_under / count,
              100 * sum.overlap / count,
              sum.objects.panopticQuality(),
              sum.precision.at(50),
              sum.quality / count,
              sum.parts.panopticQuality(),
              100 * sum.objects.wholeShare(),
              sum.objects.true_count,
              sum.flat.panopticQuality(),
              100 * sum.flat.wholeShare(),
              sum.flat.true_count,
              100 * sum.in_tree / static_cast<double>(sum.objects.true_count),
              sum.segments / count,
              100 * sum.specks / sum.segments,
              sum.seconds / count);
  std::fflush(stdout);
}

void
compare(const Settings& settings)
{
  const auto rooms = loadRooms(settings.source);
  std::printf("%zu rooms\n\n", rooms.size());
  printHead();
  const bool single_view = isSingleView(rooms.front().points);
  for (const auto& method : makeMethods(single_view, settings)) {
    Score sum;
    for (const auto& room : rooms) {
      const auto score = evaluate(room, method, settings);
      if (settings.each_room)
        printRow(method.name + ", " + room.name, score, 1);
      sum += score;
    }
    printRow(method.name, sum, static_cast<double>(rooms.size()));
  }
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  OptionParser parser("bench_object_accuracy",
                      "Segment the rooms of labelled scans into objects by several "
                      "methods and compare their errors.");
  parser.positionals("scan.pcd", settings.source.scans, "labelled scans, metres, z up")
      .text("-room_field",
            settings.source.room_field,
            "room of a point, 0 = in none; none: a scan is one room or view")
      .text(
          "-object_field", settings.source.object_field, "object of a point; 0 = none")
      .text("-part_field",
            settings.source.part_field,
            "its part, for the multi-scale errors")
      .text("-unite",
            settings.source.united,
            "labels that are parts of one object, as 2,3/6,7,8; the parts count for "
            "the multi-scale errors")
      .text("-methods",
            settings.methods,
            "which are compared",
            {"all", "ours", "upstream"})
      .flag("-each_room", settings.each_room, "print a line for each room, too")
      .flag("-failures",
            settings.failures,
            "print a line for each large object that was not found whole, too")
      .number("-turns",
              settings.source.turns,
              "each room is also turned by 11 degrees, 22 and so on",
              "",
              Range::between(1, 30))
      .number("-level",
              settings.level,
              "probability from which pieces are joined, -1 = the default",
              "",
              Range::between(-1, 1))
      .number(
          "-upstream_voxel",
          settings.upstream_voxel,
          "edge of a voxel of upstream's, tuned, a quarter of its seeds; 0 = as ours",
          "m",
          Range::atLeast(0.0))
      .text("-labels",
            settings.label_folder,
            "folder for the labels that each method gives a scan; -room_field none")
      .number("-threads", settings.threads, "threads of all methods, 0 = automatic");
  return parser.run(argc, argv, [&](Progress&) { compare(settings); });
}
