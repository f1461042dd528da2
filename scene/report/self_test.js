// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_indoor contributors
//
// report.html#self-test uses the page as a person would and says in its title what went wrong, or "self-test: passed".

const selfTest = () => {
  const problems = [];
  const expect = (holds, what) => { if (!holds) problems.push(what); };
  const rows = (id) => document.querySelectorAll(`#${id} tbody tr`).length;
  const drawn = [...document.querySelectorAll("#plan .thing")];

  expect(rows("objects") === nonStructure.length, "the table lists all objects");
  expect(rows("rooms") === scene.rooms.length, "the table lists all rooms");
  expect(rows("openings") === scene.openings.length && rows("walls") === scene.walls.length, "the tables list all openings and walls");
  expect(document.querySelectorAll("#plan .room").length === scene.rooms.filter((room) => room.storey === 0).length, "the plan shows the rooms");
  expect(drawn.length === nonStructure.filter((object) => object.storey === 0).length, "the plan shows the objects");
  expect(cloud.count === 0 || cloud.objects.reduce((most, number) => Math.max(most, number), 0) <= objects.length, "points belong to objects");
  expect(!space || drawSpace() > 0, "the 3D view has points");
  expect(scene.overview.facts.every((line) => $("about").textContent.includes(line)), "what was understood is told");
  expect($("lacks").hidden === !scene.overview.consequences.length, "what lacks is told, and only that");
  expect(document.documentElement.scrollWidth <= innerWidth, "the page is no wider than the window");

  // a click on the plan chooses the same in table and details
  const shape = drawn[drawn.length - 1];
  const number = Number(shape.dataset.object);
  const mouse = { bubbles: true, pointerId: 1, clientX: 5, clientY: 5 };
  shape.dispatchEvent(new PointerEvent("pointerdown", mouse));
  shape.dispatchEvent(new PointerEvent("pointerup", mouse));
  const chosen = document.querySelector("#objects tr[aria-selected=true]");
  expect(chosen && Number(chosen.dataset.object) === number, "a click on the plan chooses the row");
  expect(shape.classList.contains("chosen"), "a click on the plan marks the object");
  expect(!$("details").hidden && $("details").textContent.includes(`${number}`), "details are shown");
  expect(!space || space.frame.geometry.attributes.position.count === 24, "the 3D view frames it");
  expect(location.hash === `#object=${number}`, "the address names it");

  // so does a click on a wall's row, which leads to its rooms
  document.querySelector("#walls tbody tr").click();
  const wall = scene.walls[Number(document.querySelector("#walls tr[aria-selected=true]").dataset.wall) - 1];
  expect(state.chosen.kind === "wall" && wall.rooms.every((room) => $("details").textContent.includes(roomName(room))), "details tell a wall's rooms");
  choose({ kind: "object", number });

  // keys in the table choose the next
  chosen.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowUp", bubbles: true }));
  expect(state.chosen.number !== number && document.querySelectorAll("#plan .chosen").length <= 1, "keys choose another");

  // the search filters table and plan
  const name = nameOf(nonStructure[0]);
  $("search").value = `${name} room ${nonStructure[0].room}`;
  $("search").dispatchEvent(new Event("input"));
  const fits = (object) => name.split(" ").every((word) => nameOf(object).split(" ").some((part) => part.startsWith(word)));
  const wanted = nonStructure.filter((object) => fits(object) && object.room === nonStructure[0].room).length;
  expect(rows("objects") === wanted, `the search finds ${wanted} objects, not ${rows("objects")}`);
  expect(document.querySelectorAll("#plan .thing:not(.away)").length <= wanted, "the plan fades the others");
  for (const [name, count] of hasClasses ? counts : []) {
    setColour("class");
    [...document.querySelectorAll("#legend button")].find((button) => button.childNodes[1].textContent === name).click();
    expect(rows("objects") === count, `the legend finds ${count} of ${name}, not ${rows("objects")}`);
  }
  $("search").value = "no such thing";
  search();
  expect(rows("objects") === 0, "the search may find nothing");
  $("search").value = "";
  search();

  for (const colour of [...$("colour").options].map((option) => option.value)) setColour(colour);
  for (const storey of scene.storeys) setStorey(storey.storey);
  dispatchEvent(new KeyboardEvent("keydown", { key: "Escape" }));
  expect(state.chosen === null && $("details").hidden, "Escape chooses nothing");
  return problems;
};

if (location.hash === "#self-test") {
  const errors = [];
  addEventListener("error", (event) => errors.push(event.message));
  let problems;
  try {
    problems = selfTest();
  } catch (problem) {
    problems = [String(problem)];
  }
  document.title = [...problems, ...errors].length ? `self-test: ${[...problems, ...errors].join("; ")}` : "self-test: passed";
}
