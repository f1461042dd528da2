/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"
#include "command_line/preset.h"
#include "files/cloud_file.h"
#include "objects/described_object.h"
#include "objects/eppf_options.h"
#include "objects/object_files.h"

#include <pcl/conversions.h>

#include <filesystem>

namespace {

using namespace pcl::indoor::tool; // the tools' own support

struct Settings {
  std::vector<std::string> files;
  std::string input_folder;
  std::string output_folder;
  std::string preset = "default";
  int neighbor_count = 20;
  EPPFCommandLine eppf;
};

template <typename SignatureT>
void
describe(const std::string& input, const std::string& output, const Settings& settings)
{
  const auto object = loadObject(input, settings.neighbor_count);
  pcl::PointCloud<SignatureT> descriptor;
  descriptor.push_back(
      describedObject<SignatureT>(object, settings.eppf.options(), input));
  pcl::PCLPointCloud2 cloud;
  pcl::toPCLPointCloud2(descriptor, cloud);
  saveCloud(output, cloud);
}

void
describeFile(const std::string& input,
             const std::string& output,
             const Settings& settings)
{
  switch (settings.eppf.descriptor()) {
  case EPPFDescriptor::PairHarmonics:
    return describe<pcl::PairHarmonicsSignature1200>(input, output, settings);
  case EPPFDescriptor::EPPF:
    return describe<pcl::EPPFSignature1200>(input, output, settings);
  case EPPFDescriptor::EPPFShort:
    return describe<pcl::EPPFSignature540>(input, output, settings);
  }
}

void
describeFolder(const Settings& settings, Progress& progress)
{
  namespace fs = std::filesystem;
  const auto paths = objectFilesIn(settings.input_folder);
  progress.start("Describing " + std::to_string(paths.size()) + " objects");
  std::size_t failed = 0;
  std::string first_problem;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    progress.update(k, paths.size());
    try {
      const auto input = fs::path(settings.input_folder) / paths[k];
      auto output = fs::path(settings.output_folder) / paths[k];
      output.replace_extension(".pcd");
      std::error_code error;
      fs::create_directories(output.parent_path(), error);
      if (error)
        throw ToolError(output.parent_path().string() +
                        ": cannot be made: " + error.message());
      describeFile(input.string(), output.string(), settings);
    } catch (const ToolError& problem) {
      if (failed++ == 0)
        first_problem = problem.what();
    }
  }
  progress.done(std::to_string(paths.size() - failed) + " descriptors");
  if (failed > 0)
    throw ToolError(std::to_string(failed) + " of " + std::to_string(paths.size()) +
                    " files could not be described; the first: " + first_problem);
}

void
run(const Settings& settings, Progress& progress)
{
  const bool has_folders =
      !settings.input_folder.empty() || !settings.output_folder.empty();
  const auto bins = settings.eppf.options().bins.size();
  requireFittingBins(settings.eppf);
  if (has_folders) {
    if (settings.input_folder.empty() || settings.output_folder.empty() ||
        !settings.files.empty())
      throw ToolError("give either an input and an output file, or -input_dir and "
                      "-output_dir");
    describeFolder(settings, progress);
    return;
  }
  if (settings.files.size() != 2)
    throw ToolError("an input and an output file are needed, not " +
                    std::to_string(settings.files.size()) + " files");
  requireWritableCloud(settings.files[1], true);
  progress.start("Describing " + settings.files[0]);
  describeFile(settings.files[0], settings.files[1], settings);
  progress.done(std::to_string(bins) + " bins");
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  OptionParser parser("pcl_eppf_estimation",
                      "Describe an object by a histogram of point pairs and harmonics, "
                      "as one PairHarmonicsSignature1200, or by enhanced point pair "
                      "features (EPPF), as one EPPFSignature1200.");
  parser
      .positionals("input.pcd output.pcd",
                   settings.files,
                   "the object's cloud and where its descriptor goes",
                   0)
      .text("-input_dir", settings.input_folder, "describe all clouds of this folder")
      .text("-output_dir", settings.output_folder, "and put the descriptors there")
      .number("-normal_neighbors",
              settings.neighbor_count,
              "neighbours of a normal, where the file has no normals",
              "points",
              Range::atLeast(3));
  parser.text("-preset",
              settings.preset,
              "thesis: -descriptor eppf, the descriptor of the thesis",
              {"default", "thesis"});
  settings.eppf.addDescriptorTo(parser,
                                presetOf(argc, argv) == "thesis"
                                    ? EPPFDescriptor::EPPF
                                    : EPPFDescriptor::PairHarmonics);
  settings.eppf.addTo(parser);
  return parser.run(argc, argv, [&](Progress& progress) { run(settings, progress); });
}
