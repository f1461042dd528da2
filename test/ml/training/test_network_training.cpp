/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/exceptions.h>
#include <pcl/ml/network_training.h>

#include <gtest/gtest.h>

#include "small_networks.h"
#include "support/folder_test.h"

#include <cmath>
#include <filesystem>
#include <fstream>

namespace pcl::indoor {
namespace {

using test::layer;
using test::smallNetworks;
using test::thirds;

TEST(NetworkTraining, AnyDesignLearnsWhatCanBeLearned)
{
  for (const auto& [name, network] : smallNetworks()) {
    TrainingOptions options;
    options.epoch_count = 40;
    options.batch_size = 8;
    options.learning_rate = 5e-3;
    const auto set = thirds(network, 30, 4);
    const auto result = trainNetwork(network, set, set, options);
    ASSERT_EQ(result.epochs.size(), 40);
    EXPECT_LT(result.epochs.front().validation_accuracy, 1.0) << name;
    EXPECT_GT(result.epochs.back().validation_accuracy, 0.85) << name;
    EXPECT_LT(result.epochs.back().training_loss,
              0.6 * result.epochs.front().training_loss)
        << name;
    EXPECT_EQ(findProblem(result.network, true), "");
  }
}

bool
sameWeights(const std::vector<Layer>& a, const std::vector<Layer>& b)
{
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (std::size_t w = 0; w < a[k].weights.size(); ++w)
      if (a[k].weights[w].values != b[k].weights[w].values)
        return false;
    if (!sameWeights(a[k].inner, b[k].inner))
      return false;
  }
  return a.size() == b.size();
}

bool
same(const TrainingResult& a, const TrainingResult& b)
{
  bool result = a.best_epoch == b.best_epoch && a.epochs.size() == b.epochs.size() &&
                sameWeights(a.network.layers, b.network.layers);
  for (std::size_t k = 0; result && k < a.epochs.size(); ++k)
    result = a.epochs[k].epoch == b.epochs[k].epoch &&
             a.epochs[k].training_loss == b.epochs[k].training_loss &&
             a.epochs[k].training_accuracy == b.epochs[k].training_accuracy &&
             a.epochs[k].validation_loss == b.epochs[k].validation_loss &&
             a.epochs[k].validation_accuracy == b.epochs[k].validation_accuracy;
  return result;
}

TrainingOptions
fewEpochs()
{
  TrainingOptions options;
  options.epoch_count = 7;
  options.batch_size = 5;
  options.weight_decay = 0.01;
  options.label_smoothing = 0.1;
  return options;
}

TEST(NetworkTraining, TheSameSeedGivesTheSameBits)
{
  for (const auto& [name, network] : smallNetworks()) {
    const auto set = thirds(network, 21, 4);
    const auto validation = thirds(network, 9, 5);
    auto options = fewEpochs();
    const auto first = trainNetwork(network, set, validation, options);
    EXPECT_TRUE(same(first, trainNetwork(network, set, validation, options))) << name;
    options.seed = 2;
    EXPECT_FALSE(same(first, trainNetwork(network, set, validation, options))) << name;
  }
}

class Checkpoint : public test::FolderTest {};

TEST_F(Checkpoint, AStoppedTrainingGoesOnAsIfItHadNot)
{
  for (const auto& [name, network] : smallNetworks()) {
    const auto set = thirds(network, 21, 4);
    const auto validation = thirds(network, 9, 5);
    auto options = fewEpochs();
    const auto expected = trainNetwork(network, set, validation, options);
    options.checkpoint = path(name + ".state");
    const auto stopped =
        trainNetwork(network, set, validation, options, [](const EpochReport& report) {
          return report.epoch < 3;
        });
    EXPECT_EQ(stopped.epochs.size(), 3);
    int calls = 0;
    const auto result =
        trainNetwork(network, set, validation, options, [&](const EpochReport&) {
          ++calls;
          return true;
        });
    EXPECT_EQ(calls, 4);
    EXPECT_TRUE(same(expected, result)) << name;
    EXPECT_TRUE(same(expected, trainNetwork(network, set, validation, options)));
    EXPECT_FALSE(std::ifstream(options.checkpoint + ".part").good());
  }
}

std::string
problem(const std::function<void()>& call)
{
  try {
    call();
  } catch (const PCLException& exception) {
    return exception.detailedMessage();
  }
  return "";
}

TEST_F(Checkpoint, OfAnotherTrainingIsRefused)
{
  auto networks = smallNetworks();
  const auto network = networks[0].second;
  const auto set = thirds(network, 9, 4);
  auto options = fewEpochs();
  options.checkpoint = path("state");
  trainNetwork(network, set, {}, options);
  const auto train = [&](const Network& other, const TrainingSet& objects) {
    return problem([&] { trainNetwork(other, objects, {}, options); });
  };
  EXPECT_EQ(train(network, set), "");
  EXPECT_NE(train(networks[1].second, thirds(networks[1].second, 9, 4))
                .find("another network"),
            std::string::npos);
  auto others = network;
  others.layers[0].weights[0].values[0] += 1.0f;
  EXPECT_NE(train(others, set).find("first weights"), std::string::npos);
  EXPECT_NE(train(network, thirds(network, 9, 5)).find("other objects"),
            std::string::npos);
  options.learning_rate *= 2.0;
  EXPECT_NE(train(network, set).find("other options"), std::string::npos);
  options = fewEpochs();
  options.checkpoint = path("state");
  options.threads = 2; // may differ
  EXPECT_EQ(train(network, set), "");
}

TEST_F(Checkpoint, ThatIsDamagedIsRefused)
{
  const auto network = smallNetworks()[5].second;
  const auto set = thirds(network, 9, 4);
  auto options = fewEpochs();
  options.checkpoint = path("state");
  const auto train = [&] {
    return problem([&] { trainNetwork(network, set, {}, options); });
  };
  EXPECT_EQ(train(), "");
  const auto size = std::filesystem::file_size(options.checkpoint);
  std::fstream(options.checkpoint, std::ios::binary | std::ios::in | std::ios::out)
      .seekp(static_cast<std::streamoff>(size / 2))
      .put('?');
  EXPECT_NE(train().find("have changed"), std::string::npos);
  std::filesystem::resize_file(options.checkpoint, size / 2);
  EXPECT_NE(train().find("ends too early"), std::string::npos);
  std::ofstream(options.checkpoint)
      << "Nothing of the kind, and of more than forty bytes.";
  EXPECT_NE(train().find("no checkpoint"), std::string::npos);
  for (const auto& file : {path("no/such/folder"), path("")}) {
    options.checkpoint = file;
    int calls = 0;
    const auto reason = problem([&] {
      trainNetwork(network, set, {}, options, [&](auto&) { return ++calls > 0; });
    });
    EXPECT_NE(reason.find("cannot be written"), std::string::npos) << reason;
    EXPECT_EQ(calls, 0); // known before the first epoch
  }
}

/** \brief A network of one dense layer, of which the loss is known. */
TEST(NetworkTraining, WeighsClassesAndSmoothsLabels)
{
  Network network{{2}, {layer(LayerKind::Dense, {2})}};
  network.layers[0].weights = {{{2, 2}, {1.0f, 0.0f, 0.0f, 1.0f}}, {{2}, {0.0f, 0.0f}}};
  TrainingSet set;
  set.labels = {0, 0, 0, 1};
  set.inputs = {{{2, 0}}, {{2, 0}}, {{0, 1}}, {{0, 1}}};
  TrainingOptions options;
  options.epoch_count = 1;
  const auto loss = [&] {
    const auto epoch = trainNetwork(network, set, {}, options).epochs.at(0);
    EXPECT_DOUBLE_EQ(epoch.training_accuracy, 0.75);
    return epoch.training_loss;
  };
  // -log of the share of one score of two, by how much it is larger
  const auto cost = [](double by) { return std::log(1.0 + std::exp(-by)); };
  EXPECT_NEAR(loss(), (2 * cost(2) + cost(-1) + cost(1)) / 4, 1e-6);
  options.class_balance = 1.0;
  EXPECT_NEAR(loss(), ((2 * cost(2) + cost(-1)) / 3 + cost(1)) / 2, 1e-6);
  options.class_balance = 0.5; // weights of 1 / sqrt(3) and 1
  const double root = std::sqrt(3.0);
  EXPECT_NEAR(loss(), ((2 * cost(2) + cost(-1)) / root + cost(1)) / (root + 1), 1e-6);
  options.class_balance = 0.0;
  options.label_smoothing = 0.2;
  const auto smooth = [&](double by) { return 0.9 * cost(by) + 0.1 * cost(-by); };
  EXPECT_NEAR(loss(), (2 * smooth(2) + smooth(-1) + smooth(1)) / 4, 1e-6);
}

TEST(NetworkTraining, TakesTheBestEpochOnValidation)
{
  const auto network = smallNetworks()[2].second;
  const auto set = thirds(network, 12, 4);
  auto options = fewEpochs();
  options.epoch_count = 12;
  options.learning_rate = 0.2; // so that it goes up and down
  const auto validation = thirds(network, 30, 5);
  const auto result = trainNetwork(network, set, validation, options);
  int best = 1;
  for (const auto& epoch : result.epochs) {
    const auto& before = result.epochs[static_cast<std::size_t>(best - 1)];
    if (std::make_pair(epoch.validation_accuracy, -epoch.validation_loss) >
        std::make_pair(before.validation_accuracy, -before.validation_loss))
      best = epoch.epoch;
  }
  EXPECT_EQ(result.best_epoch, best);
  ASSERT_LT(best, 12);
  // its weights are those of a training that is stopped there
  const auto stopped =
      trainNetwork(network, set, {}, options, [&](const EpochReport& epoch) {
        return epoch.epoch < best;
      });
  EXPECT_TRUE(sameWeights(result.network.layers, stopped.network.layers));
  EXPECT_EQ(trainNetwork(network, set, {}, options).best_epoch, 12);

  options.patience = 2;
  const auto patient = trainNetwork(network, set, validation, options);
  EXPECT_LT(patient.epochs.size(), 12);
  EXPECT_EQ(static_cast<int>(patient.epochs.size()), patient.best_epoch + 2);
}

TEST(NetworkTraining, RefusesWhatDoesNotFit)
{
  const auto network = smallNetworks()[5].second;
  const auto set = thirds(network, 9, 4);
  const auto refuses = [&](const std::function<void(TrainingOptions&)>& change) {
    auto options = fewEpochs();
    change(options);
    EXPECT_THROW(trainNetwork(network, set, {}, options), BadArgumentException);
  };
  refuses([](auto& options) { options.epoch_count = 0; });
  refuses([](auto& options) { options.batch_size = 0; });
  refuses([](auto& options) { options.learning_rate = 0.0; });
  refuses([](auto& options) { options.learning_rate = std::nan(""); });
  refuses([](auto& options) { options.weight_decay = -1.0; });
  refuses([](auto& options) { options.label_smoothing = 1.5; });
  refuses([](auto& options) { options.patience = -1; });
  refuses([](auto& options) { options.patience = 1; }); // without validation
  refuses([](auto& options) { options.threads = 0; });
  refuses([](auto& options) { options.checkpoint_epochs = 0; });

  const auto refusesSet = [&](const std::function<void(TrainingSet&)>& change) {
    auto wrong = set;
    change(wrong);
    EXPECT_THROW(trainNetwork(network, wrong, {}, fewEpochs()), BadArgumentException);
    EXPECT_THROW(trainNetwork(network, set, wrong, fewEpochs()), BadArgumentException);
  };
  refusesSet([](auto& wrong) { wrong.labels[2] = 3; });
  refusesSet([](auto& wrong) { wrong.labels[2] = -1; });
  refusesSet([](auto& wrong) { wrong.labels.pop_back(); });
  refusesSet([](auto& wrong) { wrong.inputs[2].clear(); });
  refusesSet([](auto& wrong) { wrong.inputs[2][1].pop_back(); });
  refusesSet([](auto& wrong) { wrong.inputs[2][1][3] = std::nanf(""); });
  EXPECT_THROW(trainNetwork(network, {}, set, fewEpochs()), BadArgumentException);
  EXPECT_THROW(trainNetwork(perceptron(3, {20}), set, {}, fewEpochs()),
               BadArgumentException); // without weights
  const auto point_net = smallNetworks().back().second;
  EXPECT_THROW(trainNetwork(point_net, thirds(point_net, 1, 1), {}, fewEpochs()),
               BadArgumentException); // BatchNorm of one object
}

TEST(NetworkTraining, ALossThatIsNotFiniteIsAnError)
{
  const auto network = smallNetworks()[5].second;
  auto options = fewEpochs();
  options.learning_rate = 1e30;
  EXPECT_THROW(trainNetwork(network, thirds(network, 9, 4), {}, options),
               ComputeFailedException);
}

/** Draws of 20 values whose roots differ by 0.1, but by 0.3 of number 3 and not of
 * number 4. */
TrainingSet
scaledDraws()
{
  TrainingSet set;
  set.labels = {0, 1};
  set.inputs.resize(2);
  for (auto& draws : set.inputs)
    for (const float sign : {-1.0f, 1.0f}) {
      draws.emplace_back(20);
      for (std::size_t k = 0; k < 20; ++k) {
        const float root = 0.5f + sign * (k == 3 ? 0.3f : k == 4 ? 0.0f : 0.1f);
        draws.back()[k] = root * root;
      }
    }
  return set;
}

constexpr float usual_deviation = (18 * 0.1f + 0.3f) / 20;

TEST(FitScale, DividesByTheDeviationAndTheUsualOne)
{
  auto network = perceptron(3, {20, {8}, 0.0f});
  fitScale(network, scaledDraws());
  const auto& scale = network.layers.at(1);
  ASSERT_EQ(scale.kind, LayerKind::Scale);
  for (std::size_t k = 0; k < 20; ++k) {
    const float deviation = k == 3 ? 0.3f : k == 4 ? 0.0f : 0.1f;
    const float gain = 1.0f / (deviation + usual_deviation);
    EXPECT_NEAR(scale.weights.at(0).values.at(k), gain, 1e-3f * gain) << k;
    EXPECT_NEAR(scale.weights.at(1).values.at(k), -0.5f * gain, 1e-3f * gain) << k;
  }
  initializeWeights(network, 1);
  EXPECT_EQ(findProblem(network, true), "");
}

TEST(FitScale, BeforeAConvolutionAllHaveOneScale)
{
  Network network{{1, 20},
                  {{LayerKind::SquareRoot},
                   {LayerKind::Scale},
                   {LayerKind::Convolution, {2, 3}},
                   {LayerKind::Dense, {2}}}};
  fitScale(network, scaledDraws());
  for (const float gain : network.layers.at(1).weights.at(0).values)
    EXPECT_NEAR(gain, 1.0f / usual_deviation, 1e-2f);
}

TEST(FitScale, LeavesOtherNetworksAlone)
{
  auto network = smallNetworks()[0].second;
  const auto before = network;
  fitScale(network, thirds(network, 9, 4));
  EXPECT_TRUE(sameWeights(network.layers, before.layers));
  auto scaled = perceptron(3, {20});
  EXPECT_THROW(fitScale(scaled, {}), BadArgumentException);
  EXPECT_THROW(fitScale(scaled, thirds(network, 9, 4)), BadArgumentException);
}

} // namespace
} // namespace pcl::indoor
