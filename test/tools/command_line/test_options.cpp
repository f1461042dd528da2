/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"

#include "text/pcl_errors.h"

#include <pcl/console/print.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>
#include <string>
#include <thread>
#include <vector>

using namespace pcl::indoor::tool;

namespace {

struct Values {
  std::string input, output;
  double size = 0.2;
  float share = 0.5f;
  int count = 3;
  std::uint32_t seed = 7;
  std::string partition = "graph";
  bool fast = false;
};

OptionParser
makeParser(Values& values)
{
  OptionParser parser("pcl_example", "Does something.");
  parser.positional("input", values.input, "a cloud")
      .positional("output.pcd", values.output, "the result")
      .number("-size", values.size, "size of it", "m", Range::positive())
      .number("-share", values.share, "share of it", "", Range::between(0, 1))
      .number("-count", values.count, "number of it", "", Range::between(-5, 10))
      .number("-seed", values.seed, "seed")
      .text("-partition", values.partition, "way to do it", {"graph", "lccp", "-x"})
      .flag("-fast", values.fast, "do it fast");
  return parser;
}

bool
parse(Values& values, std::vector<const char*> arguments)
{
  arguments.insert(arguments.begin(), "pcl_example");
  return makeParser(values).parse(static_cast<int>(arguments.size()), arguments.data());
}

/** The message that the arguments, after two good file names, lead to. */
std::string
errorOf(std::vector<const char*> arguments)
{
  arguments.insert(arguments.begin(), {"a.pcd", "b.pcd"});
  Values values;
  try {
    parse(values, arguments);
  } catch (const ToolError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST(OptionParser, DefaultsStayAndGivenValuesArrive)
{
  Values values;
  ASSERT_TRUE(parse(values, {"a.pcd", "b.pcd"}));
  EXPECT_EQ(values.input, "a.pcd");
  EXPECT_EQ(values.output, "b.pcd");
  EXPECT_EQ(values.size, 0.2);
  EXPECT_EQ(values.partition, "graph");
  EXPECT_FALSE(values.fast);

  ASSERT_TRUE(parse(values,
                    {"-size",
                     "1e-3",
                     "c.pcd",
                     "-count",
                     "-4",
                     "-fast",
                     "d.pcd",
                     "-share",
                     ".25",
                     "-seed",
                     "4294967295",
                     "-partition",
                     "lccp"}));
  EXPECT_EQ(values.input, "c.pcd");
  EXPECT_EQ(values.output, "d.pcd");
  EXPECT_EQ(values.size, 1e-3);
  EXPECT_EQ(values.count, -4);
  EXPECT_EQ(values.share, 0.25f);
  EXPECT_EQ(values.seed, 4294967295u);
  EXPECT_EQ(values.partition, "lccp");
  EXPECT_TRUE(values.fast);
}

TEST(OptionParser, UnreadableNumbersAreNamed)
{
  EXPECT_EQ(errorOf({"-size", "abc"}), "-size: 'abc' is not a number");
  EXPECT_EQ(errorOf({"-size", "0.1m"}), "-size: '0.1m' is not a number");
  EXPECT_EQ(errorOf({"-size", ""}), "-size: '' is not a number");
  EXPECT_EQ(errorOf({"-size", "nan"}), "-size: 'nan' is not a number");
  EXPECT_EQ(errorOf({"-size", "inf"}), "-size: 'inf' is not a number");
  EXPECT_EQ(errorOf({"-size", "0,1"}), "-size: '0,1' is not a number");
  EXPECT_EQ(errorOf({"-count", "1.5"}), "-count: '1.5' is not a whole number");
}

TEST(OptionParser, NumbersOutOfRangeAreNamed)
{
  EXPECT_EQ(errorOf({"-size", "0"}),
            "-size: '0' is out of range, it must be greater than 0");
  EXPECT_EQ(errorOf({"-size", "-1"}),
            "-size: '-1' is out of range, it must be greater than 0");
  EXPECT_EQ(errorOf({"-share", "1.01"}),
            "-share: '1.01' is out of range, it must be from 0 to 1");
  EXPECT_EQ(errorOf({"-count", "11"}),
            "-count: '11' is out of range, it must be from -5 to 10");
  EXPECT_EQ(errorOf({"-seed", "4294967296"}), "-seed: '4294967296' is out of range");
  EXPECT_EQ(errorOf({"-seed", "-1"}), "-seed: '-1' is out of range");
  EXPECT_EQ(errorOf({"-size", "1e999"}), "-size: '1e999' is out of range");
}

TEST(OptionParser, PositiveNumbersMustStaySoAsFloat)
{
  float size = 1.0f;
  OptionParser parser("pcl_example", "Does something.");
  parser.number("-size", size, "size", "m", Range::positive());
  const char* const arguments[] = {"pcl_example", "-size", "1e-60"}; // 0 as a float
  EXPECT_THROW(parser.parse(3, arguments), ToolError);
}

TEST(OptionParser, IncompleteUnknownAndRepeatedOptionsAreRefused)
{
  EXPECT_EQ(errorOf({"-size"}), "-size: the value is missing");
  EXPECT_EQ(errorOf({"-size", "-fast"}), "-size: the value is missing");
  EXPECT_EQ(errorOf({"-fast", "-fast"}), "-fast: the option is given twice");
  EXPECT_EQ(errorOf({"-sise", "1"}), "-sise: unknown option, did you mean -size?");
  EXPECT_EQ(errorOf({"--size", "1"}), "--size: unknown option, write -size");
  EXPECT_EQ(errorOf({"-partition", "none"}),
            "-partition: 'none' is not one of graph|lccp|-x");
  EXPECT_NE(errorOf({"c.pcd"}).find("'c.pcd' is one argument too many"),
            std::string::npos);
}

TEST(OptionParser, TwoOptionsOfOneNameAreAnErrorOfTheProgram)
{
  Values values;
  auto parser = makeParser(values);
  parser.flag("-size", values.fast, "do it in size");
  for (const char* argument : {"-h", "-fast"}) {
    const char* const arguments[] = {"pcl_example", argument};
    EXPECT_THROW(parser.parse(2, arguments), ToolError);
  }
}

TEST(OptionParser, MissingFileNamesAreNamed)
{
  Values values;
  try {
    parse(values, {"a.pcd"});
    FAIL() << "one file name is not enough";
  } catch (const ToolError& error) {
    EXPECT_NE(std::string(error.what()).find("'output.pcd'"), std::string::npos);
  }
}

TEST(OptionParser, TakesTheRestAsAList)
{
  std::string first;
  std::vector<std::string> rest;
  OptionParser parser("pcl_example", "Does something.");
  parser.positional("first", first, "the first")
      .positionals("room.pcd", rest, "rooms", 2);
  const char* const arguments[] = {"pcl_example", "a", "b", "c", "d"};
  ASSERT_TRUE(parser.parse(5, arguments));
  EXPECT_EQ(first, "a");
  EXPECT_EQ(rest, (std::vector<std::string>{"b", "c", "d"}));
  EXPECT_THROW(parser.parse(3, arguments), ToolError);
}

TEST(OptionParser, TheRestMayStandBeforeOtherNames)
{
  std::vector<std::string> rest;
  std::string last;
  OptionParser parser("pcl_example", "Does something.");
  parser.positionals("scan", rest, "scans").positional("folder", last, "the last");
  const char* const arguments[] = {"pcl_example", "a", "b", "c"};
  ASSERT_TRUE(parser.parse(4, arguments));
  EXPECT_EQ(rest, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(last, "c");
  ASSERT_TRUE(parser.parse(3, arguments));
  EXPECT_EQ(rest, std::vector<std::string>{"a"});
  EXPECT_EQ(last, "b");
  const auto missing = [&](int count) {
    try {
      parser.parse(count, arguments);
    } catch (const ToolError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(missing(2).find("The argument 'folder'"), 0u) << missing(2);
  EXPECT_EQ(missing(1).find("The argument 'scan'"), 0u) << missing(1);
  EXPECT_NE(parser.usage().find("pcl_example scan ... folder <options>"),
            std::string::npos);
}

TEST(OptionParser, TheLastNameMayBeMissingIfAFlagSaysSo)
{
  std::vector<std::string> rest;
  std::string last;
  bool looks_only = false;
  const auto parse = [&](std::vector<const char*> arguments) {
    rest.clear();
    last.clear();
    looks_only = false;
    OptionParser parser("tool", "");
    parser.positionals("scan", rest, "scans").positional("folder", last, "the last");
    parser.flag("-check", looks_only, "no more than a look");
    parser.lastMayBeMissing(looks_only);
    arguments.insert(arguments.begin(), "tool");
    return parser.parse(static_cast<int>(arguments.size()), arguments.data());
  };
  EXPECT_THROW(parse({"a"}), ToolError);
  EXPECT_THROW(parse({"-check"}), ToolError);
  EXPECT_TRUE(parse({"a", "-check"}));
  EXPECT_EQ(rest, (std::vector<std::string>{"a"}));
  EXPECT_EQ(last, "");
  EXPECT_TRUE(parse({"-check", "a", "b"}));
  EXPECT_EQ(rest, (std::vector<std::string>{"a"}));
  EXPECT_EQ(last, "b");
}

TEST(OptionParser, HelpNamesEverythingWithItsDefault)
{
  Values values;
  values.size = 0.35;
  EXPECT_FALSE(parse(values, {"-size", "abc", "-h"}));
  const auto usage = makeParser(values).usage();
  for (const char* part : {"Syntax is: pcl_example input output.pcd <options>",
                           "-size X = size of it, m, greater than 0 (default: 0.35)",
                           "-partition graph|lccp|-x = way to do it (default: graph)",
                           "-fast = do it fast\n",
                           "-quiet",
                           "-h ="})
    EXPECT_NE(usage.find(part), std::string::npos) << part << "\n" << usage;
}

TEST(OptionParser, RunTurnsErrorsIntoAnExitStatusAndOneLine)
{
  const auto run = [](const std::function<void(Progress&)>& body) {
    Values values;
    const char* const arguments[] = {"pcl_example", "a", "b"};
    testing::internal::CaptureStderr();
    const int status = makeParser(values).run(3, arguments, body);
    return std::make_pair(status, testing::internal::GetCapturedStderr());
  };
  const auto good = run([](Progress&) {});
  EXPECT_EQ(good.first, EXIT_SUCCESS);
  EXPECT_EQ(good.second, "");
  const auto bad = run([](Progress&) { throw ToolError("a.pcd: too\nbad"); });
  EXPECT_EQ(bad.first, EXIT_FAILURE);
  EXPECT_NE(bad.second.find("[pcl_example] a.pcd: too bad\n"), std::string::npos);
}

TEST(ProblemOf, IsTheFirstErrorOfAClassWithoutItsName)
{
  testing::internal::CaptureStderr();
  EXPECT_EQ(problemOf([] {}), "");
  EXPECT_EQ(problemOf([] { PCL_WARN("[pcl::Class::function] A warning.\n"); }), "");
  EXPECT_EQ(problemOf([] {
              PCL_ERROR("[pcl::Class::function] It is %g m.\n", 0.5);
              PCL_ERROR("[pcl::Class::other] Another.\n");
            }),
            "It is 0.5 m.");
  EXPECT_EQ(problemOf([] { PCL_ERROR("No place."); }), "No place.");
  EXPECT_THROW(problemOf([] { throw std::bad_alloc(); }), std::bad_alloc);
  std::fputs("after", stderr); // is there again
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "after");
}

TEST(ProblemOf, IsThatOfItsOwnThread)
{
  testing::internal::CaptureStderr();
  const auto level = pcl::console::getVerbosityLevel();
  std::vector<std::string> wrong(8);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < wrong.size(); ++t)
    threads.emplace_back([&wrong, t] {
      const auto own = "error of thread " + std::to_string(t);
      for (int i = 0; i < 500; ++i) {
        const auto said = problemOf([&own] {
          std::this_thread::yield();
          PCL_ERROR("[pcl::Class::function] %s\n", own.c_str());
        });
        if (said != own)
          wrong[t] = "'" + said + "'";
      }
    });
  for (auto& thread : threads)
    thread.join();
  for (const auto& text : wrong)
    EXPECT_EQ(text, "");
  EXPECT_EQ(pcl::console::getVerbosityLevel(), level);
  std::fputs("after", stderr);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "after");
}

TEST(OptionParser, AChoiceMayBeginWithADash)
{
  Values values;
  ASSERT_TRUE(parse(values, {"a.pcd", "b.pcd", "-partition", "-x", "-fast"}));
  EXPECT_EQ(values.partition, "-x");
  EXPECT_TRUE(values.fast);
  EXPECT_EQ(errorOf({"-partition", "-fast"}), "-partition: the value is missing");
}

TEST(OptionParser, SuggestsTheRightSpelling)
{
  EXPECT_EQ(errorOf({"--size", "1"}), "--size: unknown option, write -size");
  EXPECT_EQ(errorOf({"-size=0.1"}), "-size=0.1: unknown option, write -size 0.1");
  EXPECT_EQ(errorOf({"--size=0.1"}), "--size=0.1: unknown option, write -size 0.1");
  EXPECT_EQ(errorOf({"-partitoin", "lccp"}),
            "-partitoin: unknown option, did you mean -partition?");
  EXPECT_EQ(errorOf({"-nothing_like_it"}),
            "-nothing_like_it: unknown option, -h lists the known ones");
  EXPECT_EQ(errorOf({"--"}), "--: unknown option, -h lists the known ones");
}

TEST(OptionParser, HelpListsExpertOptionsApart)
{
  Values values;
  auto parser = makeParser(values);
  EXPECT_EQ(parser.usage().find("experts"), std::string::npos);
  const auto usage = parser.expert({"-share"}).usage();
  const auto experts = usage.find("experts");
  EXPECT_LT(experts, usage.find("-share X"));
  EXPECT_GT(experts, usage.find("-seed X"));
  EXPECT_GT(experts, usage.find("-h ="));
}

TEST(OptionParser, SaysItsVersionWithoutAnyArgument)
{
  Values values;
  const char* const arguments[] = {"pcl_example", "--version"};
  testing::internal::CaptureStdout();
  const auto body = [](Progress&) { FAIL() << "nothing is to be done"; };
  EXPECT_EQ(makeParser(values).run(2, arguments, body), EXIT_SUCCESS);
  EXPECT_EQ(testing::internal::GetCapturedStdout().rfind("pcl_example 0.", 0), 0u);
}

TEST(OptionParser, ValuesLeaveOutTheThreads)
{
  int threads = 3;
  double size = 0.5;
  OptionParser parser("pcl_example", "Does something.");
  parser.number("-threads", threads, "threads").number("-size", size, "size", "m");
  EXPECT_EQ(parser.values(), "-size 0.5 m");
}

TEST(OptionParser, ErrorsHoldNothingThatATerminalActsOn)
{
  Values values;
  const char* const arguments[] = {"pcl_example", "a", "b"};
  testing::internal::CaptureStderr();
  makeParser(values).run(3, arguments, [](Progress&) {
    throw ToolError("a.pcd: '\x1b[2J' is not a number");
  });
  const auto said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("'\\x1b[2J' is not"), std::string::npos) << said;
}

TEST(Progress, SummaryIsShownWhereNoTerminalIs)
{
  testing::internal::CaptureStdout();
  Progress progress(false);
  progress.start("Loading");
  progress.done("2 points");
  progress.summary("out.pcd: 2 rooms");
  Progress(true).summary("not after -quiet");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "out.pcd: 2 rooms\n");
}
