// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_indoor contributors
//
// The scene and the cloud as the page uses them, and their colours.

const text = (id) => document.getElementById(id).textContent;
const scene = JSON.parse(text("scene"));
const plans = JSON.parse(text("plans"));
const cloudHeader = JSON.parse(text("cloud"));

const objects = scene.objects;
const nonStructure = objects.filter((object) => object.structure === "none");
const hasClasses = Boolean(scene.categories);
const nameOf = (object) => object.structure !== "none" ? object.structure : hasClasses ? object.class : "object";
const sizeOf = (object) => object.upright_box.size.map((side) => side.toFixed(2)).join(" × ") + " m";
const roomName = (number) => number ? `Room ${number}` : "–";

/** Places of the file in the frame of plan and cloud: metres, z up. */
const toBuilding = (place) => {
  const away = place.map((value, i) => (value - cloudHeader.translation[i]) * cloudHeader.metres_per_unit);
  return ["x", "y", "up"].map((axis) => scene.axes[axis].reduce((sum, value, i) => sum + value * away[i], 0));
};

// Colours that can be told apart with any colour vision: Paul Tol's "muted" and "vibrant", the rarest classes share them.
const strong = ["#4477AA", "#EE7733", "#228833", "#CC3377", "#CCBB44", "#66CCEE", "#AA3377", "#44AA99", "#DDAA77", "#882255",
  "#999933", "#88CCEE", "#EE6677", "#6699CC", "#117733", "#CC6677", "#997700", "#BB5566", "#DDCC77", "#5566AA"];
const pale = ["#77AADD", "#EE8866", "#EEDD88", "#44BB99", "#FFAABB", "#99DDFF", "#BBCC33", "#AAAA00"];
const grey = "#b4b8bc";
const structureColours = { floor: "#cfcabf", wall: "#a3abb3", ceiling: "#c9ced3" };

const counts = new Map();
for (const object of nonStructure) counts.set(nameOf(object), (counts.get(nameOf(object)) || 0) + 1);
const classNames = [...counts.keys()].filter((name) => name !== "other")
  .sort((a, b) => counts.get(b) - counts.get(a) || (a < b ? -1 : 1));
const classColours = new Map(classNames.map((name, i) => [name, strong[i % strong.length]]));
classColours.set("other", grey);
if (counts.has("other")) classNames.push("other");

const roomColour = (number) => number ? pale[(number - 1) % pale.length] : grey;
const objectColour = (object) => object.structure !== "none" ? structureColours[object.structure] : strong[(object.object * 7) % strong.length];
const classColour = (object) => object.structure !== "none" ? structureColours[object.structure] : classColours.get(nameOf(object));

/** From dark blue over green to yellow (viridis), 0 to 1. */
const ramp = (share) => {
  const stops = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];
  const at = Math.min(Math.max(share, 0), 1) * 4;
  const left = Math.min(Math.floor(at), 3);
  return stops[left].map((value, i) => Math.round(value + (at - left) * (stops[left + 1][i] - value)));
};

const bytesOf = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)).buffer;
/** Coordinates, rooms and objects of the points. */
const cloud = (() => {
  const count = cloudHeader.points;
  const values = new Uint16Array(bytesOf(cloudHeader.data));
  const positions = new Float32Array(3 * count);
  for (let axis = 0; axis < 3; ++axis)
    for (let i = 0; i < count; ++i)
      positions[3 * i + axis] = cloudHeader.lower[axis] + values[axis * count + i] * cloudHeader.step[axis];
  return { count, positions, rooms: values.subarray(3 * count, 4 * count), objects: values.subarray(4 * count, 5 * count) };
})();

/** Does an object fit a search? That is the name of a class, or words: each begins a word of a class or is "room 3",
 * "storey 1", or a number of an object. */
const matcher = (query) => {
  if (counts.has(query.trim())) return (object) => nameOf(object) === query.trim();
  const words = query.toLowerCase().replace(/\b(room|storey|object)\s+#?(\d+)/g, "$1:$2").split(/[\s,]+/).filter(Boolean);
  return (object) => words.every((word) => {
    const [key, value] = word.split(":");
    if (value && ["room", "storey", "object"].includes(key)) return String(object[key]) === value;
    return `${object.object}` === word ||
      nameOf(object).toLowerCase().split(/\s+/).some((part) => part.startsWith(word) || `${part}s` === word);
  });
};
