/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"
#include "files/cloud_file.h"
#include "files/output_file.h"
#include "formats/table/table_columns.h" // for listedNames
#include "objects/join/object_joining.h"
#include "objects/object_steps.h"
#include "scene/category_names.h"
#include "text/pcl_errors.h"
#include "text/printable.h"

#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/ml/bundled_model.h>
#include <pcl/ml/voxel_network.h>
#include <pcl/segmentation/noise_resilient_lccp.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <sstream>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

struct Settings {
  std::string input, output;
  std::string room_field = "room", object_field = "object";
  std::string part_field = "part", part_categories, category_field = "category", names;
  std::string model;
  bool objects = false, votes = false;
  double share = 0.5;
  std::uint32_t seed = 1;
};

OptionParser
makeParser(Settings& settings)
{
  OptionParser parser(
      "pcl_joining_examples",
      "Joins the pieces of a labelled scan's rooms to objects and saves each pair of "
      "pieces that is judged on the way, with what is known of it and whether the two "
      "are one object, or each piece and union, and how well it fits an object: what "
      "models/train_joining.py learns from.");
  parser.positional("scan.pcd", settings.input, "PCD or PLY file, metres, z up")
      .positional("examples",
                  settings.output,
                  "file of 32-bit floats, a row for a pair, or two for an object")
      .text("-room_field",
            settings.room_field,
            "room of a point, 0 = in none; an organised cloud is a camera's view")
      .text("-object_field", settings.object_field, "object of a point, 0 = structure")
      .text("-part_categories",
            settings.part_categories,
            "of objects of these categories, separated by commas, the parts count")
      .text("-part_field", settings.part_field, "part of a point")
      .text("-category_field", settings.category_field, "number of its category")
      .text("-names",
            settings.names,
            "JSON file with the names of the categories, in 'categories'")
      .text("-model",
            settings.model,
            "trees that join; without them what is one object is joined, in random "
            "order")
      .flag("-objects", settings.objects, "save objects instead of pairs; needs -model")
      .flag("-votes", settings.votes, "ask the bundled voxel network, in all rooms")
      .number("-share", settings.share, "of the pairs saved", "", Range::between(0, 1))
      .number("-seed", settings.seed, "of the order and of what is saved");
  parser.expert(
      {"-part_categories", "-part_field", "-objects", "-votes", "-share", "-seed"});
  return parser;
}

struct Room {
  std::uint32_t number = 0;
  pcl::PointCloud<pcl::PointXYZ>::Ptr points =
      pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  std::vector<std::uint32_t> truth;
  bool is_view = false; ///< of one camera
};

/** The numbers of the categories whose parts count. */
std::set<std::uint32_t>
dividedCategories(const Settings& settings)
{
  const auto names = readCategoryNames(settings.names);
  std::set<std::uint32_t> numbers;
  for (const auto& wanted : listedNames(settings.part_categories)) {
    bool is_known = false;
    for (const auto& [number, name] : names)
      if (name == wanted) {
        numbers.insert(number);
        is_known = true;
      }
    if (!is_known)
      throw ToolError("-part_categories: '" + wanted + "' is not in " + settings.names);
  }
  return numbers;
}

std::vector<std::uint32_t>
readTruth(const CloudFile& file, const Settings& settings)
{
  auto truth = readLabels(file, settings.object_field);
  if (settings.part_categories.empty())
    return truth;
  const auto divided = dividedCategories(settings);
  const auto parts = readLabels(file, settings.part_field);
  const auto categories = readLabels(file, settings.category_field);
  const auto most = *std::max_element(truth.begin(), truth.end());
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (divided.count(categories[i]) > 0)
      truth[i] = most + 1 + parts[i];
  return truth;
}

std::vector<Room>
readRooms(const Settings& settings)
{
  const auto file = loadCloud(settings.input);
  const bool is_view = file.points->height > 1;
  const auto rooms = is_view ? std::vector<std::uint32_t>(file.points->size(), 1)
                             : readLabels(file, settings.room_field);
  const auto truth = readTruth(file, settings);
  std::map<std::uint32_t, Room> room_of_number;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (rooms[i] == 0 || !pcl::isFinite((*file.points)[i]))
      continue;
    auto& room = room_of_number[rooms[i]];
    room.points->push_back((*file.points)[i]);
    room.truth.push_back(truth[i]);
  }
  std::vector<Room> result;
  for (auto& [number, room] : room_of_number) {
    room.number = number;
    room.is_view = is_view;
    room.points->sensor_origin_ = file.points->sensor_origin_;
    result.push_back(std::move(room));
  }
  return result;
}

/** The trees of a file; null without a file. */
std::unique_ptr<LearnedCriterion>
readCriterion(const std::string& path)
{
  if (path.empty())
    return nullptr;
  std::ifstream stream(path);
  if (!stream)
    throw ToolError(path + ": cannot be opened");
  try {
    return std::make_unique<LearnedCriterion>(BoostedTrees::read(stream));
  } catch (const pcl::BadArgumentException& error) {
    throw ToolError(path + ": " + messageOf(error));
  }
}

/** How many points of each true object a union of pieces has. */
struct PieceTruth {
  std::map<std::uint32_t, double> counts;

  /** The true object of most points, and how many these are. */
  std::pair<std::uint32_t, double>
  most() const
  {
    const auto best = std::max_element(
        counts.begin(), counts.end(), [](const auto& a, const auto& b) {
          return a.second < b.second;
        });
    if (best == counts.end())
      return {0, 0.0};
    return *best;
  }

  double
  size() const
  {
    double sum = 0;
    for (const auto& entry : counts)
      sum += entry.second;
    return sum;
  }

  void
  add(const PieceTruth& other)
  {
    for (const auto& [object, count] : other.counts)
      counts[object] += count;
  }
};

std::vector<PieceTruth>
truthOfPieces(const ObjectSegmentation& pieces, const std::vector<std::uint32_t>& truth)
{
  std::vector<PieceTruth> of_piece(stepsOf(pieces).pieces.pieces.size());
  for (std::size_t i = 0; i < truth.size(); ++i)
    ++of_piece[pieces.piece_of_point[i]].counts[truth[i]];
  return of_piece;
}

/** Save an example: what it is, its weight, and what is known of it. */
template <typename Features>
void
writeRow(bool is_one, double weight, const Features& features, std::ostream& examples)
{
  const auto write = [&](float value) {
    examples.write(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  write(is_one);
  write(static_cast<float>(weight));
  for (const float feature : features)
    write(feature);
}

/** Joins by trees, or by the truth, and saves what it judges. */
class Teacher : public JoiningCriterion {
public:
  Teacher(const ObjectSegmentation& pieces,
          const std::vector<std::uint32_t>& truth,
          LearnedCriterion* learned,
          const Settings& settings,
          std::uint32_t room,
          std::ostream& examples)
  : learned_(learned)
  , share_(settings.share)
  , random_(settings.seed + 1000 * room)
  , truth_(truthOfPieces(pieces, truth))
  , examples_(examples)
  {}

  float
  probability(const JoiningFeatures& features,
              std::uint32_t a,
              std::uint32_t b) override
  {
    const auto [object_a, count_a] = truth_[a].most();
    const auto [object_b, count_b] = truth_[b].most();
    const bool is_one = object_a == object_b && object_a != 0;
    // Of two pieces of structure nobody says whether they are one wall.
    if ((object_a != 0 || object_b != 0) && draw() < share_) {
      const double size_a = truth_[a].size(), size_b = truth_[b].size();
      const double purity = std::min(count_a / size_a, count_b / size_b);
      const double weight = std::sqrt(std::min(size_a, size_b)) * purity * purity;
      writeRow(is_one, weight, features, examples_);
    }
    if (learned_)
      return learned_->probability(features, a, b);
    return is_one ? 0.5f + 0.5f * draw() : 0.0f;
  }

  void
  joined(std::uint32_t kept, std::uint32_t gone) override
  {
    truth_[kept].add(truth_[gone]);
    truth_[gone].counts.clear();
  }

private:
  float
  draw()
  {
    return static_cast<float>(random_() >> 8) / 16777216.0f;
  }

  LearnedCriterion* learned_;
  double share_;
  std::mt19937 random_;
  std::vector<PieceTruth> truth_;
  std::ostream& examples_;
};

/** Save each piece and each union of the tree of joins that is large enough to be told:
 * with the fit as weight as an object, with the rest as none. */
void
saveObjects(const ObjectSegmentation& pieces,
            const std::vector<std::uint32_t>& truth,
            const JoinTree& tree,
            std::ostream& examples)
{
  const auto& graph = stepsOf(pieces).pieces;
  const auto piece_count = graph.pieces.size();
  auto unions = truthOfPieces(pieces, truth);
  PieceTruth all;
  for (const auto& piece : unions)
    all.add(piece);
  for (std::size_t i = 0; i < tree.objects.size(); ++i) {
    auto piece = i;
    if (i >= piece_count) {
      const auto& join = tree.joins[i - piece_count];
      piece = join.kept;
      unions[piece].add(unions[join.gone]);
    }
    const double size = unions[piece].size();
    if (size < ObjectSegmentationOptions().fewest_points ||
        !(graph.pieces[piece].positions.count > 0))
      continue;
    double fit =
        0; // in more than half of the union of both there is one object at most
    for (const auto& [object, count] : unions[piece].counts)
      if (object != 0 && 2 * count > size + all.counts[object] - count)
        fit = count / (size + all.counts[object] - count);
    for (const bool is_object : {true, false}) {
      const double weight = is_object ? fit : 1 - fit;
      if (weight > 0)
        writeRow(is_object, weight, tree.objects[i], examples);
    }
  }
}

/** The bundled voxel network, if it is to be asked. */
VoxelVoter
voterOf(const Settings& settings)
{
  if (!settings.votes)
    return {};
  const auto network =
      std::make_shared<VoxelNetwork>(loadVoxelNetwork(bundledNetworkFile()));
  return {[network](const std::vector<Eigen::Vector3f>& points) {
            return classifyVoxels(points, *network);
          },
          true};
}

void
saveExamples(const Room& room,
             const VoxelVoter& voter,
             LearnedCriterion* learned,
             const Settings& settings,
             std::ostream& examples)
{
  pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
  segmentation.setInputCloud(room.points);
  segmentation.setUseSingleCameraTransform(room.is_view);
  segmentation.setVoxelVoter(voter);
  std::vector<std::uint32_t> labels;
  const auto problem = problemOf([&] { segmentation.segment(labels); });
  if (labels.empty())
    throw ToolError(settings.input + ": " + problem);
  const auto& pieces = segmentation.getResult();
  const auto& graph = stepsOf(pieces).pieces;
  if (settings.objects) {
    saveObjects(pieces, room.truth, joinPieces(graph, *learned), examples);
    return;
  }
  Teacher teacher(pieces, room.truth, learned, settings, room.number, examples);
  joinPieces(graph, teacher);
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  auto parser = makeParser(settings);
  return parser.run(argc, argv, [&](Progress& progress) {
    requireWritable(settings.output);
    if (!settings.part_categories.empty() && settings.names.empty())
      throw ToolError("-part_categories needs -names");
    if (settings.objects && settings.model.empty())
      throw ToolError("-objects needs -model");
    const auto learned = readCriterion(settings.model);
    progress.start("Loading " + settings.input);
    const auto rooms = readRooms(settings);
    if (rooms.empty())
      throw ToolError(settings.input + ": no finite point has a room in the field " +
                      settings.room_field);
    progress.done(std::to_string(rooms.size()) + " rooms");
    progress.start("Joining pieces");
    std::ostringstream examples;
    const auto voter = voterOf(settings);
    for (std::size_t r = 0; r < rooms.size(); ++r) {
      saveExamples(rooms[r], voter, learned.get(), settings, examples);
      progress.update(r + 1, rooms.size());
    }
    const auto bytes = examples.str();
    saveText(settings.output, bytes);
    const auto features = settings.objects ? std::tuple_size<ObjectFeatures>::value
                                           : std::tuple_size<JoiningFeatures>::value;
    progress.done(std::to_string(bytes.size() / sizeof(float) / (2 + features)) +
                  " rows");
  });
}
