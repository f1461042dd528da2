/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"
#include "files/cloud_file.h"
#include "files/random_numbers.h"
#include "objects/object_files.h"
#include "rooms/collected_objects.h"
#include "scene/category_names.h"
#include "scene/segmented_rooms.h"
#include "text/printable.h"

#include <pcl/segmentation/room_objects.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <random>

using namespace pcl::indoor::tool;

namespace {

constexpr const char* no_class = "none"; // of categories that nothing is learned of

struct Options {
  std::string input, folder;
  std::string category_field = "category", object_field, names, classes;
  double min_share = 0.5;
  std::uint32_t min_points = 30;
  std::uint32_t max_other = 0;
  std::uint32_t seed = 1;
  int threads = 0;
};

OptionParser
makeParser(Options& options)
{
  OptionParser parser(
      "pcl_segment_collection",
      "Cuts labelled scans into the segments that pcl_indoor_pipeline finds and saves "
      "each in the folder of its class, to train a classifier on what it will meet.");
  parser.positional("scan.pcd", options.input, "PCD or PLY file, metres, z up")
      .positional("folder", options.folder, "where the class folders go")
      .text("-category_field", options.category_field, "number of a point's category")
      .text("-object_field",
            options.object_field,
            "save the objects that this field numbers instead of segments, whole")
      .text("-names",
            options.names,
            "JSON file with the names of the categories, in 'categories' (a list) or "
            "'classes' (number: name); without it, numbers are names")
      .text(
          "-classes",
          options.classes,
          "JSON file, class: [names of categories]; objects of the class none are left "
          "out, all other categories are other. Without it, categories are classes")
      .number("-min_share",
              options.min_share,
              "share of a segment's points that its class must hold; else it is of the "
              "class other",
              "",
              Range::between(0.0, 1.0))
      .number("-min_points",
              options.min_points,
              "fewest points (one per voxel) of a segment",
              "points",
              Range::atLeast(2))
      .number("-max_other",
              options.max_other,
              "most segments of the class other, drawn at random, 0 = all")
      .number("-seed", options.seed, "of the draw")
      .number(
          "-threads", options.threads, "0 = automatic", "", Range::between(0, 1024));
  parser.expert({"-min_share", "-min_points", "-max_other", "-seed"});
  return parser;
}

/** The class of each category's number. */
std::map<std::uint32_t, std::string>
classOfCategory(const Options& options)
{
  std::map<std::uint32_t, std::string> names;
  if (!options.names.empty())
    names = readCategoryNames(options.names);
  if (options.classes.empty())
    return names;
  const auto class_of_name = readClassMap(options.classes);
  for (auto& [number, name] : names) {
    const auto found = class_of_name.find(name);
    name = found == class_of_name.end() ? other_class : found->second;
  }
  return names;
}

/** Counts of the classes of an object's points. */
using ClassCounts = std::map<std::string, std::size_t>;

/** The class of the most points, if they are share of all; else other. */
std::string
classOf(const ClassCounts& counts, double share)
{
  std::size_t all = 0;
  auto best = counts.begin();
  for (auto entry = counts.begin(); entry != counts.end(); ++entry) {
    all += entry->second;
    if (entry->second > best->second)
      best = entry;
  }
  const bool is_enough = best != counts.end() && static_cast<double>(best->second) >=
                                                     share * static_cast<double>(all);
  return is_enough ? best->first : other_class;
}

struct ScanObjects {
  pcl::indoor::tool::CollectedObjects found;
  std::vector<std::string> classes; ///< one per object
};

/** Objects of which another room has more are left without a class. */
void
dropSmallerParts(const std::vector<std::uint32_t>& given, ScanObjects& objects)
{
  const auto& object_of_point = objects.found.object_of_point;
  std::vector<std::size_t> size(objects.classes.size(), 0);
  std::vector<std::uint32_t> source(objects.classes.size(), 0);
  for (std::size_t i = 0; i < given.size(); ++i)
    if (object_of_point[i] > 0) {
      ++size[object_of_point[i] - 1];
      source[object_of_point[i] - 1] = given[i];
    }
  std::map<std::uint32_t, std::size_t> largest;
  for (std::size_t k = 0; k < size.size(); ++k)
    largest[source[k]] = std::max(largest[source[k]], size[k]);
  for (std::size_t k = 0; k < size.size(); ++k)
    if (size[k] < largest[source[k]])
      objects.classes[k].clear();
}

ScanObjects
objectsOfScan(const Options& options, const CloudFile& file, Progress& progress)
{
  const auto class_of = classOfCategory(options);
  const auto categories = readLabels(file, options.category_field);
  std::vector<std::uint32_t> given;
  if (!options.object_field.empty())
    given = readLabels(file, options.object_field);

  progress.start("Segmenting rooms");
  pcl::RoomSegmentation<pcl::PointXYZ> rooms;
  rooms.setNumberOfThreads(options.threads);
  const auto room_of_point =
      segmentRooms(file, {}, {}, false, rooms, printWarning).room_of_point;
  progress.done(summaryOf(rooms));

  progress.start("Segmenting objects");
  RoomWork work;
  work.options.threads = 1; // the threads are busy with the rooms
  if (!given.empty())
    work.options.fewest_points = 0; // small ones are objects, too
  ScanObjects objects;
  objects.found = collectObjects(
      *file.points,
      room_of_point,
      given,
      work,
      options.threads,
      [&](std::size_t done, std::size_t all) { progress.update(done, all); });
  std::vector<ClassCounts> counts(objects.found.surfaces.size());
  for (std::size_t i = 0; i < categories.size(); ++i) {
    const auto object = objects.found.object_of_point[i];
    if (object == 0)
      continue;
    const auto name = class_of.find(categories[i]);
    ++counts[object - 1][name != class_of.end()  ? name->second
                         : options.names.empty() ? std::to_string(categories[i])
                                                 : other_class];
  }
  for (const auto& own : counts)
    objects.classes.push_back(classOf(own, options.min_share));
  if (!given.empty())
    dropSmallerParts(given, objects);
  progress.done(std::to_string(counts.size()) + " objects");
  return objects;
}

/** The objects to save: large enough, with a class, not more others than wanted. */
std::vector<std::size_t>
chosenObjects(const Options& options, const ScanObjects& objects)
{
  std::vector<std::size_t> chosen, others;
  for (std::size_t k = 0; k < objects.classes.size(); ++k) {
    if (objects.classes[k].empty() || objects.classes[k] == no_class ||
        objects.found.surfaces[k].points.size() < options.min_points)
      continue;
    (objects.classes[k] == other_class ? others : chosen).push_back(k);
  }
  if (options.max_other > 0 && others.size() > options.max_other) {
    std::mt19937 random(options.seed);
    drawToFront(others, options.max_other, random);
    others.resize(options.max_other);
  }
  chosen.insert(chosen.end(), others.begin(), others.end());
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

void
collect(const Options& options, Progress& progress)
{
  namespace fs = std::filesystem;
  requireFolder(options.folder);
  progress.start("Loading " + options.input);
  const auto file = loadCloud(options.input);
  progress.done(std::to_string(file.points->size()) + " points");
  const auto objects = objectsOfScan(options, file, progress);
  const auto chosen = chosenObjects(options, objects);
  progress.start("Saving to " + options.folder);
  const auto stem = fs::path(options.input).stem().string();
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    progress.update(k, chosen.size());
    const auto& name = objects.classes[chosen[k]];
    const auto folder = fs::path(options.folder) / name;
    makeFolder(folder.string());
    saveObject(
        (folder / (stem + "_" + std::to_string(chosen[k] + 1) + ".pcd")).string(),
        objects.found.surfaces[chosen[k]]);
  }
  progress.done(std::to_string(chosen.size()) + " segments");
}

} // namespace

int
main(int argc, char** argv)
{
  Options options;
  return makeParser(options).run(
      argc, argv, [&](Progress& progress) { collect(options, progress); });
}
