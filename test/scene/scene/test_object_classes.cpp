/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scene/object_classes.h"

#include "files/tool_error.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

/** Tells every object to be a chair, probably. */
ObjectNaming
chairNaming()
{
  return {{"chair", "other", "table"},
          [](const std::vector<ClassifierObject>& objects) {
            return std::vector<Classification>(objects.size(), {{0.6f, 0.3f, 0.1f}});
          }};
}

class ObjectClasses : public testing::Test {
protected:
  std::vector<ObjectClass>
  found(const ObjectVotes& votes = {}) const
  {
    return classesOf(surfaces, measures, chairNaming(), votes);
  }

  std::vector<ObjectSurface> surfaces{
      ObjectSurface{std::vector<OrientedPoint>(50), 0.0f}};
  std::vector<ObjectMeasures> measures{1};
};

TEST_F(ObjectClasses, without_votes_are_the_model_s)
{
  const auto classes = found();
  ASSERT_EQ(classes.size(), 1u);
  EXPECT_EQ(classes[0].category, 1u);
  EXPECT_FLOAT_EQ(classes[0].confidence, 0.6f);
}

TEST_F(ObjectClasses, votes_count_three_quarters_of_the_geometric_mean)
{
  const auto classes =
      found({{"floor", "wall", "ceiling", "table", "chair"}, {{0, 0, 0, 0.7f, 0.2f}}});
  ASSERT_EQ(classes[0].top.size(), 3u);
  EXPECT_EQ(classes[0].category, 3u);
  const auto mean = [](double model, double vote) {
    return std::pow(model + 1e-3, 0.25) * std::pow(vote + 1e-3, 0.75);
  };
  const double table = mean(0.1, 0.7), chair = mean(0.6, 0.2), other = mean(0.3, 0);
  EXPECT_NEAR(classes[0].confidence, table / (table + chair + other), 1e-4);
  EXPECT_EQ(classes[0].top[1].first, 1u);
}

TEST_F(ObjectClasses, a_wrong_number_of_probabilities_is_refused)
{
  const ObjectVotes votes{{"table"}, {{0.7f}}};
  for (const std::size_t count : {1, 2, 4}) {
    auto naming = chairNaming();
    naming.classify = [count](const std::vector<ClassifierObject>& objects) {
      return std::vector<Classification>(objects.size(),
                                         {std::vector<float>(count, 0.2f)});
    };
    EXPECT_THROW(classesOf(surfaces, measures, naming, {}), ToolError) << count;
    EXPECT_THROW(classesOf(surfaces, measures, naming, votes), ToolError) << count;
  }
}

TEST_F(ObjectClasses, structure_has_no_class_in_spite_of_votes)
{
  measures[0].structure = 2;
  const auto classes = found({{"floor", "wall", "ceiling", "table"}, {{0, 0, 0, 1}}});
  EXPECT_EQ(classes[0].category, 0u);
}

} // namespace
