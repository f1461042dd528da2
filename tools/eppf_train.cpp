/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/progress_report.h"
#include "files/output_file.h"
#include "objects/labelled_objects.h"
#include "objects/object_files.h"
#include "pictures/confusion_picture.h"
#include "pictures/svg_raster.h"
#include "text/formatted.h"
#include "training/epoch_writer.h"
#include "training/stop_requests.h"
#include "training/training_pool.h"
#include "training/training_report.h"
#include "training/training_settings.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/ml/model_file.h>

#include <algorithm>
#include <cstdio>

namespace {

using namespace pcl::indoor; // a tool of the cores
using namespace pcl::indoor::tool;

/** \brief What the networks learn from. */
struct TrainingData {
  TrainingSet training;
  TrainingSet validation;
};

void
requireOutputs(const TrainingSettings& settings)
{
  for (const auto& path : {settings.model,
                           settings.log,
                           settings.curves,
                           settings.confusion,
                           settings.training.checkpoint})
    if (!path.empty())
      requireWritable(path);
}

/** \brief How objects are drawn, but for the augmentation. */
DrawOptions
drawOptions(const TrainingSettings& settings, const ClassifierInput& input)
{
  auto options = settings.draws;
  options.input = input;
  options.seed = settings.training.seed;
  return options;
}

TrainingData
describedObjects(const LabelledObjects& objects,
                 const std::vector<std::size_t>& training,
                 const ClassifierInput& input,
                 const TrainingSettings& settings,
                 Progress& progress)
{
  auto options = drawOptions(settings, input);
  if (settings.augment != "scan")
    options.augmentation =
        settings.augment == "mild" ? mildAugmentation() : ObjectAugmentation();
  const auto split =
      withoutShare(objects, training, settings.validation, settings.training.seed);
  progress.start("Describing " + std::to_string(training.size()) + " objects, " +
                 std::to_string(options.draw_count) + " times each");
  TrainingData data;
  data.training =
      trainingPool(objects, split.training, options, settings.threads, progress);
  data.validation =
      trainingPool(objects, split.test, options, settings.threads, progress);
  progress.done();
  return data;
}

/** \brief Train one network after the other; each has its own seed and checkpoint. */
std::vector<Network>
trainedNetworks(const Network& design,
                const TrainingData& data,
                const TrainingSettings& settings,
                EpochLog& log,
                Progress& progress)
{
  const bool has_validation = !data.validation.labels.empty();
  EpochWriter writer(settings.log, has_validation);
  const auto count = static_cast<std::size_t>(settings.ensemble);
  const auto epochs = static_cast<std::size_t>(settings.training.epoch_count);
  std::vector<Network> networks;
  const StopRequests stop_requests;
  progress.start("Training");
  for (std::size_t k = 0; k < count; ++k) {
    writer.write(log);
    auto options = settings.training;
    options.seed += static_cast<std::uint32_t>(k);
    if (count > 1 && !options.checkpoint.empty())
      options.checkpoint += "." + std::to_string(k + 1);
    auto network = design;
    initializeWeights(network, options.seed);
    fitScale(network, data.training);
    const auto report = [&](const EpochReport& epoch) {
      writer.add(k + 1, epoch);
      const double accuracy =
          has_validation ? epoch.validation_accuracy : epoch.training_accuracy;
      progress.update(k * epochs + static_cast<std::size_t>(epoch.epoch),
                      count * epochs,
                      formatted("accuracy %.1f %%", 100.0 * accuracy));
      return !StopRequests::isThereOne();
    };
    auto result =
        trainNetwork(network, data.training, data.validation, options, report);
    log.push_back(result.epochs);
    networks.push_back(std::move(result.network));
    if (StopRequests::isThereOne()) {
      writer.write(log);
      throw ToolError("stopped after epoch " +
                      std::to_string(result.epochs.back().epoch) +
                      (options.checkpoint.empty()
                           ? ", without -checkpoint nothing is kept"
                           : ", the same command goes on from " + options.checkpoint));
    }
  }
  writer.write(log);
  progress.done(std::to_string(trainedValueCount(design)) + " weights");
  return networks;
}

/** \brief Classify the test part, disturbed as what was trained with, with the model as
 * it was written. */
ConfusionMatrix
testedModel(const std::string& bytes,
            const LabelledObjects& objects,
            const std::vector<std::size_t>& test,
            const TrainingSettings& settings,
            Progress& progress)
{
  progress.start("Testing with " + std::to_string(test.size()) + " objects");
  const auto model = modelFromBytes(bytes);
  const auto options = drawOptions(settings, model.input);
  std::vector<ClassifierObject> tested(test.size());
  std::vector<int> truth, predicted;
  for (const auto k : test)
    truth.push_back(objects.labels[k]);
  parallelFor(static_cast<std::ptrdiff_t>(test.size()),
              static_cast<int>(settings.threads),
              1,
              [&](std::ptrdiff_t i) {
                const auto k = static_cast<std::size_t>(i);
                const auto object =
                    firstDrawnObject(*objects.clouds[test[k]], options, test[k]);
                tested[k] = {classifierPoints(object), objects.places[test[k]]};
              });
  for (const auto& classification : classifyObjects(tested, model, settings.threads))
    predicted.push_back(classification.best());
  progress.done();
  return confusionMatrix(truth, predicted, objects.class_names.size());
}

void
run(const TrainingSettings& settings, Progress& progress)
{
  requireUsable(settings);
  requireOutputs(settings);
  ProgressReport report(progress);
  const auto objects = loadLabelledObjects(
      settings.folder, settings.draws.neighbor_count, settings.threads, report);
  const auto split = splitNamed(objects, settings.split, settings.training.seed);
  ClassifierModel model;
  model.classes = objects.class_names;
  model.input = inputOf(settings, objects, split.training);
  const auto data =
      describedObjects(objects, split.training, model.input, settings, progress);
  const auto design = networkOf(settings, model.input, model.classes.size());
  EpochLog log;
  model.networks = trainedNetworks(design, data, settings, log, progress);
  const auto bytes = modelBytes(model, settings.half_precision);
  saveText(settings.model, bytes);
  std::vector<Picture> pictures;
  if (!settings.curves.empty())
    pictures.push_back(
        {settings.curves, curvesPicture(log, !data.validation.labels.empty()).str()});
  if (!split.test.empty()) {
    const auto confusion = testedModel(bytes, objects, split.test, settings, progress);
    std::printf("%s%s",
                scoresText(confusion).c_str(),
                confusionText(confusion, model.classes).c_str());
    if (!settings.confusion.empty())
      pictures.push_back(
          {settings.confusion, confusionPicture(confusion, model.classes).str()});
  }
  savePictures(pictures);
}

} // namespace

int
main(int argc, char** argv)
{
  TrainingSettings settings;
  OptionParser parser("pcl_eppf_train",
                      "Train a classifier on the objects DIR/CLASS/OBJECT (.pcd, .ply, "
                      ".off, .obj) and write it to MODEL.");
  addTo(parser, settings);
  return parser.run(argc, argv, [&](Progress& progress) { run(settings, progress); });
}
