/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/simulation/ray_tracer.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pcl::indoor {

namespace {

constexpr int leaf_size = 4;
constexpr int bin_count = 16;
constexpr int most_uneven_levels = 40; // below, ranges are halved: bounds the depth
constexpr float no_hit = std::numeric_limits<float>::infinity();

struct Primitive {
  Eigen::AlignedBox3f box;
  Eigen::Vector3f center;
  int number;
};

float
halfArea(const Eigen::AlignedBox3f& box)
{
  if (box.isEmpty())
    return 0.0f;
  const Eigen::Vector3f d = box.sizes();
  return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
}

// A ray, made ready for testing boxes.
struct BoxRay {
  float origin[3], inverse[3];
  bool backwards[3];
};

BoxRay
makeBoxRay(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction)
{
  constexpr float tiny = 1e-20f; // in place of 0, whose inverse would give NaN
  BoxRay ray;
  for (int axis = 0; axis < 3; ++axis) {
    const float d = direction[axis];
    ray.origin[axis] = origin[axis];
    ray.inverse[axis] = 1.0f / (std::abs(d) > tiny ? d : std::copysign(tiny, d));
    ray.backwards[axis] = std::signbit(d);
  }
  return ray;
}

// Cut the ray's intervals [entry, exit] down to what lies in each of the boxes.
template <int width>
void
clip(const BoxRay& ray,
     const float (&lower)[3][width],
     const float (&upper)[3][width],
     float (&entry)[width],
     float (&exit)[width])
{
  for (int axis = 0; axis < 3; ++axis) {
    const float* near = ray.backwards[axis] ? upper[axis] : lower[axis];
    const float* far = ray.backwards[axis] ? lower[axis] : upper[axis];
    for (int i = 0; i < width; ++i) {
      const float t_near = (near[i] - ray.origin[axis]) * ray.inverse[axis];
      const float t_far = (far[i] - ray.origin[axis]) * ray.inverse[axis];
      entry[i] = t_near > entry[i] ? t_near : entry[i];
      exit[i] = t_far < exit[i] ? t_far : exit[i];
    }
  }
}

float
dot(const float* a, const float* b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::array<float, 3>
cross(const float* a, const float* b)
{
  return {
      a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A little beyond the edge still counts, so that no ray slips between two triangles.
float
intersectPacked(const float* origin,
                const float* direction,
                const float* corner,
                const float* edge_b,
                const float* edge_c)
{
  constexpr float beyond = 1e-6f;
  const auto p = cross(direction, edge_c);
  const float determinant = dot(edge_b, p.data());
  if (determinant == 0.0f)
    return no_hit;
  const float inverse = 1.0f / determinant;
  const float s[3] = {
      origin[0] - corner[0], origin[1] - corner[1], origin[2] - corner[2]};
  const float u = dot(s, p.data()) * inverse;
  if (!(u >= -beyond && u <= 1.0f + beyond))
    return no_hit;
  const auto q = cross(s, edge_b);
  const float v = dot(direction, q.data()) * inverse;
  if (!(v >= -beyond && u + v <= 1.0f + beyond))
    return no_hit;
  return dot(edge_c, q.data()) * inverse;
}

// Split [begin, end) where the surface area heuristic is lowest, at least in the
// middle.
std::size_t
split(std::vector<Primitive>& primitives,
      std::size_t begin,
      std::size_t end,
      bool in_the_middle)
{
  if (in_the_middle)
    return begin + (end - begin) / 2;
  Eigen::AlignedBox3f centers;
  for (auto i = begin; i < end; ++i)
    centers.extend(primitives[i].center);
  float best_cost = no_hit;
  int best_axis = -1, best_bin = 0;
  const auto binOf = [&](const Primitive& p, int axis) {
    const float extent = centers.sizes()[axis];
    const float t = (p.center[axis] - centers.min()[axis]) / extent;
    return std::min(bin_count - 1, static_cast<int>(t * bin_count));
  };
  for (int axis = 0; axis < 3; ++axis) {
    if (!(centers.sizes()[axis] > 0.0f))
      continue;
    std::array<Eigen::AlignedBox3f, bin_count> boxes;
    std::array<int, bin_count> counts{};
    for (auto i = begin; i < end; ++i) {
      const int bin = binOf(primitives[i], axis);
      boxes[bin].extend(primitives[i].box);
      ++counts[bin];
    }
    std::array<float, bin_count> right_cost{};
    Eigen::AlignedBox3f side;
    int count = 0;
    for (int bin = bin_count - 1; bin > 0; --bin) {
      side.extend(boxes[bin]);
      count += counts[bin];
      right_cost[bin] = halfArea(side) * static_cast<float>(count);
    }
    side.setEmpty();
    count = 0;
    for (int bin = 1; bin < bin_count; ++bin) {
      side.extend(boxes[bin - 1]);
      count += counts[bin - 1];
      const float cost = halfArea(side) * static_cast<float>(count) + right_cost[bin];
      if (count > 0 && static_cast<std::size_t>(count) < end - begin &&
          cost < best_cost) {
        best_cost = cost;
        best_axis = axis;
        best_bin = bin;
      }
    }
  }
  if (best_axis < 0)
    return begin + (end - begin) / 2;
  const auto first = primitives.begin();
  const auto middle = std::stable_partition(
      first + static_cast<std::ptrdiff_t>(begin),
      first + static_cast<std::ptrdiff_t>(end),
      [&](const Primitive& p) { return binOf(p, best_axis) < best_bin; });
  return static_cast<std::size_t>(middle - first);
}

Eigen::AlignedBox3f
boxOf(const std::vector<Primitive>& primitives, std::size_t begin, std::size_t end)
{
  Eigen::AlignedBox3f box;
  for (auto i = begin; i < end; ++i)
    box.extend(primitives[i].box);
  return box;
}

} // namespace

struct RayTracer::Builder {
  using Range = std::pair<std::size_t, std::size_t>;

  // Split the range into at most four, always the one with the largest surface.
  static std::vector<Range>
  children(std::vector<Primitive>& primitives, Range range, int level)
  {
    std::vector<Range> ranges{range};
    while (ranges.size() < width) {
      int widest = -1;
      float largest = -1.0f;
      for (std::size_t i = 0; i < ranges.size(); ++i) {
        const float area =
            halfArea(boxOf(primitives, ranges[i].first, ranges[i].second));
        if (ranges[i].second - ranges[i].first > leaf_size && area > largest) {
          largest = area;
          widest = static_cast<int>(i);
        }
      }
      if (widest < 0)
        break;
      const Range old = ranges[widest];
      const std::size_t middle =
          split(primitives, old.first, old.second, level > most_uneven_levels);
      ranges[widest].second = middle;
      ranges.emplace_back(middle, old.second);
    }
    return ranges;
  }

  static Node
  emptyNode()
  {
    Node node;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < width; ++i) {
        node.lower[axis][i] = no_hit;
        node.upper[axis][i] = -no_hit;
      }
    std::fill(node.child, node.child + width, 0);
    std::fill(node.count, node.count + width, 0);
    return node;
  }
};

RayTracer::RayTracer(const std::vector<Triangle>& triangles)
{
  std::vector<Primitive> primitives;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    Primitive p{Eigen::AlignedBox3f(t.a), Eigen::Vector3f::Zero(), static_cast<int>(i)};
    p.box.extend(t.b).extend(t.c);
    p.center = p.box.center();
    // Rounding in the box test must not lose a hit.
    const float margin =
        1e-5f +
        4e-7f * p.box.min().cwiseAbs().cwiseMax(p.box.max().cwiseAbs()).maxCoeff();
    p.box.min().array() -= margin;
    p.box.max().array() += margin;
    primitives.push_back(p);
  }
  struct Task {
    int node, level;
    Builder::Range range;
  };
  std::vector<Task> open; // nodes to fill, with their triangles
  if (!primitives.empty()) {
    nodes_.push_back(Builder::emptyNode());
    open.push_back({0, 0, {0, primitives.size()}});
  }
  while (!open.empty()) {
    const auto [number, level, range] = open.back();
    open.pop_back();
    int slot = 0;
    for (const auto& child : Builder::children(primitives, range, level)) {
      const auto box = boxOf(primitives, child.first, child.second);
      for (int axis = 0; axis < 3; ++axis) {
        nodes_[number].lower[axis][slot] = box.min()[axis];
        nodes_[number].upper[axis][slot] = box.max()[axis];
      }
      const bool leaf = child.second - child.first <= leaf_size;
      nodes_[number].count[slot] =
          leaf ? static_cast<int>(child.second - child.first) : 0;
      nodes_[number].child[slot] = static_cast<int>(leaf ? child.first : nodes_.size());
      ++slot;
      if (!leaf) {
        open.push_back({static_cast<int>(nodes_.size()), level + 1, child});
        nodes_.push_back(Builder::emptyNode());
      }
    }
  }
  for (const auto& primitive : primitives) {
    const auto& t = triangles[primitive.number];
    PackedTriangle packed;
    for (int k = 0; k < 3; ++k) {
      packed.corner[k] = t.a[k];
      packed.edge_b[k] = t.b[k] - t.a[k];
      packed.edge_c[k] = t.c[k] - t.a[k];
    }
    packed.number = primitive.number;
    triangles_.push_back(packed);
  }
}

RayHit
RayTracer::trace(const Eigen::Vector3f& origin,
                 const Eigen::Vector3f& direction,
                 float min_distance,
                 float max_distance) const
{
  struct Visit {
    float entry;
    std::int32_t child, count;
  };
  RayHit hit;
  hit.distance = max_distance;
  if (nodes_.empty())
    return RayHit();
  const BoxRay ray = makeBoxRay(origin, direction);
  Visit stack[256]; // at most three wait per level of a tree
  int waiting = 0;
  stack[waiting++] = {min_distance, 0, 0};
  while (waiting > 0) {
    const Visit visit = stack[--waiting];
    if (visit.entry > hit.distance)
      continue;
    for (int i = visit.child; i < visit.child + visit.count; ++i) {
      const auto& t = triangles_[i];
      const float distance = intersectPacked(
          origin.data(), direction.data(), t.corner, t.edge_b, t.edge_c);
      const bool tie = distance == hit.distance && t.number < hit.triangle;
      if (distance >= min_distance && (distance < hit.distance || tie)) {
        hit.distance = distance;
        hit.triangle = t.number;
      }
    }
    if (visit.count > 0)
      continue;
    const Node& node = nodes_[visit.child];
    float entry[width], exit[width];
    for (int i = 0; i < width; ++i) {
      entry[i] = min_distance;
      exit[i] = hit.distance;
    }
    clip(ray, node.lower, node.upper, entry, exit);
    const int first = waiting;
    for (int i = 0; i < width; ++i) {
      if (!(entry[i] <= exit[i]))
        continue;
      int place = waiting++; // farthest first, so that the nearest is popped first
      for (; place > first && stack[place - 1].entry < entry[i]; --place)
        stack[place] = stack[place - 1];
      stack[place] = {entry[i], node.child[i], node.count[i]};
    }
  }
  return hit.triangle < 0 ? RayHit() : hit;
}

float
intersect(const Eigen::Vector3f& origin,
          const Eigen::Vector3f& direction,
          const Triangle& triangle)
{
  const Eigen::Vector3f edge_b = triangle.b - triangle.a;
  const Eigen::Vector3f edge_c = triangle.c - triangle.a;
  const float distance = intersectPacked(
      origin.data(), direction.data(), triangle.a.data(), edge_b.data(), edge_c.data());
  return distance >= 0.0f ? distance : no_hit;
}

} // namespace pcl::indoor
