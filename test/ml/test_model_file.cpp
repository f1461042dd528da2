/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "support/folder_test.h"

#include <pcl/exceptions.h>
#include <pcl/ml/model_file.h>
#include <pcl/ml/network_designs.h>
#include <pcl/ml/object_classifier.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

namespace pcl::indoor {
namespace {

/** CRC-32 (ISO-HDLC) bit by bit. */
std::uint32_t
checksum(const std::string& bytes)
{
  std::uint32_t crc = 0xffffffffu;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit)
      crc = crc >> 1 ^ ((crc & 1u) != 0 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

std::string
littleEndian(std::uint32_t number)
{
  std::string bytes;
  for (int k = 0; k < 4; ++k)
    bytes.push_back(static_cast<char>(number >> (8 * k) & 0xff));
  return bytes;
}

/** A file with right checksums, whatever it says. */
std::string
fileOf(const std::string& header, const std::string& weights)
{
  const std::string start = "pcl_indoor_model 1\n" + header + "\n";
  return start + weights + littleEndian(checksum(start)) +
         littleEndian(checksum(weights));
}

/** The smallest model: 24 values of points. */
ClassifierModel
tinyModel()
{
  ClassifierModel model;
  model.classes = {"chair",
                   "t\xc3\xa4"
                   "ble",
                   "a \"b\"\n"};
  model.input.kind = ClassifierInputKind::Points;
  model.input.point_count = 2;
  model.input.scale = 0.1;
  model.networks = {{{3, 2}, {{LayerKind::Dense, {3}}}}};
  initializeWeights(model.networks[0], 1);
  return model;
}

/** All kinds of layers in one network, and a second network. */
ClassifierModel
largeModel()
{
  ClassifierModel model;
  model.classes = {"chair", "table"};
  model.input.kind = ClassifierInputKind::Points;
  model.input.point_count = 5;
  model.input.draws = 3;
  auto all = pointNet(2, 5, 0.05);
  all.layers.insert(all.layers.begin(),
                    {{LayerKind::Scale},
                     {LayerKind::Reshape, {3, 1, 5}},
                     {LayerKind::MaxPool, {1, 1}},
                     {LayerKind::SquareRoot},
                     {LayerKind::Reshape, {3, 5}}});
  model.networks = {all, perceptron(2, {15, {4}, 0.25f})};
  for (auto& network : model.networks)
    initializeWeights(network, 2);
  model.networks[0].layers[0].weights[0].values[1] = 123456.7f; // too large for 16 bits
  return model;
}

void
expectSameLayers(const std::vector<Layer>& a, const std::vector<Layer>& b, bool is_half)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].kind, b[k].kind);
    EXPECT_EQ(a[k].extents, b[k].extents);
    EXPECT_EQ(a[k].rate, b[k].rate);
    ASSERT_EQ(a[k].weights.size(), b[k].weights.size());
    const bool is_rounded = is_half && (a[k].kind == LayerKind::Dense ||
                                        a[k].kind == LayerKind::Convolution);
    for (std::size_t w = 0; w < a[k].weights.size(); ++w) {
      EXPECT_EQ(a[k].weights[w].shape, b[k].weights[w].shape);
      const auto& values = a[k].weights[w].values;
      for (std::size_t v = 0; v < values.size(); ++v) {
        const float tolerance =
            is_rounded ? std::max(std::abs(values[v]) / 2048.0f, 3e-8f) : 0.0f;
        EXPECT_NEAR(values[v], b[k].weights[w].values[v], tolerance);
      }
    }
    expectSameLayers(a[k].inner, b[k].inner, is_half);
  }
}

void
expectSame(const ClassifierModel& a, const ClassifierModel& b, bool is_half)
{
  EXPECT_EQ(a.classes, b.classes);
  EXPECT_EQ(a.input.kind, b.input.kind);
  EXPECT_EQ(a.input.scale, b.input.scale);
  EXPECT_EQ(a.input.pair_count, b.input.pair_count);
  EXPECT_EQ(a.input.draws, b.input.draws);
  EXPECT_EQ(a.input.context, b.input.context);
  EXPECT_EQ(a.input.point_count, b.input.point_count);
  ASSERT_EQ(a.networks.size(), b.networks.size());
  for (std::size_t k = 0; k < a.networks.size(); ++k) {
    EXPECT_EQ(a.networks[k].input, b.networks[k].input);
    expectSameLayers(a.networks[k].layers, b.networks[k].layers, is_half);
  }
}

/** The text of an exception, behind function, file and line. */
std::string
textOf(const IOException& problem)
{
  const std::string message = problem.what();
  return message.substr(message.find(" : ") + 3);
}

/** One line, and not a long one. */
void
expectRefused(const std::string& bytes, const std::string& part = "")
{
  try {
    modelFromBytes(bytes);
    ADD_FAILURE() << "read " << bytes;
  } catch (const IOException& problem) {
    const std::string message = textOf(problem);
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_FALSE(message.empty());
    EXPECT_LT(message.size(), 200u) << message;
  }
}

TEST(ModelFile, GivesBackWhatWasStored)
{
  auto described = tinyModel();
  for (const auto kind : {ClassifierInputKind::PairHarmonics,
                          ClassifierInputKind::EPPF,
                          ClassifierInputKind::EPPFShort}) {
    described.input = {kind, 1.0 / 3.0, 4000000000u, 7, true, 9};
    const auto count = static_cast<int>(inputValueCount(described.input));
    described.networks = {perceptron(3, {count, {}, 0.0f})};
    initializeWeights(described.networks[0], 1);
    expectSame(modelFromBytes(modelBytes(described)), described, false);
  }
  for (const auto& model : {tinyModel(), largeModel()}) {
    expectSame(modelFromBytes(modelBytes(model)), model, false);
    expectSame(modelFromBytes(modelBytes(model, true)), model, true);
    EXPECT_LT(modelBytes(model, true).size(), modelBytes(model).size());
  }
  // What has been rounded once is not rounded again.
  const auto bytes = modelBytes(tinyModel(), true);
  EXPECT_EQ(modelBytes(modelFromBytes(bytes), true), bytes);
}

/** The format as docs/method/classes.md has it. */
TEST(ModelFile, IsAsDocumented)
{
  auto model = tinyModel();
  model.classes = {"a", "b", "c"};
  auto& weights = model.networks[0].layers[0].weights;
  weights[0].values.assign(18, 0.0f);
  weights[0].values[1] = 1.0f;
  weights[1].values = {-2.0f, 0.5f, 0.0f};
  const std::string header =
      R"({"classes":["a","b","c"],"input":{"kind":"points","scale":0.1,)"
      R"("pair_count":20000,"draws":1,"context":false,"point_count":2},)"
      R"("networks":[{"input":[3,2],"layers":[{"kind":"dense","extents":[3]}]}],)";
  std::string values(84, '\0');
  values.replace(4, 4, {'\0', '\0', '\x80', '\x3f'});
  values.replace(72, 4, {'\0', '\0', '\0', '\xc0'});
  values.replace(76, 4, {'\0', '\0', '\0', '\x3f'});
  EXPECT_EQ(modelBytes(model),
            fileOf(header + R"("precision":"float32","weight_bytes":84})", values));
  std::string halves(42, '\0');
  halves.replace(2, 2, {'\0', '\x3c'});
  halves.replace(36, 2, {'\0', '\xc0'});
  halves.replace(38, 2, {'\0', '\x38'});
  EXPECT_EQ(modelBytes(model, true),
            fileOf(header + R"("precision":"float16","weight_bytes":42})", halves));
}

TEST(ModelFile, EveryChangedByteIsNoticed)
{
  const auto bytes = modelBytes(tinyModel());
  for (std::size_t k = 0; k < bytes.size(); ++k)
    for (const int change : {1, 0x80, '\n' ^ bytes[k], int(bytes[k])}) {
      auto changed = bytes;
      changed[k] = static_cast<char>(changed[k] ^ change);
      if (changed != bytes)
        expectRefused(changed);
    }
}

TEST(ModelFile, EveryTruncationIsNoticed)
{
  const auto bytes = modelBytes(tinyModel());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    expectRefused(bytes.substr(0, size));
  expectRefused(bytes + '\0', "damaged");
}

TEST(ModelFile, ForeignFilesAreRefused)
{
  expectRefused("", "is no model");
  expectRefused("# .PCD v0.7\nVERSION 0.7\n", "is no model");
  expectRefused(std::string(1000, '\0'), "is no model");
  expectRefused("pcl_indoor_model 2\n{}\n", "format 2");
  expectRefused("pcl_indoor_model 1\n{}", "no end");
  expectRefused("pcl_indoor_model 1\n" + std::string(100000, '[') + "\n", "not JSON");
}

/** Replaces a text of the tiny model's header; the checksums fit. */
std::string
fileWith(const std::string& from, const std::string& to)
{
  const auto bytes = modelBytes(tinyModel());
  const auto start = bytes.find('\n') + 1;
  const auto end = bytes.find('\n', start);
  auto header = bytes.substr(start, end - start);
  const auto place = header.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  header.replace(place, from.size(), to);
  return fileOf(header, bytes.substr(end + 1, bytes.size() - end - 9));
}

TEST(ModelFile, WhatDoesNotFitIsRefused)
{
  const auto refused =
      [](const std::string& from, const std::string& to, const std::string& message) {
        SCOPED_TRACE(from + " -> " + to);
        expectRefused(fileWith(from, to), message);
      };
  for (const std::string wrong :
       {"null", "-1", "1.5", "true", "\"1\"", "[]", "{}", "1e999"})
    for (const std::string key :
         {"\"scale\":0.1", "\"pair_count\":20000", "\"draws\":1", "\"point_count\":2"})
      if (key != "\"scale\":0.1" || wrong != "1.5")
        refused(key, key.substr(0, key.find(':') + 1) + wrong, "");
  refused("\"draws\":1", "\"draws\":99999999999999999999", "draws");
  refused("\"draws\":1", "\"draws\":2000000000", "1000 times");
  refused("false", "0", "context");
  refused("false", "true", "after points");
  refused("[3,2]", "[3,3]", "takes 9 values");
  refused("[3,2]", "3", "no list");
  refused("[3,2]", "[3,\"2\"]", "whole number");
  refused("[3,2]", "[2147483647,2147483647]", "");
  refused("\"points\"", "\"pints\"", "not known");
  refused("\"points\"", "7", "no text");
  refused("\"dense\"", "\"dance\"", "not known");
  refused("\"extents\":[3]", "\"extents\":[4]", "4 scores for 3 classes");
  refused("\"extents\":[3]", "\"extents\":[]", "");
  refused("\"kind\":\"dense\",\"extents\":[3]", "", "lacks 'kind'");
  refused("{\"kind\":\"dense\",\"extents\":[3]}", "3", "lacks 'kind'");
  refused("{\"kind\":\"dense\",\"extents\":[3]}", "", "at least one layer");
  refused("\"chair\"", "\"a \\\"b\\\"\\n\"", "two classes");
  refused("\"chair\",", "", "3 scores for 2 classes");
  refused("\"chair\"", "5", "no text");
  refused("\"float32\"", "\"float16\"", "42 bytes");
  refused("\"float32\"", "\"float64\"", "not known");
  refused("\"weight_bytes\":84", "\"weight_bytes\":18446744073709551615", "damaged");
  refused("\"weight_bytes\":84", "\"weight_bytes\":18446744073709551607", "damaged");
  refused("\"weight_bytes\":84", "\"weight_bytes\":0", "damaged");
  // Layers that would need far more than the file holds.
  refused("{\"kind\":\"dense\",\"extents\":[3]}",
          "{\"kind\":\"dense\",\"extents\":[40000000]},{\"kind\":\"dense\",\"extents\":"
          "[3]}",
          "bytes of weights");
  std::string nested = "{\"kind\":\"relu\"}";
  for (int k = 0; k < 20; ++k)
    nested = "{\"kind\":\"transform\",\"inner\":[" + nested + "]}";
  refused("{\"kind\":\"dense\",\"extents\":[3]}", nested, "within layers");
}

TEST(ModelFile, WeightsMustBeFinite)
{
  const auto bytes = modelBytes(tinyModel());
  const auto start = bytes.find('\n') + 1;
  const auto end = bytes.find('\n', start);
  const auto header = bytes.substr(start, end - start);
  auto weights = bytes.substr(end + 1, bytes.size() - end - 9);
  EXPECT_NO_THROW(modelFromBytes(fileOf(header, weights)));
  weights.replace(8, 4, {'\0', '\0', '\xc0', '\x7f'}); // NaN
  expectRefused(fileOf(header, weights), "not finite");
}

TEST(ModelFile, WrongModelsAreNotStored)
{
  auto model = tinyModel();
  model.classes[0] = "\xff";
  EXPECT_THROW(modelBytes(model), BadArgumentException);
  model = tinyModel();
  model.classes.pop_back();
  EXPECT_THROW(modelBytes(model), BadArgumentException);
  model = tinyModel();
  model.networks[0].layers[0].weights[0].values[3] = 70000.0f;
  EXPECT_NO_THROW(modelBytes(model));
  EXPECT_THROW(modelBytes(model, true), BadArgumentException);
  model.networks[0].layers[0].weights.clear();
  EXPECT_THROW(modelBytes(model), BadArgumentException);
}

class ModelFileOnDisk : public test::FolderTest {};

TEST_F(ModelFileOnDisk, IsLoaded)
{
  std::ofstream(path("model"), std::ios::binary) << modelBytes(tinyModel());
  expectSame(loadModel(path("model")), tinyModel(), false);
  std::ofstream(path("empty"));
  for (const auto* name : {"none", ".", "empty"})
    try {
      loadModel(path(name));
      ADD_FAILURE() << name;
    } catch (const IOException& problem) {
      EXPECT_EQ(textOf(problem).rfind(path(name) + ": ", 0), 0u) << problem.what();
    }
}

} // namespace
} // namespace pcl::indoor
