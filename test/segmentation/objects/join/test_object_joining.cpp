/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "segmentation/objects/join/joining_brute_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

using Labels = std::vector<std::uint32_t>;

/** A chain of pieces, each in contact with the next. */
PieceGraph
chain(std::uint32_t count)
{
  std::mt19937 rng(5);
  auto graph = randomGraph(count, 0, rng);
  for (std::uint32_t p = 0; p + 1 < count; ++p)
    graph.contacts.push_back(randomContact(p, p + 1, rng));
  return graph;
}

/** Judges by the features alone, and keeps a record. */
struct FeatureCriterion : JoiningCriterion {
  std::size_t judged = 0;

  float
  probability(const JoiningFeatures& features, std::uint32_t, std::uint32_t) override
  {
    ++judged;
    return probabilityOf(features);
  }
};

/** Judges by a function of the pieces. */
struct NumberCriterion : JoiningCriterion {
  std::function<float(std::uint32_t, std::uint32_t)> judge;

  explicit NumberCriterion(std::function<float(std::uint32_t, std::uint32_t)> function)
  : judge(std::move(function))
  {}

  float
  probability(const JoiningFeatures&, std::uint32_t a, std::uint32_t b) override
  {
    return judge(std::min(a, b), std::max(a, b));
  }
};

/** Knows which pieces are left, and what is in them. */
struct Listener : JoiningCriterion {
  std::map<std::uint32_t, std::set<std::uint32_t>> members;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> heard;
  std::set<std::uint32_t> judged; ///< others than the last union, since then
  std::map<std::uint32_t, std::set<std::uint32_t>> near;

  explicit Listener(const PieceGraph& graph)
  {
    for (std::uint32_t p = 0; p < graph.pieces.size(); ++p)
      members[p] = {p};
    for (const auto& contact : graph.contacts) {
      near[contact.first].insert(contact.second);
      near[contact.second].insert(contact.first);
    }
  }

  float
  probability(const JoiningFeatures& features,
              std::uint32_t a,
              std::uint32_t b) override
  {
    EXPECT_TRUE(members.count(a) && members.count(b)) << "one of them is gone";
    EXPECT_TRUE(near[a].count(b) && near[b].count(a));
    if (heard.empty())
      return probabilityOf(features);
    EXPECT_TRUE(a == heard.back().first || b == heard.back().first);
    judged.insert(a == heard.back().first ? b : a);
    std::size_t parts_a = members[a].size(), parts_b = members[b].size();
    const auto indexOf = [](const std::string& name) {
      const auto& names = joiningFeatureNames();
      return std::find(names.begin(), names.end(), name) - names.begin();
    };
    EXPECT_NEAR(features[indexOf("log parts, a")], std::log(parts_a), 1e-6);
    EXPECT_NEAR(features[indexOf("log parts, b")], std::log(parts_b), 1e-6);
    EXPECT_EQ(features[indexOf("contacts, a")], near[a].size());
    EXPECT_EQ(features[indexOf("contacts, b")], near[b].size());
    return probabilityOf(features);
  }

  void
  expectAllJudged()
  {
    if (heard.empty())
      return;
    EXPECT_EQ(judged, near[heard.back().first]);
  }

  void
  joined(std::uint32_t kept, std::uint32_t gone) override
  {
    expectAllJudged();
    judged.clear();
    heard.emplace_back(kept, gone);
    ASSERT_TRUE(members.count(kept) && members.count(gone));
    members[kept].insert(members[gone].begin(), members[gone].end());
    members.erase(gone);
    for (const auto other : near[gone]) {
      near[other].erase(gone);
      if (other == kept)
        continue;
      near[kept].insert(other);
      near[other].insert(kept);
    }
    near.erase(gone);
  }
};

void
expectSame(const std::vector<PieceJoin>& a, const std::vector<PieceJoin>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].kept, b[i].kept) << "join " << i;
    EXPECT_EQ(a[i].gone, b[i].gone) << "join " << i;
    EXPECT_NEAR(a[i].level, b[i].level, 1e-6f) << "join " << i;
  }
}

/** Segments named by their first pieces. */
Labels
firstPieces(const Labels& segments)
{
  std::map<std::uint32_t, std::uint32_t> first;
  Labels names;
  for (std::uint32_t p = 0; p < segments.size(); ++p)
    names.push_back(first.emplace(segments[p], p).first->second);
  return names;
}

} // namespace

TEST(ObjectJoining, AgreesWithJoiningByTheLetter)
{
  std::size_t joined = 0;
  for (unsigned trial = 0; trial < 25; ++trial) {
    std::mt19937 rng(trial);
    const auto graph = randomGraph(4 + trial % 9, trial % 2 ? 30 : 70, rng);
    const float least = trial % 3 ? 0.1f : 0.0f;
    FeatureCriterion criterion;
    const auto joins = joinPieces(graph, criterion, least).joins;
    SCOPED_TRACE(trial);
    expectSame(joins, LiteralJoining(graph).joinAll(least));
    joined += joins.size();
  }
  EXPECT_GT(joined, 60u);
}

TEST(ObjectJoining, LevelsDescend)
{
  std::mt19937 rng(2);
  for (unsigned trial = 0; trial < 10; ++trial) {
    const auto graph = randomGraph(30, 20, rng);
    FeatureCriterion criterion;
    const auto joins = joinPieces(graph, criterion, 0.1f).joins;
    ASSERT_GT(joins.size(), 5u);
    std::set<std::uint32_t> gone;
    for (std::size_t i = 0; i < joins.size(); ++i) {
      EXPECT_LE(joins[i].level, i == 0 ? 1 : joins[i - 1].level);
      EXPECT_GE(joins[i].level, 0.1f);
      EXPECT_LT(joins[i].kept, joins[i].gone) << "known by the smaller number";
      EXPECT_EQ(gone.count(joins[i].kept), 0u);
      EXPECT_TRUE(gone.insert(joins[i].gone).second);
    }
  }
}

TEST(ObjectJoining, SegmentsAtALevelAreThoseOfStoppingThere)
{
  std::mt19937 rng(3);
  for (unsigned trial = 0; trial < 10; ++trial) {
    const auto graph = randomGraph(25, 25, rng);
    FeatureCriterion criterion;
    const auto joins = joinPieces(graph, criterion, 0.05f).joins;
    ASSERT_FALSE(joins.empty());
    std::vector<float> levels{0.05f, 0.5f, 1};
    for (const auto& join : joins) {
      levels.push_back(join.level);
      levels.push_back(std::nextafter(join.level, 2.0f));
    }
    std::set<std::size_t> counts;
    for (const auto level : levels) {
      FeatureCriterion again;
      const auto stopped = joinPieces(graph, again, level).joins;
      const auto segments = segmentsAtLevel(25, joins, level);
      EXPECT_EQ(segments, segmentsAtLevel(25, stopped, 0)) << level;
      const auto count = static_cast<std::size_t>(
          std::count_if(joins.begin(), joins.end(), [&](const auto& join) {
            return join.level >= level;
          }));
      EXPECT_EQ(stopped.size(), count);
      const std::set<std::uint32_t> names(segments.begin(), segments.end());
      EXPECT_EQ(names.size(), 25 - count);
      for (const auto name : names)
        EXPECT_EQ(segments[name], name) << "one of its pieces";
      counts.insert(count);
    }
    EXPECT_GT(counts.size(), 3u);
  }
}

TEST(ObjectJoining, JoinsAreHeardBeforeTheirUnionsAreJudged)
{
  std::mt19937 rng(6);
  for (unsigned trial = 0; trial < 10; ++trial) {
    const auto graph = randomGraph(20, 30, rng);
    Listener listener(graph);
    const auto joins = joinPieces(graph, listener, 0).joins;
    listener.expectAllJudged();
    ASSERT_EQ(listener.heard.size(), joins.size());
    ASSERT_GT(joins.size(), 10u);
    for (std::size_t i = 0; i < joins.size(); ++i)
      EXPECT_EQ(listener.heard[i], std::make_pair(joins[i].kept, joins[i].gone));
  }
}

TEST(ObjectJoining, TheSmallerPieceIsJudgedFirst)
{
  struct Sizes : JoiningCriterion {
    const PieceGraph& graph;
    std::size_t judged = 0;

    explicit Sizes(const PieceGraph& pieces)
    : graph(pieces)
    {}

    float
    probability(const JoiningFeatures& features,
                std::uint32_t a,
                std::uint32_t b) override
    {
      ++judged;
      const double size_a = graph.pieces[a].positions.count,
                   size_b = graph.pieces[b].positions.count;
      EXPECT_TRUE(size_a < size_b || (size_a == size_b && a < b));
      EXPECT_NEAR(features[0], std::log(size_a / 1024), 1e-5);
      EXPECT_NEAR(features[13], std::log(size_b / 1024), 1e-5);
      return 0;
    }
  };
  std::mt19937 rng(7);
  const auto graph = randomGraph(20, 50, rng);
  Sizes sizes(graph);
  EXPECT_TRUE(joinPieces(graph, sizes, 0.5f).joins.empty());
  EXPECT_EQ(sizes.judged, graph.contacts.size());
}

TEST(ObjectJoining, EqualPairsAreJoinedInTheOrderOfTheirNumbers)
{
  NumberCriterion always([](auto, auto) { return 0.5f; });
  const auto joins = joinPieces(chain(5), always, 0.5f).joins;
  ASSERT_EQ(joins.size(), 4u);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(joins[i].kept, 0u);
    EXPECT_EQ(joins[i].gone, i + 1);
    EXPECT_EQ(joins[i].level, 0.5f);
  }
  auto graph = chain(6);
  std::reverse(graph.contacts.begin(), graph.contacts.end());
  NumberCriterion odd([](auto a, auto) { return a % 2 ? 0.75f : 0.5f; });
  const auto in_turn = joinPieces(graph, odd, 0.6f).joins; // 1 - 2 is before 3 - 4
  ASSERT_EQ(in_turn.size(), 4u);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(in_turn[i].kept, 1u);
    EXPECT_EQ(in_turn[i].gone, i + 2);
  }
}

TEST(ObjectJoining, ALevelDoesNotRiseAgain)
{
  // 1 and 2 are joined first; then their union is sure to be joined with 0.
  int calls = 0;
  NumberCriterion criterion([&](std::uint32_t a, std::uint32_t b) {
    ++calls;
    return a == 1 && b == 2 ? 0.4f : calls > 2 ? 1.0f : 0.2f;
  });
  const auto joins = joinPieces(chain(3), criterion, 0.1f).joins;
  ASSERT_EQ(joins.size(), 2u);
  EXPECT_EQ(joins[0].kept, 1u);
  EXPECT_EQ(joins[0].gone, 2u);
  EXPECT_EQ(joins[0].level, 0.4f);
  EXPECT_EQ(joins[1].kept, 0u);
  EXPECT_EQ(joins[1].gone, 1u);
  EXPECT_EQ(joins[1].level, 0.4f);
  EXPECT_EQ(segmentsAtLevel(3, joins, 0.5f), (Labels{0, 1, 2}));
  EXPECT_EQ(segmentsAtLevel(3, joins, 0.4f), (Labels{0, 0, 0}));
}

TEST(ObjectJoining, AStarOfManyPiecesIsJoinedInBoundedWork)
{
  constexpr std::uint32_t count = 1500;
  for (const std::uint32_t hub : {count / 2}) {
    std::mt19937 rng(9);
    auto graph = randomGraph(count + 1, 0, rng);
    for (std::uint32_t p = 0; p <= count; ++p)
      if (p != hub)
        graph.contacts.push_back(
            randomContact(std::min(p, hub), std::max(p, hub), rng));
    std::size_t judged = 0;
    NumberCriterion sure([&](auto, auto) {
      ++judged;
      return 0.5f;
    });
    const auto joins = joinPieces(graph, sure).joins;
    ASSERT_EQ(joins.size(), count);
    EXPECT_EQ(segmentsAtLevel(count + 1, joins, 0.5f), Labels(count + 1, 0));
    EXPECT_LT(judged, count * count / 8) << "not each time that the hub has grown";
  }
}

TEST(ObjectJoining, PiecesAtAHubAreJoinedAboutAsByTheLetter)
{
  // Pairs of pieces on a large one: what belongs together is found, and no more.
  constexpr std::uint32_t pairs = 600;
  std::mt19937 rng(10);
  auto graph = randomGraph(2 * pairs + 1, 0, rng);
  for (std::uint32_t p = 1; p <= 2 * pairs; ++p)
    graph.contacts.push_back(randomContact(0, p, rng));
  for (std::uint32_t p = 1; p < 2 * pairs; p += 2)
    graph.contacts.push_back(randomContact(p, p + 1, rng));
  NumberCriterion criterion([](auto a, auto b) {
    return a == 0 ? (b < 20 ? 0.8f : 0.1f) : a % 2 == 1 && b == a + 1 ? 0.9f : 0.1f;
  });
  const auto segments =
      segmentsAtLevel(2 * pairs + 1, joinPieces(graph, criterion).joins, 0.5f);
  for (std::uint32_t p = 1; p <= 2 * pairs; ++p)
    EXPECT_EQ(segments[p], p <= 20 ? 0 : p - (p + 1) % 2) << p;
}

TEST(ObjectJoining, WithoutContactsNothingIsJoined)
{
  NumberCriterion never([](auto, auto) -> float {
    ADD_FAILURE() << "there is nothing to judge";
    return 1;
  });
  EXPECT_TRUE(joinPieces({}, never, 0).joins.empty());
  std::mt19937 rng(8);
  EXPECT_TRUE(joinPieces(randomGraph(7, 0, rng), never, 0).joins.empty());
  auto planes = randomGraph(0, 0, rng);
  planes.pieces.resize(3); // without voxels
  EXPECT_TRUE(joinPieces(planes, never, 0).joins.empty());
  EXPECT_TRUE(segmentsAtLevel(0, {}, 0).empty());
  EXPECT_EQ(segmentsAtLevel(3, {}, 0), (Labels{0, 1, 2}));
}

TEST(ObjectJoining, SegmentsAreUnionsOfUnions)
{
  const std::vector<PieceJoin> joins{
      {3, 5, 0.9f}, {1, 2, 0.8f}, {1, 3, 0.7f}, {0, 1, 0.6f}};
  EXPECT_EQ(firstPieces(segmentsAtLevel(6, joins, 0.75f)), (Labels{0, 1, 1, 3, 4, 3}));
  EXPECT_EQ(firstPieces(segmentsAtLevel(6, joins, 0.7f)), (Labels{0, 1, 1, 1, 4, 1}));
  EXPECT_EQ(firstPieces(segmentsAtLevel(6, joins, 0)), (Labels{0, 0, 0, 0, 4, 0}));
  EXPECT_EQ(segmentsAtLevel(6, joins, 0.95f), (Labels{0, 1, 2, 3, 4, 5}));
}
