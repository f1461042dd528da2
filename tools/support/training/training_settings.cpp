/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "training/training_settings.h"

#include "formats/table/table_words.h" // for readNumber
#include "objects/object_files.h"

#include <pcl/ml/network_designs.h>

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

/** \brief A whole text as a number; NaN if it is none. */
double
numberOf(std::string_view text)
{
  double value = 0.0;
  return readNumber(text, value) ? value : std::nan("");
}

std::vector<int>
hiddenLayers(const std::string& text)
{
  std::vector<int> layers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(',', begin), text.size());
    const double count = numberOf(text.substr(begin, end - begin));
    if (!(count >= 1.0 && count <= 65536.0) || count != std::floor(count))
      throw ToolError("-hidden: '" + text +
                      "' is no list of whole numbers from 1 to 65536, as 256,256");
    layers.push_back(static_cast<int>(count));
    begin = end + 1;
  }
  return layers;
}

ClassifierInputKind
kindOf(const TrainingSettings& settings)
{
  auto name = settings.descriptor;
  if (name == "auto")
    name = settings.network == "perceptron" ? "pair_harmonics"
           : settings.network == "pointnet" ? "points"
                                            : "eppf";
  return name == "points"       ? ClassifierInputKind::Points
         : name == "eppf"       ? ClassifierInputKind::EPPF
         : name == "eppf_short" ? ClassifierInputKind::EPPFShort
                                : ClassifierInputKind::PairHarmonics;
}

void
requireThatTheyFit(const TrainingSettings& settings)
{
  const auto kind = kindOf(settings);
  const bool is_pointnet = settings.network == "pointnet";
  if (is_pointnet != (kind == ClassifierInputKind::Points))
    throw ToolError("-descriptor: points and -network pointnet go together only");
  if (settings.network == "perceptron")
    return;
  if (kind == ClassifierInputKind::EPPFShort)
    throw ToolError("-descriptor: the networks 2d, 3d and 4d need 1200 bins, which "
                    "eppf_short has not");
}

void
addDataOptions(OptionParser& parser, TrainingSettings& settings)
{
  parser
      .positional("DIR", settings.folder, "a folder per class with the objects' files")
      .positional("MODEL", settings.model, "where the trained model goes")
      .text(
          "-split",
          settings.split,
          "what not to train, but to test with at the end: none, random:0.8 (share to "
          "train with), folders (train and test in each class), or a file with names")
      .number("-validation",
              settings.validation,
              "share of the training part that chooses the epoch; 0: the last one",
              "",
              Range::between(0.0, 0.5))
      .number("-normal_neighbors",
              settings.draws.neighbor_count,
              "neighbours of a normal that has to be estimated",
              "points",
              Range::atLeast(3))
      .number("-threads",
              settings.threads,
              "of reading and describing, 0 = automatic; any number gives the same");
}

void
addNetworkOptions(OptionParser& parser, TrainingSettings& settings)
{
  parser
      .text("-network",
            settings.network,
            "what is trained",
            {"perceptron", "2d", "3d", "4d", "pointnet"})
      .text("-hidden", settings.hidden, "of the perceptron: values of its layers")
      .number("-dropout",
              settings.dropout,
              "of the perceptron",
              "",
              Range::between(0.0, 1.0))
      .number(
          "-input_dropout",
          settings.input_dropout,
          "of the perceptron's inputs: more for objects of another source than those "
          "it is trained with",
          "",
          Range::between(0.0, 1.0))
      .number("-width",
              settings.width,
              "of PointNet: its layers' widths, of the published ones",
              "",
              Range{0.0, 4.0, true})
      .number("-ensemble",
              settings.ensemble,
              "networks, whose probabilities are averaged",
              "",
              Range::between(1, 100));
}

void
addInputOptions(OptionParser& parser, TrainingSettings& settings)
{
  auto& draws = settings.draws;
  parser
      .text("-descriptor",
            settings.descriptor,
            "what it sees; auto: pair_harmonics, of 2d, 3d and 4d eppf, of pointnet "
            "points",
            {"auto", "pair_harmonics", "eppf", "eppf_short", "points"})
      .text("-scale",
            settings.scale,
            "metres that distances of pairs spread over; 0: each object's extent, so "
            "that size does not count; auto: the largest object's")
      .number("-pairs", draws.input.pair_count, "pairs drawn", "", Range::atLeast(1))
      .number("-points",
              draws.input.point_count,
              "points that PointNet sees",
              "",
              Range::between(1, 100000))
      .flag("-any_pose",
            settings.any_pose,
            "objects need not stand upright in metres: the perceptron sees neither "
            "size and place nor what is at which height")
      .number("-draws",
              draws.draw_count,
              "times an object is drawn, with other pairs and augmented",
              "",
              Range::between(1, 1000))
      .text("-augment",
            settings.augment,
            "how draws differ from the object; mild: stretched, fewer points; scan: "
            "also noise and hidden parts",
            {"off", "mild", "scan"})
      .number("-noise",
              draws.disturbance.noise_percent,
              "of every draw, and of what is tested with: deviation in per cent of the "
              "object's extent",
              "",
              Range::between(0.0, 100.0))
      .number("-occlusion",
              draws.disturbance.hidden_percent,
              "of every draw, and of what is tested with: per cent of the points that "
              "one view does not see",
              "",
              Range::between(0.0, 99.0))
      .number("-classify_draws",
              draws.input.draws,
              "times an object is described when it is classified",
              "",
              Range::between(1, 100));
}

void
addStepOptions(OptionParser& parser, TrainingSettings& settings)
{
  auto& training = settings.training;
  parser.number("-epochs", training.epoch_count, "epochs", "", Range::atLeast(1))
      .number(
          "-batch_size", training.batch_size, "per step", "objects", Range::atLeast(1))
      .number("-learning_rate",
              training.learning_rate,
              "of AdamW at the start; it falls to 0",
              "",
              Range::positive())
      .number(
          "-weight_decay", training.weight_decay, "of AdamW", "", Range::atLeast(0.0))
      .number("-label_smoothing",
              training.label_smoothing,
              "share of an object's label that goes to all classes",
              "",
              Range::between(0.0, 1.0))
      .number("-class_balance",
              training.class_balance,
              "objects weigh as the number of their class to the power of -X; 1: each "
              "class counts the same",
              "",
              Range::between(0.0, 1.0))
      .number("-patience",
              training.patience,
              "epochs without a better validation after which to stop; 0: never",
              "",
              Range::atLeast(0))
      .number("-seed", training.seed, "of split, draws, weights and order")
      .number("-training_threads",
              training.threads,
              "of libtorch; another number may give slightly other weights",
              "",
              Range::between(1, 1024));
}

void
addOutputOptions(OptionParser& parser, TrainingSettings& settings)
{
  parser
      .text("-checkpoint",
            settings.training.checkpoint,
            "file to keep the state in; the same command goes on from it")
      .text("-log", settings.log, "write losses and accuracies per epoch as CSV")
      .text("-curves", settings.curves, "draw them as PNG or SVG")
      .text(
          "-confusion", settings.confusion, "draw the test's confusions as PNG or SVG")
      .flag(
          "-half", settings.half_precision, "store weights in 16 bits, half the size");
}

} // namespace

TrainingOptions
recommendedTraining()
{
  TrainingOptions options;
  options.epoch_count = 40;
  options.learning_rate = 1e-3;
  options.weight_decay = 0.01;
  options.label_smoothing = 0.1;
  return options;
}

void
addTo(OptionParser& parser, TrainingSettings& settings)
{
  addDataOptions(parser, settings);
  addNetworkOptions(parser, settings);
  addInputOptions(parser, settings);
  addStepOptions(parser, settings);
  addOutputOptions(parser, settings);
  parser.expert({"-normal_neighbors",
                 "-hidden",
                 "-dropout",
                 "-input_dropout",
                 "-width",
                 "-scale",
                 "-pairs",
                 "-points",
                 "-any_pose",
                 "-draws",
                 "-augment",
                 "-noise",
                 "-occlusion",
                 "-classify_draws",
                 "-batch_size",
                 "-learning_rate",
                 "-weight_decay",
                 "-label_smoothing",
                 "-class_balance",
                 "-patience",
                 "-training_threads",
                 "-half"});
}

void
requireUsable(const TrainingSettings& settings)
{
  randomShare(settings.split); // throws if it is none
  if (settings.scale != "auto") {
    const double scale = numberOf(settings.scale);
    if (!(scale >= 0.0 && std::isfinite(scale)))
      throw ToolError("-scale: '" + settings.scale +
                      "' is neither auto nor metres of at least 0");
  }
  hiddenLayers(settings.hidden);
  requireThatTheyFit(settings);
  if (settings.training.patience > 0 && settings.validation == 0.0)
    throw ToolError("-patience: needs -validation");
  if (!settings.confusion.empty() && settings.split == "none")
    throw ToolError("-confusion: needs a test part, see -split");
}

ClassifierInput
inputOf(const TrainingSettings& settings,
        const LabelledObjects& objects,
        const std::vector<std::size_t>& used)
{
  auto input = settings.draws.input;
  input.kind = kindOf(settings);
  input.context = settings.network == "perceptron" && !settings.any_pose;
  if (settings.scale != "auto") {
    input.scale = numberOf(settings.scale);
    return input;
  }
  for (const auto k : used)
    input.scale = std::max<double>(input.scale,
                                   objectExtent(classifierPoints(*objects.clouds[k])));
  return input;
}

Network
networkOf(const TrainingSettings& settings,
          const ClassifierInput& input,
          std::size_t class_count)
{
  const int classes = static_cast<int>(class_count);
  if (settings.network == "4d")
    return eppfNetwork4D(classes);
  if (settings.network == "3d")
    return eppfNetwork3D(classes);
  if (settings.network == "2d")
    return eppfNetwork2D(classes);
  if (settings.network == "pointnet")
    return pointNet(classes, input.point_count, settings.width);
  PerceptronOptions options;
  options.input_count = static_cast<int>(inputValueCount(input));
  options.hidden = hiddenLayers(settings.hidden);
  options.dropout = static_cast<float>(settings.dropout);
  options.input_dropout = static_cast<float>(settings.input_dropout);
  return perceptron(classes, options);
}

} // namespace pcl::indoor::tool
