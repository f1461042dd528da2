/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "plan/json_reader.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

void
JsonReader::requireKeys(std::initializer_list<const char*> known) const
{
  if (!value_.is_object())
    fail("must be an object, not " + std::string(value_.type_name()));
  for (const auto& item : value_.items())
    if (std::none_of(
            known.begin(), known.end(), [&](const char* k) { return item.key() == k; }))
      fail("has an unknown key '" + item.key() + "'");
}

JsonReader
JsonReader::at(const std::string& key) const
{
  if (!has(key))
    fail("lacks the key '" + key + "'");
  return {value_.at(key), source_, path_.empty() ? key : path_ + "." + key};
}

std::vector<JsonReader>
JsonReader::list(const std::string& key) const
{
  return has(key) ? at(key).values() : std::vector<JsonReader>();
}

std::vector<JsonReader>
JsonReader::values() const
{
  if (!value_.is_array())
    fail("must be a list, not " + std::string(value_.type_name()));
  std::vector<JsonReader> elements;
  for (std::size_t i = 0; i < value_.size(); ++i)
    elements.push_back({value_[i], source_, path_ + "[" + std::to_string(i) + "]"});
  return elements;
}

double
JsonReader::number() const
{
  constexpr double largest = 1e3; // metres or degrees: a float resolves 0.06 mm there
  if (!value_.is_number())
    fail("must be a number, not " + value_.dump());
  const double number = value_.get<double>();
  if (!(std::abs(number) <= largest))
    fail("must lie within -1000 and 1000, not " + value_.dump());
  return number;
}

double
JsonReader::positive() const
{
  const double result = number();
  if (!(result > 0))
    fail("must be positive, not " + value_.dump());
  return result;
}

std::uint32_t
JsonReader::seed() const
{
  if (!value_.is_number_unsigned() || value_.get<std::uint64_t>() > 0xFFFFFFFFu)
    fail("must be a whole number from 0 to 4294967295, not " + value_.dump());
  return value_.get<std::uint32_t>();
}

std::string
JsonReader::text() const
{
  if (!value_.is_string())
    fail("must be a text, not " + value_.dump());
  return value_.get<std::string>();
}

} // namespace pcl::indoor
