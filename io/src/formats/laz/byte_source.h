/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Thrown where the bytes of a chunk cannot be those of its points. */
class DamagedChunk : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief The bytes of a chunk or a layer, one after the other. */
class ByteSource {
public:
  /** \param[in] bytes must outlive the source */
  explicit ByteSource(std::string_view bytes)
  : at_(reinterpret_cast<const std::uint8_t*>(bytes.data()))
  , end_(at_ + bytes.size())
  {}

  /** \brief A part of a file, of which some ten thousand bytes are in memory. */
  ByteSource(const std::string& path, std::uint64_t begin, std::uint64_t end);

  ByteSource(const ByteSource&) = delete;
  ByteSource&
  operator=(const ByteSource&) = delete;
  ByteSource(ByteSource&&) = default;
  ByteSource&
  operator=(ByteSource&&) = default;

  /** \brief The next bytes as one number, the first ones its greatest.
   * \param[in] count at most 4
   * \throws DamagedChunk if there are fewer */
  std::uint32_t
  next(unsigned count)
  {
    if (end_ - at_ < 4)
      return nextOfFew(count);
    const std::uint64_t four = boost::endian::load_big_u32(at_);
    at_ += count;
    return static_cast<std::uint32_t>(four >> (32 - 8 * count));
  }

  /** \throws DamagedChunk if there are fewer bytes */
  void
  take(char* target, std::size_t count);

  bool
  isAtEnd() const
  {
    return at_ == end_ && left_ == 0;
  }

private:
  /** The same where the buffer ends. */
  std::uint32_t
  nextOfFew(unsigned count);

  void
  refill();

  const std::uint8_t* at_ = nullptr;
  const std::uint8_t* end_ = nullptr;
  std::unique_ptr<std::ifstream> stream_; ///< none: all bytes are in memory
  std::uint64_t left_ = 0; ///< bytes of the stream that are not in the buffer yet
  std::vector<std::uint8_t> buffer_;
};

} // namespace pcl::indoor::tool
