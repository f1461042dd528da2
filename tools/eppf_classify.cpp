/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"
#include "command_line/progress_report.h"
#include "files/output_file.h"
#include "objects/file_classification.h"

#include <pcl/ml/model_file.h>

#include <cstdio>

namespace {

using namespace pcl::indoor::tool; // the tools' own support

struct Settings {
  std::vector<std::string> arguments;
  std::string known_folder;
  std::string json;
  std::string descriptor = "pair_harmonics"; ///< of -nearest
  ClassificationSettings classification;
};

std::vector<ClassifiedFile>
classified(const Settings& settings, Progress& progress)
{
  ProgressReport report(progress);
  auto paths = settings.arguments;
  if (!settings.known_folder.empty()) {
    const auto known = objectsOfFolder(settings.known_folder);
    auto classification = settings.classification;
    if (settings.descriptor == "point_nn")
      classification.descriptor = NearestDescriptor::PointNN;
    return classifyByNearest(objectFiles(paths), known, classification, report);
  }
  if (settings.descriptor == "point_nn")
    throw ToolError("-descriptor: point_nn goes with -nearest only");
  if (paths.size() < 2)
    throw ToolError("a model and at least one object are needed, or -nearest with a "
                    "folder of known objects; -h shows the syntax");
  const auto model = pcl::indoor::loadModel(paths.front());
  paths.erase(paths.begin());
  return classifyByModel(objectFiles(paths), model, settings.classification, report);
}

void
run(const Settings& settings, Progress& progress)
{
  if (!settings.json.empty())
    requireWritable(settings.json);
  const auto files = classified(settings, progress);
  if (!settings.json.empty())
    saveText(settings.json, classificationJson(files));
  std::printf("%s", classificationText(files).c_str());
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  OptionParser parser("pcl_eppf_classify",
                      "Name the classes of objects, one per cloud, by a trained model, "
                      "or with -nearest by the most similar known object.");
  parser
      .positionals("[model] object",
                   settings.arguments,
                   "the model's file (not with -nearest), then clouds, or folders of "
                   "clouds; of DIR/CLASS/OBJECT.pcd, accuracy and confusion are shown, "
                   "too",
                   1)
      .text("-nearest",
            settings.known_folder,
            "folder of known objects, FOLDER/CLASS/OBJECT.pcd, in place of a model; an "
            "object is not compared with its own file")
      .text("-descriptor",
            settings.descriptor,
            "what -nearest compares by; point_nn sees the pose, too",
            {"pair_harmonics", "point_nn"})
      .text("-json", settings.json, "write file, class, confidence, top of each object")
      .number("-normal_neighbors",
              settings.classification.neighbor_count,
              "neighbours of a normal, where a file has no normals",
              "points",
              Range::atLeast(3))
      .number("-threads",
              settings.classification.threads,
              "threads; 0: all of the machine");
  parser.expert({"-descriptor", "-normal_neighbors"});
  return parser.run(argc, argv, [&](Progress& progress) { run(settings, progress); });
}
