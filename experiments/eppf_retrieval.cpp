/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"
#include "command_line/progress_report.h"
#include "files/cloud_file.h"
#include "formats/table/table_columns.h" // for listedNames
#include "objects/eppf_options.h"
#include "objects/labelled_objects.h"
#include "objects/object_files.h"
#include "pictures/svg_raster.h"
#include "retrieval/feature_correlation.h"
#include "retrieval/retrieval_report.h"

#include <pcl/indoor/parallel_for.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <sstream>

namespace {

using namespace pcl::indoor; // a tool of the cores
using namespace pcl::indoor::tool;

struct Settings {
  std::string folder;
  std::string descriptors = "all";
  std::string distances = "kl,l1";
  std::string noise = "0";
  std::string ablation = "none";
  std::string scale_by = "own";
  std::string normal_method = "given";
  bool correlation = false;
  std::string json;
  std::string confusion;
  std::string confusion_picture;
  std::string plot;
  ExperimentSettings experiment;
  EPPFCommandLine eppf;
};

std::vector<HistogramDistance>
readDistances(const std::string& text)
{
  const HistogramDistance all[] = {HistogramDistance::SymmetricKullbackLeibler,
                                   HistogramDistance::L1,
                                   HistogramDistance::L2,
                                   HistogramDistance::ChiSquared};
  std::vector<HistogramDistance> distances;
  for (const auto& name : listedNames(text)) {
    const auto found = std::find_if(std::begin(all), std::end(all), [&](auto distance) {
      return distanceName(distance) == name;
    });
    if (found == std::end(all))
      throw ToolError("-distances: '" + name + "' is none of kl, l1, l2, chi2");
    distances.push_back(*found);
  }
  return distances;
}

std::vector<double>
readNoise(const std::string& text)
{
  std::vector<double> levels;
  for (const auto& part : listedNames(text)) {
    double level = 0.0;
    const auto* const end = part.data() + part.size();
    const auto result = std::from_chars(part.data(), end, level);
    if (result.ec != std::errc() || result.ptr != end || !(level >= 0 && level <= 100))
      throw ToolError("-noise: '" + part + "' is not a number from 0 to 100");
    levels.push_back(level);
  }
  return levels;
}

/** \brief Variants of pair harmonics as those of EPPF in Fig. 5.11 to 5.13, and of its
 * other choices. */
std::vector<RetrievalDescriptor>
ablation(const std::string& what, const EPPFOptions& options)
{
  std::vector<RetrievalDescriptor> variants = {
      eppfDescriptor("pair_harmonics", options)};
  const auto add = [&](const std::string& name, auto change) {
    auto changed = options;
    change(changed);
    variants.push_back(eppfDescriptor(name, changed));
  };
  if (what == "features") {
    add("without f1", [](auto& o) { o.features.distance = false; });
    add("without f2", [](auto& o) { o.features.surface_angle = false; });
    add("without f3", [](auto& o) { o.features.normal_angle = false; });
    add("with f4", [](auto& o) { o.bins = {4, 15, 5, 2, o.bins.harmonics}; });
    add("without harmonics", [](auto& o) { o.features.harmonics = false; });
    add("pairs in all bins", [](auto& o) { o.bins = {16, 15, 5, 1, {}}; });
  }
  else if (what == "surface_angle") {
    const auto use = [](auto& o, SurfaceAngleRule rule) {
      o.surface_angle_rule = rule; // 8 x 5 x 5 x 3 bins, f4 among them
      o.bins = {8, 5, 5, 3, o.bins.harmonics};
    };
    add("maximum", [=](auto& o) { use(o, SurfaceAngleRule::Maximum); });
    add("minimum", [=](auto& o) { use(o, SurfaceAngleRule::Minimum); });
    add("mean", [=](auto& o) { use(o, SurfaceAngleRule::Mean); });
    add("random", [=](auto& o) { use(o, SurfaceAngleRule::RandomOne); });
    add("both, not f4",
        [=](auto& o) { use(o, SurfaceAngleRule::BothInsteadOfOccupancy); });
  }
  else if (what == "normals") {
    add("outward", [](auto& o) { o.normal_sides = NormalSides::Outward; });
    add("given", [](auto& o) { o.normal_sides = NormalSides::Given; });
    add("angle between",
        [](auto& o) { o.normal_angle_rule = NormalAngleRule::Between; });
    add("ignored", [](auto& o) { o.normal_sides = NormalSides::Ignored; });
  }
  else if (what == "scale")
    for (const double scale : {0.5, 0.7, 1.0, 1.2, 1.4, 1.7, 2.0}) {
      std::ostringstream name;
      name << "scale " << scale << " m";
      add(name.str(), [scale](auto& o) { o.scale = scale; });
    }
  else if (what == "grid")
    for (const int size : {8, 16, 24, 32, 48, 64})
      add("f4, grid " + std::to_string(size), [size](auto& o) {
        o.bins = {4, 15, 5, 2, o.bins.harmonics};
        o.grid_size = size;
      });
  else if (what == "sampling")
    for (const std::size_t count : {2000u, 5000u, 10000u, 20000u, 50000u}) {
      add("uniform " + std::to_string(count), [count](auto& o) {
        o.sampling = PairSampling::Uniform;
        o.pair_count = count;
      });
      add("stratified " + std::to_string(count), [count](auto& o) {
        o.sampling = PairSampling::Stratified;
        o.pair_count = count;
      });
    }
  return variants;
}

/** \brief The lengths that f1 may spread over, from the objects of a set (Fig. 5.12).
 */
struct SetScale {
  double largest = 0, median = 0; ///< extent of an object
};

SetScale
scaleOf(const LabelledObjects& objects)
{
  std::vector<double> extents;
  for (const auto& cloud : objects.clouds)
    extents.push_back(extentOf(*cloud));
  std::sort(extents.begin(), extents.end());
  return {extents.back(), extents[extents.size() / 2]};
}

/** \brief Variants of the thesis's descriptor with its bins: Fig. 5.11 to 5.13. */
std::vector<RetrievalDescriptor>
thesisAblation(const std::string& what,
               const EPPFOptions& options,
               const SetScale& scale)
{
  std::vector<RetrievalDescriptor> variants;
  const auto add = [&](const std::string& name, auto change) {
    auto changed = options;
    change(changed);
    variants.push_back(eppfDescriptor(name, changed));
  };
  if (what == "thesis_scale") {
    add("maximum", [&](auto& o) { o.scale = scale.largest; });
    add("median", [&](auto& o) { o.scale = scale.median; });
    add("unit cube", [](auto& o) { o.scale = 0; });
  }
  else if (what == "thesis_features") {
    add("eppf", [](auto&) {});
    add("without f1", [](auto& o) { o.features.distance = false; });
    add("without f2", [](auto& o) { o.features.surface_angle = false; });
    add("without f3", [](auto& o) { o.features.normal_angle = false; });
    add("without f4", [](auto& o) { o.features.occupancy = false; });
  }
  else
    for (const auto& [name, rule] :
         {std::make_pair("maximum", SurfaceAngleRule::Maximum),
          std::make_pair("minimum", SurfaceAngleRule::Minimum),
          std::make_pair("mean", SurfaceAngleRule::Mean),
          std::make_pair("one only", SurfaceAngleRule::RandomOne),
          std::make_pair("both instead of f4",
                         SurfaceAngleRule::BothInsteadOfOccupancy)})
      add(name, [&, rule = rule](auto& o) { o.surface_angle_rule = rule; });
  return variants;
}

/** \brief What a descriptor of the thesis takes from the command line: pairs and scale.
 */
EPPFOptions
withPairsAndScale(EPPFOptions options, const EPPFOptions& given)
{
  options.pair_count = given.pair_count;
  options.scale = given.scale;
  options.seed = given.seed;
  return options;
}

/** \brief The options of the command line, with the set's scale if it is wanted. */
EPPFOptions
scaledOptions(const Settings& settings, const SetScale& scale)
{
  auto options = settings.eppf.options();
  if (settings.scale_by != "own")
    options.scale = settings.scale_by == "largest" ? scale.largest : scale.median;
  return options;
}

std::vector<RetrievalDescriptor>
chosenDescriptors(const Settings& settings, const SetScale& scale)
{
  const auto options = scaledOptions(settings, scale);
  const auto thesis = withPairsAndScale(thesisEPPFOptions(), options);
  if (settings.ablation.rfind("thesis_", 0) == 0)
    return thesisAblation(settings.ablation, thesis, scale);
  if (settings.ablation != "none")
    return ablation(settings.ablation, options);
  std::vector<RetrievalDescriptor> known = {
      eppfDescriptor("pair_harmonics", options),
      eppfDescriptor("eppf", thesis),
      eppfDescriptor("eppf_short", withPairsAndScale(shortEPPFOptions(), options)),
      surfletPairDescriptor(5),
      surfletPairDescriptor(6)};
  for (auto& peer : peerDescriptors())
    known.push_back(std::move(peer));
  if (settings.descriptors == "all")
    return known;
  std::vector<RetrievalDescriptor> chosen;
  for (const auto& name : listedNames(settings.descriptors)) {
    const auto found = std::find_if(
        known.begin(), known.end(), [&](const auto& one) { return one.name == name; });
    if (found == known.end()) {
      std::string names = "all";
      for (const auto& one : known)
        names += ", " + one.name;
      throw ToolError("-descriptors: '" + name + "' is none of " + names);
    }
    chosen.push_back(*found);
  }
  return chosen;
}

void
writeReports(const std::vector<RetrievalLevel>& levels,
             const LabelledObjects& objects,
             const Settings& settings)
{
  const auto& first = levels.front().results.front();
  if (!settings.json.empty())
    saveText(settings.json, resultJson(levels, objects, settings.experiment));
  if (!settings.confusion.empty())
    saveText(settings.confusion, confusionText(first.confusion, objects.class_names));
  std::vector<Picture> pictures;
  if (!settings.confusion_picture.empty())
    pictures.push_back({settings.confusion_picture,
                        confusionPicture(first.confusion, objects.class_names).str()});
  if (!settings.plot.empty())
    pictures.push_back(
        {settings.plot,
         (levels.size() > 1 ? noisePicture(levels) : barPicture(levels.front().results))
             .str()});
  savePictures(pictures);
}

/** \brief Estimate all normals by RRHT in place of those that were loaded. */
void
estimateHoughNormals(LabelledObjects& objects, unsigned threads, Progress& progress)
{
  const auto count = objects.clouds.size();
  progress.start("Estimating normals");
  std::size_t done = 0;
  parallelFor(static_cast<std::ptrdiff_t>(count),
              static_cast<int>(threads),
              1,
              [&](std::ptrdiff_t k) {
                tool::estimateHoughNormals(
                    *objects.clouds[static_cast<std::size_t>(k)]);
#pragma omp critical(pcl_indoor_progress)
                progress.update(++done, count);
              });
  progress.done(std::to_string(count) + " objects");
}

void
run(const Settings& settings, Progress& progress)
{
  chosenDescriptors(settings, {1, 1}); // complains before anything is read
  const auto noise_levels = readNoise(settings.noise);
  const bool is_noisy = std::any_of(
      noise_levels.begin(), noise_levels.end(), [](double level) { return level > 0; });
  if (settings.normal_method == "rrht" &&
      (is_noisy || settings.experiment.disturbance.estimates_normals))
    throw ToolError("-normal_method rrht: normals under noise, and those of "
                    "-estimate_normals, are of planes");
  auto experiment = settings.experiment;
  experiment.distances = readDistances(settings.distances);
  for (const auto& path :
       {settings.json, settings.confusion, settings.confusion_picture, settings.plot})
    if (!path.empty())
      requireWritable(path);
  ProgressReport report(progress);
  auto objects = loadLabelledObjects(
      settings.folder, experiment.neighbor_count, experiment.number_of_threads, report);
  if (settings.normal_method == "rrht")
    estimateHoughNormals(objects, experiment.number_of_threads, progress);
  const auto scale = scaleOf(objects);
  const auto descriptors = chosenDescriptors(settings, scale);
  if (settings.correlation)
    std::fputs(correlationText(
                   featureCorrelation(objects.clouds, scaledOptions(settings, scale)))
                   .c_str(),
               stdout);
  std::vector<RetrievalLevel> levels;
  for (const double noise : noise_levels) {
    experiment.disturbance.noise_percent = noise;
    levels.push_back({noise, runRetrieval(objects, descriptors, experiment, progress)});
    std::printf("%zu objects, %zu classes, noise %g %%, hidden %g %%\n%s",
                objects.clouds.size(),
                objects.class_names.size(),
                noise,
                experiment.disturbance.hidden_percent,
                resultTable(levels.back().results).c_str());
    std::fflush(stdout);
  }
  writeReports(levels, objects, settings);
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  OptionParser parser("pcl_eppf_retrieval",
                      "Compare descriptors by leave-one-out retrieval of the objects "
                      "DIR/CLASS/OBJECT.pcd.");
  auto& experiment = settings.experiment;
  parser
      .positional("DIR", settings.folder, "a folder per class with the objects' clouds")
      .text("-descriptors",
            settings.descriptors,
            "all, or some of pair_harmonics (which the options change),eppf (of the "
            "thesis),eppf_short,wahl,wahl_6,esf,vfh,our_cvfh,gasd,grsd,shot")
      .text("-distances", settings.distances, "some of kl,l1,l2,chi2")
      .number("-repeats",
              experiment.repeat_count,
              "repeats with other seeds",
              "",
              Range::between(1, 1000))
      .text("-noise", settings.noise, "deviations of noise, % of an object's extent")
      .number("-hidden",
              experiment.disturbance.hidden_percent,
              "share of each object that a single view hides",
              "%",
              Range::between(0, 95))
      .flag("-estimate_normals",
            experiment.disturbance.estimates_normals,
            "also where there is no noise: the same normals at every level")
      .number("-normal_radius",
              experiment.disturbance.normal_radius,
              "neighbourhood of a normal under noise, if -normal_neighbors is smaller",
              "deviations",
              Range::between(0, 100))
      .flag("-camera",
            experiment.disturbance.before_camera,
            "place each object before a camera at the origin, from a random side")
      .flag("-clean_gallery",
            experiment.clean_gallery,
            "compare noisy or hidden objects with untouched ones")
      .text("-ablation",
            settings.ablation,
            "compare variants of pair harmonics instead, or those of the thesis's "
            "descriptor (Fig. 5.11, 5.13, 5.12)",
            {"none",
             "features",
             "surface_angle",
             "normals",
             "scale",
             "grid",
             "sampling",
             "thesis_features",
             "thesis_surface_angle",
             "thesis_scale"})
      .text("-scale_by",
            settings.scale_by,
            "length the distance bins spread over: own = -scale, or the extent of the "
            "largest or of the median object of the set",
            {"own", "largest", "median"})
      .text("-normal_method",
            settings.normal_method,
            "given: those of the file or of the mesh's faces, or of planes where it "
            "has none; rrht: estimated by RRHT in all objects, as the thesis does on "
            "samples of meshes",
            {"given", "rrht"})
      .flag("-correlation",
            settings.correlation,
            "print the Pearson correlation of the thesis's features over the pairs of "
            "all objects, Eq. (5.9)")
      .number("-normal_neighbors",
              experiment.neighbor_count,
              "neighbours of a normal that has to be estimated",
              "points",
              Range::atLeast(3))
      .text("-json", settings.json, "write all numbers to this file")
      .text(
          "-confusion", settings.confusion, "write the first confusion matrix as text")
      .text("-confusion_picture", settings.confusion_picture, "and as PNG or SVG")
      .text("-plot",
            settings.plot,
            "write a PNG or SVG: accuracy over noise, or bars of F1");
  settings.eppf.addTo(parser);
  return parser.run(argc, argv, [&](Progress& progress) { run(settings, progress); });
}
