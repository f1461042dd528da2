/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "command_line/options.h"
#include "comparison/measured_segmentation.h"
#include "comparison/upstream_baselines.h"
#include "comparison/upstream_lccp.h"
#include "files/cloud_file.h"
#include "formats/json_text.h"
#include "pictures/comparison_picture.h"
#include "pictures/svg_raster.h"
#include "scene/single_view.h"
#include "text/formatted.h"
#include "text/pcl_errors.h"
#include "text/printable.h"

#include <pcl/segmentation/noise_resilient_lccp.h>
#include <pcl/segmentation/segmentation_metrics.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <set>
#include <type_traits>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

using Labels = std::vector<std::uint32_t>;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** A way to segment a cloud, and its results so far. */
struct Method {
  std::string name;
  bool in_picture; ///< the four that the picture shows beside the truth
  std::function<Labels(const Cloud::Ptr&)> segment;
  std::vector<nlohmann::json> scenes = {};
  std::string problem = {}; ///< of the first scan that it failed on
};

struct Settings {
  std::vector<std::string> inputs;
  std::string preset = "auto", truth_field = "label", coarse_field;
  std::string json_path, picture_path, methods = "all";
  unsigned threads = 1;
};

/** \param[in] options ours or the thesis's */
template <typename Options>
Labels
segmentOurs(const Cloud::Ptr& cloud, const Options& options, const Settings& settings)
{
  pcl::NoiseResilientLCCP<pcl::PointXYZ> segmentation;
  if constexpr (std::is_same_v<Options, thesis::ObjectOptions>)
    segmentation.setThesisOptions(options);
  else
    segmentation.setOptions(options);
  segmentation.setNumberOfThreads(settings.threads);
  segmentation.setInputCloud(cloud);
  Labels labels;
  const auto problem = problemOf([&] { segmentation.segment(labels); });
  if (labels.empty())
    throw ToolError(problem);
  return labels;
}

template <typename Options>
auto
ownBy(const Options& options, const Settings& settings)
{
  return [options, settings](const Cloud::Ptr& cloud) {
    return segmentOurs(cloud, options, settings);
  };
}

/** The thesis's method and its combination with LCCP (Table 4.1); -preset says for
 * which sensor. */
std::vector<Method>
thesisMethods(bool single_view, const Settings& settings)
{
  const bool kinect = settings.preset == "thesis_kinect" || single_view;
  auto proposed = kinect ? thesisKinectOptions() : thesisOptions();
  if (single_view && settings.preset != "thesis_kinect") { // objects on a table
    const auto view = withSizes(singleViewOptions());
    proposed.shared.voxel_size = view.voxel_size;
    proposed.shared.seed_size = view.seed_size;
  }
  auto with_lccp = proposed;
  with_lccp.edges.partition = thesis::EdgePartition::Lccp;
  return {{"thesis", false, ownBy(proposed, settings)},
          {"thesis + LCCP", false, ownBy(with_lccp, settings)}};
}

/** Segmentations of upstream's that know neither supervoxels nor convexity. */
std::vector<Method>
baselines(bool single_view, const Settings& settings)
{
  std::vector<Method> methods;
  for (const auto& [name, baseline] :
       {std::make_pair("growing by normals", Baseline::SmoothGrowing),
        std::make_pair("growing by FPFH", Baseline::FeatureGrowing),
        std::make_pair("Euclidean clusters", Baseline::EuclideanClusters),
        std::make_pair("Felzenszwalb on normals", Baseline::NormalGraph)}) {
    BaselineOptions options;
    options.baseline = baseline;
    options.single_camera = single_view;
    options.threads = settings.threads;
    if (single_view)
      options.voxel_size = withSizes(singleViewOptions()).voxel_size;
    methods.push_back({name, false, [options](const Cloud::Ptr& cloud) {
                         return segmentBaseline(*cloud, options);
                       }});
  }
  return methods;
}

/** Upstream at its example's defaults and tuned, ours by other partitions, and ours; of
 * rooms also their parts. */
std::vector<Method>
methodsFor(bool single_view, const Settings& settings)
{
  if (settings.methods == "thesis")
    return thesisMethods(single_view, settings);
  if (settings.methods == "baselines")
    return baselines(single_view, settings);
  const auto ours = single_view ? singleViewOptions() : ObjectSegmentationOptions();
  const auto sizes = withSizes(ours);
  const auto plain = exampleUpstreamOptions(single_view, settings.threads);
  const auto tuned = tunedUpstreamOptions(
      single_view, settings.threads, sizes.voxel_size, sizes.seed_size);
  const auto upstream = [](const UpstreamOptions& options) {
    return
        [options](const Cloud::Ptr& cloud) { return segmentUpstream(*cloud, options); };
  };
  const thesis::ObjectOptions graph{ours, {}, {}};
  auto lccp = graph;
  lccp.edges.partition = thesis::EdgePartition::Lccp;
  std::vector<Method> methods{{"LCCP, example's defaults", true, upstream(plain)},
                              {"LCCP, tuned", true, upstream(tuned)},
                              {"ours + LCCP", true, ownBy(lccp, settings)},
                              {"ours + Felzenszwalb", false, ownBy(graph, settings)},
                              {"ours", true, ownBy(ours, settings)}};
  if (!single_view)
    methods.push_back({"ours, parts", false, ownBy(partsOptions(), settings)});
  for (auto* more : {&thesisMethods, &baselines})
    for (auto& method : more(single_view, settings))
      methods.push_back(std::move(method));
  return methods;
}

nlohmann::json
evaluate(const Labels& truth, const Labels& coarse, const MeasuredSegmentation& result)
{
  const auto& labels = result.labels;
  const auto overlaps = countOverlaps(truth, labels);
  const auto errors = coarse.empty() ? richtsfeldErrors(overlaps)
                                     : multiScaleErrors(truth, coarse, labels);
  std::set<std::uint32_t> segments(labels.begin(), labels.end());
  segments.erase(0);
  std::size_t unlabelled = 0;
  for (const auto& overlap : overlaps)
    unlabelled += overlap.predicted == 0 ? overlap.count : 0;
  return {{"oversegmentation", errors.over},
          {"undersegmentation", errors.under},
          {"weighted_overlap", weightedOverlap(overlaps)},
          {"segments", segments.size()},
          {"points_without_segment", unlabelled},
          {"seconds", result.seconds},
          {"megabytes", result.megabytes}};
}

double
mean(const std::vector<nlohmann::json>& scenes, const char* key)
{
  double sum = 0;
  for (const auto& scene : scenes)
    sum += scene.at(key).get<double>();
  return sum / static_cast<double>(scenes.size());
}

/** The numbers of a method's row, or why it has none. */
void
printRow(const Method& method)
{
  if (!method.problem.empty()) {
    std::printf("%-26s %s\n", method.name.c_str(), printable(method.problem).c_str());
    return;
  }
  std::printf("%-26s %8.2f %8.2f %8.2f %9.0f %9.3f %9.0f\n",
              method.name.c_str(),
              100 * mean(method.scenes, "oversegmentation"),
              100 * mean(method.scenes, "undersegmentation"),
              100 * mean(method.scenes, "weighted_overlap"),
              mean(method.scenes, "segments"),
              mean(method.scenes, "seconds"),
              mean(method.scenes, "megabytes"));
}

void
printTable(const std::vector<Method>& methods)
{
  std::printf("%-26s %8s %8s %8s %9s %9s %9s\n",
              "method",
              "OS [%]",
              "US [%]",
              "WO [%]",
              "segments",
              "time [s]",
              "mem [MB]");
  for (const auto& method : methods)
    printRow(method);
}

void
saveResults(const std::string& path,
            const std::vector<std::string>& inputs,
            const std::vector<Method>& methods)
{
  nlohmann::json result;
  for (const auto& method : methods) {
    auto& entry = result[method.name];
    if (method.problem.empty())
      for (const auto& field : method.scenes.front().items())
        entry["mean"][field.key()] = mean(method.scenes, field.key().c_str());
    for (std::size_t i = 0; i < inputs.size(); ++i)
      entry["scenes"][inputs[i]] = method.scenes[i];
  }
  saveText(path, jsonText(result));
}

/** For example "ours: OS 0.5 %, US 0.3 %"; what an apostrophe belongs to is left out.
 */
std::string
titleOf(const Method& method)
{
  const auto& errors = method.scenes.back();
  const auto name = method.name.find('\'') == std::string::npos ? method.name : "LCCP";
  return name + formatted(": OS %.1f %%, US %.1f %%",
                          100 * errors.at("oversegmentation").get<double>(),
                          100 * errors.at("undersegmentation").get<double>());
}

bool
comparesViews(const Settings& settings, const CloudFile& file)
{
  return settings.preset == "single_view" ||
         (settings.preset == "auto" && isSingleView(file.points));
}

void
compare(const Settings& settings, Progress& progress)
{
  std::vector<Method> methods;
  std::vector<std::pair<Cloud::Ptr, std::vector<LabelledView>>> rows;
  bool single_view = false;
  for (const auto& input : settings.inputs) {
    const CloudFile file = loadCloud(input);
    const auto truth = readLabels(file, settings.truth_field);
    const auto coarse = settings.coarse_field.empty()
                            ? Labels()
                            : readLabels(file, settings.coarse_field);
    if (methods.empty()) {
      single_view = comparesViews(settings, file);
      methods = methodsFor(single_view, settings);
    }
    else if (single_view != comparesViews(settings, file))
      throw ToolError(input + ": views of tables and rooms cannot be in one table");
    std::vector<LabelledView> views{{"Truth", truth}};
    for (auto& method : methods) {
      progress.start(method.name + ", " + input);
      const auto result = segmentMeasured([&] { return method.segment(file.points); });
      if (!result.problem.empty()) {
        method.scenes.push_back({{"problem", result.problem}});
        if (method.problem.empty())
          method.problem = result.problem + ": " + input;
        if (method.in_picture)
          views.push_back({"Failed", Labels(truth.size(), 0)});
      }
      else {
        method.scenes.push_back(evaluate(truth, coarse, result));
        if (method.in_picture)
          views.push_back({titleOf(method), result.labels});
      }
      progress.done();
    }
    if (!settings.picture_path.empty())
      rows.emplace_back(file.points, std::move(views));
  }
  printTable(methods);
  const auto fails = [](const Method& method) { return !method.problem.empty(); };
  if (std::all_of(methods.begin(), methods.end(), fails))
    throw ToolError("no method could segment all of the input");
  if (!settings.json_path.empty())
    saveResults(settings.json_path, settings.inputs, methods);
  // Only now: drawing has several threads, after which no process can be measured.
  std::vector<SvgDrawing> drawings;
  for (const auto& row : rows)
    drawings.push_back(drawSideBySide(*row.first, single_view, row.second));
  if (!settings.picture_path.empty())
    savePictures({{settings.picture_path, stacked(drawings, 10.0).str(), 1.0}});
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  OptionParser parser(
      "pcl_lccp_comparison",
      "Compare upstream's LCCPSegmentation with NoiseResilientLCCP on labelled scans: "
      "over- and undersegmentation, weighted overlap, time and memory, as means over "
      "the "
      "scans. "
      "Points whose true label is 0 are segmented, but not scored.");
  parser
      .positionals(
          "room.pcd", settings.inputs, "PCD or PLY files with the true labels, metres")
      .text("-preset",
            settings.preset,
            "what was scanned; auto: single_view if the first input is a camera's "
            "view of a table; thesis, thesis_kinect: the rows of the thesis alone, "
            "with its parameters for laser scans or the Kinect",
            {"auto", "room", "single_view", "thesis", "thesis_kinect"})
      .text("-methods",
            settings.methods,
            "which rows: those of upstream's LCCP and ours, the thesis's, other "
            "segmentations of upstream's, or all",
            {"all", "thesis", "baselines"})
      .text("-truth_field", settings.truth_field, "field of the truth; 0 = not scored")
      .text("-coarse_field",
            settings.coarse_field,
            "field with the objects that the truth's parts belong to: the multi-scale "
            "errors are given")
      .text("-json", settings.json_path, "file to write all results to")
      .text("-picture",
            settings.picture_path,
            "PNG or SVG file of the truth and the clouds of four methods side by side, "
            "one row "
            "per input")
      .number("-threads", settings.threads, "threads of all methods, 0 = automatic");
  parser.expert({"-preset", "-methods", "-coarse_field"});
  return parser.run(argc, argv, [&](Progress& progress) {
    if (settings.preset == "thesis" || settings.preset == "thesis_kinect")
      settings.methods = "thesis";
    if (!settings.json_path.empty())
      requireWritable(settings.json_path);
    if (!settings.picture_path.empty())
      requireWritable(settings.picture_path);
    compare(settings, progress);
  });
}
