/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "random/habits.h"

namespace pcl::indoor {

namespace {

constexpr int all = 99; // shapes of a class at most

} // namespace

std::vector<Habit>
tableHabits()
{
  const std::vector<std::string> meals{"table", "round_table", "counter"}, work{"desk"},
      low{"coffee_table", "stool", "bench"};
  return {
      {meals, Where::On, 0.9, "cup", 0, all},
      {meals, Where::On, 0.7, "mug", 0, all},
      {meals, Where::On, 0.7, "bowl", 0, all},
      {meals, Where::On, 0.9, "bottle", 0, all},
      {meals, Where::On, 0.5, "books", 0, all},
      {meals, Where::On, 0.6, "clutter", 2, 8},
      {meals, Where::On, 0.25, "bag", 1, 3},
      {meals, Where::On, 0.3, "vase", 0, all},
      {meals, Where::On, 0.2, "laptop", 0, all},
      {meals, Where::On, 0.3, "box", 0, 3},
      {meals, Where::On, 0.2, "towel", 2, 4},
      {meals, Where::Below, 0.2, "bag", 0, 4},
      {work, Where::On, 0.9, "books", 0, all},
      {work, Where::On, 1.4, "clutter", 2, 10},
      {work, Where::On, 0.5, "mug", 0, all},
      {work, Where::On, 0.4, "bottle", 0, all},
      {work, Where::On, 0.3, "cable", 0, 0},
      {work, Where::On, 0.3, "monitor", 0, all},
      {work, Where::On, 0.25, "keyboard", 0, all},
      {work, Where::On, 0.3, "table_lamp", 0, all},
      {work, Where::On, 0.15, "bag", 1, 5},
      {work, Where::Below, 0.5, "bin", 0, all},
      {work, Where::Below, 0.4, "computer", 0, all},
      {work, Where::Below, 0.4, "bag", 0, 5},
      {work, Where::Below, 0.4, "cable", 1, 2},
      {work, Where::Below, 0.2, "box", 0, all},
      {work, Where::Below, 0.15, "shoes", 0, all},
      {low, Where::On, 0.6, "books", 0, all},
      {low, Where::On, 0.5, "cup", 0, all},
      {low, Where::On, 0.3, "bowl", 0, all},
      {low, Where::On, 0.4, "clutter", 2, 8},
      {low, Where::On, 0.15, "clothes", 0, 2},
      {low, Where::Below, 0.2, "shoes", 0, all},
  };
}

std::vector<Habit>
seatHabits()
{
  const std::vector<std::string> sofa{"sofa"}, bed{"bed", "bunk_bed"}, easy{"armchair"},
      chair{"chair", "office_chair"};
  return {
      {sofa, Where::Seat, 1.8, "pillow", 1, 1},
      {sofa, Where::Seat, 0.5, "pillow", 0, all},
      {sofa, Where::Seat, 0.3, "bag", 1, 4},
      {sofa, Where::Seat, 0.25, "books", 5, 5},
      {sofa, Where::Seat, 0.25, "toy", 0, 0},
      {sofa, Where::Seat, 0.2, "clothes", 0, 2},
      {sofa, Where::Over, 0.6, "blanket", 0, 0},
      {sofa, Where::Over, 0.25, "clothes", 0, 0},
      {bed, Where::Seat, 0.5, "pillow", 0, all},
      {bed, Where::Seat, 0.4, "clothes", 0, 2},
      {bed, Where::Seat, 0.2, "bag", 0, 4},
      {bed, Where::Seat, 0.3, "toy", 0, all},
      {bed, Where::Seat, 0.2, "books", 5, 5},
      {bed, Where::Seat, 0.15, "laptop", 0, all},
      {bed, Where::Over, 0.7, "blanket", 0, 0},
      {bed, Where::Over, 0.3, "clothes", 0, 0},
      {bed, Where::Around, 0.5, "shoes", 0, all},
      {easy, Where::Seat, 0.6, "pillow", 0, 1},
      {easy, Where::Seat, 0.15, "bag", 1, 3},
      {easy, Where::Over, 0.35, "blanket", 0, 0},
      {easy, Where::Back, 0.3, "clothes", 0, 0},
      {chair, Where::Back, 0.3, "clothes", 0, 0},
      {chair, Where::Seat, 0.12, "pillow", 0, 0},
      {chair, Where::Seat, 0.1, "bag", 1, 5},
      {chair, Where::Seat, 0.06, "books", 2, 2},
      {chair, Where::Around, 0.08, "bag", 0, 5},
  };
}

std::vector<Habit>
storageHabits()
{
  const std::vector<std::string> shelves{"bookcase", "rack", "shelf"},
      chests{"cabinet", "drawers", "tv_unit", "bedside_table", "piano"};
  const std::vector<std::string> tall{"wardrobe", "fridge"},
      worktop{"kitchen_unit", "counter"}, sink{"sink"}, bath{"bath"},
      wash{"washing_machine"}, heat{"radiator"};
  return {
      {shelves, Where::In, 3.5, "books", 3, 4},
      {shelves, Where::In, 0.8, "books", 0, all},
      {shelves, Where::In, 1.2, "box", 0, all},
      {shelves, Where::In, 0.6, "clutter", 5, 12},
      {shelves, Where::In, 0.4, "vase", 0, all},
      {shelves, Where::In, 0.3, "plant", 8, 11},
      {shelves, Where::In, 0.4, "toy", 0, all},
      {shelves, Where::In, 0.3, "bottle", 0, all},
      {shelves, Where::On, 0.4, "box", 0, all},
      {chests, Where::On, 0.5, "books", 0, all},
      {chests, Where::On, 0.35, "box", 0, all},
      {chests, Where::On, 0.3, "vase", 0, all},
      {chests, Where::On, 0.25, "plant", 8, 11},
      {chests, Where::On, 0.4, "clutter", 5, 12},
      {chests, Where::On, 0.2, "bottle", 0, all},
      {chests, Where::On, 0.12, "bag", 1, 3},
      {chests, Where::On, 0.12, "towel", 2, 3},
      {chests, Where::On, 0.12, "clothes", 0, 2},
      {tall, Where::On, 0.5, "box", 0, all},
      {tall, Where::On, 0.25, "bag", 4, 5},
      {tall, Where::On, 0.25, "blanket", 1, 1},
      {worktop, Where::On, 1.3, "kitchenware", 0, all},
      {worktop, Where::On, 0.9, "bottle", 0, all},
      {worktop, Where::On, 0.4, "bowl", 0, all},
      {worktop, Where::On, 0.4, "mug", 0, all},
      {worktop, Where::On, 0.3, "box", 0, 4},
      {worktop, Where::On, 0.2, "microwave", 0, all},
      {worktop, Where::On, 0.15, "bag", 3, 3},
      {worktop, Where::Over, 0.15, "towel", 4, 4},
      {sink, Where::On, 0.5, "bottle", 0, all},
      {sink, Where::On, 0.3, "cup", 0, all},
      {bath, Where::Over, 0.5, "towel", 4, 4},
      {bath, Where::Around, 0.4, "towel", 4, 4},
      {wash, Where::On, 0.5, "bottle", 0, all},
      {wash, Where::On, 0.4, "towel", 2, 4},
      {wash, Where::On, 0.3, "clutter", 13, 13},
      {heat, Where::Over, 0.25, "towel", 4, 4},
      {heat, Where::Over, 0.12, "clothes", 0, 0},
  };
}

std::vector<Custom>
customs()
{
  using R = RoomKind;
  constexpr double lies = -1, leans = 0;
  return {
      {R::Hall, 1.6, "shoes", 0, all, leans},
      {R::Hall, 0.7, "bag", 0, all, leans},
      {R::Hall, 1.2, "clothes", 3, 4, 0.9},
      {R::Hall, 0.4, "coat_rack", 2, 2, 0.75},
      {R::Hall, 0.3, "clutter", 14, 14, leans},
      {R::Hall, 0.3, "picture", 6, 6, 0.6},
      {R::Hall, 0.3, "box", 0, all, leans},
      {R::Living, 1.2, "toy", 0, all, lies},
      {R::Living, 0.6, "bag", 0, all, leans},
      {R::Living, 0.5, "box", 0, all, leans},
      {R::Living, 0.5, "cable", 1, 2, leans},
      {R::Living, 0.3, "clothes", 0, 1, lies},
      {R::Living, 0.3, "pillow", 0, 3, lies},
      {R::Living, 0.3, "picture", 7, 7, leans},
      {R::Living, 0.3, "shoes", 0, all, lies},
      {R::Living, 0.4, "clutter", 10, 10, leans},
      {R::Living, 0.3, "books", 2, 2, lies},
      {R::Kitchen, 0.5, "counter", 0, 3, leans},
      {R::Kitchen, 0.7, "towel", 0, 0, 0.85},
      {R::Kitchen, 0.6, "bin", 0, all, leans},
      {R::Kitchen, 0.5, "bag", 3, 3, leans},
      {R::Kitchen, 0.4, "box", 0, all, leans},
      {R::Kitchen, 0.4, "bottle", 0, all, leans},
      {R::Bathroom, 1.2, "towel", 0, 0, 0.9},
      {R::Bathroom, 0.9, "towel", 1, 1, 1.0},
      {R::Bathroom, 0.5, "clothes", 0, 1, lies},
      {R::Bathroom, 0.4, "clutter", 13, 13, leans},
      {R::Bathroom, 0.3, "clothes", 4, 4, 0.9},
      {R::Bathroom, 0.2, "radiator", 3, 3, 0.4},
      {R::Bedroom, 0.8, "clothes", 0, 1, lies},
      {R::Bedroom, 0.8, "toy", 0, all, lies},
      {R::Bedroom, 0.6, "bag", 0, all, leans},
      {R::Bedroom, 0.5, "shoes", 0, all, leans},
      {R::Bedroom, 0.4, "clothes", 3, 3, 0.9},
      {R::Bedroom, 0.4, "box", 0, all, leans},
      {R::Bedroom, 0.3, "clutter", 13, 13, leans},
      {R::Bedroom, 0.25, "picture", 7, 7, leans},
      {R::Bedroom, 0.2, "picture", 6, 6, 0.5},
      {R::Bedroom, 0.25, "coat_rack", 1, 1, leans},
      {R::Study, 0.7, "box", 0, all, leans},
      {R::Study, 0.6, "books", 2, 2, leans},
      {R::Study, 0.4, "bag", 0, 5, leans},
      {R::Study, 0.4, "cable", 1, 2, leans},
      {R::Study, 0.4, "board", 2, 3, leans},
      {R::Office, 0.6, "bag", 0, 5, leans},
      {R::Office, 0.6, "box", 0, all, leans},
      {R::Office, 0.5, "cable", 1, 2, leans},
      {R::Office, 0.5, "board", 2, 3, leans},
      {R::Office, 0.4, "bin", 0, all, leans},
      {R::Office, 0.4, "clothes", 3, 3, 0.9},
      {R::Office, 0.3, "coat_rack", 2, 2, 0.75},
      {R::Office, 0.2, "picture", 7, 7, leans},
      {R::Meeting, 0.8, "board", 2, 3, leans},
      {R::Meeting, 0.4, "bag", 0, 5, leans},
      {R::Meeting, 0.4, "cable", 1, 2, lies},
      {R::Storage, 2.0, "box", 0, all, leans},
      {R::Storage, 0.6, "box", 0, all, lies},
      {R::Storage, 0.5, "bag", 4, 7, leans},
      {R::Storage, 0.5, "bin", 0, all, leans},
      {R::Storage, 0.4, "cable", 0, 2, lies},
      {R::Storage, 0.4, "clutter", 12, 13, leans},
  };
}

} // namespace pcl::indoor
