/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/progress.h"
#include "support/occurrences.h"
#include "training/training_report.h"

#include <gtest/gtest.h>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

using pcl::indoor::test::occurrences;

const EpochLog two_networks{{{1, 2.0, 0.5, 2.5, 0.25}, {2, 1.0, 0.75, 1.5, 0.5}},
                            {{1, 3.0, 0.125, 4.0, 0.0}}};

} // namespace

TEST(TrainingReport, WritesARowPerEpoch)
{
  EXPECT_EQ(logText(two_networks, true),
            "network,epoch,training_loss,training_accuracy,validation_loss,"
            "validation_accuracy\n"
            "1,1,2,0.5,2.5,0.25\n1,2,1,0.75,1.5,0.5\n2,1,3,0.125,4,0\n");
  EXPECT_EQ(logLine(1, two_networks[0][0], false), "1,1,2,0.5,,\n");
}

TEST(TrainingReport, DrawsTheCurvesThatThereAre)
{
  const EpochLog one{two_networks[0]};
  const auto alone = curvesPicture(one, false), both = curvesPicture(one, true);
  EXPECT_EQ(occurrences(alone.str(), ">Training<"), 2u); // loss and accuracy
  EXPECT_EQ(occurrences(alone.str(), "stroke-dasharray"), 0u);
  EXPECT_EQ(occurrences(both.str(), ">Validation<"), 2u);
  EXPECT_EQ(occurrences(both.str(), "stroke-dasharray"), 4u); // and in the legends
  const auto two = curvesPicture(two_networks, false);
  EXPECT_EQ(occurrences(two.str(), ">Training 2<"), 2u);
  EXPECT_GT(curvesPicture({{{1, 0.0, 1.0, 0.0, 0.0}}}, false).width(), 0); // no loss
}

TEST(TrainingReport, SaysTheScores)
{
  // two of three and one of one are right
  const auto confusion = confusionMatrix({0, 0, 0, 1}, {0, 0, 1, 1}, 2);
  EXPECT_EQ(scoresText(confusion),
            "4 objects: total accuracy 75.00 %, mean accuracy 75.00 %, mean recall "
            "83.33 %, F1 0.733\n");
}

TEST(Progress, SaysTimesForPeople)
{
  EXPECT_EQ(durationText(0.2), "0 s");
  EXPECT_EQ(durationText(59.0), "59 s");
  EXPECT_EQ(durationText(150.0), "2 min");
  EXPECT_EQ(durationText(9000.0), "2.5 h");
}
