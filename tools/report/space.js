// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_indoor contributors
//
// The 3D view of the thinned cloud.

class Space {
  constructor(canvas, choose) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(40, 1, 0.1, 2000);
    this.camera.up.set(0, 0, 1);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.maxPolarAngle = Math.PI * 0.495;
    this.controls.zoomToCursor = true;
    this.controls.listenToKeyEvents(canvas);
    this.controls.addEventListener("change", () => this.render());
    this.geometry = new THREE.BufferGeometry();
    this.geometry.setAttribute("position", new THREE.BufferAttribute(cloud.positions, 3));
    this.colours = new THREE.BufferAttribute(new Uint8Array(3 * cloud.count), 3, true);
    this.geometry.setAttribute("color", this.colours);
    this.points = new THREE.Points(this.geometry, new THREE.PointsMaterial({ size: 0.06, vertexColors: true }));
    this.points.frustumCulled = false;
    this.frame = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x0b62c4, depthTest: false }));
    this.frame.renderOrder = 1;
    this.scene.add(this.points, this.frame);
    canvas.addEventListener("pointerdown", (event) => { this.pressed = [event.clientX, event.clientY]; });
    canvas.addEventListener("pointerup", (event) => {
      if (this.pressed && Math.hypot(event.clientX - this.pressed[0], event.clientY - this.pressed[1]) < 5) choose(this.pick(event));
    });
    new ResizeObserver(() => this.fit()).observe(canvas.parentElement);
  }

  /** Choose the points to draw, and their colours: rgb(i) gives three bytes. */
  draw(isShown, rgb) {
    const shown = new Uint32Array(cloud.count);
    let count = 0;
    const colours = this.colours.array;
    for (let i = 0; i < cloud.count; ++i) {
      if (!isShown(i)) continue;
      shown[count++] = i;
      colours.set(rgb(i), 3 * i);
    }
    this.shown = shown.subarray(0, count);
    this.colours.needsUpdate = true;
    this.geometry.setIndex(new THREE.BufferAttribute(this.shown, 1));
    this.render();
    return count;
  }

  /** A frame around a box of the scene; null for none. */
  mark(object) {
    const lines = [];
    if (object) {
      const corners = cornersOf(object);
      for (let a = 0; a < 8; ++a)
        for (const bit of [1, 2, 4]) if (!(a & bit)) lines.push(...corners[a], ...corners[a | bit]);
    }
    this.frame.geometry.dispose();
    this.frame.geometry = new THREE.BufferGeometry();
    this.frame.geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(lines), 3));
    this.render();
  }

  /** Look from the south and above at a box of places. */
  look(lower, upper) {
    const center = lower.map((value, i) => (value + upper[i]) / 2);
    const size = Math.max(4, Math.hypot(upper[0] - lower[0], upper[1] - lower[1]));
    const back = (0.66 * size) / Math.min(1, this.camera.aspect / 1.3);
    this.controls.target.set(...center);
    this.camera.position.set(center[0] - 0.25 * back, center[1] - 0.85 * back, center[2] + 0.95 * back);
    this.controls.update();
    this.render();
  }

  /** Make a place the centre, as far away as before. */
  turnTo(place) {
    const by = new THREE.Vector3(...place).sub(this.controls.target);
    this.controls.target.add(by);
    this.camera.position.add(by);
    this.controls.update();
    this.render();
  }

  pick(event) {
    const box = this.canvas.getBoundingClientRect();
    const at = new THREE.Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    const ray = new THREE.Raycaster();
    ray.params.Points.threshold = Math.max(0.04, this.camera.position.distanceTo(this.controls.target) * 0.006);
    ray.setFromCamera(at, this.camera);
    const hits = ray.intersectObject(this.points).slice(0, 200);
    const of = (hit) => objects[cloud.objects[hit.index] - 1];
    const best = hits.find((hit) => of(hit) && of(hit).structure === "none" && hit.distance < hits[0].distance + 0.4);
    if (best) return { kind: "object", number: cloud.objects[best.index] };
    return hits.length && cloud.rooms[hits[0].index] ? { kind: "room", number: cloud.rooms[hits[0].index] } : null;
  }

  fit() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.render();
  }

  render() {
    if (this.asked) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      this.renderer.render(this.scene, this.camera);
    });
  }
}

/** Corners of an object's upright box in the frame of the cloud; bits of the index are the axes. */
const cornersOf = (object) => {
  const box = object.upright_box;
  const [x, y, z] = toBuilding(box.center);
  const yaw = (box.yaw_degrees * Math.PI) / 180;
  return [...Array(8).keys()].map((i) => {
    const [u, v, w] = [1, 2, 4].map((bit, axis) => ((i & bit ? 1 : -1) * box.size[axis]) / 2);
    return [x + u * Math.cos(yaw) - v * Math.sin(yaw), y + u * Math.sin(yaw) + v * Math.cos(yaw), z + w];
  });
};
