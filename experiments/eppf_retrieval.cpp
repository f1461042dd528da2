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
#include "retrieval/descriptor_variants.h"
#include "retrieval/feature_correlation.h"
#include "retrieval/retrieval_report.h"
#include "text/words.h"

#include <pcl/indoor/parallel_for.h>

#include <algorithm>
#include <cstdio>

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
    if (!readWord(part, level) || !(level >= 0 && level <= 100))
      throw ToolError("-noise: '" + part + "' is not a number from 0 to 100");
    levels.push_back(level);
  }
  return levels;
}

SetScale
scaleOf(const LabelledObjects& objects)
{
  std::vector<double> extents;
  for (const auto& cloud : objects.clouds)
    extents.push_back(extentOf(*cloud));
  std::sort(extents.begin(), extents.end());
  return {extents.back(), extents[extents.size() / 2]};
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
    return thesisVariants(settings.ablation, thesis, scale);
  if (settings.ablation != "none")
    return harmonicsVariants(settings.ablation, options);
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

OptionParser
retrievalParser(Settings& settings)
{
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
  return parser;
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  return retrievalParser(settings).run(
      argc, argv, [&](Progress& progress) { run(settings, progress); });
}
