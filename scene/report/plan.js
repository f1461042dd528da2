// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_indoor contributors
//
// The plan: one storey as an SVG drawing that can be moved, zoomed and clicked.

class Plan {
  constructor(box, choose, say) {
    this.box = box;
    this.pointers = new Map();
    this.choose = choose;
    this.say = say;
    box.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY * 0.0015), event.clientX, event.clientY);
    }, { passive: false });
    box.addEventListener("pointerdown", (event) => this.press(event));
    box.addEventListener("pointermove", (event) => this.move(event));
    for (const end of ["pointerup", "pointercancel"]) box.addEventListener(end, (event) => this.release(event));
    box.addEventListener("pointerleave", () => say(null));
    box.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(() => this.show()).observe(box);
  }

  draw(storey, colourOf) {
    this.box.innerHTML = plans[storey] || '<svg xmlns="http://www.w3.org/2000/svg"></svg>';
    this.svg = this.box.querySelector("svg");
    this.svg.removeAttribute("width");
    this.svg.removeAttribute("height");
    const { x, y, width, height } = this.svg.getBBox();
    const margin = 16;
    this.whole = [x - margin, y - margin, width + 2 * margin, height + 2 * margin];
    this.view = [...this.whole];
    this.names = [...this.svg.querySelectorAll(".room-number")].map((number) => {
      const room = this.svg.querySelector(`#room-${number.textContent}`).getBBox();
      return { number, area: number.nextElementSibling, y: Number(number.getAttribute("y")) + 3, width: Math.min(room.width, room.height) };
    });
    for (const shape of this.svg.querySelectorAll(".thing")) this.label(shape);
    this.colour(colourOf);
    this.show();
  }

  label(shape) {
    const box = shape.getBBox();
    const label = document.createElementNS("http://www.w3.org/2000/svg", "text");
    label.setAttribute("class", "thing-name");
    label.setAttribute("x", box.x + box.width / 2);
    label.setAttribute("y", box.y + box.height / 2 + 2);
    label.textContent = nameOf(objects[shape.dataset.object - 1]);
    this.svg.append(label);
  }

  colour(colourOf) {
    for (const shape of this.svg.querySelectorAll(".thing, .room"))
      shape.style.setProperty("--fill", colourOf(itemOf(shape)) || "");
  }

  /** Fade what is not shown, and mark what is chosen. */
  mark(chosen, isShown) {
    for (const shape of this.svg.querySelectorAll("[data-object], [data-room], [data-opening]")) {
      const { kind, number } = itemOf(shape);
      const is = Boolean(chosen) && chosen.kind === kind && chosen.number === number;
      shape.classList.toggle("chosen", is);
      if (is) this.reveal(shape);
      shape.classList.toggle("away", kind === "object" && !isShown(objects[number - 1]));
    }
  }

  /** Move the plan so that a shape is in it. */
  reveal(shape) {
    const { x, y, width, height } = shape.getBBox();
    const [u, v] = [x + width / 2, y + height / 2];
    if (Math.abs(u - this.view[0] - this.view[2] / 2) > this.view[2] / 2) this.view[0] = u - this.view[2] / 2;
    if (Math.abs(v - this.view[1] - this.view[3] / 2) > this.view[3] / 2) this.view[1] = v - this.view[3] / 2;
    this.show();
  }

  show() {
    if (!this.svg) return;
    this.svg.setAttribute("viewBox", this.view.map((value) => value.toFixed(2)).join(" "));
    this.box.classList.toggle("close", this.whole[2] / this.view[2] > 2.2);
    const perUnit = this.pixelsPerUnit();
    this.nameRooms(perUnit);
    const bar = document.querySelector("#scale span");
    const metres = [0.5, 1, 2, 5, 10, 20, 50, 100].find((length) => length * 50 * perUnit > 55) || 200;
    bar.style.width = `${metres * 50 * perUnit}px`;
    bar.textContent = `${metres} m`;
  }

  /** Names are as large on the screen at any zoom; areas are shown where there is space for them. */
  nameRooms(perUnit) {
    this.svg.style.setProperty("--unit", 1 / perUnit);
    for (const { number, area, y, width } of this.names) {
      const narrow = width * perUnit < 10 + 6 * area.textContent.length; // pixels
      number.setAttribute("y", y + (narrow ? 5 : -1) / perUnit);
      area.setAttribute("y", y + 13 / perUnit);
      area.classList.toggle("narrow", narrow);
    }
  }

  pixelsPerUnit() {
    return Math.min(this.box.clientWidth / this.view[2], this.box.clientHeight / this.view[3]) || 1;
  }

  /** The place of the drawing under a place of the screen. */
  placeAt(x, y) {
    const box = this.box.getBoundingClientRect();
    const scale = this.pixelsPerUnit();
    return [this.view[0] + this.view[2] / 2 + (x - box.left - box.width / 2) / scale,
      this.view[1] + this.view[3] / 2 + (y - box.top - box.height / 2) / scale];
  }

  zoom(factor, x, y) {
    const box = this.box.getBoundingClientRect();
    const [u, v] = this.placeAt(x ?? box.left + box.width / 2, y ?? box.top + box.height / 2);
    const most = 1.6 * this.whole[2] / this.view[2], least = 0.02 * this.whole[2] / this.view[2];
    const by = Math.min(Math.max(factor, least), most);
    this.view = [u + (this.view[0] - u) * by, v + (this.view[1] - v) * by, this.view[2] * by, this.view[3] * by];
    this.show();
  }

  shift(x, y) {
    const scale = this.pixelsPerUnit();
    this.view[0] -= x / scale;
    this.view[1] -= y / scale;
    this.show();
  }

  all() {
    this.view = [...this.whole];
    this.show();
  }

  press(event) {
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    this.dragged = this.pointers.size > 1 ? 99 : 0;
  }

  move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) {
      const item = itemOf(event.target);
      this.say(item && event.pointerType === "mouse" ? item : null, event.clientX, event.clientY);
      return;
    }
    this.dragged += Math.abs(event.clientX - before[0]) + Math.abs(event.clientY - before[1]);
    if (this.dragged < 6) return;
    if (!this.box.hasPointerCapture(event.pointerId)) this.box.setPointerCapture(event.pointerId);
    const others = [...this.pointers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
    if (others.length) {
      const span = (place) => Math.hypot(place[0] - others[0][0], place[1] - others[0][1]) || 1;
      this.zoom(span(before) / span([event.clientX, event.clientY]), others[0][0], others[0][1]);
    } else this.shift(event.clientX - before[0], event.clientY - before[1]);
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
  }

  release(event) {
    const pressed = this.pointers.delete(event.pointerId);
    if (pressed && event.type === "pointerup" && this.dragged < 6) this.choose(itemOf(event.target));
  }

  key(event) {
    const step = 60;
    const moves = { ArrowLeft: [step, 0], ArrowRight: [-step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] };
    if (moves[event.key]) this.shift(...moves[event.key]);
    else if (event.key === "+" || event.key === "=") this.zoom(0.8);
    else if (event.key === "-") this.zoom(1.25);
    else if (event.key === "0") this.all();
    else return;
    event.preventDefault();
  }
}

/** What a shape of the plan stands for; null for none. */
const itemOf = (shape) => {
  for (const kind of ["object", "room", "opening"])
    if (shape.dataset && shape.dataset[kind]) return { kind, number: Number(shape.dataset[kind]) };
  return null;
};
