/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/object_segmentation.h>

#include "objects/object_steps.h"

#include <gtest/gtest.h>

#include <random>

using namespace pcl::indoor;

namespace {

/** One object that is as wide and deep, beside a wall. */
ObjectSegmentation
resultWithObject(float width, float depth)
{
  DetailedSegmentation result;
  for (float x = 0; x <= width; x += 0.05f)
    for (float y = 0; y <= depth; y += 0.05f) {
      result.scene.points.emplace_back(x, y, 0.5f);
      result.segment_of_point.push_back(1);
    }
  for (int i = 0; i < 50000; ++i) {
    result.scene.points.emplace_back(0, 0.001f * static_cast<float>(i), 1);
    result.segment_of_point.push_back(0);
  }
  result.segment_count = 2;
  result.structure_of_segment = {StructureKind::Wall, StructureKind::None};
  return published(std::move(result));
}

} // namespace

TEST(ObjectReport, AnObjectAsWideAsARoomIsSaid)
{
  const auto line = wideObjectWarning(resultWithObject(7.0f, 5.0f));
  EXPECT_NE(line.find("m wide, as no furniture is"), std::string::npos) << line;
  EXPECT_EQ(wideObjectWarning(resultWithObject(7.0f, 2.0f)), "") << "a row of cabinets";
  EXPECT_EQ(wideObjectWarning(resultWithObject(3.0f, 3.0f)), "") << "a corner sofa";
}

TEST(ObjectReport, WhatIsNoObjectIsNotSaid)
{
  EXPECT_EQ(wideObjectWarning({}), "");
  auto result = resultWithObject(7, 5);
  result.structure_of_segment[1] = StructureKind::Floor;
  EXPECT_EQ(wideObjectWarning(result), "");
  result.segment_of_point.assign(result.segment_of_point.size(), 0);
  EXPECT_EQ(wideObjectWarning(result), "") << "a wall alone";
  result = resultWithObject(7, 5);
  result.options.pieces.scale = JoiningScale::View;
  EXPECT_EQ(wideObjectWarning(result), "");
}

TEST(ObjectReport, OfATableThatACameraSeesNoDirectionUpIsKnown)
{
  DetailedSegmentation result;
  std::mt19937 rng(1);
  std::uniform_real_distribution<float> share(0, 1);
  for (std::uint32_t i = 0; i < 40000; ++i) { // ten pieces, 1.4 m wide
    result.scene.points.emplace_back(1.4f * share(rng), 1.4f * share(rng), 0.5f);
    result.piece_of_point.push_back(i % 10);
    result.segment_of_point.push_back(0);
  }
  result.segment_count = 1;
  result.structure_of_segment = {StructureKind::None};
  auto of_table = result;
  of_table.scene.capture = Capture::TableView;
  EXPECT_NE(tableTopWarning(published(result)), "");
  EXPECT_EQ(tableTopWarning(published(of_table)), "");
  for (auto* each : {&result, &of_table})
    for (auto& point : each->scene.points)
      point *= 4;
  EXPECT_NE(wideObjectWarning(published(result)), "");
  EXPECT_EQ(wideObjectWarning(published(of_table)), "");
}
