/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Curves and confusion matrices.
#include "pictures/line_plot.h"

#include "pictures/confusion_picture.h"
#include "support/occurrences.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;
using pcl::indoor::test::occurrences;

TEST(LinePlot, StepsAreRound)
{
  EXPECT_DOUBLE_EQ(plotStep(6.0), 1.0);
  EXPECT_DOUBLE_EQ(plotStep(7.0), 2.0);
  EXPECT_DOUBLE_EQ(plotStep(30.0), 5.0);
  EXPECT_DOUBLE_EQ(plotStep(0.45), 0.1);
  for (double whole = 0.01; whole < 1e4; whole *= 1.1)
    EXPECT_LE(whole / plotStep(whole), 6.0 + 1e-9) << whole;
}

TEST(LinePlot, CurvesLieBetweenTheAxes)
{
  const PlotAxes axes{"A title", "Epoch", "Loss", 10.0, 5.0, 5.0, 5.0};
  const auto text =
      linePlot(axes, {{"one", {{0.0, 0.0}, {10.0, 5.0}}, {1, 2, 3}}}).str();
  // from the lower left corner to the upper right one
  EXPECT_EQ(
      occurrences(text, "stroke-linejoin=\"round\" points=\" 64.0,280.0 504.0,40.0\""),
      1u);
  for (const char* name : {">A title<", ">Epoch<", ">Loss<", ">one<"})
    EXPECT_EQ(occurrences(text, name), 1u) << name;
  EXPECT_EQ(occurrences(text, ">5<"), 2u);                // of both axes
  EXPECT_EQ(occurrences(text, "stroke=\"#010203\""), 4u); // curve, two marks, legend
}

TEST(ConfusionPicture, CellsHoldShares)
{
  const auto confusion = confusionMatrix({0, 0, 0, 1}, {0, 0, 1, 1}, 2);
  const auto text = confusionPicture(confusion, {"chair", "R&D"}).str();
  for (const char* share : {">67<", ">33<", ">100<"})
    EXPECT_EQ(occurrences(text, share), 1u) << share;
  EXPECT_EQ(occurrences(text, ">0<"), 0u);
  EXPECT_EQ(occurrences(text, ">chair<"), 2u);
  EXPECT_EQ(occurrences(text, ">R&#38;D<"), 2u);
}
