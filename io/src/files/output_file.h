/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Find out, before the long work, that an output cannot be written there.
 *
 * Files and links to files can be replaced, pipes and character devices written to.
 * \throws ToolError naming the reason: no such folder, not writable, or a folder, a
 * socket or a block device is there
 */
PCL_INDOOR_EXPORTS void
requireWritable(const std::string& path);

/** \brief Find out, before the long work, that a folder cannot be used or made for
 * results.
 * \throws ToolError naming it and the reason
 */
PCL_INDOOR_EXPORTS void
requireFolder(const std::string& folder);

/** \brief Make a folder, and those above it, unless it is there.
 * \return was it made? */
PCL_INDOOR_EXPORTS bool
makeFolder(const std::string& folder);

/** \brief An output on its way.
 *
 * A file is written beside its place and renamed by commit(), so that its name never
 * holds a part of it; of a link, the target is replaced. Pipes and character devices
 * get the bytes as they come. What was written beside is removed by the destructor and
 * if a signal (INT, TERM, HUP) ends the program.
 * Every function throws ToolError naming the output and the reason.
 */
class PCL_INDOOR_EXPORTS OutputFile {
public:
  explicit OutputFile(const std::string& path);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile&
  operator=(OutputFile&&) = delete;
  ~OutputFile();

  void
  write(const void* bytes, std::size_t size);

  void
  write(const std::string& text)
  {
    write(text.data(), text.size());
  }

  /** \brief End the writing; a file still has to be put in place. */
  void
  close();

  /** \brief Put a file in place. */
  void
  commit();

private:
  [[noreturn]] void
  fail(int reason) const;

  std::string path_;   ///< as it was given, for messages
  std::string target_; ///< at the end of all links
  std::string part_;   ///< beside the target; empty for pipes and devices
  int descriptor_ = -1;
};

/** \brief Write a whole output. */
PCL_INDOOR_EXPORTS void
saveText(const std::string& path, const std::string& text);

/** \brief Write all of an output but do not put it in place. */
PCL_INDOOR_EXPORTS OutputFile
writtenBeside(const std::string& path, const std::string& text);

/** \brief Remove outdated files, then put the files in place in their order, as one
 * step for signals: these end the program before it or after it.
 *
 * A program that is killed amid it leaves whole files only, but not all of them: name
 * the last of them among the outdated, and wherever it lies, the others belong to it.
 */
PCL_INDOOR_EXPORTS void
commitTogether(std::vector<OutputFile>& files,
               const std::vector<std::string>& outdated = {});

} // namespace pcl::indoor::tool
