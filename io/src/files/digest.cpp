/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/digest.h"

#include "files/tool_error.h"

#include <cstring>
#include <fstream>

namespace pcl::indoor::tool {
namespace {

/** Multiplication carries each bit upwards, the shift brings them down again. */
std::uint64_t
mixed(std::uint64_t state, std::uint64_t word)
{
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15u;
  state = (state ^ word) * odd;
  return state ^ state >> 32;
}

} // namespace

std::uint64_t
digestOf(const void* bytes, std::size_t size, std::uint64_t seed)
{
  const auto* next = static_cast<const char*>(bytes);
  std::uint64_t state = mixed(seed, size);
  std::uint64_t word = 0;
  for (std::size_t left = size; left > 0;) {
    const std::size_t part = left < sizeof(word) ? left : sizeof(word);
    word = 0;
    std::memcpy(&word, next, part);
    state = mixed(state, word);
    next += part;
    left -= part;
  }
  return mixed(state, ~size);
}

std::uint64_t
digestOf(const std::string& text, std::uint64_t seed)
{
  return digestOf(text.data(), text.size(), seed);
}

std::uint64_t
digestOfFile(const std::string& path, std::size_t block_size)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw ToolError(path + ": the file cannot be read");
  std::string block(block_size, '\0');
  std::uint64_t digest = 0;
  do {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    digest = digestOf(block.data(), static_cast<std::size_t>(stream.gcount()), digest);
  } while (stream);
  if (stream.bad())
    throw ToolError(path + ": the file cannot be read");
  return digest;
}

} // namespace pcl::indoor::tool
