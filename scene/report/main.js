// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_indoor contributors
//
// Connects plan, tables and 3D view: what is chosen, searched and coloured is so in all of them.

const $ = (id) => document.getElementById(id);
const state = { chosen: null, colour: hasClasses ? "class" : "object", storey: 0, tab: "objects" };
let isFound = () => true;

const isShown = (object) => isFound(object);
const known = { object: objects, room: scene.rooms, opening: scene.openings, wall: scene.walls };
const storeyOf = ({ kind, number }) => known[kind][number - 1]?.storey;

const fillOf = ({ kind, number }) => {
  if (kind === "room") return state.colour === "room" ? roomColour(number) : null;
  if (kind !== "object") return null;
  const object = objects[number - 1];
  if (state.colour === "class") return classColour(object);
  if (state.colour === "object") return objectColour(object);
  if (state.colour === "room") return roomColour(object.room);
  return `rgb(${ramp(heightShare(toBuilding(object.upright_box.center)[2]))})`;
};

const lowest = cloudHeader.lower[2], highest = lowest + 65535 * cloudHeader.step[2];
/** Of the storey that is shown, or of all. */
const heightShare = (z) => {
  const storey = scene.storeys[state.storey];
  if (!storey || scene.axes.up.every((value) => !value)) return (z - lowest) / (highest - lowest || 1);
  const floor = floorsOfStoreys[state.storey];
  return (z - floor) / Math.max(0.5, storey.ceiling - storey.floor);
};
/** Lowest floor of the rooms of each storey, in the frame of the cloud. */
const floorsOfStoreys = scene.storeys.map((storey) => {
  const heights = scene.rooms.filter((room) => room.storey === storey.storey && room.footprint.length)
    .map((room) => toBuilding(room.footprint[0][0])[2]);
  return heights.length ? Math.min(...heights) : lowest;
});

const space = (() => {
  try {
    return new Space(document.querySelector("#space canvas"), (item) => choose(item));
  } catch (problem) {
    document.querySelector("#space canvas").hidden = true;
    $("space-note").hidden = false;
    $("space-note").textContent = "The 3D view needs WebGL, which this browser does not offer.";
    return null;
  }
})();
const plan = new Plan($("plan"), (item) => choose(item), say);
const tables = {
  objects: new Table($("objects"), "object", objectColumns((object) => fillOf({ kind: "object", number: object.object })), choose),
  rooms: new Table($("rooms"), "room", roomColumns, choose),
  openings: new Table($("openings"), "opening", openingColumns, choose),
  walls: new Table($("walls"), "wall", wallColumns, choose),
};

function say(item, x, y) {
  const tip = $("tip");
  tip.hidden = !item;
  if (!item) return;
  tip.textContent = titleOf(item);
  tip.style.left = `${Math.min(x + 14, innerWidth - tip.offsetWidth - 8)}px`;
  tip.style.top = `${y + 16}px`;
}

function titleOf({ kind, number }) {
  if (kind === "room") return `${roomName(number)}, ${scene.rooms[number - 1].area.toFixed(1)} m²`;
  if (kind === "opening") return `${capital(scene.openings[number - 1].kind)} ${number}, ${metres(scene.openings[number - 1].width)} wide`;
  if (kind === "wall") return `Wall ${number}, ${metres(lengthOf(scene.walls[number - 1]))} long`;
  const object = objects[number - 1];
  const sure = object.structure === "none" && object.confidence ? `, ${percent(object.confidence)} sure` : "";
  return `${nameOf(object)} ${number}${sure}`;
}

const capital = (word) => word.charAt(0).toUpperCase() + word.slice(1);

const roomLinks = (rooms) => rooms.filter((room) => room > 0).map((room) => ({ kind: "room", number: room }));

/** What a link to an item says. */
const linkText = ({ kind, number }) => kind === "room" ? roomName(number) : kind === "opening" ? `${capital(scene.openings[number - 1].kind)} ${number}` : `Wall ${number}`;

/** Rows of what is known of an item: [term, text or item to go to]. */
function factsOf({ kind, number }) {
  if (kind === "room") {
    const room = scene.rooms[number - 1];
    const names = new Map();
    for (const id of room.objects) if (objects[id - 1].structure === "none") names.set(nameOf(objects[id - 1]), (names.get(nameOf(objects[id - 1])) || 0) + 1);
    return [["Likeliest", room.name_top.map((top) => `${top.name} ${percent(top.probability)}`).join(", ")], ["Storey", room.storey], ["Area", `${room.area.toFixed(1)} m²`], ["Height", metres(room.height)],
      ["Volume", `${room.volume.toFixed(1)} m³`], ["Holds", [...names].map(([name, count]) => `${count} × ${name}`).join(", ") || "nothing"],
      ["Leads to", [...new Set(room.neighbours.map((n) => n.room))].map((other) => ({ kind: "room", number: other }))]];
  }
  if (kind === "opening") {
    const opening = scene.openings[number - 1];
    return [["Between", roomLinks(opening.rooms)], ["Width", metres(opening.width)], ["Height", metres(opening.height)],
      ["Lower edge", `${metres(opening.sill)} above the floor`], ["Area", `${opening.area.toFixed(2)} m²`], ["Can be passed", opening.open ? "yes" : "no"],
      ["Storey", opening.storey], ...(opening.wall ? [["In", [{ kind: "wall", number: opening.wall }]]] : [])];
  }
  if (kind === "wall") {
    const wall = scene.walls[number - 1];
    const holds = scene.openings.filter((opening) => opening.wall === number);
    return [["Bounds", roomLinks(wall.rooms)], ["Length", metres(lengthOf(wall))], ["Height", metres(wall.height)],
      ["Thickness", wall.thickness ? metres(wall.thickness) : "not known: one side was seen"],
      ["Holds", holds.map((opening) => ({ kind: "opening", number: opening.opening }))], ["Storey", wall.storey]];
  }
  const object = objects[number - 1];
  return [["Room", object.room ? [{ kind: "room", number: object.room }] : "none"], ["Size", sizeOf(object)],
    ["Centre", object.upright_box.center.map((value) => value.toFixed(2)).join(", ")], ["Points", object.points.toLocaleString("en")],
    ...(object.structure === "none" && object.top && object.top.length ? [["Likeliest", object.top.map((top) => `${top.class} ${percent(top.confidence)}`).join(", ")]] : [])];
}

function showDetails() {
  const box = $("details");
  box.hidden = !state.chosen;
  if (!state.chosen) return;
  const title = document.createElement("h2");
  title.textContent = capital(titleOf(state.chosen));
  const close = document.createElement("button");
  close.textContent = "✕";
  close.setAttribute("aria-label", "Close (Esc)");
  close.addEventListener("click", () => choose(null));
  const list = document.createElement("dl");
  for (const [term, value] of factsOf(state.chosen)) {
    const name = document.createElement("dt"), what = document.createElement("dd");
    name.textContent = term;
    if (Array.isArray(value)) value.forEach((item, i) => {
      const link = document.createElement("button");
      link.className = "link";
      link.textContent = linkText(item);
      link.addEventListener("click", () => choose(item));
      what.append(i ? ", " : "", link);
    });
    else what.textContent = value;
    list.append(name, what);
  }
  box.replaceChildren(title, close, list);
}

/** Choose an object, a room, an opening or a wall everywhere; null for nothing. */
function choose(item) {
  state.chosen = item;
  const storey = item && storeyOf(item);
  if (Number.isInteger(storey) && state.storey !== storey && state.storey !== scene.storeys.length) setStorey(storey);
  if (item && tables[`${item.kind}s`] && state.tab !== `${item.kind}s`) showTab(`${item.kind}s`);
  const object = item && item.kind === "object" ? objects[item.number - 1] : null;
  for (const table of Object.values(tables)) table.mark(item);
  plan.mark(item, isShown);
  if (space) {
    space.mark(object);
    if (object) space.turnTo(toBuilding(object.upright_box.center), 11);
    else if (item) space.turnTo(middleOf(item), 20);
    drawSpace();
  }
  showDetails();
  history.replaceState(null, "", item ? `#${item.kind}=${item.number}` : location.pathname + location.search);
}

/** Of a room, an opening or a wall, in the frame of the cloud. */
function middleOf({ kind, number }) {
  const room = scene.rooms[number - 1], wall = scene.walls[number - 1];
  if (kind === "wall") return toBuilding(wall.begin.map((value, i) => (value + wall.end[i]) / 2));
  if (kind === "opening") return toBuilding(scene.openings[number - 1].position);
  return toBuilding(room.box ? room.box.lower.map((value, i) => (value + room.box.upper[i]) / 2) : room.footprint[0][0]);
}

function drawSpace() {
  if (!space) return 0;
  const hidden = { ceiling: !$("show-ceiling").checked, wall: !$("show-wall").checked };
  const bytes = new Map();
  const rgbOf = (hex) => bytes.get(hex) || bytes.set(hex, [1, 3, 5].map((at) => parseInt(hex.substr(at, 2), 16))).get(hex);
  const chosenObject = state.chosen?.kind === "object" ? state.chosen.number : 0;
  const chosenRoom = state.chosen?.kind === "room" ? state.chosen.number : 0;
  const found = objects.map((object) => object.structure !== "none" || isFound(object));
  const all = state.storey === scene.storeys.length;
  const top = !all && floorsOfStoreys[state.storey + 1] !== undefined ? floorsOfStoreys[state.storey + 1] - 0.3 : Infinity;
  const near = scene.rooms.map((room) => all || room.storey === state.storey);
  return space.draw((i) => {
    const room = cloud.rooms[i], object = objects[cloud.objects[i] - 1];
    if (room ? !near[room - 1] : !all) return false;
    if (object && hidden[object.structure]) return false;
    return !(hidden.ceiling && cloud.positions[3 * i + 2] > top && !all);
  }, (i) => {
    const number = cloud.objects[i], object = objects[number - 1];
    if (number && number === chosenObject) return rgbOf("#0b62c4");
    let colour;
    if (state.colour === "height") colour = ramp(heightShare(cloud.positions[3 * i + 2]));
    else if (state.colour === "room") colour = rgbOf(roomColour(cloud.rooms[i]));
    else if (!object) colour = rgbOf(grey);
    else colour = rgbOf(state.colour === "class" ? classColour(object) : objectColour(object));
    const away = (object && !found[number - 1]) || (chosenRoom && cloud.rooms[i] !== chosenRoom);
    return away ? colour.map((value) => 0.22 * value + 0.78 * 205) : colour;
  });
}

function showLegend() {
  const box = $("legend");
  if (state.colour !== "class") {
    const note = document.createElement("small");
    note.textContent = { room: "Each room in its colour", object: "Each object in a colour of its own", height: "Height above the floor" }[state.colour];
    const scale = document.createElement("div");
    scale.className = "ramp";
    scale.style.background = `linear-gradient(to right, ${[0, 0.25, 0.5, 0.75, 1].map((share) => `rgb(${ramp(share)})`)})`;
    box.replaceChildren(note, ...(state.colour === "height" ? [scale] : []));
    return;
  }
  box.replaceChildren(...classNames.map((name) => {
    const button = document.createElement("button");
    const swatch = document.createElement("i"), count = document.createElement("small");
    swatch.style.setProperty("--fill", classColours.get(name));
    count.textContent = counts.get(name);
    button.append(swatch, name, count);
    button.setAttribute("aria-pressed", $("search").value.trim() === name);
    button.addEventListener("click", () => {
      $("search").value = $("search").value.trim() === name ? "" : name;
      search();
    });
    return button;
  }));
}

function search() {
  const query = $("search").value;
  isFound = matcher(query);
  const found = nonStructure.filter(isFound);
  tables.objects.fill(found, state.chosen);
  const rooms = query.trim() ? new Set(found.map((object) => object.room)) : null;
  tables.rooms.fill(scene.rooms.filter((room) => !rooms || rooms.has(room.room)), state.chosen);
  tables.openings.fill(scene.openings, state.chosen);
  tables.walls.fill(scene.walls, state.chosen);
  $("tab-objects").textContent = `Objects ${found.length}`;
  $("tab-rooms").textContent = `Rooms ${rooms ? scene.rooms.filter((room) => rooms.has(room.room)).length : scene.rooms.length}`;
  plan.mark(state.chosen, isShown);
  showLegend();
  drawSpace();
}

function setStorey(storey) {
  state.storey = storey;
  $("storey").value = storey;
  plan.draw(Math.min(storey, scene.storeys.length - 1), fillOf);
  plan.mark(state.chosen, isShown);
  drawSpace();
  showWhole();
}

function setColour(colour) {
  state.colour = colour;
  $("colour").value = colour;
  plan.colour(fillOf);
  tables.objects.fill(nonStructure.filter(isFound), state.chosen);
  showLegend();
  drawSpace();
}

/** Look at all rooms of the storey. */
function showWhole() {
  if (!space) return;
  const lower = [Infinity, Infinity, Infinity], upper = [-Infinity, -Infinity, -Infinity];
  for (const room of scene.rooms) {
    if (state.storey !== scene.storeys.length && room.storey !== state.storey) continue;
    for (const corner of room.footprint.flat()) toBuilding(corner).forEach((value, i) => {
      lower[i] = Math.min(lower[i], value);
      upper[i] = Math.max(upper[i], value);
    });
  }
  if (lower[0] < upper[0]) space.look(lower, upper);
  else space.look(cloudHeader.lower, cloudHeader.lower.map((value, i) => value + 65535 * cloudHeader.step[i]));
}

function showTab(name) {
  state.tab = name;
  for (const tab of document.querySelectorAll("[role=tab]")) {
    const is = tab.id === `tab-${name}`;
    tab.setAttribute("aria-selected", is);
    tab.tabIndex = is ? 0 : -1;
    $(tab.id.slice(4)).hidden = !is;
  }
}

function addOptions(select, options) {
  for (const [value, name] of options) select.add(new Option(name, value));
}

function start() {
  $("title").textContent = scene.input;
  const area = scene.rooms.reduce((sum, room) => sum + room.area, 0);
  const fact = (value, name) => `<b>${value.toLocaleString("en")}</b> ${name}`;
  $("facts").innerHTML = [fact(scene.storeys.length, scene.storeys.length === 1 ? "storey" : "storeys"), fact(scene.rooms.length, "rooms"),
    fact(Math.round(area), "m²"), fact(nonStructure.length, "objects"), fact(scene.points, "points")].join(" · ");
  $("lacks").hidden = !scene.overview.consequences.length;
  $("lacks").textContent = scene.overview.consequences.join(" ");
  addOptions($("colour"), [...(hasClasses ? [["class", "by class"]] : []), ["object", "by object"], ["room", "by room"], ["height", "by height"]]);
  addOptions($("storey"), [...scene.storeys.map((storey) => [storey.storey, String(storey.storey)]), [scene.storeys.length, "all (3D)"]]);
  $("storey-choice").hidden = scene.storeys.length < 2;
  $("tab-openings").textContent = `Openings ${scene.openings.length}`;
  $("tab-walls").textContent = `Walls ${scene.walls.length}`;
  const about = document.createElement("dl");
  for (const [term, value] of [["Program", `${scene.program.name} ${scene.program.version}`], ["Points", `${scene.points.toLocaleString("en")}, of which this page shows ${cloud.count.toLocaleString("en")}`],
    ...scene.overview.facts.map((line) => ["Scan", line]), ...scene.overview.consequences.map((line) => ["Lacks", line]),
    ["Voxels of the rooms", `${scene.voxel_size} m`], ...Object.entries(scene.settings).map(([name, setting]) => [`-${name}`, String(setting)]),
    ...scene.warnings.map((warning) => ["Warning", warning])]) {
    const name = document.createElement("dt"), what = document.createElement("dd");
    name.textContent = term;
    what.textContent = value;
    about.append(name, what);
  }
  $("about").append(about);
  listen();
  showTab("objects");
  setStorey(0);
  setColour(state.colour);
  search();
  const [, kind, number] = location.hash.match(/^#(object|room|opening|wall)=(\d+)$/) || [];
  if (kind && known[kind][number - 1]) choose({ kind, number: Number(number) });
}

function listen() {
  $("search").addEventListener("input", search);
  $("colour").addEventListener("change", (event) => setColour(event.target.value));
  $("storey").addEventListener("change", (event) => setStorey(Number(event.target.value)));
  for (const id of ["show-ceiling", "show-wall"]) $(id).addEventListener("change", drawSpace);
  $("space-all").addEventListener("click", showWhole);
  $("plan-in").addEventListener("click", () => plan.zoom(0.7));
  $("plan-out").addEventListener("click", () => plan.zoom(1.4));
  $("plan-all").addEventListener("click", () => plan.all());
  const tabs = [...document.querySelectorAll("[role=tab]")];
  tabs.forEach((tab, i) => {
    tab.addEventListener("click", () => showTab(tab.id.slice(4)));
    tab.addEventListener("keydown", (event) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!step) return;
      const next = tabs[(i + step + tabs.length) % tabs.length];
      next.focus();
      showTab(next.id.slice(4));
    });
  });
  addEventListener("keydown", (event) => {
    if (event.key === "Escape") choose(null);
    else if (event.key === "/" && document.activeElement !== $("search")) {
      event.preventDefault();
      $("search").focus();
    }
  });
}

start();
