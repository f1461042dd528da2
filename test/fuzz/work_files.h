/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Files that the pipeline goes on from: their format is that of one build, which makes
// the whole ones.
#pragma once

#include "files/digest.h"
#include "rooms/work_folder.h"
#include "support/folder_test.h" // for bytesOf
#include "support/some_records.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace pcl::indoor::fuzz {

constexpr std::uint64_t work_key = 7; ///< of the run that the files belong to

/** \brief Whole files: a room and a scene. */
inline std::vector<std::string>
wholeWorkFiles()
{
  tool::WorkFolder folder("fuzz_work", work_key);
  std::vector<std::string> files;
  for (const auto& bytes :
       {tool::roomBytes(test::someRoom()), tool::sceneBytes(test::someScene())}) {
    folder.write("room_1", bytes);
    files.push_back(test::bytesOf(folder.path("room_1")));
  }
  folder.remove();
  return files;
}

/** \brief What a file of this folder holds.
 * \throws tool::ToolError if it is refused */
inline std::string
workFileBytes(const std::string& name)
{
  const auto bytes = tool::WorkFolder(".", work_key).read(name);
  if (!bytes)
    throw tool::ToolError("it is damaged");
  return *bytes;
}

/** \brief Nothing but a whole file may be taken. */
inline void
readWorkFile(const std::string& name)
{
  static const auto whole = wholeWorkFiles();
  static_cast<void>(workFileBytes(name));
  if (std::find(whole.begin(), whole.end(), test::bytesOf(name)) == whole.end())
    throw std::logic_error("a damaged file was taken");
}

/** \brief A digest that fits, so that what it protects is reached, too. */
inline void
repairWorkFile(std::string& file)
{
  constexpr std::size_t head = 24, digest_at = 16;
  if (file.size() < head)
    return;
  std::memcpy(file.data(), wholeWorkFiles()[0].data(), digest_at);
  const auto digest = tool::digestOf(file.substr(head), work_key);
  std::memcpy(&file[digest_at], &digest, sizeof(digest));
}

/** \brief What was taken must be the same after it was written again. */
inline void
readRecord(const std::string& name)
{
  const auto bytes = workFileBytes(name);
  const auto room = tool::roomOf(bytes);
  const auto scene = tool::sceneOf(bytes);
  if (!room && !scene)
    throw tool::ToolError("it is neither a room nor a scene");
  if ((room && tool::roomBytes(*room) != bytes) ||
      (scene && tool::sceneBytes(*scene) != bytes))
    throw std::logic_error("a record is not what it was written as");
}

} // namespace pcl::indoor::fuzz
