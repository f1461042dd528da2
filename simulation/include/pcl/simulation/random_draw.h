/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace pcl::indoor {

/** \brief Random numbers that are the same with every standard library. */
class RandomDraw {
public:
  explicit RandomDraw(std::uint32_t seed)
  : generator_(seed)
  {}

  /** \brief Uniform in [0, 1). */
  double
  uniform()
  {
    return generator_() * (1.0 / 4294967296.0);
  }

  /** \brief Uniform in [low, high). */
  double
  uniform(double low, double high)
  {
    return low + (high - low) * uniform();
  }

  /** \brief Normal with mean 0 and standard deviation 1 (Box and Muller). */
  double
  gaussian()
  {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(6.283185307179586 * uniform());
  }

  /** \brief One of 0 ... count - 1. */
  int
  pick(int count)
  {
    return static_cast<int>(generator_() % static_cast<std::uint32_t>(count));
  }

private:
  std::mt19937 generator_;
};

/** \brief A seed for the i-th of many independent draws (finaliser of MurmurHash3). */
inline std::uint32_t
mixSeed(std::uint32_t seed, std::uint32_t i)
{
  std::uint32_t h = seed * 0x9E3779B9u + i + 1u;
  h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
  h = (h ^ (h >> 13)) * 0xC2B2AE35u;
  return h ^ (h >> 16);
}

} // namespace pcl::indoor
