/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "objects/graph/segment_members.h"
#include "objects/structure/object_scene.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <cassert>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace pcl::indoor {

/** Cut a segment, and its parts, as long as cut_once returns more than one part. */
template <typename CutOnce>
std::vector<SegmentMembers>
cutRepeatedly(const SegmentMembers& members, const CutOnce& cut_once)
{
  std::vector<SegmentMembers> open(1, members), parts;
  while (!open.empty()) {
    const auto whole = std::move(open.back());
    open.pop_back();
    auto cut = cut_once(whole);
    auto& target = cut.size() == 1 ? parts : open;
    std::move(cut.begin(), cut.end(), std::back_inserter(target));
  }
  return parts;
}

/** Cut each segment, and its parts, as long as cut_once returns more than one part of
 * some members; the first part keeps the segment's number, the others follow those that
 * were there. Points that are left out keep their segment.
 */
template <typename CutOnce>
void
partSegments(const ObjectScene& scene,
             const std::vector<std::uint8_t>& left_out,
             const CutOnce& cut_once,
             std::vector<std::uint32_t>& segment_of_point)
{
  assert(isConsistent(scene, segment_of_point.size()));
  assert(isConsistent(scene, left_out.size()));
  if (scene.points.empty())
    return;
  const auto segments = membersOfSegments(left_out, segment_of_point);
  auto next = static_cast<std::uint32_t>(segments.size());
  std::vector<std::vector<SegmentMembers>> parts(segments.size());
  const auto count = static_cast<std::ptrdiff_t>(segments.size());
  const auto threads = threadCount(static_cast<int>(scene.threads));
  parallelFor(count, threads, 1, [&](std::ptrdiff_t s) {
    parts[s] = cutRepeatedly(segments[s], cut_once);
  });
  for (const auto& cut : parts)
    for (std::size_t part = 1; part < cut.size(); ++part, ++next)
      for (const auto i : cut[part])
        segment_of_point[i] = next;
}

} // namespace pcl::indoor
