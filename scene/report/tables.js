// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_indoor contributors
//
// Tables of objects, rooms, openings and walls: sorted by their headers, chosen from by mouse and keyboard.

class Table {
  /** columns: { name, value(item), text(item), number, optional, colour(item) } */
  constructor(box, kind, columns, choose) {
    this.kind = kind;
    this.columns = columns;
    this.choose = choose;
    this.order = { column: 0, down: false };
    this.table = document.createElement("table");
    this.table.setAttribute("role", "grid");
    const head = this.table.createTHead().insertRow();
    columns.forEach((column, i) => head.append(this.header(column, i)));
    this.body = this.table.createTBody();
    this.body.addEventListener("click", (event) => this.click(event));
    this.body.addEventListener("keydown", (event) => this.key(event));
    this.note = document.createElement("p");
    box.append(this.table, this.note);
  }

  header(column, i) {
    const cell = document.createElement("th");
    cell.scope = "col";
    cell.className = this.classOf(column);
    const button = document.createElement("button");
    button.textContent = column.name;
    button.addEventListener("click", () => {
      this.order = { column: i, down: this.order.column === i && !this.order.down };
      this.fill(this.items, this.chosen);
    });
    cell.append(button);
    return cell;
  }

  classOf(column) {
    return [column.number ? "number" : "", column.optional ? "optional" : ""].join(" ").trim();
  }

  fill(items, chosen) {
    this.items = items;
    const column = this.columns[this.order.column];
    const compare = (a, b) => (column.value(a) < column.value(b) ? -1 : column.value(a) > column.value(b) ? 1 : 0);
    const sorted = [...items].sort((a, b) => (this.order.down ? -1 : 1) * compare(a, b) || a[this.kind] - b[this.kind]);
    [...this.table.tHead.rows[0].cells].forEach((cell, i) => {
      if (i === this.order.column) cell.setAttribute("aria-sort", this.order.down ? "descending" : "ascending");
      else cell.removeAttribute("aria-sort");
    });
    this.body.replaceChildren(...sorted.map((item) => this.row(item)));
    this.note.textContent = items.length ? "" : "Nothing fits the search.";
    this.mark(chosen);
  }

  row(item) {
    const row = document.createElement("tr");
    row.dataset[this.kind] = item[this.kind];
    row.tabIndex = -1;
    for (const column of this.columns) {
      const cell = row.insertCell();
      cell.className = this.classOf(column);
      if (column.colour) {
        const swatch = document.createElement("i");
        swatch.style.setProperty("--fill", column.colour(item));
        cell.append(swatch);
      }
      cell.append(column.text ? column.text(item) : String(column.value(item)));
    }
    return row;
  }

  mark(chosen) {
    this.chosen = chosen;
    let entry = null;
    for (const row of this.body.rows) {
      const is = Boolean(chosen) && chosen.kind === this.kind && chosen.number === Number(row.dataset[this.kind]);
      row.setAttribute("aria-selected", is);
      row.tabIndex = -1;
      if (is) entry = row;
    }
    const reachable = entry || this.body.rows[0];
    if (reachable) reachable.tabIndex = 0;
    if (entry && !entry.contains(document.activeElement)) this.reveal(entry);
  }

  /** Scroll the list, not the page. */
  reveal(row) {
    const sheet = row.closest(".sheet");
    const top = row.offsetTop - this.table.tHead.offsetHeight;
    if (top < sheet.scrollTop || row.offsetTop + row.offsetHeight > sheet.scrollTop + sheet.clientHeight)
      sheet.scrollTop = top - sheet.clientHeight / 3;
  }

  chooseRow(row) {
    if (row) this.choose({ kind: this.kind, number: Number(row.dataset[this.kind]) });
  }

  click(event) {
    this.chooseRow(event.target.closest("tr"));
  }

  key(event) {
    const row = event.target.closest("tr");
    const next = { ArrowDown: row.nextElementSibling, ArrowUp: row.previousElementSibling,
      Home: this.body.rows[0], End: this.body.rows[this.body.rows.length - 1] }[event.key];
    if (next) {
      event.preventDefault();
      next.focus();
      this.chooseRow(next);
    } else if (event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      this.chooseRow(row);
    }
  }
}

const metres = (value) => `${value.toFixed(2)} m`;
const percent = (value) => `${Math.round(100 * value)} %`;

const objectColumns = (colourOf) => [
  { name: "Object", value: (o) => o.object, number: true },
  { name: "Class", value: nameOf, colour: colourOf },
  ...(hasClasses ? [{ name: "Sure", value: (o) => o.confidence, number: true,
    text: (o) => o.structure === "none" && o.confidence ? percent(o.confidence) : "–" }] : []),
  { name: "Room", value: (o) => o.room, number: true, text: (o) => o.room ? String(o.room) : "–" },
  { name: "Storey", value: (o) => o.storey ?? -1, number: true, text: (o) => String(o.storey ?? "–") , optional: true },
  { name: "Size", value: (o) => Math.max(...o.upright_box.size), number: true, text: sizeOf },
  { name: "Centre", value: (o) => o.upright_box.center[0], number: true, optional: true,
    text: (o) => o.upright_box.center.map((value) => value.toFixed(2)).join(", ") },
  { name: "Points", value: (o) => o.points, number: true, optional: true, text: (o) => o.points.toLocaleString("en") },
];

const roomColumns = [
  { name: "Room", value: (r) => r.room, text: (r) => roomName(r.room), colour: (r) => roomColour(r.room) },
  { name: "Name", value: (r) => r.name, text: (r) => r.name === "unknown" ? "–" : r.name },
  { name: "Sure", value: (r) => r.name_probability, number: true, optional: true, text: (r) => percent(r.name_probability) },
  { name: "Storey", value: (r) => r.storey, number: true },
  { name: "Area", value: (r) => r.area, number: true, text: (r) => `${r.area.toFixed(1)} m²` },
  { name: "Height", value: (r) => r.height, number: true, text: (r) => metres(r.height) },
  { name: "Volume", value: (r) => r.volume, number: true, optional: true, text: (r) => `${r.volume.toFixed(1)} m³` },
  { name: "Objects", value: (r) => r.objects.filter((id) => objects[id - 1].structure === "none").length, number: true },
  { name: "Leads to", value: (r) => r.neighbours.length, optional: true,
    text: (r) => [...new Set(r.neighbours.map((n) => n.room))].sort((a, b) => a - b).join(", ") || "–" },
];

/** The rooms that a wall or an opening joins; 0 is the outside, or what was not seen. */
const joinedRooms = (rooms) => rooms.filter((room) => room > 0).join(" and ") || "–";

const openingColumns = [
  { name: "Opening", value: (o) => o.opening, number: true },
  { name: "Kind", value: (o) => o.kind, text: (o) => o.open || o.kind !== "door" ? o.kind : "closed door" },
  { name: "Rooms", value: (o) => o.rooms[0], text: (o) => joinedRooms(o.rooms) },
  { name: "Storey", value: (o) => o.storey, number: true },
  { name: "Width", value: (o) => o.width, number: true, text: (o) => metres(o.width) },
  { name: "Height", value: (o) => o.height, number: true, text: (o) => metres(o.height) },
  { name: "Sill", value: (o) => o.sill, number: true, optional: true, text: (o) => metres(o.sill) },
  { name: "Area", value: (o) => o.area, number: true, optional: true, text: (o) => `${o.area.toFixed(2)} m²` },
];

const lengthOf = (wall) => Math.hypot(...toBuilding(wall.end).map((value, i) => value - toBuilding(wall.begin)[i]));

const wallColumns = [
  { name: "Wall", value: (w) => w.wall, number: true },
  { name: "Rooms", value: (w) => w.rooms[0], text: (w) => joinedRooms(w.rooms) },
  { name: "Storey", value: (w) => w.storey, number: true },
  { name: "Length", value: lengthOf, number: true, text: (w) => metres(lengthOf(w)) },
  { name: "Height", value: (w) => w.height, number: true, text: (w) => metres(w.height) },
  { name: "Thickness", value: (w) => w.thickness ?? 0, number: true, text: (w) => w.thickness ? metres(w.thickness) : "–" },
];
