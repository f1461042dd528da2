/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include <pcl/model/model_openings.h>

#include "wall_dimensions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace pcl::indoor {
namespace {

constexpr double at_floor = 0.08;    // metres: thresholds are lower
constexpr double stride = 0.3;       // metres: higher sills are climbed, not passed
constexpr double least_head = 1.7;   // metres, of doors
constexpr double highest_head = 3.2; // metres, of doors
constexpr double narrowest = 0.5;    // metres, of doors
constexpr double least_leaf = 0.7;   // metres, of doors to the outside
constexpr double least_pane = 0.25;  // m^2: windows of 50 cm by 50 cm are the smallest
constexpr double mullion = 0.2;      // metres between two panes of one window, at most
constexpr double widest_door = 3.2;  // metres: gates of garages
constexpr double one_leaf = 1.3;     // metres: wider ones are passages, unless lintels
                                     // or leaves are seen
constexpr double lintel = 0.15;      // metres: lower ones are beams
constexpr double most = 0.5;         // share: what is mostly so

/** A hole that may be an opening. */
struct Candidate {
  std::size_t face = 0;
  FaceHole hole;
  ModelOpeningKind kind = ModelOpeningKind::Door;
  double certainty = 0.0; ///< how well the wall's face frames it
  std::uint32_t other_room = 0;
  double gap = 0.0; ///< to the other room's side, metres
  bool is_used = false;
};

/** Whether something is seen behind most of a hole or of its border. */
bool
isSeenIn(const FaceHole& hole)
{
  return hole.seen >= most || hole.reveal >= most;
}

/** How well the face frames a hole: the share of the worst side, without the lower one
 * of a door. Where something is seen in it, left or right may be a corner of the room.
 */
double
framing(const FaceHole& hole, bool is_door)
{
  const auto& [left, right, above, below] = hole.framed;
  const double lying = is_door ? above : std::min(above, below);
  return std::min(lying,
                  isSeenIn(hole) ? std::max(left, right) : std::min(left, right));
}

bool
hasSizeOfDoor(const WallFace& face, const FaceHole& hole)
{
  const double head = hole.box.max().y() - face.floor, width = hole.box.sizes().x();
  return head >= least_head && head <= highest_head && width >= narrowest &&
         width <= widest_door;
}

std::optional<Candidate>
candidateOf(const WallFace& face, std::size_t number, const FaceHole& hole)
{
  Candidate found;
  found.face = number;
  found.hole = hole;
  const double sill = hole.box.min().y() - face.floor;
  if (hole.hidden > 0.3)
    return std::nullopt;
  if (sill <= at_floor) {
    if (!hasSizeOfDoor(face, hole))
      return std::nullopt;
    if (hole.is_proud && hole.seen < 0.8)
      return std::nullopt;
    found.kind = ModelOpeningKind::Door;
  }
  else {
    if (hole.is_proud)
      return std::nullopt;
    found.kind = ModelOpeningKind::Window;
  }
  found.certainty = framing(hole, found.kind == ModelOpeningKind::Door);
  return found;
}

/** Make one window of two panes if they stand side by side. */
bool
joinPane(Candidate& one, const Candidate& other)
{
  const auto isPane = [](const Candidate& candidate) {
    return candidate.kind == ModelOpeningKind::Window && candidate.certainty >= most;
  };
  const bool is_left = one.hole.box.min().x() <= other.hole.box.min().x();
  const FaceHole& left = is_left ? one.hole : other.hole;
  const FaceHole& right = is_left ? other.hole : one.hole;
  const double gap = right.box.min().x() - left.box.max().x();
  if (!isPane(one) || !isPane(other) || gap < 0.0 || gap > mullion ||
      std::abs(right.box.min().y() - left.box.min().y()) > same_line ||
      std::abs(right.box.max().y() - left.box.max().y()) > same_line)
    return false;
  const double share =
      right.box.sizes().x() / (left.box.sizes() + right.box.sizes()).x();
  const auto mean = [share](double of_left, double of_right) {
    return (1.0 - share) * of_left + share * of_right;
  };
  FaceHole hole = left;
  hole.seen = mean(left.seen, right.seen);
  hole.reveal = mean(left.reveal, right.reveal);
  hole.framed = {left.framed[0],
                 right.framed[1],
                 mean(left.framed[2], right.framed[2]),
                 mean(left.framed[3], right.framed[3])};
  hole.box.extend(right.box);
  one.hole = hole;
  one.certainty = framing(hole, false);
  return true;
}

/** What the holes of a side may be; panes side by side are one window. */
std::vector<Candidate>
candidatesOf(const WallFace& face,
             std::size_t number,
             const std::vector<FaceHole>& holes)
{
  std::vector<Candidate> candidates;
  for (const FaceHole& hole : holes) {
    const auto candidate = candidateOf(face, number, hole);
    if (candidate && std::none_of(candidates.begin(), candidates.end(), [&](auto& one) {
          return joinPane(one, *candidate);
        }))
      candidates.push_back(*candidate);
  }
  return candidates;
}

/** The side of another room behind the middle of a hole. */
const FacePair*
pairBehind(const std::vector<FacePair>& pairs, const Candidate& candidate)
{
  const double middle = candidate.hole.box.center().x();
  for (const FacePair& pair : pairs)
    if (pair.face == candidate.face && middle >= pair.from && middle <= pair.to)
      return &pair;
  return nullptr;
}

/** Two holes seen from above, on the line of the first. */
bool
showOne(const std::vector<WallFace>& faces, const Candidate& a, const Candidate& b)
{
  const WallFace &one = faces[a.face], &other = faces[b.face];
  const double low = std::max(a.hole.box.min().y(), b.hole.box.min().y());
  const double high = std::min(a.hole.box.max().y(), b.hole.box.max().y());
  if (high - low < most * std::min(a.hole.box.sizes().y(), b.hole.box.sizes().y()))
    return false;
  const Eigen::Vector2d along = one.along();
  const auto place = [&](double u) {
    return along.dot(other.begin + u * other.along() - one.begin);
  };
  const double from = std::max(a.hole.box.min().x(), place(b.hole.box.max().x()));
  const double to = std::min(a.hole.box.max().x(), place(b.hole.box.min().x()));
  return to - from >= most * std::min(a.hole.box.sizes().x(), b.hole.box.sizes().x());
}

ModelOpening
openingOf(const WallFace& face, const Candidate& candidate)
{
  ModelOpening opening;
  const auto& box = candidate.hole.box;
  opening.kind = candidate.kind;
  opening.room_a = face.room;
  opening.room_b = candidate.other_room;
  if (opening.room_b > 0 && opening.room_b < opening.room_a)
    std::swap(opening.room_a, opening.room_b);
  opening.storey = face.storey;
  opening.along = face.along();
  opening.position.head<2>() = face.begin + box.center().x() * opening.along -
                               0.5 * candidate.gap * face.inward();
  if (candidate.kind == ModelOpeningKind::Window)
    opening.sill = box.min().y() - face.floor;
  opening.position.z() = face.floor + opening.sill;
  opening.height = box.max().y() - opening.position.z();
  opening.width = box.sizes().x();
  return opening;
}

/** What is seen of one wall: its candidates, and what they become. */
class Openings {
public:
  Openings(const std::vector<WallFace>& faces,
           const std::vector<FacePair>& pairs,
           const std::vector<FaceHoles>& holes)
  : faces_(faces)
  {
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (Candidate& candidate : candidatesOf(faces[i], i, holes[i])) {
        const FacePair* pair = pairBehind(pairs, candidate);
        if (pair) {
          candidate.other_room = faces[pair->other].room;
          candidate.gap = pair->gap;
        }
        other_face_.push_back(pair ? pair->other : faces.size());
        candidates_.push_back(candidate);
      }
  }

  /** An opening that a person can pass: as the images show it, or else as it is. */
  void
  addPassable(const RoomOpening& passable)
  {
    std::optional<Candidate> best;
    bool has_lintel = false;
    for (Candidate& candidate : candidates_) {
      if (!isAt(passable, candidate))
        continue;
      candidate.is_used = true;
      Candidate door = candidate;
      door.kind = ModelOpeningKind::Door;
      door.certainty = framing(door.hole, true);
      has_lintel = has_lintel || hasLintel(candidate);
      if (!best || door.certainty > best->certainty)
        best = door;
    }
    ModelOpening opening =
        best ? openingOf(faces_[best->face], *best) : without(passable);
    opening.room_a = passable.room_a;
    opening.room_b = passable.room_b;
    opening.is_open = true;
    if (best && opening.width > one_leaf && !has_lintel)
      opening.kind = ModelOpeningKind::Passage;
    found_.push_back(opening);
  }

  /** All others: closed doors, windows, doors to the outside. */
  void
  addOthers()
  {
    const auto first = static_cast<std::ptrdiff_t>(found_.size());
    std::vector<std::size_t> order(candidates_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
      return candidates_[a].certainty > candidates_[b].certainty;
    });
    for (const std::size_t i : order) {
      Candidate& candidate = candidates_[i];
      if (candidate.is_used || candidate.certainty < most)
        continue;
      candidate.is_used = true;
      bool from_both = false;
      for (std::size_t j = 0; j < candidates_.size(); ++j)
        if (!candidates_[j].is_used && candidates_[j].face == other_face_[i] &&
            showOne(faces_, candidate, candidates_[j]))
          from_both = candidates_[j].is_used = true;
      if (isOpening(candidate, from_both, other_face_[i] < faces_.size()))
        found_.push_back(openingOf(faces_[candidate.face], candidate));
    }
    std::stable_sort(found_.begin() + first,
                     found_.end(),
                     [](const auto& a, const auto& b) { return a.storey < b.storey; });
  }

  const std::vector<ModelOpening>&
  found() const
  {
    return found_;
  }

private:
  /** Whether the wall goes on above a hole; what frames it may be the ceiling. */
  bool
  hasLintel(const Candidate& candidate) const
  {
    return candidate.hole.framed[2] >= most &&
           faces_[candidate.face].ceiling - candidate.hole.box.max().y() >= lintel;
  }

  /** Whether a framed candidate is an opening, seen from one side or from both. */
  bool
  isOpening(const Candidate& candidate, bool from_both, bool has_other_side) const
  {
    if (candidate.other_room == faces_[candidate.face].room)
      return false; // a niche, or what stands in the room
    const FaceHole& hole = candidate.hole;
    if (candidate.kind == ModelOpeningKind::Window)
      return hole.box.volume() >= least_pane && (from_both || !has_other_side);
    if (candidate.other_room == 0 && hole.box.sizes().x() < least_leaf)
      return false; // a gap beside a column
    return from_both || isSeenIn(hole);
  }

  bool
  isAt(const RoomOpening& passable, const Candidate& candidate) const
  {
    const WallFace& face = faces_[candidate.face];
    const auto& box = candidate.hole.box;
    if (box.min().y() - face.floor > stride || !hasSizeOfDoor(face, candidate.hole) ||
        (face.room != passable.room_a && face.room != passable.room_b))
      return false;
    const Eigen::Vector2d way = passable.position.head<2>() - face.begin;
    const double place = face.along().dot(way), before = face.inward().dot(way);
    const double from = std::max(box.min().x(), place - 0.5 * passable.width);
    const double to = std::min(box.max().x(), place + 0.5 * passable.width);
    return std::abs(before) <= opening_reach &&
           to - from >= most * std::max(box.sizes().x(), passable.width) &&
           std::abs(passable.position.z() - box.min().y()) < 1.0;
  }

  /** An opening of which the images show no edges: nothing says that it has a leaf. */
  ModelOpening
  without(const RoomOpening& passable) const
  {
    ModelOpening opening;
    opening.kind = ModelOpeningKind::Passage;
    opening.position = passable.position;
    opening.width = passable.width;
    opening.along = Eigen::Vector2d::UnitX();
    double nearest = 1.0, height = 2.0; // metres
    for (const WallFace& face : faces_) {
      if (face.room != passable.room_a && face.room != passable.room_b)
        continue;
      opening.storey = face.room == passable.room_a ? face.storey : opening.storey;
      const Eigen::Vector2d way = passable.position.head<2>() - face.begin;
      const double beyond =
          std::abs(face.along().dot(way) - 0.5 * face.length()) - 0.5 * face.length();
      const double distance = std::max(0.0, beyond) + std::abs(face.inward().dot(way));
      if (distance >= nearest)
        continue;
      nearest = distance;
      opening.along = face.along();
      opening.position.z() = face.floor;
      height = face.ceiling - face.floor;
    }
    opening.height = std::min(height, passable.area / std::max(0.1, passable.width));
    return opening;
  }

  const std::vector<WallFace>& faces_;
  std::vector<Candidate> candidates_;
  std::vector<std::size_t> other_face_; ///< per candidate; their number = none
  std::vector<ModelOpening> found_;
};

} // namespace

std::vector<ModelOpening>
modelOpenings(const std::vector<WallFace>& faces,
              const std::vector<FacePair>& pairs,
              const std::vector<FaceHoles>& holes,
              const std::vector<RoomOpening>& passable)
{
  Openings openings(faces, pairs, holes);
  for (const RoomOpening& each : passable)
    openings.addPassable(each);
  openings.addOthers();
  return openings.found();
}

} // namespace pcl::indoor
