// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the pcl_indoor contributors
//
// The 3D view of the thinned cloud.

class Space {
  constructor(canvas, choose) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = "srgb-linear"; // colours as they are
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
    const material = new THREE.PointsMaterial({ size: 1.6 * cloudHeader.spacing, vertexColors: true });
    material.onBeforeCompile = (shader) => { // round points
      shader.fragmentShader = shader.fragmentShader.replace("#include <color_fragment>",
        "#include <color_fragment>\nif (length(gl_PointCoord - 0.5) > 0.5) discard;");
    };
    this.points = new THREE.Points(this.geometry, material);
    this.points.frustumCulled = false;
    this.frame = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x0b62c4, depthTest: false }));
    this.frame.renderOrder = 1;
    this.scene.add(this.points, this.frame);
    this.controls.addEventListener("start", () => { this.whole = null; });
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

  /** Look from the south and above at a whole box of places, also when the window changes, until the view is moved. */
  look(lower, upper) {
    this.whole = [lower, upper];
    const center = lower.map((value, i) => (value + upper[i]) / 2);
    const corners = [...Array(8).keys()].map((i) => [0, 1, 2].map((axis) => (i & (1 << axis) ? upper : lower)[axis]));
    const isSeen = (corner) => {
      const place = new THREE.Vector3(...corner).project(this.camera);
      return Math.max(Math.abs(place.x), Math.abs(place.y)) < 0.97;
    };
    this.controls.target.set(...center);
    for (let back = 3; back < 2000; back *= 1.03) {
      this.camera.position.set(center[0] - 0.2 * back, center[1] - 0.62 * back, center[2] + 0.78 * back);
      this.camera.lookAt(...center);
      this.camera.updateMatrixWorld();
      if (corners.every(isSeen)) break;
    }
    this.controls.update();
    this.render();
  }

  /** Make a place the centre, and come so near that objects are seen well. */
  turnTo(place, nearest) {
    this.whole = null;
    const away = this.camera.position.clone().sub(this.controls.target);
    away.setLength(Math.min(away.length(), nearest));
    this.controls.target.set(...place);
    this.camera.position.copy(this.controls.target).add(away);
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
    if (this.whole) this.look(...this.whole);
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
