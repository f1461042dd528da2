/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <boost/interprocess/sync/file_lock.hpp>

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

namespace pcl::indoor::tool {

/** \brief What a run has finished so far, in files: a run that was ended goes on from
 * there.
 *
 * Each file is written beside its place and renamed, and tells the run that it belongs
 * to and whether it is whole; one that is not counts as missing. Runs are the same if
 * their keys are: that should hold whatever the result depends on.
 */
class PCL_INDOOR_EXPORTS WorkFolder {
public:
  /** \brief Use a folder, which need not exist: the first file makes it. */
  WorkFolder(std::string folder, std::uint64_t key);
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder&
  operator=(const WorkFolder&) = delete;
  ~WorkFolder();

  /** \brief Keep other runs from using the folder until this process ends.
   * \throws ToolError if one uses it */
  void
  lock();

  /** \brief Remove the files of another run, if there are; a warning says so. */
  void
  removeOutdated();

  /** \brief The bytes of a file; nothing if it is missing, damaged, or of another run.
   */
  std::optional<std::string>
  read(const std::string& name) const;

  /** \brief Some bytes of a file that read() has found whole.
   * \throws ToolError if they are not there */
  void
  readPart(const std::string& name,
           std::size_t first,
           void* bytes,
           std::size_t count) const;

  /** \brief Write a file, from any thread.
   * \throws ToolError if it cannot be written */
  void
  write(const std::string& name, const std::string& bytes);

  /** \brief Write a file without what tells whether it is whole and of this run, from
   * any thread.
   * \throws ToolError if it cannot be written */
  void
  writePlain(const std::string& name, const std::string& bytes);

  /** \brief Remove one of the files, if it is there. */
  void
  removeFile(const std::string& name);

  /** \brief Remove all files of runs, and the folder if nothing else is in it. */
  void
  remove();

  std::string
  path(const std::string& name) const
  {
    return folder_ + "/" + name;
  }

  std::uint64_t
  key() const
  {
    return key_;
  }

private:
  void
  put(const std::string& name, const std::string& bytes);

  void
  removeFiles(bool keep_lock);

  std::string folder_;
  std::uint64_t key_;
  bool is_begun_ = false; ///< has the file by which runs are told apart
  bool made_parent_ = false;
  std::optional<boost::interprocess::file_lock> lock_;
  std::mutex mutex_; ///< of writing
};

/** \brief The name of the file of a room. */
PCL_INDOOR_EXPORTS std::string
roomFile(std::size_t room);

} // namespace pcl::indoor::tool
