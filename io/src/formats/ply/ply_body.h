/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl::indoor::tool {

/** \brief The bytes of a number of a PLY file; \a type is one of PCLPointField. */
std::size_t
plyTypeSize(std::uint8_t type);

/** \brief Takes one value after the other from what follows the header of a PLY file.
 */
class PlyBody {
public:
  enum class Encoding { Ascii, Little, Big };

  /** \param[in] path of the file, for messages */
  PlyBody(std::string bytes, Encoding encoding, std::string path);

  /** \brief Take a value as the bytes of its type.
   * \param[out] out has room for eight bytes
   * \throws ToolError at the end, or if a word is no number or does not fit the type
   */
  void
  read(std::uint8_t type, std::uint8_t* out);

  std::size_t
  left() const
  {
    return bytes_.size() - at_;
  }

  bool
  isAscii() const
  {
    return encoding_ == Encoding::Ascii;
  }

  [[noreturn]] void
  throwEnd() const;

private:
  double
  nextNumber();

  void
  store(double value, std::uint8_t type, std::uint8_t* out) const;

  std::string bytes_;
  Encoding encoding_;
  std::string path_;
  std::size_t at_ = 0;
};

} // namespace pcl::indoor::tool
