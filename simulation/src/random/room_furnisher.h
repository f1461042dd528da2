/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "random/piece.h"
#include "random/random_layout.h"
#include "random/resting_places.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor {

/** \brief Finds places in one room, so that nothing collides.
 *
 * Every way to place a piece returns its number, or -1 if it does not fit there. Pieces
 * occupy their bounding box; what stands on a table or hangs over it is free to.
 */
class RoomFurnisher {
public:
  /** \param[in] room whose furniture it is
   * \param[in] openings of the storey
   * \param[in] number of the room in the openings
   * \param[in] wall_thickness metres
   * \param[in] ceiling metres above the floor
   * \param[in] seed of all that is drawn
   */
  RoomFurnisher(const LayoutRoom& room,
                const std::vector<LayoutOpening>& openings,
                int number,
                double wall_thickness,
                double ceiling,
                std::uint32_t seed);

  /** \brief From now on all shapes are drawn from, and what stands on a piece stands
   * where its surface carries it. */
  void
  liveIn()
  {
    lived_in_ = true;
  }

  bool
  chance(double probability)
  {
    return draw_.uniform() < probability;
  }

  double
  between(double low, double high)
  {
    return draw_.uniform(low, high);
  }

  int
  pick(int count)
  {
    return draw_.pick(count);
  }

  /** \brief Draw a piece of any shape; a size that is given replaces the drawn one. */
  Piece
  piece(const std::string& category,
        const std::optional<Eigen::Vector3d>& size = std::nullopt);

  /** \brief Draw a piece of one of the shapes \a first to \a last. */
  Piece
  shaped(const std::string& category,
         int first,
         int last,
         const std::optional<Eigen::Vector3d>& size = std::nullopt);

  /** \brief Back to a wall, at a height above the floor; often in a corner or right
   * beside another piece. */
  int
  atWall(const Piece& piece, double elevation = 0.0);

  /** \brief A piece at a wall, or none. */
  void
  perhapsAtWall(double probability, const std::string& category)
  {
    if (chance(probability))
      atWall(piece(category));
  }

  /** \brief Pieces at walls, as often any number of them up to the most. */
  void
  severalAtWall(int most, const std::string& category)
  {
    for (int i = pick(most + 1); i > 0; --i)
      atWall(piece(category));
  }

  /** \brief Beside a piece, backs in line: 1 on its right seen from behind, -1 left. */
  int
  beside(int other, const Piece& piece, int side, double gap, double elevation = 0.0);

  /** \brief In front of a piece (negative gap: reaching into it, which may then be
   * under it), moved sideways, turned from facing it. */
  int
  before(int other, const Piece& piece, double gap, double sideways, double turn);

  /** \brief Around a table: chairs tucked in, some pulled out, facing it. */
  void
  around(int table, const std::string& chair, int most);

  /** \brief On top of a piece, its back in line with that one's. */
  int
  onTop(int other, const Piece& piece, double turn = 0.0, bool at_rear = false);

  /** \brief On what carries it within a piece's extent: a top, a seat, a board. */
  int
  restOn(int other, const Piece& piece, const Resting& how);

  /** \brief On the floor below a piece, between its legs. */
  int
  under(int other, const Piece& piece);

  /** \brief Cloth over a piece; it needs no free place.
   * \param[in] at its middle in the frame of the piece, metres
   * \param[in] hem height of its lowest point, metres above the floor */
  void
  layOver(int other, Piece cloth, const Eigen::Vector2d& at, double hem);

  /** \brief On a wall with its lowest point at a height. */
  int
  onWall(const Piece& piece, double elevation);

  /** \brief A piece on a wall, its lowest point between two heights. */
  void
  hang(const std::string& category, double low, double high)
  {
    const double elevation = between(low, high);
    onWall(piece(category), elevation);
  }

  /** \brief Books, bottles, vases, cups, lamps on top of a piece. */
  void
  putSmallObjects(int other, int count);

  /** \brief A desk, its chair, and what stands on it; how often away from the walls. */
  void
  workplace(const Piece& desk, const std::string& chair, double free_standing);

  /** \brief Cabinets and devices side by side, a sink and a cooker among them, with
   * wall cupboards over them. */
  void
  kitchenRow(int cabinets);

  /** \brief Push more desks, tables and cabinets against those there are, put many
   * small objects on all that has a level top, some against each other, and some on the
   * floor.
   */
  void
  clutter();

  /** \brief Anywhere on the floor. */
  int
  anywhere(const Piece& piece);

  /** \brief In the middle of the room, \a share of its size away at most. */
  int
  inTheMiddle(const Piece& piece, double share, double elevation = 0.0);

  /** \brief Hang from the ceiling, over a piece or (-1) anywhere. */
  int
  fromCeiling(const Piece& piece, int over = -1);

  /** \brief Below most windows, not above their sills. */
  void
  radiatorsBelowWindows();

  /** \brief Curtains, or blinds, before each window. */
  void
  curtains(double probability, const std::string& category = "curtain");

  /** \brief At a place; \a under may be overlapped. */
  int
  put(const Piece& piece,
      const Eigen::Vector2d& at,
      double rotation,
      double elevation,
      int under = -1);

  /** \brief Nothing may stand here from now on. */
  void
  block(const Polygon& footprint, double low, double high);

  /** \brief True if a footprint lies in the room and is free up to a height. */
  bool
  isFree(const Polygon& footprint, double low, double high, int under = -1) const;

  /** \brief Size of the room between its walls, metres. */
  Eigen::Vector2d
  size() const
  {
    return inner_.sizes();
  }

  double
  ceiling() const
  {
    return ceiling_;
  }

  const std::vector<FurniturePlan>&
  furniture() const
  {
    return furniture_;
  }

  /** \brief The size of a piece that was placed, metres. */
  const Eigen::Vector3d&
  sizeOf(int number) const
  {
    return pieces_[static_cast<std::size_t>(number)].size;
  }

private:
  struct Obstacle {
    Polygon footprint;
    double low, high;
    int piece; // -1: a door's or window's
  };

  struct Window {
    Eigen::Vector2d at; // on the inner face of the wall
    double rotation, width, sill, top;
  };

  struct Wall {
    Eigen::Vector2d start, along, inwards;
    double rotation, length;
  };

  Wall
  wall(int number) const;

  std::vector<Piece>
  drawKitchen(int cabinets);

  void
  putInRow(const Piece& next, const Wall& w, double along, double upper);

  void
  pushTogether();

  const RestingPlaces&
  placesOn(int number);

  int
  tryWalls(const Piece& piece, double elevation, double gap);

  double
  placeAlong(const Wall& wall, const Piece& piece);

  Eigen::AlignedBox2d inner_;
  double ceiling_;
  RandomDraw draw_;
  std::vector<Obstacle> obstacles_;
  std::vector<Window> windows_;
  std::vector<FurniturePlan> furniture_;
  std::vector<Piece> pieces_;
  bool lived_in_ = false;
  std::vector<std::shared_ptr<RestingPlaces>> places_; // of pieces; null: not yet made
};

} // namespace pcl::indoor
