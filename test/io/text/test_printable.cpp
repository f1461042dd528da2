/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "text/printable.h"

#include "formats/table/table_words.h" // for readNumber

#include <pcl/exceptions.h>

#include <gtest/gtest.h>

#include <clocale>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

using namespace pcl::indoor::tool;

TEST(Printable, LeavesTextAsItIs)
{
  EXPECT_EQ(printable("scan.pcd: 'abc' is not a number"),
            "scan.pcd: 'abc' is not a number");
  EXPECT_EQ(printable("B\xc3\xbcro/\xe9\x83\xa8\xe5\xb1\x8b \xf0\x9f\x8f\xa0.pcd"),
            "B\xc3\xbcro/\xe9\x83\xa8\xe5\xb1\x8b \xf0\x9f\x8f\xa0.pcd");
  EXPECT_EQ(printable(""), "");
}

TEST(Printable, GivesOneLineThatATerminalDoesNotActOn)
{
  EXPECT_EQ(printable("one\ntwo\tthree"), "one two three");
  EXPECT_EQ(printable("\x1b[31mred\x07"), "\\x1b[31mred\\x07");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\x7f\xc2\x9b"),
            "\\x7f\\xc2\\x9b"); // delete; a control of 8 bits
  EXPECT_EQ(printable("\xe2\x80\xae"
                      "dcp"),
            "\\xe2\\x80\\xaedcp"); // right to left
}

TEST(Printable, ShowsBytesThatAreNoText)
{
  EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
  EXPECT_EQ(printable("\xc3"), "\\xc3");                   // cut
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");          // longer than needed
  EXPECT_EQ(printable("\xe0\x80\x80"), "\\xe0\\x80\\x80"); // the same
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80"); // half of a pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80"); // beyond the last
}

TEST(Printable, LeavesOutTheMiddleOfALongText)
{
  const std::string text(5000, 'x');
  EXPECT_EQ(printable("first" + text + "last", 20), "firstxxxxx ... xxxxxxlast");
}

TEST(Numbers, HaveAPointInEveryLocale)
{
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  const char* const names[] = {"C", "de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"};
  for (const char* name : names) {
    if (std::setlocale(LC_NUMERIC, name) == nullptr) // not on this machine
      continue;
    EXPECT_EQ(fixedText(-1234.5678, 2), "-1234.57") << name;
    EXPECT_EQ(fixedText(0.0, 1), "0.0") << name;
    EXPECT_EQ(shortText(0.01999, 2), "0.02") << name;
    EXPECT_EQ(shortText(1e-5, 2), "1e-05") << name;
    EXPECT_EQ(shortText(691234.5, 10), "691234.5") << name;
    double value = 1.0;
    EXPECT_TRUE(readNumber("-1.5e400", value)) << name;
    EXPECT_EQ(value, -std::numeric_limits<double>::infinity()) << name;
    EXPECT_TRUE(readNumber("1.5e-400", value)) << name;
    EXPECT_EQ(value, 0.0) << name;
  }
  std::setlocale(LC_NUMERIC, before.c_str());
}

TEST(MessageOf, IsInTheUsersWords)
{
  try {
    PCL_THROW_EXCEPTION(pcl::BadArgumentException, "Cells of : 3 m are too small.");
  } catch (const std::exception& error) {
    EXPECT_EQ(messageOf(error), "Cells of : 3 m are too small.");
  }
  EXPECT_EQ(messageOf(pcl::IOException("is: damaged")), "is: damaged");
  EXPECT_EQ(messageOf(std::bad_alloc()), "There is not enough memory.");
  EXPECT_EQ(messageOf(std::length_error("vector::_M_default_append")),
            "There is not enough memory.");
  EXPECT_EQ(
      messageOf(std::runtime_error("[json.exception.parse_error.101] parse error")),
      "parse error");
  EXPECT_EQ(messageOf(std::runtime_error("plain")), "plain");
}
