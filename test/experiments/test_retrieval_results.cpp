/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

// What pcl_eppf_retrieval makes of its options, seen in what it prints.

#include "support/folder_test.h"
#include "support/run_tool.h"

#include <sys/wait.h> // for WIFEXITED

#include <algorithm>
#include <sstream>

using pcl::indoor::test::bytesOf;

namespace {

class RetrievalResults : public pcl::indoor::test::FolderTest {
protected:
  void
  SetUp() override
  {
    FolderTest::SetUp();
    for (const std::string shape : {"flat", "long"})
      for (int k = 1; k <= 3; ++k) {
        std::filesystem::create_directories(path("set/" + shape));
        const double width = 0.1 * k + 1;
        write("set/" + shape + "/" + std::to_string(k) + ".off",
              box(width, width, shape == "flat" ? 0.3 : 4));
      }
  }

  /** The mesh of a box of these edges. */
  static std::string
  box(double x, double y, double z)
  {
    std::ostringstream text;
    text << "OFF\n8 6 0\n";
    for (int k = 0; k < 8; ++k)
      text << (k & 1) * x << " " << (k >> 1 & 1) * y << " " << (k >> 2) * z << "\n";
    text << "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
    return text.str();
  }

  /** Exit status; all that was printed is in "said". */
  int
  status(const std::string& options) const
  {
    const int result = pcl::indoor::test::runTool(
        "pcl_eppf_retrieval",
        path("set") + " -descriptors eppf -repeats 1 -quiet " + options,
        path("said"));
    return WIFEXITED(result) ? WEXITSTATUS(result) : -1;
  }

  /** The line of correlations. */
  std::string
  correlation(const std::string& options) const
  {
    EXPECT_EQ(status("-correlation " + options), 0) << bytesOf(path("said"));
    std::istringstream said(bytesOf(path("said")));
    std::string line;
    std::getline(said, line);
    EXPECT_EQ(line.find("correlation of features, mean |r| 0."), 0u) << line;
    return line;
  }
};

} // namespace

TEST_F(RetrievalResults, NormalsAreGivenUnlessRRHTIsWanted)
{
  const auto faces = correlation("");
  EXPECT_EQ(correlation("-normal_method given"), faces);
  const auto hough = correlation("-normal_method rrht");
  EXPECT_NE(hough, faces);
  EXPECT_EQ(correlation("-normal_method rrht"), hough);
}

TEST_F(RetrievalResults, CorrelationFollowsTheScale)
{
  // the objects have two sizes: f1 in metres tells them apart
  EXPECT_NE(correlation("-scale 1"), correlation(""));
  EXPECT_EQ(correlation("-scale 1"), correlation("-scale 2")) << "a unit for all";
  EXPECT_EQ(correlation("-scale 1"), correlation("-scale_by largest"));
}

TEST_F(RetrievalResults, RRHTIsRefusedWhereNormalsAreOfPlanes)
{
  for (const std::string options : {"-noise 1", "-noise 0,2", "-estimate_normals"}) {
    EXPECT_EQ(status("-normal_method rrht -json " + path("out.json") + " " + options),
              1);
    const auto said = bytesOf(path("said"));
    EXPECT_NE(said.find("-normal_method rrht: "), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1);
    EXPECT_FALSE(std::filesystem::exists(path("out.json")));
  }
  EXPECT_EQ(status("-normal_method other"), 1);
  EXPECT_EQ(status("-normals ignored"), 0); // the descriptor's own
}

TEST_F(RetrievalResults, NamesNeedNotBeUTF8)
{
  std::filesystem::rename(path("set/long"), path("set/l\xE4nglich"));
  ASSERT_EQ(status("-json " + path("out.json")), 0) << bytesOf(path("said"));
  EXPECT_NE(bytesOf(path("out.json")).find("l\xEF\xBF\xBDnglich"), std::string::npos);
}

TEST_F(RetrievalResults, ListsNameSomething)
{
  EXPECT_EQ(status("-distances kl,l2"), 0);
  for (const std::string option : {"-distances", "-noise", "-descriptors"})
    for (const std::string list : {"\"\"", "no"}) {
      EXPECT_EQ(status(option + " " + list), 1);
      EXPECT_NE(bytesOf(path("said")).find(option + ": "), std::string::npos);
    }
}
