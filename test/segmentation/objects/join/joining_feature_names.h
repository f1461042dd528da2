/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/join/object_joining.h"

#include <array>

namespace pcl::indoor {
namespace test {

/** What each of the features of a pair is. */
inline const std::array<const char*, std::tuple_size<JoiningFeatures>::value>&
joiningFeatureNames()
{
  static const std::array<const char*, std::tuple_size<JoiningFeatures>::value> names =
      {{"log area, a",
        "height, a",
        "low, a",
        "high, a",
        "thickness, a",
        "middle, a",
        "length, a",
        "level, a",
        "one-sided, a",
        "second direction, a",
        "main direction, a",
        "log outline, a",
        "log volume, a",
        "log area, b",
        "height, b",
        "low, b",
        "high, b",
        "thickness, b",
        "middle, b",
        "length, b",
        "level, b",
        "one-sided, b",
        "second direction, b",
        "main direction, b",
        "log outline, b",
        "log volume, b",
        "touching share, a",
        "touching length, a",
        "share of touching, a",
        "height of contact, a",
        "touching share, b",
        "touching length, b",
        "share of touching, b",
        "height of contact, b",
        "length of contact",
        "width of contact",
        "uprightness of contact",
        "bend",
        "deviation of bend",
        "log bends",
        "concave share",
        "b over the plane of a",
        "a over the plane of b",
        "thickness of both",
        "middle of both",
        "cosine of normals",
        "air over smaller",
        "air over hull",
        "air of boxes",
        "log hull",
        "surface over hull",
        "box of a within b",
        "outline of smaller within",
        "outline in common",
        "log outline of both",
        "heights in common",
        "low, b - a",
        "high, b - a",
        "gap",
        "log near cells",
        "near in line",
        "log parts, a",
        "log parts, b",
        "contacts, a",
        "contacts, b",
        "voxel size",
        "off the middle, least",
        "off the middle, most",
        "outline in its rectangle",
        "gap of outlines",
        "open gap",
        "filled gap",
        "floor below, a",
        "floor below, b",
        "likeness of votes",
        "same vote",
        "votes for the building, a",
        "votes for the building, b",
        "most votes for an object, a",
        "most votes for an object, b",
        "distance of middles",
        "distance of middles over their spreads",
        "spread of middles, a",
        "spread of middles, b",
        "middles of a off b",
        "middles of b off a"}};
  return names;
}

/** What each of the features of an object is. */
inline const std::array<const char*, std::tuple_size<ObjectFeatures>::value>&
objectFeatureNames()
{
  static const std::array<const char*, std::tuple_size<ObjectFeatures>::value> names = {
      {"log area",
       "height",
       "low",
       "high",
       "thickness",
       "middle",
       "length",
       "level",
       "one-sided",
       "second direction",
       "main direction",
       "log outline",
       "log volume",
       "surface over hull",
       "outline in its rectangle",
       "floor below",
       "log parts",
       "contacts",
       "touching share",
       "voxel size",
       "probability of its join",
       "least probability within",
       "probability of the next join",
       "log area of what it joins with, over its own",
       "votes for the building",
       "most votes for an object",
       "evenness of votes",
       "spread of middles",
       "spread of middles over size",
       "middles off the object"}};
  return names;
}

} // namespace test
} // namespace pcl::indoor
