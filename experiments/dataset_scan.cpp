/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/cloud_options.h"
#include "command_line/options.h"
#include "datasets/depth_image.h"
#include "datasets/s3dis.h"
#include "datasets/scannet.h"
#include "files/output_file.h"
#include "files/point_coordinates.h"
#include "formats/table/table_columns.h" // for listedNames

#include <filesystem>

using namespace pcl::indoor::tool;

namespace {

struct Options {
  std::string input, output, json, structure;
  DepthImageFiles image;
  PointCoordinates coordinates;
};

OptionParser
makeParser(Options& options)
{
  auto& image = options.image;
  OptionParser parser("pcl_dataset_scan",
                      "Turns a scan of S3DIS, ScanNet, NYU v2, SUN RGB-D or OSD into a "
                      "cloud with its truth in the fields object, category and room.");
  parser
      .positional("scan",
                  options.input,
                  "folder of a room or an area of S3DIS, of a scene of ScanNet or of a "
                  "scan of SUN RGB-D; depth image (PNG); or cloud of OSD")
      .positional("output.pcd", options.output, "PCD or PLY file")
      .text("-json", options.json, "file for the names of categories and rooms")
      .text("-labels",
            image.labels,
            "PNG as large as the depth image, number of each pixel's category; for a "
            "cloud of OSD, of its object (without it, from the cloud's field label)")
      .text("-instances",
            image.instances,
            "PNG, number of each pixel's object in its category; without it, a "
            "category is an object")
      .text("-color", image.color, "PNG, colours of the depth image")
      .text("-intrinsics",
            image.intrinsics,
            "text file of the 9 numbers of the camera matrix; a folder of SUN RGB-D "
            "has one")
      .text("-label_names", image.label_names, "text file, a line per label from 1")
      .text("-structure",
            options.structure,
            "categories, separated by commas, whose objects are none: object 0")
      .number("-depth_unit",
              image.depth_unit,
              "of the numbers of the depth image",
              "m",
              Range::positive())
      .flag("-rotated",
            image.is_rotated,
            "the bits of depths are rotated by three, as in SUN RGB-D, of whose "
            "folders this is known");
  addOption(parser, options.coordinates);
  parser.expert({"-structure", "-depth_unit", "-rotated", "-double"});
  return parser;
}

/** \throws ToolError if one of these options, which need other input, was given */
void
refuse(const std::vector<std::pair<const char*, const std::string&>>& options,
       const Options& given,
       const std::string& reason)
{
  for (const auto& [name, value] : options)
    if (!value.empty())
      throw ToolError(std::string(name) + ": " + given.input + " is " + reason);
}

void
refuseImageOptions(const Options& options)
{
  const auto& image = options.image;
  refuse({{"-labels", image.labels},
          {"-instances", image.instances},
          {"-color", image.color},
          {"-intrinsics", image.intrinsics},
          {"-label_names", image.label_names}},
         options,
         "no depth image");
}

LabelledScan
readImage(const Options& options)
{
  if (options.image.labels.empty())
    throw ToolError("-labels: a depth image needs the image of its labels");
  if (options.image.intrinsics.empty())
    throw ToolError("-intrinsics: a depth image needs the camera matrix");
  return readDepthImage(options.image);
}

LabelledScan
readFolder(Options& options)
{
  const auto& folder = options.input;
  if (isSunRgbd(folder)) {
    findSunRgbd(folder, options.image);
    return readImage(options);
  }
  const bool is_scannet = isScanNet(folder);
  if (!is_scannet && !isS3dis(folder))
    throw ToolError(folder + ": no scan; neither Annotations (S3DIS) nor "
                             "*_vh_clean_2.ply (ScanNet) nor depth and intrinsics.txt "
                             "(SUN RGB-D) are in it");
  refuseImageOptions(options);
  return is_scannet ? readScanNet(folder) : readS3dis(folder);
}

LabelledScan
readScan(Options& options)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path input = options.input;
  if (!fs::exists(input, error))
    throw ToolError(options.input + ": no such file or folder");
  if (fs::is_directory(input, error))
    return readFolder(options);
  if (input.extension() == ".png") {
    options.image.depth = options.input;
    return readImage(options);
  }
  const auto labels = std::move(options.image.labels);
  options.image.labels.clear();
  refuseImageOptions(options);
  refuse({{"-json", options.json}, {"-structure", options.structure}},
         options,
         "a cloud without categories");
  return readLabelledCloud(options.input, labels);
}

void
convert(Options& options, Progress& progress)
{
  requireWritableCloud(options.output);
  if (!options.json.empty())
    requireWritable(options.json);
  progress.start("Loading " + options.input);
  auto scan = readScan(options);
  printNotes(scan.file);
  if (!options.structure.empty())
    clearObjects(scan, listedNames(options.structure));
  appendTruth(scan);
  options.coordinates.apply(scan.file, options.output);
  progress.done(std::to_string(scan.objects.size()) + " points");
  progress.start("Saving " + options.output);
  std::vector<OutputFile> files;
  if (!options.json.empty())
    files.push_back(writtenBeside(options.json, describeTruth(scan)));
  files.push_back(cloudBeside(options.output, scan.file.cloud, scan.file.pose));
  commitTogether(files);
  progress.done();
}

} // namespace

int
main(int argc, char** argv)
{
  Options options;
  return makeParser(options).run(
      argc, argv, [&](Progress& progress) { convert(options, progress); });
}
