/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/laz/arithmetic_decoder.h"
#include "formats/laz/laz_layout.h"

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Decodes an item of points whose parts are compressed in layers. */
class LayeredItem {
public:
  virtual ~LayeredItem() = default;

  /** \brief Decode the item of the next point.
   * \param[in,out] channel of the scanner, told by the first item for all others
   * \param[out] item bytes of the item */
  virtual void
  next(unsigned& channel, char* item) = 0;

  /** \brief Were all bytes needed? */
  virtual bool
  isAtEnd() const = 0;
};

/** \brief A layer; none if it has no bytes, as what it tells of does not change. */
using Layer = std::optional<ArithmeticDecoder>;

/** \brief How many layers an item has; 0 if it or its version is not known. */
std::size_t
layerCount(const LazItem& item);

/** \brief The decoder of an item that has layers.
 * \param[in] first the item of the first point of the chunk, not compressed
 * \param[in] channel of the scanner that measured that point
 * \param[in] layers of the item, in their order
 */
std::unique_ptr<LayeredItem>
makeLayeredItem(const LazItem& item,
                const char* first,
                unsigned channel,
                std::vector<Layer> layers);

/** \brief The channel of a point, the first item of layered ones. */
inline unsigned
scannerChannel(const char* point)
{
  constexpr std::size_t flags_at = 15;
  return static_cast<unsigned char>(point[flags_at]) >> 4 & 3;
}

} // namespace pcl::indoor::tool
