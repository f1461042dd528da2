/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/laz/arithmetic_decoder.h"
#include "formats/laz/laz_layout.h"

#include <memory>

namespace pcl::indoor::tool {

/** \brief Decodes an item of points that are compressed one after the other. */
class PointItem {
public:
  virtual ~PointItem() = default;

  /** \brief Decode the item of the next point.
   * \param[out] item bytes of the item */
  virtual void
  next(ArithmeticDecoder& decoder, char* item) = 0;
};

/** \brief The decoder of an item.
 * \param[in] first the item of the first point of the chunk, not compressed
 * \return null if there is no such item or version */
std::unique_ptr<PointItem>
makePointItem(const LazItem& item, const char* first);

} // namespace pcl::indoor::tool
