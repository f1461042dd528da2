/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/step_file.h"

#include "support/comma_locale.h"

#include <gtest/gtest.h>

#include <set>

using namespace pcl::indoor::tool;

TEST(StepFile, TextsAreAscii)
{
  EXPECT_EQ(stepText("it's"), "'it''s'");
  EXPECT_EQ(stepText("a\\b"), "'a\\\\b'");
  EXPECT_EQ(stepText("Gr\xc3\xb6\xc3\x9f"
                     "e"),
            "'Gr\\X2\\00F6\\X0\\\\X2\\00DF\\X0\\e'");
  EXPECT_EQ(stepText("\xf0\x9f\x8f\xa0"), "'\\X4\\0001F3E0\\X0\\'");
  EXPECT_EQ(stepText("\xff-\n-\xc3"), "'?-?-?'");
  EXPECT_EQ(stepText("\xe2z"), "'?z'");           // cut short
  EXPECT_EQ(stepText("\xed\xa0\x80"), "'?\?\?'"); // half of a pair
}

TEST(StepFile, NumbersHaveAPoint)
{
  EXPECT_EQ(stepReal(0.0), "0.");
  EXPECT_EQ(stepReal(-0.000001), "0.");
  EXPECT_EQ(stepReal(2.5), "2.5");
  EXPECT_EQ(stepReal(-100.0), "-100.");
  EXPECT_EQ(stepReal(5334567.12345), "5334567.12345");
}

TEST(StepFile, NumbersHaveAPointWhereTheLocaleHasAComma)
{
  const pcl::indoor::test::CommaLocale locale;
  if (!locale.hasComma())
    GTEST_SKIP() << "no locale with a comma is installed";
  EXPECT_EQ(stepReal(2.5), "2.5");
}

TEST(StepFile, GlobalIdsAreOfTheirName)
{
  std::set<std::string> ids;
  for (int i = 0; i < 10000; ++i) {
    const auto id = stepGlobalId("wall " + std::to_string(i));
    EXPECT_EQ(id.size(), 24u);
    EXPECT_LT(id[1], '4'); // two bits
    ids.insert(id);
  }
  EXPECT_EQ(ids.size(), 10000u);
  EXPECT_EQ(stepGlobalId("wall 1"), stepGlobalId("wall 1"));
}

TEST(StepFile, SharedEntitiesAreWrittenOnce)
{
  StepFile file;
  const auto a = file.share("IFCDIRECTION((1.,0.))");
  const auto b = file.add("IFCDIRECTION((0.,1.))");
  EXPECT_EQ(file.share("IFCDIRECTION((1.,0.))").number, a.number);
  EXPECT_EQ(stepList({a, b, {}}), "(#1,#2,$)");
  EXPECT_EQ(file.text("IFC4", "FILE_NAME('');\n"),
            "ISO-10303-21;\nHEADER;\nFILE_NAME('');\nFILE_SCHEMA(('IFC4'));\nENDSEC;\n"
            "DATA;\n#1=IFCDIRECTION((1.,0.));\n#2=IFCDIRECTION((0.,1.));\nENDSEC;\n"
            "END-ISO-10303-21;\n");
}
