/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief CRC-32C (Castagnoli) of some bytes, as RFC 3720, appendix B.4 has it. */
std::uint32_t
crc32c(const char* bytes, std::size_t count);

/** \brief Reads an E57 file without the checksums between its bytes.
 *
 * The file is made of pages of 1024 bytes, the last four of which are the CRC-32C of
 * the others; places in it are physical, which count all bytes, or logical, which count
 * those of the content (ASTM E2807, section 7). The checksum of each page that is read
 * is checked.
 */
class E57Pages {
public:
  static constexpr std::uint64_t page_size = 1024, content_size = 1020;

  /** \throws ToolError if the file cannot be read */
  explicit E57Pages(const std::string& path);

  const std::string&
  path() const
  {
    return path_;
  }

  /** \brief Bytes of content in all whole pages. */
  std::uint64_t
  size() const
  {
    return pages_ * content_size;
  }

  /** \brief The logical place of a physical one.
   * \param[in] what stands there, for the message
   * \throws ToolError if it is behind the end or in a checksum */
  std::uint64_t
  logicalPlace(std::uint64_t physical, const std::string& what) const;

  /** \brief Read bytes from a logical place on.
   * \throws ToolError if they end behind the last page, or if a checksum is wrong */
  void
  read(std::uint64_t place, void* target, std::size_t count);

private:
  void
  load(std::uint64_t page);

  std::string path_;
  std::ifstream stream_;
  std::uint64_t pages_ = 0;
  std::vector<char> loaded_; ///< pages that follow each other
  std::uint64_t first_ = 0;  ///< of them
  std::uint64_t loaded_pages_ = 0;
};

} // namespace pcl::indoor::tool
