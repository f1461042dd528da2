/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/e57/e57_pages.h"
#include "formats/e57/e57_scans.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Where the values of a scan's points are stored.
 *
 * The values of a field follow each other in a stream of bits, the first one in the
 * lowest bits; packets hold pieces of all streams (ASTM E2807, section 9).
 */
class E57Packets {
public:
  /** Takes the next bytes of the stream of a field. */
  using Visit = std::function<void(std::size_t field, const char* bytes, std::size_t)>;

  /** \brief Go through all packets.
   * \param[in,out] pages must outlive this
   * \param[in] scan must outlive this
   * \throws ToolError if packets are damaged, or hold fewer values than are promised
   */
  E57Packets(E57Pages& pages, const E57Scan& scan, const Visit& visit);

  /** \brief Values of some fields as they are stored.
   * \param[in] fields numbers of those that are wanted
   * \return bytes of each of these fields; the first value begins within the first
   * byte, at the bit first * bits % 8; behind the last one are 8 bytes more
   */
  std::vector<std::string>
  read(std::uint64_t first, std::size_t count, const std::vector<std::size_t>& fields);

  /** \brief Bytes of the file that the packets are. */
  std::uint64_t
  size() const
  {
    return size_;
  }

private:
  /** A place between packets. */
  struct Mark {
    std::uint64_t place = 0;
    std::vector<std::uint64_t> bytes; ///< of each stream that lie before
  };

  /** Bytes of the stream of a field that are wanted. */
  struct Wanted {
    std::size_t field = 0;
    std::uint64_t begin = 0, end = 0;
    std::size_t mark = 0; ///< last one before them
    std::string* bytes = nullptr;
  };

  /** The header of a packet. */
  struct Packet {
    std::size_t size = 0;
    std::vector<std::size_t> lengths; ///< of its pieces; none if it has no data
  };

  void
  openSection();

  Packet
  packetAt(std::uint64_t place);

  /** \return false if all streams have all values */
  bool
  needsMore(const Mark& mark) const;

  void
  requireAllValues(const Mark& end) const;

  Wanted
  wantedOf(std::size_t field, std::uint64_t first, std::size_t count) const;

  void
  gather(const std::vector<Wanted>& wanted, Mark mark);

  [[noreturn]] void
  refuse(const std::string& problem) const;

  E57Pages& pages_;
  const E57Scan& scan_;
  std::uint64_t end_ = 0; ///< logical place behind the last packet
  std::uint64_t size_ = 0;
  std::vector<Mark> marks_;
};

} // namespace pcl::indoor::tool
