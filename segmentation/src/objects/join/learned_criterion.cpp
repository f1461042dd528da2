/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/join/object_joining.h"

#include "bundled_joining.h"

#include <pcl/exceptions.h>

#include <array>
#include <map>
#include <sstream>
#include <string>

namespace {

using pcl::indoor::BoostedTrees;
using pcl::indoor::JoiningScale;

/** The bundled trees of a name, which stands before them in their text. */
const BoostedTrees&
bundledTrees(const std::string& name)
{
  static const auto all = [] {
    std::map<std::string, BoostedTrees> trees;
    std::istringstream text{std::string(pcl::indoor::bundled_joining)};
    for (std::string next; text >> next;)
      trees.emplace(next, BoostedTrees::read(text));
    return trees;
  }();
  const auto found = all.find(name);
  if (found == all.end())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException, "No trees for " << name << ".");
  return found->second;
}

const BoostedTrees&
bundledTrees(JoiningScale scale, bool has_votes)
{
  constexpr std::array<const char*, 3> names{"parts", "objects", "view"};
  if (has_votes && scale == JoiningScale::Objects)
    return bundledTrees("voted");
  return bundledTrees(names.at(static_cast<std::size_t>(scale)));
}

const BoostedTrees&
bundledFits(JoiningScale scale, bool has_votes)
{
  if (scale == JoiningScale::View)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "How well objects in views fit was not learned.");
  if (scale == JoiningScale::Parts)
    return bundledTrees("fit_of_parts");
  return bundledTrees(has_votes ? "fit_of_voted" : "fit_of_objects");
}

} // namespace

namespace pcl::indoor {

LearnedCriterion::LearnedCriterion(JoiningScale scale, bool has_votes)
: LearnedCriterion(bundledTrees(scale, has_votes))
{}

LearnedCriterion::LearnedCriterion(BoostedTrees trees)
: trees_(std::move(trees))
{
  if (trees_.featureCount() != std::tuple_size<JoiningFeatures>::value)
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The trees are for "
                            << trees_.featureCount() << " features, not for "
                            << std::tuple_size<JoiningFeatures>::value << ".");
}

float
LearnedCriterion::probability(const JoiningFeatures& features,
                              std::uint32_t /*a*/,
                              std::uint32_t /*b*/)
{
  return trees_.probability(features.data());
}

float
levelOf(JoiningScale scale)
{
  constexpr std::array<float, 3> levels{0.7f, 0.4f, 0.9f};
  return levels.at(static_cast<std::size_t>(scale));
}

std::vector<float>
expectedFits(const JoinTree& tree, JoiningScale scale, bool has_votes)
{
  const auto& trees = bundledFits(scale, has_votes);
  std::vector<float> fits;
  for (const auto& object : tree.objects)
    fits.push_back(trees.probability(object.data()));
  return fits;
}

} // namespace pcl::indoor
