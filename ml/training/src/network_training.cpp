/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/network_training.h>

#include "adam.h"
#include "network_module.h"
#include "training_checkpoint.h"
#include "training_data.h"
#include "training_resources.h"

#include <c10/core/GradMode.h>
#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

[[noreturn]] void
refuse(const std::string& problem)
{
  PCL_THROW_EXCEPTION(BadArgumentException, problem);
}

void
requireOptions(const TrainingOptions& options)
{
  if (options.epoch_count < 1 || options.batch_size < 1)
    refuse("Training needs at least 1 epoch of batches of at least 1 object, not " +
           std::to_string(options.epoch_count) + " of " +
           std::to_string(options.batch_size));
  if (!(options.learning_rate > 0.0) || !std::isfinite(options.learning_rate))
    refuse("The learning rate must be positive, not " +
           std::to_string(options.learning_rate));
  if (!(options.weight_decay >= 0.0) || !std::isfinite(options.weight_decay))
    refuse("The weight decay must be at least 0, not " +
           std::to_string(options.weight_decay));
  if (!(options.label_smoothing >= 0.0 && options.label_smoothing <= 1.0))
    refuse("The label smoothing must be in 0 ... 1, not " +
           std::to_string(options.label_smoothing));
  if (!(options.class_balance >= 0.0 && options.class_balance <= 1.0))
    refuse("The balance of classes must be in 0 ... 1, not " +
           std::to_string(options.class_balance));
  if (options.patience < 0 || options.threads < 1 || options.checkpoint_epochs < 1)
    refuse("Patience must be at least 0, threads and epochs between checkpoints at "
           "least 1, not " +
           std::to_string(options.patience) + ", " + std::to_string(options.threads) +
           " and " + std::to_string(options.checkpoint_epochs));
}

int
classCount(const Network& network)
{
  return outputShape(network.layers, network.input).front();
}

void
requireSet(const Network& network, const TrainingSet& set, const std::string& name)
{
  const auto value_count = valueCount(network.input);
  const int class_count = classCount(network);
  if (set.inputs.size() != set.labels.size())
    refuse("The " + name + " set has " + std::to_string(set.inputs.size()) +
           " objects, but " + std::to_string(set.labels.size()) + " labels");
  for (std::size_t object = 0; object < set.inputs.size(); ++object) {
    const std::string which =
        "Object " + std::to_string(object + 1) + " of the " + name + " set";
    if (set.labels[object] < 0 || set.labels[object] >= class_count)
      refuse(which + " has label " + std::to_string(set.labels[object]) +
             ", not 0 ... " + std::to_string(class_count - 1));
    if (set.inputs[object].empty())
      refuse(which + " has no draws");
    for (const auto& draw : set.inputs[object]) {
      if (draw.size() != value_count)
        refuse(which + " has " + std::to_string(draw.size()) + " values, not the " +
               std::to_string(value_count) + " of the network");
      for (const float value : draw)
        if (!std::isfinite(value))
          refuse(which + " has values that are not finite");
    }
  }
}

bool
hasBatchNorm(const std::vector<Layer>& layers)
{
  for (const auto& layer : layers)
    if (layer.kind == LayerKind::BatchNorm || hasBatchNorm(layer.inner))
      return true;
  return false;
}

void
requireAll(const Network& network,
           const TrainingSet& training,
           const TrainingSet& validation,
           const TrainingOptions& options)
{
  requireOptions(options);
  const auto problem = findProblem(network, true);
  if (!problem.empty())
    refuse("The network to train is wrong: " + problem);
  requireSet(network, training, "training");
  requireSet(network, validation, "validation");
  if (training.inputs.empty())
    refuse("Training needs at least 1 object");
  if (hasBatchNorm(network.layers) &&
      (training.inputs.size() < 2 || options.batch_size < 2))
    refuse("A network with BatchNorm needs batches of at least 2 objects");
  if (options.patience > 0 && validation.inputs.empty())
    refuse("Patience needs a validation set");
}

/** \brief The number of objects of each class to the power of -balance, times what
 * makes the mean over the objects 1. */
at::Tensor
classWeights(const TrainingSet& set, int class_count, double balance)
{
  std::vector<double> counts(static_cast<std::size_t>(class_count), 0.0);
  for (const int label : set.labels)
    ++counts[static_cast<std::size_t>(label)];
  double sum = 0.0;
  for (const double count : counts)
    sum += count > 0.0 ? std::pow(count, 1.0 - balance) : 0.0;
  std::vector<float> weights;
  for (const double count : counts)
    weights.push_back(
        count > 0.0 ? static_cast<float>(std::pow(count, -balance) *
                                         static_cast<double>(set.labels.size()) / sum)
                    : 0.0f);
  return at::tensor(weights, at::kFloat);
}

std::int64_t
rightCount(const at::Tensor& scores, const at::Tensor& labels)
{
  return scores.argmax(1).eq(labels).sum().item<std::int64_t>();
}

/** \brief A training under way. */
class Training {
public:
  Training(const Network& network,
           const TrainingSet& training,
           const TrainingSet& validation,
           const TrainingOptions& options)
  : options_(options)
  , device_(at::hasCUDA() ? at::kCUDA : at::kCPU)
  , training_(trainingData(training, device_))
  , validation_(trainingData(validation, device_))
  , module_(network, device_)
  , adam_(module_.parameters(), options.weight_decay)
  , has_validation_(!validation.inputs.empty())
  {
    if (options.class_balance > 0.0)
      class_weights_ =
          classWeights(training, classCount(network), options.class_balance)
              .to(device_);
    if (options.checkpoint.empty())
      return;
    identity_ = trainingIdentity(network, training, validation, options);
    state_.network = state_.best = network;
    state_.moments = adam_.moments();
    requireWritable(options.checkpoint); // now, not after hours
    if (!readCheckpoint(options.checkpoint, identity_, state_))
      return;
    module_ = NetworkModule(state_.network, device_);
    adam_ = Adam(module_.parameters(), options.weight_decay);
    adam_.setMoments(state_.moments);
    adam_.step_count = state_.step_count;
  }

  TrainingResult
  run(const std::function<bool(const EpochReport&)>& report)
  {
    bool goes_on = true;
    bool is_saved = true;
    while (goes_on && !isOver()) {
      state_.epochs.push_back(nextEpoch());
      keepBest();
      goes_on = !report || report(state_.epochs.back());
      is_saved = options_.checkpoint.empty();
      if (!is_saved && epochCount() % options_.checkpoint_epochs == 0) {
        save();
        is_saved = true;
      }
    }
    if (!is_saved)
      save();
    return {has_validation_ ? state_.best : module_.network(),
            state_.epochs,
            state_.best_epoch};
  }

private:
  int
  epochCount() const
  {
    return static_cast<int>(state_.epochs.size());
  }

  bool
  isOver() const
  {
    return epochCount() >= options_.epoch_count ||
           (options_.patience > 0 && epochCount() > 0 &&
            epochCount() - state_.best_epoch >= options_.patience);
  }

  EpochReport
  nextEpoch()
  {
    EpochReport result;
    result.epoch = epochCount() + 1;
    train(result);
    if (has_validation_)
      validate(result);
    if (!std::isfinite(result.training_loss) || !std::isfinite(result.validation_loss))
      PCL_THROW_EXCEPTION(ComputeFailedException,
                          "The loss of epoch "
                              << result.epoch << " is not finite; the learning rate is "
                              << options_.learning_rate);
    return result;
  }

  /** \brief The learning rate of the next step. */
  double
  learningRate(std::int64_t steps_per_epoch) const
  {
    const auto steps = static_cast<double>(steps_per_epoch * options_.epoch_count);
    const double done = static_cast<double>(adam_.step_count) / steps;
    return 0.5 * options_.learning_rate * (1.0 + std::cos(M_PI * done));
  }

  void
  train(EpochReport& result)
  {
    auto rows = drawnRows(training_, options_.seed, result.epoch);
    const auto order = at::tensor(rows, at::kLong).to(device_);
    auto dropout =
        at::detail::createCPUGenerator((std::uint64_t(options_.seed) << 32) +
                                       static_cast<std::uint64_t>(result.epoch));
    const auto object_count = static_cast<std::int64_t>(rows.size());
    const auto bounds = batchBounds(object_count, options_.batch_size);
    const auto step_count = static_cast<std::int64_t>(bounds.size()) - 1;
    double loss_sum = 0.0;
    std::int64_t right_count = 0;
    for (std::size_t k = 0; k + 1 < bounds.size(); ++k) {
      const auto batch = order.slice(0, bounds[k], bounds[k + 1]);
      const auto labels = training_.labels.index_select(0, batch);
      const auto scores =
          module_.scores(training_.inputs.index_select(0, batch), &dropout);
      const auto loss = at::cross_entropy_loss(scores,
                                               labels,
                                               class_weights_,
                                               at::Reduction::Mean,
                                               -100,
                                               options_.label_smoothing);
      loss.backward();
      adam_.step(learningRate(step_count));
      loss_sum += static_cast<double>(batch.size(0)) * loss.item<double>();
      right_count += rightCount(scores, labels);
    }
    result.training_loss = loss_sum / static_cast<double>(object_count);
    result.training_accuracy =
        static_cast<double>(right_count) / static_cast<double>(object_count);
  }

  /** \brief Every draw of every object, plain cross-entropy. */
  void
  validate(EpochReport& result) const
  {
    const c10::NoGradGuard no_gradients;
    const auto row_count = validation_.inputs.size(0);
    double loss_sum = 0.0;
    std::int64_t right_count = 0;
    for (std::int64_t row = 0; row < row_count; row += options_.batch_size) {
      const auto end = std::min<std::int64_t>(row + options_.batch_size, row_count);
      const auto labels = validation_.labels.slice(0, row, end);
      const auto scores =
          module_.scores(validation_.inputs.slice(0, row, end), nullptr);
      const auto loss = at::cross_entropy_loss(scores, labels, {}, at::Reduction::Sum);
      loss_sum += loss.item<double>();
      right_count += rightCount(scores, labels);
    }
    result.validation_loss = loss_sum / static_cast<double>(row_count);
    result.validation_accuracy =
        static_cast<double>(right_count) / static_cast<double>(row_count);
  }

  void
  keepBest()
  {
    const auto& last = state_.epochs.back();
    if (has_validation_ && state_.best_epoch > 0) {
      const auto& best = state_.epochs[static_cast<std::size_t>(state_.best_epoch - 1)];
      const bool is_better = last.validation_accuracy > best.validation_accuracy ||
                             (last.validation_accuracy == best.validation_accuracy &&
                              last.validation_loss < best.validation_loss);
      if (!is_better)
        return;
    }
    state_.best_epoch = last.epoch;
    if (has_validation_)
      state_.best = module_.network();
  }

  void
  save()
  {
    state_.network = module_.network();
    state_.moments = adam_.moments();
    state_.step_count = adam_.step_count;
    writeCheckpoint(options_.checkpoint, identity_, state_);
  }

  TrainingOptions options_;
  at::Device device_;
  TrainingData training_;
  TrainingData validation_;
  NetworkModule module_;
  Adam adam_;
  bool has_validation_;
  at::Tensor class_weights_;
  TrainingIdentity identity_;
  TrainingState state_;
};

} // namespace

TrainingResult
trainNetwork(const Network& network,
             const TrainingSet& training,
             const TrainingSet& validation,
             const TrainingOptions& options,
             const std::function<bool(const EpochReport&)>& report)
{
  requireAll(network, training, validation, options);
  const TrainingResources resources(options.threads);
  return Training(network, training, validation, options).run(report);
}

} // namespace pcl::indoor
