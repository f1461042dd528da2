/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/simulation/plan.h>

#include <nlohmann/json.hpp>

#include <initializer_list>

namespace pcl::indoor {

/** \brief A place in a JSON document that knows its path, for messages that name it. */
class JsonReader {
public:
  using Json = nlohmann::json;

  JsonReader(const Json& value, const std::string& source, const std::string& path = "")
  : value_(value)
  , source_(source)
  , path_(path)
  {}

  [[noreturn]] void
  fail(const std::string& problem) const
  {
    throw PlanError(source_ + ": " + (path_.empty() ? "the plan" : path_) + " " +
                    problem);
  }

  /** \brief Refuse a value that is no object, and keys that nobody reads. */
  void
  requireKeys(std::initializer_list<const char*> known) const;

  bool
  has(const std::string& key) const
  {
    return value_.contains(key);
  }

  bool
  isObject() const
  {
    return value_.is_object();
  }

  bool
  isList() const
  {
    return value_.is_array();
  }

  JsonReader
  at(const std::string& key) const;

  /** \brief The elements of a list under a key; none if the key is absent. */
  std::vector<JsonReader>
  list(const std::string& key) const;

  double
  number() const;
  /** \brief A number greater than zero. */
  double
  positive() const;
  std::uint32_t
  seed() const;
  std::string
  text() const;
  /** \brief A list of two or three numbers. */
  template <int n>
  Eigen::Matrix<double, n, 1>
  vector() const
  {
    const auto elements = values();
    if (elements.size() != n)
      fail("must be " + std::to_string(n) + " numbers, not " + value_.dump());
    Eigen::Matrix<double, n, 1> result;
    for (int i = 0; i < n; ++i)
      result[i] = elements[i].number();
    return result;
  }
  std::vector<JsonReader>
  values() const;

private:
  const Json& value_;
  std::string source_, path_;
};

} // namespace pcl::indoor
